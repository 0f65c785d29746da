/* Measures an asset as a whole. */
#include "assets/asset_facts.h"

#include <math.h>

#include "math/elementary.h"

#define ALIKE 0.02f             /* relative difference of extents and areas of twins; by hand */
#define LEAST_DIFFERENCE 0.001f /* least difference of extents that counts, in object sizes; by hand */

/* Sorts three numbers, largest first. */
static void sort3(float v[3]) {
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < 2; k++)
            if (v[k] < v[k + 1]) {
                const float t = v[k];
                v[k] = v[k + 1], v[k + 1] = t;
            }
}

void dmi_sorted_extents(const float low[3], const float high[3], float out[3]) {
    for (int k = 0; k < 3; k++) out[k] = high[k] - low[k];
    sort3(out);
}

static bool is_close(float a, float b) {
    return fabsf(a - b) <= ALIKE * dmi_fmaxf(fabsf(a), fabsf(b)) + LEAST_DIFFERENCE;
}

bool dmi_shapes_are_alike(const float low_a[3], const float high_a[3], float area_a, const float low_b[3],
                          const float high_b[3], float area_b) {
    float a[3], b[3];
    dmi_sorted_extents(low_a, high_a, a);
    dmi_sorted_extents(low_b, high_b, b);
    if (fabsf(area_a - area_b) > ALIKE * dmi_fmaxf(area_a, area_b)) return false;
    return is_close(a[0], b[0]) && is_close(a[1], b[1]) && is_close(a[2], b[2]);
}

dm_result dmi_asset_facts_make(dmi_arena* arena, const dmi_node_cells* g, const dmi_node_labels* labels,
                               dmi_asset_facts* out) {
    *out = (dmi_asset_facts){.node_count = g->node_count, .cell_count = g->first[g->node_count], .labels = labels};
    out->alike = dmi_arena_push(arena, (g->node_count + 1) * sizeof *out->alike);
    if (out->alike == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (int k = 0; k < 3; k++) out->low[k] = INFINITY, out->high[k] = -INFINITY;
    for (uint32_t n = 0; n < g->node_count; n++) {
        for (int k = 0; k < 3; k++) {
            out->low[k] = dmi_fminf(out->low[k], g->low_of[n][k]);
            out->high[k] = dmi_fmaxf(out->high[k], g->high_of[n][k]);
        }
        out->area += g->area[n];
        if (dmi_cells_of(g, n) > dmi_cells_of(g, out->largest)) out->largest = n;
        out->alike[n] = 0;
        for (uint32_t m = 0; m < g->node_count; m++)
            out->alike[n] += m != n && dmi_shapes_are_alike(g->low_of[n], g->high_of[n], g->area[n], g->low_of[m],
                                                            g->high_of[m], g->area[m]);
    }
    out->largest_share = out->cell_count > 0 ? dmi_cells_of(g, out->largest) / (float)out->cell_count : 0;
    return DM_OK;
}
