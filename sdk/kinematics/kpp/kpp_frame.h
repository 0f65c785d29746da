/* The frame of KPP-Net's input: origin and scale of the part, axes along the Manhattan frame of part and body, ordered
 * and signed by the drag. */
#ifndef DMI_KPP_KPP_FRAME_H
#define DMI_KPP_KPP_FRAME_H

#include "math/joint.h"
#include "math/linear3.h"
#include "mesh/cloud.h"

#define DMI_KPP_SUBSETS 4 /* disjoint subsets of a cloud */
/* Points of the subset's blocks (docs/networks.md). */
#define DMI_KPP_PART_POINTS 512
#define DMI_KPP_NEAR_POINTS 256
#define DMI_KPP_BODY_POINTS 256
#define DMI_KPP_POINTS (DMI_KPP_PART_POINTS + DMI_KPP_NEAR_POINTS + DMI_KPP_BODY_POINTS)

typedef struct dmi_kpp_subset {
    const float (*part)[3], (*near)[3], (*body)[3];
    const float (*part_normals)[3], (*near_normals)[3], (*body_normals)[3];
} dmi_kpp_subset;

static inline dmi_kpp_subset dmi_kpp_subset_of(const dmi_cloud* cloud, uint32_t index) {
    const float(*xyz)[3] = (const float(*)[3])cloud->xyz, (*normal)[3] = (const float(*)[3])cloud->normal;
    const uint32_t part = index * DMI_KPP_PART_POINTS, near = DMI_CLOUD_PART + index * DMI_KPP_NEAR_POINTS;
    const uint32_t body = DMI_CLOUD_PART + DMI_CLOUD_NEAR + index * DMI_KPP_BODY_POINTS;
    return (dmi_kpp_subset){xyz + part, xyz + near, xyz + body, normal + part, normal + near, normal + body};
}

/* y = (rotation (x - origin)) * scale. The rows of rotation are the frame's axes; x is object-normalised. */
typedef struct dmi_kpp_frame {
    float rotation[3 * 3];
    float origin[3];
    float scale;
} dmi_kpp_frame;

/* What the frame and the shape features are made from; object-normalised. */
typedef struct dmi_kpp_geometry {
    float centre[3];       /* mean of the part's points */
    float near_offset[3];  /* vector from there to the mean of the near points */
    float radius;          /* largest distance of a point of the part from the centre */
    float principal[3][3]; /* directions of the part's points, largest variance first */
    float part_axes[3][3], body_axes[3][3], all_axes[3][3]; /* Manhattan frames */
    float part_fit, body_fit, all_fit;                      /* shares, as of dmi_manhattan_frame_fit */
} dmi_kpp_geometry;

/* Rotates a vector into the frame, without scaling it. */
static inline void dmi_kpp_frame_rotate(const dmi_kpp_frame* frame, const float v[3], float out[3]) {
    for (int r = 0; r < 3; r++) out[r] = dmi_dot3(frame->rotation + 3 * (size_t)r, v);
}

void dmi_kpp_geometry_make(const dmi_kpp_subset* subset, dmi_kpp_geometry* out);
/* Makes the frame. hint: NULL when there is no drag. */
void dmi_kpp_frame_make(const dmi_cloud* cloud, const dmi_kpp_subset* subset, const dmi_drag_hint* hint,
                        const dmi_kpp_geometry* geometry, dmi_kpp_frame* out);
/* Transforms a point into the frame. Lengths above 2 are shortened to 2 + ln(length / 2), so that a small part of a
 * large object keeps its scale. */
void dmi_kpp_frame_point_in(const dmi_kpp_frame* frame, const float x[3], float out[3]);

/* ---- manhattan_frame.c: a step of making the geometry ---- */

/* A Manhattan frame (Straub et al. 2014) is the three perpendicular directions that most surface normals are parallel
 * to. Joint axes of manufactured objects are mostly parallel to one of them. */

/* Unit normals in one block or two. */
typedef struct dmi_normals {
    const float (*first)[3];
    uint32_t first_count;
    const float (*second)[3];
    uint32_t second_count;
} dmi_normals;

/* Computes a start for the fit: the eigenvectors (rows) of the sum of n n^T over the normals, largest eigenvalue first.
 */
void dmi_manhattan_frame_guess(const dmi_normals* normals, float out_axes[3][3]);

/* Rotates the perpendicular unit rows `axes` to fit the normals near them. Returns the share of normals within 8
 * degrees of an axis, 0 .. 1. */
float dmi_manhattan_frame_fit(const dmi_normals* normals, float axes[3][3]);

#endif
