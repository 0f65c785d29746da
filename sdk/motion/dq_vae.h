/* DQ-VAE (paper §3.3): joint + cloud + drag path -> 16 dual quaternions about the joint origin. Forward pass, split by
 * how often the inputs change: object (prepare), then joint and drag. */
#ifndef DMI_MOTION_DQ_VAE_H
#define DMI_MOTION_DQ_VAE_H

#include "base/cpu.h"
#include "mesh/cloud.h"

/* Sizes of the `game` network, docs/networks.md. */
#define DMI_VAE_POINTS DMI_PART_POINTS
#define DMI_VAE_PART_POINTS (DMI_VAE_POINTS * DMI_CLOUD_PART / DMI_CLOUD_POINTS) /* the first ones */
#define DMI_VAE_NEIGHBOURS 4 /* points near the joint origin, and near the drag point */
#define DMI_VAE_POINT_FEATURES 64
#define DMI_VAE_LATENT 32 /* dimensions */
#define DMI_VAE_PATH 16   /* points of the drag path */

typedef struct dmi_dq_vae dmi_dq_vae;

/* Features of the object and the part alone, kept with the prepared object. */
typedef struct dmi_vae_object {
    float xyz[DMI_VAE_POINTS][3];
    float mask[DMI_VAE_POINTS];
    float global[DMI_VAE_POINT_FEATURES]; /* max over the points' features */
} dmi_vae_object;

typedef struct dmi_vae_query {
    dm_joint joint; /* inner frame */
    float drag_point[3];
    float drag_vector[3];
    float path[DMI_VAE_PATH][3]; /* where the pointer moved the drag point; [0] = drag_point */
    uint32_t seed;               /* 0 takes z = mu */
} dmi_vae_query;

typedef struct dmi_vae_output {
    float raw[DM_MOTION_FRAMES][8]; /* x,y,z,w of real, then of dual, about the joint origin; raw network output */
    float mean[DMI_VAE_LATENT], log_variance[DMI_VAE_LATENT];
} dmi_vae_output;

dm_result dmi_dq_vae_load(dmi_env* env, const void* data, size_t size, dmi_dq_vae** out_vae);
void dmi_dq_vae_destroy(dmi_dq_vae* vae);
void dmi_dq_vae_prepare(const dmi_dq_vae* vae, dmi_isa isa, const dmi_part_points* points, dmi_vae_object* out_object);
/* The part of dmi_dq_vae_prepare that needs no weights: xyz and mask. Training calls it too. */
void dmi_vae_object_points(const dmi_part_points* points, dmi_vae_object* out_object);
size_t dmi_dq_vae_scratch_size(const dmi_dq_vae* vae);
/* Runs the network. scratch: 64-byte aligned memory. The function allocates nothing. */
void dmi_dq_vae_forward(const dmi_dq_vae* vae, dmi_isa isa, const dmi_vae_object* object, const dmi_vae_query* query,
                        void* scratch, dmi_vae_output* out_output);

/* The network's input features of a query, computed here for C and for training (docs/networks.md). */
typedef struct dmi_vae_features {
    float joint_scalars[3]; /* pitch, lower, upper, each clamped to [-4, 4] */
    float rotation_direction[3];
    float mean_velocity[3];
    float chords[9];             /* vectors from the first path point to every fifth */
    float amplitude[2];          /* joint value at the end, length of the path */
    float path[DMI_VAE_PATH][5]; /* offset from the start, joint value, residual */
} dmi_vae_features;
void dmi_vae_features_make(const dmi_vae_query* query, dmi_vae_features* out_features);
/* Finds the DMI_VAE_NEIGHBOURS points nearest to `centre`, nearest first, ties by index. */
void dmi_vae_neighbours(const dmi_vae_object* object, const float centre[3], uint32_t out_indices[DMI_VAE_NEIGHBOURS]);

#endif
