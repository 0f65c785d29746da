/* Makes rows of bodies and what may carry them, from generated assets. */
#include "lab_carriers.h"

#include <string.h>

#include "assets/asset_models.h"
#include "assets/carrier_features.h"
#include "lab_asset_draw.h"
#include "math/frames.h"

#define MOVES 0.5f      /* probability from which on a body is answered */
#define FOUND 0.9f      /* overlap with the true part from which on a body is that part */
#define UNRATED (-1.0f) /* stands for the probability of true bodies, which nothing rates */

/* Bodies of an asset: found ones or true ones. */
typedef struct bodies {
    uint32_t* of_unit; /* UINT32_MAX: it stays */
    float* moves;
    uint32_t count;
    uint32_t* part; /* body -> the part that it is; 0: it is none */
} bodies;

uint32_t dm_lab_carrier_columns(void) {
    return DMI_CARRIER_FEATURES;
}

static uint32_t part_of(const dm_lab_drawn_asset* d, uint32_t unit) {
    return d->asset.nodes[d->unit_node[unit]].part;
}

static dm_result make_room(dm_lab_drawn_asset* d, bodies* out) {
    const size_t units = (size_t)d->unit_count + d->asset.object.joint_count + 1;
    *out = (bodies){.of_unit = dmi_arena_push(&d->arena, units * sizeof *out->of_unit),
                    .moves = dmi_arena_push(&d->arena, units * sizeof *out->moves),
                    .part = dmi_arena_push(&d->arena, units * sizeof *out->part)};
    return out->of_unit != NULL && out->moves != NULL && out->part != NULL ? DM_OK : DM_ERROR_OUT_OF_MEMORY;
}

/* ---- true bodies ---- */

static void take_true_bodies(const dm_lab_drawn_asset* d, bodies* out) {
    for (uint32_t u = 0; u < d->unit_count; u++) {
        const uint32_t part = part_of(d, u);
        out->of_unit[u] = UINT32_MAX;
        if (part == 0) continue;
        uint32_t b = 0;
        while (b < out->count && out->part[b] != part) b++;
        if (b == out->count) out->part[out->count] = part, out->moves[out->count++] = UNRATED;
        out->of_unit[u] = b;
    }
}

/* ---- found bodies ---- */

/* Makes the mesh as the library has it when it looks for bodies. */
static dm_result make_numbered_mesh(dm_lab_drawn_asset* d, dmi_mesh** out) {
    dm_mesh_desc desc;
    const dm_result result = dm_lab_describe_mesh(d, &desc);
    if (result != DM_OK) return result;
    dmi_axes axes;
    dmi_axes_init(&axes, 0, NULL, 1);
    return dmi_mesh_create_numbered(d->env, &axes, &desc, d->asset.node_count, NULL, out);
}

static dm_result query_bodies(dm_lab_drawn_asset* d, const dmi_asset_models* models, const dmi_mesh* mesh,
                              dmi_asset_bodies* out) {
    const uint32_t count = d->asset.node_count;
    uint32_t* above = dmi_arena_push(&d->arena, (count + 1) * sizeof *above);
    uint32_t* order = dmi_arena_push(&d->arena, (count + 1) * sizeof *order);
    uint8_t* done = dmi_arena_push(&d->arena, count + 1);
    if (above == NULL || order == NULL || done == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t n = 0; n < count; n++) above[n] = d->nodes[n].parent;
    dmi_asset_order_nodes(above, count, order, done);
    const dmi_asset_query query = {.mesh = mesh,
                                   .nodes = d->nodes,
                                   .order = order,
                                   .node_count = count,
                                   .use_names = d->use_names,
                                   .models = models,
                                   .min_moves = MOVES,
                                   .arena = &d->arena};
    return dmi_asset_find_bodies(d->env, &query, out);
}

static float area_of_part(const dm_lab_drawn_asset* d, uint32_t part) {
    float sum = 0;
    for (uint32_t u = 0; u < d->unit_count; u++) sum += part_of(d, u) == part ? d->cells.area[u] : 0;
    return sum;
}

/* Finds the part that each body is. */
static void match_parts(const dm_lab_drawn_asset* d, bodies* all) {
    for (uint32_t b = 0; b < all->count; b++) {
        float own = 0;
        for (uint32_t u = 0; u < d->unit_count; u++) own += all->of_unit[u] == b ? d->cells.area[u] : 0;
        all->part[b] = 0;
        for (uint32_t part = 1; part <= d->asset.object.joint_count; part++) {
            float both = 0;
            for (uint32_t u = 0; u < d->unit_count; u++)
                both += all->of_unit[u] == b && part_of(d, u) == part ? d->cells.area[u] : 0;
            if (both > 0 && both >= FOUND * (own + area_of_part(d, part) - both)) all->part[b] = part;
        }
    }
}

static dm_result take_found_bodies(dm_lab_drawn_asset* d, const dmi_asset_models* models, bodies* out) {
    dmi_mesh* mesh;
    dmi_asset_bodies found;
    dm_result result = make_numbered_mesh(d, &mesh);
    if (result != DM_OK) return result;
    result = query_bodies(d, models, mesh, &found);
    dmi_mesh_destroy(d->env, mesh);
    if (result != DM_OK) return result;
    while (out->count < found.count && found.bodies[out->count].moves >= MOVES) {
        out->moves[out->count] = found.bodies[out->count].moves;
        out->count++;
    }
    for (uint32_t u = 0; u < d->unit_count; u++) {
        const uint32_t body = found.body_of_node[d->unit_node[u]];
        out->of_unit[u] = body < out->count ? body : UINT32_MAX;
    }
    match_parts(d, out);
    return DM_OK;
}

/* ---- rows ---- */

/* Returns the nearest part that carries a part and has a surface; 0: what stays. */
static uint32_t true_carrier(const dm_lab_drawn_asset* d, uint32_t part) {
    do part = d->asset.object.joints[part - 1].parent;
    while (part != 0 && area_of_part(d, part) <= 0);
    return part;
}

/* Returns the body, other than `body`, that has the most of a part; all->count: what stays. */
static uint32_t body_with_most(const dm_lab_drawn_asset* d, const bodies* all, uint32_t body, uint32_t part) {
    uint32_t best = all->count;
    float most = 0;
    for (uint32_t b = 0; b <= all->count; b++) {
        float area = 0;
        for (uint32_t u = 0; u < d->unit_count; u++)
            if (part_of(d, u) == part && all->of_unit[u] == (b < all->count ? b : UINT32_MAX)) area += d->cells.area[u];
        if (b != body && area > most) most = area, best = b;
    }
    return best;
}

static uint32_t find_target(const dm_lab_drawn_asset* d, const bodies* all, uint32_t body, uint32_t* out_carried) {
    const uint32_t part = true_carrier(d, all->part[body]);
    *out_carried = part == 0 ? DM_LAB_CARRIED_BY_BODY : DM_LAB_CARRIED_BY_OTHERS;
    if (part == 0) return all->count;
    for (uint32_t b = 0; b < all->count; b++)
        if (all->part[b] == part) {
            *out_carried = DM_LAB_CARRIED_BY_PART;
            return b;
        }
    return body_with_most(d, all, body, part);
}

static dm_result write_case(const dmi_carrier_facts* facts, uint32_t body, uint32_t target, uint32_t carried,
                            uint32_t asset, dm_lab_carrier_rows* rows) {
    if (rows->case_count == rows->case_capacity) return DM_ERROR_TOO_LARGE;
    uint32_t used = rows->first[rows->case_count];
    for (uint32_t c = 0; c <= facts->count; c++) {
        if (!dmi_carrier_is_candidate(facts, body, c)) continue;
        if (used == rows->capacity) return DM_ERROR_TOO_LARGE;
        rows->target[used] = c == target;
        dmi_carrier_features_make(facts, body, c, rows->features + (size_t)used++ * DMI_CARRIER_FEATURES);
    }
    rows->carried[rows->case_count] = carried;
    rows->asset[rows->case_count] = asset;
    rows->first[++rows->case_count] = used;
    return DM_OK;
}

static dm_result write_rows(dm_lab_drawn_asset* d, const dmi_asset_models* models, uint32_t asset,
                            dm_lab_carrier_rows* rows) {
    bodies all;
    dmi_carrier_facts facts;
    dm_result result = make_room(d, &all);
    if (result != DM_OK) return result;
    if (models == NULL)
        take_true_bodies(d, &all);
    else
        result = take_found_bodies(d, models, &all);
    if (result == DM_OK)
        result = dmi_carrier_facts_make(&d->arena, &d->cells, &d->labels, all.of_unit, all.moves, all.count, &facts);
    for (uint32_t b = 0; result == DM_OK && b < all.count; b++) {
        if (all.part[b] == 0) continue;
        uint32_t carried;
        const uint32_t target = find_target(d, &all, b, &carried);
        if (dmi_carrier_is_candidate(&facts, b, target))
            result = write_case(&facts, b, target, carried, asset, rows);
        else
            rows->missed++;
    }
    return result;
}

/* models NULL: the bodies are the true ones. */
static dm_result write_batch(dmi_env* env, const dm_lab_options* options, const dmi_asset_models* models,
                             dm_lab_carrier_rows* rows) {
    dm_result result = DM_OK;
    rows->case_count = rows->missed = rows->first[0] = 0;
    for (uint32_t i = 0; i < options->count && result == DM_OK; i++) {
        dm_lab_drawn_asset d;
        result = dm_lab_open_asset(env, options, i, &d);
        if (result == DM_OK && d.unit_count > 0) result = write_rows(&d, models, i, rows);
        dm_lab_close_asset(&d);
    }
    return result;
}

dm_result dm_lab_carriers(const dm_lab_options* options, const void* weights, size_t weights_size,
                          dm_lab_carrier_rows* rows) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    if (weights == NULL) return write_batch(&env, options, NULL, rows);
    dmi_asset_models models;
    dm_result result = dmi_asset_models_load(&env, weights, weights_size, &models);
    if (result != DM_OK) return result;
    result = write_batch(&env, options, &models, rows);
    dmi_asset_models_release(&models);
    return result;
}
