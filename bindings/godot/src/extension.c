/* What Godot calls when it loads the extension. */
#include "body.h"
#include "library.h"

#if defined(_WIN32)
#define EXPORTED __declspec(dllexport)
#else
#define EXPORTED __attribute__((visibility("default")))
#endif

static GDExtensionClassLibraryPtr library;

static void begin(void* data, GDExtensionInitializationLevel level) {
    (void)data;
    if (level != GDEXTENSION_INITIALIZATION_SCENE) return;
    gd_find_precision();
    if (library_begin()) body_register(library);
}

static void end(void* data, GDExtensionInitializationLevel level) {
    (void)data;
    if (level != GDEXTENSION_INITIALIZATION_SCENE || !library_context()) return;
    body_unregister(library);
    library_end();
}

EXPORTED GDExtensionBool dragmesh_godot_begin(GDExtensionInterfaceGetProcAddress find,
                                              GDExtensionClassLibraryPtr handle, GDExtensionInitialization* out);

GDExtensionBool dragmesh_godot_begin(GDExtensionInterfaceGetProcAddress find, GDExtensionClassLibraryPtr handle,
                                     GDExtensionInitialization* out) {
    if (!gd_load(find)) return false;
    library = handle;
    out->minimum_initialization_level = GDEXTENSION_INITIALIZATION_SCENE;
    out->initialize = begin;
    out->deinitialize = end;
    return true;
}
