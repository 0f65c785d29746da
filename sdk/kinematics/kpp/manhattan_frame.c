/* Three perpendicular directions fitted to normals: assign every normal to the nearest direction, turn the directions
 * to the assigned normals' means, again. */
#include "kinematics/kpp/manhattan_frame.h"

#include "math/linear3.h"

#define ROUNDS 12
#define NEAR_COSINE 0.8f /* farther normals belong to no direction */
#define ALONG_COSINE 0.99f
#define SETTLED 0.9999999f
#define HOLD 1e-3 /* of the old directions, where a family has no normals */

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

/* The direction nearest to a normal as a line, and their signed cosine. */
static int nearest_direction(const float axes[3][3], const float normal[3], float* out_cosine) {
    int best = 0;
    *out_cosine = 0;
    for (int k = 0; k < 3; k++) {
        const float cosine = dmi_dot3(axes[k], normal);
        if (fabsf(cosine) > fabsf(*out_cosine)) *out_cosine = cosine, best = k;
    }
    return best;
}

/* Rows: the means of the families, weighed by the square root of their size, so that a thin panel's edges count too. */
static void family_means(const dmi_normals* normals, const float axes[3][3], double out[3][3]) {
    uint32_t members[3] = {0, 0, 0};
    memset(out, 0, 9 * sizeof(double));
    for (uint32_t i = 0; i < count_of(normals); i++) {
        const float* n = normal_at(normals, i);
        float cosine;
        const int k = nearest_direction(axes, n, &cosine);
        if (fabsf(cosine) < NEAR_COSINE) continue;
        members[k]++;
        for (int c = 0; c < 3; c++) out[k][c] += cosine > 0 ? n[c] : -n[c];
    }
    for (int k = 0; k < 3; k++) {
        const double share = members[k] > 0 ? 1 / sqrt((double)members[k]) : 0;
        for (int c = 0; c < 3; c++) out[k][c] = out[k][c] * share + HOLD * axes[k][c];
    }
}

/* The rotation nearest to m: m (m^T m)^(-1/2). */
static void nearest_rotation(const double m[3][3], float out[3][3]) {
    double square[3][3], values[3], root[3][3] = {{0}};
    float vectors[3][3];
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++) square[r][c] = m[0][r] * m[0][c] + m[1][r] * m[1][c] + m[2][r] * m[2][c];
    dmi_eigen3((const double(*)[3])square, values, vectors);
    for (int i = 0; i < 3; i++)
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                root[r][c] += (double)vectors[i][r] * vectors[i][c] / sqrt(fmax(values[i], 1e-12));
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            out[r][c] = (float)(m[r][0] * root[0][c] + m[r][1] * root[1][c] + m[r][2] * root[2][c]);
}

/* Float rounding and nearly singular families leave rows that are not quite perpendicular. */
static void straighten(float axes[3][3], const float before[3][3]) {
    dmi_reject3(axes[1], axes[0]);
    const int sound = fabsf(dmi_length3(axes[0]) - 1) < 0.1f && dmi_length3(axes[1]) > 0.1f;
    if (!sound) memcpy(axes, before, 9 * sizeof(float));
    dmi_normalize3(axes[0]);
    dmi_reject3(axes[1], axes[0]);
    dmi_normalize3(axes[1]);
    float third[3];
    dmi_cross3(axes[0], axes[1], third);
    const float sign = dmi_dot3(third, axes[2]) < 0 ? -1.0f : 1.0f;
    for (int c = 0; c < 3; c++) axes[2][c] = sign * third[c];
}

float dmi_manhattan_frame_fit(const dmi_normals* normals, float axes[3][3]) {
    for (int round = 0; round < ROUNDS; round++) {
        double means[3][3];
        float before[3][3];
        memcpy(before, axes, sizeof before);
        family_means(normals, (const float(*)[3])axes, means);
        nearest_rotation((const double(*)[3])means, axes);
        straighten(axes, (const float(*)[3])before);
        float least = 1; /* cosine between old and new */
        for (int k = 0; k < 3; k++) least = dmi_min(least, dmi_dot3(axes[k], before[k]));
        if (least > SETTLED) break;
    }
    uint32_t along = 0;
    for (uint32_t i = 0; i < count_of(normals); i++) {
        float cosine;
        nearest_direction((const float(*)[3])axes, normal_at(normals, i), &cosine);
        along += fabsf(cosine) > ALONG_COSINE;
    }
    return (float)along / (float)(count_of(normals) > 0 ? count_of(normals) : 1);
}
