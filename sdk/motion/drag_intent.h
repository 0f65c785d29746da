/* What a released part is asked to do, by where it is and how fast it goes, and by its rules. */
#ifndef DMI_MOTION_DRAG_INTENT_H
#define DMI_MOTION_DRAG_INTENT_H

#include <stdbool.h>

#include "motion/drag_rules.h"

/* A part at the moment of its release. */
typedef struct dmi_released_part {
    const dm_joint* joint;
    const dm_drag_feel* feel;
    const dmi_rules* rules; /* rules of the part; NULL: it has none */
    float value, velocity;
    int32_t side; /* side on which a part that opens to both sides is to open: -1 or 1; 0: where it was pulled */
} dmi_released_part;

/* Returns the part's rules, or none. */
const dmi_rules* dmi_released_rules(const dmi_released_part* part);
/* Returns whether limits bound the part to both sides. */
bool dmi_released_has_range(const dmi_released_part* part);
/* Returns the joint value whose shares the thresholds are: the range, where the part has one. */
float dmi_released_unit(const dmi_released_part* part);
/* Returns the distance that exponentially decaying velocity covers. */
float dmi_released_glide(const dmi_released_part* part);
/* Returns whether a snap value catches the part as it glides to a stop. */
bool dmi_released_is_caught(const dmi_released_part* part, float* out_snap);
/* Returns whether the part glides against a limit that throws it back. */
bool dmi_released_is_thrown_back(const dmi_released_part* part);
/* Returns whether the part falls, to rest or to its open end. */
bool dmi_released_falls(const dmi_released_part* part);
/* Returns whether the part closes by itself from where it is. */
bool dmi_released_closes_itself(const dmi_released_part* part);
/* Returns the intent that DM_INTENT_AUTO stands for. */
int32_t dmi_released_intent(const dmi_released_part* part, float return_time);
/* Returns whether the part is more than half-way from rest to the end on its side. */
bool dmi_release_is_open(const dmi_released_part* part);
/* Returns the limit that is not rest; of two, the one on the side that the part was pulled to. */
float dmi_release_open_end(const dmi_released_part* part);

#endif
