/* What the WebAssembly module has beside the library: hooks that call the page. JavaScript's functions have no address
 * in the module; imported ones have, and `user` tells whose they are. */
#include "dragmesh/dragmesh.h"

#define HOST(name) __attribute__((import_module("host"), import_name(#name)))
#define EXPORT(name) __attribute__((export_name(#name)))

HOST(log) void dmjs_host_log(void* user, int32_t level, dm_result code, const char* text);
HOST(intent) int32_t dmjs_host_intent(void* user, uint32_t part_id, dm_vec3 box_min, dm_vec3 box_max);
HOST(progress) int32_t dmjs_host_progress(void* user, float done);
HOST(choose) int32_t dmjs_host_choose(void* user, const dm_choice* choice);

/* The addresses of the hooks, for descriptors. */
EXPORT(dmjs_log) void dmjs_log(dm_log* out_log) {
    out_log->message = dmjs_host_log;
}
EXPORT(dmjs_intent) dm_intent_callback dmjs_intent(void) {
    return dmjs_host_intent;
}
EXPORT(dmjs_progress) dm_progress_callback dmjs_progress(void) {
    return dmjs_host_progress;
}
EXPORT(dmjs_choose) dm_choice_callback dmjs_choose(void) {
    return dmjs_host_choose;
}
