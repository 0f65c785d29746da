/* The backend of Embree 3.13 or 4: one device a context, set up so that it never starts a thread.
 *
 * Embree builds with TBB. The setting that looks right, threads=1, holds TBB to one thread in the whole process, the
 * host's own loops included, and still starts a worker when several threads build at once or when the device goes. So:
 * all slots of the device's arena are reserved for threads that call in (user_threads), every build joins that arena
 * (rtcJoinCommitScene), and no more threads enter than it has slots: a surplus one would make TBB start a worker. */
#if defined(__linux__)
#include <sched.h>
#else
#include <unistd.h>
#endif
#include <stdio.h>
#include <string.h>
#include <threads.h>

#include "base/fp_environment.h"
#include "pick/backend.h"
#include "pick/embree_abi.h"

#define DEVICE_CONFIG "user_threads=65536,start_threads=0,set_affinity=0"

static const char* const library_names[] = {"libembree4.so.4", "libembree3.so.3", NULL};

typedef struct device {
    dmi_env* env;
    embree_library library;
    embree_device handle;
    _Atomic uint32_t builders; /* threads inside join_commit */
    uint32_t max_builders;
} device;

typedef struct tree {
    const embree_library* library;
    embree_scene scene;
} tree;

/* ---- errors and memory ---- */

static dm_result result_of(int32_t error) {
    switch (error) {
    case EMBREE_ERROR_NONE:
        return DM_OK;
    case EMBREE_ERROR_OUT_OF_MEMORY:
        return DM_ERROR_OUT_OF_MEMORY;
    case EMBREE_ERROR_UNSUPPORTED_CPU:
        return DM_ERROR_UNSUPPORTED;
    case EMBREE_ERROR_CANCELLED:
        return DM_ERROR_CANCELLED;
    default:
        return DM_ERROR_INTERNAL;
    }
}

static const char* name_of(int32_t error) {
    switch (error) {
    case EMBREE_ERROR_INVALID_ARGUMENT:
        return "RTC_ERROR_INVALID_ARGUMENT";
    case EMBREE_ERROR_INVALID_OPERATION:
        return "RTC_ERROR_INVALID_OPERATION";
    case EMBREE_ERROR_OUT_OF_MEMORY:
        return "RTC_ERROR_OUT_OF_MEMORY";
    case EMBREE_ERROR_UNSUPPORTED_CPU:
        return "RTC_ERROR_UNSUPPORTED_CPU";
    case EMBREE_ERROR_CANCELLED:
        return "RTC_ERROR_CANCELLED";
    default:
        return "RTC_ERROR_UNKNOWN";
    }
}

static void on_error(void* user, int32_t error, const char* text) {
    if (error == EMBREE_ERROR_CANCELLED) return; /* on_progress has said so */
    dmi_fail(user, result_of(error), "Embree: %s: %s", name_of(error), text != NULL ? text : "");
}

static bool on_memory(void* user, ssize_t bytes, bool post) {
    (void)post;
    dmi_env* env = user;
    atomic_fetch_add_explicit(&env->pick_bytes, (uint64_t)(int64_t)bytes, memory_order_relaxed);
    return true;
}

/* Returns the result of the calling thread's calls since the last time; failures are already in the log. */
static dm_result status(const device* d) {
    return result_of(d->library.GetDeviceError(d->handle));
}

/* ---- device ---- */

/* Processors this process may run on, which is how many slots TBB gives an arena. */
static uint32_t processor_count(void) {
    long count;
#if defined(__linux__)
    cpu_set_t set;
    count = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
#else
    count = sysconf(_SC_NPROCESSORS_ONLN);
#endif
    return count > 1 ? (uint32_t)count : 1;
}

/* Fills the device; on failure it holds neither handle nor library. UNSUPPORTED: this process can't have one. */
static dm_result open_device(device* d, char* why, size_t why_size) {
    if (!dmi_embree_load(&d->library, library_names, why, why_size)) return DM_ERROR_UNSUPPORTED;
    d->handle = d->library.NewDevice(DEVICE_CONFIG);
    if (d->handle == NULL) {
        const int32_t error = d->library.GetDeviceError(NULL);
        snprintf(why, why_size, "Embree makes no device: %s", name_of(error));
        dmi_embree_unload(&d->library);
        return error == EMBREE_ERROR_OUT_OF_MEMORY ? DM_ERROR_OUT_OF_MEMORY : DM_ERROR_UNSUPPORTED;
    }
    d->library.SetDeviceErrorFunction(d->handle, on_error, d->env);
    d->library.SetDeviceMemoryMonitorFunction(d->handle, on_memory, d->env);
    return DM_OK;
}

static dm_result open(dmi_env* env, void** out_device, char* why, size_t why_size) {
    device* d = dmi_alloc_zeroed(env, sizeof *d, _Alignof(device));
    if (d == NULL) {
        snprintf(why, why_size, "no memory");
        return DM_ERROR_OUT_OF_MEMORY;
    }
    d->env = env;
    d->max_builders = processor_count();
    const dm_result result = open_device(d, why, why_size);
    if (result != DM_OK) {
        dmi_free(env, d, sizeof *d);
        return result;
    }
    *out_device = d;
    return DM_OK;
}

static void close(void* handle) {
    device* d = handle;
    d->library.ReleaseDevice(d->handle);
    dmi_embree_unload(&d->library);
    dmi_free(d->env, d, sizeof *d);
}

/* ---- trees ---- */

static bool enter(device* d) {
    uint32_t builders = atomic_load_explicit(&d->builders, memory_order_relaxed);
    return builders < d->max_builders && atomic_compare_exchange_weak(&d->builders, &builders, builders + 1);
}

typedef struct building {
    const dmi_progress* progress;
    thrd_t thread;
    _Atomic bool cancelled;
} building;

/* Builds that run side by side take work from each other: another thread may come by here. Embree flushes denormals. */
static bool on_progress(void* user, double share) {
    DMI_OWN_FP;
    building* b = user;
    if (!b->cancelled && thrd_equal(b->thread, thrd_current()) && dmi_progress_tell(b->progress, (float)share) != DM_OK)
        b->cancelled = true;
    return !b->cancelled;
}

/* Builds the scene on the calling thread. */
static void join_commit(device* d, embree_scene scene, const dmi_progress* progress) {
    building own = {.progress = progress, .thread = thrd_current()};
    while (!enter(d)) thrd_yield();
    d->library.SetSceneProgressMonitorFunction(scene, on_progress, &own);
    d->library.JoinCommitScene(scene);
    d->library.SetSceneProgressMonitorFunction(scene, NULL, NULL);
    atomic_fetch_sub(&d->builders, 1);
}

static dm_result build_scene(device* d, const dmi_triangles* triangles, embree_scene* out_scene) {
    const embree_library* rtc = &d->library;
    embree_geometry geometry = rtc->NewGeometry(d->handle, EMBREE_TRIANGLES);
    embree_scene scene = rtc->NewScene(d->handle);
    if (geometry != NULL && scene != NULL) {
        rtc->SetSharedGeometryBuffer(geometry, EMBREE_VERTICES, 0, EMBREE_FLOAT3, triangles->positions, 0,
                                     3 * sizeof(float), triangles->vertex_count);
        rtc->SetSharedGeometryBuffer(geometry, EMBREE_INDICES, 0, EMBREE_UINT3, triangles->wide, 0,
                                     3 * sizeof(uint32_t), triangles->face_count);
        rtc->CommitGeometry(geometry);
        rtc->SetSceneFlags(scene, EMBREE_ROBUST);
        rtc->AttachGeometry(scene, geometry);
        join_commit(d, scene, triangles->progress);
    }
    if (geometry != NULL) rtc->ReleaseGeometry(geometry);
    const dm_result result = status(d);
    if (result == DM_OK)
        *out_scene = scene;
    else if (scene != NULL)
        rtc->ReleaseScene(scene);
    return result;
}

static dm_result build(void* handle, const dmi_triangles* triangles, void** out_tree) {
    device* d = handle;
    tree* t = dmi_alloc(d->env, sizeof *t, _Alignof(tree));
    if (t == NULL) return dmi_fail(d->env, DM_ERROR_OUT_OF_MEMORY, "no memory to pick a part");
    t->library = &d->library;
    const dm_result result = build_scene(d, triangles, &t->scene);
    if (result != DM_OK) {
        dmi_free(d->env, t, sizeof *t);
        return result;
    }
    *out_tree = t;
    return DM_OK;
}

static void destroy(void* handle, void* built) {
    device* d = handle;
    tree* t = built;
    d->library.ReleaseScene(t->scene);
    dmi_free(d->env, t, sizeof *t);
}

static bool first_hit(const void* built, const dmi_part_ray* ray, dmi_part_hit* out_hit) {
    const tree* t = built;
    embree_ray_hit rtc;
    memcpy(&rtc, ray, offsetof(dmi_part_ray, far)); /* the fourth floats: near and time */
    rtc.far = ray->far;
    rtc.mask = EMBREE_ALL_RAYS;
    rtc.id = rtc.flags = 0;
    rtc.geometry = EMBREE_NO_ID;
    if (t->library->intersect4 != NULL) {
        t->library->intersect4(t->scene, &rtc, NULL);
    } else {
        embree_context3 context = {0};
        t->library->intersect3(t->scene, &context, &rtc);
    }
    if (rtc.geometry == EMBREE_NO_ID) return false;
    *out_hit = (dmi_part_hit){rtc.primitive, rtc.u, rtc.v};
    return true;
}

const dmi_pick_backend dmi_pick_embree = {"embree", DM_PICK_EMBREE, true, open, close,
                                          build,    destroy,        NULL, NULL, first_hit};
