/* Embree called directly, as a host would: what our picks are measured against. */
#ifndef BARE_EMBREE_H
#define BARE_EMBREE_H

#if defined(__has_include) && __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include "support.h"

#define BARE_EMBREE_ALL 0xffffffffu /* parts */

/* A tree of the faces of one part, or of all, on the mesh's own numbers. */
RTCScene bare_embree_part(RTCDevice device, const bench_mesh* mesh, uint32_t part, enum RTCSceneFlags flags);
/* `count` copies of body and doors as instances, as any game that moves the doors must have them, shifted by the xyz of
 * `places`; NULL: none is. */
RTCScene bare_embree_instances(RTCDevice device, const bench_mesh* mesh, uint32_t count, const float* places,
                               enum RTCSceneFlags flags);
/* Whether a ray hits anything: the nearest hit is found. */
int bare_embree_hits(RTCScene scene, const float origin[3], const float direction[3]);

#endif
