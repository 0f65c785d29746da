/* Loads the DQ-VAE's layers and folds what does not depend on a query. */
#include <stdio.h>
#include <string.h>

#include "motion/dq_vae_net.h"

#define INJECTION 0.1f /* a condition is input twice: as it is, and scaled by this (paper §3.3.3) */

/* out[t] = bias + W[:, columns] row t of `table`: the contribution of a one-hot input to a layer, as a table. */
static void* fold_table(dmi_loader* loader, const float* weight, uint32_t stride, const float* bias, uint32_t outputs,
                        const float* table, uint32_t entries, uint32_t width) {
    float* folded = dmi_load_alloc(loader, (size_t)entries * outputs);
    if (folded == NULL) return NULL;
    for (uint32_t t = 0; t < entries; t++)
        for (uint32_t o = 0; o < outputs; o++) {
            double sum = bias[o];
            for (uint32_t i = 0; i < width; i++) sum += (double)weight[o * stride + i] * table[t * width + i];
            folded[t * outputs + o] = (float)sum;
        }
    return folded;
}

/* Merges the columns of x and of INJECTION x, which follow them, into one block of columns. */
static void fold_injection(float* weight, uint32_t stride, uint32_t outputs, uint32_t first, uint32_t width) {
    for (uint32_t o = 0; o < outputs; o++)
        for (uint32_t i = 0; i < width; i++)
            weight[o * stride + first + i] += INJECTION * weight[o * stride + first + width + i];
}

static void read_joint(dmi_loader* loader, const float* embedding, dmi_dq_vae* vae) {
    const uint32_t inputs = VAE_EMBEDDING + 2 * VAE_SMALL + 3;
    dmi_load_mlp(loader, "joint.axis", 3, VAE_SMALL, VAE_SMALL, &vae->joint_axis);
    dmi_load_mlp(loader, "joint.origin", 3, VAE_SMALL, VAE_SMALL, &vae->joint_origin);
    const float* weight = dmi_load_tensor(loader, "joint.fuse.0.weight", VAE_FEATURE, inputs);
    const float* bias = dmi_load_tensor(loader, "joint.fuse.0.bias", VAE_FEATURE, 0);
    dmi_load_linear(loader, "joint.fuse.2", VAE_FEATURE, VAE_FEATURE, &vae->joint_out);
    if (loader->result != DM_OK) return;
    vae->joint_bias = fold_table(loader, weight, inputs, bias, VAE_FEATURE, embedding, VAE_TYPES, VAE_EMBEDDING);
    dmi_pack_linear(loader, weight + VAE_EMBEDDING, inputs, NULL, inputs - VAE_EMBEDDING, VAE_FEATURE,
                    &vae->joint_fuse);
}

static void read_intent(dmi_loader* loader, dmi_dq_vae* vae) {
    dmi_load_mlp(loader, "intent.direction", 3, VAE_SMALL, VAE_SMALL, &vae->direction);
    dmi_load_mlp(loader, "intent.velocity", 3, VAE_SMALL, VAE_SMALL, &vae->velocity);
    dmi_load_mlp(loader, "intent.chord", 3 * 3, VAE_FEATURE, VAE_FEATURE, &vae->chord);
    dmi_load_mlp(loader, "intent.amplitude", 2, VAE_SMALL, VAE_SMALL, &vae->amplitude);
    dmi_load_linear(loader, "intent.path_in", 5, VAE_SMALL, &vae->path_in);
    dmi_load_transformer(loader, "intent.path_layer", VAE_SMALL, VAE_PATH_HEADS, VAE_PATH_FEED_FORWARD,
                         &vae->path_layer);
    dmi_load_mlp(loader, "intent.fuse", 4 * VAE_SMALL, VAE_HIDDEN, VAE_FEATURE, &vae->motion_fuse);
    const float* position = dmi_load_tensor(loader, "intent.path_position", DMI_VAE_PATH, VAE_SMALL);
    vae->path_position = (void*)dmi_load_alloc(loader, (size_t)DMI_VAE_PATH * VAE_SMALL);
    if (vae->path_position != NULL) memcpy(vae->path_position, position, DMI_VAE_PATH * sizeof vae->path_position[0]);
}

/* Copies one FiLM layer's rows, gamma then beta, to `row` of the layer that holds them all; the bias adds the 1 of
 * 1 + gamma. */
static void add_film(dmi_loader* loader, const char* name, uint32_t width, uint32_t row, float* weight, float* bias) {
    const float* own_weight = dmi_load_part(loader, name, ".weight", 2 * width, VAE_FEATURE);
    const float* own_bias = dmi_load_part(loader, name, ".bias", 2 * width, 0);
    if (loader->result != DM_OK) return;
    memcpy(weight + (size_t)row * VAE_FEATURE, own_weight, (size_t)2 * width * VAE_FEATURE * sizeof(float));
    for (uint32_t i = 0; i < 2 * width; i++) bias[row + i] = own_bias[i] + (i < width ? 1.0f : 0.0f);
}

static void read_films(dmi_loader* loader, dmi_dq_vae* vae) {
    float* weight = dmi_load_spare(loader, VAE_FILMS * VAE_FEATURE);
    float* bias = dmi_load_spare(loader, VAE_FILMS);
    add_film(loader, "local.film", VAE_FEATURE, 0, weight, bias);
    for (uint32_t l = 0; l < VAE_LAYERS; l++) {
        char name[32]; /* longer than "decoder.layers." and ten digits */
        snprintf(name, sizeof name, "decoder.film.%u", l);
        add_film(loader, name, VAE_WIDTH, 2 * (VAE_FEATURE + l * VAE_WIDTH), weight, bias);
    }
    dmi_pack_linear(loader, weight, VAE_FEATURE, bias, VAE_FEATURE, VAE_FILMS, &vae->films);
}

static void read_decoder(dmi_loader* loader, dmi_dq_vae* vae) {
    const uint32_t inputs = VAE_SMALL + DMI_VAE_LATENT + 2 * VAE_FEATURE, joint = VAE_SMALL + DMI_VAE_LATENT;
    const float* position = dmi_load_tensor(loader, "decoder.position", DM_MOTION_FRAMES, VAE_SMALL);
    float* weight = dmi_load_tensor(loader, "decoder.input.weight", VAE_WIDTH, inputs);
    const float* bias = dmi_load_tensor(loader, "decoder.input.bias", VAE_WIDTH, 0);
    for (uint32_t l = 0; l < VAE_LAYERS; l++) {
        char name[32]; /* longer than "decoder.layers." and ten digits */
        snprintf(name, sizeof name, "decoder.layers.%u", l);
        dmi_load_transformer(loader, name, VAE_WIDTH, VAE_HEADS, VAE_FEED_FORWARD, &vae->layers[l]);
    }
    dmi_load_norm(loader, "decoder.norm", VAE_WIDTH, &vae->norm);
    dmi_load_mlp(loader, "decoder.head", VAE_WIDTH, VAE_HIDDEN, VAE_POSE, &vae->head);
    if (loader->result != DM_OK) return;
    vae->tokens = fold_table(loader, weight, inputs, bias, VAE_WIDTH, position, DM_MOTION_FRAMES, VAE_SMALL);
    fold_injection(weight, inputs, VAE_WIDTH, joint, VAE_FEATURE);
    dmi_pack_linear(loader, weight + VAE_SMALL, inputs, NULL, DMI_VAE_LATENT + VAE_FEATURE, VAE_WIDTH, &vae->condition);
}

/* Inputs: base, type, f_joint, 0.1 f_joint, axis, 0.1 axis. */
static void read_correction(dmi_loader* loader, const float* embedding, dmi_dq_vae* vae) {
    const uint32_t type = VAE_POSE, joint = type + VAE_EMBEDDING, axis = joint + 2 * VAE_FEATURE, inputs = axis + 2 * 3;
    float* weight = dmi_load_tensor(loader, "correction.0.weight", VAE_FEATURE, inputs);
    const float* bias = dmi_load_tensor(loader, "correction.0.bias", VAE_FEATURE, 0);
    const float* out_weight = dmi_load_tensor(loader, "correction.2.weight", VAE_POSE, VAE_FEATURE);
    float* out_bias = dmi_load_tensor(loader, "correction.2.bias", VAE_POSE, 0);
    dmi_load_linear(loader, "along", VAE_FEATURE, VAE_ALONG, &vae->along);
    if (loader->result != DM_OK) return;
    dmi_pack_linear(loader, weight, inputs, NULL, VAE_POSE, VAE_FEATURE, &vae->correction_base);
    vae->correction_bias =
        fold_table(loader, weight + type, inputs, bias, VAE_FEATURE, embedding, VAE_TYPES, VAE_EMBEDDING);
    fold_injection(weight, inputs, VAE_FEATURE, joint, VAE_FEATURE);
    fold_injection(weight, inputs, VAE_FEATURE, axis, 3);
    for (size_t o = 0; o < VAE_FEATURE; o++) /* the axis follows f_joint */
        memmove(weight + o * inputs + joint + VAE_FEATURE, weight + o * inputs + axis, 3 * sizeof(float));
    dmi_pack_linear(loader, weight + joint, inputs, NULL, VAE_FEATURE + 3, VAE_FEATURE, &vae->correction_joint);
    out_bias[3] += 1.0f; /* w of the identity */
    dmi_pack_linear(loader, out_weight, VAE_FEATURE, out_bias, VAE_FEATURE, VAE_POSE, &vae->correction_out);
}

void dmi_vae_read(dmi_loader* loader, void* network) {
    dmi_dq_vae* vae = network;
    const float* embedding = dmi_load_tensor(loader, "joint.type.weight", VAE_TYPES, VAE_EMBEDDING);
    read_joint(loader, embedding, vae);
    dmi_load_mlp(loader, "points", 4, VAE_SMALL, VAE_FEATURE, &vae->points);
    read_intent(loader, vae);
    dmi_load_mlp(loader, "local.mlp", VAE_CONTEXT, VAE_HIDDEN, VAE_FEATURE, &vae->local);
    read_films(loader, vae);
    dmi_load_linear(loader, "gate.gate", VAE_CONTEXT, VAE_CONTEXT, &vae->gate);
    dmi_load_mlp(loader, "gate.mlp", VAE_CONTEXT, VAE_HIDDEN, VAE_HIDDEN, &vae->fuse);
    dmi_load_mlp(loader, "encoder", VAE_HIDDEN + VAE_FEATURE, VAE_ENCODER_HIDDEN, 2 * DMI_VAE_LATENT, &vae->encoder);
    read_decoder(loader, vae);
    read_correction(loader, embedding, vae);
}
