/* Grows the true parts of generated objects piece by piece and notes what touched them on the way. */
#include "lab_growth.h"

#include <math.h>
#include <string.h>

#include "case.h"
#include "kinematics/part_finder.h"

#define MOST_PIECES 400
#define GROWTHS 2
#define STEPS 10
#define UNDIRECTED 0.1f /* share of growths that are not told the drag */

typedef struct growing {
    const dm_lab_growth* out;
    dmi_pieces pieces;
    uint32_t* shells;
    uint8_t belongs[MOST_PIECES];
    float area; /* of the pieces that belong */
    lab_case made;
} growing;

uint32_t dm_lab_growth_columns(void) {
    return DMI_GROWTH_FEATURES;
}

/* Pieces with more than half of their area on the part. */
static void find_truth(growing* g) {
    const dmi_mesh* mesh = g->made.mesh;
    const uint32_t part = (uint32_t)dmi_mesh_find_part(mesh, g->made.part);
    float moving[MOST_PIECES] = {0};
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (dmi_mesh_moves_with(mesh, mesh->face_part[f], part)) moving[g->pieces.labels[f]] += mesh->face_area[f];
    g->area = 0;
    for (uint32_t p = 0; p < g->pieces.count; p++) {
        g->belongs[p] = moving[p] > 0.5f * g->pieces.area[p];
        g->area += g->belongs[p] ? g->pieces.area[p] : 0;
    }
}

/* By area, as a hand meets them. */
static uint32_t draw_piece(growing* g) {
    float left = dmi_random_unit(&g->made.random) * g->area;
    uint32_t last = 0;
    for (uint32_t p = 0; p < g->pieces.count; p++) {
        if (!g->belongs[p]) continue;
        last = p;
        left -= g->pieces.area[p];
        if (left < 0) break;
    }
    return last;
}

static void note(const growing* g, const dmi_growth* growth) {
    const dm_lab_growth* out = g->out;
    for (uint32_t i = 0; i < growth->touching_count && *out->count < out->capacity; i++) {
        const uint32_t piece = growth->touching[i], row = (*out->count)++;
        memcpy(out->features + (size_t)row * DMI_GROWTH_FEATURES, growth->features[piece], sizeof growth->features[0]);
        out->belongs[row] = g->belongs[piece];
        out->weight[row] = 1 / (float)growth->touching_count;
        out->category[row] = (int32_t)g->made.category;
    }
}

/* A random one of the touching pieces that belong joins; 0 when none does. */
static int step(growing* g, dmi_growth* growth) {
    uint32_t good[MOST_PIECES], count = 0;
    for (uint32_t i = 0; i < growth->touching_count; i++)
        if (g->belongs[growth->touching[i]]) good[count++] = growth->touching[i];
    if (count == 0) return 0;
    dmi_growth_add(growth, good[dmi_random_u32(&g->made.random) % count]);
    return 1;
}

static dm_result grow(dmi_arena* arena, growing* g) {
    static const float none[3] = {0, 0, 0};
    dm_joint joint;
    dmi_drag_hint hint = lab_case_drag(&g->made, 8, &joint);
    const float length =
        sqrtf(hint.vector[0] * hint.vector[0] + hint.vector[1] * hint.vector[1] + hint.vector[2] * hint.vector[2]);
    for (int k = 0; k < 3; k++) hint.vector[k] /= length;
    const int told = !lab_chance(&g->made.random, UNDIRECTED);
    dmi_growth growth;
    dm_result result = dmi_growth_make(arena, &g->pieces, g->shells, told ? hint.vector : none, &growth);
    if (result != DM_OK) return result;
    dmi_growth_add(&growth, draw_piece(g));
    for (int i = 0; i < STEPS; i++) {
        dmi_growth_look(&growth);
        note(g, &growth);
        if (!step(g, &growth)) break;
    }
    return DM_OK;
}

static dm_result grow_case(dmi_env* env, growing* g) {
    dmi_arena arena;
    dmi_arena_init(&arena, env, (size_t)1 << 20);
    dm_result result = dmi_part_sheets(&arena, g->made.mesh, &g->pieces, &g->shells);
    if (result == DM_OK && g->pieces.count > 1 && g->pieces.count <= MOST_PIECES) {
        find_truth(g);
        for (int i = 0; i < GROWTHS && g->area > 0 && result == DM_OK; i++) result = grow(&arena, g);
    }
    dmi_arena_release(&arena);
    return result;
}

dm_result dm_lab_growth_batch(const dm_lab_options* options, const dm_lab_growth* out) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    growing* g = dmi_alloc(&env, sizeof *g, 64);
    if (g == NULL) return DM_ERROR_OUT_OF_MEMORY;
    g->out = out;
    *out->count = 0;
    dm_result result = DM_OK;
    for (uint32_t i = 0; i < options->count && result == DM_OK; i++) {
        if (out->capacity - *out->count < GROWTHS * STEPS * MOST_PIECES) break;
        result = lab_case_make(&env, options, i, &g->made);
        if (result != DM_OK) break;
        result = grow_case(&env, g);
        lab_case_release(&env, &g->made);
    }
    dmi_free(&env, g, sizeof *g);
    return result;
}
