/* Release: the intent from where the part is and how fast it goes, then one smooth way from there to the end. */
#include "motion/drag_release.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "motion/drag.h"

#define THROW_TIME 0.2f   /* s: how far ahead of its speed a part is seen to be going */
#define THROWN 0.35f      /* of the range, ahead: no mere letting go */
#define NEAR_END 0.12f    /* of the range, ahead: as good as there */
#define AT_STOP 0.05f     /* of the range: rest and a limit are the same */
#define ARRIVED 1e-4f     /* of the range */
#define LEAST_TIME 0.18f  /* s */
#define WHOLE_TIME 0.7f   /* s over the whole range */
#define COAST_HALVES 7.0f /* after so many half-lives a free part stands */
#define BACKWARDS 0.105f  /* most of s (1 - s)^3 */
#define FIND_STEPS 64     /* of a place on the keys */

static float pace(float s) {
    return s * s * s * (10 - 15 * s + 6 * s * s); /* minimum jerk: Flash and Hogan 1985 */
}

/* ---- what is meant ---- */

static float range_of(const dm_joint* joint) {
    return joint->upper - joint->lower;
}

static bool rests_at_stop(const dm_joint* joint) {
    const float near = AT_STOP * range_of(joint), rest = dmi_joint_clamp(joint, 0);
    return rest - joint->lower <= near || joint->upper - rest <= near;
}

/* The limit that is not rest; of two, the one on the side that the part was pulled to. */
static float open_end(const dmi_drag* drag) {
    const dm_joint* joint = &drag->joint;
    const float rest = dmi_joint_clamp(joint, 0), side = drag->value + THROW_TIME * drag->velocity - rest;
    if (side == 0 || rests_at_stop(joint))
        return joint->upper - rest >= rest - joint->lower ? joint->upper : joint->lower;
    return side > 0 ? joint->upper : joint->lower;
}

/* What the player meant. */
static int32_t read_intent(const dmi_drag* drag) {
    const dm_joint* joint = &drag->joint;
    if (drag->release.return_time > 0) return DM_INTENT_CLOSE;
    if (!dmi_joint_has_limits(joint) || drag->feel.detent > 0) return DM_INTENT_STAY;
    const float range = range_of(joint), thrown = THROW_TIME * drag->velocity, ahead = drag->value + thrown;
    const float from_rest = fabsf(ahead - dmi_joint_clamp(joint, 0));
    const bool homeward = drag->velocity * (dmi_joint_clamp(joint, 0) - drag->value) >= 0;
    if (rests_at_stop(joint) && (from_rest < NEAR_END * range || dmi_joint_clamp(joint, ahead) != ahead) && homeward) {
        return DM_INTENT_CLOSE;
    }
    if (rests_at_stop(joint) && homeward && fabsf(thrown) > THROWN * range) return DM_INTENT_CLOSE;
    if (fabsf(thrown) > THROWN * range) return DM_INTENT_OPEN;
    if (fabsf(ahead - open_end(drag)) < NEAR_END * range) return DM_INTENT_OPEN;
    return DM_INTENT_STAY;
}

/* ---- the plan ---- */

/* How long a part that starts at its speed takes to an end, neither crawling nor shooting past. */
static float natural_time(const dmi_drag* drag, float way) {
    const float speed = fabsf(drag->velocity), range = range_of(&drag->joint);
    const float share = dmi_joint_has_limits(&drag->joint) ? fminf(fabsf(way) / range, 1) : 1;
    float time = WHOLE_TIME * sqrtf(share);
    if (drag->velocity * way > 0) time = fminf(time, 2 * fabsf(way) / speed);
    return fmaxf(time, LEAST_TIME);
}

static float glide_length(const dmi_drag* drag) {
    return drag->velocity * dmi_feel_coast_time(&drag->feel) / DMI_LN_2;
}

/* Gliding ends where the glide does, or at a limit; catches draw it on to the next one. */
static void plan_stay(dmi_drag* drag, dmi_release* r) {
    const float end = dmi_joint_clamp(&drag->joint, drag->value + glide_length(drag));
    r->end = dmi_feel_catch(&drag->feel, &drag->joint, end);
    r->duration = COAST_HALVES * dmi_feel_coast_time(&drag->feel);
    r->glides = r->end == end;
    if (!r->glides) r->duration = natural_time(drag, r->end - r->start);
    const float way = fabsf(r->end - r->start);
    if (way <= ARRIVED * (dmi_joint_has_limits(&drag->joint) ? range_of(&drag->joint) : 1)) r->duration = 0;
}

/* Going back first, a part gets no farther than BACKWARDS of its speed times the duration: what would take it into the
 * stop behind it is lost at once. */
static float speed_with_room(const dmi_drag* drag, const dmi_release* r) {
    const float way = r->end - r->start, u = r->velocity;
    if (u * way >= 0) return u;
    const float room = u > 0 ? drag->joint.upper - r->start : r->start - drag->joint.lower;
    return copysignf(fminf(fabsf(u), fmaxf(room, 0) / (BACKWARDS * r->duration)), u);
}

static void plan_move(dmi_drag* drag, dmi_release* r, float end) {
    const float way = end - r->start;
    r->end = end;
    r->duration = r->return_time > 0 && r->intent == DM_INTENT_CLOSE ? r->return_time : natural_time(drag, way);
    if (fabsf(way) <= ARRIVED * fmaxf(range_of(&drag->joint), 0)) r->duration = 0;
}

void dmi_drag_release(dmi_drag* drag, int32_t intent, float duration) {
    dmi_release* r = &drag->release;
    r->elapsed = 0;
    r->phase = DM_DRAG_RELEASED;
    if (intent == DM_INTENT_REPLAY) return;
    const int32_t asked = intent == DM_INTENT_AUTO ? read_intent(drag) : intent;
    r->intent = asked;
    r->start = r->end = drag->value;
    r->velocity = drag->velocity;
    r->paced = r->glides = 0;
    r->duration = 0;
    const bool free = !dmi_joint_has_limits(&drag->joint);
    if (asked == DM_INTENT_CLOSE)
        plan_move(drag, r, dmi_joint_clamp(&drag->joint, 0));
    else if (asked == DM_INTENT_OPEN && !free)
        plan_move(drag, r, open_end(drag));
    else if (asked != DM_INTENT_FREEZE)
        r->intent = DM_INTENT_STAY, plan_stay(drag, r);
    if (duration > 0 && r->duration > 0) r->duration = duration;
    if (!r->glides && r->duration > 0 && !free) r->velocity = speed_with_room(drag, r);
    if (r->duration > 0) return;
    r->velocity = drag->velocity = 0;
    r->phase = DM_DRAG_AT_REST;
}

/* ---- the network's pace ---- */

static float on_keys(const dmi_release* r, float t) {
    dmi_motion motion = {0};
    memcpy(motion.values, r->keys, sizeof motion.values);
    return dmi_motion_value(&motion, t);
}

/* Where the keys first reach a value, outwards. */
static float find_on_keys(const dmi_release* r, float value) {
    const float outer = r->keys[DM_MOTION_FRAMES - 1];
    float low = 0, high = 1;
    for (int i = 1; i <= FIND_STEPS; i++) {
        high = (float)i / FIND_STEPS;
        if (on_keys(r, high) / outer >= value / outer) break;
        low = high;
    }
    for (int i = 0; i < 20; i++) {
        const float middle = 0.5f * (low + high);
        if (on_keys(r, middle) / outer >= value / outer)
            high = middle;
        else
            low = middle;
    }
    return 0.5f * (low + high);
}

bool dmi_drag_set_pace(dmi_drag* drag, const float values[DM_MOTION_FRAMES]) {
    dmi_release* r = &drag->release;
    const bool outwards = fabsf(r->end) > fabsf(r->start);
    const float outer = outwards ? r->end : r->start, inner = outwards ? r->start : r->end;
    const float last = values[DM_MOTION_FRAMES - 1], scale = outer / last;
    if (r->phase != DM_DRAG_RELEASED || r->glides || !(scale > 0.5f && scale < 2)) return false;
    if (inner / outer < 0) return false; /* across rest: such a motion is none of the network's */
    for (int i = 0; i < DM_MOTION_FRAMES; i++) r->keys[i] = values[i] * scale;
    r->first = outwards ? find_on_keys(r, inner) : 1;
    r->last = outwards ? 1 : find_on_keys(r, inner);
    r->paced = r->first != r->last;
    return r->paced;
}

/* ---- on the way ---- */

/* The way without regard to the speed it starts with. */
static float planned(const dmi_release* r, float s) {
    if (!r->paced) return r->start + (r->end - r->start) * pace(s);
    const float t = r->first + (r->last - r->first) * s;
    return on_keys(r, t);
}

/* The planned way, and what differs from it at the start, place and speed, fading: s (1 - s)^3 has slope 1 at 0 and
 * comes down smoothly. */
static float way_at(const dmi_release* r, float s) {
    const float h = 1e-3f, left = 1 - s, fade = left * left * left;
    const float off = r->start - planned(r, 0), slope = (planned(r, h) - planned(r, 0)) / h;
    const float speed = r->velocity * r->duration - slope;
    return planned(r, s) + fade * ((1 + 3 * s) * off + s * speed);
}

static float glide_at(const dmi_release* r, const dm_drag_feel* feel) {
    const float coast = dmi_feel_coast_time(feel) / DMI_LN_2;
    return r->start + r->velocity * coast * (1 - expf(-r->elapsed / coast));
}

void dmi_release_advance(dmi_release* r, const dm_drag_feel* feel, const dm_joint* joint, float dt, float* out_value,
                         float* out_velocity) {
    const float old = *out_value;
    r->elapsed += dt;
    if (r->elapsed >= r->duration) {
        *out_value = r->end, *out_velocity = 0;
        r->phase = DM_DRAG_AT_REST;
        return;
    }
    const float value = r->glides ? glide_at(r, feel) : way_at(r, r->elapsed / r->duration);
    *out_value = dmi_joint_clamp(joint, value);
    const float velocity = (*out_value - old) / dt;
    if (dt > 0 && isfinite(velocity)) *out_velocity = velocity;
}
