/* Minimises the mean square normal speed over angular and linear velocity with eigenvectors of 3 x 3 matrices. */
#include "kinematics/analysis/analysis_steps.h"

#include "math/elementary.h"
#include "math/linear3.h"

#define DAMPING 1e-4    /* added to the diagonal of B, whose trace is 1: keeps it invertible; by hand */
#define MIN_RADIUS 1e-9 /* object sizes: avoids a division by zero */

/* Second moments of (arm x normal, normal) over the surface: [A C'; C B]. Arms are from the centre, in radii. */
typedef struct slip_moments {
    double turn[3][3], slide[3][3], cross[3][3]; /* A, B, C */
    double centre[3], radius;                    /* weighted mean and root mean square distance */
} slip_moments;

/* Inverts a symmetric positive definite matrix by its adjugate. */
static void invert3(const double m[3][3], double out[3][3]) {
    double c00 = m[1][1] * m[2][2] - m[1][2] * m[2][1], c01 = m[1][2] * m[2][0] - m[1][0] * m[2][2];
    double c02 = m[1][0] * m[2][1] - m[1][1] * m[2][0];
    double scale = 1 / (m[0][0] * c00 + m[0][1] * c01 + m[0][2] * c02);
    out[0][0] = c00 * scale, out[0][1] = out[1][0] = c01 * scale, out[0][2] = out[2][0] = c02 * scale;
    out[1][1] = (m[0][0] * m[2][2] - m[0][2] * m[2][0]) * scale;
    out[1][2] = out[2][1] = (m[0][2] * m[1][0] - m[0][0] * m[1][2]) * scale;
    out[2][2] = (m[0][0] * m[1][1] - m[0][1] * m[1][0]) * scale;
}

static void find_centre(const float (*points)[3], const float* weights, uint32_t count, slip_moments* m) {
    double total = 0, spread = 0;
    for (uint32_t i = 0; i < count; i++) {
        double w = weights != NULL ? weights[i] : 1;
        total += w;
        for (int k = 0; k < 3; k++) m->centre[k] += w * points[i][k];
    }
    for (int k = 0; k < 3; k++) m->centre[k] /= total;
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            double d = points[i][k] - m->centre[k];
            spread += (weights != NULL ? weights[i] : 1) * d * d;
        }
    m->radius = sqrt(spread / total) + MIN_RADIUS;
}

static void add_moments(const float (*points)[3], const float (*normals)[3], const float* weights, uint32_t count,
                        slip_moments* m) {
    double total = 0;
    for (uint32_t i = 0; i < count; i++) total += weights != NULL ? weights[i] : 1;
    for (uint32_t i = 0; i < count; i++) {
        double w = (weights != NULL ? weights[i] : 1) / total, y[3];
        const float* n = normals[i];
        for (int k = 0; k < 3; k++) y[k] = (points[i][k] - m->centre[k]) / m->radius;
        double a[3] = {y[1] * n[2] - y[2] * n[1], y[2] * n[0] - y[0] * n[2], y[0] * n[1] - y[1] * n[0]};
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++) {
                m->turn[r][c] += w * a[r] * a[c];
                m->slide[r][c] += w * n[r] * n[c];
                m->cross[r][c] += w * n[r] * a[c];
            }
    }
}

/* Eliminates the linear velocity t: for a given angular velocity w the best is t = -B^-1 C w, which leaves the
 * quadratic form w' (A - C' B^-1 C) w. */
static void eliminate_slide(const slip_moments* m, double best[3][3], double reduced[3][3]) {
    double damped[3][3], inverse[3][3];
    memcpy(damped, m->slide, sizeof damped);
    for (int k = 0; k < 3; k++) damped[k][k] += DAMPING;
    invert3((const double(*)[3])damped, inverse);
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++) {
            best[r][c] = 0;
            for (int k = 0; k < 3; k++) best[r][c] -= inverse[r][k] * m->cross[k][c];
        }
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++) {
            reduced[r][c] = m->turn[r][c];
            for (int k = 0; k < 3; k++) reduced[r][c] += m->cross[k][r] * best[k][c];
        }
}

void dmi_slippage_compute(const float (*points)[3], const float (*normals)[3], const float* weights, uint32_t count,
                          dmi_slippage* out) {
    slip_moments m = {0};
    double best[3][3], reduced[3][3], values[3];
    float vectors[3][3];
    find_centre(points, weights, count, &m);
    add_moments(points, normals, weights, count, &m);
    eliminate_slide(&m, best, reduced);
    dmi_eigen3((const double(*)[3])reduced, values, vectors);
    for (int i = 0; i < 2; i++) {
        float t[3] = {0, 0, 0}, arm[3];
        const float* w = vectors[2 - i];
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++) t[r] += (float)(best[r][c] * w[c]);
        dmi_cross3(w, t, arm);
        dmi_copy3(w, out->turn_axis[i]);
        for (int k = 0; k < 3; k++) out->turn_point[i][k] = (float)(m.centre[k] + m.radius * arm[k]);
        out->turn_residual[i] = (float)sqrt(dmi_fmax(values[2 - i], 0));
    }
    dmi_eigen3((const double(*)[3])m.slide, values, vectors);
    for (int i = 0; i < 2; i++) {
        dmi_copy3(vectors[2 - i], out->slide[i]);
        out->slide_residual[i] = (float)sqrt(dmi_fmax(values[2 - i], 0));
    }
}
