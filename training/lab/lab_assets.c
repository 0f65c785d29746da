/* Makes rows of features from generated assets, as sdk/assets sees them. */
#include "lab_assets.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "assets/merge_tree.h"
#include "base/random.h"
#include "generator.h"
#include "lab_asset_draw.h"
#include "math/frames.h"

#define BLOCK ((size_t)1 << 20) /* bytes */
#define MOST_UNITS 400          /* of an asset that is taken */
#define TRIES 50                /* objects drawn for one asset */
#define NAMELESS 0.4f           /* share of assets whose names and hierarchy are not read; by hand */

/* Most of the keys, screws and buttons that people model are decoration. All set by hand. */
#define FIXED_DETAILS 0.35f /* share of assets in which the smallest parts stay */
#define DETAIL 0.01f        /* share of the asset's area below which a part is a detail */

typedef dm_lab_drawn_asset drawn;

uint32_t dm_lab_asset_pair_columns(void) {
    return DMI_PAIR_FEATURES;
}

uint32_t dm_lab_asset_set_columns(void) {
    return DMI_RATED_FEATURES;
}

uint32_t dm_lab_asset_context_columns(void) {
    return DMI_CONTEXT_FEATURES;
}

/* ---- drawing an asset ---- */

static uint32_t draw_row(const dm_lab_options* options, dmi_random* random) {
    uint32_t sum = 0;
    for (uint32_t row = 0; row < dmg_category_count(); row++) sum += options->categories[dmg_category_id(row)];
    uint32_t left = (uint32_t)(dmi_random_unit(random) * (float)sum);
    for (uint32_t row = 0; row < dmg_category_count(); row++) {
        const uint32_t weight = options->categories[dmg_category_id(row)];
        if (left < weight) return row;
        left -= weight;
    }
    return 0;
}

static bool draw_asset(const dm_lab_options* options, dmi_random* random, dmg_asset* out) {
    for (int i = 0; i < TRIES; i++) {
        const uint32_t row = draw_row(options, random);
        const uint64_t seed = ((uint64_t)dmi_random_u32(random) << 32) | dmi_random_u32(random);
        const uint32_t flags = dmi_random_unit(random) < options->messy ? DMG_MESSY : 0;
        if (dmg_split(row, seed) == options->split && dmg_make_asset(row, seed, flags, out) == 0) return true;
    }
    return false;
}

dm_result dm_lab_describe_mesh(drawn* d, dm_mesh_desc* out) {
    const dmg_object* o = &d->asset.object;
    uint32_t* ids = dmi_arena_push(&d->arena, (o->face_count + 1) * sizeof *ids);
    if (ids == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t f = 0; f < o->face_count; f++) ids[f] = d->asset.face_node[f] + 1;
    *out = (dm_mesh_desc){.struct_size = sizeof *out,
                          .positions = o->positions,
                          .vertex_count = o->vertex_count,
                          .indices = o->indices,
                          .index_count = (uint64_t)o->face_count * 3,
                          .part_ids = ids,
                          .part_id_bytes = o->face_count * sizeof *ids,
                          .part_id_scope = DM_PER_FACE};
    return DM_OK;
}

static dm_result make_mesh(drawn* d) {
    dm_mesh_desc desc;
    const dm_result result = dm_lab_describe_mesh(d, &desc);
    if (result != DM_OK) return result;
    dmi_axes axes;
    dmi_axes_init(&axes, 0, NULL, 1);
    return dmi_mesh_create_pieces(d->env, &axes, &desc, NULL, &d->mesh);
}

/* Lists the nodes with faces as units, with the body of each. */
static dm_result list_units(drawn* d) {
    const uint32_t nodes = d->asset.node_count, parts = d->mesh->part_count;
    d->nodes = dmi_arena_push(&d->arena, (nodes + 1) * sizeof *d->nodes);
    d->of_part = dmi_arena_push(&d->arena, (parts + 1) * sizeof *d->of_part);
    d->unit_node = dmi_arena_push(&d->arena, (parts + 1) * sizeof *d->unit_node);
    d->body = dmi_arena_push(&d->arena, (parts + 1) * sizeof *d->body);
    if (d->nodes == NULL || d->of_part == NULL || d->unit_node == NULL || d->body == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t n = 0; n < nodes; n++)
        d->nodes[n] = (dmi_asset_node){.name = d->asset.nodes[n].name,
                                       .mesh_name = d->asset.nodes[n].mesh_name,
                                       .parent = d->asset.nodes[n].parent,
                                       .given_body = DMI_ASSET_BODY};
    d->unit_count = 0;
    for (uint32_t p = 0; p < parts; p++) {
        d->of_part[p] = UINT32_MAX;
        if (p == 0 || d->mesh->parts[p].face_count == 0) continue;
        const uint32_t node = d->mesh->parts[p].id - 1;
        d->of_part[p] = d->unit_count;
        d->unit_node[d->unit_count] = node;
        d->body[d->unit_count++] = d->asset.nodes[node].part;
    }
    return DM_OK;
}

static float area_of_body(const drawn* d, uint32_t body) {
    float sum = 0;
    for (uint32_t u = 0; u < d->unit_count; u++) sum += body == UINT32_MAX || d->body[u] == body ? d->cells.area[u] : 0;
    return sum;
}

static void fix_details(drawn* d) {
    const float least = DETAIL * area_of_body(d, UINT32_MAX);
    for (uint32_t part = 1; part <= d->asset.object.joint_count; part++) {
        if (area_of_body(d, part) >= least) continue;
        for (uint32_t u = 0; u < d->unit_count; u++)
            if (d->body[u] == part) d->body[u] = 0;
    }
}

dm_result dm_lab_open_asset(dmi_env* env, const dm_lab_options* options, uint32_t index, drawn* d) {
    dmi_random random = dmi_random_make(options->seed, index);
    *d = (drawn){.env = env};
    if (!draw_asset(options, &random, &d->asset)) return DM_ERROR_INTERNAL;
    dmi_arena_init(&d->arena, env, BLOCK);
    d->use_names = dmi_random_unit(&random) >= NAMELESS;
    const bool fixed = dmi_random_unit(&random) < FIXED_DETAILS;
    dm_result result = make_mesh(d);
    if (result == DM_OK) result = list_units(d);
    if (result == DM_OK && d->unit_count > MOST_UNITS) d->unit_count = 0;
    if (result == DM_OK)
        result = dmi_node_labels_make(&d->arena, d->nodes, d->asset.node_count, d->unit_node, d->unit_count,
                                      d->use_names, &d->labels);
    if (result == DM_OK && d->unit_count > 0)
        result = dmi_node_cells_make(&d->arena, d->mesh, d->of_part, d->unit_count, NULL, &d->cells);
    if (result == DM_OK && fixed) fix_details(d);
    return result;
}

void dm_lab_close_asset(drawn* d) {
    dmi_arena_release(&d->arena);
    dmi_mesh_destroy(d->env, d->mesh);
    dmg_asset_release(&d->asset);
}

static uint32_t count_movers(const drawn* d) {
    uint32_t count = 0;
    for (uint32_t part = 1; part <= d->asset.object.joint_count; part++) count += area_of_body(d, part) > 0;
    return count;
}

/* ---- pairs ---- */

static dm_result write_pairs(drawn* d, const dm_lab_asset_rows* out, uint32_t* used) {
    dmi_asset_facts facts;
    dmi_node_pair* pairs;
    uint32_t count;
    dm_result result = dmi_asset_facts_make(&d->arena, &d->cells, &d->labels, &facts);
    if (result == DM_OK) result = dmi_node_pairs_list(&d->arena, &d->cells, &pairs, &count);
    for (uint32_t i = 0; result == DM_OK && i < count; i++, ++*used) {
        if (*used == out->capacity) return DM_ERROR_TOO_LARGE;
        out->target[*used] = d->body[pairs[i].a] == d->body[pairs[i].b];
        result = dmi_pair_features_make(&d->arena, &d->cells, &facts, pairs[i].a, pairs[i].b,
                                        out->features + (size_t)*used * DMI_PAIR_FEATURES);
    }
    return result;
}

/* ---- sets ---- */

/* Returns the overlap of a set with the body of its nodes that fits best. */
static float overlap_of(const drawn* d, const uint32_t* units, uint32_t count) {
    float own = 0, best = 0;
    for (uint32_t i = 0; i < count; i++) own += d->cells.area[units[i]];
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t body = d->body[units[i]];
        if (body == 0) continue;
        float both = 0;
        for (uint32_t k = 0; k < count; k++) both += d->body[units[k]] == body ? d->cells.area[units[k]] : 0;
        best = fmaxf(best, both / (own + area_of_body(d, body) - both + 1e-20f));
    }
    return best;
}

static dm_result write_sets(drawn* d, const dmi_asset_models* models, int rounds, const dm_lab_asset_rows* out,
                            uint32_t* used) {
    dmi_merge_tree tree;
    dm_result result = dmi_merge_tree_make(&d->arena, &d->cells, &d->labels, models, NULL, &tree);
    if (result != DM_OK) return result;
    if (tree.set_count > out->capacity - *used) return DM_ERROR_TOO_LARGE;
    dmi_set_ratings ratings;
    result = dmi_set_ratings_make(&d->arena, &tree, models, rounds, NULL, &ratings);
    const uint32_t first = *used;
    for (uint32_t s = 0; result == DM_OK && s < tree.set_count; s++, ++*used) {
        const uint32_t* members = tree.members + tree.first[s];
        out->target[*used] = overlap_of(d, members, tree.size[s]);
        for (int k = 0; k < 2; k++)
            out->children[2 * *used + (uint32_t)k] =
                tree.children[s][k] == UINT32_MAX ? -1 : (int32_t)(first + tree.children[s][k]);
        memcpy(out->features + (size_t)*used * DMI_RATED_FEATURES, ratings.features[s], sizeof *ratings.features);
    }
    return result;
}

/* ---- batches ---- */

static dm_result write_batch(dmi_env* env, const dm_lab_options* options, const dmi_asset_models* models, int rounds,
                             const dm_lab_asset_rows* out) {
    uint32_t used = 0;
    dm_result result = DM_OK;
    for (uint32_t i = 0; i < options->count && result == DM_OK; i++) {
        drawn d;
        out->first[i] = used;
        result = dm_lab_open_asset(env, options, i, &d);
        if (result == DM_OK && d.unit_count > 0)
            result = out->children != NULL ? write_sets(&d, models, rounds, out, &used) : write_pairs(&d, out, &used);
        out->movers[i] = count_movers(&d);
        dm_lab_close_asset(&d);
    }
    out->first[options->count] = used;
    return result;
}

dm_result dm_lab_asset_pairs(const dm_lab_options* options, const dm_lab_asset_rows* out) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    dm_lab_asset_rows rows = *out;
    rows.children = NULL;
    return write_batch(&env, options, NULL, 0, &rows);
}

dm_result dm_lab_asset_sets(const dm_lab_options* options, const void* weights, size_t weights_size, uint32_t rounds,
                            const dm_lab_asset_rows* out) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    dmi_asset_models models;
    dm_result result = dmi_asset_models_load(&env, weights, weights_size, &models);
    if (result != DM_OK) return result;
    result = write_batch(&env, options, &models, (int)rounds, out);
    dmi_asset_models_release(&models);
    return result;
}
