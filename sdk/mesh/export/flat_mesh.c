/* Meshes that lie in one plane. */
#include "mesh/export/flat_mesh.h"

#include <math.h>

#include "math/elementary.h"

/* Shares of a mesh's size: what is less high lies in one plane, and by how much a corner of that is lifted. By hand. */
static const double flat = 1e-7, lift = 1e-6;

static void cross(const double a[3], const double b[3], double out[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Writes a triangle's normal, twice its area long. Returns six times the volume between it and a corner of the first
 * one: 0 of those that lie in one plane with that. */
static double measure_face(const dmi_rig_mesh* mesh, uint32_t face, double out_normal[3]) {
    const float *a = mesh->points[mesh->faces[face][0]], *first = mesh->points[mesh->faces[0][0]];
    double sides[2][3], volume = 0;
    for (int s = 0; s < 2; s++)
        for (int k = 0; k < 3; k++) sides[s][k] = (double)mesh->points[mesh->faces[face][s + 1]][k] - (double)a[k];
    cross(sides[0], sides[1], out_normal);
    for (int k = 0; k < 3; k++) volume += ((double)a[k] - (double)first[k]) * out_normal[k];
    return fabs(volume);
}

static double length_of(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* The largest side of the box, about whose middle the points are. */
static double size_of(const dmi_rig_mesh* mesh) {
    double half = 0;
    for (uint32_t i = 0; i < mesh->point_count; i++)
        for (int k = 0; k < 3; k++) half = dmi_fmax(half, fabs((double)mesh->points[i][k]));
    return 2 * half;
}

void dmi_lift_corner(dmi_rig_mesh* mesh) {
    const double size = size_of(mesh);
    double volume = 0, area = 0, most = 0, normal[3], up[3];
    uint32_t largest = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        volume += measure_face(mesh, f, normal);
        area += length_of(normal);
        if (length_of(normal) <= most) continue;
        most = length_of(normal);
        largest = f;
    }
    if (!(most > 0) || volume > flat * size * area) return;
    measure_face(mesh, largest, up);
    float* corner = mesh->points[mesh->faces[largest][0]];
    for (int k = 0; k < 3; k++) corner[k] = (float)((double)corner[k] + lift * size * up[k] / most);
}
