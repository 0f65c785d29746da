/* Alternates between assigning normals to the nearest axis and rotating the axes to the means of the assigned normals,
 * as k-means does. */
#include "kinematics/kpp/kpp_frame.h"

#include <stdbool.h>

#include "math/elementary.h"
#include "math/linear3.h"

#define MAX_ITERATIONS 12           /* docs/networks.md; by hand */
#define ASSIGNED_COSINE 0.8f        /* |cosine| below which a normal is not assigned (37 degrees); by hand */
#define PARALLEL_COSINE 0.99f       /* |cosine| of normals that count as along an axis (8 degrees); by hand */
#define CONVERGED_COSINE 0.9999999f /* cosine between axes before and after an iteration that ends the fit; by hand */
#define OLD_WEIGHT 1e-3             /* weight of the old axis in the mean, for axes without normals; by hand */
#define MIN_EIGENVALUE 1e-12        /* keeps the inverse square root finite */
/* Error of an axis' length after an iteration, beyond which the axis is discarded; by hand. */
#define MAX_LENGTH_ERROR 0.1f
/* Length of the second axis perpendicular to the first, below which it is discarded; by hand. */
#define MIN_SECOND_LENGTH 0.1f

static uint32_t count_of(const dmi_normals* normals) {
    return normals->first_count + normals->second_count;
}

static const float* normal_at(const dmi_normals* normals, uint32_t i) {
    return i < normals->first_count ? normals->first[i] : normals->second[i - normals->first_count];
}

void dmi_manhattan_frame_guess(const dmi_normals* normals, float out_axes[3][3]) {
    double m[3][3] = {{0}}, values[3];
    for (uint32_t i = 0; i < count_of(normals); i++) {
        const float* n = normal_at(normals, i);
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++) m[r][c] += (double)n[r] * n[c];
    }
    dmi_eigen3((const double(*)[3])m, values, out_axes);
}

/* Returns the axis with the greatest |cosine| to the normal, and the signed cosine. */
static int nearest_axis(const float axes[3][3], const float normal[3], float* out_cosine) {
    int best = 0;
    *out_cosine = 0;
    for (int k = 0; k < 3; k++) {
        const float cosine = dmi_dot3(axes[k], normal);
        if (fabsf(cosine) > fabsf(*out_cosine)) *out_cosine = cosine, best = k;
    }
    return best;
}

/* Computes for each axis (row) the mean of its normals times the square root of their number, which gives few normals,
 * such as those of a thin panel's edges, more weight than a sum does. */
static void assigned_means(const dmi_normals* normals, const float axes[3][3], double out[3][3]) {
    uint32_t members[3] = {0, 0, 0};
    memset(out, 0, 3 * sizeof *out);
    for (uint32_t i = 0; i < count_of(normals); i++) {
        const float* n = normal_at(normals, i);
        float cosine;
        const int k = nearest_axis(axes, n, &cosine);
        if (fabsf(cosine) < ASSIGNED_COSINE) continue;
        members[k]++;
        for (int c = 0; c < 3; c++) out[k][c] += cosine > 0 ? n[c] : -n[c];
    }
    for (int k = 0; k < 3; k++) {
        const double share = members[k] > 0 ? 1 / sqrt((double)members[k]) : 0;
        for (int c = 0; c < 3; c++) out[k][c] = out[k][c] * share + OLD_WEIGHT * axes[k][c];
    }
}

/* Computes the orthogonal matrix closest to m, its polar factor m (m^T m)^(-1/2). */
static void nearest_rotation(const double m[3][3], float out[3][3]) {
    double square[3][3], values[3], root[3][3] = {{0}};
    float vectors[3][3];
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++) square[r][c] = m[0][r] * m[0][c] + m[1][r] * m[1][c] + m[2][r] * m[2][c];
    dmi_eigen3((const double(*)[3])square, values, vectors);
    for (int i = 0; i < 3; i++)
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                root[r][c] += (double)vectors[i][r] * vectors[i][c] / sqrt(dmi_fmax(values[i], MIN_EIGENVALUE));
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            out[r][c] = (float)(m[r][0] * root[0][c] + m[r][1] * root[1][c] + m[r][2] * root[2][c]);
}

/* Makes the rows perpendicular unit vectors again after rounding errors; restores `before` where the matrix was nearly
 * singular. */
static void orthonormalize(float axes[3][3], const float before[3][3]) {
    dmi_reject3(axes[1], axes[0]);
    const bool is_regular =
        fabsf(dmi_length3(axes[0]) - 1) < MAX_LENGTH_ERROR && dmi_length3(axes[1]) > MIN_SECOND_LENGTH;
    if (!is_regular) memcpy(axes, before, 3 * sizeof *axes);
    dmi_normalize3(axes[0]);
    dmi_reject3(axes[1], axes[0]);
    dmi_normalize3(axes[1]);
    float third[3];
    dmi_cross3(axes[0], axes[1], third);
    const float sign = dmi_dot3(third, axes[2]) < 0 ? -1.0f : 1.0f;
    for (int c = 0; c < 3; c++) axes[2][c] = sign * third[c];
}

float dmi_manhattan_frame_fit(const dmi_normals* normals, float axes[3][3]) {
    for (int i = 0; i < MAX_ITERATIONS; i++) {
        double means[3][3];
        float before[3][3];
        memcpy(before, axes, sizeof before);
        assigned_means(normals, (const float(*)[3])axes, means);
        nearest_rotation((const double(*)[3])means, axes);
        orthonormalize(axes, (const float(*)[3])before);
        float least = 1; /* cosine between an axis before and after */
        for (int k = 0; k < 3; k++) least = dmi_min(least, dmi_dot3(axes[k], before[k]));
        if (least > CONVERGED_COSINE) break;
    }
    uint32_t along = 0;
    for (uint32_t i = 0; i < count_of(normals); i++) {
        float cosine;
        nearest_axis((const float(*)[3])axes, normal_at(normals, i), &cosine);
        along += fabsf(cosine) > PARALLEL_COSINE;
    }
    return (float)along / (float)(count_of(normals) > 0 ? count_of(normals) : 1);
}
