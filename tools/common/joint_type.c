/* The names of joint types. */
#include "joint_type.h"

#include <string.h>

#include "dragmesh/dragmesh.h"

static const char* const type_names[] = {"unknown", "revolute", "prismatic", "screw", "continuous", "fixed"};

const char* joint_type_name(int32_t type) {
    return type >= 0 && type <= DM_JOINT_FIXED ? type_names[type] : "unknown";
}

int32_t joint_type_from_name(const char* name) {
    for (int32_t i = DM_JOINT_REVOLUTE; i <= DM_JOINT_CONTINUOUS; i++) {
        if (strcmp(name, type_names[i]) == 0) return i;
    }
    return DM_JOINT_UNKNOWN;
}
