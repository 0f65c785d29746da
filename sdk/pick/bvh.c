/* Chooses the backend of a context, which builds or restores one tree for each part, over vertices that all parts
 * share. */
#include "pick/bvh.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/sort.h"

/* ---- the backend of a context ---- */

#define MOST_BACKENDS 3 /* a choice tries, and the NULL behind them */

/* What each choice tries, in this order. */
static const dmi_pick_backend* const choices[][MOST_BACKENDS] = {
    [DM_PICK_AUTO] = {DMI_PICK_EMBREE DMI_PICK_PORTABLE NULL},
    [DM_PICK_EMBREE] = {DMI_PICK_EMBREE NULL},
    [DM_PICK_PORTABLE] = {DMI_PICK_PORTABLE NULL},
    [DM_PICK_NONE] = {NULL},
};

/* Opens the first backend that works here; leaves none, and the reason, where there is none. */
static dm_result open_backend(dmi_picker* picker, int32_t choice) {
    const dmi_pick_backend* const* backend = choices[choice];
    snprintf(picker->why, sizeof picker->why, "%s",
             choice == DM_PICK_NONE ? "the host wants none (DM_PICK_NONE)" : "this build has none (--pick)");
    for (; *backend != NULL; backend++) {
        const dm_result result = (*backend)->open(picker->env, &picker->device, picker->why, sizeof picker->why);
        if (result == DM_OK) picker->backend = *backend;
        if (result != DM_ERROR_UNSUPPORTED) return result;
    }
    return choice == DM_PICK_AUTO || choice == DM_PICK_NONE ? DM_OK : DM_ERROR_UNSUPPORTED;
}

dm_result dmi_picker_create(dmi_env* env, int32_t choice, dmi_picker** out_picker) {
    dmi_picker* picker = dmi_alloc_zeroed(env, sizeof *picker, _Alignof(dmi_picker));
    if (picker == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for the ray picker");
    picker->env = env;
    picker->choice = choice;
    dm_result result = open_backend(picker, choice);
    if (result != DM_OK) {
        result = dmi_fail(env, result, "picking: %s", picker->why);
        dmi_free(env, picker, sizeof *picker);
        return result;
    }
    *out_picker = picker;
    return DM_OK;
}

void dmi_picker_destroy(dmi_picker* picker) {
    if (picker == NULL) return;
    if (picker->backend != NULL) picker->backend->close(picker->device);
    dmi_free(picker->env, picker, sizeof *picker);
}

const char* dmi_picker_backend(const dmi_picker* picker) {
    return picker->backend != NULL ? picker->backend->name : "none";
}

/* ---- trees ---- */

int32_t dmi_bvh_find_part(const dmi_bvh* bvh, uint32_t id) {
    return dmi_find_id(&bvh->parts->id, sizeof *bvh->parts, bvh->part_count, id);
}

int32_t dmi_bvh_picking(const dmi_bvh* bvh) {
    return bvh != NULL ? bvh->backend->choice : DM_PICK_NONE;
}

/* ---- parts ---- */

static size_t bvh_size(uint32_t part_count) {
    return sizeof(dmi_bvh) + part_count * sizeof(dmi_bvh_part);
}

static dm_result allocate(dmi_env* env, const dmi_pick_backend* backend, const dmi_packed_mesh* mesh,
                          const dmi_part_ids* ids, dmi_bvh** out_bvh) {
    dmi_bvh* bvh = dmi_alloc_zeroed(env, bvh_size(mesh->part_count), DMI_ALIGNMENT);
    *out_bvh = bvh;
    if (bvh == NULL)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory to pick among %u triangles", mesh->face_count);
    bvh->env = env;
    bvh->backend = backend;
    bvh->mesh = mesh;
    bvh->part_count = mesh->part_count;
    for (uint32_t p = 0; p < mesh->part_count; p++) {
        bvh->parts[p].id = *(const uint32_t*)(const void*)((const char*)ids->first + p * ids->step);
        bvh->parts[p].first_face = mesh->parts[p].first_face;
        bvh->parts[p].first_hit = backend->first_hit;
        bvh->parts[p].mesh = mesh;
    }
    return DM_OK;
}

/* Measures the box of a part's triangles with an area. */
static void measure(const dmi_packed_mesh* mesh, const dmi_packed_part* from, dmi_bvh_part* part) {
    for (int k = 0; k < 3; k++) part->low[k] = INFINITY, part->high[k] = -INFINITY;
    for (uint32_t f = 0; f < from->solid_count; f++)
        for (int i = 0; i < 3; i++) {
            const float* p = mesh->positions + (size_t)dmi_packed_corner(mesh, from->first_face + f, i) * 3;
            for (int k = 0; k < 3; k++) {
                part->low[k] = p[k] < part->low[k] ? p[k] : part->low[k];
                part->high[k] = p[k] > part->high[k] ? p[k] : part->high[k];
            }
        }
}

static dmi_triangles triangles_of(const dmi_packed_mesh* mesh, const dmi_packed_part* part,
                                  const dmi_progress* progress) {
    const size_t first = (size_t)part->first_face * 3;
    return (dmi_triangles){.positions = mesh->positions,
                           .narrow = mesh->narrow != NULL ? mesh->narrow + first : NULL,
                           .wide = mesh->narrow != NULL ? NULL : mesh->wide + first,
                           .vertex_count = mesh->vertex_count,
                           .face_count = part->solid_count,
                           .progress = progress};
}

/* Builds the tree of a part, or restores it where there is a shape. */
static dm_result make_part(dmi_bvh* bvh, uint32_t index, const dmi_tree_shape* shapes, const dmi_progress* progress) {
    const dmi_packed_part* from = &bvh->mesh->parts[index];
    dmi_bvh_part* part = &bvh->parts[index];
    measure(bvh->mesh, from, part);
    if (from->solid_count == 0) return DM_OK;
    const float all = (float)bvh->mesh->face_count;
    const dmi_progress own =
        dmi_progress_piece(progress, (float)from->first_face / all, (float)(from->first_face + from->face_count) / all);
    const dmi_triangles triangles = triangles_of(bvh->mesh, from, &own);
    if (shapes == NULL) return bvh->backend->build(bvh->device, &triangles, &part->tree);
    return bvh->backend->restore(bvh->device, &triangles, &shapes[index], &part->tree);
}

/* ---- the whole ---- */

static dm_result create(dmi_env* env, const dmi_pick_backend* backend, void* device, const dmi_bvh_source* from,
                        const dmi_progress* progress, dmi_bvh** out_bvh) {
    dmi_bvh* bvh;
    dm_result result = allocate(env, backend, from->mesh, &from->ids, &bvh);
    if (result == DM_OK) bvh->device = device;
    for (uint32_t p = 0; result == DM_OK && p < from->mesh->part_count; p++)
        result = make_part(bvh, p, from->shapes, progress);
    if (result != DM_OK) {
        dmi_bvh_destroy(bvh);
        return result;
    }
    *out_bvh = bvh;
    return DM_OK;
}

#if defined(DMI_NO_PORTABLE)
static const dmi_pick_backend* const storing = NULL;
#else
static const dmi_pick_backend* const storing = &dmi_pick_portable;
#endif

bool dmi_picker_restores(const dmi_picker* picker) {
    return storing != NULL && picker->backend != NULL && (picker->backend == storing || picker->choice == DM_PICK_AUTO);
}

bool dmi_picker_is_wide(const dmi_picker* picker) {
    return picker->backend != NULL && picker->backend->wide;
}

dm_result dmi_bvh_create(dmi_picker* picker, const dmi_bvh_source* from, const dmi_progress* progress,
                         dmi_bvh** out_bvh) {
    *out_bvh = NULL;
    if (picker->backend == NULL) return DM_OK;
    if (from->shapes != NULL) return create(picker->env, storing, picker->env, from, progress, out_bvh);
    return create(picker->env, picker->backend, picker->device, from, progress, out_bvh);
}

dm_result dmi_bvh_create_to_store(dmi_env* env, const dmi_bvh_source* from, dmi_bvh** out_bvh) {
    *out_bvh = NULL;
    return storing != NULL ? create(env, storing, env, from, NULL, out_bvh) : DM_OK;
}

bool dmi_bvh_shapes(const dmi_bvh* bvh, uint32_t part, dmi_tree_shape* out_shape) {
    *out_shape = (dmi_tree_shape){0};
    if (bvh == NULL || bvh->backend->shape == NULL) return false;
    if (bvh->parts[part].tree != NULL) *out_shape = bvh->backend->shape(bvh->parts[part].tree);
    return true;
}

void dmi_bvh_destroy(dmi_bvh* bvh) {
    if (bvh == NULL) return;
    for (uint32_t p = 0; p < bvh->part_count; p++)
        if (bvh->parts[p].tree != NULL) bvh->backend->destroy(bvh->device, bvh->parts[p].tree);
    dmi_free(bvh->env, bvh, bvh_size(bvh->part_count));
}
