/* Builds one tree for each part, over vertices that all parts share. */
#include "pick/bvh.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/ids.h"

#define COPIED 0.1f /* share of the work, when the mesh is copied; measured */

static size_t positions_size(const dmi_bvh* bvh) {
    return (size_t)bvh->vertex_count * 3 * sizeof(float) + DMI_POSITION_PADDING;
}

int32_t dmi_bvh_find_part(const dmi_bvh* bvh, uint32_t id) {
    return dmi_find_id(&bvh->parts->id, sizeof *bvh->parts, bvh->part_count, id);
}

int32_t dmi_bvh_picking(const dmi_bvh* bvh) {
    return bvh != NULL ? bvh->picker->backend->choice : DM_PICK_NONE;
}

/* ---- building ---- */

static dm_result allocate(dmi_picker* picker, const dmi_mesh* mesh, dmi_bvh** out_bvh) {
    dmi_env* env = picker->env;
    dmi_bvh* bvh = dmi_alloc_zeroed(env, sizeof *bvh, DMI_ALIGNMENT);
    *out_bvh = bvh;
    if (bvh != NULL) {
        bvh->picker = picker;
        bvh->vertex_count = mesh->vertex_count;
        bvh->face_count = mesh->face_count;
        bvh->part_count = mesh->part_count;
        bvh->positions = dmi_alloc(env, positions_size(bvh), DMI_ALIGNMENT);
        bvh->faces = dmi_alloc(env, mesh->face_count * sizeof *bvh->faces, DMI_ALIGNMENT);
        bvh->parts = dmi_alloc_zeroed(env, mesh->part_count * sizeof(dmi_bvh_part), DMI_ALIGNMENT);
        if (bvh->positions != NULL && bvh->faces != NULL && bvh->parts != NULL) return DM_OK;
    }
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory to pick among %u triangles", mesh->face_count);
}

/* Whether a triangle has an area, in the numbers that the trees see. One without is never hit: where it lies in front
 * of another, rounding would decide. */
static bool has_area(const dmi_mesh* mesh, uint32_t face) {
    const uint32_t* corner = mesh->indices + (size_t)face * 3;
    double edge[2][3];
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            edge[i][k] = (double)mesh->positions[(size_t)corner[i + 1] * 3 + (size_t)k] -
                         (double)mesh->positions[(size_t)corner[0] * 3 + (size_t)k];
    for (int k = 0; k < 3; k++) {
        if (edge[0][k] * edge[1][(k + 1) % 3] != edge[0][(k + 1) % 3] * edge[1][k]) return true;
    }
    return false;
}

static void include(dmi_bvh_part* part, const float* position) {
    for (int k = 0; k < 3; k++) {
        part->low[k] = position[k] < part->low[k] ? position[k] : part->low[k];
        part->high[k] = position[k] > part->high[k] ? position[k] : part->high[k];
    }
}

static void add_face(dmi_bvh* bvh, const dmi_mesh* mesh, uint32_t face) {
    dmi_bvh_part* part = &bvh->parts[mesh->face_part[face]];
    const uint32_t place = part->first_face + part->face_count++;
    const uint32_t* corner = mesh->indices + (size_t)face * 3;
    bvh->faces[place] = (dmi_pick_face){{corner[0], corner[1], corner[2]}, face};
    for (int i = 0; i < 3; i++) include(part, bvh->positions + (size_t)corner[i] * 3);
}

/* Copies the mesh with its faces in order of their parts. */
static dm_result copy_mesh(dmi_bvh* bvh, const dmi_mesh* mesh, const dmi_progress* progress) {
    memcpy(bvh->positions, mesh->positions, (size_t)mesh->vertex_count * 3 * sizeof(float));
    memset(bvh->positions + (size_t)mesh->vertex_count * 3, 0, DMI_POSITION_PADDING);
    uint32_t first = 0;
    for (uint32_t p = 0; p < mesh->part_count; p++) {
        bvh->parts[p] = (dmi_bvh_part){.id = mesh->parts[p].id,
                                       .first_face = first,
                                       .low = {INFINITY, INFINITY, INFINITY},
                                       .high = {-INFINITY, -INFINITY, -INFINITY}};
        first += mesh->parts[p].face_count;
    }
    dm_result result = DM_OK;
    for (uint32_t f = 0; f < mesh->face_count && result == DM_OK; f++) {
        if (has_area(mesh, f)) add_face(bvh, mesh, f);
        if (f % DMI_PROGRESS_STEP == DMI_PROGRESS_STEP - 1)
            result = dmi_progress_tell(progress, (float)f / (float)mesh->face_count);
    }
    return result;
}

static dm_result build_part(dmi_bvh* bvh, dmi_bvh_part* part, const dmi_progress* progress) {
    if (part->face_count == 0) return DM_OK;
    const float first = (float)part->first_face / (float)bvh->face_count;
    const dmi_progress own =
        dmi_progress_piece(progress, first, first + (float)part->face_count / (float)bvh->face_count);
    const dmi_triangles triangles = {.positions = bvh->positions,
                                     .faces = bvh->faces + part->first_face,
                                     .vertex_count = bvh->vertex_count,
                                     .face_count = part->face_count,
                                     .progress = &own};
    return bvh->picker->backend->build(bvh->picker->device, &triangles, &part->tree);
}

dm_result dmi_bvh_create(dmi_picker* picker, const dmi_mesh* mesh, const dmi_progress* progress, dmi_bvh** out_bvh) {
    dmi_bvh* bvh;
    *out_bvh = NULL;
    if (picker->backend == NULL) return DM_OK;
    dm_result result = allocate(picker, mesh, &bvh);
    const dmi_progress copying = dmi_progress_piece(progress, 0, COPIED),
                       building = dmi_progress_piece(progress, COPIED, 1);
    if (result == DM_OK) result = copy_mesh(bvh, mesh, &copying);
    for (uint32_t p = 0; result == DM_OK && p < mesh->part_count; p++)
        result = build_part(bvh, &bvh->parts[p], &building);
    if (result != DM_OK) {
        dmi_bvh_destroy(bvh);
        return result;
    }
    *out_bvh = bvh;
    return DM_OK;
}

void dmi_bvh_destroy(dmi_bvh* bvh) {
    if (bvh == NULL) return;
    dmi_env* env = bvh->picker->env;
    for (uint32_t p = 0; bvh->parts != NULL && p < bvh->part_count; p++) {
        if (bvh->parts[p].tree != NULL) bvh->picker->backend->destroy(bvh->picker->device, bvh->parts[p].tree);
    }
    dmi_free(env, bvh->positions, positions_size(bvh));
    dmi_free(env, bvh->faces, bvh->face_count * sizeof *bvh->faces);
    dmi_free(env, bvh->parts, bvh->part_count * sizeof(dmi_bvh_part));
    dmi_free(env, bvh, sizeof *bvh);
}
