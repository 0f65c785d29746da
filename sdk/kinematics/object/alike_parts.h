/* Parts of one shape in the same surroundings, such as the keys of a keyboard. Where an object has many parts, one
 * inference serves all that are alike. */
#ifndef DMI_OBJECT_ALIKE_PARTS_H
#define DMI_OBJECT_ALIKE_PARTS_H

#include "kinematics/object/object.h"

/* Number of parts from which on alike ones are looked for; by hand: objects that people made had 126 at most. */
#define DMI_MANY_PARTS 256

/* Sets out_like[i] to the first part that part i is like, or to i. excluded: per part, 1 for one that is like no other.
 * The function looks only at parts that the body carries and that carry none. mesh: the object's, with the masks that
 * are inferred from. progress: gets no share, and is asked whether to stop. Memory comes from the arena. */
dm_result dmi_alike_parts_find(dmi_arena* arena, const dmi_mesh* mesh, const dmi_object* object,
                               const uint8_t* excluded, const dmi_progress* progress, uint32_t* out_like);

/* Gives a part the answers of the one that it is like, at its own place. */
void dmi_alike_part_copy(dmi_object* object, uint32_t from, uint32_t to);

#endif
