/* Goes from one limit to the next: the time until it is struck has a closed form, under constant acceleration and with
 * exponentially decaying speed. */
#include "motion/drag_flight.h"

#include <math.h>

#include "base/number_bounds.h"
#include "math/elementary.h"

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
