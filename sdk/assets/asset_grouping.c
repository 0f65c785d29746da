/* Chooses among the sets of the merge tree the bodies that move, and those that might. */
#include "assets/asset_grouping.h"

#include <math.h>
#include <string.h>

#include "assets/merge_tree.h"
#include "assets/node_cells.h"
#include "math/elementary.h"

/* Probability from which a set is answered, which is stated as one half. Bodies that are found and those that are
 * missed weigh alike (F1), so that a set is worth an answer although it is less likely than not; on generated assets of
 * kinds held out. */
#define EVEN 0.25f

/* Probability that is stated as LIKELY_STATED: what is answered and as likely as not keeps close to one half. On the
 * same assets. */
#define LIKELY 0.5f
#define LIKELY_STATED 0.58f

#define LEAST 0.05f /* probability below which a set is no answer; by hand */

#define NOTHING 0xff /* every byte of an index that is none */

/* ---- units: nodes with faces, or nodes that are one body for certain ---- */

/* A fixed node is of one unit with the nearest one above it that has faces. */
static uint32_t unit_above(const dmi_asset_query* q, const dmi_asset_units* u, uint32_t node) {
    while (node != DMI_ASSET_BODY && u->of_node[node] == UINT32_MAX) node = q->nodes[node].parent;
    return node == DMI_ASSET_BODY ? UINT32_MAX : u->of_node[node];
}

static dm_result list_units(const dmi_asset_query* q, dmi_asset_units* out) {
    const uint32_t count = q->node_count;
    out->of_node = dmi_arena_push(q->arena, (count + 1) * sizeof *out->of_node);
    out->of_part = dmi_arena_push(q->arena, (count + 2) * sizeof *out->of_part);
    out->node = dmi_arena_push(q->arena, (count + 1) * sizeof *out->node);
    uint32_t* of_given = dmi_arena_push(q->arena, (count + 1) * sizeof *of_given);
    if (out->of_node == NULL || out->of_part == NULL || out->node == NULL || of_given == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    memset(out->of_node, NOTHING, count * sizeof *out->of_node);
    memset(out->of_part, NOTHING, (count + 1) * sizeof *out->of_part);
    memset(of_given, NOTHING, count * sizeof *of_given);
    out->count = 0;
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t n = q->order[k];
        const dmi_asset_node* node = &q->nodes[n];
        if (q->mesh->parts[n + 1].face_count == 0) continue;
        uint32_t unit = node->is_fixed ? unit_above(q, out, node->parent) : UINT32_MAX;
        if (unit == UINT32_MAX && node->given_body != DMI_ASSET_BODY) unit = of_given[node->given_body];
        if (unit == UINT32_MAX) out->node[unit = out->count++] = n;
        if (node->given_body != DMI_ASSET_BODY) of_given[node->given_body] = unit;
        out->of_node[n] = out->of_part[n + 1] = unit;
    }
    return DM_OK;
}

static bool has_given(const dmi_asset_query* q, const dmi_asset_units* u, const uint32_t* members, uint32_t count) {
    for (uint32_t i = 0; i < count; i++)
        if (q->nodes[u->node[members[i]]].given_body != DMI_ASSET_BODY) return true;
    return false;
}

/* ---- choosing sets ---- */

/* Returns what is stated for a probability: itself below EVEN, at least one half from there on. */
static float state(float probability) {
    if (probability < EVEN) return probability;
    if (probability < LIKELY) return 0.5f + (LIKELY_STATED - 0.5f) * (probability - EVEN) / (LIKELY - EVEN);
    return LIKELY_STATED + (1 - LIKELY_STATED) * (probability - LIKELY) / (1 - LIKELY);
}

typedef struct choice {
    const dmi_merge_tree* tree;
    const float* moves; /* set -> probability that it is a body that moves */
    float* worth;       /* set -> the most that can be had of it and the sets in it */
    uint8_t* chosen;    /* set -> 1: it is better than the sets in it */
} choice;

/* Rates the sets. One that holds a given node is a body only when it is that node alone. */
static dm_result rate_sets(const dmi_asset_query* q, const dmi_asset_units* u, const dmi_merge_tree* tree,
                           float* out_moves) {
    const dmi_progress rating = dmi_progress_piece(q->progress, DMI_STAGE_GROUP_PAIRS_RATED, 1);
    dmi_set_ratings ratings;
    const dm_result result = dmi_set_ratings_make(q->arena, tree, q->models, DMI_CONTEXT_ROUNDS, &rating, &ratings);
    for (uint32_t s = 0; result == DM_OK && s < tree->set_count; s++) {
        const uint32_t* members = tree->members + tree->first[s];
        out_moves[s] =
            has_given(q, u, members, tree->size[s]) ? (tree->size[s] == 1 ? 1.0f : 0.0f) : state(ratings.moves[s]);
    }
    return result;
}

/* Compares every set with the best choice of the sets in it: they come before it. */
static void compare_sets(choice* c, float min_moves) {
    const dmi_merge_tree* tree = c->tree;
    for (uint32_t s = 0; s < tree->set_count; s++) {
        const uint32_t* kids = tree->children[s];
        const float inside = kids[0] == UINT32_MAX ? 0 : c->worth[kids[0]] + c->worth[kids[1]];
        const float own = c->moves[s] - min_moves;
        c->chosen[s] = own >= 0 && c->moves[s] > 0 && own >= inside;
        c->worth[s] = dmi_fmaxf(0, dmi_fmaxf(own, inside));
    }
}

/* Lists the chosen sets from the top: what is in a chosen set is no body of its own. */
static void list_bodies(const choice* c, dmi_asset_bodies* out, uint32_t* body_of_unit) {
    const dmi_merge_tree* tree = c->tree;
    for (uint32_t s = tree->set_count; s-- > 0;) {
        const uint32_t* members = tree->members + tree->first[s];
        if (!c->chosen[s] || body_of_unit[members[0]] != DMI_ASSET_BODY) continue;
        out->bodies[out->count] = (dmi_asset_body){.carrier = DMI_ASSET_BODY, .moves = c->moves[s]};
        for (uint32_t i = 0; i < tree->size[s]; i++) body_of_unit[members[i]] = out->count;
        out->count++;
    }
}

/* out_moves: the probability of each set. */
static dm_result choose_bodies(const dmi_asset_query* q, const dmi_asset_units* u, const dmi_merge_tree* tree,
                               dmi_asset_bodies* out, uint32_t* body_of_unit, const float** out_moves) {
    float* moves = dmi_arena_push(q->arena, (tree->set_count + 1) * sizeof *moves);
    choice c = {.tree = tree, .moves = moves};
    c.worth = dmi_arena_push(q->arena, (tree->set_count + 1) * sizeof *c.worth);
    c.chosen = dmi_arena_push(q->arena, tree->set_count + 1);
    out->bodies = dmi_arena_push(q->arena, (u->count + 1) * sizeof *out->bodies);
    if (moves == NULL || c.worth == NULL || c.chosen == NULL || out->bodies == NULL) return DM_ERROR_OUT_OF_MEMORY;
    const dm_result result = rate_sets(q, u, tree, moves);
    if (result != DM_OK) return result;
    compare_sets(&c, q->min_moves);
    memset(body_of_unit, NOTHING, u->count * sizeof *body_of_unit);
    list_bodies(&c, out, body_of_unit);
    *out_moves = moves;
    return DM_OK;
}

/* ---- bodies that might move, but probably do not: the best choice of the sets that hold no unit of a body ---- */

static bool is_open(const dmi_merge_tree* tree, uint32_t set, const uint32_t* body_of_unit) {
    const uint32_t* members = tree->members + tree->first[set];
    for (uint32_t i = 0; i < tree->size[set]; i++)
        if (body_of_unit[members[i]] != DMI_ASSET_BODY) return false;
    return true;
}

/* Compares every set with the best choice of the sets in it: they come before it. */
static void compare_staying(choice* c, const uint32_t* body_of_unit) {
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
static void list_staying(const choice* c, dmi_asset_bodies* bodies, uint32_t* body_of_unit) {
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

/* Adds the best sets of units that are of no body to the bodies, behind those that move. moves: probability of each set
 * of the tree. body_of_unit: DMI_ASSET_BODY: of no body yet. */
static dm_result list_staying_bodies(dmi_arena* arena, const dmi_merge_tree* tree, const float* moves,
                                     dmi_asset_bodies* bodies, uint32_t* inout_body_of_unit) {
    choice c = {.tree = tree, .moves = moves};
    c.worth = dmi_arena_push(arena, (tree->set_count + 1) * sizeof *c.worth);
    c.chosen = dmi_arena_push(arena, tree->set_count + 1);
    if (c.worth == NULL || c.chosen == NULL) return DM_ERROR_OUT_OF_MEMORY;
    compare_staying(&c, inout_body_of_unit);
    list_staying(&c, bodies, inout_body_of_unit);
    return DM_OK;
}

/* ---- the whole ---- */

#define MIXED (DMI_ASSET_BODY - 1) /* nodes below are of different bodies */

/* A node without faces is of the body that all below it are of; else of the body above it. */
static dm_result spread_to_nodes(const dmi_asset_query* q, const dmi_asset_units* u, const uint32_t* body_of_unit,
                                 dmi_asset_bodies* out) {
    const uint32_t count = q->node_count;
    uint32_t* body = out->body_of_node = dmi_arena_push(q->arena, (count + 1) * sizeof *body);
    uint8_t* seen = dmi_arena_push(q->arena, count + 1);
    if (body == NULL || seen == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(seen, 0, count);
    for (uint32_t k = count; k-- > 0;) {
        const uint32_t n = q->order[k], above = q->nodes[n].parent;
        if (u->of_node[n] != UINT32_MAX) body[n] = body_of_unit[u->of_node[n]], seen[n] = 1;
        if (above == DMI_ASSET_BODY || !seen[n] || u->of_node[above] != UINT32_MAX) continue;
        body[above] = !seen[above] || body[above] == body[n] ? body[n] : MIXED;
        seen[above] = 1;
    }
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t n = q->order[k], above = q->nodes[n].parent;
        if (!seen[n] || body[n] == MIXED) body[n] = above != DMI_ASSET_BODY ? body[above] : DMI_ASSET_BODY;
    }
    return DM_OK;
}

static dm_result find_bodies(const dmi_asset_query* q, const dmi_asset_units* u, dmi_asset_bodies* out) {
    uint32_t* body_of_unit = dmi_arena_push(q->arena, (u->count + 1) * sizeof *body_of_unit);
    if (body_of_unit == NULL) return DM_ERROR_OUT_OF_MEMORY;
    dmi_node_labels labels;
    dmi_node_cells cells;
    dmi_merge_tree tree;
    const float* moves = NULL;
    dm_result result =
        dmi_node_labels_make(q->arena, q->nodes, q->node_count, u->node, u->count, q->use_names, &labels);
    const dmi_progress filling = dmi_progress_piece(q->progress, 0, DMI_STAGE_GROUP_CELLS_FILLED);
    const dmi_progress merging =
        dmi_progress_piece(q->progress, DMI_STAGE_GROUP_CELLS_FILLED, DMI_STAGE_GROUP_PAIRS_RATED);
    if (result == DM_OK) result = dmi_node_cells_make(q->arena, q->mesh, u->of_part, u->count, &filling, &cells);
    if (result == DM_OK) result = dmi_merge_tree_make(q->arena, &cells, &labels, q->models, &merging, &tree);
    if (result == DM_OK) result = choose_bodies(q, u, &tree, out, body_of_unit, &moves);
    if (result == DM_OK) result = dmi_asset_attach_loose_units(q->arena, &cells, out->count, body_of_unit);
    if (result == DM_OK) result = dmi_asset_find_carriers(q, u, &cells, &labels, body_of_unit, out);
    if (result == DM_OK) result = list_staying_bodies(q->arena, &tree, moves, out, body_of_unit);
    return result == DM_OK ? spread_to_nodes(q, u, body_of_unit, out) : result;
}

dm_result dmi_asset_find_bodies(dmi_env* env, const dmi_asset_query* q, dmi_asset_bodies* out) {
    *out = (dmi_asset_bodies){0};
    dmi_asset_units u;
    dm_result result = list_units(q, &u);
    if (result == DM_OK && u.count > DMI_ASSET_MAX_UNITS)
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "dm_asset_create: %u nodes have faces: %d is the most", u.count,
                        DMI_ASSET_MAX_UNITS);
    if (result == DM_OK) result = find_bodies(q, &u, out);
    if (result == DM_ERROR_OUT_OF_MEMORY)
        dmi_fail(env, result, "dm_asset_create: no memory for %u nodes", q->node_count);
    return result;
}

void dmi_asset_bodies_keep(dmi_asset_bodies* bodies, uint32_t node_count, const uint8_t* keep, uint32_t* scratch) {
    uint32_t kept = 0;
    for (uint32_t i = 0; i < bodies->count; i++) scratch[i] = keep[i] ? kept++ : DMI_ASSET_BODY;
    for (uint32_t i = 0; i < bodies->count; i++) {
        uint32_t* carrier = &bodies->bodies[i].carrier;
        while (*carrier != DMI_ASSET_BODY && !keep[*carrier]) *carrier = bodies->bodies[*carrier].carrier;
    }
    for (uint32_t i = 0; i < node_count; i++) {
        uint32_t* body = &bodies->body_of_node[i];
        while (*body != DMI_ASSET_BODY && !keep[*body]) *body = bodies->bodies[*body].carrier;
        if (*body != DMI_ASSET_BODY) *body = scratch[*body];
    }
    for (uint32_t i = 0; i < bodies->count; i++) {
        if (!keep[i]) continue;
        dmi_asset_body body = bodies->bodies[i];
        if (body.carrier != DMI_ASSET_BODY) body.carrier = scratch[body.carrier];
        bodies->bodies[scratch[i]] = body;
    }
    bodies->count = kept;
}
