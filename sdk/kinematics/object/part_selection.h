/* A prepared object of some of the parts of another. */
#ifndef DMI_OBJECT_PART_SELECTION_H
#define DMI_OBJECT_PART_SELECTION_H

#include "kinematics/object/object.h"

/* Makes an object of the parts for which keep is not 0; triangles of the others go with what carries them. Joints stay
 * as they are. object: with its mesh. keep: one a part; that of the body is not read. keep_triangles: also the new
 * object keeps its mesh, with trees to pick by. */
dm_result dmi_object_select_parts(dmi_env* env, dmi_picker* picker, const dmi_object* object, const uint8_t* keep,
                                  bool keep_triangles, dmi_object** out_object);

/* Bytes that dmi_object_renumber needs for an object of `count` parts besides its body. */
#define DMI_RENUMBER_SCRATCH(count) (((size_t)(count) + 1) * (sizeof(dmi_object_part) + sizeof(uint32_t)))

/* Gives part i + 1 the index, and the id, number[i] + 1: `number` is a permutation. The object keeps its mesh. */
void dmi_object_renumber(dmi_object* object, const uint32_t* number, void* scratch);

#endif
