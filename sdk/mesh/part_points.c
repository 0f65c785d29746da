#include "mesh/part_points.h"

#include <math.h>

#include "math/elementary.h"

static int16_t to_unit(float coordinate) {
    const float steps = floorf(coordinate / DMI_PART_POINT_UNIT + 0.5f);
    return (int16_t)dmi_fminf(dmi_fmaxf(steps, INT16_MIN), INT16_MAX);
}

void dmi_part_points_take(const float (*xyz)[3], size_t step, dmi_part_points* out) {
    for (size_t i = 0; i < DMI_PART_POINTS; i++)
        for (int k = 0; k < 3; k++) out->at[i][k] = to_unit(xyz[i * step][k]);
}

void dmi_part_points_place(const dmi_part_points* points, float out_xyz[DMI_PART_POINTS][3]) {
    for (size_t i = 0; i < DMI_PART_POINTS; i++)
        for (int k = 0; k < 3; k++) out_xyz[i][k] = (float)points->at[i][k] * DMI_PART_POINT_UNIT;
}

void dmi_part_points_of_cloud(const dmi_cloud* cloud, dmi_part_points* out) {
    dmi_part_points_take(cloud->xyz, DMI_CLOUD_POINTS / DMI_PART_POINTS, out);
}
