#include "library.h"

#include <stdio.h>
#include <stdlib.h>

#include "engine.h"

enum { LONGEST_PATH = 1024 };
static const char models_setting[] = "dragmesh/models", models_default[] = "res://addons/dragmesh/models";

static dm_context* context;
static dm_model model;
static bool model_read;

/* Called on the threads that prepare, too: printing is safe there. */
static void DM_CALL print_message(void* user, int32_t level, dm_result code, const char* text) {
    (void)user;
    if (code == DM_ERROR_CANCELLED) return; /* as asked */
    const char* name = dm_result_string(code);
    if (level == DM_LOG_ERROR)
        gd.print_error_with_message(name, text, "dragmesh", "", 0, 0);
    else if (level == DM_LOG_WARNING)
        gd.print_warning_with_message(name, text, "dragmesh", "", 0, 0);
}

bool library_begin(void) {
    dm_context_desc desc = dm_context_desc_default();
    desc.axes = DM_AXES_GLTF; /* Godot's: right-handed, y up, metres */
    desc.log.message = print_message;
    const dm_result result = dm_context_create(&desc, &context);
    if (result == DM_OK) return true;
    gd.print_error_with_message(dm_result_string(result), "no context could be made", "dragmesh", "", 0, 0);
    return false;
}

void library_end(void) {
    dm_context_destroy(context);
    context = NULL;
    model = 0;
    model_read = false;
}

dm_context* library_context(void) {
    return context;
}

/* A static function of FileAccess, called by its name. */
static gd_value file_access(const char* function, const char* path) {
    gd_value classes = gd_singleton("ClassDB");
    gd_value arguments[3] = {gd_of_text("FileAccess"), gd_of_text(function), gd_of_text(path)};
    const gd_value result = gd_call(&classes, "class_call_static", 3, arguments);
    for (int i = 0; i < 3; i++) gd_free(&arguments[i]);
    gd_free(&classes);
    return result;
}

/* The bytes of FOLDER/NAME.safetensors; nil where there is none. */
static gd_value read_weights(const char* folder, const char* name) {
    char path[LONGEST_PATH];
    snprintf(path, sizeof path, "%s/%s.safetensors", folder, name);
    gd_value exists = file_access("file_exists", path);
    const gd_value bytes = gd_bool(&exists) ? file_access("get_file_as_bytes", path) : gd_nil();
    gd_free(&exists);
    return bytes;
}

static char* models_folder(void) {
    gd_value settings = gd_singleton("ProjectSettings");
    gd_value arguments[2] = {gd_of_text(models_setting), gd_of_text(models_default)};
    gd_value folder = gd_call(&settings, "get_setting", 2, arguments);
    char* text = gd_text(&folder);
    gd_free(&folder);
    gd_free(&arguments[1]);
    gd_free(&arguments[0]);
    gd_free(&settings);
    return text;
}

dm_model library_model(void) {
    if (model_read) return model;
    model_read = true;
    char* folder = models_folder();
    if (!folder) return 0;
    gd_value kinematics = read_weights(folder, "kpp_net"), ranker = read_weights(folder, "ranker"),
             motion = read_weights(folder, "dq_vae");
    free(folder);
    dm_model_desc desc = dm_model_desc_default();
    desc.kinematics = gd_bytes(&kinematics), desc.kinematics_size = (size_t)gd_count(&kinematics);
    desc.ranker = gd_bytes(&ranker), desc.ranker_size = (size_t)gd_count(&ranker);
    desc.motion = gd_bytes(&motion), desc.motion_size = (size_t)gd_count(&motion);
    if ((desc.kinematics || desc.ranker || desc.motion) && dm_model_load(context, &desc, &model) != DM_OK) model = 0;
    gd_free(&motion);
    gd_free(&ranker);
    gd_free(&kinematics);
    return model;
}
