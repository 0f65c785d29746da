/* A prepared object of some of the parts of another. */
#ifndef DMI_OBJECT_PART_SELECTION_H
#define DMI_OBJECT_PART_SELECTION_H

#include "kinematics/object/object.h"

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
