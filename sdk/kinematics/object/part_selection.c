/* Copies mesh and parts, and renumbers them. */
#include "kinematics/object/object.h"

#include <string.h>

/* Numbers the parts that are kept. The others get the number of the part that carries them. Returns how many are kept,
 * the body included. */
static uint32_t number_parts(const dmi_object* object, const uint8_t* keep, uint32_t* out_number) {
    uint32_t count = 1;
    out_number[0] = 0;
    for (uint32_t i = 1; i < object->part_count; i++)
        if (keep[i]) out_number[i] = count++;
    for (uint32_t i = 1; i < object->part_count; i++) {
        uint32_t above = i;
        while (above != 0 && !keep[above]) above = object->parts[above].shape.parent;
        if (!keep[i]) out_number[i] = out_number[above];
    }
    return count;
}

/* Gives the parts of an unpacked mesh their new numbers, and measures those. */
static dm_result renumber_parts(dmi_env* env, const dmi_object* object, const uint8_t* keep, const uint32_t* number,
                                uint32_t part_count, dmi_mesh* mesh) {
    memset(mesh->parts, 0, part_count * sizeof *mesh->parts);
    for (uint32_t i = 1; i < object->part_count; i++) {
        if (!keep[i]) continue;
        mesh->parts[number[i]].id = object->parts[i].shape.id;
        mesh->parts[number[i]].parent = number[object->parts[i].shape.parent];
    }
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        mesh->face_part[f] = number[mesh->face_part[f]];
        mesh->parts[mesh->face_part[f]].face_count++;
    }
    const uint32_t room = mesh->part_count;
    mesh->part_count = part_count;
    const dm_result result = dmi_mesh_measure(env, NULL, mesh);
    mesh->part_count = room; /* the memory is freed by the count that it was allocated for */
    return result;
}

static void copy_parts(const dmi_object* object, const uint8_t* keep, const uint32_t* number, const dmi_mesh* mesh,
                       dmi_object* out) {
    dmi_object_part* parts = out->parts;
    *parts = *object->parts;
    for (uint32_t i = 1; i < object->part_count; i++)
        if (keep[i]) parts[number[i]] = object->parts[i];
    for (uint32_t i = 0; i < out->part_count; i++) parts[i].shape = mesh->parts[i];
    out->frame = object->frame;
    out->vertex_count = object->vertex_count;
    out->triangle_count = object->triangle_count;
    out->seed = object->seed;
    out->degraded = object->degraded;
    out->network_alone = object->network_alone;
    dmi_object_bound(out);
}

/* Keeps the triangles in the new numbers, and builds the trees where there is a picker. */
static dm_result keep_mesh(dmi_env* env, dmi_picker* picker, const dmi_mesh* mesh, dmi_object* out) {
    dmi_unpacked all = dmi_unpacked_of(mesh);
    all.part_count = out->part_count;
    const dm_result result = dmi_object_pack(env, &all, picker != NULL && dmi_picker_is_wide(picker), NULL, out);
    return result == DM_OK && picker != NULL ? dmi_object_make_trees(picker, NULL, NULL, out) : result;
}

static dm_result select_numbered(dmi_env* env, dmi_picker* picker, const dmi_object* object, const uint8_t* keep,
                                 const uint32_t* number, uint32_t part_count, bool keep_triangles,
                                 dmi_object** out_object) {
    dmi_object* out = NULL;
    dmi_mesh* mesh = NULL;
    dm_result result = dmi_object_create(env, part_count, &out);
    if (result == DM_OK) result = dmi_object_unpack(env, object, NULL, &mesh);
    if (result == DM_OK) result = renumber_parts(env, object, keep, number, part_count, mesh);
    if (result == DM_OK) copy_parts(object, keep, number, mesh, out);
    if (result == DM_OK && keep_triangles) result = keep_mesh(env, picker, mesh, out);
    dmi_mesh_destroy(env, mesh);
    if (result != DM_OK) {
        dmi_object_destroy(env, out);
        return result;
    }
    *out_object = out;
    return DM_OK;
}

dm_result dmi_object_select_parts(dmi_env* env, dmi_picker* picker, const dmi_object* object, const uint8_t* keep,
                                  bool keep_triangles, dmi_object** out_object) {
    const size_t size = object->part_count * sizeof(uint32_t);
    uint32_t* number = dmi_alloc(env, size, _Alignof(uint32_t));
    if (number == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u parts", object->part_count);
    const uint32_t count = number_parts(object, keep, number);
    const dm_result result = select_numbered(env, picker, object, keep, number, count, keep_triangles, out_object);
    dmi_free(env, number, size);
    return result;
}

dm_result dmi_object_reorder_parts(dmi_env* env, const dmi_object* object, const uint32_t* number,
                                   dmi_object** out_object) {
    const uint32_t count = object->part_count;
    const size_t size = count * (sizeof(uint32_t) + 1);
    uint32_t* place = dmi_alloc(env, size, _Alignof(uint32_t)); /* index before -> index now */
    if (place == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u parts", count);
    uint8_t* keep = (uint8_t*)(place + count);
    memset(keep, 1, count);
    place[0] = 0;
    for (uint32_t i = 1; i < count; i++) place[i] = number[i - 1] + 1;
    const dm_result result = select_numbered(env, NULL, object, keep, place, count, true, out_object);
    for (uint32_t i = 1; i < count && result == DM_OK; i++) (*out_object)->parts[i].shape.id = i;
    dmi_free(env, place, size);
    return result;
}
