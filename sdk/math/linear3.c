/* Symmetric eigenproblems by Jacobi rotations, principal directions, perpendicular frames. */
#include "math/linear3.h"

#define MAX_SWEEPS 32          /* sweeps of Jacobi rotations; convergence takes under ten */
#define JACOBI_TOLERANCE 1e-15 /* ratio of the off-diagonal sum to the trace: rounding of doubles */

void dmi_perpendicular3(const float axis[3], float out_u[3], float out_w[3]) {
    int least = 0;
    for (int i = 1; i < 3; i++)
        if (fabsf(axis[i]) < fabsf(axis[least])) least = i;
    float unit[3] = {0, 0, 0};
    unit[least] = 1;
    dmi_cross3(axis, unit, out_u);
    dmi_normalize3(out_u);
    dmi_cross3(axis, out_u, out_w);
}

/* Applies one Jacobi rotation that zeroes m[p][q]; v collects the rotations as columns. */
static void rotate(double m[3][3], double v[3][3], int p, int q) {
    if (m[p][q] == 0) return;
    double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
    double t = (theta >= 0 ? 1 : -1) / (fabs(theta) + sqrt(theta * theta + 1));
    double c = 1 / sqrt(t * t + 1), s = t * c;
    for (int k = 0; k < 3; k++) {
        double a = m[k][p], b = m[k][q];
        m[k][p] = c * a - s * b, m[k][q] = s * a + c * b;
    }
    for (int k = 0; k < 3; k++) {
        double a = m[p][k], b = m[q][k];
        m[p][k] = c * a - s * b, m[q][k] = s * a + c * b;
        a = v[k][p], b = v[k][q];
        v[k][p] = c * a - s * b, v[k][q] = s * a + c * b;
    }
}

void dmi_eigen3(const double matrix[3][3], double out_values[3], float out_vectors[3][3]) {
    double m[3][3], v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    memcpy(m, matrix, sizeof m);
    const double scale = fabs(m[0][0]) + fabs(m[1][1]) + fabs(m[2][2]);
    for (int sweep = 0; sweep < MAX_SWEEPS; sweep++) {
        if (fabs(m[0][1]) + fabs(m[0][2]) + fabs(m[1][2]) <= JACOBI_TOLERANCE * scale) break;
        rotate(m, v, 0, 1);
        rotate(m, v, 0, 2);
        rotate(m, v, 1, 2);
    }
    int order[3] = {0, 1, 2};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2 - i; j++)
            if (m[order[j]][order[j]] < m[order[j + 1]][order[j + 1]]) {
                int swap = order[j];
                order[j] = order[j + 1], order[j + 1] = swap;
            }
    for (int i = 0; i < 3; i++) {
        out_values[i] = m[order[i]][order[i]];
        for (int k = 0; k < 3; k++) out_vectors[i][k] = (float)v[k][order[i]];
    }
}

void dmi_principal3(const float (*points)[3], uint32_t count, float out_mean[3], double out_variances[3],
                    float out_directions[3][3]) {
    double mean[3] = {0, 0, 0}, m[3][3] = {{0}};
    double share = count > 0 ? 1.0 / count : 0;
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) mean[k] += points[i][k] * share;
    for (uint32_t i = 0; i < count; i++) {
        double d[3] = {points[i][0] - mean[0], points[i][1] - mean[1], points[i][2] - mean[2]};
        for (int r = 0; r < 3; r++)
            for (int c = 0; c <= r; c++) m[r][c] += d[r] * d[c] * share;
    }
    m[0][1] = m[1][0], m[0][2] = m[2][0], m[1][2] = m[2][1];
    for (int k = 0; k < 3; k++) out_mean[k] = (float)mean[k];
    dmi_eigen3((const double(*)[3])m, out_variances, out_directions);
}
