/* Defaults of dm_drag_rules. */
#include "motion/drag_rules.h"

#include <math.h>

/* By hand; documented at dm_drag_rules. */
#define DEFAULT_OPEN_SHARE 0.1f    /* of the range */
#define DEFAULT_CLOSED_SHARE 0.02f /* of the range */
#define OUTER_REACH 0.05f          /* of the range: how far an outermost snap value reaches */

float dmi_rules_range(const dmi_rules* rules, const dm_joint* joint) {
    if (dmi_joint_has_limits(joint) && !rules->one_sided) return joint->upper - joint->lower;
    return dmi_joint_turns(joint->type) ? 1 : rules->object_size;
}

static dmi_snaps snaps_from(const dm_drag_rules* given, float pull, float range) {
    dmi_snaps snaps = {.count = given->snap_count, .reach = given->snap_reach, .pull = pull};
    for (uint32_t i = 0; i < snaps.count; i++) snaps.values[i] = given->snaps[i];
    snaps.outer_reach = snaps.reach > 0 ? snaps.reach : OUTER_REACH * range;
    return snaps;
}

dmi_rules dmi_rules_from(const dm_drag_rules* given, const dm_drag_feel* feel, const dm_joint* joint, bool one_sided,
                         float object_size) {
    dmi_rules rules = {.on = true,
                       .one_sided = one_sided,
                       .object_size = object_size,
                       .open_share = given->open_share > 0 ? given->open_share : DEFAULT_OPEN_SHARE,
                       .closed_share = given->closed_share > 0 ? given->closed_share : DEFAULT_CLOSED_SHARE,
                       .event_time = given->event_time,
                       .max_speed = given->max_speed,
                       .max_acceleration = given->max_acceleration};
    rules.snaps = snaps_from(given, dmi_feel_detent_pull(feel), dmi_rules_range(&rules, joint));
    return rules;
}
