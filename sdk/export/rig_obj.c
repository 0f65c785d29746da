/* Prints a mesh as a Wavefront OBJ file, once for all formats that refer to it, and gives a mesh that lies in one plane
 * a volume. */
#include <math.h>

#include "export/rig_formats.h"
#include "math/elementary.h"

/* Shares of a mesh's size; by hand. A mesh that is less high than the first lies in one plane, and a corner of it is
 * lifted by the second. */
static const double flat = 1e-7, lift = 1e-6;
/* Least area times height that a lifted corner adds, m³; by hand: twenty times what MuJoCo 3 asks for. */
static const double least_volume = 2e-13;

static void cross(const double a[3], const double b[3], double out[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Writes a triangle's normal, twice its area long. Returns six times the volume between it and a corner of the first
 * triangle, which is 0 for triangles in one plane with that. */
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

/* Returns the largest side of the box, about whose middle the points are. */
static double size_of(const dmi_rig_mesh* mesh) {
    double half = 0;
    for (uint32_t i = 0; i < mesh->point_count; i++)
        for (int k = 0; k < 3; k++) half = dmi_fmax(half, fabs((double)mesh->points[i][k]));
    return 2 * half;
}

/* Writes by how much the largest triangle's corners are lifted. Returns that triangle, or UINT32_MAX when none has an
 * area. */
static uint32_t find_lift(const dmi_rig_mesh* mesh, double* out_volume, double* out_area, double out_lift[3]) {
    double most = 0, normal[3];
    uint32_t largest = UINT32_MAX;
    *out_volume = *out_area = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        *out_volume += measure_face(mesh, f, normal);
        *out_area += length_of(normal);
        if (length_of(normal) <= most) continue;
        most = length_of(normal);
        largest = f;
    }
    if (largest == UINT32_MAX) return largest;
    measure_face(mesh, largest, normal);
    const double height = dmi_fmax(lift * size_of(mesh), least_volume / most);
    for (int k = 0; k < 3; k++) out_lift[k] = height * normal[k] / most;
    return largest;
}

void dmi_rig_lift_corner(dmi_rig_mesh* mesh, double most) {
    double volume, area, up[3];
    const uint32_t face = find_lift(mesh, &volume, &area, up);
    if (face == UINT32_MAX || volume > flat * size_of(mesh) * area || length_of(up) > most) return;
    float* corner = mesh->points[mesh->faces[face][0]];
    for (int k = 0; k < 3; k++) corner[k] = (float)((double)corner[k] + up[k]);
}

/* Returns whether the mesh has fewer than the four points that MuJoCo 3 asks for. Writes one that makes a second side
 * for a face, with its first two corners. */
static bool find_fourth_point(const dmi_rig_mesh* mesh, uint32_t* out_face, float out_point[3]) {
    double volume, area, up[3];
    if (mesh->point_count >= 4) return false; /* literal: corners of a tetrahedron */
    *out_face = find_lift(mesh, &volume, &area, up);
    if (*out_face == UINT32_MAX) return false;
    for (int k = 0; k < 3; k++) out_point[k] = (float)((double)mesh->points[mesh->faces[*out_face][2]][k] + up[k]);
    return true;
}

/* ---- files ---- */

static void put_point(const float p[3], dmi_text* out) {
    dmi_text_put(out, "v %s %s %s\n", dmi_digits_of_float(p[0]).text, dmi_digits_of_float(p[1]).text,
                 dmi_digits_of_float(p[2]).text);
}

void dmi_rig_print_obj(const dmi_rig_mesh* mesh, dmi_text* out) {
    dmi_text_put(out, "# metres, Z up\no %s\n", mesh->name);
    for (uint32_t i = 0; i < mesh->point_count; i++) put_point(mesh->points[i], out);
    for (uint32_t f = 0; f < mesh->face_count; f++)
        dmi_text_put(out, "f %u %u %u\n", mesh->faces[f][0] + 1, mesh->faces[f][1] + 1, mesh->faces[f][2] + 1);
    uint32_t face;
    float point[3];
    if (!find_fourth_point(mesh, &face, point)) return;
    put_point(point, out);
    dmi_text_put(out, "f %u %u %u\n", mesh->faces[face][1] + 1, mesh->faces[face][0] + 1, mesh->point_count + 1);
}
