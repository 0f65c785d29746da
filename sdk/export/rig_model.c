/* Memory of the model of a rigged asset, and what formats ask of it. rig_make.c makes it. */
#include "export/rig_model.h"

void* dmi_rig_push(dmi_rig_model* model, size_t count, size_t size) {
    void* memory = count <= SIZE_MAX / 2 / size ? dmi_arena_push(&model->arena, count * size) : NULL;
    if (memory == NULL) dmi_fail(model->env, DM_ERROR_OUT_OF_MEMORY, "dm_gltf_rig_make: no memory for the model");
    return memory;
}

void dmi_rig_model_close(dmi_rig_model* model) {
    dmi_arena_release(&model->arena);
}

bool dmi_rig_turns(const dmi_rig_body* body) {
    return body->kind == DMI_RIG_HINGE || body->kind == DMI_RIG_SCREW;
}
