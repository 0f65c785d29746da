/* Checks for collisions by winding numbers (van Oosterom and Strackee 1983) and for detachment by distances, both
 * over surface samples. It is slow, and shares no code with the generator. */
#include "core/check.h"

#include <float.h>
#include <stdbool.h>
#include <stdlib.h>

#include "core/build.h"

enum { POINTS = 40, STOPS = 5 };

typedef struct sample {
    dmg_vec at[POINTS];
    uint32_t count;
} sample;

static dmg_vec vertex(const dmg_object* o, uint32_t face, uint32_t corner) {
    const float* p = o->positions + (size_t)o->indices[3 * face + corner] * 3;
    return v3_from(p);
}

static bool moves_with(const dmg_object* o, uint32_t part, uint32_t carrier) {
    while (part != 0 && part != carrier) part = o->joints[part - 1].parent;
    return part == carrier;
}

static float face_area(const dmg_object* o, uint32_t face) {
    dmg_vec a = vertex(o, face, 0);
    return 0.5f * v3_length(v3_cross(v3_sub(vertex(o, face, 1), a), v3_sub(vertex(o, face, 2), a)));
}

/* Samples points evenly over the faces that move with the part, or over those that do not. */
static void take_sample(const dmg_object* o, uint32_t part, bool moving, sample* out) {
    float area = 0.0f, done = 0.0f;
    for (uint32_t f = 0; f < o->face_count; ++f) {
        if (moves_with(o, o->face_part[f], part) == moving) area += face_area(o, f);
    }
    out->count = 0;
    for (uint32_t f = 0; f < o->face_count && out->count < POINTS; ++f) {
        if (moves_with(o, o->face_part[f], part) != moving) continue;
        done += face_area(o, f);
        while (out->count < POINTS && done > area * ((float)out->count + 0.5f) / POINTS) {
            /* A low-discrepancy walk over the triangle (Roberts 2018). */
            float n = (float)out->count + 1.0f, u = fmodf(0.7548777f * n, 1.0f), w = fmodf(0.5698403f * n, 1.0f);
            if (u + w > 1.0f) {
                u = 1.0f - u;
                w = 1.0f - w;
            }
            dmg_vec a = vertex(o, f, 0), side = v3_scale(v3_sub(vertex(o, f, 1), a), u);
            out->at[out->count++] = v3_mad(v3_add(a, side), v3_sub(vertex(o, f, 2), a), w);
        }
    }
}

/* Returns the winding number of the body: 1 inside a closed shell, 0 outside, more inside several. */
static float body_winding(const dmg_object* o, dmg_vec p) {
    float sum = 0.0f;
    for (uint32_t f = 0; f < o->face_count; ++f) {
        if (o->face_part[f] != 0) continue;
        dmg_vec a = v3_sub(vertex(o, f, 0), p), b = v3_sub(vertex(o, f, 1), p), c = v3_sub(vertex(o, f, 2), p);
        float la = v3_length(a), lb = v3_length(b), lc = v3_length(c);
        float below = la * lb * lc + v3_dot(a, b) * lc + v3_dot(b, c) * la + v3_dot(c, a) * lb;
        sum += 2.0f * atan2f(v3_dot(a, v3_cross(b, c)), below);
    }
    return sum / (4.0f * DMG_PI);
}

/* Returns the squared distance of a point to a triangle. */
static float triangle_distance(dmg_vec p, dmg_vec a, dmg_vec b, dmg_vec c) {
    const dmg_vec corners[3] = {a, b, c};
    dmg_vec n = v3_cross(v3_sub(b, a), v3_sub(c, a));
    bool inside = true;
    float best = FLT_MAX;
    for (int i = 0; i < 3; ++i) {
        dmg_vec from = corners[i], edge = v3_sub(corners[(i + 1) % 3], from), to = v3_sub(p, from);
        inside = inside && v3_dot(v3_cross(n, edge), to) >= 0.0f;
        float length = v3_dot(edge, edge), t = length > 0.0f ? v3_dot(to, edge) / length : 0.0f;
        dmg_vec off = v3_mad(to, edge, -fmaxf(0.0f, fminf(1.0f, t)));
        best = fminf(best, v3_dot(off, off));
    }
    float height = v3_dot(v3_sub(p, a), n), square = v3_dot(n, n);
    return inside && square > 0.0f ? height * height / square : best;
}

static float surface_distance(const dmg_object* o, uint32_t part, bool moving, bool body, dmg_vec p) {
    float best = FLT_MAX;
    for (uint32_t f = 0; f < o->face_count; ++f) {
        bool taken = body ? o->face_part[f] == 0 : moves_with(o, o->face_part[f], part) == moving;
        if (taken) best = fminf(best, triangle_distance(p, vertex(o, f, 0), vertex(o, f, 1), vertex(o, f, 2)));
    }
    return sqrtf(best);
}

/* Returns the smallest distance between samples of the moved part and the rest, and of the rest and the part moved
 * back. */
static float part_gap(const dmg_object* o, uint32_t part, const sample* moving, const sample* still,
                      const dmg_frame* there, const dmg_frame* back) {
    float best = FLT_MAX;
    for (uint32_t i = 0; i < moving->count; ++i) {
        dmg_vec p = dmg_frame_point(there, moving->at[i]);
        best = fminf(best, surface_distance(o, part, false, false, p));
    }
    for (uint32_t i = 0; i < still->count; ++i) {
        dmg_vec p = dmg_frame_point(back, still->at[i]);
        best = fminf(best, surface_distance(o, part, true, false, p));
    }
    return best;
}

/* Returns how deep the deepest of the moved points lies in the body. */
static float deepest(const dmg_object* o, uint32_t part, const sample* moving, const dmg_frame* there) {
    float depth = 0.0f;
    for (uint32_t i = 0; i < moving->count; ++i) {
        dmg_vec p = dmg_frame_point(there, moving->at[i]);
        if (body_winding(o, p) > 0.5f) depth = fmaxf(depth, surface_distance(o, part, false, true, p));
    }
    return depth;
}

/* Returns the joint's value at a stop of its range. */
static float stop_value(const dmg_joint* joint, int stop) {
    float share = (float)stop / (STOPS - 1);
    if (joint->type == DM_JOINT_CONTINUOUS) return 2.0f * DMG_PI * share;
    return joint->lower + (joint->upper - joint->lower) * share;
}

int dmg_check(const dmg_object* object, uint32_t part, dmg_finding* out) {
    *out = (dmg_finding){0};
    if (part == 0 || part > object->joint_count) return 1;
    const dmg_joint* joint = &object->joints[part - 1];
    sample* samples = malloc(2 * sizeof *samples);
    if (!samples) return 1;
    take_sample(object, part, true, &samples[0]);
    take_sample(object, part, false, &samples[1]);
    const float size = out->size = dmg_object_size(object);
    const dmg_frame rest = dmg_frame_identity();
    const float near = part_gap(object, part, &samples[0], &samples[1], &rest, &rest);
    const float sunk = deepest(object, part, &samples[0], &rest);
    for (int stop = 0; stop < STOPS; ++stop) {
        const float value = stop_value(joint, stop);
        const dmg_frame there = dmg_joint_frame(joint, value), back = dmg_joint_frame(joint, -value);
        const float gap = part_gap(object, part, &samples[0], &samples[1], &there, &back) - near;
        const float depth = deepest(object, part, &samples[0], &there) - sunk;
        out->gap = fmaxf(out->gap, gap / size);
        if (depth <= out->depth * size) continue;
        out->depth = depth / size;
        out->depth_value = value;
    }
    free(samples);
    return 0;
}
