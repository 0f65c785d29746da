/* Compares each sample's offset from the other's tangent plane with the distance between the samples. */
#include "segmentation/contact_kind.h"

#include "math/elementary.h"
#include "math/linear3.h"

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
