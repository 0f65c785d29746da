/* One Embree device a context, set up so that it never starts a thread.
 *
 * Embree builds with TBB. The setting that looks right, threads=1, holds TBB to one thread in the whole process, the
 * host's own loops included, and still starts a worker when several threads build at once or when the device goes. So:
 * all slots of the device's arena are reserved for threads that call in (user_threads), every build joins that arena
 * (rtcJoinCommitScene), and no more threads enter than it has slots: a surplus one would make TBB start a worker. */
#if defined(__linux__)
#include <sched.h>
#include <stdbool.h>
#else
#include <unistd.h>
#endif
#include <threads.h>

#include "pick/picker.h"

#define DEVICE_CONFIG "user_threads=65536,start_threads=0,set_affinity=0"

static dm_result result_of(enum RTCError error) {
    switch (error) {
    case RTC_ERROR_NONE:
        return DM_OK;
    case RTC_ERROR_OUT_OF_MEMORY:
        return DM_ERROR_OUT_OF_MEMORY;
    case RTC_ERROR_UNSUPPORTED_CPU:
        return DM_ERROR_UNSUPPORTED;
    default:
        return DM_ERROR_INTERNAL;
    }
}

static const char* name_of(enum RTCError error) {
    switch (error) {
    case RTC_ERROR_INVALID_ARGUMENT:
        return "RTC_ERROR_INVALID_ARGUMENT";
    case RTC_ERROR_INVALID_OPERATION:
        return "RTC_ERROR_INVALID_OPERATION";
    case RTC_ERROR_OUT_OF_MEMORY:
        return "RTC_ERROR_OUT_OF_MEMORY";
    case RTC_ERROR_UNSUPPORTED_CPU:
        return "RTC_ERROR_UNSUPPORTED_CPU";
    case RTC_ERROR_CANCELLED:
        return "RTC_ERROR_CANCELLED";
    default:
        return "RTC_ERROR_UNKNOWN";
    }
}

static void on_error(void* user, enum RTCError error, const char* text) {
    dmi_fail(user, result_of(error), "Embree: %s: %s", name_of(error), text != NULL ? text : "");
}

static bool on_memory(void* user, ssize_t bytes, bool post) {
    (void)post;
    dmi_env* env = user;
    atomic_fetch_add_explicit(&env->pick_bytes, (uint64_t)(int64_t)bytes, memory_order_relaxed);
    return true;
}

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

dm_result dmi_picker_create(dmi_env* env, dmi_picker** out_picker) {
    dmi_picker* picker = dmi_alloc_zeroed(env, sizeof *picker, _Alignof(dmi_picker));
    if (picker == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for the ray picker");
    picker->env = env;
    picker->max_builders = processor_count();
    picker->device = rtcNewDevice(DEVICE_CONFIG);
    if (picker->device == NULL) {
        enum RTCError error = rtcGetDeviceError(NULL);
        dmi_free(env, picker, sizeof *picker);
        return dmi_fail(env, error == RTC_ERROR_NONE ? DM_ERROR_INTERNAL : result_of(error), "Embree: no device: %s",
                        name_of(error));
    }
    rtcSetDeviceErrorFunction(picker->device, on_error, env);
    rtcSetDeviceMemoryMonitorFunction(picker->device, on_memory, env);
    *out_picker = picker;
    return DM_OK;
}

void dmi_picker_destroy(dmi_picker* picker) {
    if (picker == NULL) return;
    rtcReleaseDevice(picker->device);
    dmi_free(picker->env, picker, sizeof *picker);
}

static bool enter(dmi_picker* picker) {
    uint32_t builders = atomic_load_explicit(&picker->builders, memory_order_relaxed);
    return builders < picker->max_builders && atomic_compare_exchange_weak(&picker->builders, &builders, builders + 1);
}

void dmi_picker_commit(dmi_picker* picker, RTCScene scene) {
    while (!enter(picker)) thrd_yield();
    rtcJoinCommitScene(scene);
    atomic_fetch_sub(&picker->builders, 1);
}

dm_result dmi_picker_status(const dmi_picker* picker) {
    return result_of(rtcGetDeviceError(picker->device));
}
