/* Sums over the contacts of a proposal. */
#include "segmentation/proposal_contact.h"

#include <string.h>

#include "math/elementary.h"
#include "math/linear3.h"
#include "segmentation/contact_kind.h"

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

bool dmi_sample_touches(const dmi_pieces* pieces, const uint8_t* inside, const dmi_piece_sample* sample) {
    for (uint32_t c = 0; c < sample->contact_count; c++)
        if (inside[pieces->samples[sample->contacts[c].sample].piece]) return true;
    return false;
}

/* Adds a contact to the normal equations. The grabbed point moves with unit velocity d along the drag and the part
 * turns about it with angular velocity w: the speed along the other surface's normal n is n d + w m, m = arm x n. */
static void add_speed(const dmi_grab* grab, const dmi_piece_sample* sample, const float normal[3],
                      dmi_proposal_contact* sums) {
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
                        const dmi_piece_contact* contact, dmi_proposal_contact* sums) {
    const dmi_piece_level* level = part->level;
    const dmi_piece_sample* other = &level->pieces.samples[contact->sample];
    const dmi_contact_kind kind = dmi_contact_classify(&level->pieces, sample, contact, grab->drag);
    const bool kinds[DMI_PROPOSAL_CONTACT_KINDS] = {kind.concave,
                                                    kind.convex,
                                                    kind.flush,
                                                    kind.stacked,
                                                    kind.behind,
                                                    kind.ahead,
                                                    level->sheets[sample->piece] == level->sheets[other->piece],
                                                    level->shells[sample->piece] == level->shells[other->piece]};
    for (int i = 0; i < DMI_PROPOSAL_CONTACT_KINDS; i++) sums->kinds[i] += (float)kinds[i];
    dmi_madd3(sums->centre, 1, sample->point, sums->centre);
    sums->square += dmi_dot3(sample->point, sample->point);
    sums->distance += contact->distance / level->pieces.contact_distance;
    sums->count++;
    add_speed(grab, sample, other->normal, sums);
}

dmi_proposal_contact dmi_proposal_contact_sum(const dmi_proposal* part, const dmi_grab* grab) {
    const dmi_pieces* pieces = &part->level->pieces;
    dmi_proposal_contact sums = {.count = 0};
    for (uint32_t s = 0; s < pieces->first[pieces->count]; s++) {
        const dmi_piece_sample* sample = &pieces->samples[s];
        if (sample->contact_count == 0) continue;
        if (!part->inside[sample->piece]) {
            sums.rest_count += (float)dmi_sample_touches(pieces, part->inside, sample);
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

float dmi_proposal_contact_turn(const dmi_proposal_contact* sums) {
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
