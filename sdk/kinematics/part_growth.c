/* What tells whether a piece that touches a part belongs to it: how they touch, their sizes, and how both lie to the
 * drag. */
#include <string.h>

#include "kinematics/linear3.h"
#include "kinematics/part_finder.h"

enum { CONTACT, SIZE = 7, SHELL = 13, DRAG = 14, ALONE = 25 };
static const float flush_cosine = 0.9f, flush_offset = 0.35f, stack_offset = 0.7f;

/* A piece, or several: area moments, and extent along the drag. */
typedef struct dmi_piece_shape {
    float area, centre[3], square; /* square: area-weighted mean of |x|^2 */
    float low, high;               /* along the drag */
    float across;                  /* mean |cosine| between normals and the drag */
} piece_shape;

/* How a piece touches the part, in numbers of samples. */
typedef struct dmi_touch_sums {
    uint32_t part, others, back, flush, stack, front, behind;
    float distance;
} touch_sums;

static piece_shape measure(const dmi_pieces* pieces, const float drag[3], uint32_t piece) {
    piece_shape out = {.area = pieces->area[piece], .low = INFINITY, .high = -INFINITY};
    const uint32_t first = pieces->first[piece], end = pieces->first[piece + 1];
    const float share = 1 / (float)(end - first);
    for (uint32_t s = first; s < end; s++) {
        const dmi_piece_sample* sample = &pieces->samples[s];
        const float height = dmi_dot3(sample->point, drag);
        dmi_madd3(out.centre, share, sample->point, out.centre);
        out.square += share * dmi_dot3(sample->point, sample->point);
        out.low = fminf(out.low, height);
        out.high = fmaxf(out.high, height);
        out.across += share * fabsf(dmi_dot3(sample->normal, drag));
    }
    return out;
}

static piece_shape join(const piece_shape* a, const piece_shape* b) {
    piece_shape out = {.area = a->area + b->area, .low = fminf(a->low, b->low), .high = fmaxf(a->high, b->high)};
    const float share = out.area > 0 ? b->area / out.area : 0.5f;
    for (int k = 0; k < 3; k++) out.centre[k] = (1 - share) * a->centre[k] + share * b->centre[k];
    out.square = (1 - share) * a->square + share * b->square;
    out.across = (1 - share) * a->across + share * b->across;
    return out;
}

/* Root mean square distance from the centre. */
static float radius(const piece_shape* shape) {
    return sqrtf(fmaxf(shape->square - dmi_dot3(shape->centre, shape->centre), 1e-10f));
}

dm_result dmi_growth_make(dmi_arena* arena, const dmi_pieces* pieces, const uint32_t* shells, const float drag[3],
                          dmi_growth* out) {
    *out = (dmi_growth){.pieces = pieces, .shells = shells};
    dmi_copy3(drag, out->drag);
    out->inside = dmi_arena_push(arena, pieces->count);
    out->features = dmi_arena_push(arena, pieces->count * sizeof *out->features);
    out->touching = dmi_arena_push(arena, pieces->count * sizeof *out->touching);
    out->shapes = dmi_arena_push(arena, pieces->count * sizeof *out->shapes);
    out->sums = dmi_arena_push(arena, pieces->count * sizeof *out->sums);
    if (!out->inside || !out->features || !out->touching || !out->shapes || !out->sums)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to grow a part of %u pieces", pieces->count);
    memset(out->inside, 0, pieces->count);
    for (uint32_t p = 0; p < pieces->count; p++) out->shapes[p] = measure(pieces, out->drag, p);
    return DM_OK;
}

void dmi_growth_add(dmi_growth* growth, uint32_t piece) {
    growth->inside[piece] = 1;
    growth->member_count++;
}

/* One sample of a piece outside that touches the part. */
static void add_touch(const dmi_growth* growth, const dmi_piece_sample* sample, const dmi_piece_touch* touch,
                      touch_sums* sums) {
    const dmi_piece_sample* other = &growth->pieces->samples[touch->sample];
    float apart[3];
    dmi_sub3(sample->point, other->point, apart);
    const float offset = fabsf(dmi_dot3(apart, sample->normal)) / fmaxf(touch->distance, 1e-9f);
    const float ahead = dmi_dot3(apart, growth->drag) / growth->pieces->reach;
    if (fabsf(dmi_dot3(sample->normal, other->normal)) > flush_cosine) {
        const int stacked = offset > stack_offset;
        sums->flush += offset < flush_offset;
        sums->stack += (uint32_t)stacked;
        sums->front += stacked && ahead > 0.3f;
        sums->behind += stacked && ahead < -0.3f;
    }
    sums->distance += touch->distance / growth->pieces->reach;
}

static void sum_sample(dmi_growth* growth, const dmi_piece_sample* sample) {
    touch_sums* sums = growth->sums;
    const dmi_piece_touch* nearest = NULL;
    int others = 0;
    for (uint32_t t = 0; t < sample->touch_count; t++) {
        const dmi_piece_touch* touch = &sample->touches[t];
        const uint32_t piece = growth->pieces->samples[touch->sample].piece;
        if (growth->inside[sample->piece] && !growth->inside[piece]) sums[piece].back++;
        if (growth->inside[sample->piece]) continue;
        if (!growth->inside[piece])
            others = 1;
        else if (nearest == NULL || touch->distance < nearest->distance)
            nearest = touch;
    }
    sums[sample->piece].others += (uint32_t)others;
    if (nearest == NULL) return;
    sums[sample->piece].part++;
    add_touch(growth, sample, nearest, &sums[sample->piece]);
}

static void write_features(const dmi_growth* growth, uint32_t piece, const piece_shape* part, uint32_t part_samples,
                           float total, float* out) {
    const touch_sums* sums = &growth->sums[piece];
    const piece_shape *own = &growth->shapes[piece], both = join(part, own);
    const float count = (float)(growth->pieces->first[piece + 1] - growth->pieces->first[piece]);
    const float touches = fmaxf((float)sums->part, 1);
    float* contact = out + CONTACT;
    contact[0] = (float)sums->part / fmaxf((float)(sums->part + sums->others), 1);
    contact[1] = (float)sums->part / count;
    contact[2] = (float)sums->others / count;
    contact[3] = (float)sums->back / (float)part_samples;
    contact[4] = (float)sums->flush / touches;
    contact[5] = (float)sums->stack / touches;
    contact[6] = sums->distance / touches;
    float* size = out + SIZE;
    size[0] = fminf(fmaxf(logf(fmaxf(own->area, 1e-12f) / fmaxf(part->area, 1e-12f)), -6), 6);
    size[1] = own->area / total;
    size[2] = part->area / total;
    size[3] = radius(own);
    size[4] = radius(part);
    size[5] = fminf(logf(radius(&both) / radius(part)), 3);
    float* drag = out + DRAG;
    float apart[3];
    dmi_sub3(own->centre, part->centre, apart);
    const float along = dmi_dot3(apart, growth->drag);
    drag[0] = dmi_dot3(growth->drag, growth->drag) > 0.5f ? 1 : 0;
    drag[1] = own->across;
    drag[2] = part->across;
    drag[3] = fmaxf(own->high - part->high, 0);
    drag[4] = fmaxf(part->low - own->low, 0);
    drag[5] = along;
    drag[6] = part->high - part->low;
    drag[7] = own->high - own->low;
    drag[8] = sqrtf(fmaxf(dmi_dot3(apart, apart) - along * along, 0));
    drag[9] = (float)sums->front / touches;
    drag[10] = (float)sums->behind / touches;
    out[ALONE] = growth->member_count == 1;
}

void dmi_growth_look(dmi_growth* growth) {
    const dmi_pieces* pieces = growth->pieces;
    piece_shape part = {.area = 0};
    uint32_t part_samples = 0, members = 0;
    float total = 0;
    memset(growth->sums, 0, pieces->count * sizeof *growth->sums);
    for (uint32_t p = 0; p < pieces->count; p++) {
        total += pieces->area[p];
        if (!growth->inside[p]) continue;
        part = members++ == 0 ? growth->shapes[p] : join(&part, &growth->shapes[p]);
        part_samples += pieces->first[p + 1] - pieces->first[p];
    }
    for (uint32_t s = 0; s < pieces->first[pieces->count]; s++) sum_sample(growth, &pieces->samples[s]);
    growth->touching_count = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        if (growth->inside[p] || growth->sums[p].part + growth->sums[p].back == 0) continue;
        growth->touching[growth->touching_count++] = p;
        write_features(growth, p, &part, part_samples, total, growth->features[p]);
        growth->features[p][SHELL] = 0;
        for (uint32_t q = 0; q < pieces->count; q++)
            if (growth->inside[q] && growth->shells[q] == growth->shells[p]) growth->features[p][SHELL] = 1;
    }
}
