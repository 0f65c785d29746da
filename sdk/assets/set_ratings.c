/* Rates sets of nodes: first each by itself, then in rounds in view of how the other sets were rated in the round
 * before. Each set's probability is compared with those of the sets in it, around it, beside it and like it. */
#include "assets/set_ratings.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"

/* ---- context ---- */

#define LIKELY 0.35f /* probability above which a set is counted as likely; by hand */
#define SURE 0.6f
#define WORTH 0.25f /* the same as EVEN of asset_grouping.c */
#define TINY 1e-6f  /* added to divisors, against a division by 0 */

/* Relations of each set to others in the tree, one number a set. */
typedef struct relations {
    uint32_t* parent; /* UINT32_MAX: none */
    float* inside;    /* highest probability of the sets in it */
    float* around;    /* highest probability of the sets that it is in */
    float *twin_sum, *twin_count;
    float* cells;
    uint32_t *best_inside, *best_around; /* the sets that have those probabilities; UINT32_MAX: none */
    /* Cells, number and worth of the best choice among the sets in it. */
    float *inside_cells, *inside_count, *inside_worth;
} relations;

static float cells_of_set(const dmi_merge_tree* tree, uint32_t set) {
    float sum = 0;
    for (uint32_t i = 0; i < tree->size[set]; i++) sum += dmi_cells_of(tree->grid, tree->members[tree->first[set] + i]);
    return sum;
}

/* Adds to set s the better choice of its child: the child itself, or sets in the child. */
static void add_child(relations* r, const float* moves, uint32_t s, uint32_t kid) {
    if (moves[kid] > r->inside[s]) r->inside[s] = moves[kid], r->best_inside[s] = kid;
    if (r->inside[kid] > r->inside[s]) r->inside[s] = r->inside[kid], r->best_inside[s] = r->best_inside[kid];
    const float own = moves[kid] - WORTH;
    const bool itself = own > 0 && own >= r->inside_worth[kid];
    r->inside_worth[s] += itself ? own : r->inside_worth[kid];
    r->inside_cells[s] += itself ? r->cells[kid] : r->inside_cells[kid];
    r->inside_count[s] += itself ? 1 : r->inside_count[kid];
}

static dm_result open_relations(dmi_arena* arena, uint32_t count, relations* r) {
    uint32_t** const indices[] = {&r->parent, &r->best_inside, &r->best_around};
    float** const numbers[] = {&r->inside, &r->around,       &r->twin_sum,     &r->twin_count,
                               &r->cells,  &r->inside_cells, &r->inside_count, &r->inside_worth};
    for (size_t i = 0; i < sizeof indices / sizeof *indices; i++) {
        *indices[i] = dmi_arena_push(arena, (count + (size_t)1) * sizeof **indices[i]);
        if (*indices[i] == NULL) return DM_ERROR_OUT_OF_MEMORY;
        memset(*indices[i], 0xff, count * sizeof **indices[i]); /* literal: every byte of UINT32_MAX */
    }
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        *numbers[i] = dmi_arena_push(arena, (count + (size_t)1) * sizeof **numbers[i]);
        if (*numbers[i] == NULL) return DM_ERROR_OUT_OF_MEMORY;
        memset(*numbers[i], 0, count * sizeof **numbers[i]);
    }
    return DM_OK;
}

static dm_result relate(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_set_links* links, const float* moves,
                        relations* r) {
    const uint32_t count = tree->set_count;
    const dm_result result = open_relations(arena, count, r);
    if (result != DM_OK) return result;
    for (uint32_t s = 0; s < count; s++) {
        r->cells[s] = cells_of_set(tree, s);
        for (int k = 0; k < 2; k++) {
            const uint32_t kid = tree->children[s][k];
            if (kid == UINT32_MAX) continue;
            r->parent[kid] = s;
            add_child(r, moves, s, kid);
        }
    }
    for (uint32_t s = count; s-- > 0;) {
        const uint32_t up = r->parent[s];
        if (up != UINT32_MAX) {
            const bool is_up = moves[up] > r->around[up];
            r->around[s] = is_up ? moves[up] : r->around[up];
            r->best_around[s] = is_up ? up : r->best_around[up];
        }
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
    float all = 0;
    for (uint32_t n = 0; n < tree->grid->node_count; n++) all += r.cells[n];
    for (uint32_t s = 0; s < tree->set_count; s++) {
        float best = 0, sum = 0, likely = 0, sure = 0, better = 0, moving = 0;
        mark_overlaps(tree, &r, s, overlaps);
        for (uint32_t t = 0; t < tree->set_count; t++) {
            if (overlaps[t]) continue;
            const bool is_top = r.parent[t] == UINT32_MAX || moves[t] > dmi_fmaxf(r.inside[t], r.around[t]);
            best = dmi_fmaxf(best, moves[t]);
            sum += is_top ? moves[t] : 0;
            likely += is_top && moves[t] > LIKELY, sure += is_top && moves[t] > SURE;
            better += moves[t] > moves[s];
            moving += is_top && moves[t] > LIKELY ? r.cells[t] : 0;
        }
        const uint32_t in = r.best_inside[s], out_of = r.best_around[s];
        const float own = r.cells[s] + TINY;
        const float twins = r.twin_sum[links[s].twin] / r.twin_count[links[s].twin];
        const float row[DMI_CONTEXT_FEATURES] = {moves[s],
                                                 best,
                                                 sum,
                                                 likely,
                                                 sure,
                                                 better,
                                                 r.inside[s],
                                                 r.around[s],
                                                 twins,
                                                 moves[s] / (dmi_fmaxf(best, moves[s]) + TINY),
                                                 r.inside_cells[s] / own,
                                                 r.inside_count[s],
                                                 r.inside_worth[s],
                                                 in != UINT32_MAX ? r.cells[in] / own : 0,
                                                 out_of != UINT32_MAX ? own / r.cells[out_of] : 0,
                                                 r.parent[s] != UINT32_MAX ? moves[r.parent[s]] : 0,
                                                 moving / (all + TINY)};
        memcpy(out[s], row, sizeof row);
    }
    return DM_OK;
}

/* ---- ratings ---- */

/* Rates a set without models: every node except the largest may move, and no set of several nodes does. */
static float rate_by_rule(const dmi_merge_tree* tree, uint32_t set) {
    return tree->size[set] == 1 && tree->members[tree->first[set]] != tree->facts.largest ? 0.5f : 0;
}

static dm_result rate_alone(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_set_links* links,
                            const dmi_asset_models* models, const dmi_progress* progress, dmi_set_ratings* out) {
    for (uint32_t s = 0; s < tree->set_count; s++) {
        dm_result result = dmi_set_features_make(arena, tree->grid, &tree->facts, tree->members + tree->first[s],
                                                 tree->size[s], &links[s], out->features[s]);
        if (result == DM_OK) result = dmi_progress_tell(progress, (float)s / (float)tree->set_count);
        if (result != DM_OK) return result;
        out->moves[s] = models != NULL ? dmi_probability(&models->sets, out->features[s]) : rate_by_rule(tree, s);
    }
    return DM_OK;
}

static dm_result rate_in_context(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_set_links* links,
                                 const dmi_tree_ensemble* ensemble, dmi_set_ratings* out) {
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    float(*context)[DMI_CONTEXT_FEATURES] = dmi_arena_push(arena, (tree->set_count + 1) * sizeof *context);
    if (context == NULL) return DM_ERROR_OUT_OF_MEMORY;
    const dm_result result = dmi_set_context_make(arena, tree, links, out->moves, context);
    for (uint32_t s = 0; result == DM_OK && s < tree->set_count; s++) {
        memcpy(out->features[s] + DMI_SET_FEATURES, context[s], sizeof context[s]);
        out->moves[s] = dmi_probability(ensemble, out->features[s]);
    }
    dmi_arena_rewind(arena, mark);
    return result;
}

dm_result dmi_set_ratings_make(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_asset_models* models, int rounds,
                               const dmi_progress* progress, dmi_set_ratings* out) {
    const size_t count = tree->set_count;
    dmi_set_links* links = dmi_arena_push(arena, (count + 1) * sizeof *links);
    out->features = dmi_arena_push(arena, (count + 1) * sizeof *out->features);
    out->moves = dmi_arena_push(arena, (count + 1) * sizeof *out->moves);
    if (links == NULL || out->features == NULL || out->moves == NULL) return DM_ERROR_OUT_OF_MEMORY;
    dm_result result = dmi_merge_tree_links(arena, tree, links);
    if (result == DM_OK) result = rate_alone(arena, tree, links, models, progress, out);
    for (int round = 0; models != NULL && result == DM_OK && round < rounds; round++)
        result = rate_in_context(arena, tree, links, &models->context[round], out);
    return result;
}
