/* Sample points of a part, carried along a joint many at a time. */
#ifndef DMI_KINEMATICS_MOVED_H
#define DMI_KINEMATICS_MOVED_H

#include "kinematics/field.h"

/* x = base + cosine * across + sine * beside + shift * axis; a slide has no across and no beside. */
typedef struct dmi_moved {
    float axis[3];
    float base[3][DMI_FIELD_BATCH], across[3][DMI_FIELD_BATCH], beside[3][DMI_FIELD_BATCH];
    uint32_t count;
} dmi_moved;

/* count: at most DMI_FIELD_BATCH. */
void dmi_moved_turn(const float axis[3], const float origin[3], const float (*points)[3], uint32_t count,
                    dmi_moved* out);
void dmi_moved_slide(const float axis[3], const float (*points)[3], uint32_t count, dmi_moved* out);

/* How far the points are from the field's samples at a place of the joint. */
void dmi_moved_distances(const dmi_moved* moved, float cosine, float sine, float shift, const dmi_field* field,
                         float out[DMI_FIELD_BATCH]);

#endif
