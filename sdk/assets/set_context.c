/* Compares each set's probability with those of the sets in it, around it, beside it and like it. */
#include "assets/set_context.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"

#define LIKELY 0.35f /* probabilities that are counted, and those of better sets; by hand */
#define SURE 0.6f
#define TINY 1e-6f /* no probability is divided by less */

/* Relations in the tree, one number a set. */
typedef struct relations {
    uint32_t* parent; /* UINT32_MAX: none */
    float* inside;    /* highest probability of the sets in it */
    float* around;    /* of those that it is in */
    float *twin_sum, *twin_count;
} relations;

static dm_result relate(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_set_links* links, const float* moves,
                        relations* r) {
    const size_t count = tree->set_count;
    r->parent = dmi_arena_push(arena, (count + 1) * sizeof *r->parent);
    r->inside = dmi_arena_push(arena, (count + 1) * sizeof *r->inside);
    r->around = dmi_arena_push(arena, (count + 1) * sizeof *r->around);
    r->twin_sum = dmi_arena_push(arena, (count + 1) * sizeof *r->twin_sum);
    r->twin_count = dmi_arena_push(arena, (count + 1) * sizeof *r->twin_count);
    if (r->parent == NULL || r->inside == NULL || r->around == NULL || r->twin_sum == NULL || r->twin_count == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t s = 0; s < count; s++) {
        r->parent[s] = UINT32_MAX;
        r->inside[s] = r->around[s] = r->twin_sum[s] = r->twin_count[s] = 0;
        for (int k = 0; k < 2; k++) {
            const uint32_t kid = tree->children[s][k];
            if (kid == UINT32_MAX) continue;
            r->parent[kid] = s;
            r->inside[s] = dmi_fmaxf(r->inside[s], dmi_fmaxf(r->inside[kid], moves[kid]));
        }
    }
    for (uint32_t s = (uint32_t)count; s-- > 0;) {
        const uint32_t up = r->parent[s];
        if (up != UINT32_MAX) r->around[s] = dmi_fmaxf(r->around[up], moves[up]);
        r->twin_sum[links[s].twin] += moves[s];
        r->twin_count[links[s].twin] += 1;
    }
    return DM_OK;
}

/* Marks the sets that share nodes with set s: those that it is in, and those in it. */
static void mark_overlaps(const dmi_merge_tree* tree, const relations* r, uint32_t s, uint8_t* overlaps) {
    memset(overlaps, 0, tree->set_count);
    for (uint32_t up = s; up != UINT32_MAX; up = r->parent[up]) overlaps[up] = 1;
    for (uint32_t t = s; t-- > 0;) {
        const uint32_t up = r->parent[t];
        if (up != UINT32_MAX && up <= s && overlaps[up]) overlaps[t] = 1;
    }
}

dm_result dmi_set_context_make(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_set_links* links,
                               const float* moves, float (*out)[DMI_CONTEXT_FEATURES]) {
    relations r;
    uint8_t* overlaps = dmi_arena_push(arena, tree->set_count + 1);
    const dm_result result = relate(arena, tree, links, moves, &r);
    if (result != DM_OK || overlaps == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t s = 0; s < tree->set_count; s++) {
        float best = 0, sum = 0, likely = 0, sure = 0, better = 0;
        mark_overlaps(tree, &r, s, overlaps);
        for (uint32_t t = 0; t < tree->set_count; t++) {
            if (overlaps[t]) continue;
            const bool is_top = r.parent[t] == UINT32_MAX || moves[t] > dmi_fmaxf(r.inside[t], r.around[t]);
            best = dmi_fmaxf(best, moves[t]);
            sum += is_top ? moves[t] : 0;
            likely += is_top && moves[t] > LIKELY, sure += is_top && moves[t] > SURE;
            better += moves[t] > moves[s];
        }
        const float twins = r.twin_sum[links[s].twin] / r.twin_count[links[s].twin];
        const float row[DMI_CONTEXT_FEATURES] = {
            moves[s], best,        sum,         likely, sure,
            better,   r.inside[s], r.around[s], twins,  moves[s] / (dmi_fmaxf(best, moves[s]) + TINY)};
        memcpy(out[s], row, sizeof row);
    }
    return DM_OK;
}
