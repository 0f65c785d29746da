/* Instances of objects: their parts as placed in the world, and how a ray meets one. */
#ifndef DMI_PICK_PLACED_H
#define DMI_PICK_PLACED_H

#include <math.h>
#include <string.h>

#include "math/linear3.h"
#include "pick/bvh.h"
#include "pick/top_tree.h"

/* Bound of ray origins and translations, host units, so that no product of floats overflows. */
#define DMI_MAX_COORDINATE 1e10
/* Constants of floats: where the exponent stands in their bits, what it is of 1, and numbers whose products with the
 * largest and smallest ones are normal numbers. */
#define DMI_FLOAT_EXPONENT_SHIFT 23
#define DMI_FLOAT_BIAS 127
#define DMI_FLOAT_SMALL 0x1p-64f
#define DMI_FLOAT_LARGE 0x1p64f

typedef struct dmi_placed_object dmi_placed_object;

typedef struct dmi_placed_part {
    const dmi_placed_object* owner;
    const dmi_bvh_part* shape; /* shape in the owner's bvh */
    /* Placement as committed, from the object-normalised frame, in the order in which a hit needs the numbers; the way
     * back is in the tree's item. They are doubles so that objects far from the origin keep their shape. */
    double to_world[DMI_MATRIX], to_object[DMI_MATRIX];
    double winding; /* -1 where to_world mirrors, else 1 */
    uint32_t leaf;  /* leaf of the scene's tree; DMI_TOP_NONE: there is nothing to hit */
    bool moved;     /* it has moved since the last commit */
    dm_pose pose;   /* pose from rest, object frame */
} dmi_placed_part;

struct dmi_placed_object {
    dmi_placed_object *next_dirty, *previous_dirty;
    const dmi_bvh* bvh;
    void* user;
    dmi_frame frame;
    dm_object object;
    dm_pose placement;
    uint32_t id;
    bool dirty;              /* it is in the scene's list */
    bool moved;              /* placement, since the last commit */
    dmi_placed_part parts[]; /* one a part of bvh */
};

/* A ray in the world. The direction is the host's times a power of two, its largest component in [0.5, 1): the same
 * line to the bit, in floats and in doubles. */
typedef struct dmi_world_ray {
    double origin[4], direction[4];
    float origin_f32[3], direction_f32[3]; /* the same numbers */
} dmi_world_ray;

/* Returns the power of two that brings a number from DMI_FLOAT_SMALL to DMI_FLOAT_LARGE into [0.5, 1). */
static inline float dmi_scale_to_one(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits = (2 * DMI_FLOAT_BIAS - 1 - (bits >> DMI_FLOAT_EXPONENT_SHIFT)) << DMI_FLOAT_EXPONENT_SHIFT;
    memcpy(&x, &bits, sizeof bits);
    return x;
}

/* False for rays that hit nothing anywhere: without a direction, or from out of reach. */
static inline bool dmi_world_ray_start(const dm_ray* host_ray, dmi_world_ray* out) {
    const dmi_float3 origin = dmi_xyz(host_ray->origin);
    dmi_float3 direction = dmi_xyz(host_ray->direction);
    float largest = 0;
    for (int k = 0; k < 3; k++) {
        if (!isfinite(direction.v[k]) || !(fabsf(origin.v[k]) <= (float)DMI_MAX_COORDINATE)) return false;
        largest = fabsf(direction.v[k]) > largest ? fabsf(direction.v[k]) : largest;
    }
    if (!(largest > 0)) return false;
    const float first = largest < DMI_FLOAT_SMALL ? DMI_FLOAT_LARGE : largest > DMI_FLOAT_LARGE ? DMI_FLOAT_SMALL : 1;
    const float second = dmi_scale_to_one(largest * first);
    for (int k = 0; k < 3; k++) {
        out->origin_f32[k] = origin.v[k];
        out->direction_f32[k] = direction.v[k] * first * second;
        out->origin[k] = (double)out->origin_f32[k];
        out->direction[k] = (double)out->direction_f32[k];
    }
    out->origin[3] = out->direction[3] = 0;
    return true;
}

typedef struct dmi_world_hit {
    const dmi_placed_part* part; /* NULL: none */
    double distance;             /* distance in lengths of the direction */
    double weight[2];            /* weights of the second and third corner */
    double triangle[3][4];       /* its first corner, and the way to the other two */
    uint32_t face;
} dmi_world_hit;

/* Computes matrices, item and box of a part that has moved. at_rest: of the parts of an object that are updated one
 * after the other, the last that is at rest, NULL at first; parts at rest share their matrices. */
void dmi_placed_part_update(dmi_placed_part* part, dmi_top_tree* tree, const double placement[DMI_MATRIX],
                            const double from_inner[DMI_MATRIX], const dmi_placed_part** at_rest);
/* Finds the nearest hit among the parts of a scene, zeros where there is none. With the same bits from each. */
typedef void dmi_scene_trace(const dmi_top_tree* tree, const dm_ray* host_ray, dm_hit* out_hit);
dmi_scene_trace dmi_scene_trace_plain;
#if defined(__x86_64__)
dmi_scene_trace dmi_scene_trace_avx2;
#endif
/* A pose as a matrix like those above. */
void dmi_pose_matrix_f64(const dm_pose* pose, double out[DMI_MATRIX]);

#endif
