/* Makes cases for fitting the part finder: grows the true parts of generated objects piece by piece and records the
 * neighbours of the region at each step; lets regions grow by the network and records each proposal's overlap with the
 * true part.
 *
 * The generator's objects are many separate shells. Some are taken as if neighbouring shells were one sheet of surface,
 * as in meshes that were modelled, scanned or united in one piece; in some the shells are split at their creases, as
 * where faces are doubled, or more than two meet at an edge. */
#include "lab_growth.h"

#include <math.h>
#include <string.h>

#include "mesh/connectivity.h"
#include "pull.h"
#include "segmentation/part_finder.h"
#include "segmentation/part_networks.h"
#include "segmentation/proposals.h"
#include "segmentation/region_growing.h"

#define BLOCK ((size_t)1 << 20)         /* bytes */
#define WEIGHTS_BLOCK ((size_t)1 << 16) /* bytes */

/* All set by hand. */
#define DRAG_NOISE_DEGREES 8
#define MOST_PIECES 400    /* of a case that is grown */
#define MOST_SHEETS 1500   /* of a case whose proposals are recorded */
#define GROWTHS 2          /* of a case */
#define STEPS 10           /* of a growth */
#define WITHOUT_DRAG 0.1f  /* share of growths without the drag */
#define UNITED 0.35f       /* share of cases in which shells count as one sheet */
#define CUT 0.3f           /* share of the others in which the grabbed sheet is cut */
#define SPLIT 0.35f        /* share of cases in which sheets are split at their creases */
#define CREASE_COSINE 0.8f /* cosine between the normals of two faces, below which there is a crease between them */

typedef struct growing {
    const dm_lab_growth* out;
    dmi_piece_level level;
    uint8_t belongs[MOST_PIECES];
    float area; /* of the pieces that belong */
    lab_case made;
} growing;

uint32_t dm_lab_growth_columns(void) {
    return DMI_NEIGHBOUR_FEATURES;
}

uint32_t dm_lab_choice_columns(void) {
    return DMI_PROPOSAL_FEATURES;
}

uint32_t dm_lab_choice_cut_column(void) {
    return DMI_PROPOSAL_SHEET_IS_CUT;
}

uint32_t dm_lab_choice_most(void) {
    return DMI_MAX_PROPOSALS;
}

/* ---- one drag, one surface ---- */

static void grab_part(lab_case* made, float noise_degrees, dmi_grab* out) {
    dm_joint joint;
    const dmi_drag_hint hint = lab_case_drag(made, DM_LAB_PULL_TANGENT, noise_degrees, &joint);
    float length = 0;
    for (int k = 0; k < 3; k++) length += hint.vector[k] * hint.vector[k];
    const int has_drag = !lab_random_bool(&made->random, WITHOUT_DRAG) && length > 0;
    for (int k = 0; k < 3; k++) {
        out->point[k] = hint.point[k];
        out->drag[k] = has_drag ? hint.vector[k] / sqrtf(length) : 0;
    }
    out->face = 0; /* of a mesh without faces, which no case has */
    dmi_mesh_nearest_face(made->mesh, out->point, NULL, &out->face);
}

/* Renumbers sheets: the united ones become sheet 0 and one shell, the others follow. */
static dm_result relabel(dmi_arena* arena, const uint8_t* united, dmi_mesh_sheets* sheets) {
    uint32_t* labels = dmi_arena_push(arena, sheets->count * sizeof *labels);
    if (labels == NULL) return DM_ERROR_OUT_OF_MEMORY;
    uint32_t count = 1, shell = UINT32_MAX;
    for (uint32_t p = 0; p < sheets->count; p++) labels[p] = united[p] ? 0 : count++;
    for (uint32_t f = 0; f < sheets->mesh->face_count; f++) {
        uint32_t* label = &sheets->labels[f];
        if (united[*label]) {
            if (shell == UINT32_MAX) shell = sheets->shells[f];
            sheets->shells[f] = shell;
        }
        *label = labels[*label];
    }
    sheets->count = count;
    return DM_OK;
}

/* Unites the sheets around the grabbed one up to a random share of the whole area. */
static dm_result unite_sheets(dmi_arena* arena, dmi_random* random, uint32_t seed, dmi_mesh_sheets* sheets) {
    dmi_pieces pieces;
    dm_result result = dmi_pieces_make(arena, sheets->mesh, sheets->labels, sheets->count, &pieces);
    uint8_t* united = result == DM_OK ? dmi_arena_push(arena, sheets->count) : NULL;
    if (united == NULL) return result == DM_OK ? DM_ERROR_OUT_OF_MEMORY : result;
    float total = 0, area = pieces.area[seed];
    for (uint32_t p = 0; p < pieces.count; p++) total += pieces.area[p];
    const float most = lab_random_uniform(random, 0.2f, 1.2f) * total, eager = lab_random_uniform(random, 0.02f, 0.5f);
    memset(united, 0, sheets->count);
    united[seed] = 1;
    for (int changed = 1; changed && area < most;) {
        changed = 0;
        for (uint32_t s = 0; s < pieces.first[pieces.count] && area < most; s++) {
            const dmi_piece_sample* sample = &pieces.samples[s];
            for (uint32_t t = 0; t < sample->contact_count && !united[sample->piece]; t++) {
                if (!united[pieces.samples[sample->contacts[t].sample].piece] || !lab_random_bool(random, eager))
                    continue;
                united[sample->piece] = 1;
                area += pieces.area[sample->piece];
                changed = 1;
            }
        }
    }
    return relabel(arena, united, sheets);
}

/* Splits a random share of the sheets into smooth regions. */
static dm_result split_sheets(dmi_arena* arena, dmi_random* random, dmi_mesh_sheets* sheets) {
    const uint32_t faces = sheets->mesh->face_count;
    uint32_t* regions = dmi_arena_push(arena, faces * sizeof *regions);
    uint8_t* select = dmi_arena_push(arena, faces);
    uint8_t* split = dmi_arena_push(arena, sheets->count);
    uint32_t count, labels = sheets->count;
    if (regions == NULL || select == NULL || split == NULL) return DM_ERROR_OUT_OF_MEMORY;
    const float share = lab_random_uniform(random, 0.1f, 1);
    for (uint32_t p = 0; p < sheets->count; p++) split[p] = (uint8_t)lab_random_bool(random, share);
    for (uint32_t f = 0; f < faces; f++) select[f] = split[sheets->labels[f]];
    dm_result result =
        dmi_face_regions(arena, sheets->mesh, sheets->welded, select, CREASE_COSINE, NULL, regions, &count);
    uint32_t* owners = result == DM_OK ? dmi_arena_push(arena, (count + 1) * sizeof *owners) : NULL;
    uint32_t* names = owners != NULL ? dmi_arena_push(arena, (count + 1) * sizeof *names) : NULL;
    if (names == NULL) return result == DM_OK ? DM_ERROR_OUT_OF_MEMORY : result;
    memset(owners, 0xff, count * sizeof *owners);
    memset(split, 0, sheets->count);
    for (uint32_t f = 0; f < faces; f++) { /* a sheet's first region keeps its label */
        const uint32_t sheet = sheets->labels[f], region = regions[f];
        if (!select[f]) continue;
        if (owners[region] == UINT32_MAX) {
            owners[region] = sheet;
            names[region] = split[sheet] ? labels++ : sheet;
            split[sheet] = 1;
        }
        if (owners[region] == sheet) sheets->labels[f] = names[region];
    }
    sheets->count = labels;
    return DM_OK;
}

/* Makes the sheets of a case, some united or split. out_united: whether the grabbed one was united with others. */
static dm_result make_sheets(dmi_arena* arena, lab_case* made, const dmi_grab* grab, dmi_mesh_sheets* out,
                             int* out_united) {
    dm_result result = dmi_mesh_sheets_make(arena, made->mesh, NULL, out);
    if (result == DM_OK && lab_random_bool(&made->random, SPLIT)) result = split_sheets(arena, &made->random, out);
    *out_united = lab_random_bool(&made->random, UNITED);
    if (result != DM_OK || !*out_united || out->count > MOST_SHEETS) return result;
    return unite_sheets(arena, &made->random, out->labels[grab->face], out);
}

/* Returns whether a face moves with the case's part. */
static int moves(const lab_case* made, uint32_t part, uint32_t face) {
    return dmi_mesh_moves_with(made->mesh, made->mesh->face_part[face], part);
}

/* ---- growing ---- */

/* Marks the pieces with more than half of their area on the part. */
static void find_truth(growing* g) {
    const dmi_mesh* mesh = g->made.mesh;
    const dmi_pieces* pieces = &g->level.pieces;
    const uint32_t part = (uint32_t)dmi_mesh_find_part(mesh, g->made.part);
    float moving[MOST_PIECES] = {0};
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (moves(&g->made, part, f)) moving[pieces->labels[f]] += mesh->face_area[f];
    g->area = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        g->belongs[p] = moving[p] > 0.5f * pieces->area[p];
        g->area += g->belongs[p] ? pieces->area[p] : 0;
    }
}

static void record_neighbours(const growing* g, const dmi_region* region) {
    const dm_lab_growth* out = g->out;
    for (uint32_t i = 0; i < region->neighbour_count && *out->count < out->capacity; i++) {
        const uint32_t row = (*out->count)++;
        memcpy(out->features + (size_t)row * DMI_NEIGHBOUR_FEATURES, region->features[i], sizeof region->features[i]);
        out->belongs[row] = g->belongs[region->neighbours[i]];
        out->weight[row] = 1 / (float)region->neighbour_count;
        out->category[row] = (int32_t)g->made.category_id;
    }
}

/* Adds a random one of the neighbours that belong; returns 0 when there is none. */
static int step(growing* g, dmi_region* region) {
    uint32_t good[MOST_PIECES], count = 0;
    for (uint32_t i = 0; i < region->neighbour_count; i++)
        if (g->belongs[region->neighbours[i]]) good[count++] = region->neighbours[i];
    if (count == 0) return 0;
    dmi_region_add(region, good[dmi_random_u32(&g->made.random) % count]);
    return 1;
}

static dm_result grow(dmi_arena* arena, growing* g, const dmi_grab* grab) {
    dmi_region region;
    dm_result result = dmi_region_make(arena, &g->level, grab->drag, &region);
    if (result != DM_OK) return result;
    dmi_region_add(&region, g->level.pieces.labels[grab->face]);
    for (int i = 0; i < STEPS; i++) {
        dmi_region_find_neighbours(&region);
        record_neighbours(g, &region);
        if (!step(g, &region)) break;
    }
    return DM_OK;
}

static dm_result grow_once(dmi_env* env, growing* g) {
    dmi_arena arena;
    dmi_mesh_sheets sheets;
    dmi_grab grab;
    grab_part(&g->made, DRAG_NOISE_DEGREES, &grab);
    dmi_arena_init(&arena, env, BLOCK);
    int united;
    dm_result result = make_sheets(&arena, &g->made, &grab, &sheets, &united);
    const int cut = united || lab_random_bool(&g->made.random, CUT);
    if (result == DM_OK)
        result =
            dmi_piece_level_make(&arena, &sheets, cut ? sheets.labels[grab.face] : DMI_PIECE_NONE, NULL, &g->level);
    if (result == DM_OK && g->level.pieces.count == 0)
        result = dmi_piece_level_make(&arena, &sheets, DMI_PIECE_NONE, NULL, &g->level);
    if (result == DM_OK && g->level.pieces.count > 1 && g->level.pieces.count <= MOST_PIECES) {
        find_truth(g);
        if (g->belongs[g->level.pieces.labels[grab.face]]) result = grow(&arena, g, &grab);
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
        for (int k = 0; k < GROWTHS && result == DM_OK; k++) result = grow_once(&env, g);
        lab_case_release(&env, &g->made);
    }
    dmi_free(&env, g, sizeof *g);
    return result;
}

/* ---- choosing ---- */

static float overlap(const lab_case* made, uint32_t part, const dmi_proposal* item) {
    const dmi_mesh* mesh = made->mesh;
    float both = 0, either = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const int truly = moves(made, part, f), found = item->inside[item->level->pieces.labels[f]] != 0;
        both += truly && found ? mesh->face_area[f] : 0;
        either += truly || found ? mesh->face_area[f] : 0;
    }
    return either > 0 ? both / either : 0;
}

static dm_result propose(dmi_arena* arena, lab_case* made, const dmi_perceptron* growth, dmi_proposals* out) {
    dmi_mesh_sheets sheets;
    dmi_grab grab;
    grab_part(made, DRAG_NOISE_DEGREES, &grab);
    out->count = 0;
    int united;
    const dm_result result = make_sheets(arena, made, &grab, &sheets, &united);
    if (result != DM_OK || sheets.count > MOST_SHEETS) return result;
    return dmi_proposals_make(arena, &sheets, &grab, growth, dmi_cpu_best_isa(), NULL, out);
}

static void record_proposals(const lab_case* made, const dmi_proposals* proposals, uint32_t row,
                             const dm_lab_choice* out) {
    const uint32_t part = (uint32_t)dmi_mesh_find_part(made->mesh, made->part);
    out->used[row] = (int32_t)proposals->count;
    out->category[row] = (int32_t)made->category_id;
    for (uint32_t i = 0; i < proposals->count; i++) {
        const size_t at = (size_t)row * DMI_MAX_PROPOSALS + i;
        memcpy(out->features + at * DMI_PROPOSAL_FEATURES, proposals->items[i].features,
               sizeof proposals->items[i].features);
        out->overlap[at] = overlap(made, part, &proposals->items[i]);
    }
}

static dm_result choose(dmi_env* env, const dm_lab_options* options, const dmi_perceptron* growth,
                        dmi_proposals* proposals, const dm_lab_choice* out) {
    dm_result result = DM_OK;
    for (uint32_t i = 0; i < options->count && result == DM_OK; i++) {
        lab_case made;
        dmi_arena arena;
        result = lab_case_make(env, options, i, &made);
        if (result != DM_OK) break;
        dmi_arena_init(&arena, env, BLOCK);
        result = propose(&arena, &made, growth, proposals);
        if (result == DM_OK) record_proposals(&made, proposals, i, out);
        dmi_arena_release(&arena);
        lab_case_release(env, &made);
    }
    return result;
}

static void read_growth(dmi_loader* loader, void* network) {
    dmi_part_growth_read(loader, network);
}

dm_result dm_lab_choice_batch(const dm_lab_options* options, const void* weights, size_t weights_size,
                              const dm_lab_choice* out) {
    dmi_env env;
    dmi_arena keep;
    dmi_perceptron growth;
    dmi_env_init(&env, NULL, NULL, NULL);
    dmi_arena_init(&keep, &env, WEIGHTS_BLOCK);
    dm_result result =
        dmi_load_network(&env, weights, weights_size, DMI_PART_FINDER_ARCHITECTURE, read_growth, &growth, &keep);
    if (result != DM_OK) return result;
    dmi_proposals* proposals = dmi_alloc(&env, sizeof *proposals, 64);
    result = proposals != NULL ? choose(&env, options, &growth, proposals, out) : DM_ERROR_OUT_OF_MEMORY;
    if (proposals != NULL) dmi_free(&env, proposals, sizeof *proposals);
    dmi_arena_release(&keep);
    return result;
}
