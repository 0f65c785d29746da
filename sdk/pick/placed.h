/* Instances of objects: their parts as placed in the world, and how a ray meets one. */
#ifndef DMI_PICK_PLACED_H
#define DMI_PICK_PLACED_H

#include "pick/bvh.h"
#include "pick/top_tree.h"

/* Numbers of a 3x4 matrix, column-major, and one more, so that code may compute four rows at once. Likewise the fourth
 * number of points and directions: what it holds does not count. */
#define DMI_MATRIX 13

typedef struct dmi_placed_object dmi_placed_object;

typedef struct dmi_placed_part {
    const dmi_placed_object* owner;
    uint32_t part; /* of the bvh */
    uint32_t leaf; /* of the scene's tree; DMI_TOP_NONE: nothing to hit */
    bool moved;    /* since the last commit */
    dm_pose pose;  /* from rest, object frame */
    /* As committed, from and to the object-normalised frame; doubles so that objects far from the origin keep their
     * shape. */
    double to_object[DMI_MATRIX], to_world[DMI_MATRIX], from_world[DMI_MATRIX];
    double scale, inverse_scale; /* host units in one of the object-normalised frame */
    double winding;              /* -1 where to_world mirrors, else 1 */
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
    double origin[4], direction[4];
    double length, inverse_squared; /* of the direction; of the square of its length */
} dmi_world_ray;

typedef struct dmi_world_hit {
    const dmi_placed_part* part; /* NULL: none */
    double distance;             /* in lengths of the direction */
    double weight[2];            /* of the second and third corner */
    uint32_t face;
} dmi_world_hit;

/* Computes matrices and box of a part that has moved. */
void dmi_placed_part_update(dmi_placed_part* part, const double placement[DMI_MATRIX],
                            const double from_inner[DMI_MATRIX], dmi_box* out_box);
/* Tests a part whose box the ray enters at `entry`; replaces a hit that is farther away. Of hits at the same distance,
 * that of the lower instance and part wins, so that the order of tests does not count. */
void dmi_placed_part_hit(const dmi_placed_part* part, const dmi_world_ray* ray, float entry, dmi_world_hit* hit);
void dmi_placed_part_describe(const dmi_world_ray* ray, const dmi_world_hit* hit, dm_hit* out_hit);
/* A pose as a matrix like those above. */
void dmi_pose_matrix_f64(const dm_pose* pose, double out[DMI_MATRIX]);

#endif
