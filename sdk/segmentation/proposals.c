/* Grows a region from the grabbed piece beyond the part. Every stage that might be the part is proposed, alone and with
 * the pieces that it carries; on whole sheets, and with the grabbed sheet cut at its creases. */
#include "segmentation/proposals.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"
#include "segmentation/part_networks.h"
#include "segmentation/region_contacts.h"
#include "segmentation/region_growing.h"

#define MAX_STAGES 16         /* stages that one growth proposes; by hand */
#define CERTAIN_LOG_ODDS 3.0f /* while a neighbour is this likely to belong, the part is incomplete; by hand */
#define MIN_LOG_ODDS (-6.0f)  /* neighbours below this never join; by hand */
#define MAX_AREA_SHARE 0.95f  /* share of the mesh's area at which a growth ends; by hand */
#define MAX_WORK (1u << 22)   /* samples in contact that a growth visits, for time: twice the most measured */
#define RATING_WORK 16        /* work of rating one neighbour, in the time of samples visited; measured */
#define MAX_REGIONS 2000      /* smooth regions of the cut sheet beyond which it is not grown, for time; by hand */

/* A growth network and how to run it. */
typedef struct rater {
    const dmi_perceptron* network;
    dmi_isa isa;
} rater;

/* State of one growth. */
typedef struct growth {
    dmi_region region;
    float* log_odds; /* per neighbour */
    dmi_remaining_components components;
    uint32_t seed, next_piece, likely_count;
    float lowest_log_odds, last_log_odds, next_log_odds, likely_area; /* dmi_proposal's */
    float area;                                                       /* the region's area */
} growth;

/* Appends a proposal with a copy of `inside`, unless there is no room. */
static dm_result add_proposal(dmi_arena* arena, const growth* g, const uint8_t* inside, dmi_proposals* out) {
    const dmi_piece_level* level = g->region.level;
    if (out->count == DMI_MAX_PROPOSALS) return DM_OK;
    dmi_proposal* item = &out->items[out->count];
    *item = (dmi_proposal){.level = level,
                           .seed = g->seed,
                           .lowest_log_odds = g->lowest_log_odds,
                           .last_log_odds = g->last_log_odds,
                           .next_log_odds = g->next_log_odds,
                           .next_piece = g->next_piece,
                           .likely_count = g->likely_count,
                           .likely_area = g->likely_area,
                           .later_log_odds = MIN_LOG_ODDS};
    item->inside = dmi_arena_push(arena, level->pieces.count);
    if (item->inside == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory for a part of %u pieces", level->pieces.count);
    memcpy(item->inside, inside, level->pieces.count);
    out->count++;
    return DM_OK;
}

/* Proposes the region alone and, if it carries any pieces, together with them. */
static dm_result propose_stage(dmi_arena* arena, growth* g, dmi_proposals* out) {
    const dmi_pieces* pieces = &g->region.level->pieces;
    dm_result result = add_proposal(arena, g, g->region.inside, out);
    if (result != DM_OK || out->count == DMI_MAX_PROPOSALS) return result;
    dmi_remaining_components_find(pieces, g->region.inside, &g->components);
    result = add_proposal(arena, g, g->region.inside, out);
    if (result != DM_OK) return result;
    if (dmi_remaining_components_carry(pieces, &g->components, out->items[out->count - 1].inside) == 0) out->count--;
    return DM_OK;
}

/* Finds the neighbour that most likely belongs, and counts those with positive log odds. */
static void rate_neighbours(growth* g, const rater* rater) {
    dmi_region* region = &g->region;
    dmi_region_find_neighbours(region);
    dmi_part_network_apply(rater->network, rater->isa, region->features[0], region->neighbour_count, g->log_odds);
    g->next_piece = DMI_PIECE_NONE;
    g->next_log_odds = MIN_LOG_ODDS;
    g->likely_count = 0;
    g->likely_area = 0;
    for (uint32_t i = 0; i < region->neighbour_count; i++) {
        const uint32_t piece = region->neighbours[i];
        const float log_odds = g->log_odds[i];
        if (log_odds > 0) {
            g->likely_count++;
            g->likely_area += region->level->pieces.area[piece];
        }
        if (log_odds <= g->next_log_odds) continue;
        g->next_log_odds = log_odds;
        g->next_piece = piece;
    }
}

static void add_next_piece(growth* g) {
    dmi_region_add(&g->region, g->next_piece);
    g->area += g->region.level->pieces.area[g->next_piece];
    g->last_log_odds = g->next_log_odds;
    if (g->next_log_odds < g->lowest_log_odds) g->lowest_log_odds = g->next_log_odds;
}

/* Sets later_log_odds and final_area of the growth's proposals, which begin at `first`. A stage alone and the same
 * stage with the pieces that it carries have the same next piece. */
static void set_later(const growth* g, uint32_t first, dmi_proposals* out) {
    float later = MIN_LOG_ODDS;
    for (uint32_t i = out->count; i-- > first;) {
        dmi_proposal* item = &out->items[i];
        item->later_log_odds = later;
        item->final_area = g->area;
        if (i > first && item[-1].next_piece != item->next_piece) later = dmi_fmaxf(later, item->last_log_odds);
    }
}

static dm_result grow(dmi_arena* arena, const dmi_piece_level* level, const dmi_grab* grab, const rater* rater,
                      const dmi_progress* progress, dmi_proposals* out) {
    const uint32_t seed = level->pieces.labels[grab->face], first = out->count;
    growth g = {.seed = seed,
                .lowest_log_odds = -MIN_LOG_ODDS,
                .last_log_odds = -MIN_LOG_ODDS,
                .area = level->pieces.area[seed]};
    dm_result result = dmi_region_make(arena, level, grab->drag, &g.region);
    if (result == DM_OK) result = dmi_remaining_components_make(arena, &level->pieces, &g.components);
    if (result != DM_OK) return result;
    g.log_odds = dmi_arena_push(arena, level->pieces.count * sizeof *g.log_odds);
    if (g.log_odds == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to rate %u pieces", level->pieces.count);
    dmi_region_add(&g.region, seed);
    uint64_t work = 0;
    int stages = 0;
    while (stages < MAX_STAGES && g.area <= MAX_AREA_SHARE * level->total_area && result == DM_OK) {
        rate_neighbours(&g, rater);
        work += g.region.contacts.first_sample[level->pieces.count] + (uint64_t)RATING_WORK * g.region.neighbour_count;
        const bool is_last = g.next_piece == DMI_PIECE_NONE || work > MAX_WORK;
        if (g.next_log_odds < CERTAIN_LOG_ODDS || is_last) {
            result = propose_stage(arena, &g, out);
            stages++;
        }
        if (is_last) break;
        add_next_piece(&g);
        if (result == DM_OK) result = dmi_progress_tell(progress, (float)work / MAX_WORK);
    }
    set_later(&g, first, out);
    return result;
}

dm_result dmi_proposals_make(dmi_arena* arena, const dmi_mesh_sheets* sheets, const dmi_grab* grab,
                             const dmi_perceptron* growth_network, dmi_isa isa, const dmi_progress* progress,
                             dmi_proposals* out) {
    const dmi_progress whole = dmi_progress_piece(progress, 0, DMI_STAGE_PROPOSE_WHOLE_MADE),
                       growing =
                           dmi_progress_piece(progress, DMI_STAGE_PROPOSE_WHOLE_MADE, DMI_STAGE_PROPOSE_WHOLE_GROWN),
                       cutting =
                           dmi_progress_piece(progress, DMI_STAGE_PROPOSE_WHOLE_GROWN, DMI_STAGE_PROPOSE_CUT_MADE),
                       growing_cut =
                           dmi_progress_piece(progress, DMI_STAGE_PROPOSE_CUT_MADE, DMI_STAGE_PROPOSE_CUT_GROWN);
    const rater rater = {growth_network, isa};
    out->count = 0;
    const uint32_t grabbed = sheets->labels[grab->face];
    dm_result result = dmi_piece_level_make(arena, sheets, DMI_PIECE_NONE, &whole, &out->levels[0]);
    if (result == DM_OK) result = grow(arena, &out->levels[0], grab, &rater, &growing, out);
    if (result == DM_OK) result = dmi_piece_level_make(arena, sheets, grabbed, &cutting, &out->levels[1]);
    if (result != DM_OK) return result;
    const uint32_t pieces = out->levels[1].pieces.count;
    if (pieces > 0 && pieces - sheets->count <= MAX_REGIONS)
        result = grow(arena, &out->levels[1], grab, &rater, &growing_cut, out);
    if (result == DM_OK) result = dmi_progress_tell(progress, DMI_STAGE_PROPOSE_CUT_GROWN);
    return result == DM_OK ? dmi_proposals_measure(arena, grab, out) : result;
}
