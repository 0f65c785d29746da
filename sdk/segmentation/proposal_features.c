/* Computes the features of proposals: of a box that is fitted by principal component analysis, of sums over the
 * contacts, of how the part grew and of what remains. */
#include "segmentation/proposals.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "math/elementary.h"
#include "math/linear3.h"
#include "segmentation/region_contacts.h"

#define MIN_AREA 1e-12f       /* object sizes squared: avoids a division by zero */
#define MIN_AREA_SHARE 1e-9f  /* share of the mesh's area, added to areas that are divided by; by hand */
#define MIN_AREA_ADDED 1e-20f /* object sizes squared, added likewise for meshes without area */
#define MAX_ODDS 8            /* clamp of log odds; by hand */
#define MAX_AREA_RATIO 3.0f   /* clamp of areas and counts relative to the part's; by hand */
#define MAX_BOX_AREA 3        /* clamp of the area relative to the box's surface; by hand */
#define MAX_REST_CONTACTS 2   /* clamp; by hand */
#define MAX_GRAB_OFFSET 2     /* half sides, clamp; by hand */
#define MAX_LOG_NEXT_AREA 6   /* clamp; by hand */
#define BOX_MARGIN 0.5f       /* contact distances, added to boxes where the next piece is compared; by hand */
/* A piece of which more than 4 of 5 samples lie in the box is enclosed; by hand. */
enum { ENCLOSED_SAMPLES = 4, ENCLOSED_OF = 5 };

typedef struct scratch {
    float (*points)[3], (*next_points)[3]; /* samples of the part, of the next piece */
    dmi_remaining_components components;
} scratch;

/* ---- box of a proposal ---- */

#define MIN_BOX_SIDE 1e-6f /* object sizes: the least side that is divided by */

/* Lengths are object-normalised. */
typedef struct proposal_box {
    float centre[3];       /* mean of the samples */
    float axes[3][3];      /* unit rows, largest variance first */
    float low[3], high[3]; /* ends along each axis, from the centre */
    float radius;          /* root mean square distance of the samples from the centre */
    uint32_t samples;
} proposal_box;

#define CELLS 8             /* cells along each side of the box; by hand */
#define MIN_VARIANCE 1e-10f /* object sizes squared: avoids a division by zero */

static proposal_box proposal_box_fit(const float (*points)[3], uint32_t count) {
    proposal_box box = {
        .low = {INFINITY, INFINITY, INFINITY}, .high = {-INFINITY, -INFINITY, -INFINITY}, .samples = count};
    double variances[3];
    dmi_principal3(points, count, box.centre, variances, box.axes);
    box.radius = sqrtf(dmi_fmaxf((float)(variances[0] + variances[1] + variances[2]), MIN_VARIANCE));
    for (uint32_t s = 0; s < count; s++) {
        float offset[3];
        dmi_sub3(points[s], box.centre, offset);
        for (int k = 0; k < 3; k++) {
            const float x = dmi_dot3(offset, box.axes[k]);
            box.low[k] = dmi_fminf(box.low[k], x);
            box.high[k] = dmi_fmaxf(box.high[k], x);
        }
    }
    return box;
}

/* Returns whether the point lies in the box grown by the margin on all sides. */
static bool proposal_box_contains(const proposal_box* box, const float point[3], float margin) {
    float offset[3];
    dmi_sub3(point, box->centre, offset);
    for (int k = 0; k < 3; k++) {
        const float x = dmi_dot3(offset, box->axes[k]);
        if (x < box->low[k] - margin || x > box->high[k] + margin) return false;
    }
    return true;
}

static void mark_cells(const proposal_box* box, const float (*points)[3], uint8_t full[CELLS][CELLS][CELLS]) {
    for (uint32_t s = 0; s < box->samples; s++) {
        float offset[3];
        int cell[3];
        dmi_sub3(points[s], box->centre, offset);
        for (int k = 0; k < 3; k++) {
            const float side = dmi_fmaxf(box->high[k] - box->low[k], MIN_BOX_SIDE);
            const float x = (dmi_dot3(offset, box->axes[k]) - box->low[k]) / side;
            cell[k] = (int)dmi_fminf(dmi_fmaxf(x * CELLS, 0), CELLS - 1);
        }
        full[cell[0]][cell[1]][cell[2]] = 1;
    }
}

/* Computes for each axis the share of occupied cells of the box whose mirror image across it is occupied too. points:
 * those that the box was fitted to. */
static void proposal_box_symmetry(const proposal_box* box, const float (*points)[3], float out[3]) {
    uint8_t full[CELLS][CELLS][CELLS] = {0};
    int count = 0, mirrored[3] = {0, 0, 0};
    mark_cells(box, points, full);
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

/* ---- contacts of a proposal ---- */

/* concave, convex, flush, stacked, stacked with the rest ahead, stacked with the rest behind, same sheet, same shell */
#define CONTACT_KINDS 8

/* Sums over the part's samples that are in contact with the rest; lengths object-normalised. */
typedef struct proposal_contact {
    float count;                            /* the part's samples in contact with the rest */
    float rest_count;                       /* the rest's samples in contact with the part */
    float kinds[CONTACT_KINDS];             /* samples of each kind */
    float centre[3], square;                /* sums of x and of |x|^2 */
    float distance;                         /* unit: contact distances */
    float normal[3][3], right[3], constant; /* normal equations of the speeds, see proposal_contact_turn */
} proposal_contact;

#define DAMPING 0.02f     /* damping of the least squares, share of the matrix's trace; by hand */
#define MIN_DAMPING 1e-6f /* object sizes squared: keeps the matrix invertible; by hand */

static const dmi_piece_contact* nearest_outside(const dmi_pieces* pieces, const uint8_t* inside,
                                                const dmi_piece_sample* sample) {
    const dmi_piece_contact* nearest = NULL;
    for (uint32_t c = 0; c < sample->contact_count; c++) {
        const dmi_piece_contact* contact = &sample->contacts[c];
        if (inside[pieces->samples[contact->sample].piece]) continue;
        if (nearest == NULL || contact->distance < nearest->distance) nearest = contact;
    }
    return nearest;
}

/* Returns whether the sample is in contact with a piece of the part. */
static bool sample_touches(const dmi_pieces* pieces, const uint8_t* inside, const dmi_piece_sample* sample) {
    for (uint32_t c = 0; c < sample->contact_count; c++)
        if (inside[pieces->samples[sample->contacts[c].sample].piece]) return true;
    return false;
}

/* Adds a contact to the normal equations. The grabbed point moves with unit velocity d along the drag and the part
 * turns about it with angular velocity w: the speed along the other surface's normal n is n d + w m, m = arm x n. */
static void add_speed(const dmi_grab* grab, const dmi_piece_sample* sample, const float normal[3],
                      proposal_contact* sums) {
    float arm[3], moment[3];
    const float speed = dmi_dot3(normal, grab->drag);
    dmi_sub3(sample->point, grab->point, arm);
    dmi_cross3(arm, normal, moment);
    sums->constant += speed * speed;
    for (int i = 0; i < 3; i++) {
        sums->right[i] += speed * moment[i];
        for (int k = 0; k < 3; k++) sums->normal[i][k] += moment[i] * moment[k];
    }
}

static void add_contact(const dmi_proposal* part, const dmi_grab* grab, const dmi_piece_sample* sample,
                        const dmi_piece_contact* contact, proposal_contact* sums) {
    const dmi_piece_level* level = part->level;
    const dmi_piece_sample* other = &level->pieces.samples[contact->sample];
    const dmi_contact_kind kind = dmi_contact_classify(&level->pieces, sample, contact, grab->drag);
    const bool kinds[CONTACT_KINDS] = {kind.concave,
                                       kind.convex,
                                       kind.flush,
                                       kind.stacked,
                                       kind.behind,
                                       kind.ahead,
                                       level->sheets[sample->piece] == level->sheets[other->piece],
                                       level->shells[sample->piece] == level->shells[other->piece]};
    for (int i = 0; i < CONTACT_KINDS; i++) sums->kinds[i] += (float)kinds[i];
    dmi_madd3(sums->centre, 1, sample->point, sums->centre);
    sums->square += dmi_dot3(sample->point, sample->point);
    sums->distance += contact->distance / level->pieces.contact_distance;
    sums->count++;
    add_speed(grab, sample, other->normal, sums);
}

static proposal_contact proposal_contact_sum(const dmi_proposal* part, const dmi_grab* grab) {
    const dmi_pieces* pieces = &part->level->pieces;
    proposal_contact sums = {.count = 0};
    for (uint32_t s = 0; s < pieces->first[pieces->count]; s++) {
        const dmi_piece_sample* sample = &pieces->samples[s];
        if (sample->contact_count == 0) continue;
        if (!part->inside[sample->piece]) {
            sums.rest_count += (float)sample_touches(pieces, part->inside, sample);
            continue;
        }
        const dmi_piece_contact* contact = nearest_outside(pieces, part->inside, sample);
        if (contact != NULL) add_contact(part, grab, sample, contact, &sums);
    }
    return sums;
}

static float determinant(const float m[3][3]) {
    float c[3];
    dmi_cross3(m[1], m[2], c);
    return dmi_dot3(m[0], c);
}

/* Returns the mean square speed along the contact normals for a unit velocity of the grabbed point along the drag, with
 * the angular velocity about that point chosen by damped least squares. */
static float proposal_contact_turn(const proposal_contact* sums) {
    float m[3][3], least = sums->constant;
    memcpy(m, sums->normal, sizeof m);
    const float damping = DAMPING * (m[0][0] + m[1][1] + m[2][2]) + MIN_DAMPING;
    for (int i = 0; i < 3; i++) m[i][i] += damping;
    const float whole = determinant((const float(*)[3])m);
    for (int i = 0; i < 3; i++) { /* Cramer's rule; the matrix is symmetric */
        float replaced[3][3];
        memcpy(replaced, m, sizeof replaced);
        dmi_copy3(sums->right, replaced[i]);
        least -= sums->right[i] * determinant((const float(*)[3])replaced) / whole;
    }
    return dmi_fmaxf(least, 0) / dmi_fmaxf(sums->count, 1);
}

/* ---- features ---- */

static float clamp(float x, float limit) {
    return dmi_fminf(dmi_fmaxf(x, -limit), limit);
}

/* ---- how the part grew ---- */

static void write_growth(const dmi_proposal* part, float area, float* out) {
    const dmi_piece_level* level = part->level;
    float carried = 0, sheet = 0, taken = 0;
    uint32_t members = 0;
    for (uint32_t p = 0; p < level->pieces.count; p++) {
        members += part->inside[p] != 0;
        carried += part->inside[p] == DMI_PIECE_CARRIED ? level->pieces.area[p] : 0;
        if (level->sheets[p] != level->sheets[part->seed]) continue;
        sheet += level->pieces.area[p];
        taken += part->inside[p] ? level->pieces.area[p] : 0;
    }
    const float epsilon = MIN_AREA_SHARE * level->total_area + MIN_AREA_ADDED;
    out[DMI_PROPOSAL_LOG_AREA] = dmi_logf((area + epsilon) / level->total_area);
    out[DMI_PROPOSAL_SEED_AREA] = level->pieces.area[part->seed] / (area + epsilon);
    out[DMI_PROPOSAL_LOG_PIECES] = dmi_logf((float)members);
    out[DMI_PROPOSAL_LOWEST_ODDS] = clamp(part->lowest_log_odds, MAX_ODDS);
    out[DMI_PROPOSAL_LAST_ODDS] = clamp(part->last_log_odds, MAX_ODDS);
    out[DMI_PROPOSAL_NEXT_ODDS] = clamp(part->next_log_odds, MAX_ODDS);
    out[DMI_PROPOSAL_SHEET_IS_CUT] = (float)level->sheet_is_cut;
    out[DMI_PROPOSAL_CARRIED_AREA] = carried / (area + epsilon);
    out[DMI_PROPOSAL_LOG_MESH_PIECES] = dmi_logf((float)level->pieces.count);
    out[DMI_PROPOSAL_SHEET_AREA] = sheet / level->total_area;
    out[DMI_PROPOSAL_SHEET_TAKEN] = taken / (sheet + epsilon);
    out[DMI_PROPOSAL_LATER_ODDS] = dmi_fmaxf(part->later_log_odds, -MAX_ODDS);
    out[DMI_PROPOSAL_GROWTH_AREA] = area / dmi_fmaxf(part->final_area, MIN_AREA);
    out[DMI_PROPOSAL_LOG_LIKELY] = dmi_logf(1 + (float)part->likely_count);
    out[DMI_PROPOSAL_LIKELY_AREA] = dmi_fminf(part->likely_area / area, MAX_AREA_RATIO);
}

/* ---- contact and motion ---- */

static void write_contact(const proposal_contact* sums, const proposal_box* box, float* out) {
    const float count = dmi_fmaxf(sums->count, 1), samples = (float)box->samples;
    float centre[3];
    for (int k = 0; k < 3; k++) centre[k] = sums->count > 0 ? sums->centre[k] / count : box->centre[k];
    out[DMI_PROPOSAL_CONTACTS] = sums->count / samples;
    out[DMI_PROPOSAL_REST_CONTACTS] = dmi_fminf(sums->rest_count / samples, MAX_REST_CONTACTS);
    out[DMI_PROPOSAL_CONTACT_SPREAD] =
        sqrtf(dmi_fmaxf(sums->square / count - dmi_dot3(centre, centre), 0)) / box->radius;
    out[DMI_PROPOSAL_CONTACT_OFFSET] = dmi_distance3(centre, box->centre) / box->radius;
    for (int i = 0; i < CONTACT_KINDS; i++) out[DMI_PROPOSAL_CONCAVE + i] = sums->kinds[i] / count;
    out[DMI_PROPOSAL_CONTACT_DISTANCE] = sums->distance / count;
}

static void write_motion(const proposal_contact* sums, const proposal_box* box, const dmi_grab* grab, float* out) {
    out[DMI_PROPOSAL_HAS_DRAG] = dmi_dot3(grab->drag, grab->drag) > 0.5f ? 1 : 0;
    out[DMI_PROPOSAL_SLIDE_SPEED] = sqrtf(sums->constant / dmi_fmaxf(sums->count, 1));
    out[DMI_PROPOSAL_TURN_SPEED] = sqrtf(proposal_contact_turn(sums));
    out[DMI_PROPOSAL_DRAG_LONGEST] = fabsf(dmi_dot3(grab->drag, box->axes[0]));
    out[DMI_PROPOSAL_DRAG_SHORTEST] = fabsf(dmi_dot3(grab->drag, box->axes[2]));
}

/* ---- shape ---- */

static uint32_t gather_points(const dmi_pieces* pieces, const uint8_t* inside, float (*points)[3]) {
    uint32_t count = 0;
    for (uint32_t s = 0; s < pieces->first[pieces->count]; s++)
        if (inside[pieces->samples[s].piece]) dmi_copy3(pieces->samples[s].point, points[count++]);
    return count;
}

static void write_shape(const proposal_box* box, float area, float* out) {
    float side[3];
    for (int k = 0; k < 3; k++) side[k] = dmi_fmaxf(box->high[k] - box->low[k], MIN_BOX_SIDE);
    const float surface = 2 * (side[0] * side[1] + side[1] * side[2] + side[2] * side[0]);
    out[DMI_PROPOSAL_LOG_LENGTH] = dmi_logf(side[0]);
    out[DMI_PROPOSAL_WIDTH] = side[1] / side[0];
    out[DMI_PROPOSAL_THICKNESS] = side[2] / side[0];
    out[DMI_PROPOSAL_BOX_AREA] = dmi_fminf(area / surface, MAX_BOX_AREA);
    out[DMI_PROPOSAL_RADIUS] = box->radius;
    out[DMI_PROPOSAL_LOG_RADIUS] = dmi_logf(box->radius);
}

static void write_grab(const proposal_box* box, const dmi_grab* grab, float* out) {
    float offset[3];
    dmi_sub3(grab->point, box->centre, offset);
    for (int k = 0; k < 3; k++) {
        const float side = dmi_fmaxf(box->high[k] - box->low[k], MIN_BOX_SIDE);
        out[DMI_PROPOSAL_GRAB + k] = dmi_fminf(2 * fabsf(dmi_dot3(offset, box->axes[k])) / side, MAX_GRAB_OFFSET);
    }
}

/* ---- what remains ---- */

/* Counts the rest's samples in the part's box, and sums the area of enclosed pieces outside the largest component. */
static void write_box_contents(const dmi_proposal* part, const proposal_box* box,
                               const dmi_remaining_components* components, float area, float* out) {
    const dmi_pieces* pieces = &part->level->pieces;
    float samples = 0, enclosed = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        uint32_t count = 0, all = pieces->first[p + 1] - pieces->first[p];
        if (part->inside[p]) continue;
        for (uint32_t s = pieces->first[p]; s < pieces->first[p + 1]; s++)
            count += proposal_box_contains(box, pieces->samples[s].point, 0);
        samples += (float)count;
        if (components->roots[p] != components->largest && ENCLOSED_OF * count > ENCLOSED_SAMPLES * all)
            enclosed += pieces->area[p];
    }
    out[DMI_PROPOSAL_REST_IN_BOX] = dmi_fminf(samples / (float)box->samples, MAX_AREA_RATIO);
    out[DMI_PROPOSAL_ENCLOSED_AREA] = dmi_fminf(enclosed / area, MAX_AREA_RATIO);
}

static void write_detached(const dmi_proposal* part, const dmi_remaining_components* components, float area,
                           float* out) {
    float detached = 0;
    for (uint32_t p = 0; p < part->level->pieces.count; p++)
        if (!part->inside[p] && components->roots[p] == p && p != components->largest && components->touches_part[p])
            detached += components->area[p];
    out[DMI_PROPOSAL_DETACHED_AREA] = dmi_fminf(detached / area, MAX_AREA_RATIO);
}

static void write_repeats(const dmi_proposal* part, float area, float* out) {
    const dmi_piece_level* level = part->level;
    float shares[2] = {0, 0}; /* those with a repeat outside, inside */
    for (uint32_t p = 0; p < level->pieces.count; p++) {
        bool found[2] = {false, false};
        if (!part->inside[p]) continue;
        for (int i = 0; i < DMI_PIECE_MAX_REPEATS && level->repeats[p][i] != DMI_PIECE_NONE; i++)
            found[part->inside[level->repeats[p][i]] != 0] = true;
        for (int i = 0; i < 2; i++)
            if (found[i]) shares[i] += level->pieces.area[p] / area;
    }
    out[DMI_PROPOSAL_REPEATS_OUTSIDE] = shares[0];
    out[DMI_PROPOSAL_REPEATS_INSIDE] = shares[1];
}

/* ---- the next piece ---- */

static void write_next(const dmi_proposal* part, const proposal_box* box, float area, const scratch* work, float* out) {
    const dmi_piece_level* level = part->level;
    const dmi_pieces* pieces = &level->pieces;
    const uint32_t next = part->next_piece;
    if (next == DMI_PIECE_NONE || part->inside[next]) return;
    const float margin = BOX_MARGIN * pieces->contact_distance;
    const uint32_t first = pieces->first[next], count = pieces->first[next + 1] - first;
    uint32_t in_box = 0, in_next_box = 0, touching = 0;
    for (uint32_t s = first; s < first + count; s++) {
        dmi_copy3(pieces->samples[s].point, work->next_points[s - first]);
        in_box += proposal_box_contains(box, pieces->samples[s].point, margin);
        touching += sample_touches(pieces, part->inside, &pieces->samples[s]);
    }
    const proposal_box next_box = proposal_box_fit((const float(*)[3])work->next_points, count);
    for (uint32_t s = 0; s < box->samples; s++)
        in_next_box += proposal_box_contains(&next_box, work->points[s], margin);
    out[DMI_PROPOSAL_NEXT_IN_BOX] = (float)in_box / (float)count;
    out[DMI_PROPOSAL_IN_NEXT_BOX] = (float)in_next_box / (float)box->samples;
    out[DMI_PROPOSAL_LOG_NEXT_AREA] =
        clamp(dmi_logf(dmi_fmaxf(pieces->area[next], MIN_AREA) / area), MAX_LOG_NEXT_AREA);
    out[DMI_PROPOSAL_NEXT_CONTACTS] = (float)touching / (float)count;
    for (int i = 0; i < DMI_PIECE_MAX_REPEATS && level->repeats[next][i] != DMI_PIECE_NONE; i++)
        if (part->inside[level->repeats[next][i]]) out[DMI_PROPOSAL_NEXT_REPEATS] = 1;
}

/* ---- all of them ---- */

static void measure(dmi_proposal* part, const dmi_grab* grab, scratch* work) {
    const dmi_pieces* pieces = &part->level->pieces;
    float* out = part->features;
    memset(out, 0, sizeof part->features);
    dmi_remaining_components_find(pieces, part->inside, &work->components);
    const float area = dmi_fmaxf(work->components.part_area, MIN_AREA);
    const uint32_t count = gather_points(pieces, part->inside, work->points);
    const proposal_box box = proposal_box_fit((const float(*)[3])work->points, count);
    const proposal_contact sums = proposal_contact_sum(part, grab);
    write_growth(part, area, out);
    write_contact(&sums, &box, out);
    write_motion(&sums, &box, grab, out);
    write_shape(&box, area, out);
    write_box_contents(part, &box, &work->components, area, out);
    write_detached(part, &work->components, area, out);
    write_repeats(part, area, out);
    write_grab(&box, grab, out);
    proposal_box_symmetry(&box, (const float(*)[3])work->points, out + DMI_PROPOSAL_SYMMETRY);
    write_next(part, &box, area, work, out);
}

/* Returns the pieces with the most samples, NULL without proposals: scratch memory is made for them. */
static const dmi_pieces* largest_level(const dmi_proposals* proposals) {
    uint32_t samples = 0;
    const dmi_pieces* largest = NULL;
    for (uint32_t i = 0; i < proposals->count; i++) {
        const dmi_pieces* pieces = &proposals->items[i].level->pieces;
        if (pieces->first[pieces->count] < samples) continue;
        samples = pieces->first[pieces->count];
        largest = pieces;
    }
    return largest;
}

dm_result dmi_proposals_measure(dmi_arena* arena, const dmi_grab* grab, dmi_proposals* proposals) {
    scratch work = {.points = NULL};
    const dmi_pieces* largest = largest_level(proposals);
    if (largest == NULL) return DM_OK;
    const uint32_t samples = largest->first[largest->count];
    work.points = dmi_arena_push(arena, samples * sizeof *work.points);
    work.next_points = dmi_arena_push(arena, samples * sizeof *work.next_points);
    if (work.points == NULL || work.next_points == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u samples", samples);
    dm_result result = dmi_remaining_components_make(arena, largest, &work.components);
    if (result != DM_OK) return result;
    for (uint32_t i = 0; i < proposals->count; i++) measure(&proposals->items[i], grab, &work);
    return DM_OK;
}
