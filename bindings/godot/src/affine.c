#include "affine.h"

affine affine_identity(void) {
    return (affine){{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}};
}

static void apply(const affine* a, const double v[3], const double origin[3], double out[3]) {
    for (int row = 0; row < 3; row++) {
        const double* m = a->m + 3 * (size_t)row;
        out[row] = m[0] * v[0] + m[1] * v[1] + m[2] * v[2] + origin[row];
    }
}

affine affine_after(const affine* a, const affine* b) {
    affine out;
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++) {
            double sum = 0;
            for (int k = 0; k < 3; k++) sum += a->m[3 * row + k] * b->m[3 * k + column];
            out.m[3 * row + column] = sum;
        }
    apply(a, b->m + 9, a->m + 9, out.m + 9);
    return out;
}

affine affine_inverse(const affine* a) {
    const double* m = a->m;
    affine out;
    /* The cofactors of two columns: cyclic indices spare the signs. */
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++) {
            const int r1 = (column + 1) % 3, r2 = (column + 2) % 3, c1 = (row + 1) % 3, c2 = (row + 2) % 3;
            out.m[3 * row + column] = m[3 * r1 + c1] * m[3 * r2 + c2] - m[3 * r1 + c2] * m[3 * r2 + c1];
        }
    const double determinant = m[0] * out.m[0] + m[1] * out.m[3] + m[2] * out.m[6];
    for (int i = 0; i < 9; i++) out.m[i] /= determinant;
    const double none[3] = {0}, back[3] = {-m[9], -m[10], -m[11]};
    apply(&out, back, none, out.m + 9);
    return out;
}

affine affine_of_pose(const dm_pose* pose) {
    float columns[16];
    affine out;
    dm_pose_to_matrix(pose, columns);
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++) out.m[3 * row + column] = columns[4 * column + row];
        out.m[9 + row] = columns[12 + row];
    }
    return out;
}

static dm_vec3 narrow(const double v[3]) {
    return (dm_vec3){(float)v[0], (float)v[1], (float)v[2]};
}

dm_vec3 affine_point(const affine* a, const double p[3]) {
    double out[3];
    apply(a, p, a->m + 9, out);
    return narrow(out);
}

dm_vec3 affine_vector(const affine* a, const double v[3]) {
    const double none[3] = {0};
    double out[3];
    apply(a, v, none, out);
    return narrow(out);
}
