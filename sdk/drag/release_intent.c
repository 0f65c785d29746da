/* Reads the player's intent from value and velocity at the release. */
#include "drag/release.h"

#include <math.h>

#include "math/elementary.h"

/* The values are set by hand, with the releases of tests/unit/test_drag_release.c; docs/feel.md. */
#define LOOK_AHEAD 0.2f /* s: the part is taken to be where its velocity carries it in this time */
/* Share of the range travelled in LOOK_AHEAD; a part that goes farther was thrown, not just let go. */
#define THROWN_SHARE 0.35f
#define NEAR_END_SHARE 0.12f /* share of the range; a part this near is as good as at the end */
#define HALF_WAY 0.5f        /* share of the way to an open end; a part beyond it is open */
#define AT_STOP_SHARE 0.05f  /* share of the range; a closed place this near to a limit is the same as the limit */

static float range_of(const dm_joint* joint) {
    return joint->upper - joint->lower;
}

const dmi_rules* dmi_released_rules(const dmi_released_part* part) {
    static const dmi_rules none = {0};
    return part->rules != NULL ? part->rules : &none;
}

bool dmi_released_has_range(const dmi_released_part* part) {
    return dmi_joint_has_limits(part->joint) && !dmi_released_rules(part)->one_sided;
}

float dmi_released_unit(const dmi_released_part* part) {
    return dmi_joint_has_limits(part->joint) ? dmi_rules_range(dmi_released_rules(part), part->joint) : 1;
}

static bool closes_at_stop(const dm_joint* joint) {
    const float near = AT_STOP_SHARE * range_of(joint), closed = dmi_joint_closed(joint);
    return closed - joint->lower <= near || joint->upper - closed <= near;
}

float dmi_release_open_end(const dmi_released_part* part) {
    const dm_joint* joint = part->joint;
    const float closed = dmi_joint_closed(joint), pulled = part->value + LOOK_AHEAD * part->velocity - closed;
    const float side = part->side != 0 ? (float)part->side : pulled;
    if (side == 0 || closes_at_stop(joint)) return dmi_joint_opened(joint);
    return side > 0 ? joint->upper : joint->lower;
}

bool dmi_release_is_open(const dmi_released_part* part) {
    const dm_joint* joint = part->joint;
    const float closed = dmi_joint_closed(joint), below = closed - joint->lower, above = joint->upper - closed;
    const bool both_sides = !closes_at_stop(joint);
    if (!dmi_released_has_range(part)) return fabsf(part->value - closed) > HALF_WAY * dmi_released_unit(part);
    const float way = both_sides ? (part->value < closed ? below : above) : dmi_fmaxf(below, above);
    return fabsf(part->value - closed) > HALF_WAY * way;
}

float dmi_released_glide(const dmi_released_part* part) {
    return part->velocity * dmi_feel_coast_time(part->feel) / DMI_LN_2_F;
}

bool dmi_released_is_caught(const dmi_released_part* part, float* out_snap) {
    const float end = dmi_joint_clamp(part->joint, part->value + dmi_released_glide(part));
    return dmi_snaps_catch(&dmi_released_rules(part)->snaps, part->joint, end, out_snap);
}

bool dmi_released_is_thrown_back(const dmi_released_part* part) {
    const float end = part->value + dmi_released_glide(part);
    float snap;
    return dmi_released_rules(part)->restitution > 0 && dmi_released_has_range(part) &&
           dmi_joint_clamp(part->joint, end) != end && !dmi_released_is_caught(part, &snap);
}

bool dmi_released_falls(const dmi_released_part* part) {
    return dmi_released_rules(part)->tip_share > 0 && dmi_released_has_range(part);
}

bool dmi_released_closes_itself(const dmi_released_part* part) {
    return dmi_rules_share(dmi_released_rules(part), part->joint, part->value) <
           dmi_released_rules(part)->auto_close_share;
}

/* Returns the intent by the part's rules, or DM_INTENT_AUTO when they decide nothing. */
static int32_t intent_by_rules(const dmi_released_part* part, float return_time) {
    const dmi_rules* rules = dmi_released_rules(part);
    float snap;
    if (!rules->on) return DM_INTENT_AUTO;
    if (return_time > 0 && rules->close_delay > 0) return DM_INTENT_STAY;
    if (return_time > 0) return DM_INTENT_CLOSE;
    if (dmi_released_closes_itself(part)) return DM_INTENT_CLOSE;
    if (dmi_released_is_caught(part, &snap)) return DM_INTENT_STAY;
    if (dmi_released_falls(part))
        return dmi_rules_share(rules, part->joint, part->value) < rules->tip_share ? DM_INTENT_CLOSE : DM_INTENT_OPEN;
    return dmi_released_is_thrown_back(part) ? DM_INTENT_STAY : DM_INTENT_AUTO;
}

int32_t dmi_released_intent(const dmi_released_part* part, float return_time) {
    const dm_joint* joint = part->joint;
    const int32_t ruled = intent_by_rules(part, return_time);
    if (ruled != DM_INTENT_AUTO) return ruled;
    if (return_time > 0) return DM_INTENT_CLOSE;
    if (!dmi_released_has_range(part) || part->feel->detent > 0) return DM_INTENT_STAY;
    const float range = range_of(joint), thrown = LOOK_AHEAD * part->velocity, ahead = part->value + thrown;
    const float off = fabsf(ahead - dmi_joint_closed(joint));
    const bool homeward = part->velocity * (dmi_joint_closed(joint) - part->value) >= 0;
    if (closes_at_stop(joint) && (off < NEAR_END_SHARE * range || dmi_joint_clamp(joint, ahead) != ahead) && homeward) {
        return DM_INTENT_CLOSE;
    }
    if (closes_at_stop(joint) && homeward && fabsf(thrown) > THROWN_SHARE * range) return DM_INTENT_CLOSE;
    if (fabsf(thrown) > THROWN_SHARE * range) return DM_INTENT_OPEN;
    if (fabsf(ahead - dmi_release_open_end(part)) < NEAR_END_SHARE * range) return DM_INTENT_OPEN;
    return DM_INTENT_STAY;
}
