/* Proposals: a part grows from the grabbed piece past where it should stop, and every stage that might be the whole is
 * one, alone and with what it carries; on the mesh's sheets, and with the grabbed sheet cut at its creases. */
#include <math.h>
#include <string.h>

#include "segmentation/part_choice.h"

#define STAGES 16        /* most that one growth proposes */
#define SURE 3.0f        /* log odds: while a piece is this certain to belong, the part is not whole yet */
#define HOPELESS (-6.0f) /* what is less likely is not tried */
#define MOST_SHARE 0.95f /* of the whole area: such a part would leave nothing behind */
#define MOST_REGIONS 2000

typedef struct stage {
    dmi_growth growth;
    dmi_part_groups groups;
    uint32_t seed, next_piece, likely;
    float lowest, last, next, area, likely_area; /* as of a proposal; area: of the part */
} stage;

static dm_result keep(dmi_arena* arena, const stage* at, const uint8_t* inside, dmi_proposals* out) {
    const dmi_part_level* level = at->growth.level;
    if (out->count == DMI_PROPOSALS_MOST) return DM_OK;
    dmi_proposal* item = &out->items[out->count];
    *item = (dmi_proposal){.level = level,
                           .seed = at->seed,
                           .lowest = at->lowest,
                           .last = at->last,
                           .next = at->next,
                           .next_piece = at->next_piece,
                           .likely = at->likely,
                           .likely_area = at->likely_area,
                           .later = HOPELESS};
    item->inside = dmi_arena_push(arena, level->pieces.count);
    if (item->inside == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory for a part of %u pieces", level->pieces.count);
    memcpy(item->inside, inside, level->pieces.count);
    out->count++;
    return DM_OK;
}

/* The stage alone, and with what it carries. */
static dm_result propose(dmi_arena* arena, stage* at, dmi_proposals* out) {
    const dmi_pieces* pieces = &at->growth.level->pieces;
    dm_result result = keep(arena, at, at->growth.inside, out);
    if (result != DM_OK || out->count == DMI_PROPOSALS_MOST) return result;
    dmi_part_groups_find(pieces, at->growth.inside, &at->groups);
    result = keep(arena, at, at->growth.inside, out);
    if (result == DM_OK && dmi_part_carry(pieces, &at->groups, out->items[out->count - 1].inside) == 0) out->count--;
    return result;
}

/* Which of the pieces that touch the stage is the likeliest to belong, and how many are likely to. */
static void look(stage* at, const dmi_part_net* net) {
    dmi_growth_look(&at->growth);
    at->next_piece = DMI_PART_NONE;
    at->next = HOPELESS;
    at->likely = 0;
    at->likely_area = 0;
    for (uint32_t i = 0; i < at->growth.touching_count; i++) {
        const uint32_t piece = at->growth.touching[i];
        const float score = dmi_part_net_run(net, at->growth.features[piece]);
        if (score > 0) {
            at->likely++;
            at->likely_area += at->growth.level->pieces.area[piece];
        }
        if (score <= at->next) continue;
        at->next = score;
        at->next_piece = piece;
    }
}

static void join(stage* at) {
    dmi_growth_add(&at->growth, at->next_piece);
    at->area += at->growth.level->pieces.area[at->next_piece];
    at->last = at->next;
    if (at->next < at->lowest) at->lowest = at->next;
}

/* Tells the stages of a growth, from the proposal `first` on, what joined after them. A stage alone and the same with
 * what it carries have the same next piece. */
static void look_back(const stage* at, uint32_t first, dmi_proposals* out) {
    float later = HOPELESS;
    for (uint32_t i = out->count; i-- > first;) {
        dmi_proposal* item = &out->items[i];
        item->later = later;
        item->whole_area = at->area;
        if (i > first && item[-1].next_piece != item->next_piece) later = fmaxf(later, item->last);
    }
}

static dm_result grow(dmi_arena* arena, const dmi_part_level* level, const dmi_grab* grab, const dmi_part_net* net,
                      dmi_proposals* out) {
    const uint32_t seed = level->pieces.labels[grab->face], first = out->count;
    stage at = {.seed = seed, .lowest = -HOPELESS, .last = -HOPELESS, .area = level->pieces.area[seed]};
    dm_result result = dmi_growth_make(arena, level, grab->drag, &at.growth);
    if (result == DM_OK) result = dmi_part_groups_make(arena, &level->pieces, &at.groups);
    if (result != DM_OK) return result;
    dmi_growth_add(&at.growth, seed);
    for (int stages = 0; stages < STAGES && at.area <= MOST_SHARE * level->total_area && result == DM_OK;) {
        look(&at, net);
        if (at.next < SURE) {
            result = propose(arena, &at, out);
            stages++;
        }
        if (at.next_piece == DMI_PART_NONE) break;
        join(&at);
    }
    look_back(&at, first, out);
    return result;
}

dm_result dmi_proposals_make(dmi_arena* arena, const dmi_part_sheets* sheets, const dmi_grab* grab,
                             const dmi_part_net* growth, dmi_proposals* out) {
    out->count = 0;
    const uint32_t grabbed = sheets->labels[grab->face];
    dm_result result = dmi_part_level_make(arena, sheets, DMI_PART_NONE, &out->levels[0]);
    if (result == DM_OK) result = grow(arena, &out->levels[0], grab, growth, out);
    if (result == DM_OK) result = dmi_part_level_make(arena, sheets, grabbed, &out->levels[1]);
    if (result != DM_OK) return result;
    const uint32_t pieces = out->levels[1].pieces.count;
    if (pieces > 0 && pieces - sheets->count <= MOST_REGIONS) result = grow(arena, &out->levels[1], grab, growth, out);
    return result == DM_OK ? dmi_proposals_measure(arena, grab, out) : result;
}
