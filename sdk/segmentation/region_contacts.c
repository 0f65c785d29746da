/* Classifies contacts, counts a piece's contacts anew when a piece in contact with it joins the region, and connects
 * the pieces that remain outside. */
#include "segmentation/region_contacts.h"

#include <string.h>

#include "math/elementary.h"
#include "math/linear3.h"

/* ---- kinds of contacts ---- */

#define PARALLEL_COSINE 0.9f /* |cosine| between the normals of parallel faces (26 degrees); by hand */
#define FLUSH_OFFSET 0.35f   /* offset from the own plane, in distances, below which faces are coplanar; by hand */
#define STACKED_OFFSET 0.7f  /* the same, above which one face lies above the other; by hand */
#define BEND_OFFSET 0.2f     /* offset from both planes, in distances, of a concave or convex bend; by hand */
#define AHEAD_OFFSET 0.3f    /* offset along the drag, in contact distances, that counts as ahead; by hand */
#define MIN_DISTANCE 1e-9f   /* object sizes: avoids a division by zero */

dmi_contact_kind dmi_contact_classify(const dmi_pieces* pieces, const dmi_piece_sample* sample,
                                      const dmi_piece_contact* contact, const float drag[3]) {
    const dmi_piece_sample* other = &pieces->samples[contact->sample];
    const float distance = dmi_fmaxf(contact->distance, MIN_DISTANCE);
    float offset[3];
    dmi_sub3(sample->point, other->point, offset);
    /* Signed offsets of the other sample from this one's plane, and of this one from the other's, in distances. */
    const float own = -dmi_dot3(offset, sample->normal) / distance;
    const float others = dmi_dot3(offset, other->normal) / distance;
    const float along = dmi_dot3(offset, drag) / pieces->contact_distance;
    const bool parallel = fabsf(dmi_dot3(sample->normal, other->normal)) > PARALLEL_COSINE;
    const bool stacked = parallel && fabsf(own) > STACKED_OFFSET;
    return (dmi_contact_kind){.flush = parallel && fabsf(own) < FLUSH_OFFSET,
                              .stacked = stacked,
                              .concave = own > BEND_OFFSET && others > BEND_OFFSET,
                              .convex = own < -BEND_OFFSET && others < -BEND_OFFSET,
                              .ahead = stacked && along > AHEAD_OFFSET,
                              .behind = stacked && along < -AHEAD_OFFSET};
}

/* ---- contacts of a region ---- */

static uint32_t piece_of(const dmi_pieces* pieces, const dmi_piece_contact* contact) {
    return pieces->samples[contact->sample].piece;
}

/* ---- lists ---- */

/* Lists the samples that are in contact with another piece. */
static void list_samples(dmi_region_contacts* contacts) {
    const dmi_pieces* pieces = contacts->pieces;
    uint32_t count = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        contacts->first_sample[p] = count;
        for (uint32_t s = pieces->first[p]; s < pieces->first[p + 1]; s++)
            if (pieces->samples[s].contact_count > 0) contacts->samples[count++] = s;
        contacts->sums[p].with_others = count - contacts->first_sample[p];
    }
    contacts->first_sample[pieces->count] = count;
}

/* Lists for each piece those with a sample in contact with it, by a counting sort. A piece comes again for each such
 * sample, side by side. first_of_touching has two entries more than there are pieces. */
static void list_touching(dmi_region_contacts* contacts) {
    const dmi_pieces* pieces = contacts->pieces;
    uint32_t* first = contacts->first_of_touching;
    const uint32_t count = contacts->first_sample[pieces->count];
    memset(first, 0, ((size_t)pieces->count + 2) * sizeof *first);
    for (uint32_t i = 0; i < count; i++) {
        const dmi_piece_sample* sample = &pieces->samples[contacts->samples[i]];
        for (uint32_t c = 0; c < sample->contact_count; c++) first[piece_of(pieces, &sample->contacts[c]) + 2]++;
    }
    for (uint32_t p = 0; p < pieces->count; p++) first[p + 2] += first[p + 1];
    for (uint32_t i = 0; i < count; i++) {
        const dmi_piece_sample* sample = &pieces->samples[contacts->samples[i]];
        for (uint32_t c = 0; c < sample->contact_count; c++)
            contacts->touching_pieces[first[piece_of(pieces, &sample->contacts[c]) + 1]++] = sample->piece;
    }
}

static uint32_t contact_count(const dmi_pieces* pieces) {
    uint32_t count = 0;
    for (uint32_t s = 0; s < pieces->first[pieces->count]; s++) count += pieces->samples[s].contact_count;
    return count;
}

dm_result dmi_region_contacts_make(dmi_arena* arena, const dmi_pieces* pieces, const float drag[3],
                                   dmi_region_contacts* out) {
    const size_t count = pieces->count;
    *out = (dmi_region_contacts){.pieces = pieces};
    dmi_copy3(drag, out->drag);
    out->samples = dmi_arena_push(arena, pieces->first[count] * sizeof *out->samples);
    out->first_sample = dmi_arena_push(arena, (count + 1) * sizeof *out->first_sample);
    out->touching_pieces = dmi_arena_push(arena, contact_count(pieces) * sizeof *out->touching_pieces);
    out->first_of_touching = dmi_arena_push(arena, (count + 2) * sizeof *out->first_of_touching);
    out->sums = dmi_arena_push(arena, count * sizeof *out->sums);
    if (out->samples == NULL || out->first_sample == NULL || out->touching_pieces == NULL ||
        out->first_of_touching == NULL || out->sums == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory for the contacts of %u pieces", pieces->count);
    memset(out->sums, 0, count * sizeof *out->sums);
    list_samples(out);
    list_touching(out);
    return DM_OK;
}

/* ---- sums ---- */

/* Adds the contact of a piece's sample with the region. */
static void add_contact(const dmi_region_contacts* contacts, const dmi_piece_sample* sample,
                        const dmi_piece_contact* contact, dmi_neighbour_contacts* sums) {
    const dmi_contact_kind kind = dmi_contact_classify(contacts->pieces, sample, contact, contacts->drag);
    sums->with_region++;
    sums->flush += kind.flush;
    sums->stacked += kind.stacked;
    sums->concave += kind.concave;
    sums->convex += kind.convex;
    sums->ahead += kind.ahead;
    sums->behind += kind.behind;
    sums->distance += contact->distance / contacts->pieces->contact_distance;
}

/* Adds one sample's contacts to the sums of its piece, which is outside the region. */
static void add_sample(const dmi_region_contacts* contacts, const uint8_t* inside, const dmi_piece_sample* sample,
                       dmi_neighbour_contacts* sums) {
    const dmi_piece_contact* nearest = NULL;
    bool with_others = false;
    for (uint32_t c = 0; c < sample->contact_count; c++) {
        const dmi_piece_contact* contact = &sample->contacts[c];
        if (!inside[piece_of(contacts->pieces, contact)])
            with_others = true;
        else if (nearest == NULL || contact->distance < nearest->distance)
            nearest = contact;
    }
    sums->with_others += with_others;
    if (nearest != NULL) add_contact(contacts, sample, nearest, sums);
}

/* Counts the contacts of one piece outside the region anew. */
static void count_again(dmi_region_contacts* contacts, const uint8_t* inside, uint32_t piece) {
    dmi_neighbour_contacts sums = {.from_region = contacts->sums[piece].from_region};
    for (uint32_t i = contacts->first_sample[piece]; i < contacts->first_sample[piece + 1]; i++)
        add_sample(contacts, inside, &contacts->pieces->samples[contacts->samples[i]], &sums);
    contacts->sums[piece] = sums;
}

void dmi_region_contacts_add(dmi_region_contacts* contacts, const uint8_t* inside, uint32_t piece) {
    const dmi_pieces* pieces = contacts->pieces;
    for (uint32_t i = contacts->first_sample[piece]; i < contacts->first_sample[piece + 1]; i++) {
        const dmi_piece_sample* sample = &pieces->samples[contacts->samples[i]];
        for (uint32_t c = 0; c < sample->contact_count; c++)
            contacts->sums[piece_of(pieces, &sample->contacts[c])].from_region++;
    }
    uint32_t last = DMI_PIECE_NONE;
    for (uint32_t i = contacts->first_of_touching[piece]; i < contacts->first_of_touching[piece + 1]; i++) {
        const uint32_t other = contacts->touching_pieces[i];
        if (other != last && !inside[other]) count_again(contacts, inside, other);
        last = other;
    }
}

/* ---- components of the pieces that remain, with a disjoint-set forest over the pairs in contact ---- */

#define MAX_CARRIED_AREA                                                                                               \
    0.25f /* area of a carried component, in areas of the part: larger ones do not depend on the part;                 \
           * by hand */

/* Returns the root, halving the path to it. */
static uint32_t find_root(uint32_t* parents, uint32_t p) {
    while (parents[p] != p) p = parents[p] = parents[parents[p]];
    return p;
}

dm_result dmi_remaining_components_make(dmi_arena* arena, const dmi_pieces* pieces, dmi_remaining_components* out) {
    *out = (dmi_remaining_components){.largest = DMI_PIECE_NONE};
    out->roots = dmi_arena_push(arena, pieces->count * sizeof *out->roots);
    out->area = dmi_arena_push(arena, pieces->count * sizeof *out->area);
    out->touches_part = dmi_arena_push(arena, pieces->count);
    if (out->roots != NULL && out->area != NULL && out->touches_part != NULL) return DM_OK;
    return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory for the components of %u pieces", pieces->count);
}

void dmi_remaining_components_find(const dmi_pieces* pieces, const uint8_t* inside, dmi_remaining_components* out) {
    const uint32_t count = pieces->count;
    uint32_t* roots = out->roots;
    memset(out->area, 0, count * sizeof *out->area);
    memset(out->touches_part, 0, count);
    for (uint32_t p = 0; p < count; p++) roots[p] = p;
    for (uint32_t i = 0; i < pieces->pair_count; i++) {
        const uint32_t *pair = pieces->pairs[i], a = pair[0], b = pair[1];
        if (!inside[a] && !inside[b]) roots[find_root(roots, a)] = find_root(roots, b);
    }
    for (uint32_t p = 0; p < count; p++) roots[p] = find_root(roots, p);
    for (uint32_t i = 0; i < pieces->pair_count; i++) {
        const uint32_t a = pieces->pairs[i][0], b = pieces->pairs[i][1];
        if (!inside[a] != !inside[b]) out->touches_part[roots[inside[a] ? b : a]] = 1;
    }
    out->part_area = 0;
    out->largest = DMI_PIECE_NONE;
    for (uint32_t p = 0; p < count; p++) *(inside[p] ? &out->part_area : &out->area[roots[p]]) += pieces->area[p];
    for (uint32_t p = 0; p < count; p++)
        if (!inside[p] && roots[p] == p && (out->largest == DMI_PIECE_NONE || out->area[p] > out->area[out->largest]))
            out->largest = p;
}

uint32_t dmi_remaining_components_carry(const dmi_pieces* pieces, const dmi_remaining_components* components,
                                        uint8_t* inside) {
    uint32_t carried = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        const uint32_t root = components->roots[p];
        if (inside[p] || root == components->largest || !components->touches_part[root]) continue;
        if (components->area[root] > MAX_CARRIED_AREA * components->part_area) continue;
        inside[p] = DMI_PIECE_CARRIED;
        carried++;
    }
    return carried;
}
