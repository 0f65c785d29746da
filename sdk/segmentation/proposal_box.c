/* Fits the box by principal component analysis; measures mirror symmetry on a grid of occupied cells. */
#include "segmentation/proposal_box.h"

#include "math/elementary.h"
#include "math/linear3.h"

#define CELLS 8             /* cells along each side of the box; by hand */
#define MIN_VARIANCE 1e-10f /* object sizes squared: avoids a division by zero */

dmi_proposal_box dmi_proposal_box_fit(const float (*points)[3], uint32_t count) {
    dmi_proposal_box box = {
        .low = {INFINITY, INFINITY, INFINITY}, .high = {-INFINITY, -INFINITY, -INFINITY}, .samples = count};
    double variances[3];
    dmi_principal3(points, count, box.centre, variances, box.axes);
    box.radius = sqrtf(dmi_fmaxf((float)(variances[0] + variances[1] + variances[2]), MIN_VARIANCE));
    for (uint32_t s = 0; s < count; s++) {
        float offset[3];
        dmi_sub3(points[s], box.centre, offset);
        for (int k = 0; k < 3; k++) {
            const float x = dmi_dot3(offset, box.axes[k]);
            box.low[k] = dmi_fminf(box.low[k], x);
            box.high[k] = dmi_fmaxf(box.high[k], x);
        }
    }
    return box;
}

bool dmi_proposal_box_contains(const dmi_proposal_box* box, const float point[3], float margin) {
    float offset[3];
    dmi_sub3(point, box->centre, offset);
    for (int k = 0; k < 3; k++) {
        const float x = dmi_dot3(offset, box->axes[k]);
        if (x < box->low[k] - margin || x > box->high[k] + margin) return false;
    }
    return true;
}

static void mark_cells(const dmi_proposal_box* box, const float (*points)[3], uint8_t full[CELLS][CELLS][CELLS]) {
    for (uint32_t s = 0; s < box->samples; s++) {
        float offset[3];
        int cell[3];
        dmi_sub3(points[s], box->centre, offset);
        for (int k = 0; k < 3; k++) {
            const float side = dmi_fmaxf(box->high[k] - box->low[k], DMI_MIN_BOX_SIDE);
            const float x = (dmi_dot3(offset, box->axes[k]) - box->low[k]) / side;
            cell[k] = (int)dmi_fminf(dmi_fmaxf(x * CELLS, 0), CELLS - 1);
        }
        full[cell[0]][cell[1]][cell[2]] = 1;
    }
}

void dmi_proposal_box_symmetry(const dmi_proposal_box* box, const float (*points)[3], float out[3]) {
    uint8_t full[CELLS][CELLS][CELLS] = {0};
    int count = 0, mirrored[3] = {0, 0, 0};
    mark_cells(box, points, full);
    for (int i = 0; i < CELLS * CELLS * CELLS; i++) {
        const int x = i / (CELLS * CELLS), y = i / CELLS % CELLS, z = i % CELLS;
        if (!full[x][y][z]) continue;
        count++;
        mirrored[0] += full[CELLS - 1 - x][y][z];
        mirrored[1] += full[x][CELLS - 1 - y][z];
        mirrored[2] += full[x][y][CELLS - 1 - z];
    }
    for (int k = 0; k < 3; k++) out[k] = count > 0 ? (float)mirrored[k] / (float)count : 0;
}
