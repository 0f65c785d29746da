/* The DQ-VAE's layers in memory. What does not depend on a query is folded when they are loaded. */
#ifndef DMI_MOTION_DQ_VAE_NET_H
#define DMI_MOTION_DQ_VAE_NET_H

#include "motion/dq_vae.h"
#include "nn/layers.h"

/* Widths of the `game` size (docs/networks.md). */
enum {
    VAE_TYPES = 4,
    VAE_SMALL = 32, /* a direction, a position, a pair of scalars */
    VAE_EMBEDDING = 16,
    VAE_FEATURE = 64, /* f_joint, f_local, f_motion, a point's features */
    VAE_CONTEXT = 3 * VAE_FEATURE,
    VAE_HIDDEN = 96,
    VAE_ENCODER_HIDDEN = 128,
    VAE_PATH_HEADS = 2,
    VAE_PATH_FEED_FORWARD = 64,
    VAE_WIDTH = 96,
    VAE_HEADS = 4,
    VAE_FEED_FORWARD = 384,
    VAE_LAYERS = 3,
    VAE_POSE = 8, /* numbers of a dual quaternion */
    VAE_ALONG = 2 /* rotation and translation on the axis */
};

/* FiLM coefficients of f_joint for one layer: x scale + shift, scale = 1 + gamma. */
typedef struct dmi_vae_film {
    float scale[VAE_WIDTH], shift[VAE_WIDTH];
} dmi_vae_film;

/* The coefficients of all FiLM layers, which one matrix product of f_joint gives. */
typedef struct dmi_vae_films {
    float local_scale[VAE_FEATURE], local_shift[VAE_FEATURE];
    dmi_vae_film decoder[VAE_LAYERS];
} dmi_vae_films;
#define VAE_FILMS (sizeof(dmi_vae_films) / sizeof(float))

struct dmi_dq_vae {
    dmi_env* env;
    dmi_arena arena;

    dmi_mlp joint_axis, joint_origin;
    dmi_linear joint_fuse;            /* layer over [axis, origin, scalars]; it has no bias … */
    float (*joint_bias)[VAE_FEATURE]; /* … because a type's embedding gives it */
    dmi_linear joint_out;
    dmi_linear films; /* f_joint -> dmi_vae_films */

    dmi_mlp points;

    dmi_mlp direction, velocity, chord, amplitude;
    dmi_linear path_in;
    float (*path_position)[VAE_SMALL];
    dmi_transformer path_layer;
    dmi_mlp motion_fuse;

    dmi_mlp local;
    dmi_linear gate;
    dmi_mlp fuse;
    dmi_mlp encoder;

    float (*tokens)[VAE_WIDTH]; /* decoder.input of the frames' positions */
    dmi_linear condition;       /* decoder.input over [z, f_joint], both its uses of f_joint summed; it has no bias */
    dmi_transformer layers[VAE_LAYERS];
    dmi_norm norm;
    dmi_mlp head;

    dmi_linear correction_joint; /* layer over [f_joint, axis], both uses of each summed; it has no bias … */
    float (*correction_bias)[VAE_FEATURE]; /* … because a type's embedding gives it */
    dmi_linear correction_base;            /* layer over a frame's base; it has no bias */
    dmi_linear correction_out;             /* its bias holds the identity pose too */
    dmi_linear along;                      /* turn and slide on the axis */
};

/* Reads the layers of a dmi_dq_vae. */
dmi_read_network dmi_vae_read;

#endif
