/* Collision sweep: moves the part along a candidate joint, both ways, through the distance grid of its body. */
#include "kinematics/analysis/batched_transform.h"
#include "kinematics/features/feature_groups.h"
#include "math/linear3.h"

/* How far the part goes. The steps between only serve to notice hits on the way: a board that is thinner than a step
 * and two cells is met by some of the points that pass through it. */
enum { SHORT = 0, MIDDLE = 4, LONG = 10, STEPS = 11 };

/* Cosines and sines of 0.06, 0.1, 0.15, 0.24, 0.35, 0.5, 0.65, 0.8, 1.0, 1.2 and 1.4 rad, and shares of the part's
 * extent along a slide; by hand. */
static const float step_cosine[STEPS] = {0.99820054f, 0.99500417f, 0.98877108f, 0.97133797f, 0.93937271f, 0.87758256f,
                                         0.7960838f,  0.69670671f, 0.54030231f, 0.36235775f, 0.16996714f};
static const float step_sine[STEPS] = {0.059964006f, 0.099833417f, 0.14943813f, 0.23770263f, 0.34289781f, 0.47942554f,
                                       0.60518641f,  0.71735609f,  0.84147098f, 0.93203909f, 0.98544973f};
static const float step_share[STEPS] = {0.04f, 0.08f, 0.12f, 0.18f, 0.25f, 0.33f, 0.41f, 0.5f, 0.61f, 0.73f, 0.85f};

typedef struct sweep {
    float hit[2][STEPS], detached[2][STEPS], touch[2][STEPS]; /* one way: along the joint; the other: against it */
} sweep;

void dmi_sweep_features_begin(dmi_feature_context* context) {
    const dmi_part_analysis* a = context->analysis;
    context->free_count =
        dmi_put_free_points_first(&a->body_grid, (const float(*)[3])a->points, DMI_SWEPT_POINTS, context->swept);
}

/* Returns the third smallest distance: a couple of points may lag behind a part that has left the body. */
static float third_smallest(const float* distance) {
    float near[3] = {INFINITY, INFINITY, INFINITY};
    for (uint32_t i = 0; i < DMI_SWEPT_POINTS; i++) {
        /* Keeps the least three in order, without a branch. */
        const float d = distance[i], first = dmi_max(near[0], d), second = dmi_max(near[1], first);
        near[0] = dmi_min(near[0], d);
        near[1] = dmi_min(near[1], first);
        near[2] = dmi_min(near[2], second);
    }
    return near[2];
}

static float share_nearer(const float* distance, float limit) {
    int32_t count = 0;
    for (int i = 0; i < DMI_SWEPT_POINTS; i++) count += distance[i] < limit;
    return (float)count / DMI_SWEPT_POINTS;
}

/* Counts the free points that have met the body by now. A point that has met it stays so. */
static uint32_t add_hits(const int32_t* meets, uint32_t free_count, int32_t hit[DMI_SWEPT_POINTS]) {
    uint32_t hits = 0;
    for (uint32_t i = 0; i < free_count; i++) {
        hit[i] |= meets[i];
        hits += (uint32_t)hit[i];
    }
    return hits;
}

static void carry(const dmi_candidate* c, const float (*points)[3], dmi_batched_transform* out) {
    if (dmi_candidate_slides(c))
        dmi_batched_transform_prismatic(c->axis, points, DMI_SWEPT_POINTS, out);
    else
        dmi_batched_transform_revolute(c->axis, c->origin, points, DMI_SWEPT_POINTS, out);
}

/* Sweeps one way. A free point that moves into a cell of the body's surface has met it. */
static void sweep_side(const dmi_feature_context* context, const dmi_candidate* c, float extent, int side,
                       dmi_batched_transform* moved, sweep* out) {
    const dmi_distance_grid* body = &context->analysis->body_grid;
    const float sign = side == 0 ? 1.0f : -1.0f;
    const uint32_t free_batches = dmi_whole_batches(context->free_count);
    int32_t hit[DMI_SWEPT_POINTS] = {0};
    uint32_t hits = 0;
    for (int step = 0; step < STEPS; step++) {
        const float cosine = step_cosine[step], sine = sign * step_sine[step];
        const float shift = dmi_candidate_slides(c) ? sign * step_share[step] * extent : 0;
        if (hits < context->free_count) {
            int32_t meets[DMI_POINT_BATCH];
            moved->count = free_batches;
            dmi_batched_transform_meetings(moved, cosine, sine, shift, body, meets);
            hits = add_hits(meets, context->free_count, hit);
        }
        out->hit[side][step] = (float)hits / DMI_SWEPT_POINTS;
        if (step != MIDDLE && step != LONG) continue;
        float distance[DMI_POINT_BATCH];
        moved->count = DMI_SWEPT_POINTS;
        dmi_batched_transform_distances(moved, cosine, sine, shift, body, distance);
        out->touch[side][step] = share_nearer(distance, DMI_TOUCH_CELLS * body->cell);
        out->detached[side][step] = third_smallest(distance) / context->analysis->diagonal;
    }
}

static void sweep_part(const dmi_feature_context* context, const dmi_candidate* c, sweep* out) {
    float extent = 0;
    for (int k = 0; k < 3; k++)
        extent += fabsf(dmi_dot3(c->axis, context->analysis->box.axes[k])) * context->cheap.side[k];
    dmi_batched_transform moved;
    carry(c, (const float(*)[3])context->swept, &moved);
    for (int side = 0; side < 2; side++) sweep_side(context, c, extent, side, &moved, out);
}

/* Writes the numbers of both ways: the drag's way first, or the smaller number where there is no drag. */
static void write_pair(const dmi_feature_context* context, const float both[2][STEPS], int step, float* along,
                       float* against) {
    const float a = both[0][step], b = both[1][step];
    *along = context->hint != NULL ? a : dmi_min(a, b);
    *against = context->hint != NULL ? b : dmi_max(a, b);
}

void dmi_sweep_features(const dmi_feature_context* context, const dmi_candidate* candidate,
                        float row[DMI_FEATURE_COUNT]) {
    sweep s;
    sweep_part(context, candidate, &s);
#define WRITE(what, of, step)                                                                                          \
    write_pair(context, (const float(*)[STEPS])s.of, step, &row[DMI_FEATURE_##what##_##step##_ALONG],                  \
               &row[DMI_FEATURE_##what##_##step##_AGAINST])
    WRITE(HIT, hit, SHORT);
    WRITE(HIT, hit, MIDDLE);
    WRITE(HIT, hit, LONG);
    WRITE(DETACHED, detached, MIDDLE);
    WRITE(DETACHED, detached, LONG);
    WRITE(TOUCH, touch, MIDDLE);
    WRITE(TOUCH, touch, LONG);
#undef WRITE
}
