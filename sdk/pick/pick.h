/* Ray picking: one static tree of triangles a part, built once with the object by Embree or by a backend of our own; a
 * scene of moved instances on top. A camera gives the ray through a pixel. */
#ifndef DMI_PICK_PICK_H
#define DMI_PICK_PICK_H

#include <stdbool.h>

#include "base/env.h"
#include "base/progress.h"
#include "mesh/packed_mesh.h"

typedef struct dmi_picker dmi_picker; /* the backend of a context, without threads of its own */
typedef struct dmi_bvh dmi_bvh;       /* the parts of one object, object-normalised, at rest */
typedef struct dmi_scene dmi_scene;   /* instances in the host's world frame */

/* choice: DM_PICK_*. UNSUPPORTED when the backend asked for does not work here; DM_PICK_AUTO then takes the next, and
 * at last none. */
dm_result dmi_picker_create(dmi_env* env, int32_t choice, dmi_picker** out_picker);
void dmi_picker_destroy(dmi_picker* picker);
/* Returns "embree", "portable" or "none". */
const char* dmi_picker_backend(const dmi_picker* picker);

/* The parts' ids, `step` bytes from each other. */
typedef struct dmi_part_ids {
    const uint32_t* first;
    size_t step;
} dmi_part_ids;

typedef struct dmi_tree_shape dmi_tree_shape;

/* What trees are made from. */
typedef struct dmi_bvh_source {
    const dmi_packed_mesh* mesh; /* outlives the trees */
    dmi_part_ids ids;
    const dmi_tree_shape* shapes; /* a part, stored before; NULL: they are built */
} dmi_bvh_source;

/* Whether trees of this context may be restored from shapes; and whether it reads corners of 32 bits alone where they
 * are not. */
bool dmi_picker_restores(const dmi_picker* picker);
bool dmi_picker_is_wide(const dmi_picker* picker);

/* Builds the trees, or restores them: BAD_DATA, without a message, where a shape is none of its triangles. NULL, and
 * DM_OK, where the context picks nothing. */
dm_result dmi_bvh_create(dmi_picker* picker, const dmi_bvh_source* from, const dmi_progress* progress,
                         dmi_bvh** out_bvh);
/* Builds trees whose shapes can be stored; NULL, and DM_OK, in a library that has none. */
dm_result dmi_bvh_create_to_store(dmi_env* env, const dmi_bvh_source* from, dmi_bvh** out_bvh);
/* The shape of a part's tree, zeros where it has none; false where such trees are not stored. */
bool dmi_bvh_shapes(const dmi_bvh* bvh, uint32_t part, dmi_tree_shape* out_shape);
/* NULL does nothing. */
void dmi_bvh_destroy(dmi_bvh* bvh);
/* DM_PICK_*: whose trees they are; NULL: DM_PICK_NONE. */
int32_t dmi_bvh_picking(const dmi_bvh* bvh);

/* UNSUPPORTED where the context picks nothing. */
dm_result dmi_scene_create(dmi_picker* picker, dmi_scene** out_scene);
void dmi_scene_destroy(dmi_scene* scene);
/* Adds an instance. `object` is the handle reported in hits; `frame` is the mesh's. The bvh must outlive the instance.
 */
dm_result dmi_scene_add(dmi_scene* scene, const dmi_bvh* bvh, const dmi_frame* frame, dm_object object,
                        const dm_pose* host_placement, uint32_t* out_instance);
/* A pointer kept with an instance, NULL at first; and NULL for one that is not there. */
void dmi_scene_set_user(dmi_scene* scene, uint32_t instance, void* user);
void* dmi_scene_user(const dmi_scene* scene, uint32_t instance);
/* part_id: the host's, 0 = the placement of the whole. Poses in host units: the part's own is from rest in the object
 * frame, the poses of the parts that carry it included. Allocates and logs nothing. NOT_FOUND: no such
 * instance or part; INVALID_ARGUMENT: too far away. */
dm_result dmi_scene_move(dmi_scene* scene, uint32_t instance, uint32_t part_id, const dm_pose* host_pose);
/* Takes effect at once, without a commit. */
dm_result dmi_scene_remove(dmi_scene* scene, uint32_t instance);
/* Instances added and moves made since the last commit become visible. No allocation; a move takes the time of its own
 * part, and of one way through the tree of the others. */
void dmi_scene_commit(dmi_scene* scene);
/* out_hit->object 0 when nothing is hit. The normal is (b - a) x (c - a) of the corners' host world coordinates, made
 * unit: in a left-handed host it points to the side from which the corners run clockwise. */
void dmi_scene_pick(const dmi_scene* scene, const dm_ray* host_ray, dm_hit* out_hit);

/* ---- camera.c ---- */

/* Converts a screen position to a ray. handedness: +1 right-handed host, -1 left-handed. False (and no output) for a
 * camera without a valid frame or viewport. */
bool dmi_camera_ray(const dm_camera* camera, float handedness, float x, float y, dm_ray* out_ray);

#endif
