/* The lab's library, as a test finds it. */
#ifndef DM_TEST_LAB_H
#define DM_TEST_LAB_H

#include <dlfcn.h>

#include "test_tool.h"

/* NULL, and why on standard error, when it can't be opened. */
static inline void* test_open_lab(void) {
    char path[TOOL_PATH];
    tool_find("libdragmesh_lab.so", path);
    void* lab = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (lab == NULL) print_error("%s\n", dlerror());
    return lab;
}

#endif
