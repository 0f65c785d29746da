/* Computes turns between a body's axes and those of its joint or of its inertia. */
#include <math.h>

#include "export/rig_formats.h"
#include "math/linear3.h"

/* Cosine plus one below which two directions are opposite, so that any way round will do; by hand: squared, a float's
 * rounding. */
static const double opposite = 1e-12;

void dmi_rig_turn_to_axis(const double axis[3], double out_turn[4]) {
    out_turn[0] = 0;
    out_turn[1] = -axis[2];
    out_turn[2] = axis[1];
    out_turn[3] = 1 + axis[0];
    if (out_turn[3] < opposite) out_turn[1] = 0, out_turn[2] = 1, out_turn[3] = 0;
    const double length = sqrt(out_turn[1] * out_turn[1] + out_turn[2] * out_turn[2] + out_turn[3] * out_turn[3]);
    for (int k = 1; k < 4; k++) out_turn[k] /= length; /* literal: a quaternion */
}

void dmi_rig_joint_frame(const double axis[3], int which, double out_frame[3][3]) {
    int least = 0;
    for (int k = 1; k < 3; k++)
        if (fabs(axis[k]) < fabs(axis[least])) least = k;
    double *a = out_frame[which], *u = out_frame[(which + 1) % 3], *w = out_frame[(which + 2) % 3];
    const int next = (least + 1) % 3, last = (least + 2) % 3;
    const double length = sqrt(axis[next] * axis[next] + axis[last] * axis[last]);
    for (int k = 0; k < 3; k++) a[k] = axis[k];
    u[least] = 0;
    u[next] = axis[last] / length;
    u[last] = -axis[next] / length;
    for (int k = 0; k < 3; k++) w[k] = a[(k + 1) % 3] * u[(k + 2) % 3] - a[(k + 2) % 3] * u[(k + 1) % 3];
}

/* Writes the quaternion of an orthonormal frame, whose axes are rows. */
static void turn_of(const double r[3][3], double out[4]) {
    const double trace = r[0][0] + r[1][1] + r[2][2];
    int big = 0;
    for (int i = 1; i < 3; i++)
        if (r[i][i] > r[big][big]) big = i;
    const int next = (big + 1) % 3, last = (big + 2) % 3;
    if (trace > r[big][big]) {
        for (int i = 0; i < 3; i++) out[i] = r[(i + 1) % 3][(i + 2) % 3] - r[(i + 2) % 3][(i + 1) % 3];
        out[3] = 1 + trace;
    } else {
        out[big] = 1 + 2 * r[big][big] - trace;
        out[next] = r[big][next] + r[next][big];
        out[last] = r[big][last] + r[last][big];
        out[3] = r[next][last] - r[last][next];
    }
    const double length = sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2] + out[3] * out[3]);
    for (int k = 0; k < 4; k++) out[k] /= length; /* literal: a quaternion */
}

void dmi_rig_principal(const dmi_rig_body* body, double out_moments[3], double out_turn[4]) {
    float rows[3][3];
    double frame[3][3];
    dmi_eigen3(body->inertia, out_moments, rows);
    dmi_cross3(rows[0], rows[1], rows[2]); /* right-handed */
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) frame[i][k] = (double)rows[i][k];
    turn_of((const double(*)[3])frame, out_turn);
}
