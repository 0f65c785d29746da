/* What tells whether a set of pieces is the part that was grabbed: how it grew, how it touches the rest, whether it
 * could move there, its shape, and what is repeated or left hanging. */
#include "segmentation/part_choice.h"

#include <string.h>

#include "math/linear3.h"

enum { GROWTH, CONTACT = 8, MOTION = 20, SHAPE = 25, REST = 34, GRAB = 39, SYMMETRY = 42, NEXT = 45 };
#define CELLS 8 /* along each side of the box, to see whether a part is its own mirror image */
#define MOST_SHARE 3.0f

/* Sums over the samples of the part that touch the rest. */
typedef struct contact_sums {
    float count, back;       /* of the part, of the rest */
    float kinds[8];          /* concave, convex, flush, stacked, front, behind, of one sheet, of one shell */
    float centre[3], square; /* of the contact */
    float distance;          /* in reaches */
    float turning[3][3], along[3], slide; /* least squares of the normal speed, see turn_freely */
} contact_sums;

typedef struct scratch {
    float (*points)[3], (*others)[3]; /* of the part, of another piece */
    dmi_part_groups groups;
} scratch;

/* ---- contact ---- */

static const dmi_piece_touch* nearest_outside(const dmi_pieces* pieces, const uint8_t* inside,
                                              const dmi_piece_sample* sample) {
    const dmi_piece_touch* nearest = NULL;
    for (uint32_t t = 0; t < sample->touch_count; t++) {
        const dmi_piece_touch* touch = &sample->touches[t];
        if (inside[pieces->samples[touch->sample].piece]) continue;
        if (nearest == NULL || touch->distance < nearest->distance) nearest = touch;
    }
    return nearest;
}

static int touches_inside(const dmi_pieces* pieces, const uint8_t* inside, const dmi_piece_sample* sample) {
    for (uint32_t t = 0; t < sample->touch_count; t++)
        if (inside[pieces->samples[sample->touches[t].sample].piece]) return 1;
    return 0;
}

/* The part moves with the drag's velocity at the grabbed point, and turns about it at some rate w: at a contact its
 * speed along the other surface's normal n is n d + w m, m = arm x n. */
static void add_speed(const dmi_grab* grab, const dmi_piece_sample* sample, const float normal[3], contact_sums* sums) {
    float arm[3], turn[3];
    const float speed = dmi_dot3(normal, grab->drag);
    dmi_sub3(sample->point, grab->point, arm);
    dmi_cross3(arm, normal, turn);
    sums->slide += speed * speed;
    for (int i = 0; i < 3; i++) {
        sums->along[i] += speed * turn[i];
        for (int k = 0; k < 3; k++) sums->turning[i][k] += turn[i] * turn[k];
    }
}

static void add_contact(const dmi_proposal* part, const dmi_grab* grab, const dmi_piece_sample* sample,
                        const dmi_piece_touch* touch, contact_sums* sums) {
    const dmi_part_level* level = part->level;
    const dmi_piece_sample* other = &level->pieces.samples[touch->sample];
    const dmi_touch_kind kind = dmi_touch_classify(&level->pieces, sample, touch, grab->drag);
    const int kinds[8] = {kind.concave,
                          kind.convex,
                          kind.flush,
                          kind.stacked,
                          kind.stacked && kind.ahead < -0.3f, /* the rest lies in the part's way */
                          kind.stacked && kind.ahead > 0.3f,
                          level->sheets[sample->piece] == level->sheets[other->piece],
                          level->shells[sample->piece] == level->shells[other->piece]};
    for (int i = 0; i < 8; i++) sums->kinds[i] += (float)kinds[i];
    dmi_madd3(sums->centre, 1, sample->point, sums->centre);
    sums->square += dmi_dot3(sample->point, sample->point);
    sums->distance += touch->distance / level->pieces.reach;
    sums->count++;
    add_speed(grab, sample, other->normal, sums);
}

static contact_sums sum_contacts(const dmi_proposal* part, const dmi_grab* grab) {
    const dmi_pieces* pieces = &part->level->pieces;
    contact_sums sums = {.count = 0};
    for (uint32_t s = 0; s < pieces->first[pieces->count]; s++) {
        const dmi_piece_sample* sample = &pieces->samples[s];
        if (sample->touch_count == 0) continue;
        if (!part->inside[sample->piece]) {
            sums.back += (float)touches_inside(pieces, part->inside, sample);
            continue;
        }
        const dmi_piece_touch* touch = nearest_outside(pieces, part->inside, sample);
        if (touch != NULL) add_contact(part, grab, sample, touch, &sums);
    }
    return sums;
}

/* ---- motion ---- */

static float determinant(const float m[3][3]) {
    float c[3];
    dmi_cross3(m[1], m[2], c);
    return dmi_dot3(m[0], c);
}

/* Mean square of the normal speed at the contacts when the part turns as suits them best, a little damped. */
static float turn_freely(const contact_sums* sums) {
    float m[3][3], least = sums->slide;
    memcpy(m, sums->turning, sizeof m);
    const float damping = 0.02f * (m[0][0] + m[1][1] + m[2][2]) + 1e-6f;
    for (int i = 0; i < 3; i++) m[i][i] += damping;
    const float whole = determinant((const float(*)[3])m);
    for (int i = 0; i < 3; i++) { /* Cramer's rule; the matrix is symmetric */
        float replaced[3][3];
        memcpy(replaced, m, sizeof replaced);
        dmi_copy3(sums->along, replaced[i]);
        least -= sums->along[i] * determinant((const float(*)[3])replaced) / whole;
    }
    return fmaxf(least, 0) / fmaxf(sums->count, 1);
}

/* ---- shape ---- */

typedef struct part_box {
    float centre[3], axes[3][3], low[3], high[3], radius;
    uint32_t samples;
} part_box;

static uint32_t gather_points(const dmi_pieces* pieces, const uint8_t* inside, float (*points)[3]) {
    uint32_t count = 0;
    for (uint32_t s = 0; s < pieces->first[pieces->count]; s++)
        if (inside[pieces->samples[s].piece]) dmi_copy3(pieces->samples[s].point, points[count++]);
    return count;
}

static part_box fit_box(const float (*points)[3], uint32_t count) {
    part_box box = {.low = {INFINITY, INFINITY, INFINITY}, .high = {-INFINITY, -INFINITY, -INFINITY}, .samples = count};
    double variances[3];
    dmi_principal3(points, count, box.centre, variances, box.axes);
    box.radius = sqrtf(fmaxf((float)(variances[0] + variances[1] + variances[2]), 1e-10f));
    for (uint32_t s = 0; s < count; s++) {
        float off[3];
        dmi_sub3(points[s], box.centre, off);
        for (int k = 0; k < 3; k++) {
            const float x = dmi_dot3(off, box.axes[k]);
            box.low[k] = fminf(box.low[k], x);
            box.high[k] = fmaxf(box.high[k], x);
        }
    }
    return box;
}

static int is_in_box(const part_box* box, const float point[3], float margin) {
    float off[3];
    dmi_sub3(point, box->centre, off);
    for (int k = 0; k < 3; k++) {
        const float x = dmi_dot3(off, box->axes[k]);
        if (x < box->low[k] - margin || x > box->high[k] + margin) return 0;
    }
    return 1;
}

/* Samples of the rest that lie in the part's box; and the area of its pieces, the largest group's apart, that lie
 * there for the most part. */
static void look_in_box(const dmi_proposal* part, const part_box* box, const dmi_part_groups* groups,
                        float* out_samples, float* out_area) {
    const dmi_pieces* pieces = &part->level->pieces;
    *out_samples = *out_area = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        uint32_t count = 0;
        if (part->inside[p]) continue;
        for (uint32_t s = pieces->first[p]; s < pieces->first[p + 1]; s++)
            count += (uint32_t)is_in_box(box, pieces->samples[s].point, 0);
        *out_samples += (float)count;
        if (groups->roots[p] != groups->largest && 5 * count > 4 * (pieces->first[p + 1] - pieces->first[p]))
            *out_area += pieces->area[p];
    }
}

/* How much of the part is its own mirror image along each of its axes. */
static void find_symmetry(const part_box* box, const float (*points)[3], float out[3]) {
    uint8_t full[CELLS][CELLS][CELLS] = {0};
    int count = 0, mirrored[3] = {0, 0, 0};
    for (uint32_t s = 0; s < box->samples; s++) {
        float off[3];
        int cell[3];
        dmi_sub3(points[s], box->centre, off);
        for (int k = 0; k < 3; k++) {
            const float x = (dmi_dot3(off, box->axes[k]) - box->low[k]) / fmaxf(box->high[k] - box->low[k], 1e-6f);
            cell[k] = (int)fminf(fmaxf(x * CELLS, 0), CELLS - 1);
        }
        full[cell[0]][cell[1]][cell[2]] = 1;
    }
    for (int i = 0; i < CELLS * CELLS * CELLS; i++) {
        const int x = i / (CELLS * CELLS), y = i / CELLS % CELLS, z = i % CELLS;
        if (!full[x][y][z]) continue;
        count++;
        mirrored[0] += full[CELLS - 1 - x][y][z];
        mirrored[1] += full[x][CELLS - 1 - y][z];
        mirrored[2] += full[x][y][CELLS - 1 - z];
    }
    for (int k = 0; k < 3; k++) out[k] = count > 0 ? (float)mirrored[k] / (float)count : 0;
}

/* Shares of the part's area with a twin outside, and inside. */
static void find_repeats(const dmi_proposal* part, float area, float out[2]) {
    const dmi_part_level* level = part->level;
    out[0] = out[1] = 0;
    for (uint32_t p = 0; p < level->pieces.count; p++) {
        int seen[2] = {0, 0};
        if (!part->inside[p]) continue;
        for (int i = 0; i < DMI_PART_TWINS && level->twins[p][i] != DMI_PART_NONE; i++)
            seen[part->inside[level->twins[p][i]] != 0] = 1;
        for (int i = 0; i < 2; i++)
            if (seen[i]) out[i] += level->pieces.area[p] / area;
    }
}

/* ---- features ---- */

static void write_growth(const dmi_proposal* part, float area, float* out) {
    const dmi_part_level* level = part->level;
    float carried = 0, sheet = 0, taken = 0;
    uint32_t members = 0;
    for (uint32_t p = 0; p < level->pieces.count; p++) {
        members += part->inside[p] != 0;
        carried += part->inside[p] == 2 ? level->pieces.area[p] : 0;
        if (level->sheets[p] != level->sheets[part->seed]) continue;
        sheet += level->pieces.area[p];
        taken += part->inside[p] ? level->pieces.area[p] : 0;
    }
    const float speck = 1e-9f * level->total_area + 1e-20f;
    out[0] = logf((area + speck) / level->total_area);
    out[1] = level->pieces.area[part->seed] / (area + speck);
    out[2] = logf((float)members);
    out[3] = fminf(fmaxf(part->lowest, -8), 8);
    out[4] = fminf(fmaxf(part->last, -8), 8);
    out[5] = fminf(fmaxf(part->next, -8), 8);
    out[6] = (float)level->fine;
    out[7] = carried / (area + speck);
    out[REST + 3] = sheet / level->total_area;
    out[REST + 4] = taken / (sheet + speck);
}

static void write_contact(const contact_sums* sums, const part_box* box, float* out) {
    const float count = fmaxf(sums->count, 1), samples = (float)box->samples;
    float centre[3];
    for (int k = 0; k < 3; k++) centre[k] = sums->count > 0 ? sums->centre[k] / count : box->centre[k];
    out[0] = sums->count / samples;
    out[1] = fminf(sums->back / samples, 2);
    out[2] = sqrtf(fmaxf(sums->square / count - dmi_dot3(centre, centre), 0)) / box->radius;
    out[3] = dmi_distance3(centre, box->centre) / box->radius;
    for (int i = 0; i < 8; i++) out[4 + i] = sums->kinds[i] / count;
}

static void write_motion(const contact_sums* sums, const part_box* box, const dmi_grab* grab, float* out) {
    out[0] = dmi_dot3(grab->drag, grab->drag) > 0.5f ? 1 : 0;
    out[1] = sqrtf(sums->slide / fmaxf(sums->count, 1));
    out[2] = sqrtf(turn_freely(sums));
    out[3] = fabsf(dmi_dot3(grab->drag, box->axes[0]));
    out[4] = fabsf(dmi_dot3(grab->drag, box->axes[2]));
}

static void write_shape(const part_box* box, float area, float in_box, float* out) {
    float extent[3];
    for (int k = 0; k < 3; k++) extent[k] = fmaxf(box->high[k] - box->low[k], 1e-6f);
    const float surface = 2 * (extent[0] * extent[1] + extent[1] * extent[2] + extent[2] * extent[0]);
    out[0] = logf(extent[0]);
    out[1] = extent[1] / extent[0];
    out[2] = extent[2] / extent[0];
    out[3] = fminf(area / surface, 3);
    out[4] = fminf(in_box / (float)box->samples, MOST_SHARE);
    out[5] = box->radius;
    out[6] = logf(box->radius);
}

static void write_grab(const part_box* box, const dmi_grab* grab, float* out) {
    float off[3];
    dmi_sub3(grab->point, box->centre, off);
    for (int k = 0; k < 3; k++)
        out[k] = fminf(2 * fabsf(dmi_dot3(off, box->axes[k])) / fmaxf(box->high[k] - box->low[k], 1e-6f), 2);
}

/* The piece that would join next: is it a part of the same thing, or what the part is mounted on? */
static void write_next(const dmi_proposal* part, const part_box* box, float area, const scratch* work, float* out) {
    const dmi_part_level* level = part->level;
    const dmi_pieces* pieces = &level->pieces;
    const uint32_t next = part->next_piece;
    if (next == DMI_PART_NONE || part->inside[next]) return;
    const uint32_t first = pieces->first[next], count = pieces->first[next + 1] - first;
    uint32_t in = 0, around = 0, touching = 0;
    for (uint32_t s = first; s < first + count; s++) {
        dmi_copy3(pieces->samples[s].point, work->others[s - first]);
        in += (uint32_t)is_in_box(box, pieces->samples[s].point, 0.5f * pieces->reach);
        touching += (uint32_t)touches_inside(pieces, part->inside, &pieces->samples[s]);
    }
    const part_box other = fit_box((const float(*)[3])work->others, count);
    for (uint32_t s = 0; s < box->samples; s++)
        around += (uint32_t)is_in_box(&other, work->points[s], 0.5f * pieces->reach);
    out[0] = (float)in / (float)count;
    out[1] = (float)around / (float)box->samples;
    out[2] = fminf(fmaxf(logf(fmaxf(pieces->area[next], 1e-12f) / area), -6), 6);
    out[3] = (float)touching / (float)count;
    for (int i = 0; i < DMI_PART_TWINS && level->twins[next][i] != DMI_PART_NONE; i++)
        if (part->inside[level->twins[next][i]]) out[4] = 1;
}

static void measure(dmi_proposal* part, const dmi_grab* grab, scratch* work) {
    const dmi_pieces* pieces = &part->level->pieces;
    float *out = part->features, in_box, enclosed;
    memset(out, 0, sizeof part->features);
    dmi_part_groups_find(pieces, part->inside, &work->groups);
    const float area = fmaxf(work->groups.part_area, 1e-12f);
    const part_box box = fit_box((const float(*)[3])work->points, gather_points(pieces, part->inside, work->points));
    const contact_sums sums = sum_contacts(part, grab);
    float stranded = 0;
    for (uint32_t p = 0; p < pieces->count; p++)
        if (!part->inside[p] && work->groups.roots[p] == p && p != work->groups.largest && work->groups.touches[p])
            stranded += work->groups.area[p];
    look_in_box(part, &box, &work->groups, &in_box, &enclosed);
    write_growth(part, area, out + GROWTH);
    write_contact(&sums, &box, out + CONTACT);
    write_motion(&sums, &box, grab, out + MOTION);
    write_shape(&box, area, in_box, out + SHAPE);
    out[SHAPE + 7] = sums.distance / fmaxf(sums.count, 1);
    out[SHAPE + 8] = logf((float)pieces->count);
    out[REST] = fminf(stranded / area, MOST_SHARE);
    find_repeats(part, area, out + REST + 1);
    write_grab(&box, grab, out + GRAB);
    find_symmetry(&box, (const float(*)[3])work->points, out + SYMMETRY);
    write_next(part, &box, area, work, out + NEXT);
    out[NEXT + 5] = fminf(enclosed / area, MOST_SHARE);
    out[NEXT + 6] = fmaxf(part->later, -8);
    out[NEXT + 7] = area / fmaxf(part->whole_area, 1e-12f);
    out[NEXT + 8] = logf(1 + (float)part->likely);
    out[NEXT + 9] = fminf(part->likely_area / area, MOST_SHARE);
}

dm_result dmi_proposals_measure(dmi_arena* arena, const dmi_grab* grab, dmi_proposals* proposals) {
    scratch work = {.points = NULL};
    uint32_t samples = 0;
    const dmi_pieces* largest = NULL;
    for (uint32_t i = 0; i < proposals->count; i++) {
        const dmi_pieces* pieces = &proposals->items[i].level->pieces;
        if (pieces->first[pieces->count] < samples) continue;
        samples = pieces->first[pieces->count];
        largest = pieces;
    }
    if (largest == NULL) return DM_OK;
    work.points = dmi_arena_push(arena, samples * sizeof *work.points);
    work.others = dmi_arena_push(arena, samples * sizeof *work.others);
    if (work.points == NULL || work.others == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u samples", samples);
    dm_result result = dmi_part_groups_make(arena, largest, &work.groups);
    if (result != DM_OK) return result;
    for (uint32_t i = 0; i < proposals->count; i++) measure(&proposals->items[i], grab, &work);
    return DM_OK;
}
