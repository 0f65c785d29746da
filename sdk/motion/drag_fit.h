/* What a pull says of one joint: how far the joint misses it, and where its line would have to be to miss it less.
 */
#ifndef DMI_MOTION_DRAG_FIT_H
#define DMI_MOTION_DRAG_FIT_H

#include <stdbool.h>

#include "motion/follow.h"

#define DMI_PULL_RAYS 8

/* The pull as far as it has come, as rays spaced evenly along its way. One that goes back over its own way, or round
 * and round, adds none. */
typedef struct dmi_pull {
    dm_ray rays[DMI_PULL_RAYS];
    float places[DMI_PULL_RAYS][3]; /* where each passes the grabbed point most closely */
    uint32_t count, thinned;        /* how often every second ray was dropped */
    float spacing;
    float grab[3]; /* where the part was taken hold of, at rest */
    float length;  /* how far the pointer went from there, at its depth, at most */
    dm_vec3 sight; /* the direction of the last ray */
    float now[3];  /* where the pointer is, at that depth */
    float bend;    /* how far the way is from straight, at most: of its places, from the line to the last */
    dmi_projection projection;
} dmi_pull;

/* Where a ray passes a point most closely. ray->direction must be unit. */
void dmi_ray_passing(const dm_ray* ray, const float point[3], float out[3]);

/* Nothing yet. The projection of the rays is the caller's to set. */
void dmi_pull_begin(dmi_pull* pull, const float grab_point[3], float spacing);
/* A ray that counts for the length, and is remembered where no other is near. ray->direction must be unit. */
void dmi_pull_add(dmi_pull* pull, const dm_ray* ray);
/* How far apart a ray and a point look, as a length where the grabbed point was at the start. */
float dmi_pull_miss(const dmi_pull* pull, const dm_ray* ray, const float point[3]);

/* Whether the pointer is on the straight way from the grabbed point to some place on its circle, at most a third of a
 * turn from rest, and not beyond it. */
bool dmi_pull_cuts_corner(const dmi_pull* pull, const dm_joint* joint);

/* What a joint makes of a pull, ray after ray from rest on. A turn's line may be shifted across its axis: away from the
 * grabbed point's foot on it to the point, and a quarter turn from that; both in lengths of the part. */
typedef struct dmi_fit {
    dm_joint joint;
    float lower, upper;           /* to follow within */
    float size;                   /* of the part */
    float outward[3], forward[3]; /* the two ways to shift; zeros: none */
    float reach;                  /* on the last ray */
    float worst;                  /* how far it missed a ray, at most */
    float slope[2], curvature[3]; /* of half the squares by the shift; curvature 00, 01, 11 */
    uint32_t count;               /* rays followed */
} dmi_fit;

/* The ways to shift the line; 0: the joint has none, or the point lies on it. */
bool dmi_fit_ways(const dm_joint* joint, const float grab_point[3], float out_outward[3], float out_forward[3]);
/* One ray more, the next that the pull has. */
void dmi_fit_follow(dmi_fit* fit, const dmi_pull* pull);

#endif
