/* Implements the builder's core: random numbers, growing arrays, frames and parts. */
#include "core/build.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* PCG32 (O'Neill 2014), one stream. */
uint32_t dmg_random(dmg_builder* b) {
    uint64_t old = b->random_state;
    b->random_state = old * 6364136223846793005ull + 1442695040888963407ull;
    uint32_t shifted = (uint32_t)(((old >> 18) ^ old) >> 27), turn = (uint32_t)(old >> 59);
    return (shifted >> turn) | (shifted << ((32 - turn) & 31));
}

float dmg_unit(dmg_builder* b) {
    return (float)(dmg_random(b) >> 8) * 0x1p-24f;
}

float dmg_range(dmg_builder* b, float low, float high) {
    return low + (high - low) * dmg_unit(b);
}

float dmg_scale_range(dmg_builder* b, float low, float high) {
    return low * expf(logf(high / low) * dmg_unit(b));
}

int dmg_int(dmg_builder* b, int low, int high) {
    return low + (int)(((uint64_t)dmg_random(b) * (uint64_t)(high - low + 1)) >> 32);
}

bool dmg_chance(dmg_builder* b, float probability) {
    return dmg_unit(b) < probability;
}

float dmg_sign(dmg_builder* b) {
    return dmg_random(b) & 0x80000000u ? 1.0f : -1.0f;
}

float dmg_normal(dmg_builder* b) {
    float radius = sqrtf(-2.0f * logf(1.0f - dmg_unit(b)));
    return radius * cosf(2.0f * DMG_PI * dmg_unit(b));
}

int dmg_weighted(dmg_builder* b, const float* weights, int count) {
    float total = 0.0f;
    for (int i = 0; i < count; ++i) total += weights[i];
    float left = total * dmg_unit(b);
    for (int i = 0; i < count; ++i) {
        left -= weights[i];
        if (left < 0.0f && weights[i] > 0.0f) return i;
    }
    return 0;
}

void dmg_builder_init(dmg_builder* b, uint64_t seed, bool messy) {
    memset(b, 0, sizeof *b);
    b->random_state = seed * 0x9e3779b97f4a7c15ull + 0x853c49e6748fea9bull;
    dmg_random(b);
    dmg_random(b);
    b->messy = messy;
    b->frames[0] = dmg_frame_identity();
    static const int levels[] = {8, 10, 12, 14, 16, 20, 24, 32, 48};
    b->sides = levels[dmg_int(b, messy ? 0 : 3, messy ? 8 : 6)];
}

void dmg_builder_free(dmg_builder* b) {
    free(b->vertices);
    free(b->indices);
    free(b->face_part);
    free(b->pieces);
    b->vertices = NULL;
    b->indices = b->face_part = NULL;
    b->pieces = NULL;
}

/* ---- frames ---- */

static dmg_frame* top(dmg_builder* b) {
    return &b->frames[b->frame_depth];
}

void dmg_save(dmg_builder* b) {
    if (b->frame_depth + 1 >= DMG_FRAME_DEPTH) {
        b->failed = true;
        return;
    }
    b->frames[b->frame_depth + 1] = b->frames[b->frame_depth];
    b->mirrored[b->frame_depth + 1] = b->mirrored[b->frame_depth];
    ++b->frame_depth;
}

void dmg_restore(dmg_builder* b) {
    if (b->frame_depth > 0) --b->frame_depth;
}

void dmg_move(dmg_builder* b, float x, float y, float z) {
    top(b)->origin = dmg_frame_point(top(b), v3(x, y, z));
}

void dmg_turn(dmg_builder* b, dmg_vec axis, float angle) {
    dmg_frame turn = dmg_frame_screw(v3(0, 0, 0), axis, angle, 0.0f);
    *top(b) = dmg_frame_multiply(top(b), &turn);
}

void dmg_mirror(dmg_builder* b, dmg_vec normal) {
    dmg_frame mirror = dmg_frame_identity();
    for (int i = 0; i < 3; ++i) {
        mirror.column[i] = v3_mad(mirror.column[i], normal, -2.0f * v3_dot(mirror.column[i], normal));
    }
    *top(b) = dmg_frame_multiply(top(b), &mirror);
    b->mirrored[b->frame_depth] = !b->mirrored[b->frame_depth];
}

void dmg_grow(dmg_builder* b, float factor) {
    for (int i = 0; i < 3; ++i) top(b)->column[i] = v3_scale(top(b)->column[i], factor);
}

void dmg_turn_to(dmg_builder* b, dmg_vec axis, int i, int count) {
    dmg_turn(b, axis, 2.0f * DMG_PI * (float)i / (float)count);
}

/* ---- parts ---- */

static bool name_taken(const dmg_builder* b, const char* name) {
    for (uint32_t i = 0; i < b->part_count; ++i) {
        if (strcmp(b->parts[i].joint.name, name) == 0) return true;
    }
    return false;
}

/* Joint names become node names: a second "button" is "button_2". */
static void unique_name(const dmg_builder* b, const char* name, char out[48]) {
    size_t length = strlen(name);
    uint32_t copy = 1;
    for (uint32_t i = 0; i < b->part_count; ++i) copy += strncmp(b->parts[i].joint.name, name, length) == 0;
    snprintf(out, 48, "%.40s", name);
    if (copy == 1) return;
    if (!name_taken(b, out)) return;
    do snprintf(out, 48, "%.40s_%u", name, copy++);
    while (name_taken(b, out));
}

static uint32_t add_part(dmg_builder* b, uint32_t parent, const char* name, int32_t type, dmg_vec origin,
                         dmg_vec axis) {
    if (b->part_count >= DMG_PART_LIMIT) {
        b->failed = true;
        return b->part_count;
    }
    dmg_part part = {0};
    unique_name(b, name, part.joint.name);
    part.joint.type = type;
    part.joint.parent = parent;
    dmg_vec direction = v3_normalize(dmg_frame_vector(top(b), axis));
    /* A mirrored turn goes the other way round: rotation axes are pseudovectors. */
    if (type != DM_JOINT_PRISMATIC && b->mirrored[b->frame_depth]) direction = v3_scale(direction, -1.0f);
    dmg_vec point = dmg_frame_point(top(b), origin);
    memcpy(part.joint.axis, &direction, sizeof part.joint.axis);
    memcpy(part.joint.origin, &point, sizeof part.joint.origin);
    part.joint.opens = 1;
    b->parts[b->part_count++] = part;
    b->part = b->part_count;
    return b->part;
}

static void set_limits(dmg_builder* b, uint32_t part, float lower, float upper) {
    b->parts[part - 1].joint.lower = lower;
    b->parts[part - 1].joint.upper = upper;
}

uint32_t dmg_hinge(dmg_builder* b, uint32_t parent, const char* name, dmg_vec origin, dmg_vec axis, float lower,
                   float upper) {
    uint32_t part = add_part(b, parent, name, DM_JOINT_REVOLUTE, origin, axis);
    set_limits(b, part, lower, upper);
    return part;
}

uint32_t dmg_hinge_either_way(dmg_builder* b, uint32_t parent, const char* name, dmg_vec origin, dmg_vec axis,
                              float least, float most) {
    const float upper = dmg_range(b, least, most), lower = -dmg_range(b, least, most);
    return dmg_hinge(b, parent, name, origin, axis, lower, upper);
}

uint32_t dmg_slide(dmg_builder* b, uint32_t parent, const char* name, dmg_vec direction, float lower, float upper) {
    uint32_t part = add_part(b, parent, name, DM_JOINT_PRISMATIC, v3(0, 0, 0), direction);
    float scale = v3_length(dmg_frame_vector(top(b), v3_normalize(direction)));
    set_limits(b, part, lower * scale, upper * scale);
    return part;
}

uint32_t dmg_spin(dmg_builder* b, uint32_t parent, const char* name, dmg_vec origin, dmg_vec axis) {
    return add_part(b, parent, name, DM_JOINT_CONTINUOUS, origin, axis);
}

uint32_t dmg_screw(dmg_builder* b, uint32_t parent, const char* name, dmg_vec origin, dmg_vec axis, float pitch,
                   float lower, float upper) {
    uint32_t part = add_part(b, parent, name, DM_JOINT_SCREW, origin, axis);
    /* A mirrored screw is left-handed: the pitch changes its sign along the turned-round axis. */
    float sign = b->mirrored[b->frame_depth] ? -1.0f : 1.0f;
    b->parts[part - 1].joint.pitch = sign * pitch * v3_length(dmg_frame_vector(top(b), v3_normalize(axis)));
    set_limits(b, part, lower, upper);
    return part;
}

void dmg_use(dmg_builder* b, uint32_t part) {
    b->part = part;
}

void dmg_rest(dmg_builder* b, uint32_t part, float value) {
    b->parts[part - 1].rest = value;
}

void dmg_keep_rest(dmg_builder* b, uint32_t part) {
    b->parts[part - 1].keep_rest = true;
}

dmg_frame dmg_joint_frame(const dmg_joint* joint, float value) {
    dmg_vec axis = v3_from(joint->axis);
    dmg_vec origin = v3_from(joint->origin);
    if (joint->type == DM_JOINT_PRISMATIC) return dmg_frame_screw(origin, axis, 0.0f, value);
    return dmg_frame_screw(origin, axis, value, joint->type == DM_JOINT_SCREW ? value * joint->pitch : 0.0f);
}

float dmg_joint_stop(const dmg_joint* joint, int stop, int stops) {
    if (joint->type == DM_JOINT_CONTINUOUS) return 2.0f * DMG_PI * (float)stop / (float)stops;
    return joint->lower + (joint->upper - joint->lower) * (float)stop / (float)(stops - 1);
}

/* ---- geometry ---- */

static bool reserve(dmg_builder* b, void** array, uint32_t count, uint32_t* capacity, size_t size) {
    if (count < *capacity) return true;
    uint32_t wanted = *capacity ? *capacity * 2 : 1024;
    void* grown = realloc(*array, wanted * size);
    if (!grown) {
        b->failed = true;
        return false;
    }
    *array = grown;
    *capacity = wanted;
    return true;
}

dmg_bounds dmg_bounds_none(void) {
    return (dmg_bounds){{1e30f, 1e30f, 1e30f}, {-1e30f, -1e30f, -1e30f}};
}

void dmg_bounds_grow(dmg_bounds* bounds, dmg_vec p) {
    bounds->low = v3(fminf(bounds->low.x, p.x), fminf(bounds->low.y, p.y), fminf(bounds->low.z, p.z));
    bounds->high = v3(fmaxf(bounds->high.x, p.x), fmaxf(bounds->high.y, p.y), fmaxf(bounds->high.z, p.z));
}

uint32_t dmg_piece_end(const dmg_builder* b, uint32_t piece) {
    return piece + 1 < b->piece_count ? b->pieces[piece + 1].first_vertex : b->vertex_count;
}

uint32_t dmg_piece_face_end(const dmg_builder* b, uint32_t piece) {
    return piece + 1 < b->piece_count ? b->pieces[piece + 1].first_face : b->face_count;
}

dmg_bounds dmg_part_bounds(const dmg_builder* b, uint32_t part) {
    dmg_bounds out = dmg_bounds_none();
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        if (b->pieces[p].part != part) continue;
        for (uint32_t v = b->pieces[p].first_vertex; v < dmg_piece_end(b, p); ++v) {
            dmg_bounds_grow(&out, b->vertices[v]);
        }
    }
    return out;
}

void dmg_piece_begin(dmg_builder* b) {
    if (!reserve(b, (void**)&b->pieces, b->piece_count, &b->piece_capacity, sizeof *b->pieces)) return;
    b->pieces[b->piece_count] = (dmg_piece){b->vertex_count, b->face_count, b->part, b->piece_count};
    ++b->piece_count;
}

uint32_t dmg_vertex(dmg_builder* b, dmg_vec position) {
    if (!reserve(b, (void**)&b->vertices, b->vertex_count, &b->vertex_capacity, sizeof *b->vertices)) return 0;
    b->vertices[b->vertex_count] = dmg_frame_point(top(b), position);
    return b->vertex_count++;
}

/* Both face arrays share one capacity. */
static bool reserve_face(dmg_builder* b) {
    if (b->face_count < b->face_capacity) return true;
    uint32_t wanted = b->face_capacity ? b->face_capacity * 2 : 1024;
    uint32_t* indices = realloc(b->indices, (size_t)wanted * 3 * sizeof *indices);
    if (indices) b->indices = indices;
    uint32_t* face_part = realloc(b->face_part, wanted * sizeof *face_part);
    if (face_part) b->face_part = face_part;
    if (!indices || !face_part || wanted > 2 * DMG_FACE_LIMIT) {
        b->failed = true;
        return false;
    }
    b->face_capacity = wanted;
    return true;
}

void dmg_triangle(dmg_builder* b, uint32_t i, uint32_t j, uint32_t k) {
    if (b->failed || !reserve_face(b)) return;
    bool mirrored = b->mirrored[b->frame_depth];
    uint32_t* face = b->indices + (size_t)b->face_count * 3;
    face[0] = i;
    face[1] = mirrored ? k : j;
    face[2] = mirrored ? j : k;
    b->face_part[b->face_count++] = b->part;
}

void dmg_quad(dmg_builder* b, uint32_t i, uint32_t j, uint32_t k, uint32_t l) {
    dmg_triangle(b, i, j, k);
    dmg_triangle(b, i, k, l);
}
