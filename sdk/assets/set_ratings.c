/* Rates sets twice: each by itself, then in view of how the others were rated. */
#include "assets/set_ratings.h"

#include <string.h>

/* Without models, a set is rated by what it is: every node but the largest may move. */
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
        out->alone[s] = models != NULL ? dmi_probability(&models->sets, out->features[s]) : rate_by_rule(tree, s);
    }
    return DM_OK;
}

static dm_result rate_in_context(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_set_links* links,
                                 const dmi_asset_models* models, dmi_set_ratings* out) {
    float(*context)[DMI_CONTEXT_FEATURES] = dmi_arena_push(arena, (tree->set_count + 1) * sizeof *context);
    if (context == NULL) return DM_ERROR_OUT_OF_MEMORY;
    const dm_result result = dmi_set_context_make(arena, tree, links, out->alone, context);
    for (uint32_t s = 0; result == DM_OK && s < tree->set_count; s++) {
        memcpy(out->features[s] + DMI_SET_FEATURES, context[s], sizeof context[s]);
        out->moves[s] = models != NULL ? dmi_probability(&models->context, out->features[s]) : out->alone[s];
    }
    return result;
}

dm_result dmi_set_ratings_make(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_asset_models* models,
                               const dmi_progress* progress, dmi_set_ratings* out) {
    const size_t count = tree->set_count;
    dmi_set_links* links = dmi_arena_push(arena, (count + 1) * sizeof *links);
    out->features = dmi_arena_push(arena, (count + 1) * sizeof *out->features);
    out->alone = dmi_arena_push(arena, (count + 1) * sizeof *out->alone);
    out->moves = dmi_arena_push(arena, (count + 1) * sizeof *out->moves);
    if (links == NULL || out->features == NULL || out->alone == NULL || out->moves == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    dm_result result = dmi_merge_tree_links(arena, tree, links);
    if (result == DM_OK) result = rate_alone(arena, tree, links, models, progress, out);
    return result == DM_OK ? rate_in_context(arena, tree, links, models, out) : result;
}
