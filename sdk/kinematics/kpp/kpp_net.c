/* KPP-Net (paper §3.5) in the `game` size of docs/networks.md: a PointNet makes a token of each group of points, a
 * transformer encodes the tokens of the whole (global) and of the part (local), and four decoupled heads read the
 * pooled features; a fifth head scores candidates. */
#include "kinematics/kpp/kpp_net.h"

#include <stdio.h>
#include <string.h>

#include "math/elementary.h"
#include "math/linear3.h"
#include "nn/layers.h"

/* Sizes of the layers (docs/networks.md). */
#define WIDTH 96
#define HEADS 4
#define FEED_FORWARD 192
#define POINT_HIDDEN 64
#define POSITION_HIDDEN 48
#define HEAD_HIDDEN 128
#define SCALAR_HIDDEN 96
#define SCORE_HIDDEN 64
#define GLOBAL_LAYERS 3
#define LOCAL_LAYERS 2
#define MAX_LAYERS GLOBAL_LAYERS

#define SNAP_DIRECTIONS 6                /* axes of the part's and the body's frames: the first of the shape features */
#define SNAP_COSINE 0.9397f              /* cosine of the angle within which an axis is snapped (20 degrees); by hand */
#define ARENA_BLOCK ((size_t)256 * 1024) /* bytes; by hand */
#define MAX_NAME 64                      /* bytes of a tensor's name, with the terminating zero */
#define ALIGNMENT 64                     /* bytes, a cache line: what the kernels expect */

#define STEP_GROUPS 4 /* groups whose points pass the point MLP together: they fit a level 1 cache; by hand */
#define STEP_POINTS (STEP_GROUPS * DMI_KPP_GROUP)

enum {
    POOLED = 2 * WIDTH,    /* mean and max */
    FEATURES = 2 * POOLED, /* global and local */
    KNOWN = FEATURES + DMI_KPP_SHAPE,
    /* A vector and a coefficient of each direction, for a turn and a slide. */
    AXIS_OUTPUTS = 2 * (3 + DMI_KPP_DIRECTIONS),
    ORIGIN_OUTPUTS = 2 * 3, /* a place in the part's box, and an offset */
};

typedef struct encoder {
    dmi_mlp point, position;
    dmi_transformer layers[MAX_LAYERS];
    uint32_t layer_count;
    dmi_norm norm;
} encoder;

struct dmi_kpp_net {
    dmi_env* env;
    dmi_arena arena;
    encoder global, local;
    dmi_mlp type, axis, origin, limits;
    dmi_linear known, line; /* first layer of the candidate-scoring head: columns of the part, columns of a candidate */
    dmi_mlp score;
};

/* The transformer's own scratch lies behind this struct. */
typedef struct scratch {
    _Alignas(ALIGNMENT) float tokens[DMI_KPP_GLOBAL_GROUPS][WIDTH];
    float positions[DMI_KPP_GLOBAL_GROUPS][POSITION_HIDDEN];
    float hidden[STEP_POINTS][POINT_HIDDEN];
    float points[STEP_POINTS][WIDTH];
    float known[KNOWN]; /* pooled features, then the shape features */
    float head[HEAD_HIDDEN];
    float axes[AXIS_OUTPUTS], origin[ORIGIN_OUTPUTS];
    _Alignas(ALIGNMENT) float transformer[];
} scratch;

static void read_encoder(dmi_loader* loader, const char* name, uint32_t layer_count, encoder* out) {
    char part[MAX_NAME];
    snprintf(part, sizeof part, "%s.point", name);
    dmi_load_mlp(loader, part, DMI_KPP_CHANNELS, POINT_HIDDEN, WIDTH, &out->point);
    snprintf(part, sizeof part, "%s.position", name);
    dmi_load_mlp(loader, part, 3, POSITION_HIDDEN, WIDTH, &out->position);
    out->layer_count = layer_count;
    for (uint32_t i = 0; i < layer_count; i++) {
        snprintf(part, sizeof part, "%s.layers.%u", name, i);
        dmi_load_transformer(loader, part, WIDTH, HEADS, FEED_FORWARD, &out->layers[i]);
    }
    snprintf(part, sizeof part, "%s.norm", name);
    dmi_load_norm(loader, part, WIDTH, &out->norm);
}

static void read_network(dmi_loader* loader, void* network) {
    dmi_kpp_net* net = network;
    read_encoder(loader, "global", GLOBAL_LAYERS, &net->global);
    read_encoder(loader, "local", LOCAL_LAYERS, &net->local);
    dmi_load_mlp(loader, "type", KNOWN, SCALAR_HIDDEN, DMI_KPP_TYPES, &net->type);
    dmi_load_mlp(loader, "axis", KNOWN, HEAD_HIDDEN, AXIS_OUTPUTS, &net->axis);
    dmi_load_mlp(loader, "origin", KNOWN, HEAD_HIDDEN, ORIGIN_OUTPUTS, &net->origin);
    dmi_load_mlp(loader, "limits", KNOWN, SCALAR_HIDDEN, DMI_KPP_LIMITS, &net->limits);
    dmi_load_linear(loader, "choice.known", KNOWN, DMI_KPP_CONTEXT, &net->known);
    dmi_load_linear(loader, "choice.line", DMI_KPP_CANDIDATE_NUMBERS, DMI_KPP_CONTEXT, &net->line);
    dmi_load_mlp(loader, "choice.score", DMI_KPP_CONTEXT, SCORE_HIDDEN, 1, &net->score);
}

dm_result dmi_kpp_net_load(dmi_env* env, const void* data, size_t size, dmi_kpp_net** out_net) {
    dmi_kpp_net* net = dmi_alloc_zeroed(env, sizeof *net, _Alignof(dmi_kpp_net));
    if (net == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "KPP-Net: no memory");
    net->env = env;
    dmi_arena_init(&net->arena, env, ARENA_BLOCK);
    const dm_result result = dmi_load_network(env, data, size, "dragmesh-kpp-net", read_network, net, &net->arena);
    if (result != DM_OK) {
        dmi_free(env, net, sizeof *net);
        return result;
    }
    *out_net = net;
    return DM_OK;
}

void dmi_kpp_net_destroy(dmi_kpp_net* net) {
    if (net == NULL) return;
    dmi_env* env = net->env;
    dmi_arena_release(&net->arena);
    dmi_free(env, net, sizeof *net);
}

size_t dmi_kpp_net_scratch_size(const dmi_kpp_net* net) {
    (void)net;
    return sizeof(scratch) + sizeof(float) * dmi_transformer_scratch(DMI_KPP_GLOBAL_GROUPS, WIDTH, HEADS, FEED_FORWARD);
}

/* Computes a token for each group: the maximum over its points' features plus an embedding of its centre. */
static void make_tokens(const encoder* encoder, const dmi_kernels* kernels,
                        const float (*points)[DMI_KPP_GROUP][DMI_KPP_CHANNELS], const float (*centres)[3],
                        uint32_t groups, scratch* s) {
    for (uint32_t first = 0; first < groups; first += STEP_GROUPS) {
        dmi_mlp_apply(&encoder->point, kernels, points[first][0], STEP_POINTS, 0, s->hidden[0], s->points[0]);
        for (size_t g = 0; g < STEP_GROUPS; g++)
            kernels->max_rows(s->points[g * DMI_KPP_GROUP], DMI_KPP_GROUP, WIDTH, s->tokens[first + g]);
    }
    dmi_mlp_apply(&encoder->position, kernels, centres[0], groups, DMI_GEMM_ADD, s->positions[0], s->tokens[0]);
}

/* Writes the mean and the maximum over the tokens to `pooled`. The normalised tokens overwrite s->points. */
static void encode_groups(const encoder* encoder, const dmi_kernels* kernels,
                          const float (*points)[DMI_KPP_GROUP][DMI_KPP_CHANNELS], const float (*centres)[3],
                          uint32_t groups, scratch* s, float* pooled) {
    _Static_assert(sizeof s->points >= sizeof s->tokens, "the normalised tokens must fit");
    float* normal = s->points[0];
    make_tokens(encoder, kernels, points, centres, groups, s);
    for (uint32_t i = 0; i < encoder->layer_count; i++)
        dmi_transformer_apply(&encoder->layers[i], kernels, groups, s->tokens[0], s->transformer);
    dmi_norm_apply(&encoder->norm, kernels, s->tokens[0], groups, normal);
    kernels->mean_rows(normal, groups, WIDTH, pooled);
    kernels->max_rows(normal, groups, WIDTH, pooled + WIDTH);
}

/* Computes the head's vector plus its linear combination of the shape's directions. */
static void combine_axis(const float* head, const float* shape, float out[3]) {
    for (int k = 0; k < 3; k++) {
        out[k] = head[k];
        for (int d = 0; d < DMI_KPP_DIRECTIONS; d++) out[k] += head[3 + d] * shape[3 * d + k];
    }
}

/* Replaces `axis` by the closest axis of the part's, the body's and the input's frame if it is within SNAP_COSINE: the
 * regression is off by a few hundredths of a radian. The length is kept. */
static void snap_axis(const float* shape, float axis[3]) {
    static const float frame[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const float length = dmi_length3(axis);
    const float* nearest = frame[0];
    float best = 0;
    for (int d = 0; d < SNAP_DIRECTIONS + 3; d++) {
        const float* direction = d < SNAP_DIRECTIONS ? shape + 3 * (size_t)d : frame[d - SNAP_DIRECTIONS];
        const float along = dmi_dot3(axis, direction);
        if (fabsf(along) > fabsf(best)) best = along, nearest = direction;
    }
    /* An axis of weights that have overflowed is near nothing either. */
    if (!(fabsf(best) > SNAP_COSINE * length)) return;
    for (int k = 0; k < 3; k++) axis[k] = copysignf(length, best) * nearest[k];
}

static void read_axis(const float* head, const float* shape, float out[3]) {
    combine_axis(head, shape, out);
    snap_axis(shape, out);
}

void dmi_kpp_net_forward(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_input* input, void* scratch_memory,
                         dmi_kpp_output* out_output) {
    const dmi_kernels* kernels = dmi_kernels_for(isa);
    scratch* s = scratch_memory;
    encode_groups(&net->global, kernels, input->global_points, input->global_centres, DMI_KPP_GLOBAL_GROUPS, s,
                  s->known);
    encode_groups(&net->local, kernels, input->local_points, input->local_centres, DMI_KPP_LOCAL_GROUPS, s,
                  s->known + POOLED);
    memcpy(s->known + FEATURES, input->shape, sizeof input->shape);
    dmi_mlp_apply(&net->type, kernels, s->known, 1, 0, s->head, out_output->type_logits);
    dmi_mlp_apply(&net->axis, kernels, s->known, 1, 0, s->head, s->axes);
    read_axis(s->axes, input->shape, out_output->turn_axis);
    read_axis(s->axes + 3 + DMI_KPP_DIRECTIONS, input->shape, out_output->slide_axis);
    dmi_mlp_apply(&net->origin, kernels, s->known, 1, 0, s->head, s->origin);
    const float* box = input->shape + DMI_KPP_SHAPE_PART_BOX;
    for (int k = 0; k < 3; k++) out_output->origin[k] = box[k] + box[3 + k] * s->origin[k] + s->origin[3 + k];
    dmi_mlp_apply(&net->limits, kernels, s->known, 1, 0, s->head, out_output->limits);
    dmi_linear_apply(&net->known, kernels, s->known, 1, 0, out_output->context);
    for (int k = 0; k < DMI_KPP_CONTEXT; k++) out_output->context[k] += net->line.bias[k];
}

void dmi_kpp_net_score(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_output* output,
                       const float (*candidates)[DMI_KPP_CANDIDATE_NUMBERS], uint32_t count, float* out_scores) {
    const dmi_kernels* kernels = dmi_kernels_for(isa);
    _Alignas(ALIGNMENT) float context[DMI_KPP_SCORE_BATCH][DMI_KPP_CONTEXT], hidden[DMI_KPP_SCORE_BATCH][SCORE_HIDDEN];
    dmi_linear line = net->line;
    line.bias = output->context; /* the part's share of the first layer, the same for all candidates */
    dmi_linear_apply(&line, kernels, candidates[0], count, DMI_GEMM_RELU, context[0]);
    dmi_mlp_apply(&net->score, kernels, context[0], count, 0, hidden[0], out_scores);
}

/* ---- what the network predicts ---- */

#define MIN_AXIS 1e-6f /* length of a raw axis below which it has no direction; by hand */

/* Rotates a vector out of the frame. */
static void rotate_out(const dmi_kpp_frame* frame, const float in[3], float out[3]) {
    for (int k = 0; k < 3; k++)
        out[k] = in[0] * frame->rotation[k] + in[1] * frame->rotation[3 + k] + in[2] * frame->rotation[2 * 3 + k];
}

void dmi_prediction_read(const dmi_kpp_frame* frame, const dmi_kpp_output* raw, dmi_prediction* out) {
    static const float x_axis[3] = {1, 0, 0};
    memcpy(out->type, raw->type_logits, sizeof out->type);
    dmi_softmax(out->type, DMI_KPP_TYPES);
    rotate_out(frame, raw->turn_axis, out->turn_axis);
    rotate_out(frame, raw->slide_axis, out->slide_axis);
    if (!(dmi_normalize3(out->turn_axis) > MIN_AXIS)) rotate_out(frame, x_axis, out->turn_axis);
    if (!(dmi_normalize3(out->slide_axis) > MIN_AXIS)) rotate_out(frame, x_axis, out->slide_axis);
    rotate_out(frame, raw->origin, out->origin);
    for (int k = 0; k < 3; k++) out->origin[k] = frame->origin[k] + out->origin[k] / frame->scale;
    for (int k = 0; k < 2; k++) {
        out->turn_limits[k] = raw->limits[k] * DMI_PI_F;
        out->slide_limits[k] = raw->limits[2 + k] / frame->scale;
    }
    out->pitch = raw->limits[DMI_KPP_LIMITS - 1] / frame->scale;
}
