/* The lab's library, as a test finds it. */
#ifndef DM_TEST_LAB_H
#define DM_TEST_LAB_H

#include <dlfcn.h>
#include <stdint.h>
#include <string.h>

#include "test_tool.h"

/* NULL, and why on standard error, when it can't be opened. */
static inline void* test_open_lab(void) {
    char path[TOOL_PATH];
    tool_find("libdragmesh_lab.so", path);
    void* lab = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (lab == NULL) print_error("%s\n", dlerror());
    return lab;
}

/* Sets the weight of every category's id to 1, the others to 0. Returns 0 when `size` bytes are too few. */
static inline int test_every_category(void* lab, uint8_t* weights, size_t size) {
    uint32_t (*count)(void), (*id)(uint32_t), (*limit)(void);
    *(void**)&count = dlsym(lab, "dm_lab_category_count");
    *(void**)&id = dlsym(lab, "dm_lab_category_id");
    *(void**)&limit = dlsym(lab, "dm_lab_category_id_limit");
    if (limit() > size) return 0;
    memset(weights, 0, size);
    for (uint32_t row = 0; row < count(); row++) weights[id(row)] = 1;
    return 1;
}

#endif
