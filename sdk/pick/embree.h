/* Embree 3.13 (Debian 12) and 4.x (Debian 13) behind one call: 4 has no context in the intersect call. */
#ifndef DMI_PICK_EMBREE_H
#define DMI_PICK_EMBREE_H

#if defined(__has_include) && __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

/* Nearest hit of the ray; hit->hit.geomID is RTC_INVALID_GEOMETRY_ID where there is none. */
static inline void dmi_embree_intersect(RTCScene scene, struct RTCRayHit* hit) {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, hit, NULL);
#else
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, hit);
#endif
}

/* A ray from `origin` along `direction`, up to `far`, that has hit nothing yet. */
static inline struct RTCRayHit dmi_embree_ray(const float origin[3], const float direction[3], float far) {
    return (struct RTCRayHit){
        .ray = {.org_x = origin[0],
                .org_y = origin[1],
                .org_z = origin[2],
                .dir_x = direction[0],
                .dir_y = direction[1],
                .dir_z = direction[2],
                .tfar = far,
                .mask = 0xffffffffu},
        .hit = {.geomID = RTC_INVALID_GEOMETRY_ID,
                .primID = RTC_INVALID_GEOMETRY_ID,
                .instID = {RTC_INVALID_GEOMETRY_ID}},
    };
}

#endif
