/* Augments cases by what the generator does not: any orientation, and part masks with errors. */
#include <math.h>

#include "case.h"

void lab_rotate_object(dmi_random* random, dmg_object* object, float out_rotation[9]) {
    float axis[3];
    lab_random_direction(random, axis);
    lab_rotation(axis, lab_random_uniform(random, 0.0f, 3.14159265f), out_rotation);
    for (uint32_t v = 0; v < object->vertex_count; v++)
        lab_rotate(out_rotation, object->positions + (size_t)3 * v, object->positions + (size_t)3 * v);
    for (uint32_t j = 0; j < object->joint_count; j++) {
        lab_rotate(out_rotation, object->joints[j].axis, object->joints[j].axis);
        lab_rotate(out_rotation, object->joints[j].origin, object->joints[j].origin);
    }
}

static void face_corners(const dmg_object* object, uint32_t face, const float* corners[3]) {
    for (int i = 0; i < 3; i++) corners[i] = object->positions + (size_t)3 * object->indices[(size_t)3 * face + i];
}

static float face_area(const dmg_object* object, uint32_t face) {
    const float* p[3];
    face_corners(object, face, p);
    float a[3], b[3];
    for (int i = 0; i < 3; i++) {
        a[i] = p[1][i] - p[0][i];
        b[i] = p[2][i] - p[0][i];
    }
    const float n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    return 0.5f * sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
}

static float face_distance(const dmg_object* object, uint32_t face, const float point[3]) {
    const float* p[3];
    face_corners(object, face, p);
    float square = 0.0f;
    for (int i = 0; i < 3; i++) {
        const float d = (p[0][i] + p[1][i] + p[2][i]) / 3.0f - point[i];
        square += d * d;
    }
    return sqrtf(square);
}

/* Gives the faces of `from` within `radius` of `point` to `to`, unless they are more than `most` of area. */
static void move_patch(dmg_object* object, uint32_t from, uint32_t to, const float point[3], float radius, float most) {
    float area = 0.0f;
    for (uint32_t f = 0; f < object->face_count; f++)
        if (object->face_part[f] == from && face_distance(object, f, point) < radius) area += face_area(object, f);
    if (area > most) return;
    for (uint32_t f = 0; f < object->face_count; f++)
        if (object->face_part[f] == from && face_distance(object, f, point) < radius) object->face_part[f] = to;
}

void lab_augment_mask(dmi_random* random, dmg_object* object, uint32_t part) {
    float area = 0.0f;
    uint32_t count = 0;
    for (uint32_t f = 0; f < object->face_count; f++)
        if (object->face_part[f] == part) {
            area += face_area(object, f);
            count++;
        }
    const float size = dmg_object_size(object);
    const int patches = 1 + (int)lab_random_uniform(random, 0.0f, 3.0f);
    for (int i = 0; i < patches; i++) {
        /* Both kinds of error are centred on the part: segmentation fails at borders and on small hardware. */
        uint32_t pick = (uint32_t)lab_random_uniform(random, 0.0f, (float)count), face = 0;
        for (uint32_t f = 0; f < object->face_count; f++)
            if (object->face_part[f] == part) {
                face = f;
                if (pick-- == 0) break;
            }
        const float* corners[3];
        face_corners(object, face, corners);
        const int lost = lab_random_bool(random, 0.5f);
        const float radius = size * lab_random_uniform(random, 0.02f, 0.12f);
        move_patch(object, lost ? part : 0, lost ? 0 : part, corners[0], radius, area / 7.0f);
    }
}
