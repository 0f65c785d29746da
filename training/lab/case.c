/* Makes training cases: draws an object of the requested split, augments it, and passes it through the library's own
 * mesh check and cloud sampler. */
#include <string.h>

#include "case.h"
#include "kinematics/analysis/part_analysis.h"
#include "kinematics/inference/hypotheses.h"
#include "lab_ranker.h"
#include "mesh/connectivity.h"
#include "mesh/mesh_repair.h"

#define TRIES 64

/* Hashes two numbers into one (SplitMix64's finaliser). */
static uint64_t mix(uint64_t a, uint64_t b) {
    uint64_t x = a * 0x9e3779b97f4a7c15u + b + 0x2545f4914f6cdd1du;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/* Draws the id of a category by the weights of the options; -1 when they allow none. Goes through ids in rising order,
 * so that the order of the generator's rows does not matter. */
static int32_t draw_category_id(dmi_random* random, const dm_lab_options* options) {
    const uint32_t limit = dmg_category_id_limit();
    uint32_t total = 0;
    for (uint32_t id = 0; id < limit; id++) total += options->categories[id];
    if (total == 0) return -1;
    uint32_t pick = dmi_random_u32(random) % total;
    for (uint32_t id = 0; id < limit; id++) {
        if (pick < options->categories[id]) return (int32_t)id;
        pick -= options->categories[id];
    }
    return -1;
}

/* Draws a seed whose object belongs to the split. row: of the generator's category. */
static uint64_t draw_object_seed(dmi_random* random, uint32_t row, int32_t split) {
    uint64_t seed;
    do seed = dmi_random_u32(random);
    while (dmg_split(row, seed) != split);
    return seed;
}

/* Converts the object to the library's checked mesh, with parts and their parents. */
static dm_result make_mesh(dmi_env* env, const dmg_object* object, dmi_mesh** out_mesh) {
    const dm_mesh_desc desc = {.struct_size = sizeof desc,
                               .positions = object->positions,
                               .vertex_count = object->vertex_count,
                               .indices = object->indices,
                               .index_count = 3ull * object->face_count,
                               .part_ids = object->face_part,
                               .part_id_scope = DM_PER_FACE};
    dmi_axes axes;
    if (!dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 1.0f)) return DM_ERROR_INTERNAL;
    const size_t bytes = (object->joint_count + 1) * sizeof(dm_part_desc);
    dm_part_desc* parts = dmi_alloc_zeroed(env, bytes, _Alignof(dm_part_desc));
    if (!parts) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t j = 0; j < object->joint_count; j++) {
        parts[j].struct_size = sizeof(dm_part_desc);
        parts[j].id = j + 1;
        parts[j].parent = object->joints[j].parent;
    }
    const dm_result result = dmi_mesh_create(env, &axes, &desc, parts, object->joint_count, NULL, out_mesh);
    dmi_free(env, parts, bytes);
    return result;
}

/* Welds the vertices and repairs the part mask as the library does. */
static dm_result weld_and_repair(dmi_env* env, lab_case* out) {
    dmi_mesh *mesh = out->mesh, repaired = *mesh;
    out->welded = dmi_alloc(env, mesh->vertex_count * sizeof *out->welded, _Alignof(uint32_t));
    if (out->welded == NULL) return DM_ERROR_OUT_OF_MEMORY;
    dmi_arena arena;
    dmi_arena_init(&arena, env, (size_t)1 << 16);
    dm_result result = dmi_weld_vertices(&arena, mesh, DMI_WELD_TOLERANCE, NULL, out->welded);
    if (result == DM_OK) result = dmi_mesh_repair(&arena, mesh, out->welded, NULL, &repaired);
    if (result == DM_OK && repaired.face_part != mesh->face_part) {
        memcpy(mesh->face_part, repaired.face_part, mesh->face_count * sizeof *mesh->face_part);
        memcpy(mesh->parts, repaired.parts, mesh->part_count * sizeof *mesh->parts);
    }
    dmi_arena_release(&arena);
    return result;
}

static dm_joint flipped(dm_joint joint) {
    const float lower = joint.lower;
    joint.axis = (dm_vec3){-joint.axis.x, -joint.axis.y, -joint.axis.z};
    joint.lower = -joint.upper;
    joint.upper = -lower;
    return joint;
}

/* Returns the true joint in the object-normalised frame, signed so that positive opens. */
static dm_joint true_joint(const dmi_mesh* mesh, const dmg_joint* source, uint32_t part_index) {
    dm_joint joint = {.type = source->type,
                      .type_confidence = 1.0f,
                      .joint_confidence = 1.0f,
                      .pitch = source->pitch,
                      .axis = {source->axis[0], source->axis[1], source->axis[2]},
                      .origin = {source->origin[0], source->origin[1], source->origin[2]},
                      .lower = source->lower,
                      .upper = source->upper};
    joint = dmi_frame_joint_in(&mesh->frame, &joint);
    if (source->opens < 0) joint = flipped(joint);
    dmi_joint_set_origin_near(&joint, mesh->parts[part_index].centre);
    return joint;
}

static dm_result try_case(dmi_env* env, const dm_lab_options* options, lab_case* out) {
    dmi_random* random = &out->random;
    const int32_t id = draw_category_id(random, options);
    const int32_t row = id < 0 ? -1 : dmg_category_with_id((uint32_t)id);
    if (row < 0) return DM_ERROR_INVALID_ARGUMENT;
    out->category_id = (uint32_t)id;
    const uint64_t seed = draw_object_seed(random, (uint32_t)row, options->split);
    const uint32_t flags = lab_random_bool(random, options->messy) ? DMG_MESSY : 0;
    if (dmg_make((uint32_t)row, seed, flags, &out->object)) return DM_ERROR_OUT_OF_MEMORY;
    if (out->object.joint_count == 0) return DM_ERROR_NOT_FOUND;
    out->part = 1 + dmi_random_u32(random) % out->object.joint_count;
    const dmg_joint* joint = &out->object.joints[out->part - 1];
    if (joint->type < DM_JOINT_REVOLUTE || joint->type > DM_JOINT_CONTINUOUS) return DM_ERROR_NOT_FOUND;
    lab_rotation((const float[3]){0, 0, 1}, 0, out->rotation);
    if (lab_random_bool(random, options->rotated)) lab_rotate_object(random, &out->object, out->rotation);
    if (lab_random_bool(random, options->mask_noise)) lab_augment_mask(random, &out->object, out->part);
    dm_result result = make_mesh(env, &out->object, &out->mesh);
    if (result == DM_OK) result = weld_and_repair(env, out);
    if (result != DM_OK) return result;
    const int32_t index = dmi_mesh_find_part(out->mesh, out->part);
    if (index < 1) return DM_ERROR_NOT_FOUND;
    out->joint = true_joint(out->mesh, joint, (uint32_t)index);
    return dmi_cloud_sample(env, out->mesh, (uint32_t)index, dmi_random_u32(random), &out->cloud);
}

dm_result lab_case_make(dmi_env* env, const dm_lab_options* options, uint64_t index, lab_case* out_case) {
    dm_result result = DM_ERROR_INTERNAL;
    for (uint64_t attempt = 0; attempt < TRIES; attempt++) {
        memset(out_case, 0, sizeof *out_case);
        out_case->random = dmi_random_make(mix(options->seed, index), attempt);
        result = try_case(env, options, out_case);
        if (result == DM_OK) break;
        lab_case_release(env, out_case);
    }
    return result;
}

dm_result lab_case_given(dmi_env* env, const dm_lab_given* given, lab_case* out_case) {
    dmg_joint joint = {.type = given->type, .lower = given->lower, .upper = given->upper, .opens = 1};
    memcpy(joint.axis, given->axis, sizeof joint.axis);
    memcpy(joint.origin, given->origin, sizeof joint.origin);
    memset(out_case, 0, sizeof *out_case);
    const dmg_object object = {.positions = (float*)given->positions,
                               .indices = (uint32_t*)given->indices,
                               .face_part = (uint32_t*)given->face_part,
                               .vertex_count = given->vertex_count,
                               .face_count = given->face_count,
                               .joints = &joint,
                               .joint_count = 1};
    out_case->part = 1;
    out_case->random = dmi_random_make(1, 1);
    dm_result result = make_mesh(env, &object, &out_case->mesh);
    if (result != DM_OK) return result;
    out_case->joint = true_joint(out_case->mesh, &joint, (uint32_t)dmi_mesh_find_part(out_case->mesh, 1));
    result =
        dmi_cloud_sample(env, out_case->mesh, (uint32_t)dmi_mesh_find_part(out_case->mesh, 1), 1, &out_case->cloud);
    if (result != DM_OK) dmi_mesh_destroy(env, out_case->mesh);
    return result;
}

void lab_case_release(dmi_env* env, lab_case* made) {
    if (made->welded != NULL) dmi_free(env, made->welded, made->mesh->vertex_count * sizeof *made->welded);
    dmi_mesh_destroy(env, made->mesh);
    dmg_object_release(&made->object);
    made->mesh = NULL;
    made->welded = NULL;
}

dmi_drag_hint lab_given_drag(lab_case* made, const dm_lab_given* given, float noise_degrees, dm_joint* out_joint) {
    const float degrees = lab_random_uniform(&made->random, 0.0f, noise_degrees) * dmi_random_normal(&made->random);
    float about[3], rotation[9], vector[3];
    lab_random_direction(&made->random, about);
    lab_rotation(about, degrees * 0.01745329f, rotation);
    lab_rotate(rotation, given->drag_vector, vector);
    const double point[3] = {given->drag_point[0], given->drag_point[1], given->drag_point[2]};
    dmi_drag_hint hint;
    dmi_frame_point_in(&made->mesh->frame, point, hint.point);
    dmi_frame_vector_in(&made->mesh->frame, vector, hint.vector);
    *out_joint = made->joint;
    dmi_joint_orient(out_joint, &hint);
    return hint;
}
