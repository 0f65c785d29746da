/* Checks of what crosses the boundary. */
#include "api_check.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/utf8.h"
#include "math/dual_quat.h"

#define MAX_STRUCT_SIZE 4096 /* bytes; a larger struct_size was never set on purpose; by hand */
#define MAX_WARNING 512      /* bytes of a warning, as of an error; longer ones are cut */

void dmi_warn(dmi_env* env, const char* format, ...) {
    if (env->log.message == NULL) return;
    char text[MAX_WARNING];
    va_list arguments;
    va_start(arguments, format);
    /* NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized): as in dmi_fail */
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    dmi_utf8_mend(text);
    env->log.message(env->log.user, DM_LOG_WARNING, DM_OK, text);
}

static dm_result check_size(dmi_env* env, const char* what, const void* desc, size_t first, uint32_t* out_size) {
    if (desc == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s is NULL", what);
    memcpy(out_size, desc, sizeof *out_size);
    if (*out_size < first || *out_size > MAX_STRUCT_SIZE) {
        return dmi_fail(env, DM_ERROR_STRUCT_SIZE, "%s.struct_size is %u: it must be sizeof the struct, at least %zu",
                        what, *out_size, first);
    }
    return DM_OK;
}

dm_result dmi_read_desc(dmi_env* env, const char* what, const void* desc, size_t first, size_t size, void* out) {
    uint32_t given = 0;
    dm_result result = check_size(env, what, desc, first, &given);
    if (result != DM_OK) return result;
    const uint8_t* bytes = desc;
    for (size_t i = size; i < given; i++) {
        if (bytes[i] != 0) {
            return dmi_fail(env, DM_ERROR_STRUCT_SIZE,
                            "%s sets byte %zu: this library is older than the caller and knows %zu bytes", what, i,
                            size);
        }
    }
    memset(out, 0, size);
    memcpy(out, desc, given < size ? given : size);
    return DM_OK;
}

dm_result dmi_check_out(dmi_env* env, const char* what, const void* out, size_t first) {
    uint32_t given = 0;
    return check_size(env, what, out, first, &given);
}

void dmi_write_out(void* out, const void* value, size_t size) {
    uint32_t given = 0;
    memcpy(&given, out, sizeof given);
    size_t known = given < size ? given : size;
    memcpy((uint8_t*)out + sizeof given, (const uint8_t*)value + sizeof given, known - sizeof given);
    memset((uint8_t*)out + known, 0, given - known);
}

dm_result dmi_check_number(dmi_env* env, const char* what, const char* field, float number) {
    if (fabsf(number) <= DMI_LARGEST) return DM_OK;
    if (!isfinite(number)) return dmi_fail(env, DM_ERROR_NOT_FINITE, "%s%s is %g", what, field, (double)number);
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s%s is %g: numbers beyond %g are too large to compute with", what,
                    field, (double)number, (double)DMI_LARGEST);
}

dm_result dmi_check_vector(dmi_env* env, const char* what, const char* const fields[3], const float vector[3]) {
    for (int i = 0; i < 3; i++) {
        if (!(fabsf(vector[i]) <= DMI_LARGEST)) return dmi_check_number(env, what, fields[i], vector[i]);
    }
    return DM_OK;
}

dm_result dmi_check_finite(dmi_env* env, const char* what, const float* values, uint32_t count) {
    for (uint32_t i = 0; i < count; i++) {
        if (isfinite(values[i])) continue;
        if (count == 1) return dmi_fail(env, DM_ERROR_NOT_FINITE, "%s is %g", what, (double)values[i]);
        return dmi_fail(env, DM_ERROR_NOT_FINITE, "%s: number %u is %g", what, i, (double)values[i]);
    }
    return DM_OK;
}

dm_result dmi_check_range(dmi_env* env, const char* what, int32_t value, int32_t first, int32_t last) {
    if (value >= first && value <= last) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s is %d: it must be %d to %d", what, value, first, last);
}

/* Whether two sums alone tell that a ray is good, as of most rays: what is too large or not finite makes its sum so
 * too.
 */
static bool is_ordinary_ray(const dm_ray* ray) {
    const dm_vec3 origin = ray->origin, direction = ray->direction;
    const float far = fabsf(origin.x) + fabsf(origin.y) + fabsf(origin.z);
    const float length = fabsf(direction.x) + fabsf(direction.y) + fabsf(direction.z);
    return far <= DMI_LARGEST && length > 0 && length <= FLT_MAX;
}

dm_result dmi_check_ray(dmi_env* env, const char* what, const dm_ray* ray) {
    if (ray == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s is NULL", what);
    if (is_ordinary_ray(ray)) return DM_OK;
    static const char* const fields[3] = {".origin.x", ".origin.y", ".origin.z"};
    const float origin[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    const float direction[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    dm_result result = dmi_check_vector(env, what, fields, origin);
    if (result == DM_OK) result = dmi_check_finite(env, what, direction, 3);
    if (result != DM_OK) return result;
    if (direction[0] == 0.0f && direction[1] == 0.0f && direction[2] == 0.0f) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.direction has no length", what);
    }
    return DM_OK;
}

static dm_result refuse_dual(dmi_env* env, const char* what, int i, double number) {
    if (!isfinite(number)) return dmi_fail(env, DM_ERROR_NOT_FINITE, "%s.dual[%d] is %g", what, i, number);
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                    "%s.dual[%d] is %g: numbers beyond %g are too large to compute with", what, i, number,
                    (double)DMI_LARGEST_DUAL);
}

dm_result dmi_check_pose(dmi_env* env, const char* what, const dm_pose* pose, dm_pose* out) {
    if (pose == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s is NULL", what);
    dm_result result = dmi_check_finite(env, what, pose->real, 4);
    if (result != DM_OK) return result;
    for (int i = 0; i < 4; i++) {
        if (!(fabsf(pose->dual[i]) <= DMI_LARGEST_DUAL)) return refuse_dual(env, what, i, (double)pose->dual[i]);
    }
    float length;
    if (!dmi_pose_is_near_unit(pose, &length)) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.real has length %g: it must be a unit quaternion", what,
                        (double)length);
    }
    *out = dmi_pose_normalize(pose);
    return DM_OK;
}
