/* Rays through pixels of perspective and orthographic cameras, in the host's axes. */
#include "pick/pick.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "math/elementary.h"
#include "math/linear3.h"

#define MIN_SINE 1e-4 /* least sine of the angle between forward and up; by hand */

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static bool load(dm_vec3 v, double out[3]) {
    memcpy(out, dmi_xyz_f64(v).v, 3 * sizeof *out);
    return isfinite(out[0]) && isfinite(out[1]) && isfinite(out[2]);
}

/* Scales to unit length; false for a vector without length. */
static bool normalize(double v[3]) {
    double length = sqrt(dot(v, v));
    if (!(length > 0)) return false;
    for (int i = 0; i < 3; i++) v[i] /= length;
    return true;
}

typedef struct basis {
    double right[3], up[3], forward[3];
} basis;

/* Right is forward x up in a right-handed frame, up x forward in a left-handed one; the cross product is that of the
 * coordinates in both. */
static bool make_basis(const dm_camera* camera, double handedness, basis* out) {
    double *r = out->right, *u = out->up, *f = out->forward;
    if (!load(camera->forward, f) || !load(camera->up, u) || !normalize(f) || !normalize(u)) return false;
    double along = dot(f, u);
    for (int i = 0; i < 3; i++) u[i] -= along * f[i];
    if (!(dot(u, u) > MIN_SINE * MIN_SINE)) return false;
    normalize(u);
    for (int i = 0; i < 3; i++) {
        r[i] = handedness * (f[(i + 1) % 3] * u[(i + 2) % 3] - f[(i + 2) % 3] * u[(i + 1) % 3]);
    }
    return true;
}

/* Returns half the height of the picture: at distance 1, or of the orthographic box; 0 for an invalid camera. */
static double half_height(const dm_camera* camera) {
    double fov = (double)camera->fov_y, height = (double)camera->ortho_height;
    if (fov > 0 && fov < DMI_PI) return dmi_tan(0.5 * fov);
    return fov == 0 && height > 0 && isfinite(height) ? 0.5 * height : 0;
}

bool dmi_camera_ray(const dm_camera* camera, float handedness, float x, float y, dm_ray* out_ray) {
    double width = (double)camera->viewport_width, height = (double)camera->viewport_height, half = half_height(camera),
           eye[3];
    basis b;
    if (!(width > 0 && height > 0 && half > 0) || !isfinite(width) || !isfinite(height)) return false;
    if (!isfinite(x) || !isfinite(y) || !load(camera->eye, eye) || !make_basis(camera, (double)handedness, &b))
        return false;
    /* Pixels are square: both offsets in units of half the picture's height. */
    double across = (2 * (double)x - width) / height * half, upward = (height - 2 * (double)y) / height * half;
    double offset[3], direction[3];
    for (int i = 0; i < 3; i++) offset[i] = across * b.right[i] + upward * b.up[i];
    bool perspective = camera->fov_y > 0;
    for (int i = 0; i < 3; i++) direction[i] = b.forward[i] + (perspective ? offset[i] : 0);
    for (int i = 0; i < 3; i++) eye[i] += perspective ? 0 : offset[i];
    normalize(direction);
    *out_ray = (dm_ray){{(float)eye[0], (float)eye[1], (float)eye[2]},
                        {(float)direction[0], (float)direction[1], (float)direction[2]}};
    return true;
}
