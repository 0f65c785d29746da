/* Moves sets of nodes along and about the axes of the grid. */
#include "assets/set_motions.h"

#include <math.h>

#include "math/elementary.h"

/* All set by hand. */
static const float WAY_CELLS[3] = {2, 8, 24}; /* cells that a set is shifted by */
#define LITTLE 0.25f                          /* rad */
#define MUCH 0.9f                             /* rad */
#define SPIN_STEP 0.6f                        /* rad, of turns into itself */
#define EXPOSED_BONUS 0.05f                   /* share of collisions that being seen is worth */
#define APART_COST 0.3f                       /* share of collisions that a diagonal from the contacts is worth */
#define TINY 1e-6f                            /* object sizes; no length is divided by less */
#define CORNERS 4                             /* edges of a box along one axis */

/* ---- ways ---- */

static float slide(const dmi_node_set* set, uint32_t against, int side, float cells) {
    dmi_set_motion m = {.axis = 0};
    m.shift[side / 2] = (side % 2 ? 1.0f : -1.0f) * cells * set->grid->cell;
    return dmi_node_set_collide(set, against, &m);
}

static float way_cost(const dmi_set_way* w) {
    return w->near + w->middle + w->far - EXPOSED_BONUS * w->exposed;
}

void dmi_measure_ways(const dmi_node_set* set, uint32_t against, const float exposed[DMI_GRID_SIDES],
                      dmi_set_way out[DMI_GRID_SIDES]) {
    for (int side = 0; side < DMI_GRID_SIDES; side++)
        out[side] = (dmi_set_way){slide(set, against, side, WAY_CELLS[0]),
                                  slide(set, against, side, WAY_CELLS[1]),
                                  slide(set, against, side, WAY_CELLS[2]),
                                  exposed[side],
                                  0,
                                  side};
    for (int side = 0; side < DMI_GRID_SIDES; side++) out[side].back = out[side ^ 1].near;
    for (int i = 1; i < DMI_GRID_SIDES; i++)
        for (int j = i; j > 0 && way_cost(&out[j]) < way_cost(&out[j - 1]); j--) {
            const dmi_set_way t = out[j];
            out[j] = out[j - 1], out[j - 1] = t;
        }
}

/* ---- turns ---- */

static float diagonal_of(const dmi_node_set* s) {
    float sum = 0;
    for (int k = 0; k < 3; k++) sum += (s->high[k] - s->low[k]) * (s->high[k] - s->low[k]);
    return sqrtf(sum) + TINY;
}

static float touch_distance(const dmi_node_set* s, int axis, const float at[3]) {
    float sum = 0;
    uint32_t count = 0;
    for (uint32_t p = 0; p < s->point_count; p++) {
        if (s->touches[p] == 0) continue;
        float d = 0;
        for (int k = 0; k < 3; k++)
            if (k != axis) d += (s->points[p][k] - at[k]) * (s->points[p][k] - at[k]);
        sum += sqrtf(d);
        count++;
    }
    return count > 0 ? sum / (float)count / diagonal_of(s) : 1;
}

static float turn_by(const dmi_node_set* s, int axis, const float at[3], float angle) {
    const dmi_set_motion m = {.axis = axis, .angle = angle, .at = {at[0], at[1], at[2]}};
    return dmi_node_set_collide(s, UINT32_MAX, &m);
}

static dmi_set_turn measure_turn(const dmi_node_set* s, int axis, const float at[3]) {
    const float little[2] = {turn_by(s, axis, at, LITTLE), turn_by(s, axis, at, -LITTLE)};
    const float much[2] = {turn_by(s, axis, at, MUCH), turn_by(s, axis, at, -MUCH)};
    const int sense = little[1] + much[1] < little[0] + much[0];
    return (dmi_set_turn){little[sense], much[sense], little[!sense], touch_distance(s, axis, at),
                          s->high[axis] - s->low[axis]};
}

static float turn_cost(const dmi_set_turn* t) {
    return t->little + t->much + APART_COST * t->apart;
}

void dmi_measure_edges(const dmi_node_set* s, dmi_set_turn out[2], uint32_t* out_free) {
    dmi_set_turn best_of[3];
    *out_free = 0;
    for (int axis = 0; axis < 3; axis++) {
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        for (int corner = 0; corner < CORNERS; corner++) {
            float at[3] = {0};
            at[b] = corner & 1 ? s->high[b] : s->low[b];
            at[c] = corner & 2 ? s->high[c] : s->low[c];
            const dmi_set_turn t = measure_turn(s, axis, at);
            *out_free += t.little + t.much < DMI_FREE;
            if (corner == 0 || turn_cost(&t) < turn_cost(&best_of[axis])) best_of[axis] = t;
        }
    }
    int best = 0;
    for (int axis = 1; axis < 3; axis++)
        if (turn_cost(&best_of[axis]) < turn_cost(&best_of[best])) best = axis;
    const int one = (best + 1) % 3, two = (best + 2) % 3;
    out[0] = best_of[best];
    out[1] = turn_cost(&best_of[one]) < turn_cost(&best_of[two]) ? best_of[one] : best_of[two];
}

dmi_set_spin dmi_measure_spin(const dmi_node_set* s) {
    dmi_set_spin best = {.round = -1};
    float at[3];
    for (int k = 0; k < 3; k++) at[k] = 0.5f * (s->low[k] + s->high[k]);
    for (int axis = 0; axis < 3; axis++) {
        float round = 1;
        for (int i = 1; i <= 2; i++) {
            const dmi_set_motion m = {.axis = axis, .angle = SPIN_STEP * (float)i, .at = {at[0], at[1], at[2]}};
            round = dmi_fminf(round, dmi_node_set_coincide(s, &m));
        }
        if (round > best.round) best = (dmi_set_spin){round, measure_turn(s, axis, at)};
    }
    return best;
}
