/* pin.h: what the C++ runtime that is linked into libdragmesh_gltf.so calls of newer versions of glibc. */
#include <dlfcn.h>
#include <link.h>
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <string.h>

#if defined(DMI_PIN_GLIBC) /* other builds share the C++ runtime */

/* glibc 2.32: the C++ runtime counts references without atomics where it is true. 0 is always safe. */
char __libc_single_threaded;

/* A pthread_once_t that is not PTHREAD_ONCE_INIT, which is 0. */
enum { ONCE_RUNS = 1, ONCE_DONE };

int __wrap_pthread_once(pthread_once_t* control, void (*run)(void));
int __wrap___pthread_key_create(pthread_key_t* key, void (*destroy)(void*));

/* glibc before 2.34 has it in libpthread alone, which a host may lack. */
int __wrap_pthread_once(pthread_once_t* control, void (*run)(void)) {
    _Atomic int* state = (_Atomic int*)control;
    int expected = PTHREAD_ONCE_INIT;
    if (atomic_compare_exchange_strong(state, &expected, ONCE_RUNS)) {
        run();
        atomic_store(state, ONCE_DONE);
    }
    while (atomic_load(state) != ONCE_DONE) sched_yield();
    return 0;
}

/* Never called: the C++ runtime asks for its address alone, as a sign that there may be threads. */
int __wrap___pthread_key_create(pthread_key_t* key, void (*destroy)(void*)) {
    (void)key, (void)destroy;
    return -1;
}

#if defined(DLFO_STRUCT_HAS_EH_DBASE) /* glibc 2.35 */

typedef struct search {
    struct dl_find_object* out;
    ElfW(Addr) address;
} search;

/* Non-zero, and *out filled in, where the object holds the address. */
static int holds(struct dl_phdr_info* object, size_t size, void* data) {
    (void)size;
    const search* sought = data;
    const ElfW(Addr) base = object->dlpi_addr;
    void* tables = NULL;
    int inside = 0;
    for (int i = 0; i < object->dlpi_phnum; i++) {
        const ElfW(Phdr)* segment = &object->dlpi_phdr[i];
        char* start = (char*)(base + segment->p_vaddr);
        if (segment->p_type == PT_GNU_EH_FRAME) tables = start;
        if (segment->p_type != PT_LOAD || sought->address - base - segment->p_vaddr >= segment->p_memsz) continue;
        inside = 1;
        sought->out->dlfo_map_start = start;
        sought->out->dlfo_map_end = start + segment->p_memsz;
    }
    sought->out->dlfo_eh_frame = tables;
    return inside && tables != NULL;
}

int __wrap__dl_find_object(void* address, struct dl_find_object* out);

/* Finds the tables by which an exception is unwound; 0, or -1 where no object holds the address. */
int __wrap__dl_find_object(void* address, struct dl_find_object* out) {
    search sought = {out, (ElfW(Addr))address};
    memset(out, 0, sizeof *out);
    return dl_iterate_phdr(holds, &sought) ? 0 : -1;
}

#endif

#endif
