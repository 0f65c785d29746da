/* Places parts in the world. */
#include "pick/placed.h"

#include <math.h>
#include <string.h>

/* ---- matrices ---- */

void dmi_pose_matrix_f64(const dm_pose* pose, double out[DMI_MATRIX]) {
    double x = (double)pose->real[0], y = (double)pose->real[1], z = (double)pose->real[2], w = (double)pose->real[3];
    double a = (double)pose->dual[0], b = (double)pose->dual[1], c = (double)pose->dual[2], d = (double)pose->dual[3];
    const double columns[DMI_MATRIX] = {
        1 - 2 * (y * y + z * z),
        2 * (x * y + w * z),
        2 * (x * z - w * y),
        2 * (x * y - w * z),
        1 - 2 * (x * x + z * z),
        2 * (y * z + w * x),
        2 * (x * z + w * y),
        2 * (y * z - w * x),
        1 - 2 * (x * x + y * y),
        2 * (w * a - d * x + y * c - z * b),
        2 * (w * b - d * y + z * a - x * c),
        2 * (w * c - d * z + x * b - y * a),
    };
    memcpy(out, columns, sizeof columns);
}

static void apply(const double m[DMI_MATRIX], const double p[4], double out[4]) {
    for (int i = 0; i < 4; i++) out[i] = m[i] * p[0] + m[3 + i] * p[1] + m[6 + i] * p[2] + m[9 + i];
}

/* Applies the matrix without its translation. */
static void apply_linear(const double m[DMI_MATRIX], const double direction[4], double out[4]) {
    for (int i = 0; i < 4; i++) out[i] = m[i] * direction[0] + m[3 + i] * direction[1] + m[6 + i] * direction[2];
}

static void multiply(const double a[DMI_MATRIX], const double b[DMI_MATRIX], double out[DMI_MATRIX]) {
    double column[4];
    for (int i = 0; i < 3; i++) {
        apply_linear(a, b + 3 * (size_t)i, column);
        memcpy(out + 3 * (size_t)i, column, 3 * sizeof *column);
    }
    apply(a, b + 9, column);
    memcpy(out + 9, column, sizeof column);
}

/* Inverts a turn, mirrored or not, times `scale`. */
static void invert(const double m[DMI_MATRIX], double inverse_scale, double out[DMI_MATRIX]) {
    const double squared = inverse_scale * inverse_scale;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) out[3 * i + k] = m[3 * k + i] * squared;
    for (int k = 0; k < 4; k++) out[9 + k] = 0;
    double shift[4];
    apply_linear(out, m + 9, shift);
    for (int k = 0; k < 3; k++) out[9 + k] = -shift[k];
}

static double determinant(const double m[DMI_MATRIX]) {
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[3] * (m[1] * m[8] - m[2] * m[7]) + m[6] * (m[1] * m[5] - m[2] * m[4]);
}

/* ---- places ---- */

/* nextafterf is a call that looks at everything; f is finite here. */
static float next_up(float f) {
    int32_t bits;
    memcpy(&bits, &f, sizeof bits);
    if (f == 0) return 0x1p-149f;
    bits += f > 0 ? 1 : -1;
    memcpy(&f, &bits, sizeof bits);
    return f;
}

static float round_up(double x) {
    const float f = (float)x;
    return (double)f < x ? next_up(f) : f;
}

static float round_down(double x) {
    return -round_up(-x);
}

/* Box of the moved box of a part. */
static void measure_box(const dmi_placed_part* part, dmi_box* out) {
    const dmi_bvh_part* shape = part->shape;
    double centre[4], half[3], middle[4] = {0};
    for (int k = 0; k < 3; k++) {
        middle[k] = 0.5 * ((double)shape->low[k] + (double)shape->high[k]);
        half[k] = 0.5 * ((double)shape->high[k] - (double)shape->low[k]);
    }
    const double* m = part->to_world;
    apply(m, middle, centre);
    *out = (dmi_box){{0}, {0}};
    for (int k = 0; k < 3; k++) {
        const double reach = fabs(m[k]) * half[0] + fabs(m[3 + k]) * half[1] + fabs(m[6 + k]) * half[2];
        out->low[k] = round_down(centre[k] - reach);
        out->high[k] = round_up(centre[k] + reach);
    }
}

/* Whether a part stands at rest, where most parts of a level stand. */
static bool is_at_rest(const dm_pose* pose) {
    static const dm_pose rest = {{0, 0, 0, 1}, {0, 0, 0, 0}};
    return memcmp(pose, &rest, sizeof rest) == 0;
}

/* Sets what moves with a part from the matrix to_object. */
static void place_part(dmi_placed_part* part, const double placement[DMI_MATRIX], dmi_top_item* item) {
    multiply(placement, part->to_object, part->to_world);
    const double* m = part->to_world;
    item->scale = sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    part->winding = determinant(m) < 0 ? -1 : 1;
    invert(m, 1 / item->scale, item->from_world);
}

static void copy_place(const dmi_placed_part* from, dmi_placed_part* part) {
    part->winding = from->winding;
    memcpy(part->to_world, from->to_world, sizeof part->to_world);
    memcpy(part->to_object, from->to_object, sizeof part->to_object);
}

void dmi_placed_part_update(dmi_placed_part* part, dmi_top_tree* tree, const double placement[DMI_MATRIX],
                            const double from_inner[DMI_MATRIX], const dmi_placed_part** at_rest) {
    const bool rests = is_at_rest(&part->pose);
    dmi_top_item* item = dmi_top_tree_item(tree, part->leaf);
    if (rests && *at_rest != NULL) {
        copy_place(*at_rest, part);
        *item = *dmi_top_tree_item(tree, (*at_rest)->leaf);
    } else {
        double pose[DMI_MATRIX];
        dmi_pose_matrix_f64(&part->pose, pose);
        multiply(pose, from_inner, part->to_object);
        place_part(part, placement, item);
    }
    if (rests) *at_rest = part;
    item->shape = part->shape;
    item->part = part;
    part->moved = false;
    measure_box(part, &tree->leaves[part->leaf].box);
}
