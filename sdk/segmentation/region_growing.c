/* Computes the features of a region's neighbours: contacts, sizes, and positions along the drag. */
#include "segmentation/region_growing.h"

#include <string.h>

#include "math/elementary.h"
#include "math/linear3.h"

#define MIN_AREA 1e-12f         /* object sizes squared: avoids the logarithm of zero */
#define MIN_VARIANCE 1e-10f     /* object sizes squared: avoids a division by zero */
#define MAX_LOG_AREA_RATIO 6    /* clamp of a feature; by hand */
#define MAX_LOG_RADIUS_GROWTH 3 /* clamp of a feature; by hand */

/* Moments and extent of one piece or several, object-normalised. */
typedef struct dmi_piece_extent {
    float area, centre[3], mean_square; /* mean_square: mean of |x|^2 over the surface */
    float low, high;                    /* ends along the drag */
    float normal_cosine;                /* mean |cosine| between normals and the drag */
} piece_extent;

/* ---- extents ---- */

static piece_extent measure_piece(const dmi_pieces* pieces, const float drag[3], uint32_t piece) {
    piece_extent out = {.area = pieces->area[piece], .low = INFINITY, .high = -INFINITY};
    const uint32_t first = pieces->first[piece], end = pieces->first[piece + 1];
    const float share = 1 / (float)(end - first);
    for (uint32_t s = first; s < end; s++) {
        const dmi_piece_sample* sample = &pieces->samples[s];
        const float height = dmi_dot3(sample->point, drag);
        dmi_madd3(out.centre, share, sample->point, out.centre);
        out.mean_square += share * dmi_dot3(sample->point, sample->point);
        out.low = dmi_fminf(out.low, height);
        out.high = dmi_fmaxf(out.high, height);
        out.normal_cosine += share * fabsf(dmi_dot3(sample->normal, drag));
    }
    return out;
}

/* Returns the extent of both together, weighted by area. */
static piece_extent merge_extents(const piece_extent* a, const piece_extent* b) {
    piece_extent out = {
        .area = a->area + b->area, .low = dmi_fminf(a->low, b->low), .high = dmi_fmaxf(a->high, b->high)};
    const float share = out.area > 0 ? b->area / out.area : 0.5f;
    for (int k = 0; k < 3; k++) out.centre[k] = (1 - share) * a->centre[k] + share * b->centre[k];
    out.mean_square = (1 - share) * a->mean_square + share * b->mean_square;
    out.normal_cosine = (1 - share) * a->normal_cosine + share * b->normal_cosine;
    return out;
}

/* Returns the root mean square distance of the surface from its centre. */
static float radius_of(const piece_extent* extent) {
    return sqrtf(dmi_fmaxf(extent->mean_square - dmi_dot3(extent->centre, extent->centre), MIN_VARIANCE));
}

/* ---- the region ---- */

static uint32_t label_count(const uint32_t* labels, uint32_t count) {
    uint32_t end = 0;
    for (uint32_t i = 0; i < count; i++)
        if (labels[i] >= end) end = labels[i] + 1;
    return end;
}

dm_result dmi_region_make(dmi_arena* arena, const dmi_piece_level* level, const float drag[3], dmi_region* out) {
    const dmi_pieces* pieces = &level->pieces;
    const uint32_t shells = label_count(level->shells, pieces->count);
    const uint32_t sheets = label_count(level->sheets, pieces->count);
    *out = (dmi_region){.level = level};
    dmi_copy3(drag, out->drag);
    out->inside = dmi_arena_push(arena, pieces->count);
    out->shell_inside = dmi_arena_push(arena, shells);
    out->sheet_inside = dmi_arena_push(arena, sheets);
    out->features = dmi_arena_push(arena, pieces->count * sizeof *out->features);
    out->neighbours = dmi_arena_push(arena, pieces->count * sizeof *out->neighbours);
    out->extents = dmi_arena_push(arena, pieces->count * sizeof *out->extents);
    if (out->inside == NULL || out->shell_inside == NULL || out->sheet_inside == NULL || out->features == NULL ||
        out->neighbours == NULL || out->extents == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to grow a region of %u pieces", pieces->count);
    memset(out->inside, 0, pieces->count);
    memset(out->shell_inside, 0, shells);
    memset(out->sheet_inside, 0, sheets);
    for (uint32_t p = 0; p < pieces->count; p++) out->extents[p] = measure_piece(pieces, out->drag, p);
    return dmi_region_contacts_make(arena, pieces, drag, &out->contacts);
}

void dmi_region_add(dmi_region* region, uint32_t piece) {
    region->inside[piece] = 1;
    region->shell_inside[region->level->shells[piece]] = 1;
    region->sheet_inside[region->level->sheets[piece]] = 1;
    region->piece_count++;
    dmi_region_contacts_add(&region->contacts, region->inside, piece);
}

/* ---- features ---- */

static void write_contacts(const dmi_neighbour_contacts* sums, float piece_samples, float region_samples, float* out) {
    const float contacts = dmi_fmaxf((float)sums->with_region, 1);
    out[DMI_NEIGHBOUR_CONTACT_SHARE] =
        (float)sums->with_region / dmi_fmaxf((float)(sums->with_region + sums->with_others), 1);
    out[DMI_NEIGHBOUR_REGION_CONTACTS] = (float)sums->with_region / piece_samples;
    out[DMI_NEIGHBOUR_OTHER_CONTACTS] = (float)sums->with_others / piece_samples;
    out[DMI_NEIGHBOUR_COVERED_REGION] = (float)sums->from_region / region_samples;
    out[DMI_NEIGHBOUR_FLUSH] = (float)sums->flush / contacts;
    out[DMI_NEIGHBOUR_STACKED] = (float)sums->stacked / contacts;
    out[DMI_NEIGHBOUR_CONTACT_DISTANCE] = sums->distance / contacts;
    out[DMI_NEIGHBOUR_STACKED_AHEAD] = (float)sums->ahead / contacts;
    out[DMI_NEIGHBOUR_STACKED_BEHIND] = (float)sums->behind / contacts;
    out[DMI_NEIGHBOUR_CONCAVE] = (float)sums->concave / contacts;
    out[DMI_NEIGHBOUR_CONVEX] = (float)sums->convex / contacts;
}

static void write_sizes(const piece_extent* piece, const piece_extent* region, float total_area, float* out) {
    const piece_extent both = merge_extents(region, piece);
    out[DMI_NEIGHBOUR_LOG_AREA_RATIO] = dmi_fminf(
        dmi_fmaxf(dmi_logf(dmi_fmaxf(piece->area, MIN_AREA) / dmi_fmaxf(region->area, MIN_AREA)), -MAX_LOG_AREA_RATIO),
        MAX_LOG_AREA_RATIO);
    out[DMI_NEIGHBOUR_AREA] = piece->area / total_area;
    out[DMI_NEIGHBOUR_REGION_AREA] = region->area / total_area;
    out[DMI_NEIGHBOUR_RADIUS] = radius_of(piece);
    out[DMI_NEIGHBOUR_REGION_RADIUS] = radius_of(region);
    out[DMI_NEIGHBOUR_LOG_RADIUS_GROWTH] =
        dmi_fminf(dmi_logf(radius_of(&both) / radius_of(region)), MAX_LOG_RADIUS_GROWTH);
}

static void write_drag(const piece_extent* piece, const piece_extent* region, const float drag[3], float* out) {
    float offset[3];
    dmi_sub3(piece->centre, region->centre, offset);
    const float along = dmi_dot3(offset, drag);
    out[DMI_NEIGHBOUR_HAS_DRAG] = dmi_dot3(drag, drag) > 0.5f ? 1 : 0;
    out[DMI_NEIGHBOUR_NORMAL_COSINE] = piece->normal_cosine;
    out[DMI_NEIGHBOUR_REGION_NORMAL_COSINE] = region->normal_cosine;
    out[DMI_NEIGHBOUR_EXCESS_AHEAD] = dmi_fmaxf(piece->high - region->high, 0);
    out[DMI_NEIGHBOUR_EXCESS_BEHIND] = dmi_fmaxf(region->low - piece->low, 0);
    out[DMI_NEIGHBOUR_OFFSET_ALONG] = along;
    out[DMI_NEIGHBOUR_REGION_EXTENT] = region->high - region->low;
    out[DMI_NEIGHBOUR_EXTENT] = piece->high - piece->low;
    out[DMI_NEIGHBOUR_OFFSET_ACROSS] = sqrtf(dmi_fmaxf(dmi_dot3(offset, offset) - along * along, 0));
}

static void write_relation(const dmi_region* region, uint32_t piece, float* out) {
    const dmi_piece_level* level = region->level;
    out[DMI_NEIGHBOUR_SAME_SHELL] = region->shell_inside[level->shells[piece]];
    out[DMI_NEIGHBOUR_SAME_SHEET] = region->sheet_inside[level->sheets[piece]];
    out[DMI_NEIGHBOUR_REPEAT] = 0;
    for (int i = 0; i < DMI_PIECE_MAX_REPEATS && level->repeats[piece][i] != DMI_PIECE_NONE; i++)
        if (region->inside[level->repeats[piece][i]]) out[DMI_NEIGHBOUR_REPEAT] = 1;
    out[DMI_NEIGHBOUR_REGION_IS_SEED] = region->piece_count == 1;
    out[DMI_NEIGHBOUR_SHEET_IS_CUT] = (float)level->sheet_is_cut;
}

void dmi_region_find_neighbours(dmi_region* region) {
    const dmi_pieces* pieces = &region->level->pieces;
    piece_extent whole = {.area = 0};
    uint32_t region_samples = 0, members = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        if (!region->inside[p]) continue;
        whole = members++ == 0 ? region->extents[p] : merge_extents(&whole, &region->extents[p]);
        region_samples += pieces->first[p + 1] - pieces->first[p];
    }
    const dmi_neighbour_contacts* sums = region->contacts.sums;
    region->neighbour_count = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        if (region->inside[p] || sums[p].with_region + sums[p].from_region == 0) continue;
        float* features = region->features[region->neighbour_count];
        region->neighbours[region->neighbour_count++] = p;
        const float samples = (float)(pieces->first[p + 1] - pieces->first[p]);
        write_contacts(&sums[p], samples, (float)region_samples, features);
        write_sizes(&region->extents[p], &whole, region->level->total_area, features);
        write_drag(&region->extents[p], &whole, region->drag, features);
        write_relation(region, p, features);
    }
}
