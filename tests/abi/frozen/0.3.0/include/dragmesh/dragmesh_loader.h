/* Loads the dragmesh library at run time: one header, nothing to link (but -ldl on old systems).
 *
 *     dm_library library;
 *     const dm_core_1* dm = dm_library_open(&library, "libdragmesh.so");
 *     if (!dm) { fprintf(stderr, "%s\n", library.error); ... }
 *     dm->context_create(NULL, &context);
 *     ...
 *     dm_library_close(&library);   // after the last context is destroyed
 *
 * A library older than this header has a shorter table: before calling a function that was added after version 0.2, ask
 * DM_HAS(dm, function). */
#ifndef DRAGMESH_LOADER_H
#define DRAGMESH_LOADER_H

#include "dragmesh/dragmesh.h"

#if defined(_WIN32)
#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#include <windows.h>
#define DM_LIBRARY_PATH 4096 /* characters of the longest path */
#else
#include <dlfcn.h>
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef const void*(DM_CALL* dm_get_interface_function)(const char* id);

typedef struct dm_library {
    void* handle;
    const char* error; /* NULL, or why dm_library_open returned NULL; valid until the next call of this thread */
} dm_library;

#define DM_HAS(table, function)                                                                                        \
    ((table)->struct_size >= offsetof(dm_core_1, function) + sizeof((table)->function) && (table)->function)

static inline void dm_library_close(dm_library* library) {
    if (library->handle) {
#if defined(_WIN32)
        FreeLibrary((HMODULE)library->handle);
#else
        dlclose(library->handle);
#endif
    }
    library->handle = NULL;
}

/* Opens a library and returns its function table. path: as dlopen or LoadLibrary take it, in UTF-8. Returns NULL, with
 * library->error set, when there is no such library or it is none of dragmesh. */
static inline const dm_core_1* dm_library_open(dm_library* library, const char* path) {
    /* A union, because ISO C knows no cast from an object to a function pointer. */
    union {
#if defined(_WIN32)
        FARPROC object;
#else
        void* object;
#endif
        dm_get_interface_function function;
    } symbol;
#if defined(_WIN32)
    wchar_t wide[DM_LIBRARY_PATH];
#endif
    const dm_core_1* core = NULL;
    symbol.object = NULL;
    library->error = NULL;
#if defined(_WIN32)
    library->handle = NULL;
    if (MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, wide, DM_LIBRARY_PATH) > 0)
        library->handle = (void*)LoadLibraryW(wide);
    if (!library->handle)
        library->error = "LoadLibrary could not load it";
    else
        symbol.object = GetProcAddress((HMODULE)library->handle, "dm_get_interface");
#else
    library->handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library->handle)
        library->error = dlerror();
    else
        symbol.object = dlsym(library->handle, "dm_get_interface");
#endif
    if (!library->handle) return NULL;
    if (symbol.object) core = (const dm_core_1*)symbol.function("dm.core/1");
    if (core) return core;
    library->error = symbol.object ? "it has no interface dm.core/1" : "it has no function dm_get_interface";
    dm_library_close(library);
    return NULL;
}

#ifdef __cplusplus
}
#endif

#endif
