/* A prepared object: how each of its parts moves, and the triangles it keeps for picking. */
#ifndef DMI_OBJECT_OBJECT_H
#define DMI_OBJECT_OBJECT_H

#include <stdbool.h>

#include "kinematics/inference/joint_inference.h"
#include "mesh/part_points.h"
#include "pick/pick.h"

typedef struct dmi_object_part {
    dmi_part shape;                /* shape.parent: index in dmi_object.parts */
    int32_t given_type;            /* DM_JOINT_* given by the host; DM_JOINT_UNKNOWN: inferred */
    dmi_asset_hints asset_hints;   /* inner frame; for dmi_object_refine too; not saved */
    dm_joint joint;                /* the one in use; host object frame */
    dmi_hypotheses hypotheses;     /* inner frame */
    dmi_alternatives alternatives; /* inner frame */
    dmi_part_points points;
} dmi_object_part;

typedef struct dmi_object {
    dmi_frame frame;
    float box_min[3], box_max[3]; /* inner frame */
    uint64_t vertex_count, triangle_count, seed;
    dmi_object_part* parts; /* [0] is the body; then parts by rising id */
    uint32_t part_count;    /* the body included */
    uint32_t degraded;  /* DM_DEGRADED_* that the object was prepared with, except those that it can tell from itself */
    bool network_alone; /* joints are inferred by KPP-Net alone, without geometry and ranker */
    dmi_packed_mesh* mesh; /* NULL: no triangles are kept */
    dmi_bvh* bvh;          /* NULL: no triangles are kept, or nothing picks */
} dmi_object;

/* Creates an object with zeroed parts. */
dm_result dmi_object_create(dmi_env* env, uint32_t part_count, dmi_object** out_object);
/* Destroys the object. NULL does nothing. */
void dmi_object_destroy(dmi_env* env, dmi_object* object);
/* Frees the triangles, and with them picking and refinement. */
void dmi_object_drop_triangles(dmi_env* env, dmi_object* object);

/* Returns the index of the part with the host's id: 0 for the body, -1 when there is none. */
int32_t dmi_object_find_part(const dmi_object* object, uint32_t id);
/* Returns whether part `index` is `ancestor` or one of its descendants. */
bool dmi_object_moves_with(const dmi_object* object, uint32_t index, uint32_t ancestor);

/* Sets the object's box to the union of its parts' boxes. */
void dmi_object_bound(dmi_object* object);
/* Describes part `index` in the host object frame; struct_size is set. */
dm_part_info dmi_object_part_out(const dmi_object* object, uint32_t index);
/* Transforms a box to the host object frame and computes its axis-aligned box there. */
void dmi_object_box_out(const dmi_frame* frame, const float min[3], const float max[3], dm_vec3* out_min,
                        dm_vec3* out_max);

/* Checks a host's drag on a part and transforms it to the inner frame. Errors: NOT_FINITE, ZERO_DRAG, DRAG_OFF_PART,
 * with `what` ("dm_function: field") in the message. */
dm_result dmi_object_hint(dmi_env* env, const char* what, const dmi_object* object, uint32_t part,
                          const dm_drag_hint* drag, dmi_drag_hint* out_hint);

/* ---- triangles and trees ---- */

/* Keeps a mesh with the object's parts. */
dm_result dmi_object_pack(dmi_env* env, const dmi_unpacked* from, bool wide, const dmi_progress* progress,
                          dmi_object* object);
/* Makes the trees of the triangles that the object keeps. shapes: one a part, stored before; NULL: the trees are built.
 * Errors are those of dmi_bvh_create. */
dm_result dmi_object_make_trees(dmi_picker* picker, const dmi_tree_shape* shapes, const dmi_progress* progress,
                                dmi_object* object);
/* Computes the mesh that was packed. Every number has the same bits. */
dm_result dmi_object_unpack(dmi_env* env, const dmi_object* object, const dmi_progress* progress, dmi_mesh** out_mesh);
/* Returns trees whose shapes go into the object's file: its own, or new ones, which *out_made points to and the caller
 * destroys. Returns NULL where there are none. */
dm_result dmi_object_stored_trees(dmi_env* env, const dmi_object* object, const dmi_bvh** out_trees,
                                  dmi_bvh** out_made);

/* ---- copies of some of its parts: part_selection.c ---- */

/* Makes an object of the parts for which keep is not 0. The triangles of the others go to what carries them. Joints
 * stay as they are. object: must have its mesh. keep: one number a part; the body's is not read. keep_triangles: the
 * new object keeps its mesh too, with trees to pick by. */
dm_result dmi_object_select_parts(dmi_env* env, dmi_picker* picker, const dmi_object* object, const uint8_t* keep,
                                  bool keep_triangles, dmi_object** out_object);

/* Copies an object with its parts in another order, its triangles included, without trees. number[i]: the new index,
 * from 0, of part i + 1. Ids become the indices of the parts. */
dm_result dmi_object_reorder_parts(dmi_env* env, const dmi_object* object, const uint32_t* number,
                                   dmi_object** out_object);

#endif
