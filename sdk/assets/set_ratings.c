/* Rates sets by themselves, then in rounds, in view of how the others were rated in the round before. */
#include "assets/set_ratings.h"

#include <string.h>

/* Rates a set by what it is, where there are no models: every node but the largest may move. */
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
