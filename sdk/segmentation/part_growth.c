/* What tells whether a piece that touches a part belongs to it: how they touch, their sizes, and how both lie to the
 * drag. */
#include <string.h>

#include "math/linear3.h"
#include "segmentation/part_growth.h"

enum { CONTACT, SIZE = 7, SHELL = 13, DRAG = 14, ALONE = 25, BEND = 26, SHEET = 28, TWIN = 29, FINE = 30 };
static const float flush_cosine = 0.9f, flush_offset = 0.35f, stack_offset = 0.7f, bend_offset = 0.2f;

/* A piece, or several: area moments, and extent along the drag. */
typedef struct dmi_piece_shape {
    float area, centre[3], square; /* square: area-weighted mean of |x|^2 */
    float low, high;               /* along the drag */
    float across;                  /* mean |cosine| between normals and the drag */
} piece_shape;

/* How a piece touches the part, in numbers of samples. */
typedef struct dmi_touch_sums {
    uint32_t part, others, back, flush, stack, front, behind, concave, convex;
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

float dmi_part_net_run(const dmi_part_net* net, const float* features) {
    float score = net->bias;
    for (uint32_t h = 0; h < net->hidden; h++) {
        const float* weights = net->weights + (size_t)h * net->inputs;
        float sum = net->biases[h];
        for (uint32_t i = 0; i < net->inputs; i++) sum += weights[i] * features[i];
        score += net->outputs[h] * fmaxf(sum, 0);
    }
    return score;
}

static uint32_t past_largest(const uint32_t* labels, uint32_t count) {
    uint32_t end = 0;
    for (uint32_t i = 0; i < count; i++)
        if (labels[i] >= end) end = labels[i] + 1;
    return end;
}

dm_result dmi_growth_make(dmi_arena* arena, const dmi_part_level* level, const float drag[3], dmi_growth* out) {
    const dmi_pieces* pieces = &level->pieces;
    const uint32_t shells = past_largest(level->shells, pieces->count);
    const uint32_t sheets = past_largest(level->sheets, pieces->count), samples = pieces->first[pieces->count];
    *out = (dmi_growth){.level = level};
    dmi_copy3(drag, out->drag);
    out->inside = dmi_arena_push(arena, pieces->count);
    out->shell_inside = dmi_arena_push(arena, shells);
    out->sheet_inside = dmi_arena_push(arena, sheets);
    out->features = dmi_arena_push(arena, pieces->count * sizeof *out->features);
    out->touching = dmi_arena_push(arena, pieces->count * sizeof *out->touching);
    out->border = dmi_arena_push(arena, samples * sizeof *out->border);
    out->shapes = dmi_arena_push(arena, pieces->count * sizeof *out->shapes);
    out->sums = dmi_arena_push(arena, pieces->count * sizeof *out->sums);
    if (!out->inside || !out->shell_inside || !out->sheet_inside || !out->features || !out->touching || !out->border ||
        !out->shapes || !out->sums)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to grow a part of %u pieces", pieces->count);
    memset(out->inside, 0, pieces->count);
    memset(out->shell_inside, 0, shells);
    memset(out->sheet_inside, 0, sheets);
    for (uint32_t p = 0; p < pieces->count; p++) out->shapes[p] = measure(pieces, out->drag, p);
    for (uint32_t s = 0; s < samples; s++)
        if (pieces->samples[s].touch_count > 0) out->border[out->border_count++] = s;
    return DM_OK;
}

void dmi_growth_add(dmi_growth* growth, uint32_t piece) {
    growth->inside[piece] = 1;
    growth->shell_inside[growth->level->shells[piece]] = 1;
    growth->sheet_inside[growth->level->sheets[piece]] = 1;
    growth->member_count++;
}

dmi_touch_kind dmi_touch_classify(const dmi_pieces* pieces, const dmi_piece_sample* sample,
                                  const dmi_piece_touch* touch, const float drag[3]) {
    const dmi_piece_sample* other = &pieces->samples[touch->sample];
    const float distance = fmaxf(touch->distance, 1e-9f);
    float apart[3];
    dmi_sub3(sample->point, other->point, apart);
    /* How far each lies before the other's plane. */
    const float own = -dmi_dot3(apart, sample->normal) / distance;
    const float others = dmi_dot3(apart, other->normal) / distance;
    const int parallel = fabsf(dmi_dot3(sample->normal, other->normal)) > flush_cosine;
    return (dmi_touch_kind){.flush = parallel && fabsf(own) < flush_offset,
                            .stacked = parallel && fabsf(own) > stack_offset,
                            .concave = own > bend_offset && others > bend_offset,
                            .convex = own < -bend_offset && others < -bend_offset,
                            .ahead = dmi_dot3(apart, drag) / pieces->reach};
}

/* One sample of a piece outside that touches the part. */
static void add_touch(const dmi_growth* growth, const dmi_piece_sample* sample, const dmi_piece_touch* touch,
                      touch_sums* sums) {
    const dmi_pieces* pieces = &growth->level->pieces;
    const dmi_touch_kind kind = dmi_touch_classify(pieces, sample, touch, growth->drag);
    sums->flush += (uint32_t)kind.flush;
    sums->stack += (uint32_t)kind.stacked;
    sums->concave += (uint32_t)kind.concave;
    sums->convex += (uint32_t)kind.convex;
    sums->front += kind.stacked && kind.ahead > 0.3f;
    sums->behind += kind.stacked && kind.ahead < -0.3f;
    sums->distance += touch->distance / pieces->reach;
}

static void sum_sample(dmi_growth* growth, const dmi_piece_sample* sample) {
    touch_sums* sums = growth->sums;
    const dmi_piece_touch* nearest = NULL;
    int others = 0;
    for (uint32_t t = 0; t < sample->touch_count; t++) {
        const dmi_piece_touch* touch = &sample->touches[t];
        const uint32_t piece = growth->level->pieces.samples[touch->sample].piece;
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

static void write_kinship(const dmi_growth* growth, uint32_t piece, float* out) {
    const dmi_part_level* level = growth->level;
    out[SHELL] = growth->shell_inside[level->shells[piece]];
    out[SHEET] = growth->sheet_inside[level->sheets[piece]];
    out[TWIN] = 0;
    for (int i = 0; i < DMI_PART_TWINS && level->twins[piece][i] != DMI_PART_NONE; i++)
        if (growth->inside[level->twins[piece][i]]) out[TWIN] = 1;
    out[FINE] = (float)level->fine;
}

static void write_features(const dmi_growth* growth, uint32_t piece, const piece_shape* part, uint32_t part_samples,
                           float* out) {
    const touch_sums* sums = &growth->sums[piece];
    const piece_shape *own = &growth->shapes[piece], both = join(part, own);
    const float count = (float)(growth->level->pieces.first[piece + 1] - growth->level->pieces.first[piece]);
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
    size[1] = own->area / growth->level->total_area;
    size[2] = part->area / growth->level->total_area;
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
    out[BEND] = (float)sums->concave / touches;
    out[BEND + 1] = (float)sums->convex / touches;
    write_kinship(growth, piece, out);
}

void dmi_growth_look(dmi_growth* growth) {
    const dmi_pieces* pieces = &growth->level->pieces;
    piece_shape part = {.area = 0};
    uint32_t part_samples = 0, members = 0;
    memset(growth->sums, 0, pieces->count * sizeof *growth->sums);
    for (uint32_t p = 0; p < pieces->count; p++) {
        if (!growth->inside[p]) continue;
        part = members++ == 0 ? growth->shapes[p] : join(&part, &growth->shapes[p]);
        part_samples += pieces->first[p + 1] - pieces->first[p];
    }
    for (uint32_t i = 0; i < growth->border_count; i++) sum_sample(growth, &pieces->samples[growth->border[i]]);
    growth->touching_count = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        if (growth->inside[p] || growth->sums[p].part + growth->sums[p].back == 0) continue;
        growth->touching[growth->touching_count++] = p;
        write_features(growth, p, &part, part_samples, growth->features[p]);
    }
}
