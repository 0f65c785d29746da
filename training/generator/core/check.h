/* Declares checks on generated objects: whether a part, moving as its joint says, runs into the body or comes off
 * it. */
#ifndef DMG_CHECK_H
#define DMG_CHECK_H

#include "generator.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The worst over the whole way from the lower to the upper limit, in fractions of the object's largest side. */
typedef struct dmg_finding {
    float depth;       /* how much deeper a surface point gets into the body than any is at rest */
    float depth_value; /* the joint value there */
    float size;        /* of the object: its largest side */
    float gap;         /* how much farther the part is from all that does not move with it than it is at rest */
} dmg_finding;

/* Part ids from 1, carried parts move along. Closed, outward-facing shells only: clean objects, not messy ones.
 * 0 on success. */
int dmg_check(const dmg_object* object, uint32_t part, dmg_finding* out);

#ifdef __cplusplus
}
#endif

#endif
