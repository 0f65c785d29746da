/* The names of joint types, as jobs and answers have them. */
#ifndef CLI_JOINT_TYPE_H
#define CLI_JOINT_TYPE_H

#include <stdint.h>

/* Returns "unknown" for a number that is none. */
const char* joint_type_name(int32_t type);
/* Returns DM_JOINT_UNKNOWN for a name that is none. */
int32_t joint_type_from_name(const char* name);

#endif
