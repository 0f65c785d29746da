/* A host without a C library, linked by Microsoft's rules: status 0 when the library answers as the header says. */
#include "dragmesh/dragmesh.h"

static int same(const char* a, const char* b) {
    while (*a && *a == *b) a++, b++;
    return *a == *b;
}

int _fltused = 1; /* what the C library defines, for objects with floats */

int start(void) {
    dm_context* context = 0;
    const dm_joint joint = {.struct_size = sizeof joint, .type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}, .upper = 1};
    const dm_core_1* table = dm_get_interface("dm.core/1");
    dm_pose pose;
    float matrix[16];
    if (dm_version() != DM_VERSION || !same(dm_result_string(DM_OK), "DM_OK")) return 1;
    if (!table || table->version() != DM_VERSION || table->context_create(0, &context) != DM_OK) return 2;
    if (dm_joint_pose(&joint, 0.5f, &pose) != DM_OK) return 3;
    dm_pose_to_matrix(&pose, matrix);
    table->context_destroy(context);
    return matrix[14] > 0.49f && matrix[14] < 0.51f ? 0 : 4;
}
