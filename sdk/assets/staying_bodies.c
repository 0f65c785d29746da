/* Chooses among the sets of the merge tree that hold no unit of a body: those that add up to the most probability. */
#include "assets/staying_bodies.h"

#include "math/elementary.h"

#define LEAST 0.05f /* probability below which a set is no answer; by hand */

typedef struct choice {
    const dmi_merge_tree* tree;
    const float* moves;
    float* worth;    /* set -> the most that can be had of it and the sets in it */
    uint8_t* chosen; /* set -> 1: it is better than the sets in it */
} choice;

static bool is_open(const dmi_merge_tree* tree, uint32_t set, const uint32_t* body_of_unit) {
    const uint32_t* members = tree->members + tree->first[set];
    for (uint32_t i = 0; i < tree->size[set]; i++)
        if (body_of_unit[members[i]] != DMI_ASSET_BODY) return false;
    return true;
}

/* Compares every set with the best choice of the sets in it: they come before it. */
static void compare_sets(choice* c, const uint32_t* body_of_unit) {
    const dmi_merge_tree* tree = c->tree;
    for (uint32_t s = 0; s < tree->set_count; s++) {
        const uint32_t* kids = tree->children[s];
        const float inside = kids[0] == UINT32_MAX ? 0 : c->worth[kids[0]] + c->worth[kids[1]];
        const float own = is_open(tree, s, body_of_unit) ? c->moves[s] - LEAST : -1;
        c->chosen[s] = own > 0 && own >= inside;
        c->worth[s] = dmi_fmaxf(own, inside);
    }
}

static uint32_t count_cells(const dmi_merge_tree* tree, uint32_t set) {
    uint32_t cells = 0;
    for (uint32_t i = 0; i < tree->size[set]; i++)
        cells += dmi_cell_count(tree->grid, tree->members[tree->first[set] + i]);
    return cells;
}

/* Lists the chosen sets from the top. One that is more than half of what is left is the body itself. */
static void list_sets(const choice* c, dmi_asset_bodies* bodies, uint32_t* body_of_unit) {
    const dmi_merge_tree* tree = c->tree;
    uint32_t left = 0;
    for (uint32_t u = 0; u < tree->grid->node_count; u++)
        if (body_of_unit[u] == DMI_ASSET_BODY) left += dmi_cell_count(tree->grid, u);
    for (uint32_t s = tree->set_count; s-- > 0;) {
        const uint32_t cells = count_cells(tree, s);
        if (!c->chosen[s] || !is_open(tree, s, body_of_unit) || cells > left / 2) continue;
        for (uint32_t i = 0; i < tree->size[s]; i++) body_of_unit[tree->members[tree->first[s] + i]] = bodies->count;
        bodies->bodies[bodies->count++] = (dmi_asset_body){.carrier = DMI_ASSET_BODY, .moves = c->moves[s]};
        left -= cells;
    }
}

dm_result dmi_list_staying_bodies(dmi_arena* arena, const dmi_merge_tree* tree, const float* moves,
                                  dmi_asset_bodies* bodies, uint32_t* inout_body_of_unit) {
    choice c = {.tree = tree, .moves = moves};
    c.worth = dmi_arena_push(arena, (tree->set_count + 1) * sizeof *c.worth);
    c.chosen = dmi_arena_push(arena, tree->set_count + 1);
    if (c.worth == NULL || c.chosen == NULL) return DM_ERROR_OUT_OF_MEMORY;
    compare_sets(&c, inout_body_of_unit);
    list_sets(&c, bodies, inout_body_of_unit);
    return DM_OK;
}
