/* The points of KPP-Net's input in its frame. */
#ifndef DMI_KPP_KPP_POINTS_H
#define DMI_KPP_KPP_POINTS_H

#include "kinematics/kpp/kpp_frame.h"

/* Part, near and body points, in this order. Coordinates are separated, so that distance loops vectorise. */
typedef struct dmi_kpp_points {
    float y[3][DMI_KPP_POINTS];
    float normal[DMI_KPP_POINTS][3];
    float nearness[DMI_KPP_POINTS]; /* 1 / (1 + gap to the other side / half-value gap), 0 .. 1 */
} dmi_kpp_points;

void dmi_kpp_points_make(const dmi_cloud* cloud, const dmi_kpp_subset* subset, const dmi_kpp_frame* frame,
                         dmi_kpp_points* out);

#endif
