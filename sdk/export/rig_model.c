/* Makes the model of a rigged asset, step by step. Each step has a file of its own. */
#include "export/rig_model.h"

#include "export/rig_text.h"

enum { BLOCK = 1 << 18 }; /* bytes of the model's memory that are asked for at once; by hand */

/* The values are set by hand: pine; the sheet metal and board that furniture is made of; dry wood on wood slides at
 * three times as much, drawers on runners at less; a door pushed and let go comes to rest in about a second. */
static const dmi_rig_values usual = {.density = 600, .thickness = 0.003, .friction = 0.1, .damping_time = 0.5};

/* The stated value, the usual one for 0, and 0 for a negative one. */
static double value_or(float stated, double otherwise) {
    return stated == 0 ? otherwise : stated > 0 ? (double)stated : 0;
}

/* Slides without limits get some: formats want them, and gravity would take the part away for ever. */
static void bound_slides(dmi_rig_model* model) {
    for (uint32_t b = 0; b < model->body_count; b++) {
        dmi_rig_body* body = &model->bodies[b];
        if (body->kind != DMI_RIG_SLIDE || body->limited) continue;
        body->limited = body->is_range_made = true;
        body->lower = -model->size;
        body->upper = model->size;
    }
}

dm_result dmi_rig_model_make(dmi_env* env, const dm_gltf_rig_desc* desc, dmi_rig_model* out) {
    *out = (dmi_rig_model){.env = env, .desc = desc};
    dmi_arena_init(&out->arena, env, BLOCK);
    dmi_axes_init(&out->axes, desc->axes, NULL, desc->unit_in_metres);
    out->values = (dmi_rig_values){.density = value_or(desc->density, usual.density),
                                   .thickness = value_or(desc->thickness, usual.thickness),
                                   .friction = value_or(desc->friction, usual.friction),
                                   .damping_time = value_or(desc->damping_time, usual.damping_time)};
    out->original = desc->name != NULL ? desc->name : "";
    dmi_legal_name("asset", out->original, out->name, sizeof out->name);
    uint32_t* part_bodies = dmi_rig_push(out, desc->part_count, sizeof *part_bodies);
    if (part_bodies == NULL) return DM_ERROR_OUT_OF_MEMORY;
    dm_result result = dmi_rig_make_bodies(out, part_bodies);
    if (result == DM_OK) result = dmi_rig_make_shapes(out, part_bodies);
    if (result == DM_OK) result = dmi_rig_make_masses(out);
    if (result == DM_OK) bound_slides(out);
    return result;
}

void dmi_rig_model_close(dmi_rig_model* model) {
    dmi_arena_release(&model->arena);
}
