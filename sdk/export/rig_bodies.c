/* Makes bodies of the parts of an asset. What moves hangs on what carries it, and all else is one with it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "export/rig_model.h"
#include "export/rig_text.h"
#include "math/joint.h"
#include "math/linear3.h"

#define UNSET UINT32_MAX

/* Turns canonical coordinates, Y up, into Z up. */
static void put_z_up(const double y_up[3], double out[3]) {
    out[0] = y_up[0];
    out[1] = -y_up[2];
    out[2] = y_up[1];
}

/* Returns whether a part moves by itself. */
static bool moves(const dmi_rig_model* model, uint32_t part) {
    const dm_asset_part* p = &model->desc->parts[part];
    const int32_t type = model->desc->joints[part].type;
    if (p->state == DM_ASSET_FREE) return true;
    return p->state == DM_ASSET_MOVES && type != DM_JOINT_FIXED && type != DM_JOINT_UNKNOWN;
}

static dmi_rig_kind kind_of(const dmi_rig_model* model, uint32_t part) {
    if (model->desc->parts[part].state == DM_ASSET_FREE) return DMI_RIG_FREE;
    switch (model->desc->joints[part].type) {
    case DM_JOINT_PRISMATIC:
        return DMI_RIG_SLIDE;
    case DM_JOINT_SCREW:
        return DMI_RIG_SCREW;
    default:
        return DMI_RIG_HINGE;
    }
}

/* Writes the joint in the model's frame and units. */
static void place_joint(const dmi_rig_model* model, uint32_t part, dmi_rig_body* body) {
    const dmi_frame frame = {.axes = model->axes, .size = 1};
    const dm_joint joint = dmi_frame_joint_in(&frame, &model->desc->joints[part]);
    put_z_up(dmi_xyz_f64(joint.origin).v, body->origin);
    put_z_up(dmi_xyz_f64(joint.axis).v, body->axis);
    const double* a = body->axis;
    const double length = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    for (int k = 0; k < 3; k++) body->axis[k] = length > 0 ? body->axis[k] / length : k == 0 ? 1.0 : 0.0;
    body->limited = dmi_joint_has_limits(&joint);
    body->lower = body->limited ? (double)joint.lower : 0;
    body->upper = body->limited ? (double)joint.upper : 0;
    body->pitch = (double)joint.pitch;
}

/* Returns the name that the host has for a part, else that of the first node that has one, or "" where none has. */
static const char* name_of(const dmi_rig_model* model, uint32_t part) {
    const dm_gltf_rig_desc* desc = model->desc;
    if (desc->part_names != NULL) return desc->part_names[part] != NULL ? desc->part_names[part] : "";
    for (uint32_t n = 0; n < desc->node_count; n++)
        if (desc->node_parts[n] == part && desc->nodes[n].name != NULL && desc->nodes[n].name[0])
            return desc->nodes[n].name;
    return "";
}

static void add_body(dmi_rig_model* model, uint32_t part, uint32_t parent) {
    dmi_rig_body* body = &model->bodies[model->body_count++];
    char start[DMI_RIG_NAME];
    *body =
        (dmi_rig_body){.part = part, .parent = parent, .kind = kind_of(model, part), .original = name_of(model, part)};
    snprintf(start, sizeof start, "part_%u", part + 1);
    dmi_legal_name(start, body->original, body->name, sizeof body->name);
    snprintf(start, sizeof start, "joint_%u", part + 1);
    dmi_legal_name(start, body->original, body->joint_name, sizeof body->joint_name);
    place_joint(model, part, body);
    for (int k = 0; k < 3; k++) body->place[k] = body->origin[k] - model->bodies[parent].origin[k];
}

/* Adds the bodies of a part and of what carries it, from above. chain: room for all parts. Returns false where the
 * parts carry each other in a circle. */
static bool add_chain(dmi_rig_model* model, uint32_t part, uint32_t* chain, uint32_t* part_bodies) {
    uint32_t length = 0;
    for (; part != DM_ASSET_NO_PART && part_bodies[part] == UNSET; part = model->desc->parts[part].parent) {
        if (length == model->desc->part_count) return false;
        chain[length++] = part;
    }
    uint32_t body = part != DM_ASSET_NO_PART ? part_bodies[part] : 0;
    while (length > 0) {
        part = chain[--length];
        if (moves(model, part)) {
            add_body(model, part, body);
            body = model->body_count - 1;
        }
        part_bodies[part] = body;
    }
    return true;
}

dm_result dmi_rig_make_bodies(dmi_rig_model* model, uint32_t* out_part_bodies) {
    const uint32_t count = model->desc->part_count;
    uint32_t* chain = dmi_rig_push(model, count, sizeof *chain);
    model->bodies = dmi_rig_push(model, (size_t)count + 1, sizeof *model->bodies);
    if (chain == NULL || model->bodies == NULL) return DM_ERROR_OUT_OF_MEMORY;
    model->bodies[0] = (dmi_rig_body){.name = "body", .original = "", .part = DM_ASSET_NO_PART, .kind = DMI_RIG_ROOT};
    model->body_count = 1;
    for (uint32_t i = 0; i < count; i++) out_part_bodies[i] = UNSET;
    for (uint32_t i = 0; i < count; i++)
        if (!add_chain(model, i, chain, out_part_bodies))
            return dmi_fail(model->env, DM_ERROR_INVALID_ARGUMENT,
                            "dm_gltf_rig_make: parts carry each other in a circle");
    return DM_OK;
}
