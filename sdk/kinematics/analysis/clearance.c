/* Measures how far the part may slide along each side of its box before the body stands in its way.
 *
 * Lines through the part's own thickness meet the body's faces exactly. They tell a leaf in one plane with its
 * neighbour, which it cannot slide past, from a leaf in a track of its own beside it, which a distance grid cannot: its
 * cells are as wide as the gap between two tracks. */
#include "kinematics/analysis/analysis_steps.h"

#define OVERLAP 0.05f  /* sides: the body may reach so far into the part's box and still stand before it; by hand */
#define MIN_SIDE 1e-5f /* object sizes: avoids a division by zero */

enum { LINES = 3 };

/* Places of the lines across the wider side of a cross-section, in sides from the part's mean; by hand. They lie where
 * neither the diagonal of a face nor a thing in the middle is met by all. */
static const float line_place[LINES] = {-0.31f, 0.07f, 0.29f};

typedef struct line_scan {
    float through[3][LINES][3]; /* a point of each line along each side, in coordinates along the box' axes */
    float gap[3][LINES][2];     /* distance from the box to the nearest face, against the side and along it */
    float low[3], high[3], side[3];
} line_scan;

static void begin_scan(const dmi_part_analysis* a, line_scan* scan) {
    float mean[3];
    for (int k = 0; k < 3; k++) {
        scan->low[k] = a->box.low[k], scan->high[k] = a->box.high[k];
        scan->side[k] = dmi_max(scan->high[k] - scan->low[k], MIN_SIDE);
        mean[k] = dmi_dot3(a->centre, a->box.axes[k]);
    }
    for (int k = 0; k < 3; k++) {
        const int b = (k + 1) % 3, c = (k + 2) % 3, wide = scan->side[b] > scan->side[c] ? b : c;
        for (int i = 0; i < LINES; i++) {
            dmi_copy3(mean, scan->through[k][i]);
            scan->through[k][i][wide] += line_place[i] * scan->side[wide];
            scan->gap[k][i][0] = scan->gap[k][i][1] = INFINITY;
        }
    }
}

/* Returns whether the line along side k through a point meets the triangle, and where along the side. */
static bool meet_triangle(const float corner[3][3], int k, const float through[3], float* out_at) {
    const int b = (k + 1) % 3, c = (k + 2) % 3;
    double weight[3], sum = 0;
    for (int i = 0; i < 3; i++) {
        const float *p = corner[(i + 1) % 3], *q = corner[(i + 2) % 3];
        weight[i] = ((double)p[b] - (double)through[b]) * ((double)q[c] - (double)through[c]) -
                    ((double)q[b] - (double)through[b]) * ((double)p[c] - (double)through[c]);
        sum += weight[i];
    }
    double at = 0;
    for (int i = 0; i < 3; i++) {
        if (sum == 0 || weight[i] / sum < 0) return false;
        at += weight[i] / sum * (double)corner[i][k];
    }
    *out_at = (float)at;
    return true;
}

static bool is_beside(const float corner[3][3], int axis, float at) {
    return (corner[0][axis] < at && corner[1][axis] < at && corner[2][axis] < at) ||
           (corner[0][axis] > at && corner[1][axis] > at && corner[2][axis] > at);
}

static void scan_triangle(line_scan* scan, const float corner[3][3]) {
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < LINES; i++) {
            const float* through = scan->through[k][i];
            const int b = (k + 1) % 3, c = (k + 2) % 3;
            float at;
            if (is_beside(corner, b, through[b]) || is_beside(corner, c, through[c]) ||
                !meet_triangle(corner, k, through, &at))
                continue;
            const float gap[2] = {scan->low[k] - at, at - scan->high[k]};
            for (int way = 0; way < 2; way++)
                if (gap[way] > -OVERLAP * scan->side[k]) scan->gap[k][i][way] = dmi_min(scan->gap[k][i][way], gap[way]);
        }
    }
}

static bool is_outside(const float* const corner[3], const float low[3], const float high[3]) {
    for (int k = 0; k < 3; k++)
        if (dmi_max(corner[0][k], dmi_max(corner[1][k], corner[2][k])) < low[k] ||
            dmi_min(corner[0][k], dmi_min(corner[1][k], corner[2][k])) > high[k])
            return true;
    return false;
}

static float middle_of(float a, float b, float c) {
    return dmi_max(dmi_min(a, b), dmi_min(dmi_max(a, b), c));
}

void dmi_analysis_find_clearance(const uint8_t* moving, const float low[3], const float high[3],
                                 dmi_part_analysis* analysis) {
    const dmi_mesh* mesh = analysis->mesh;
    line_scan scan;
    begin_scan(analysis, &scan);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (moving[f] || mesh->face_area[f] <= 0) continue;
        const float* at[3];
        for (uint32_t i = 0; i < 3; i++) at[i] = mesh->positions + 3 * (size_t)mesh->indices[3 * (size_t)f + i];
        if (is_outside(at, low, high)) continue;
        float corner[3][3];
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++) corner[i][k] = dmi_dot3(at[i], analysis->box.axes[k]);
        scan_triangle(&scan, (const float(*)[3])corner);
    }
    for (int k = 0; k < 3; k++)
        for (int way = 0; way < 2; way++) {
            const float gap = middle_of(scan.gap[k][0][way], scan.gap[k][1][way], scan.gap[k][2][way]);
            analysis->clearance[k][way] = dmi_clamp(gap / scan.side[k], 0, DMI_MOST_CLEARANCE);
        }
}
