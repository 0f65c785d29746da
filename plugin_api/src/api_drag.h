/* Drag handles for other parts of the boundary. */
#ifndef DMI_API_DRAG_H
#define DMI_API_DRAG_H

#include <stdbool.h>

#include "api_handles.h"

/* Least time, share or catch of a feel that is not 0: its inverse stays in a float's range. By hand. */
#define DMI_SMALLEST_FEEL 1e-12f

/* Checks desc.feel of dm_drag_begin. */
dm_result dmi_check_feel(dmi_env* env, const dm_drag_feel* feel);
/* Returns the feel with times and catches that can be computed with. */
dm_drag_feel dmi_usable_feel(const dm_drag_feel* given);
/* Whether a drag can have begun with this feel. */
bool dmi_is_usable_feel(const dm_drag_feel* feel);
/* What rules depend on: the joint that the drag begins with, which of its limits count, and the object's size in host
 * units. */
typedef struct dmi_rules_start {
    const dm_joint* joint;
    bool one_sided;
    float object_size;
} dmi_rules_start;

/* Reads desc->rules of any version; NULL: none. desc->feel must have been checked. */
dm_result dmi_rules_read(dmi_env* env, const dm_drag_desc* desc, const dmi_rules_start* start, dmi_rules* out);
/* Returns whether a drag can have begun with these rules. */
bool dmi_is_sound_rules(const dmi_rules* rules);
/* Reads and checks the input of an update, of any version. It logs nothing. */
dm_result dmi_input_read(const dmi_drag* drag, const dm_drag_input* input, dm_drag_input* out);
/* Returns a number that tells a part from others, made of its id, its box, the counts of part and object, and the types
 * of its joints. */
uint64_t dmi_part_key(const dmi_object* object, uint32_t part);
/* Reports once what the [frame] calls of a drag have noticed and may not log themselves. */
void dmi_drag_slot_warn(dmi_env* env, const char* function, dmi_drag_slot* slot);

#endif
