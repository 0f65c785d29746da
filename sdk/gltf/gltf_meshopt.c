/* Decodes compressed buffer views. The decoder only asserts what it is called with, so everything is checked here. */
#include "gltf/gltf_meshopt.h"

#include <inttypes.h>
#include <string.h>

#if !defined(DMI_NO_MESHOPT)
#include <meshoptimizer/meshoptimizer.h>
#endif

/* A vertex block spends at least 2 bits on 16 values of a byte each: 64 bytes come out of one. */
#define MOST_BYTES_PER_BYTE 64
#define LARGEST_STRIDE 256 /* most bytes of an element in the vertex codec */

static const char* const names[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

int dmi_meshopt_is_name(const char* name) {
    return strcmp(name, names[0]) == 0 || strcmp(name, names[1]) == 0;
}

const cJSON* dmi_meshopt_of(const cJSON* object) {
    const cJSON* extensions = dmi_json_get(object, "extensions");
    const cJSON* found = dmi_json_get(extensions, names[0]);
    return found ? found : dmi_json_get(extensions, names[1]);
}

const char* dmi_meshopt_name_of(const cJSON* object) {
    return dmi_json_get(dmi_json_get(object, "extensions"), names[0]) ? names[0] : names[1];
}

static int is(const char* a, const char* b) {
    return a && strcmp(a, b) == 0;
}

/* Returns whether the filter takes elements of this size. */
static int filter_fits(const char* filter, uint64_t stride) {
    if (!filter || is(filter, "NONE")) return 1;
    if (is(filter, "OCTAHEDRAL")) return stride == 4 || stride == 8;
    if (is(filter, "QUATERNION")) return stride == 8;
    return is(filter, "EXPONENTIAL") && stride % 4 == 0;
}

dm_result dmi_meshopt_check(const dmi_meshopt_view* view, const char* place, dmi_gltf_problem* problem) {
    const int vertices = is(view->mode, "ATTRIBUTES"), triangles = is(view->mode, "TRIANGLES");
    const uint64_t stride = view->stride;
    if (!dmi_meshopt_available())
        return dmi_gltf_refuse(problem, DM_ERROR_UNSUPPORTED, "%s: meshopt compression, which this build lacks", place);
    if (!vertices && !triangles && !is(view->mode, "INDICES"))
        return dmi_gltf_refuse(problem, DM_ERROR_UNSUPPORTED, "%s: meshopt compression of mode '%.20s'", place,
                               view->mode ? view->mode : "");
    if (vertices ? stride == 0 || stride > LARGEST_STRIDE || stride % 4 != 0 : stride != 2 && stride != 4)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: meshopt compression of %" PRIu64 " bytes an element",
                               place, stride);
    if (!filter_fits(vertices ? view->filter : NULL, stride))
        return dmi_gltf_refuse(problem, DM_ERROR_UNSUPPORTED,
                               "%s: meshopt filter '%.20s' of %" PRIu64 " bytes an element", place, view->filter,
                               stride);
    if (view->count / MOST_BYTES_PER_BYTE > view->size / stride + 1 || (triangles && view->count % 3 != 0))
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA,
                               "%s: %" PRIu64 " bytes of meshopt data can't hold %" PRIu64 " elements of %" PRIu64,
                               place, view->size, view->count, stride);
    return DM_OK;
}

#if defined(DMI_NO_MESHOPT)

int dmi_meshopt_available(void) {
    return 0;
}

dm_result dmi_meshopt_decode(const dmi_meshopt_view* view, const char* place, dmi_gltf_problem* problem, uint8_t* out) {
    (void)out;
    return dmi_meshopt_check(view, place, problem);
}

#else

int dmi_meshopt_available(void) {
    return 1;
}

/* Undoes the filter in place. */
static void undo_filter(const dmi_meshopt_view* view, uint8_t* out) {
    if (is(view->filter, "OCTAHEDRAL")) meshopt_decodeFilterOct(out, view->count, view->stride);
    if (is(view->filter, "QUATERNION")) meshopt_decodeFilterQuat(out, view->count, view->stride);
    if (is(view->filter, "EXPONENTIAL")) meshopt_decodeFilterExp(out, view->count, view->stride);
}

dm_result dmi_meshopt_decode(const dmi_meshopt_view* view, const char* place, dmi_gltf_problem* problem, uint8_t* out) {
    int status;
    if (is(view->mode, "ATTRIBUTES"))
        status = meshopt_decodeVertexBuffer(out, view->count, view->stride, view->data, view->size);
    else if (is(view->mode, "TRIANGLES"))
        status = meshopt_decodeIndexBuffer(out, view->count, view->stride, view->data, view->size);
    else
        status = meshopt_decodeIndexSequence(out, view->count, view->stride, view->data, view->size);
    if (status != 0)
        return dmi_gltf_refuse(problem, DM_ERROR_BAD_DATA, "%s: meshopt data that can't be decoded (%d)", place,
                               status);
    if (is(view->mode, "ATTRIBUTES")) undo_filter(view, out);
    return DM_OK;
}

#endif
