/* Records the player's pull as pointer rays, and fits one joint to it: residuals, and the Gauss-Newton sums for the
 * place of its axis line. */
#ifndef DMI_DRAG_PULL_FIT_H
#define DMI_DRAG_PULL_FIT_H

#include <stdbool.h>

#include "drag/follow.h"

#define DMI_PULL_RAYS 8 /* recorded rays of a pull; by hand, for the time of an update */

/* The pointer as seen in the plane across the line of sight to the grabbed point. */
typedef struct dmi_seen_pointer {
    float sight[3];     /* unit direction to the grabbed point */
    float eye_distance; /* distance of the grabbed point from the eye; infinite for parallel rays */
    float way[3];       /* vector from the grabbed point to the pointer in that plane; zeros: it is behind the eye */
} dmi_seen_pointer;

/* The pull so far, as rays spaced evenly along its path. A pull that goes back over the same path, or round and round,
 * adds none. Lengths are host units at the depth of the grabbed point. */
typedef struct dmi_pull {
    dm_ray rays[DMI_PULL_RAYS];
    float places[DMI_PULL_RAYS][3]; /* closest point of each ray to the grabbed point */
    uint32_t count, thinned;        /* thinned: how often every second ray was dropped */
    float spacing;                  /* least distance between two places */
    float grab[3];                  /* the grabbed point at rest */
    float length;                   /* largest distance of the pointer from there */
    dmi_seen_pointer pointer;       /* the pointer of the newest ray, recorded or not */
    float bend;                     /* largest distance of a place from the straight way to the last one, as seen */
    dmi_projection projection;
} dmi_pull;

/* Computes the point of a ray's line closest to `point`. ray->direction must be unit. */
void dmi_ray_closest_point(const dm_ray* ray, const float point[3], float out[3]);

/* Starts an empty pull. The caller sets the projection of the rays. */
void dmi_pull_begin(dmi_pull* pull, const float grab_point[3], float spacing);
/* Adds a ray. It counts for the length, and is recorded where no other is near. ray->direction must be unit. */
void dmi_pull_add(dmi_pull* pull, const dm_ray* ray);
/* Returns the distance between a ray and a point as it is seen, scaled to the depth of the grabbed point. */
float dmi_pull_residual(const dmi_pull* pull, const dm_ray* ray, const float point[3]);

/* Returns whether the pointer lies, on the screen, on a chord from the grabbed point to a place on the joint's circle,
 * at most 140 degrees away. */
bool dmi_pull_is_on_chord(const dmi_pull* pull, const dm_joint* joint);

/* A joint that follows a recorded pull ray by ray, from rest on. The axis line of a turn may be shifted along two
 * directions across the axis: from the axis to the grabbed point, and a quarter turn from that. */
typedef struct dmi_pull_fit {
    dm_joint joint;
    float lower, upper;           /* range within which the joint follows */
    float size;                   /* size of the part, the unit of shifts */
    float outward[3], forward[3]; /* the two shift directions; zeros: none */
    float pointer_value;          /* joint value on the last ray */
    float max_residual;           /* largest residual so far */
    float gradient[2];            /* gradient of half the sum of squared residuals, by the shift */
    float hessian[3];             /* Gauss-Newton approximation of its second derivatives: 00, 01, 11 */
    uint32_t count;               /* rays followed */
} dmi_pull_fit;

/* Computes the shift directions. Returns false when the joint is a slide, or the point lies on its axis. */
bool dmi_pull_fit_shift_directions(const dm_joint* joint, const float grab_point[3], float out_outward[3],
                                   float out_forward[3]);
/* Follows the next recorded ray. */
void dmi_pull_fit_step(dmi_pull_fit* fit, const dmi_pull* pull);

#endif
