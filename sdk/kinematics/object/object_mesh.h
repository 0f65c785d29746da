/* The triangles that an object keeps: for picking, for refinement, for its file. */
#ifndef DMI_OBJECT_OBJECT_MESH_H
#define DMI_OBJECT_OBJECT_MESH_H

#include "kinematics/object/object.h"

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

#endif
