/* Divides a mesh into sheets, and a sheet into its smooth regions. */
#include "segmentation/pieces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mesh/connectivity.h"

#define WELD_DISTANCE 1e-5f /* object sizes; by hand */
#define CREASE_COSINE 0.8f  /* cosine of the angle between normals (37 degrees) at which smooth regions end; by hand */
#define REPEAT_AREA_TOLERANCE 1e-3f /* relative difference of the areas of repeated pieces; by hand */
#define MIN_REPEAT_AREA 1e-5f       /* share of the whole area below which no piece counts as repeated; by hand */
#define SHELLS_ONLY (-2)            /* cosine that makes dmi_face_regions connect over vertices */
#define NO_BYTE 0xff                /* memset value that makes every uint32_t DMI_PIECE_NONE */

typedef struct piece_area {
    float area;
    uint32_t piece;
} piece_area;

static dm_result out_of_memory(const dmi_arena* arena, const dmi_mesh* mesh) {
    return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to divide %u triangles into pieces",
                    mesh->face_count);
}

dm_result dmi_mesh_sheets_make(dmi_arena* arena, const dmi_mesh* mesh, const dmi_progress* progress,
                               dmi_mesh_sheets* out) {
    const dmi_progress welding = dmi_progress_piece(progress, 0, DMI_STAGE_SHEETS_WELDED),
                       uniting = dmi_progress_piece(progress, DMI_STAGE_SHEETS_WELDED, DMI_STAGE_SHEETS_FOUND),
                       joining = dmi_progress_piece(progress, DMI_STAGE_SHEETS_FOUND, 1);
    uint32_t shell_count;
    *out = (dmi_mesh_sheets){.mesh = mesh};
    out->welded = dmi_arena_push(arena, mesh->vertex_count * sizeof *out->welded);
    out->labels = dmi_arena_push(arena, mesh->face_count * sizeof *out->labels);
    out->shells = dmi_arena_push(arena, mesh->face_count * sizeof *out->shells);
    uint8_t* all = dmi_arena_push(arena, mesh->face_count);
    if (out->welded == NULL || out->labels == NULL || out->shells == NULL || all == NULL)
        return out_of_memory(arena, mesh);
    memset(all, 1, mesh->face_count);
    dm_result result = dmi_weld_vertices(arena, mesh, WELD_DISTANCE, &welding, out->welded);
    if (result == DM_OK)
        result = dmi_face_sheets_and_fans(arena, mesh, out->welded, &uniting, out->labels, &out->count);
    if (result == DM_OK) result = dmi_progress_tell(&joining, 0);
    if (result != DM_OK) return result;
    return dmi_face_regions(arena, mesh, out->welded, all, SHELLS_ONLY, &joining, out->shells, &shell_count);
}

/* Replaces the label `cut` by labels of the sheet's smooth regions: the first region keeps the label, the others get
 * new ones from *count on. */
static dm_result cut_sheet(dmi_arena* arena, const dmi_mesh_sheets* sheets, uint32_t cut, const dmi_progress* progress,
                           uint32_t* labels, uint32_t* count) {
    const dmi_mesh* mesh = sheets->mesh;
    uint32_t* regions = dmi_arena_push(arena, mesh->face_count * sizeof *regions);
    uint8_t* select = dmi_arena_push(arena, mesh->face_count);
    uint32_t region_count;
    if (regions == NULL || select == NULL) return out_of_memory(arena, mesh);
    for (uint32_t f = 0; f < mesh->face_count; f++) select[f] = labels[f] == cut;
    dm_result result =
        dmi_face_regions(arena, mesh, sheets->welded, select, CREASE_COSINE, progress, regions, &region_count);
    if (result != DM_OK) return result;
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (select[f] && regions[f] > 0) labels[f] = *count + regions[f] - 1;
    if (region_count > 1) *count += region_count - 1;
    return DM_OK;
}

static int compare_areas(const void* a, const void* b) {
    const piece_area *x = a, *y = b;
    if (x->area != y->area) return x->area < y->area ? -1 : 1;
    return x->piece < y->piece ? -1 : x->piece > y->piece;
}

/* Lists for each piece others whose area is the same within the tolerance. */
static dm_result find_repeats(dmi_arena* arena, dmi_piece_level* level) {
    const uint32_t count = level->pieces.count;
    piece_area* sorted = dmi_arena_push(arena, count * sizeof *sorted);
    level->repeats = dmi_arena_push(arena, count * sizeof *level->repeats);
    if (sorted == NULL || level->repeats == NULL) return out_of_memory(arena, level->pieces.mesh);
    for (uint32_t p = 0; p < count; p++) sorted[p] = (piece_area){level->pieces.area[p], p};
    qsort(sorted, count, sizeof *sorted, compare_areas);
    memset(level->repeats, NO_BYTE, count * sizeof *level->repeats);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t found = 0, *repeats = level->repeats[sorted[i].piece];
        if (sorted[i].area < MIN_REPEAT_AREA * level->total_area) continue;
        const float tolerance = sorted[i].area * REPEAT_AREA_TOLERANCE;
        for (uint32_t step = 1; step <= DMI_PIECE_MAX_REPEATS && found < DMI_PIECE_MAX_REPEATS; step++) {
            if (i + step < count && sorted[i + step].area - sorted[i].area < tolerance)
                repeats[found++] = sorted[i + step].piece;
            if (found < DMI_PIECE_MAX_REPEATS && step <= i && sorted[i].area - sorted[i - step].area < tolerance)
                repeats[found++] = sorted[i - step].piece;
        }
    }
    return DM_OK;
}

dm_result dmi_piece_level_make(dmi_arena* arena, const dmi_mesh_sheets* sheets, uint32_t cut,
                               const dmi_progress* progress, dmi_piece_level* out) {
    const dmi_progress cutting = dmi_progress_piece(progress, 0, DMI_STAGE_LEVEL_SHEET_CUT),
                       sampling = dmi_progress_piece(progress, DMI_STAGE_LEVEL_SHEET_CUT, 1);
    const uint32_t face_count = sheets->mesh->face_count;
    uint32_t count = sheets->count;
    *out = (dmi_piece_level){.sheet_is_cut = cut != DMI_PIECE_NONE};
    uint32_t* labels = dmi_arena_push(arena, face_count * sizeof *labels);
    if (labels == NULL) return out_of_memory(arena, sheets->mesh);
    memcpy(labels, sheets->labels, face_count * sizeof *labels);
    dm_result result = out->sheet_is_cut ? cut_sheet(arena, sheets, cut, &cutting, labels, &count) : DM_OK;
    if (result == DM_OK && out->sheet_is_cut && count == sheets->count) return DM_OK;
    if (result == DM_OK) result = dmi_progress_tell(&sampling, 0);
    if (result == DM_OK) result = dmi_pieces_make(arena, sheets->mesh, labels, count, &out->pieces);
    if (result != DM_OK) return result;
    result = dmi_progress_tell(&sampling, DMI_STAGE_LEVEL_SAMPLED);
    if (result != DM_OK) return result;
    out->sheets = dmi_arena_push(arena, count * sizeof *out->sheets);
    out->shells = dmi_arena_push(arena, count * sizeof *out->shells);
    if (out->sheets == NULL || out->shells == NULL) return out_of_memory(arena, sheets->mesh);
    for (uint32_t f = 0; f < face_count; f++) {
        out->sheets[labels[f]] = sheets->labels[f];
        out->shells[labels[f]] = sheets->shells[f];
    }
    for (uint32_t p = 0; p < count; p++) out->total_area += out->pieces.area[p];
    return find_repeats(arena, out);
}
