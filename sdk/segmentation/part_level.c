/* Takes a mesh apart into sheets, and a sheet into its smooth regions. */
#include "segmentation/part_level.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mesh/connectivity.h"

#define WELD 1e-5f         /* of the object's size */
#define CREASE_COSINE 0.8f /* smooth regions end where neighbouring faces turn by more than 37 degrees */
#define ALIKE 1e-3f        /* twins' areas differ by less */
#define SPECK 1e-5f        /* of the whole area: too small to be called a twin */

typedef struct sized {
    float area;
    uint32_t piece;
} sized;

static dm_result out_of_memory(const dmi_arena* arena, const dmi_mesh* mesh) {
    return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to take %u triangles apart", mesh->face_count);
}

dm_result dmi_part_sheets_make(dmi_arena* arena, const dmi_mesh* mesh, dmi_part_sheets* out) {
    uint32_t shell_count;
    *out = (dmi_part_sheets){.mesh = mesh};
    out->welded = dmi_arena_push(arena, mesh->vertex_count * sizeof *out->welded);
    out->labels = dmi_arena_push(arena, mesh->face_count * sizeof *out->labels);
    out->shells = dmi_arena_push(arena, mesh->face_count * sizeof *out->shells);
    uint8_t* all = dmi_arena_push(arena, mesh->face_count);
    if (out->welded == NULL || out->labels == NULL || out->shells == NULL || all == NULL)
        return out_of_memory(arena, mesh);
    memset(all, 1, mesh->face_count);
    dm_result result = dmi_weld_vertices(arena, mesh, WELD, out->welded);
    if (result == DM_OK) result = dmi_face_sheets(arena, mesh, out->welded, out->labels, &out->count);
    return result == DM_OK ? dmi_face_regions(arena, mesh, out->welded, all, -2, out->shells, &shell_count) : result;
}

/* Labels with the sheet `cut` replaced by its regions: the first takes its label, the others new ones. */
static dm_result cut_sheet(dmi_arena* arena, const dmi_part_sheets* sheets, uint32_t cut, uint32_t* labels,
                           uint32_t* count) {
    const dmi_mesh* mesh = sheets->mesh;
    uint32_t* regions = dmi_arena_push(arena, mesh->face_count * sizeof *regions);
    uint8_t* select = dmi_arena_push(arena, mesh->face_count);
    uint32_t region_count;
    if (regions == NULL || select == NULL) return out_of_memory(arena, mesh);
    for (uint32_t f = 0; f < mesh->face_count; f++) select[f] = labels[f] == cut;
    dm_result result = dmi_face_regions(arena, mesh, sheets->welded, select, CREASE_COSINE, regions, &region_count);
    if (result != DM_OK) return result;
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (select[f] && regions[f] > 0) labels[f] = *count + regions[f] - 1;
    if (region_count > 1) *count += region_count - 1;
    return DM_OK;
}

static int by_area(const void* a, const void* b) {
    const sized *x = a, *y = b;
    if (x->area != y->area) return x->area < y->area ? -1 : 1;
    return x->piece < y->piece ? -1 : x->piece > y->piece;
}

static dm_result find_twins(dmi_arena* arena, dmi_part_level* level) {
    const uint32_t count = level->pieces.count;
    sized* sorted = dmi_arena_push(arena, count * sizeof *sorted);
    level->twins = dmi_arena_push(arena, count * sizeof *level->twins);
    if (sorted == NULL || level->twins == NULL) return out_of_memory(arena, level->pieces.mesh);
    for (uint32_t p = 0; p < count; p++) sorted[p] = (sized){level->pieces.area[p], p};
    qsort(sorted, count, sizeof *sorted, by_area);
    memset(level->twins, 0xff, count * sizeof *level->twins);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t found = 0;
        if (sorted[i].area < SPECK * level->total_area) continue;
        for (uint32_t step = 1; step <= DMI_PART_TWINS && found < DMI_PART_TWINS; step++) {
            const float most = sorted[i].area * ALIKE;
            if (i + step < count && sorted[i + step].area - sorted[i].area < most)
                level->twins[sorted[i].piece][found++] = sorted[i + step].piece;
            if (found < DMI_PART_TWINS && step <= i && sorted[i].area - sorted[i - step].area < most)
                level->twins[sorted[i].piece][found++] = sorted[i - step].piece;
        }
    }
    return DM_OK;
}

dm_result dmi_part_level_make(dmi_arena* arena, const dmi_part_sheets* sheets, uint32_t cut, dmi_part_level* out) {
    const uint32_t face_count = sheets->mesh->face_count;
    uint32_t count = sheets->count;
    *out = (dmi_part_level){.fine = cut != DMI_PART_NONE};
    uint32_t* labels = dmi_arena_push(arena, face_count * sizeof *labels);
    if (labels == NULL) return out_of_memory(arena, sheets->mesh);
    memcpy(labels, sheets->labels, face_count * sizeof *labels);
    dm_result result = out->fine ? cut_sheet(arena, sheets, cut, labels, &count) : DM_OK;
    if (result == DM_OK && out->fine && count == sheets->count) return DM_OK;
    if (result == DM_OK) result = dmi_pieces_make(arena, sheets->mesh, labels, count, &out->pieces);
    if (result != DM_OK) return result;
    out->sheets = dmi_arena_push(arena, count * sizeof *out->sheets);
    out->shells = dmi_arena_push(arena, count * sizeof *out->shells);
    if (out->sheets == NULL || out->shells == NULL) return out_of_memory(arena, sheets->mesh);
    for (uint32_t f = 0; f < face_count; f++) {
        out->sheets[labels[f]] = sheets->labels[f];
        out->shells[labels[f]] = sheets->shells[f];
    }
    for (uint32_t p = 0; p < count; p++) out->total_area += out->pieces.area[p];
    return find_twins(arena, out);
}
