/* Puts the bits of a call into one line. */
#include "api_degraded.h"

#include <stdio.h>
#include <string.h>

#include "api_check.h"

#define LINE 512 /* bytes; all of the texts below fit */

static const struct {
    uint32_t bit;
    const char* text;
} reasons[] = {
    {DM_DEGRADED_NO_KINEMATICS, "no weights of KPP-Net (kpp_net.safetensors), joints are found by geometry alone"},
    {DM_DEGRADED_NO_RANKER, "no weights of the ranker (ranker.safetensors), joints are chosen by rules"},
    {DM_DEGRADED_NO_MOTION, "no weights of the DQ-VAE (dq_vae.safetensors), releases are paced by a rule"},
    {DM_DEGRADED_NO_BODY, "every triangle is of a part, nothing stays that joints could be told by"},
    {DM_DEGRADED_HINT, "a pivot far away from the object is ignored"},
    {DM_DEGRADED_MESH, "the mesh is not all of its file"},
};

/* Returns whether a part of the object moves. */
static bool has_moving_part(const dmi_object* object) {
    for (uint32_t i = 1; i < object->part_count; i++)
        if (object->parts[i].joint.type != DM_JOINT_FIXED) return true;
    return false;
}

uint32_t dmi_degraded_of(const dmi_object_slot* slot) {
    const dmi_object* object = slot->object;
    if (!has_moving_part(object)) return object->degraded;
    return object->degraded | (object->parts[0].shape.face_count == 0 ? DM_DEGRADED_NO_BODY : 0) |
           (slot->features == NULL ? DM_DEGRADED_NO_MOTION : 0);
}

void dmi_degraded_warn(dmi_env* env, const char* function, uint32_t bits) {
    char line[LINE];
    size_t length = 0;
    if (bits == 0) return;
    for (size_t i = 0; i < sizeof reasons / sizeof *reasons; i++) {
        if (!(bits & reasons[i].bit) || length >= sizeof line) continue;
        const int written =
            snprintf(line + length, sizeof line - length, "%s%s", length > 0 ? "; " : "", reasons[i].text);
        if (written > 0) length += (size_t)written;
    }
    dmi_warn(env, "%s: the answer is less than it could be: %s", function, line);
}
