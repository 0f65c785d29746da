/* The directions a shape is built along, read from its normals: made things are mostly made of three perpendicular
 * families of faces, and joints mostly follow one of them. */
#ifndef DMI_KPP_MANHATTAN_FRAME_H
#define DMI_KPP_MANHATTAN_FRAME_H

#include <stdint.h>

/* Unit normals, in up to two blocks (part and body, or one alone). */
typedef struct dmi_normals {
    const float (*first)[3];
    uint32_t first_count;
    const float (*second)[3];
    uint32_t second_count;
} dmi_normals;

/* Principal directions (rows) of the normals taken as lines: the dominant face first, a turned shape's axis last. */
void dmi_manhattan_frame_guess(const dmi_normals* normals, float out_axes[3][3]);

/* Turns the perpendicular directions `axes` until they fit the normals near them best, and answers the share of the
 * normals that lie along one of them (within 8 degrees). */
float dmi_manhattan_frame_fit(const dmi_normals* normals, float axes[3][3]);

#endif
