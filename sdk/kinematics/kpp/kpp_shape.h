/* The shape features of KPP-Net's input. */
#ifndef DMI_KPP_KPP_SHAPE_H
#define DMI_KPP_KPP_SHAPE_H

#include <stdbool.h>

#include "kinematics/kpp/kpp_input.h"
#include "kinematics/kpp/kpp_points.h"

/* A drag in the frame; zeros without one. */
typedef struct dmi_kpp_drag {
    float point[3], vector[3]; /* vector: unit */
} dmi_kpp_drag;

/* Computes the features, see DMI_KPP_SHAPE_DIRECTIONS and following. */
void dmi_kpp_shape_make(const dmi_cloud* cloud, const dmi_kpp_frame* frame, const dmi_kpp_geometry* geometry,
                        const dmi_kpp_drag* drag, const dmi_kpp_points* points, float out[DMI_KPP_SHAPE]);
/* Negates the direction unless its component with the largest magnitude is positive. */
void dmi_kpp_sign_line(float line[3]);

#endif
