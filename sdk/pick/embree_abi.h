/* The part of Embree's binary interface that picking uses, in words of our own, so that one binary drives versions 3.13
 * and 4 and builds without either. */
#ifndef DMI_PICK_EMBREE_ABI_H
#define DMI_PICK_EMBREE_ABI_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

#define EMBREE_NO_ID 0xffffffffu
#define EMBREE_ALL_RAYS 0xffffffffu /* mask */

/* Enumerations, the same in both versions. */
enum {
    EMBREE_TRIANGLES = 0, /* type of geometry */
    EMBREE_INDICES = 0,   /* buffers */
    EMBREE_VERTICES = 1,
    EMBREE_UINT3 = 0x5003, /* formats */
    EMBREE_FLOAT3 = 0x9003,
    EMBREE_ROBUST = 4,  /* flag of scenes: no ray slips between two triangles that share an edge */
    EMBREE_VERSION = 0, /* property of a device: major * 10000 + minor * 100 + patch */
    EMBREE_VERSION_MAJOR = 10000
};

enum {
    EMBREE_ERROR_NONE = 0,
    EMBREE_ERROR_UNKNOWN = 1,
    EMBREE_ERROR_INVALID_ARGUMENT = 2,
    EMBREE_ERROR_INVALID_OPERATION = 3,
    EMBREE_ERROR_OUT_OF_MEMORY = 4,
    EMBREE_ERROR_UNSUPPORTED_CPU = 5,
    EMBREE_ERROR_CANCELLED = 6
};

/* RTCRayHit. Version 4 writes one id more behind `instance`; how many levels of instances there are is a choice of who
 * built Embree. The room at the end bears all of them. */
typedef struct embree_ray_hit {
    _Alignas(16) float origin[3];
    float near, direction[3], time, far;
    uint32_t mask, id, flags;
    float normal[3], u, v;
    uint32_t primitive, geometry, instance[15];
} embree_ray_hit;

/* RTCIntersectContext of version 3, with the same room. Zeros will do for every build of it: where there are several
 * levels of instances, their number comes first. */
typedef struct embree_context3 {
    int32_t flags;
    void* filter;
    uint32_t instance[16];
} embree_context3;

typedef struct embree_device* embree_device;
typedef struct embree_scene* embree_scene;
typedef struct embree_geometry* embree_geometry;
typedef void (*embree_error_function)(void* user, int32_t code, const char* text);
typedef bool (*embree_memory_function)(void* user, ssize_t bytes, bool post);
typedef bool (*embree_progress_function)(void* user, double share);

/* X(result, name, parameters): the functions, called rtc… in the library. */
#define EMBREE_FUNCTIONS(X)                                                                                            \
    X(embree_device, NewDevice, (const char* config))                                                                  \
    X(void, ReleaseDevice, (embree_device device))                                                                     \
    X(ssize_t, GetDeviceProperty, (embree_device device, int32_t property))                                            \
    X(int32_t, GetDeviceError, (embree_device device))                                                                 \
    X(void, SetDeviceErrorFunction, (embree_device device, embree_error_function function, void* user))                \
    X(void, SetDeviceMemoryMonitorFunction, (embree_device device, embree_memory_function function, void* user))       \
    X(embree_geometry, NewGeometry, (embree_device device, int32_t type))                                              \
    X(void, SetSharedGeometryBuffer,                                                                                   \
      (embree_geometry geometry, int32_t buffer, uint32_t slot, int32_t format, const void* data, size_t offset,       \
       size_t stride, size_t count))                                                                                   \
    X(void, CommitGeometry, (embree_geometry geometry))                                                                \
    X(void, ReleaseGeometry, (embree_geometry geometry))                                                               \
    X(embree_scene, NewScene, (embree_device device))                                                                  \
    X(void, SetSceneFlags, (embree_scene scene, int32_t flags))                                                        \
    X(uint32_t, AttachGeometry, (embree_scene scene, embree_geometry geometry))                                        \
    X(void, SetSceneProgressMonitorFunction, (embree_scene scene, embree_progress_function function, void* user))      \
    X(void, JoinCommitScene, (embree_scene scene))                                                                     \
    X(void, ReleaseScene, (embree_scene scene))

/* Where the two versions differ: 3 takes a context before the ray, 4 arguments after it, which may be NULL. */
typedef void embree3_intersect(embree_scene scene, embree_context3* context, embree_ray_hit* ray);
typedef void embree4_intersect(embree_scene scene, embree_ray_hit* ray, void* arguments);

/* NOLINTNEXTLINE(bugprone-macro-parentheses): the parts of a declaration take none */
#define EMBREE_POINTER(result, name, parameters) result(*name) parameters;
typedef struct embree_library {
    void* handle;
    EMBREE_FUNCTIONS(EMBREE_POINTER)
    embree3_intersect* intersect3; /* one of the two is NULL */
    embree4_intersect* intersect4;
} embree_library;
#undef EMBREE_POINTER

/* Loads one of the libraries called `names` (up to NULL), the first that is there and whole. False where none is, and
 * where the process has no room for it; `why` is then filled with the reasons. */
bool dmi_embree_load(embree_library* out_library, const char* const* names, char* why, size_t why_size);
void dmi_embree_unload(embree_library* library);

#endif
