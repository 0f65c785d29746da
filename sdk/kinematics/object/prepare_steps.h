/* The steps of dmi_object_prepare that have files of their own. */
#ifndef DMI_OBJECT_PREPARE_STEPS_H
#define DMI_OBJECT_PREPARE_STEPS_H

#include "kinematics/object/prepare.h"

/* ---- part_hints.c: what the host's descriptors say of the asset: labels, pivots, the up direction ---- */

/* Sets asset_hints of all parts. mesh: the object's. parts: `count` descriptors; NULL with a count of 0: none. Errors:
 * NOT_FINITE, TOO_LARGE for a label. */
dm_result dmi_object_read_hints(dmi_env* env, const dmi_mesh* mesh, dmi_object* object, const dmi_object_labels* labels,
                                const dm_part_desc* parts, uint32_t count);

/* ---- alike_parts.c: parts of one shape in the same surroundings, such as the keys of a keyboard ---- */

/* Number of parts from which on alike ones are looked for, so that one inference serves all of them; by hand: objects
 * that people made had 126 at most. */
#define DMI_MANY_PARTS 256

/* Sets out_like[i] to the first part that part i is like, or to i. excluded: per part, 1 for one that is like no other.
 * The function looks only at parts that the body carries and that carry none. mesh: the object's, with the masks that
 * are inferred from. progress: gets no share, and is asked whether to stop. Memory comes from the arena. */
dm_result dmi_alike_parts_find(dmi_arena* arena, const dmi_mesh* mesh, const dmi_object* object,
                               const uint8_t* excluded, const dmi_progress* progress, uint32_t* out_like);

/* Gives a part the answers of the one that it is like, at its own place. */
void dmi_alike_part_copy(dmi_object* object, uint32_t from, uint32_t to);

/* ---- choice.c: lets the host choose among a part's hypotheses ---- */

/* Shows the hypotheses of part `index` to the host, and puts the one it chooses in force. The object must still have
 * its triangles. Does nothing for a part that the host has declared fixed. Errors: INDEX_OUT_OF_RANGE. */
dm_result dmi_choose_joint(dmi_env* env, dmi_object* object, const dmi_mesh* mesh, uint32_t index,
                           dm_choice_callback choose, void* user);

#endif
