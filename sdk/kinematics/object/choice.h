/* Lets the host choose among a part's hypotheses. */
#ifndef DMI_OBJECT_CHOICE_H
#define DMI_OBJECT_CHOICE_H

#include "kinematics/object/object.h"

/* Shows the hypotheses of part `index` to the host, and puts the one it chooses in force. The object must still have
 * its triangles. Does nothing for a part that the host has declared fixed. Errors: INDEX_OUT_OF_RANGE. */
dm_result dmi_choose_joint(dmi_env* env, dmi_object* object, const dmi_mesh* mesh, uint32_t index,
                           dm_choice_callback choose, void* user);

#endif
