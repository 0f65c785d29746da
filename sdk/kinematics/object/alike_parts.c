/* Compares parts vertex by vertex, and their surroundings by moments of the surface in the near box, which do not
 * depend on how it is cut into triangles. */
#include "kinematics/object/prepare_steps.h"

#include <math.h>
#include <string.h>

#include "kinematics/analysis/part_analysis.h"
#include "math/linear3.h"

#define SAME_VERTEX 1e-4f /* longest sides of the part, between two vertices that count as the same; by hand */
/* Difference of moments in units of half the near box; by hand: a screw's head in a door's box. */
#define SAME_MOMENT 3e-4f
#define LEAST_SIDE 1e-6f /* object sizes: avoids a division by zero */
#define MOST_CORNERS 9   /* most corners of a triangle that is cut by the six sides of a box */
enum { MOMENTS = 19 };   /* area, its first and second moments, and those of normals by area */

/* A part's shape and its surroundings. */
typedef struct look {
    uint32_t part;
    float corner[3], side; /* the box's lower corner; its longest side */
    float moments[MOMENTS];
} look;

typedef struct search {
    const dmi_mesh* mesh;
    const dmi_object* object;
    uint32_t *faces, *first; /* faces sorted by part; per part, its first */
    look* looks;             /* looks that differ from each other */
    uint32_t count;
} search;

/* ---- surroundings ---- */

/* Cuts a polygon by a plane across an axis: keeps what lies at or above `limit` on the side of `sign`. */
static uint32_t cut_polygon(float (*corners)[3], uint32_t count, int axis, float sign, float limit) {
    float kept[MOST_CORNERS + 1][3];
    uint32_t out = 0;
    for (uint32_t i = 0; i < count; i++) {
        const float *a = corners[i], *b = corners[(i + 1) % count];
        const float above = sign * a[axis] - limit, next = sign * b[axis] - limit;
        if (above >= 0) dmi_copy3(a, kept[out++]);
        if ((above >= 0) == (next >= 0)) continue;
        const float share = above / (above - next);
        for (int k = 0; k < 3; k++) kept[out][k] = a[k] + share * (b[k] - a[k]);
        out++;
    }
    memcpy(corners, kept, out * sizeof *kept);
    return out;
}

/* Adds the moments of a triangle with a unit normal. */
static void add_triangle(const float a[3], const float b[3], const float c[3], const float normal[3],
                         float moments[MOMENTS]) {
    float ab[3], ac[3], across[3], sum[3];
    dmi_sub3(b, a, ab);
    dmi_sub3(c, a, ac);
    dmi_cross3(ab, ac, across);
    const float area = 0.5f * dmi_length3(across);
    for (int k = 0; k < 3; k++) sum[k] = a[k] + b[k] + c[k];
    int at = 0;
    moments[at++] += area;
    for (int k = 0; k < 3; k++) moments[at++] += area * sum[k] / 3;
    for (int k = 0; k < 3; k++) moments[at++] += area * normal[k];
    for (int i = 0; i < 3; i++)
        for (int k = i; k < 3; k++) {
            /* literal: divisor of the integral of two coordinates' product over a triangle */
            moments[at++] += area / 12 * (a[i] * a[k] + b[i] * b[k] + c[i] * c[k] + sum[i] * sum[k]);
            moments[at++] += area * normal[i] * normal[k];
        }
}

/* Adds the moments of what lies of a face in the box round 0 whose half sides are 1. */
static void add_face(const search* s, uint32_t face, const float middle[3], const float half[3],
                     float moments[MOMENTS]) {
    float corners[MOST_CORNERS + 1][3];
    uint32_t count = 3;
    for (uint32_t i = 0; i < 3; i++) {
        const float* at = s->mesh->positions + 3 * (size_t)s->mesh->indices[3 * (size_t)face + i];
        for (int k = 0; k < 3; k++) corners[i][k] = (at[k] - middle[k]) / half[k];
    }
    for (int k = 0; k < 3 && count > 0; k++) {
        count = cut_polygon(corners, count, k, 1, -1);
        if (count > 0) count = cut_polygon(corners, count, k, -1, -1);
    }
    for (uint32_t i = 2; i < count; i++)
        add_triangle(corners[0], corners[i - 1], corners[i], s->mesh->face_normal + 3 * (size_t)face, moments);
}

static bool boxes_meet(const float low[3], const float high[3], const float other_low[3], const float other_high[3]) {
    for (int k = 0; k < 3; k++)
        if (low[k] > other_high[k] || other_low[k] > high[k]) return false;
    return true;
}

static void measure_look(const search* s, uint32_t part, look* out) {
    const dmi_part* shape = &s->object->parts[part].shape;
    float low[3], high[3], middle[3], half[3];
    *out = (look){.part = part, .side = LEAST_SIDE};
    dmi_copy3(shape->box_min, out->corner);
    for (int k = 0; k < 3; k++) out->side = dmi_max(out->side, shape->box_max[k] - shape->box_min[k]);
    dmi_part_near_box(shape->box_min, shape->box_max, low, high);
    for (int k = 0; k < 3; k++) middle[k] = 0.5f * (low[k] + high[k]), half[k] = 0.5f * (high[k] - low[k]);
    for (uint32_t p = 0; p < s->object->part_count; p++) {
        const dmi_part* other = &s->object->parts[p].shape;
        if (p == part || !boxes_meet(low, high, other->box_min, other->box_max)) continue;
        for (uint32_t f = s->first[p]; f < s->first[p + 1]; f++) add_face(s, s->faces[f], middle, half, out->moments);
    }
}

/* ---- comparison ---- */

static bool same_hints(const dmi_object_part* a, const dmi_object_part* b) {
    return a->given_type == b->given_type && a->asset_hints.label.kind == b->asset_hints.label.kind &&
           a->asset_hints.label.depth == b->asset_hints.label.depth &&
           a->asset_hints.label.modifiers.own == b->asset_hints.label.modifiers.own &&
           a->asset_hints.label.modifiers.above == b->asset_hints.label.modifiers.above;
}

static bool same_shape(const search* s, const look* a, const look* b) {
    const uint32_t count = s->first[a->part + 1] - s->first[a->part];
    if (count != s->first[b->part + 1] - s->first[b->part]) return false;
    for (uint32_t f = 0; f < count; f++)
        for (uint32_t i = 0; i < 3; i++) {
            const uint32_t* indices = s->mesh->indices;
            const uint32_t u = indices[3 * (size_t)s->faces[s->first[a->part] + f] + i],
                           v = indices[3 * (size_t)s->faces[s->first[b->part] + f] + i];
            for (int k = 0; k < 3; k++) {
                const float x = s->mesh->positions[3 * (size_t)u + (size_t)k] - a->corner[k],
                            y = s->mesh->positions[3 * (size_t)v + (size_t)k] - b->corner[k];
                if (!(fabsf(x - y) <= SAME_VERTEX * a->side)) return false;
            }
        }
    return true;
}

static bool are_alike(const search* s, const look* a, const look* b) {
    const float tolerance = SAME_MOMENT * (1 + a->moments[0]);
    for (int i = 0; i < MOMENTS; i++)
        if (!(fabsf(a->moments[i] - b->moments[i]) <= tolerance)) return false;
    return same_hints(&s->object->parts[a->part], &s->object->parts[b->part]) && same_shape(s, a, b);
}

/* Marks the parts that are carried, carry others, or have a pivot. They are like no other part. */
static void exclude_parts(const dmi_object* object, uint8_t* alone) {
    for (uint32_t i = 1; i < object->part_count; i++) {
        const uint32_t parent = object->parts[i].shape.parent;
        if (parent != 0) alone[i] = alone[parent] = 1;
        if (object->parts[i].asset_hints.has_pivot) alone[i] = 1;
    }
}

/* Sorts the faces by part, by a counting sort. first has two entries more than there are parts. */
static void sort_faces(const dmi_mesh* mesh, search* s) {
    memset(s->first, 0, ((size_t)mesh->part_count + 2) * sizeof *s->first);
    for (uint32_t f = 0; f < mesh->face_count; f++) s->first[mesh->face_part[f] + 2]++;
    for (uint32_t p = 0; p < mesh->part_count; p++) s->first[p + 2] += s->first[p + 1];
    for (uint32_t f = 0; f < mesh->face_count; f++) s->faces[s->first[mesh->face_part[f] + 1]++] = f;
}

dm_result dmi_alike_parts_find(dmi_arena* arena, const dmi_mesh* mesh, const dmi_object* object,
                               const uint8_t* excluded, const dmi_progress* progress, uint32_t* out_like) {
    search s = {.mesh = mesh, .object = object};
    uint8_t* alone = dmi_arena_push(arena, object->part_count);
    s.faces = dmi_arena_push(arena, mesh->face_count * sizeof *s.faces);
    s.first = dmi_arena_push(arena, ((size_t)object->part_count + 2) * sizeof *s.first);
    s.looks = dmi_arena_push(arena, object->part_count * sizeof *s.looks);
    if (alone == NULL || s.faces == NULL || s.first == NULL || s.looks == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to compare %u parts", object->part_count);
    memcpy(alone, excluded, object->part_count);
    exclude_parts(object, alone);
    sort_faces(mesh, &s);
    for (uint32_t i = 0; i < object->part_count; i++) out_like[i] = i;
    for (uint32_t i = 1; i < object->part_count; i++) {
        uint32_t same = 0;
        if (alone[i]) continue;
        look* own = &s.looks[s.count];
        measure_look(&s, i, own);
        while (same < s.count && !are_alike(&s, &s.looks[same], own)) same++;
        if (same < s.count)
            out_like[i] = s.looks[same].part;
        else
            s.count++;
        const dm_result result = dmi_progress_tell(progress, 0);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

/* ---- answers ---- */

void dmi_alike_part_copy(dmi_object* object, uint32_t from, uint32_t to) {
    const dmi_object_part* source = &object->parts[from];
    dmi_object_part* part = &object->parts[to];
    float shift[3];
    dmi_sub3(part->shape.box_min, source->shape.box_min, shift);
    part->hypotheses = source->hypotheses;
    part->alternatives = source->alternatives;
    for (uint32_t i = 0; i < part->hypotheses.count; i++) {
        dm_vec3* origin = &part->hypotheses.joints[i].origin;
        *origin = (dm_vec3){origin->x + shift[0], origin->y + shift[1], origin->z + shift[2]};
    }
    for (uint32_t i = 0; i < part->alternatives.count; i++)
        for (int k = 0; k < 3; k++) part->alternatives.list[i].origin[k] += shift[k];
    float points[DMI_PART_POINTS][3];
    dmi_part_points_place(&source->points, points);
    for (uint32_t i = 0; i < DMI_PART_POINTS; i++)
        for (int k = 0; k < 3; k++) points[i][k] += shift[k];
    dmi_part_points_take((const float(*)[3])points, 1, &part->points);
    part->joint = dmi_frame_joint_out(&object->frame, &part->hypotheses.joints[0]);
}
