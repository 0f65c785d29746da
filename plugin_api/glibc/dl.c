/* dlopen and the like, which moved from libdl to libc in glibc 2.34. */
#include "pin.h"

PIN(dlopen);
PIN(dlsym);
PIN(dlclose);
PIN(dlerror);

void* pinned_dlopen(const char* file, int mode);
void* pinned_dlsym(void* handle, const char* name);
int pinned_dlclose(void* handle);
char* pinned_dlerror(void);

void* __wrap_dlopen(const char* file, int mode);
void* __wrap_dlsym(void* handle, const char* name);
int __wrap_dlclose(void* handle);
char* __wrap_dlerror(void);

void* __wrap_dlopen(const char* file, int mode) {
    return pinned_dlopen(file, mode);
}

void* __wrap_dlsym(void* handle, const char* name) {
    return pinned_dlsym(handle, name);
}

int __wrap_dlclose(void* handle) {
    return pinned_dlclose(handle);
}

char* __wrap_dlerror(void) {
    return pinned_dlerror();
}
