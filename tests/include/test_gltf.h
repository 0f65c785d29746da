/* Opens a glTF file that must be sound, on the test's memory and log. */
#ifndef DM_TEST_GLTF_H
#define DM_TEST_GLTF_H

#include "dragmesh/ext/gltf.h"
#include "test_env.h"

static inline dm_gltf* test_gltf_open(test_env* t, const void* data, size_t size) {
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = data,
                               .size = size,
                               .allocator = test_allocator(&t->memory),
                               .log = test_log(&t->messages)};
    dm_gltf* gltf = NULL;
    if (dm_gltf_open(&desc, &gltf) != DM_OK) fail_msg("%s", t->messages.text);
    return gltf;
}

#endif
