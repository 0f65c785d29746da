/* Sorts faces by their parts, and keeps corners in as few bits as they need. */
#include "mesh/packed_mesh.h"

#include <string.h>

#include "base/env.h"

/* Faces on their way into a packed mesh. */
typedef struct packing {
    const dmi_unpacked* from;
    dmi_packed_mesh* to;
    uint8_t* solid; /* a face: whether it has an area */
    bool in_order;  /* the faces are sorted as they are */
} packing;

dmi_unpacked dmi_unpacked_of(const dmi_mesh* mesh) {
    return (dmi_unpacked){mesh->positions,    mesh->indices,    mesh->face_part,
                          mesh->vertex_count, mesh->face_count, mesh->part_count};
}

/* ---- memory ---- */

static size_t positions_size(const dmi_packed_mesh* packed) {
    return (size_t)packed->vertex_count * 3 * sizeof(float) + DMI_POSITION_PADDING;
}

void dmi_packed_mesh_destroy(dmi_env* env, dmi_packed_mesh* packed) {
    if (packed == NULL) return;
    const size_t faces = packed->face_count;
    dmi_free(env, packed->positions, positions_size(packed));
    dmi_free(env, packed->narrow, faces * 3 * sizeof *packed->narrow);
    dmi_free(env, packed->wide, faces * 3 * sizeof *packed->wide);
    dmi_free(env, packed->of_mesh, faces * sizeof *packed->of_mesh);
    dmi_free(env, packed->parts, packed->part_count * sizeof *packed->parts);
    dmi_free(env, packed, sizeof *packed);
}

static dm_result out_of_memory(dmi_env* env, uint32_t faces) {
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory to keep %u triangles", faces);
}

static dm_result allocate(dmi_env* env, const dmi_unpacked* from, bool wide, dmi_packed_mesh** out_packed) {
    dmi_packed_mesh* packed = dmi_alloc_zeroed(env, sizeof *packed, _Alignof(dmi_packed_mesh));
    *out_packed = packed;
    if (packed == NULL) return out_of_memory(env, from->face_count);
    const size_t faces = packed->face_count = from->face_count;
    packed->vertex_count = from->vertex_count;
    packed->part_count = from->part_count;
    packed->positions = dmi_alloc(env, positions_size(packed), DMI_ALIGNMENT);
    packed->parts = dmi_alloc_zeroed(env, from->part_count * sizeof *packed->parts, DMI_ALIGNMENT);
    if (wide || from->vertex_count > DMI_NARROW_VERTICES)
        packed->wide = dmi_alloc(env, faces * 3 * sizeof *packed->wide, DMI_ALIGNMENT);
    else
        packed->narrow = dmi_alloc(env, faces * 3 * sizeof *packed->narrow, DMI_ALIGNMENT);
    const bool has_corners = packed->wide != NULL || packed->narrow != NULL;
    return packed->positions && packed->parts && has_corners ? DM_OK : out_of_memory(env, from->face_count);
}

/* ---- packing ---- */

/* Whether a triangle has an area, in the numbers that the trees see. One without is never hit: where it lies in front
 * of another, rounding would decide. */
static bool has_area(const dmi_unpacked* from, uint32_t face) {
    const uint32_t* corner = from->indices + (size_t)face * 3;
    const float* a = from->positions + (size_t)corner[0] * 3;
    double edge[2][3];
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            edge[i][k] = (double)from->positions[(size_t)corner[i + 1] * 3 + (size_t)k] - (double)a[k];
    for (int k = 0; k < 3; k++) {
        if (edge[0][k] * edge[1][(k + 1) % 3] != edge[0][(k + 1) % 3] * edge[1][k]) return true;
    }
    return false;
}

/* Counts the faces of each part, and sees whether they are in order. */
static dm_result count_faces(packing* p, const dmi_progress* progress) {
    const dmi_unpacked* from = p->from;
    uint32_t last = 0;
    p->in_order = true;
    for (uint32_t f = 0; f < from->face_count; f++) {
        const uint32_t part = from->face_part[f];
        dmi_packed_part* to = &p->to->parts[part];
        p->solid[f] = has_area(from, f);
        p->in_order = p->in_order && part >= last && !(p->solid[f] && to->solid_count < to->face_count);
        last = part;
        to->face_count++;
        to->solid_count += p->solid[f];
        if (dmi_progress_step(progress, f, from->face_count) != DM_OK) return DM_ERROR_CANCELLED;
    }
    uint32_t first = 0;
    for (uint32_t i = 0; i < from->part_count; i++) {
        p->to->parts[i].first_face = first;
        first += p->to->parts[i].face_count;
    }
    return DM_OK;
}

static void put_face(dmi_packed_mesh* to, uint32_t place, const uint32_t corner[3]) {
    for (size_t i = 0; i < 3; i++) {
        if (to->narrow != NULL)
            to->narrow[(size_t)place * 3 + i] = (uint16_t)corner[i];
        else
            to->wide[(size_t)place * 3 + i] = corner[i];
    }
}

static void put_in_order(const packing* p) {
    for (uint32_t f = 0; f < p->from->face_count; f++) put_face(p->to, f, p->from->indices + (size_t)f * 3);
}

/* next: of each part, the places of its next face with an area and of its next one without. */
static void put_sorted(const packing* p, uint32_t (*next)[2]) {
    for (uint32_t i = 0; i < p->from->part_count; i++) {
        const dmi_packed_part* part = &p->to->parts[i];
        next[i][1] = part->first_face;
        next[i][0] = part->first_face + part->solid_count;
    }
    for (uint32_t f = 0; f < p->from->face_count; f++) {
        const uint32_t place = next[p->from->face_part[f]][p->solid[f]]++;
        put_face(p->to, place, p->from->indices + (size_t)f * 3);
        p->to->of_mesh[place] = f;
    }
}

static dm_result put_faces(dmi_env* env, const packing* p) {
    if (p->in_order) {
        put_in_order(p);
        return DM_OK;
    }
    const size_t size = p->from->face_count * sizeof *p->to->of_mesh;
    uint32_t(*next)[2] = dmi_scratch_alloc(env, p->from->part_count * sizeof *next);
    p->to->of_mesh = dmi_alloc(env, size, DMI_ALIGNMENT);
    const bool room = next != NULL && p->to->of_mesh != NULL;
    if (room) put_sorted(p, next);
    dmi_scratch_free(env, next);
    return room ? DM_OK : out_of_memory(env, p->from->face_count);
}

static dm_result pack(dmi_env* env, const dmi_unpacked* from, const dmi_progress* progress, dmi_packed_mesh* to) {
    packing p = {.from = from, .to = to, .solid = dmi_scratch_alloc(env, from->face_count)};
    if (p.solid == NULL) return out_of_memory(env, from->face_count);
    memcpy(to->positions, from->positions, (size_t)from->vertex_count * 3 * sizeof(float));
    memset(to->positions + (size_t)from->vertex_count * 3, 0, DMI_POSITION_PADDING);
    dm_result result = count_faces(&p, progress);
    if (result == DM_OK) result = put_faces(env, &p);
    dmi_scratch_free(env, p.solid);
    return result;
}

dm_result dmi_packed_mesh_create(dmi_env* env, const dmi_unpacked* from, bool wide, const dmi_progress* progress,
                                 dmi_packed_mesh** out_packed) {
    dmi_packed_mesh* packed;
    dm_result result = allocate(env, from, wide, &packed);
    if (result == DM_OK) result = pack(env, from, progress, packed);
    if (result != DM_OK) {
        dmi_packed_mesh_destroy(env, packed);
        return result;
    }
    *out_packed = packed;
    return DM_OK;
}

void dmi_packed_mesh_unpack(const dmi_packed_mesh* packed, dmi_mesh* mesh) {
    memcpy(mesh->positions, packed->positions, (size_t)packed->vertex_count * 3 * sizeof(float));
    for (uint32_t p = 0; p < packed->part_count; p++) {
        const dmi_packed_part* part = &packed->parts[p];
        for (uint32_t f = part->first_face; f < part->first_face + part->face_count; f++) {
            const uint32_t face = dmi_packed_of_mesh(packed, f);
            for (int i = 0; i < 3; i++) mesh->indices[(size_t)face * 3 + (size_t)i] = dmi_packed_corner(packed, f, i);
            mesh->face_part[face] = p;
        }
    }
}
