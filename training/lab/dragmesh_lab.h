/* Declares what training calls: batches of network inputs and labels, made by the sdk's own code from generated
 * objects.
 *
 * Everything is seeded: the same options give the same bits. Arrays belong to the caller and hold `count` cases each.
 * Lengths are object-normalised unless said otherwise; joint types are 0 revolute, 1 prismatic, 2 screw, 3 continuous.
 */
#ifndef DRAGMESH_LAB_H
#define DRAGMESH_LAB_H

#include <stdint.h>

#include "dragmesh/dragmesh.h"

/* Which objects: seeds are dealt to the splits by a hash of category id and seed, 18 : 1 : 1 (dmg_split). */
enum { DM_LAB_TRAIN = 0, DM_LAB_VALIDATION = 1, DM_LAB_TEST = 2 };

/* Kinds of pulls. Where a hand takes hold, and their shares in the mixture, are in one table (pull.c). */
enum {
    DM_LAB_PULL_TANGENT = 0, /* anywhere on the part, the way in which the point starts to move, with an error */
    DM_LAB_PULL_EXACT = 1,   /* the same without an error */
    DM_LAB_PULL_CHORD = 2,   /* straight to where the point is after any share of its way */
    DM_LAB_PULL_ROOM = 3,    /* along the nearest axis of the room that the object was modelled in */
    DM_LAB_PULL_SCREEN = 4,  /* along the nearest axis of a camera in any orientation */
    DM_LAB_PULL_MIXED = 5,   /* any of these */
    DM_LAB_PULL_CAREFUL = 6  /* either of the first two, anywhere on the part */
};

typedef struct dm_lab_options {
    uint64_t seed;
    uint32_t count;
    int32_t split; /* DM_LAB_* */
    /* Weight of each category id: how often it is drawn against the others, 0 never; dm_lab_category_id_limit() bytes.
     * Ids of no category need 0. */
    const uint8_t* categories;
    float messy;              /* share of objects made with DMG_MESSY */
    float mask_noise;         /* share of objects whose part mask loses or leaks patches */
    float rotated;            /* share of objects turned by a random rotation */
    float with_drag;          /* share of cases with a drag (KPP alone: the VAE always has one) */
    float drag_noise_degrees; /* each case's drag error has a sigma between 0 and this many degrees; exact pulls have
                                 none, half of the straight ones either */
    float joint_noise;        /* VAE: share of cases whose given joint is slightly off */
    float hand_noise;         /* VAE: share of cases whose path is drawn by an unsteady hand */
    int32_t pull;             /* DM_LAB_PULL_*; the VAE's and the part finder's cases are tangential */
} dm_lab_options;

/* A batch for KPP-Net: its input (docs/networks.md), and labels in the input's frame. */
typedef struct dm_lab_kpp {
    float* global_points;  /* x 48 x 16 x 17 */
    float* global_centres; /* x 48 x 3 */
    float* local_points;   /* x 24 x 16 x 17 */
    float* local_centres;  /* x 24 x 3 */
    float* shape;          /* x 56 */
    int32_t* type;
    int32_t* has_drag; /* 1: positive motion follows the drag; 0: positive motion opens, the axis' sign is free */
    int32_t* category; /* id */
    float* axis;       /* x 3 */
    float* origin;     /* x 3: the point of the axis nearest the part's centre */
    float* limits;     /* x 5: turn lower, upper (pi rad), slide lower, upper, pitch (inner units, a radian) */
    float* size;       /* object-normalised length of one inner unit */
} dm_lab_kpp;

/* A batch for the DQ-VAE: its input (docs/networks.md), the true joint values, and the closed-form answer to the path.
 */
typedef struct dm_lab_vae {
    float* xyz;  /* x 64 x 3 */
    float* mask; /* x 64 */
    int32_t* type;
    int32_t* category;    /* id */
    float* axis;          /* x 3: of the joint the network is given */
    float* origin;        /* x 3 */
    float* pitch;         /* of that joint, not clamped */
    float* features;      /* x 100: dmi_vae_features in order */
    int32_t* near_origin; /* x 4 */
    int32_t* near_drag;   /* x 4 */
    float* drag_point;    /* x 3 */
    float* drag_vector;   /* x 3 */
    float* limits;        /* x 2: lower, upper of the given joint */
    float* values;        /* x 16: the motion meant, noise-free and inside the limits */
    float* closed_form;   /* x 16: the value nearest to each point of the path, inside the limits */
} dm_lab_vae;

/* The generator's categories, in rows 0 .. count - 1. Everything else here names a category by its id, which stays the
 * same when rows are added or moved. */
DM_API uint32_t dm_lab_category_count(void);
DM_API const char* dm_lab_category_name(uint32_t row); /* NULL: no such row */
DM_API uint32_t dm_lab_category_id(uint32_t row);      /* UINT32_MAX: no such row */
DM_API int32_t dm_lab_category_set(uint32_t row);      /* DMG_SET_* of generator.h; -1: no such row */
DM_API uint32_t dm_lab_category_id_limit(void);        /* 1 + the largest id */
/* Returns how many differently named joints the objects of the category's first seeds have: a controller many, a book
 * one. Used as a weight, so that every kind of joint gets its share. */
DM_API uint32_t dm_lab_category_kinds(uint32_t row);
/* Returns the size in bytes of the options (which = 0), dm_lab_kpp (1) and dm_lab_vae (2), for a binding's check. */
DM_API uint32_t dm_lab_layout(uint32_t which);

/* Fill a batch. Return DM_OK, or the error of a case whose 64 attempts all failed. */
DM_API dm_result dm_lab_kpp_batch(const dm_lab_options* options, const dm_lab_kpp* out);
DM_API dm_result dm_lab_vae_batch(const dm_lab_options* options, const dm_lab_vae* out);

#endif
