/* Finds Embree at run time, by a handle of its own: what the host or another library calls rtc… is never called. */
#include "pick/embree_abi.h"

#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#define SPARE_KEYS 32 /* that are left to TBB, which takes 1 to 3, and to the host; by hand */

/* Deep binding lets Embree find its own functions first, too, where the host exports some of the same name. The
 * sanitizers abort on it: what they replace would not be replaced in Embree. */
static int load_flags(void) {
    int flags = RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE; /* TBB does not bear being unloaded */
#if defined(RTLD_DEEPBIND)
    static const char* const sanitizers[] = {"__asan_init", "__tsan_init", "__msan_init"};
    for (size_t i = 0; i < sizeof sanitizers / sizeof *sanitizers; i++) {
        if (dlsym(RTLD_DEFAULT, sanitizers[i]) != NULL) return flags;
    }
    flags |= RTLD_DEEPBIND;
#endif
    return flags;
}

/* Copies the address of a function into a pointer to it; false when the library has none of that name. */
static bool find(void* handle, const char* name, void* out_pointer) {
    void* address = dlsym(handle, name);
    memcpy(out_pointer, &address, sizeof address); /* C has no conversion from objects to functions */
    return address != NULL;
}

static bool find_all(embree_library* library) {
    bool found = true;
#define FIND(result, name, parameters) found = find(library->handle, "rtc" #name, &library->name) && found;
    EMBREE_FUNCTIONS(FIND)
#undef FIND
    return found;
}

/* Looks up rtcIntersect1 under the type that this version gives it. */
static bool find_intersect(embree_library* library, int major) {
    library->intersect3 = NULL;
    library->intersect4 = NULL;
    if (major == 3) return find(library->handle, "rtcIntersect1", &library->intersect3);
    return major == 4 && find(library->handle, "rtcIntersect1", &library->intersect4);
}

/* The major version stands in every name: libembree3.so.3, embree4.dll. */
static int major_of(const char* name) {
    const char* digit = strpbrk(name, "34");
    return digit != NULL ? *digit - '0' : 0;
}

static void append(char* why, size_t size, const char* text) {
    const size_t used = strlen(why);
    snprintf(why + used, size - used, "%s%s", used > 0 ? "; " : "", text);
}

/* Whether the process has thread-specific keys left, of which glibc has 1,024: each device takes one, TBB some when it
 * first builds. Where there is none, Embree crashes, or fails in all contexts alike. glibc before 2.34 has the
 * functions in libpthread alone, so they are not linked. */
static bool has_spare_keys(void) {
    pthread_key_t keys[SPARE_KEYS];
    int (*make)(pthread_key_t*, void (*)(void*));
    int (*end)(pthread_key_t);
    if (!find(RTLD_DEFAULT, "pthread_key_create", &make) || !find(RTLD_DEFAULT, "pthread_key_delete", &end))
        return true;
    int count = 0;
    while (count < SPARE_KEYS && make(&keys[count], NULL) == 0) count++;
    for (int i = 0; i < count; i++) end(keys[i]);
    return count == SPARE_KEYS;
}

bool dmi_embree_load(embree_library* out_library, const char* const* names, char* why, size_t why_size) {
    why[0] = 0;
    if (!has_spare_keys()) {
        append(why, why_size, "Embree needs thread-specific keys, and this process has used up its own");
        return false;
    }
    for (; *names != NULL; names++) {
        embree_library library = {.handle = dlopen(*names, load_flags())};
        if (library.handle == NULL) {
            append(why, why_size, dlerror());
        } else if (find_all(&library) && find_intersect(&library, major_of(*names))) {
            *out_library = library;
            return true;
        } else {
            append(why, why_size, *names);
            append(why, why_size, "lacks functions");
            dlclose(library.handle);
        }
    }
    return false;
}

void dmi_embree_unload(embree_library* library) {
    dlclose(library->handle);
}
