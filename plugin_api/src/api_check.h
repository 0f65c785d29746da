/* Checks of what crosses the boundary: descriptors of any version, numbers, enums. Each names the field and the value.
 */
#ifndef DMI_API_CHECK_H
#define DMI_API_CHECK_H

#include "base/env.h"

/* Bytes up to and with `last`, the last member of a descriptor's first published version. */
#define DMI_FIRST_SIZE(type, last) (offsetof(type, last) + sizeof(((type*)0)->last))

/* The struct_size rules, for inputs: copies the caller's version of a descriptor into ours (`size` bytes at `out`),
 * shorter ones zero-extended. STRUCT_SIZE when it is smaller than the first version or sets what we can't know.
 * what: "dm_function: argument". */
dm_result dmi_read_desc(dmi_env* env, const char* what, const void* desc, size_t first, size_t size, void* out);
/* The same for outputs: checks before any work is done, … */
dm_result dmi_check_out(dmi_env* env, const char* what, const void* out, size_t first);
/* … and writes as much as the caller has room for; what we can't know becomes zero. out->struct_size stays. */
void dmi_write_out(void* out, const void* value, size_t size);

dm_result dmi_check_finite(dmi_env* env, const char* what, const float* values, uint32_t count);
dm_result dmi_check_range(dmi_env* env, const char* what, int32_t value, int32_t first, int32_t last);
/* A ray with finite numbers and a direction. */
dm_result dmi_check_ray(dmi_env* env, const char* what, const dm_ray* ray);
/* Finite, with a rotation; out is it made a unit dual quaternion. */
dm_result dmi_check_pose(dmi_env* env, const char* what, const dm_pose* pose, dm_pose* out);

#endif
