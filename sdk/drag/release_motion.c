/* The motion along the plan of a release: minimum jerk, a generated motion's pace, a glide, or free flight from one
 * limit to the next. */
#include <math.h>
#include <string.h>

#include "drag/release.h"
#include "math/elementary.h"

/* The values are set by hand, with the releases of tests/unit/test_drag_release.c; docs/feel.md. */
#define SLOPE_STEP 1e-3f     /* share of the duration over which the slope of the plan at its start is measured */
#define SEARCH_STEPS 64      /* even steps over the keys … */
#define SEARCH_BISECTIONS 20 /* … and bisections of the step found */
#define MIN_PACE_SCALE 0.5f  /* keys that end this much farther than the plan do not suit it … */
#define MAX_PACE_SCALE 2.0f  /* … nor those that end this much nearer */

/* Minimum jerk from 0 to 1 (Flash and Hogan 1985). */
static float minimum_jerk(float s) {
    return s * s * s * (10 - 15 * s + 6 * s * s);
}

/* ---- pace of a generated motion ---- */

static float value_on_keys(const dmi_release* r, float t) {
    dmi_motion motion = {0};
    memcpy(motion.values, r->keys, sizeof motion.values);
    return dmi_motion_value(&motion, t);
}

/* Returns the time, 0 to 1, at which the keys first reach a value on their way outwards. */
static float time_on_keys(const dmi_release* r, float value) {
    const float outer = r->keys[DM_MOTION_FRAMES - 1];
    float low = 0, high = 1;
    for (int i = 1; i <= SEARCH_STEPS; i++) {
        high = (float)i / SEARCH_STEPS;
        if (value_on_keys(r, high) / outer >= value / outer) break;
        low = high;
    }
    for (int i = 0; i < SEARCH_BISECTIONS; i++) {
        const float middle = 0.5f * (low + high);
        if (value_on_keys(r, middle) / outer >= value / outer)
            high = middle;
        else
            low = middle;
    }
    return 0.5f * (low + high);
}

bool dmi_release_set_pace(dmi_release* r, const float values[DM_MOTION_FRAMES]) {
    const bool outwards = fabsf(r->end) > fabsf(r->start);
    const float outer = outwards ? r->end : r->start, inner = outwards ? r->start : r->end;
    const float last = values[DM_MOTION_FRAMES - 1], scale = outer / last;
    if (r->phase != DM_DRAG_RELEASED || r->glides || r->flies || !(scale > MIN_PACE_SCALE && scale < MAX_PACE_SCALE))
        return false;
    if (inner / outer < 0) return false; /* the plan crosses rest; generated motions begin there */
    for (int i = 0; i < DM_MOTION_FRAMES; i++) r->keys[i] = values[i] * scale;
    r->first = outwards ? time_on_keys(r, inner) : 1;
    r->last = outwards ? 1 : time_on_keys(r, inner);
    r->paced = r->first != r->last;
    return r->paced;
}

/* ---- motion to the end ---- */

/* Returns the planned value at a share of the duration, without regard to the initial velocity. */
static float planned_value(const dmi_release* r, float s) {
    if (!r->paced) return r->start + (r->end - r->start) * minimum_jerk(s);
    const float t = r->first + (r->last - r->first) * s;
    return value_on_keys(r, t);
}

/* Returns the plan plus what value and velocity differ from it at the start, fading. The function s (1 - s)^3 has slope
 * 1 at 0, and (1 + 3 s) (1 - s)^3 has value 1 and slope 0 there. */
static float move_at(const dmi_release* r, float s) {
    const float h = SLOPE_STEP, left = 1 - s, fade = left * left * left;
    const float off = r->start - planned_value(r, 0), slope = (planned_value(r, h) - planned_value(r, 0)) / h;
    const float speed = r->velocity * r->duration - slope;
    return planned_value(r, s) + fade * ((1 + 3 * s) * off + s * speed);
}

static float glide_at(const dmi_release* r, const dm_drag_feel* feel) {
    const float time_constant = dmi_feel_coast_time(feel) / DMI_LN_2_F;
    return r->start + r->velocity * time_constant * (1 - dmi_expf(-r->elapsed / time_constant));
}

void dmi_release_advance(dmi_release* r, const dm_drag_feel* feel, const dm_joint* joint, float dt, float* out_value,
                         float* out_velocity) {
    const float old = *out_value;
    r->elapsed = dmi_fminf(r->elapsed + dt, DMI_LARGEST_TIME);
    if (r->elapsed >= r->duration) {
        *out_value = r->end, *out_velocity = 0;
        r->phase = DM_DRAG_AT_REST;
        return;
    }
    const float value = r->glides ? glide_at(r, feel) : move_at(r, r->elapsed / r->duration);
    *out_value = dmi_joint_clamp(joint, value);
    if (dt > 0) *out_velocity = (*out_value - old) / dt;
}

/* ---- free flight: the time until a limit is struck has a closed form, under constant acceleration and with
 * exponentially decaying speed ---- */

#define MAX_BOUNCES 16        /* bounces of one step; after them the part stays at the limit; by hand */
#define SETTLED_SHARE 0.002f  /* share of the range; a bounce that does not rise higher counts as none; by hand */
#define STANDING_SHARE 0.002f /* share of the range; a glide that has no farther to go stands; by hand */

/* A part on its way to one limit: distance to it, and speed towards it. */
typedef struct approach {
    float distance, speed;
} approach;

/* Returns the time until a limit is struck; infinite when it is not. pull: acceleration towards it. */
static float time_to_strike(const dmi_flight* flight, approach to, float pull) {
    if (flight->acceleration == 0) { /* distance = speed * time_constant * (1 - exp(-t / time_constant)) */
        const float reach = to.speed * flight->time_constant;
        return reach > to.distance ? -flight->time_constant * dmi_logf(1 - to.distance / reach) : INFINITY;
    }
    const float square = to.speed * to.speed + 2 * pull * to.distance;
    if (square < 0 || (pull < 0 && to.speed <= 0)) return INFINITY;
    /* The smaller root that is not negative, in the form that loses no digits. */
    if (to.speed < 0) return (sqrtf(square) - to.speed) / pull;
    return to.distance > 0 ? 2 * to.distance / (to.speed + sqrtf(square)) : 0;
}

static void move_freely(const dmi_flight* flight, float time, float* value, float* velocity) {
    if (flight->acceleration != 0) {
        *value += (*velocity + 0.5f * flight->acceleration * time) * time;
        *velocity += flight->acceleration * time;
        return;
    }
    const float kept = dmi_expf(-time / flight->time_constant);
    *value += *velocity * flight->time_constant * (1 - kept);
    *velocity *= kept;
}

/* Returns whether a part that leaves a limit at this speed comes to rest there. */
static bool settles_at_limit(const dmi_flight* flight, int32_t side, float speed) {
    const float range = flight->upper - flight->lower, pull = flight->acceleration * (float)side;
    if (flight->acceleration != 0) return pull > 0 && speed * speed < 2 * pull * SETTLED_SHARE * range;
    return speed * flight->time_constant < STANDING_SHARE * range;
}

static void strike_limit(const dmi_flight* flight, int32_t side, dmi_landing* landing, float* value, float* velocity) {
    const float speed = fabsf(*velocity), back = flight->restitution * speed;
    landing->struck = side;
    landing->impact = dmi_fminf(dmi_fmaxf(landing->impact, speed), DMI_LARGEST_RATE);
    landing->settled = settles_at_limit(flight, side, back);
    *value = side > 0 ? flight->upper : flight->lower;
    *velocity = landing->settled ? 0 : -(float)side * back;
}

dmi_landing dmi_flight_advance(const dmi_flight* flight, float dt, float* inout_value, float* inout_velocity) {
    dmi_landing landing = {0};
    float left = dt;
    for (int i = 0; i < MAX_BOUNCES && !landing.settled; i++) {
        const approach up = {dmi_fmaxf(flight->upper - *inout_value, 0), *inout_velocity},
                       down = {dmi_fmaxf(*inout_value - flight->lower, 0), -*inout_velocity};
        const float to_upper = time_to_strike(flight, up, flight->acceleration);
        const float to_lower = time_to_strike(flight, down, -flight->acceleration);
        const float time = dmi_fminf(to_upper, to_lower);
        move_freely(flight, dmi_fminf(time, left), inout_value, inout_velocity);
        if (!(time <= left)) {
            landing.settled = flight->acceleration == 0 && settles_at_limit(flight, 0, fabsf(*inout_velocity));
            return landing;
        }
        left -= time;
        strike_limit(flight, to_upper < to_lower ? 1 : -1, &landing, inout_value, inout_velocity);
    }
    landing.settled = true;
    *inout_velocity = 0;
    return landing;
}

float dmi_flight_end(const dmi_flight* flight, float value, float velocity) {
    for (int i = 0; i < MAX_BOUNCES; i++) {
        const float end = value + velocity * flight->time_constant;
        if (end >= flight->lower && end <= flight->upper) return end;
        const float limit = end > flight->upper ? flight->upper : flight->lower;
        /* The speed that is left when it reaches the limit, after the bounce. */
        velocity = -flight->restitution * (end - limit) / flight->time_constant;
        value = limit;
    }
    return value;
}
