/* Makes parts of the part ids of vertices or faces: those of the host's list, or every id that occurs. Looks parts up
 * by id and by what carries them. */
#include "mesh/mesh_read.h"

#include <string.h>

#include "base/env.h"
#include "base/sort.h"
#include "mesh/mesh.h"

/* Entries of the set of ids, which is at most half full with DM_MAX_PARTS ids. */
#define ID_SET_SIZE (2 * DM_MAX_PARTS)

/* Open-addressing set of ids above 0. */
typedef struct id_set {
    uint32_t slots[ID_SET_SIZE]; /* 0 = free */
    uint64_t ids[DM_MAX_PARTS];  /* ids in order of arrival; wide for sort_keys */
    uint32_t count;
} id_set;

/* Neighbours in a buffer mostly share their id: the last one looked up. */
typedef struct id_cache {
    uint32_t id, index;
} id_cache;

/* Heap sort: qsort of the C library may allocate behind the host's back. */
static void sort_keys(uint64_t* keys, uint32_t count) {
    for (uint32_t start = count / 2, end = count; end > 1;) {
        uint64_t key;
        if (start > 0) {
            key = keys[--start];
        } else {
            key = keys[--end];
            keys[end] = keys[0];
        }
        uint32_t hole = start;
        for (uint32_t child; (child = 2 * hole + 1) < end; hole = child) {
            if (child + 1 < end && keys[child + 1] > keys[child]) child++;
            if (keys[child] <= key) break;
            keys[hole] = keys[child];
        }
        keys[hole] = key;
    }
}

static dm_result out_of_memory(dmi_env* env, uint32_t part_count) {
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u parts", part_count);
}

/* 0 when the set is full and the id is not in it. */
static int id_set_add(id_set* set, uint32_t id) {
    uint32_t slot = (uint32_t)(id * 2654435769u) % ID_SET_SIZE;
    while (set->slots[slot] != 0) {
        if (set->slots[slot] == id) return 1;
        slot = (slot + 1) % ID_SET_SIZE;
    }
    if (set->count == DM_MAX_PARTS) return 0;
    set->slots[slot] = id;
    set->ids[set->count++] = id;
    return 1;
}

/* The body and `count` parts, all zeros. */
static dm_result make_parts(dmi_env* env, dmi_mesh* mesh, uint32_t count) {
    mesh->parts = dmi_alloc_zeroed(env, (count + 1) * sizeof(dmi_part), 64);
    if (mesh->parts == NULL) return out_of_memory(env, count);
    mesh->part_count = count + 1;
    return DM_OK;
}

/* The value two of the three share, else the smallest (dm_mesh_desc.part_ids). */
static uint32_t majority(uint32_t a, uint32_t b, uint32_t c) {
    if (a == b || a == c) return a;
    if (b == c) return b;
    uint32_t least = a < b ? a : b;
    return least < c ? least : c;
}

static uint32_t face_id(const dmi_mesh_reader* reader, const uint32_t* corners, uint32_t face) {
    if (reader->desc->part_id_scope == DM_PER_FACE) return dmi_mesh_read_part_id(reader, face);
    return majority(dmi_mesh_read_part_id(reader, corners[0]), dmi_mesh_read_part_id(reader, corners[1]),
                    dmi_mesh_read_part_id(reader, corners[2]));
}

/* Index of the part with this id; ids of no part are the body's. */
static uint32_t find_cached(const dmi_mesh* mesh, uint32_t id, id_cache* cache) {
    if (id != cache->id) {
        int32_t index = dmi_mesh_find_part(mesh, id);
        *cache = (id_cache){id, index > 0 ? (uint32_t)index : 0};
    }
    return cache->index;
}

/* ---- every id that occurs ---- */

static dm_result collect_ids(dmi_env* env, const dmi_mesh_reader* reader, dmi_mesh* mesh, id_set* set) {
    uint32_t last = 0; /* neighbours mostly share their id */
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        uint32_t id = face_id(reader, mesh->indices + (size_t)f * 3, f);
        mesh->face_part[f] = id;
        if (id == last || id == 0) continue;
        if (!id_set_add(set, id)) {
            return dmi_fail(env, DM_ERROR_TOO_LARGE, "dm_mesh_desc.part_ids: more than %d parts (face %u has id %u)",
                            DM_MAX_PARTS, f, id);
        }
        last = id;
    }
    return DM_OK;
}

/* face_part holds ids: makes them indices. */
static void ids_to_indices(dmi_mesh* mesh) {
    id_cache cache = {0, 0};
    for (uint32_t f = 0; f < mesh->face_count; f++) mesh->face_part[f] = find_cached(mesh, mesh->face_part[f], &cache);
}

static dm_result assign_all_ids(dmi_env* env, const dmi_mesh_reader* reader, int may_be_none, dmi_mesh* mesh) {
    id_set* set = dmi_scratch_alloc(env, sizeof *set);
    if (set == NULL) return out_of_memory(env, DM_MAX_PARTS);
    memset(set, 0, sizeof *set);
    dm_result result = collect_ids(env, reader, mesh, set);
    if (result == DM_OK && set->count == 0 && !may_be_none)
        result = dmi_fail(env, DM_ERROR_EMPTY_MASK, "dm_mesh_desc.part_ids: no triangle belongs to a part");
    if (result == DM_OK) result = make_parts(env, mesh, set->count);
    if (result == DM_OK) {
        sort_keys(set->ids, set->count);
        for (uint32_t i = 0; i < set->count; i++) mesh->parts[i + 1].id = (uint32_t)set->ids[i];
        ids_to_indices(mesh);
    }
    dmi_scratch_free(env, set);
    return result;
}

/* ---- the host's list ---- */

static dm_result check_list(dmi_env* env, const dm_part_desc* descs, uint32_t count) {
    if (count == 0)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_desc.part_count: 0 with a list of parts");
    if (count > DM_MAX_PARTS) {
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "dm_object_desc.part_count: %u, at most %d", count, DM_MAX_PARTS);
    }
    for (uint32_t i = 0; i < count; i++) {
        if (descs[i].id != 0) continue;
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_part_desc.id: 0 (the body) in parts[%u]", i);
    }
    return DM_OK;
}

static dm_result set_parents(dmi_env* env, const dm_part_desc* descs, uint32_t count, dmi_mesh* mesh) {
    for (uint32_t i = 0; i < count; i++) {
        int32_t parent = dmi_mesh_find_part(mesh, descs[i].parent);
        if (parent < 0) {
            return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                            "dm_part_desc.parent: %u in parts[%u] is not the id of a part", descs[i].parent, i);
        }
        mesh->parts[dmi_mesh_find_part(mesh, descs[i].id)].parent = (uint32_t)parent;
    }
    for (uint32_t p = 1; p < mesh->part_count; p++) {
        uint32_t steps = 0;
        for (uint32_t up = p; up != 0; up = mesh->parts[up].parent) {
            if (++steps < mesh->part_count) continue;
            return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_part_desc.parent: the parents of part %u form a circle",
                            mesh->parts[p].id);
        }
    }
    return DM_OK;
}

/* Sorted by id; a position in the list beside the id tells which two entries share it. */
static dm_result list_parts(dmi_env* env, const dm_part_desc* descs, uint32_t count, dmi_mesh* mesh) {
    uint64_t* keys = dmi_scratch_alloc(env, count * sizeof *keys);
    if (keys == NULL) return out_of_memory(env, count);
    for (uint32_t i = 0; i < count; i++) keys[i] = (uint64_t)descs[i].id << 32 | i;
    sort_keys(keys, count);
    dm_result result = make_parts(env, mesh, count);
    for (uint32_t i = 0; i < count && result == DM_OK; i++) {
        uint32_t id = (uint32_t)(keys[i] >> 32);
        if (id == mesh->parts[i].id) {
            result = dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_part_desc.id: %u in both parts[%u] and parts[%u]", id,
                              (uint32_t)keys[i - 1], (uint32_t)keys[i]);
        }
        mesh->parts[i + 1].id = id;
    }
    dmi_scratch_free(env, keys);
    return result;
}

static dm_result assign_listed(dmi_env* env, const dmi_mesh_reader* reader, const dm_part_desc* descs, uint32_t count,
                               dmi_mesh* mesh) {
    dm_result result = check_list(env, descs, count);
    if (result == DM_OK) result = list_parts(env, descs, count, mesh);
    if (result == DM_OK) result = set_parents(env, descs, count, mesh);
    if (result != DM_OK) return result;
    id_cache cache = {0, 0};
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t* corners = mesh->indices + (size_t)f * 3;
        if (reader->desc->part_id_scope == DM_PER_FACE) {
            mesh->face_part[f] = find_cached(mesh, dmi_mesh_read_part_id(reader, f), &cache);
            continue;
        }
        uint32_t part[3];
        for (int i = 0; i < 3; i++) part[i] = find_cached(mesh, dmi_mesh_read_part_id(reader, corners[i]), &cache);
        mesh->face_part[f] = majority(part[0], part[1], part[2]); /* rising index is rising id */
    }
    return DM_OK;
}

static dm_result count_faces(dmi_env* env, dmi_mesh* mesh) {
    for (uint32_t f = 0; f < mesh->face_count; f++) mesh->parts[mesh->face_part[f]].face_count++;
    for (uint32_t p = 1; p < mesh->part_count; p++) {
        if (mesh->parts[p].face_count > 0) continue;
        return dmi_fail(env, DM_ERROR_EMPTY_MASK, "dm_mesh_desc.part_ids: no triangle belongs to part %u",
                        mesh->parts[p].id);
    }
    return DM_OK;
}

dm_result dmi_mesh_assign_parts(dmi_env* env, const dmi_mesh_reader* reader, const dm_part_desc* descs,
                                uint32_t desc_count, dmi_mesh* mesh) {
    if (descs == NULL && desc_count > 0) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_desc.parts: NULL, but part_count is %u", desc_count);
    }
    if (reader->desc->part_ids == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_mesh_desc.part_ids: NULL");
    dm_result result =
        descs != NULL ? assign_listed(env, reader, descs, desc_count, mesh) : assign_all_ids(env, reader, 0, mesh);
    return result == DM_OK ? count_faces(env, mesh) : result;
}

dm_result dmi_mesh_assign_pieces(dmi_env* env, const dmi_mesh_reader* reader, dmi_mesh* mesh) {
    dm_result result;
    if (reader->desc->part_ids != NULL) {
        result = assign_all_ids(env, reader, 1, mesh);
    } else {
        result = make_parts(env, mesh, 0);
        memset(mesh->face_part, 0, mesh->face_count * sizeof *mesh->face_part);
    }
    for (uint32_t f = 0; f < mesh->face_count && result == DM_OK; f++) mesh->parts[mesh->face_part[f]].face_count++;
    return result;
}

dm_result dmi_mesh_assign_numbered(dmi_env* env, const dmi_mesh_reader* reader, uint32_t piece_count, dmi_mesh* mesh) {
    dm_result result = make_parts(env, mesh, piece_count);
    if (result != DM_OK) return result;
    for (uint32_t p = 1; p <= piece_count; p++) mesh->parts[p].id = p;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        mesh->face_part[f] = dmi_mesh_read_part_id(reader, f);
        if (mesh->face_part[f] > piece_count)
            return dmi_fail(env, DM_ERROR_INTERNAL, "face %u is of piece %u of %u", f, mesh->face_part[f], piece_count);
        mesh->parts[mesh->face_part[f]].face_count++;
    }
    return DM_OK;
}

int32_t dmi_mesh_find_part(const dmi_mesh* mesh, uint32_t id) {
    return dmi_find_id(&mesh->parts->id, sizeof *mesh->parts, mesh->part_count, id);
}

int dmi_mesh_moves_with(const dmi_mesh* mesh, uint32_t index, uint32_t ancestor) {
    while (index != ancestor && index != 0) index = mesh->parts[index].parent;
    return index == ancestor;
}
