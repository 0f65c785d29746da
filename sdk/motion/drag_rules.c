/* Defaults of dm_drag_rules. */
#include "motion/drag_rules.h"

#include <math.h>

#include "math/elementary.h"

/* The values are set by hand, and documented at dm_drag_rules. */
#define DEFAULT_OPEN_SHARE 0.1f    /* share of the range */
#define DEFAULT_CLOSED_SHARE 0.02f /* share of the range */
#define DEFAULT_LOCK_GIVE 0.01f    /* share of the range */
#define DEFAULT_LATCH_TURN 0.785f  /* rad: 45 degrees */
#define DEFAULT_AUTO_CLOSE 0.25f   /* s */
#define DEFAULT_FALL_TIME 0.7f     /* s, as long as a planned motion over the whole range */
#define OUTER_REACH 0.05f          /* share of the range that an outermost snap value reaches */

float dmi_rules_range(const dmi_rules* rules, const dm_joint* joint) {
    if (dmi_joint_has_limits(joint) && !rules->one_sided) return joint->upper - joint->lower;
    return dmi_joint_turns(joint->type) ? 1 : rules->object_size;
}

float dmi_rules_share(const dmi_rules* rules, const dm_joint* joint, float value) {
    return fabsf(value - dmi_joint_closed(joint)) / dmi_rules_range(rules, joint);
}

float dmi_rules_share_from_rest(const dmi_rules* rules, const dm_joint* joint, float value) {
    return fabsf(value - dmi_joint_clamp(joint, 0)) / dmi_rules_range(rules, joint);
}

/* Returns `given`, or the default when it is 0. */
static float given_or(float given, float otherwise) {
    return given != 0 ? given : otherwise;
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
                       .flags = given->flags,
                       .one_sided = one_sided,
                       .object_size = object_size,
                       .open_share = given_or(given->open_share, DEFAULT_OPEN_SHARE),
                       .closed_share = given_or(given->closed_share, DEFAULT_CLOSED_SHARE),
                       .event_time = given->event_time,
                       .max_speed = given->max_speed,
                       .max_acceleration = given->max_acceleration,
                       .lock_give = dmi_fmaxf(given_or(given->lock_give, DEFAULT_LOCK_GIVE), 0),
                       .latch_turn = given_or(given->latch_turn, DEFAULT_LATCH_TURN),
                       .auto_close_share = given->auto_close_share,
                       .auto_close_time = given_or(given->auto_close_time, DEFAULT_AUTO_CLOSE),
                       .close_delay = given->close_delay,
                       .tip_share = given->tip_share,
                       .fall_time = given_or(given->fall_time, DEFAULT_FALL_TIME),
                       .restitution = given->restitution,
                       .break_distance = given->break_distance,
                       .drive_speed = given_or(given->drive_speed, 1)};
    rules.snaps = snaps_from(given, dmi_feel_detent_pull(feel), dmi_rules_range(&rules, joint));
    return rules;
}
