/* Instances of objects: their parts as placed in the world, and how a ray meets one. */
#ifndef DMI_PICK_PLACED_H
#define DMI_PICK_PLACED_H

#include "pick/bvh.h"
#include "pick/top_tree.h"

typedef struct dmi_placed_object dmi_placed_object;

typedef struct dmi_placed_part {
    const dmi_placed_object* owner;
    uint32_t part; /* of the bvh */
    uint32_t leaf; /* of the scene's tree; DMI_TOP_NONE: nothing to hit */
    bool moved;    /* since the last commit */
    dm_pose pose;  /* from rest, object frame */
    /* As committed, from the object-normalised frame; 3x4, column-major; doubles so that objects far from the origin
     * keep their shape. */
    double to_object[12], to_world[12];
    double scale, inverse_scale; /* of both: host units in one of the object-normalised frame */
} dmi_placed_part;

struct dmi_placed_object {
    dmi_placed_object *next_dirty, *previous_dirty;
    const dmi_bvh* bvh;
    void* user;
    dmi_frame frame;
    dm_object object;
    dm_pose placement;
    uint32_t id;
    bool dirty;              /* in the scene's list */
    bool moved;              /* placement, since the last commit */
    dmi_placed_part parts[]; /* of bvh */
};

/* A ray in the world. The direction is the host's times a power of two, its largest component in [0.5, 1): the same
 * line to the bit, in floats and in doubles. */
typedef struct dmi_world_ray {
    double origin[3], direction[3];
} dmi_world_ray;

typedef struct dmi_world_hit {
    const dmi_placed_part* part; /* NULL: none */
    double distance;             /* in lengths of the direction */
    double weight[2];            /* of the second and third corner */
    uint32_t face;
} dmi_world_hit;

/* Computes matrices and box of a part that has moved. */
void dmi_placed_part_update(dmi_placed_part* part, const double placement[12], const double from_inner[12],
                            dmi_box* out_box);
/* Tests a part whose box the ray enters at `entry`; replaces a hit that is farther away. Of hits at the same distance,
 * that of the lower instance and part wins, so that the order of tests does not count. */
void dmi_placed_part_hit(const dmi_placed_part* part, const dmi_world_ray* ray, float entry, dmi_world_hit* hit);
void dmi_placed_part_describe(const dmi_world_ray* ray, const dmi_world_hit* hit, dm_hit* out_hit);
/* A pose as a matrix like those above. */
void dmi_pose_matrix_f64(const dm_pose* pose, double out[12]);

#endif
