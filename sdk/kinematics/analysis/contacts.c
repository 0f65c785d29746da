/* Finds where the part is in contact with the body: gaps, contact regions, slippage. */
#include "base/sort.h"
#include "kinematics/analysis/analysis_steps.h"

#define ABSOLUTE_GAP 0.01f     /* object sizes: limit of the first contact region; by hand */
#define RELATIVE_GAP 0.03f     /* part diagonals: limit of the second; by hand */
#define NEAREST_SHARE 20       /* the third region is the nearest 1 / 20 of the part's points; by hand */
#define MIN_SLIPPAGE_POINTS 20 /* points from which slippage is computed; by hand */

static dm_result measure_gaps(dmi_arena* arena, dmi_part_analysis* analysis) {
    analysis->gap = dmi_arena_push(arena, sizeof *analysis->gap * DMI_ANALYSIS_POINTS);
    analysis->nearest_near = dmi_arena_push(arena, sizeof *analysis->nearest_near * DMI_ANALYSIS_POINTS);
    if (analysis->gap == NULL || analysis->nearest_near == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++)
        analysis->nearest_near[i] =
            dmi_distance_grid_nearest(&analysis->body_grid, analysis->points[i], &analysis->gap[i]);
    return DM_OK;
}

static dm_result make_contact(dmi_arena* arena, float max_gap, const dmi_part_analysis* analysis, dmi_contact* out) {
    *out = (dmi_contact){0};
    out->points = dmi_arena_push(arena, sizeof *out->points * DMI_ANALYSIS_POINTS);
    float(*xyz)[3] = dmi_arena_push(arena, sizeof *xyz * DMI_ANALYSIS_POINTS);
    if (out->points == NULL || xyz == NULL) return DM_ERROR_OUT_OF_MEMORY;
    float low[3], high[3];
    dmi_analysis_empty_box(low, high);
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++) {
        if (!(analysis->gap[i] <= max_gap)) continue;
        dmi_analysis_extend_box(analysis->points[i], low, high);
        dmi_copy3(analysis->points[i], xyz[out->count]);
        out->points[out->count++] = i;
    }
    if (out->count == 0) return DM_OK;
    double variances[3];
    dmi_principal3((const float(*)[3])xyz, out->count, out->mean, variances, out->directions);
    for (int k = 0; k < 3; k++) out->box_centre[k] = (low[k] + high[k]) / 2;
    return DM_OK;
}

dm_result dmi_analysis_find_contacts(dmi_arena* arena, dmi_part_analysis* analysis) {
    const size_t size = sizeof(float) * DMI_ANALYSIS_POINTS;
    float *sorted = dmi_arena_push(arena, size), *spare = dmi_arena_push(arena, size);
    if (sorted == NULL || spare == NULL || measure_gaps(arena, analysis) != DM_OK) return DM_ERROR_OUT_OF_MEMORY;
    memcpy(sorted, analysis->gap, size);
    dmi_sort_floats(sorted, DMI_ANALYSIS_POINTS, spare);
    const float max_gaps[DMI_CONTACT_REGIONS] = {ABSOLUTE_GAP, RELATIVE_GAP * analysis->diagonal,
                                                 sorted[DMI_ANALYSIS_POINTS / NEAREST_SHARE]};
    for (int c = 0; c < DMI_CONTACT_REGIONS; c++) {
        float max_gap = isfinite(max_gaps[c]) ? max_gaps[c] : -1;
        if (make_contact(arena, max_gap, analysis, &analysis->contacts[c]) != DM_OK) return DM_ERROR_OUT_OF_MEMORY;
    }
    return DM_OK;
}

/* Computes the slippage of a contact's part side (side 0) or of the body's samples nearest to it (side 1). xyz, normal:
 * scratch for DMI_ANALYSIS_POINTS. */
static void contact_slippage(const dmi_contact* contact, int side, float (*xyz)[3], float (*normal)[3],
                             dmi_part_analysis* analysis, int slot) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < contact->count; i++) {
        uint32_t p = contact->points[i], q = analysis->nearest_near[p];
        if (side == 1 && q == UINT32_MAX) continue;
        dmi_copy3(side == 0 ? analysis->points[p] : analysis->near_points[q], xyz[count]);
        dmi_copy3(side == 0 ? analysis->normals[p] : analysis->near_normals[q], normal[count++]);
    }
    analysis->has_slippage[slot] = count >= MIN_SLIPPAGE_POINTS;
    if (!analysis->has_slippage[slot]) return;
    dmi_slippage_compute((const float(*)[3])xyz, (const float(*)[3])normal, NULL, count, &analysis->slippage[slot]);
}

dm_result dmi_analysis_find_slippage(dmi_arena* arena, dmi_part_analysis* analysis) {
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    float(*xyz)[3] = dmi_arena_push(arena, sizeof *xyz * DMI_ANALYSIS_POINTS);
    float(*normal)[3] = dmi_arena_push(arena, sizeof *normal * DMI_ANALYSIS_POINTS);
    if (xyz == NULL || normal == NULL) return DM_ERROR_OUT_OF_MEMORY;
    dmi_slippage_compute(analysis->points, analysis->normals, NULL, DMI_ANALYSIS_POINTS, &analysis->slippage[0]);
    analysis->has_slippage[0] = true;
    for (int c = 0; c < DMI_CONTACT_REGIONS; c++)
        for (int side = 0; side < 2; side++)
            contact_slippage(&analysis->contacts[c], side, xyz, normal, analysis, 1 + 2 * c + side);
    dmi_arena_rewind(arena, mark);
    return DM_OK;
}
