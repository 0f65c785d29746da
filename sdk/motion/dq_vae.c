/* DQ-VAE (paper §3.3), the `game` size of docs/networks.md: encoders of joint, points and drag, gated fusion, latent,
 * non-autoregressive decoder of 16 dual quaternions with FiLM after every layer, physics correction. */
#include "motion/dq_vae.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/random.h"
#include "math/elementary.h"
#include "math/linear3.h"
#include "motion/dq_vae_net.h"

#define BLOCK_SIZE ((size_t)256 * 1024) /* bytes of an arena block; by hand */
#define POINT_BATCH 16                  /* rows; by hand: a batch and its maxima fit the stack and the L1 cache */
#define MAX_LOG_VARIANCE 4.0f           /* bounds of the latent's log variance, as trained (docs/networks.md) */
#define MIN_LOG_VARIANCE (-8.0f)

/* Points that one matrix product encodes. */
typedef struct point_batch {
    _Alignas(DMI_ALIGNMENT) float inputs[POINT_BATCH][4];
    float hidden[POINT_BATCH][VAE_SMALL];
    float features[POINT_BATCH][VAE_FEATURE];
} point_batch;

/* Followed by the transformer's own scratch. Names are docs/networks.md's. */
typedef struct scratch {
    _Alignas(DMI_ALIGNMENT) float tokens[DM_MOTION_FRAMES][VAE_WIDTH];
    float normal[DM_MOTION_FRAMES][VAE_WIDTH];
    point_batch points;
    float path[DMI_VAE_PATH][VAE_SMALL];
    float correction_hidden[DM_MOTION_FRAMES][VAE_FEATURE];
    float along[DM_MOTION_FRAMES][VAE_ALONG];
    float context[VAE_CONTEXT]; /* f_local, f_joint, f_motion */
    float gate[VAE_CONTEXT], gated[VAE_CONTEXT];
    float inputs[VAE_CONTEXT], hidden[VAE_CONTEXT]; /* inputs and hidden units of the current layer */
    float latent[2 * DMI_VAE_LATENT];
    float condition[VAE_WIDTH];
    dmi_vae_films films;
    _Alignas(DMI_ALIGNMENT) float transformer[];
} scratch;

/* Offsets of the parts of a layer's input. */
enum {
    F_LOCAL = 0, /* offsets in the context */
    F_JOINT = VAE_FEATURE,
    F_MOTION = 2 * VAE_FEATURE,
    JOINT_ORIGIN = VAE_SMALL, /* offset in the joint encoder's input, after the axis */
    JOINT_SCALARS = 2 * VAE_SMALL,
    INTENT_VELOCITY = VAE_SMALL, /* offset in the intent encoder's input, after the direction or the chords */
    INTENT_AMPLITUDE = 2 * VAE_SMALL,
    INTENT_PATH = 3 * VAE_SMALL,
    NEAR_DRAG = VAE_FEATURE, /* offset in the local sampler's input, after the features near the origin */
    WHOLE = 2 * VAE_FEATURE
};

dm_result dmi_dq_vae_load(dmi_env* env, const void* data, size_t size, dmi_dq_vae** out_vae) {
    dmi_dq_vae* vae = dmi_alloc_zeroed(env, sizeof *vae, _Alignof(dmi_dq_vae));
    if (vae == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "DQ-VAE: no memory");
    vae->env = env;
    dmi_arena_init(&vae->arena, env, BLOCK_SIZE);
    const dm_result result = dmi_load_network(env, data, size, "dragmesh-dq-vae", dmi_vae_read, vae, &vae->arena);
    if (result != DM_OK) {
        dmi_free(env, vae, sizeof *vae);
        return result;
    }
    *out_vae = vae;
    return DM_OK;
}

void dmi_dq_vae_destroy(dmi_dq_vae* vae) {
    if (vae == NULL) return;
    dmi_env* env = vae->env;
    dmi_arena_release(&vae->arena);
    dmi_free(env, vae, sizeof *vae);
}

size_t dmi_dq_vae_scratch_size(const dmi_dq_vae* vae) {
    (void)vae;
    return sizeof(scratch) +
           sizeof(float) * dmi_transformer_scratch(DM_MOTION_FRAMES, VAE_WIDTH, VAE_HEADS, VAE_FEED_FORWARD);
}

/* Computes the features of the first `count` points of a batch. */
static void encode_points(const dmi_dq_vae* vae, const dmi_kernels* kernels, uint32_t count, point_batch* batch) {
    dmi_mlp_apply(&vae->points, kernels, batch->inputs[0], count, DMI_GEMM_RELU, batch->hidden[0], batch->features[0]);
}

static void set_point(const dmi_vae_object* object, uint32_t index, float out_input[4]) {
    memcpy(out_input, object->xyz[index], sizeof object->xyz[index]);
    out_input[3] = object->mask[index];
}

void dmi_dq_vae_prepare(const dmi_dq_vae* vae, dmi_isa isa, const dmi_part_points* points, dmi_vae_object* out_object) {
    enum { BATCHES = DMI_VAE_POINTS / POINT_BATCH };
    const dmi_kernels* kernels = dmi_kernels_for(isa);
    point_batch batch;
    float maxima[BATCHES][VAE_FEATURE];
    dmi_vae_object_points(points, out_object);
    for (uint32_t b = 0; b < BATCHES; b++) {
        for (uint32_t i = 0; i < POINT_BATCH; i++) set_point(out_object, b * POINT_BATCH + i, batch.inputs[i]);
        encode_points(vae, kernels, POINT_BATCH, &batch);
        kernels->max_rows(batch.features[0], POINT_BATCH, VAE_FEATURE, maxima[b]);
    }
    kernels->max_rows(maxima[0], BATCHES, VAE_FEATURE, out_object->global);
}

/* Returns the index of a joint type in the network's tables. */
static uint32_t type_index(const dm_joint* joint) {
    const bool known = joint->type >= DM_JOINT_REVOLUTE && joint->type <= DM_JOINT_CONTINUOUS;
    return known ? (uint32_t)(joint->type - DM_JOINT_REVOLUTE) : 0;
}

/* Joint condition encoder (§3.3.1), and the coefficients of every FiLM layer, which depend on it alone. */
static void encode_joint(const dmi_dq_vae* vae, const dmi_kernels* kernels, const dm_joint* joint,
                         const float scalars[3], scratch* s) {
    const dmi_float3 axis = dmi_xyz(joint->axis), origin = dmi_xyz(joint->origin);
    dmi_linear fuse = vae->joint_fuse;
    fuse.bias = vae->joint_bias[type_index(joint)];
    dmi_mlp_apply(&vae->joint_axis, kernels, axis.v, 1, 0, s->hidden, s->inputs);
    dmi_mlp_apply(&vae->joint_origin, kernels, origin.v, 1, 0, s->hidden, s->inputs + JOINT_ORIGIN);
    memcpy(s->inputs + JOINT_SCALARS, scalars, 3 * sizeof(float));
    dmi_linear_apply(&fuse, kernels, s->inputs, 1, DMI_GEMM_RELU, s->hidden);
    dmi_linear_apply(&vae->joint_out, kernels, s->hidden, 1, 0, s->context + F_JOINT);
    dmi_linear_apply(&vae->films, kernels, s->context + F_JOINT, 1, 0, (float*)(void*)&s->films);
}

/* Motion intent encoder (§3.3.1): turning types read direction and velocity, sliding ones the chords. */
static void encode_intent(const dmi_dq_vae* vae, const dmi_kernels* kernels, bool slides,
                          const dmi_vae_features* features, scratch* s) {
    if (slides) {
        dmi_mlp_apply(&vae->chord, kernels, features->chords, 1, 0, s->hidden, s->inputs);
    } else {
        dmi_mlp_apply(&vae->direction, kernels, features->rotation_direction, 1, 0, s->hidden, s->inputs);
        dmi_mlp_apply(&vae->velocity, kernels, features->mean_velocity, 1, 0, s->hidden, s->inputs + INTENT_VELOCITY);
    }
    dmi_mlp_apply(&vae->amplitude, kernels, features->amplitude, 1, 0, s->hidden, s->inputs + INTENT_AMPLITUDE);
    memcpy(s->path, vae->path_position, sizeof s->path);
    dmi_linear_apply(&vae->path_in, kernels, features->path[0], DMI_VAE_PATH, DMI_GEMM_ADD, s->path[0]);
    dmi_transformer_apply(&vae->path_layer, kernels, DMI_VAE_PATH, s->path[0], s->transformer);
    kernels->mean_rows(s->path[0], DMI_VAE_PATH, VAE_SMALL, s->inputs + INTENT_PATH);
    dmi_mlp_apply(&vae->motion_fuse, kernels, s->inputs, 1, 0, s->hidden, s->context + F_MOTION);
}

/* Kinematics-aware sampling (§3.3.2): features near the joint's origin and near the drag point, and of the whole. */
static void encode_local(const dmi_dq_vae* vae, const dmi_kernels* kernels, const dmi_vae_object* object,
                         const dmi_vae_query* query, scratch* s) {
    uint32_t near[2 * DMI_VAE_NEIGHBOURS];
    float* f_local = s->context + F_LOCAL;
    dmi_vae_neighbours(object, dmi_xyz(query->joint.origin).v, near);
    dmi_vae_neighbours(object, query->drag_point, near + DMI_VAE_NEIGHBOURS);
    for (uint32_t i = 0; i < 2 * DMI_VAE_NEIGHBOURS; i++) set_point(object, near[i], s->points.inputs[i]);
    encode_points(vae, kernels, 2 * DMI_VAE_NEIGHBOURS, &s->points);
    kernels->max_rows(s->points.features[0], DMI_VAE_NEIGHBOURS, VAE_FEATURE, s->inputs);
    kernels->max_rows(s->points.features[DMI_VAE_NEIGHBOURS], DMI_VAE_NEIGHBOURS, VAE_FEATURE, s->inputs + NEAR_DRAG);
    memcpy(s->inputs + WHOLE, object->global, sizeof object->global);
    dmi_mlp_apply(&vae->local, kernels, s->inputs, 1, 0, s->hidden, f_local);
    kernels->modulate(f_local, 1, VAE_FEATURE, s->films.local_scale, s->films.local_shift);
    for (uint32_t i = 0; i < VAE_FEATURE; i++) f_local[i] = dmi_fmaxf(f_local[i], 0.0f);
}

/* Gated fusion (§3.3.2) and the latent's distribution. */
static void encode_latent(const dmi_dq_vae* vae, const dmi_kernels* kernels, scratch* s, dmi_vae_output* out) {
    memcpy(s->gated, s->context, sizeof s->gated);
    dmi_linear_apply(&vae->gate, kernels, s->context, 1, 0, s->gate);
    kernels->gate(s->gate, VAE_CONTEXT, s->gated);
    dmi_mlp_apply(&vae->fuse, kernels, s->gated, 1, 0, s->hidden, s->inputs);
    memcpy(s->inputs + VAE_HIDDEN, s->context + F_JOINT, VAE_FEATURE * sizeof(float));
    dmi_mlp_apply(&vae->encoder, kernels, s->inputs, 1, 0, s->hidden, s->latent);
    for (uint32_t i = 0; i < DMI_VAE_LATENT; i++) {
        out->mean[i] = s->latent[i];
        out->log_variance[i] = dmi_fminf(dmi_fmaxf(s->latent[DMI_VAE_LATENT + i], MIN_LOG_VARIANCE), MAX_LOG_VARIANCE);
    }
}

/* Samples z = mu + sigma eps; seed 0: z = mu. */
static void sample_latent(const dmi_vae_output* distribution, uint32_t seed, float out_z[DMI_VAE_LATENT]) {
    dmi_random random = dmi_random_make(seed, 0);
    for (uint32_t i = 0; i < DMI_VAE_LATENT; i++) {
        const float noise = seed ? dmi_random_normal(&random) : 0.0f;
        out_z[i] = distribution->mean[i] + dmi_expf(0.5f * distribution->log_variance[i]) * noise;
    }
}

/* Decoder (§3.3.3): all frames at once; base poses go to out->raw. */
static void decode_frames(const dmi_dq_vae* vae, const dmi_kernels* kernels, uint32_t seed, scratch* s,
                          dmi_vae_output* out) {
    sample_latent(out, seed, s->inputs);
    memcpy(s->inputs + DMI_VAE_LATENT, s->context + F_JOINT, VAE_FEATURE * sizeof(float));
    dmi_linear_apply(&vae->condition, kernels, s->inputs, 1, 0, s->condition);
    for (uint32_t t = 0; t < DM_MOTION_FRAMES; t++)
        for (uint32_t i = 0; i < VAE_WIDTH; i++) s->tokens[t][i] = vae->tokens[t][i] + s->condition[i];
    for (uint32_t l = 0; l < VAE_LAYERS; l++) {
        dmi_transformer_apply(&vae->layers[l], kernels, DM_MOTION_FRAMES, s->tokens[0], s->transformer);
        kernels->modulate(s->tokens[0], DM_MOTION_FRAMES, VAE_WIDTH, s->films.decoder[l].scale,
                          s->films.decoder[l].shift);
    }
    dmi_norm_apply(&vae->norm, kernels, s->tokens[0], DM_MOTION_FRAMES, s->normal[0]);
    dmi_mlp_apply(&vae->head, kernels, s->normal[0], DM_MOTION_FRAMES, 0, s->tokens[0], out->raw[0]);
}

/* Physics correction (§3.3.3): adds to each base pose a residual under the joint, the identity, and rotation and
 * translation components that lie exactly on the axis. */
static void correct_poses(const dmi_dq_vae* vae, const dmi_kernels* kernels, const dm_joint* joint, scratch* s,
                          dmi_vae_output* out) {
    const dmi_float3 axis = dmi_xyz(joint->axis);
    dmi_linear of_joint = vae->correction_joint, of_base = vae->correction_base;
    of_joint.bias = vae->correction_bias[type_index(joint)];
    memcpy(s->inputs, s->context + F_JOINT, VAE_FEATURE * sizeof(float));
    memcpy(s->inputs + VAE_FEATURE, axis.v, sizeof axis.v);
    dmi_linear_apply(&of_joint, kernels, s->inputs, 1, 0, s->condition);
    of_base.bias = s->condition;
    dmi_linear_apply(&of_base, kernels, out->raw[0], DM_MOTION_FRAMES, DMI_GEMM_RELU, s->correction_hidden[0]);
    dmi_linear_apply(&vae->correction_out, kernels, s->correction_hidden[0], DM_MOTION_FRAMES, DMI_GEMM_ADD,
                     out->raw[0]);
    dmi_linear_apply(&vae->along, kernels, s->correction_hidden[0], DM_MOTION_FRAMES, 0, s->along[0]);
    for (uint32_t t = 0; t < DM_MOTION_FRAMES; t++)
        for (uint32_t k = 0; k < 3; k++) {
            out->raw[t][k] += s->along[t][0] * axis.v[k];
            out->raw[t][4 + k] += s->along[t][1] * axis.v[k];
        }
}

void dmi_dq_vae_forward(const dmi_dq_vae* vae, dmi_isa isa, const dmi_vae_object* object, const dmi_vae_query* query,
                        void* scratch_memory, dmi_vae_output* out_output) {
    const dmi_kernels* kernels = dmi_kernels_for(isa);
    scratch* s = scratch_memory;
    dmi_vae_features features;
    dmi_vae_features_make(query, &features);
    encode_joint(vae, kernels, &query->joint, features.joint_scalars, s);
    encode_local(vae, kernels, object, query, s);
    encode_intent(vae, kernels, query->joint.type == DM_JOINT_PRISMATIC, &features, s);
    encode_latent(vae, kernels, s, out_output);
    decode_frames(vae, kernels, query->seed, s, out_output);
    correct_poses(vae, kernels, &query->joint, s, out_output);
}
