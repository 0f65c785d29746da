/* Free motion of a released part between its limits, with bounces: a fall, or a glide. Each step is exact, so that the
 * frame rate does not matter. */
#ifndef DMI_MOTION_DRAG_FLIGHT_H
#define DMI_MOTION_DRAG_FLIGHT_H

#include <stdbool.h>
#include <stdint.h>

typedef struct dmi_flight {
    float lower, upper;  /* limits, joint values */
    float acceleration;  /* joint value a second squared, signed; 0: glides */
    float time_constant; /* s, of the speed of a glide: e-fold */
    float restitution;   /* share of the speed that is left after a limit, 0 to 1 */
} dmi_flight;

/* What a step has done. */
typedef struct dmi_landing {
    int32_t struck; /* the limit struck last: -1, 0 for none, 1 */
    float impact;   /* speed of the hardest one, joint value a second */
    bool settled;   /* it does not move on */
} dmi_landing;

/* Advances value and velocity by dt seconds. */
dmi_landing dmi_flight_advance(const dmi_flight* flight, float dt, float* inout_value, float* inout_velocity);
/* Returns where a glide ends. */
float dmi_flight_end(const dmi_flight* flight, float value, float velocity);

#endif
