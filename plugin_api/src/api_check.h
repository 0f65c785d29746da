/* Checks of what crosses the boundary: descriptors of any version, numbers, enums. Messages name the field and value.
 */
#ifndef DMI_API_CHECK_H
#define DMI_API_CHECK_H

#include <stdbool.h>

#include "base/env.h"
#include "math/elementary.h"

/* The checks of [frame] functions take this for an environment: they log nothing. */
#define DMI_SILENT ((dmi_env*)NULL)

/* Size of a descriptor's first published version, whose last member is `last`. */
#define DMI_FIRST_SIZE(type, last) (offsetof(type, last) + sizeof(((type*)0)->last))

/* Copies the caller's version of an input descriptor into the library's (`size` bytes at `out`). Shorter ones are
 * zero-extended. Answers STRUCT_SIZE when it is smaller than the first version or sets bytes that this version does not
 * know. what: "dm_function: argument", for messages. */
dm_result dmi_read_desc(dmi_env* env, const char* what, const void* desc, size_t first, size_t size, void* out);
/* Checks the struct_size of an output descriptor before any work is done. */
dm_result dmi_check_out(dmi_env* env, const char* what, const void* out, size_t first);
/* Writes as much of `value` as the caller's version holds and zeroes the rest; out->struct_size stays. */
void dmi_write_out(void* out, const void* value, size_t size);

/* Logs a warning, after which the call goes on. [frame] functions must not call it. */
void dmi_warn(dmi_env* env, const char* format, ...) DMI_PRINTF(2, 3);

/* Checks that a number is finite, else it answers NOT_FINITE, and within DMI_LARGEST, else INVALID_ARGUMENT. field:
 * such as ".axis.x". */
dm_result dmi_check_number(dmi_env* env, const char* what, const char* field, float number);
dm_result dmi_check_vector(dmi_env* env, const char* what, const char* const fields[3], const float vector[3]);

dm_result dmi_check_finite(dmi_env* env, const char* what, const float* values, uint32_t count);
dm_result dmi_check_range(dmi_env* env, const char* what, int32_t value, int32_t first, int32_t last);
/* Checks that a ray has finite numbers, an origin within DMI_LARGEST and a direction. */
dm_result dmi_check_ray(dmi_env* env, const char* what, const dm_ray* ray);
/* Checks that a pose is finite, within DMI_LARGEST_DUAL, and holds a rotation. out: the pose as a unit dual
 * quaternion. */
dm_result dmi_check_pose(dmi_env* env, const char* what, const dm_pose* pose, dm_pose* out);

#endif
