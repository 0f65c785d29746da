/* Compares the squared distances to all faces. */
#include "segmentation/nearest_face.h"

#include "math/elementary.h"
#include "math/linear3.h"

enum { CLOSED_TRIANGLE = 4 }; /* the three corners and the first one again */

/* Returns the squared distance of p from the segment a b. */
static float segment_distance(const float p[3], const float a[3], const float b[3]) {
    float along[3], offset[3], nearest[3];
    dmi_sub3(b, a, along), dmi_sub3(p, a, offset);
    const float length = dmi_dot3(along, along);
    const float t = length > 0 ? dmi_fminf(dmi_fmaxf(dmi_dot3(offset, along) / length, 0), 1) : 0;
    dmi_madd3(a, t, along, nearest);
    dmi_sub3(p, nearest, offset);
    return dmi_dot3(offset, offset);
}

/* Returns the squared distance of p from the triangle a b c, by barycentric coordinates (Ericson, Real-Time Collision
 * Detection, 2005, 3.4 and 5.1.5). */
static float triangle_distance(const float p[3], const float a[3], const float b[3], const float c[3]) {
    float ab[3], ac[3], ap[3], nearest[3], offset[3];
    dmi_sub3(b, a, ab), dmi_sub3(c, a, ac), dmi_sub3(p, a, ap);
    const float d00 = dmi_dot3(ab, ab), d01 = dmi_dot3(ab, ac), d11 = dmi_dot3(ac, ac);
    const float d20 = dmi_dot3(ap, ab), d21 = dmi_dot3(ap, ac), area = d00 * d11 - d01 * d01;
    float v = area > 0 ? (d11 * d20 - d01 * d21) / area : -1, w = area > 0 ? (d00 * d21 - d01 * d20) / area : -1;
    if (v >= 0 && w >= 0 && v + w <= 1) {
        for (int k = 0; k < 3; k++) nearest[k] = a[k] + v * ab[k] + w * ac[k];
        dmi_sub3(p, nearest, offset);
        return dmi_dot3(offset, offset);
    }
    const float* corners[CLOSED_TRIANGLE] = {a, b, c, a};
    float best = INFINITY;
    for (int i = 0; i < 3; i++) best = dmi_fminf(best, segment_distance(p, corners[i], corners[i + 1]));
    return best;
}

dm_result dmi_mesh_nearest_face(const dmi_mesh* mesh, const float point[3], const dmi_progress* progress,
                                uint32_t* out_face) {
    float least = INFINITY;
    *out_face = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t* corner = mesh->indices + (size_t)f * 3;
        const float distance =
            triangle_distance(point, mesh->positions + (size_t)corner[0] * 3, mesh->positions + (size_t)corner[1] * 3,
                              mesh->positions + (size_t)corner[2] * 3);
        if (distance < least) *out_face = f;
        least = dmi_fminf(distance, least);
        if (dmi_progress_step(progress, f, mesh->face_count) != DM_OK) return DM_ERROR_CANCELLED;
    }
    return DM_OK;
}
