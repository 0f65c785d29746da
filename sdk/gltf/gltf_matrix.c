/* Affine matrices in doubles, because files place things far away, and scale them by much. */
#include "gltf/gltf_matrix.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

enum { COLUMN = DMI_GLTF_COLUMN, ORIGIN = DMI_GLTF_ORIGIN };

/* Length of a column, its share across the columns before it, below which the columns span no space. By hand. */
#define SMALLEST_COLUMN 1e-6

void dmi_gltf_multiply(const double a[16], const double b[16], double out[16]) {
    for (int column = 0; column < 4; column++) {
        for (int row = 0; row < 4; row++) {
            double sum = 0;
            for (int k = 0; k < 4; k++) sum += a[4 * k + row] * b[4 * column + k];
            out[4 * column + row] = sum;
        }
    }
}

void dmi_gltf_compose(const double translation[3], const double rotation[4], const double scale[3], double out[16]) {
    const double x = rotation[0], y = rotation[1], z = rotation[2], w = rotation[3];
    const double r[9] = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z),     2 * (x * z - w * y),
                         2 * (x * y - w * z),     1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
                         2 * (x * z + w * y),     2 * (y * z - w * x),     1 - 2 * (x * x + y * y)};
    for (int column = 0; column < 3; column++) {
        for (int row = 0; row < 3; row++) out[COLUMN * column + row] = r[3 * column + row] * scale[column];
        out[COLUMN * column + 3] = 0;
        out[ORIGIN + column] = translation[column];
    }
    out[15] = 1;
}

double dmi_gltf_determinant(const double m[16]) {
    return m[0] * (m[5] * m[10] - m[9] * m[6]) - m[4] * (m[1] * m[10] - m[9] * m[2]) +
           m[8] * (m[1] * m[6] - m[5] * m[2]);
}

bool dmi_gltf_invert(const double m[16], double out[16]) {
    const double d = dmi_gltf_determinant(m);
    if (!(fabs(d) > DBL_MIN) || !isfinite(d)) return false;
    for (int column = 0; column < 3; column++) {
        for (int row = 0; row < 3; row++) {
            const int a = (row + 1) % 3, b = (row + 2) % 3, c = (column + 1) % 3, e = (column + 2) % 3;
            out[COLUMN * column + row] =
                (m[COLUMN * a + c] * m[COLUMN * b + e] - m[COLUMN * a + e] * m[COLUMN * b + c]) / d;
        }
        out[COLUMN * column + 3] = 0;
    }
    for (int row = 0; row < 3; row++)
        out[ORIGIN + row] =
            -(out[row] * m[ORIGIN] + out[COLUMN + row] * m[ORIGIN + 1] + out[2 * COLUMN + row] * m[ORIGIN + 2]);
    out[15] = 1;
    return true;
}

void dmi_gltf_turn(const double m[16], const double v[3], double out[3]) {
    for (int row = 0; row < 3; row++) out[row] = m[row] * v[0] + m[COLUMN + row] * v[1] + m[2 * COLUMN + row] * v[2];
}

double dmi_gltf_length(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

double dmi_gltf_straighten(double m[16]) {
    double error = 0;
    for (int column = 0; column < 3; column++) {
        double* v = m + (size_t)COLUMN * (size_t)column;
        error = fmax(error, fabs(dmi_gltf_length(v) - 1));
        for (int other = 0; other < column; other++) {
            const double* u = m + (size_t)COLUMN * (size_t)other;
            const double dot = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
            error = fmax(error, fabs(dot));
            for (int k = 0; k < 3; k++) v[k] -= dot * u[k];
        }
        const double length = dmi_gltf_length(v);
        if (!(length > SMALLEST_COLUMN)) return 1;
        for (int k = 0; k < 3; k++) v[k] /= length;
    }
    return dmi_gltf_determinant(m) > 0 ? error : 1;
}

void dmi_gltf_normalize(double q[4]) {
    const double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (int k = 0; k < 4; k++) q[k] = length > 0 ? q[k] / length : (k == 3 ? 1.0 : 0.0);
}

void dmi_gltf_to_quaternion(const double m[16], double q[4]) {
    const double trace[4] = {m[0] - m[5] - m[10], m[5] - m[0] - m[10], m[10] - m[0] - m[5], m[0] + m[5] + m[10]};
    int best = 3;
    for (int i = 0; i < 3; i++)
        if (trace[i] > trace[best]) best = i;
    const double four[4][4] = {{1 + trace[0], m[1] + m[4], m[8] + m[2], m[6] - m[9]},
                               {m[1] + m[4], 1 + trace[1], m[6] + m[9], m[8] - m[2]},
                               {m[8] + m[2], m[6] + m[9], 1 + trace[2], m[1] - m[4]},
                               {m[6] - m[9], m[8] - m[2], m[1] - m[4], 1 + trace[3]}};
    for (int k = 0; k < 4; k++) q[k] = four[best][k];
    dmi_gltf_normalize(q);
}
