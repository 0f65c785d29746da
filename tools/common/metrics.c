/* Metrics of an answered joint against the true one. */
#include "metrics.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "play.h"

/* Range in which the answered joint's value is searched; by hand, beyond any true travel. */
static const double max_turn = 2.2 /* rad */, max_slide = 1.5 /* object sizes */;
static const double free_turn = 1 /* rad */, free_slide = 0.3 /* object sizes */; /* travel without limits; by hand */
static const double max_travel = 1.2; /* rad: most of a turn that is measured; by hand */
enum { CHAMFER_POINTS = 256 };        /* vertices of a part; by hand, for the time of a run */

static bool kind_slides(int32_t type) {
    return type == DM_JOINT_PRISMATIC;
}

static vec move(vec point, bool slides, vec axis, vec origin, double value) {
    return slides ? add(point, scale(axis, value)) : add(turn(sub(point, origin), axis, value), origin);
}

vec metrics_true_move(const metric_case* known, vec point, double value) {
    return move(point, known->truth->slides, known->truth->axis, known->truth->origin, value);
}

/* Full travel: the limit farther from rest, at most max_travel. */
double metrics_travel(const metric_case* known) {
    const known_joint* truth = known->truth;
    const double lower = isnan(truth->lower) ? 0 : truth->lower;
    double travel = truth->slides ? free_slide * known->size : free_turn;
    if (!isnan(truth->upper)) {
        const double far = fabs(truth->upper) >= fabs(lower) ? truth->upper : lower;
        if (truth->slides && far != 0) travel = far;
        if (!truth->slides) travel = far != 0 ? copysign(fmin(fabs(far), max_travel), far) : free_turn;
    }
    const double step = travel < 0 ? -1e-4 : 1e-4; /* finite difference: only its sign counts */
    const vec way = sub(metrics_true_move(known, known->drag->point, step), known->drag->point);
    return dot(way, known->drag->vector) < 0 ? -travel : travel;
}

/* Returns the value that brings `from` nearest to `to`, within the search range. */
static double value_to_reach(vec from, vec to, bool slides, vec axis, vec origin, double size) {
    if (slides) return fmin(fmax(dot(sub(to, from), axis), -max_slide * size), max_slide * size);
    const vec u = sub(from, origin), v = sub(to, origin);
    const double sine = dot(axis, cross(u, v)), cosine = dot(u, v) - dot(u, axis) * dot(v, axis);
    return fmin(fmax(atan2(sine, cosine), -max_turn), max_turn);
}

double metrics_answered_travel(const metric_case* known, const dm_joint* joint) {
    const vec goal = metrics_true_move(known, known->drag->point, metrics_travel(known));
    return value_to_reach(known->drag->point, goal, kind_slides(joint->type), unit(vec_of(joint->axis)),
                          vec_of(joint->origin), known->size);
}

static double pose_error(const metric_case* known, const dm_joint* joint) {
    const bool slides = kind_slides(joint->type);
    const vec axis = unit(vec_of(joint->axis)), origin = vec_of(joint->origin);
    const double travel = metrics_travel(known), value = metrics_answered_travel(known, joint);
    double sum = 0;
    for (size_t i = 0; i < known->moving_count; i++)
        sum += length(sub(move(known->moving[i], slides, axis, origin, value),
                          metrics_true_move(known, known->moving[i], travel)));
    return sum / (double)known->moving_count / known->size;
}

static void clear(const metric_case* known, metric_row* row) {
    for (int i = 0; i < METRIC_COUNT; i++) row->value[i] = NAN;
    row->slides = known->truth->slides;
}

void metrics_of_failure(const metric_case* known, metric_row* out_row) {
    clear(known, out_row);
    out_row->answered = false;
    out_row->value[METRIC_TYPE] = 0;
    out_row->value[METRIC_AXIS] = 1e3 * PI / 2;
    out_row->value[METRIC_POSE] = out_row->value[METRIC_POSE_TOP3] = 1;
    if (!known->truth->slides) out_row->value[METRIC_ORIGIN] = 1000;
}

static void measure_origin(const metric_case* known, vec axis, vec origin, double value[METRIC_COUNT]) {
    const known_joint* truth = known->truth;
    vec centre = {0, 0, 0};
    for (size_t i = 0; i < known->moving_count; i++) centre = add(centre, known->moving[i]);
    centre = scale(centre, 1 / (double)known->moving_count);
    const vec nearest = add(origin, scale(axis, dot(sub(centre, origin), axis)));
    const vec off = sub(nearest, truth->origin), gap = sub(origin, truth->origin);
    const vec beside = cross(truth->axis, axis);
    const double across = length(beside), k = 1e3 / known->size;
    value[METRIC_ORIGIN] = k * length(sub(off, scale(truth->axis, dot(off, truth->axis))));
    value[METRIC_ORIGIN_L1] = k * (fabs(gap.x) + fabs(gap.y) + fabs(gap.z)) / 3;
    value[METRIC_LINE] = across < 1e-6 ? k * length(sub(gap, scale(truth->axis, dot(gap, truth->axis))))
                                       : k * fabs(dot(gap, beside)) / across;
}

static double range_overlap(const known_joint* truth, const dm_joint* joint, vec axis) {
    double low = fmin(truth->lower, truth->upper), high = fmax(truth->lower, truth->upper);
    double found_low = (double)fminf(joint->lower, joint->upper),
           found_high = (double)fmaxf(joint->lower, joint->upper);
    if (dot(axis, truth->axis) < 0) {
        const double swapped = -found_low;
        found_low = -found_high;
        found_high = swapped;
    }
    const double both = fmax(0, fmin(high, found_high) - fmax(low, found_low));
    return both / fmax(fmax(high, found_high) - fmin(low, found_low), 1e-9);
}

void metrics_of_joint(const metric_case* known, const joint_answer* answer, metric_row* out_row) {
    const known_joint* truth = known->truth;
    const dm_joint* joint = &answer->joint;
    const bool slides = kind_slides(joint->type);
    const vec axis = unit(vec_of(joint->axis)), origin = vec_of(joint->origin);
    clear(known, out_row);
    double* value = out_row->value;
    out_row->answered = true;
    value[METRIC_TYPE] =
        slides == truth->slides && (slides || joint->type == DM_JOINT_REVOLUTE || joint->type == DM_JOINT_CONTINUOUS);
    value[METRIC_AXIS] = 1e3 * acos(fmin(1, fabs(dot(axis, truth->axis))));
    if (!truth->slides) measure_origin(known, axis, origin, value);
    value[METRIC_POSE] = value[METRIC_POSE_TOP3] = pose_error(known, joint);
    for (uint32_t i = 0; i < answer->hypothesis_count && i < 3; i++)
        value[METRIC_POSE_TOP3] = fmin(value[METRIC_POSE_TOP3], pose_error(known, &answer->hypotheses[i]));
    value[METRIC_CONFIDENCE] = (double)joint->joint_confidence;
    if (known->dragged) {
        const vec way = sub(move(known->drag->point, slides, axis, origin, 1e-4), known->drag->point);
        value[METRIC_SIGN] = dot(way, known->drag->vector) > 0;
    }
    if (!isnan(truth->lower) && !isnan(truth->upper) && joint->type != DM_JOINT_CONTINUOUS && value[METRIC_TYPE] > 0)
        value[METRIC_RANGE] = range_overlap(truth, joint, axis);
}

/* ---- generated motion ---- */

static vec apply(const dm_pose* pose, vec point) {
    float xyz[3] = {(float)point.x, (float)point.y, (float)point.z};
    dm_pose_apply_points(pose, xyz, 0, xyz, 0, 1);
    return vec_at(xyz);
}

static double mean_nearest(const vec* from, const vec* to, size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        double best = INFINITY;
        for (size_t j = 0; j < count; j++) {
            const vec gap = sub(from[i], to[j]);
            best = fmin(best, dot(gap, gap));
        }
        sum += best;
    }
    return sum / (double)count;
}

static double chamfer(const metric_case* known, const dm_pose* pose, double value) {
    vec found[CHAMFER_POINTS], right[CHAMFER_POINTS];
    const size_t count = known->moving_count < CHAMFER_POINTS ? known->moving_count : CHAMFER_POINTS;
    for (size_t i = 0; i < count; i++) {
        const vec point = known->moving[i * known->moving_count / count];
        found[i] = apply(pose, point);
        right[i] = metrics_true_move(known, point, value);
    }
    return (mean_nearest(found, right, count) + mean_nearest(right, found, count)) / (known->size * known->size);
}

/* Deviation of one pose from the true axis (paper's L_axis, as a number). */
static double constraint(const metric_case* known, const dm_pose* pose, vec slide) {
    const known_joint* truth = known->truth;
    if (truth->slides) {
        const vec across = cross(scale(slide, 1 / known->size), truth->axis);
        return dot(across, across);
    }
    const vec axis = unit(vec_at(pose->real));
    const double cosine = fabs(dot(axis, truth->axis)); /* 0 when the pose does not turn at all */
    return 2 * (1 - fmin(cosine, 1)) + 0.5 * (1 - fmin(cosine * cosine, 1));
}

void metrics_of_motion(const metric_case* known, const dm_joint* joint, const dm_pose poses[DM_MOTION_FRAMES],
                       metric_row* out_row) {
    const vec origin = vec_of(joint->origin);
    const double travel = metrics_travel(known);
    double distance = 0, deviation = 0, turned = 0, slid = 0;
    for (int i = 1; i < DM_MOTION_FRAMES; i++) {
        const dm_pose* pose = &poses[i];
        const vec slide = sub(apply(pose, origin), origin);
        const double angle = 2 * atan2(length(vec_at(pose->real)), fabs((double)pose->real[3]));
        const double way = travel * (double)minimum_jerk((float)i / (DM_MOTION_FRAMES - 1));
        distance += chamfer(known, pose, way);
        deviation += constraint(known, pose, slide);
        turned += angle * angle;
        slid += dot(slide, slide) / (known->size * known->size);
    }
    out_row->value[METRIC_CHAMFER] = distance / DM_MOTION_FRAMES; /* frame 0 is rest: nothing to add */
    out_row->value[METRIC_CONSTRAINT] = deviation / (DM_MOTION_FRAMES - 1);
    if (known->truth->slides)
        out_row->value[METRIC_SLIDE_TURN] = turned / (DM_MOTION_FRAMES - 1);
    else
        out_row->value[METRIC_TURN_SLIDE] = slid / (DM_MOTION_FRAMES - 1);
}

/* ---- statistics ---- */

typedef struct weighted {
    double value, weight;
} weighted;

static int by_value(const void* a, const void* b) {
    const weighted *left = a, *right = b;
    if (left->value != right->value) return left->value < right->value ? -1 : 1;
    return left->weight < right->weight ? -1 : left->weight > right->weight;
}

/* The first value at which the weights below and at it reach `share` of all. */
static double quantile(const weighted* items, size_t count, double total, double share) {
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        sum += items[i].weight;
        if (sum / total >= share) return items[i].value;
    }
    return items[count - 1].value;
}

metric_stat metrics_stat(const metric_row* rows, size_t count, const unsigned char* pick, enum metric metric) {
    weighted* items = cli_alloc(count * sizeof *items);
    metric_stat out = {0, NAN, NAN, NAN};
    double total = 0, sum = 0;
    for (size_t i = 0; i < count; i++) {
        const double value = rows[i].value[metric];
        if ((pick != NULL && !pick[i]) || isnan(value)) continue;
        items[out.count++] = (weighted){value, rows[i].weight};
        total += rows[i].weight;
        sum += value * rows[i].weight;
    }
    if (out.count > 0) {
        qsort(items, out.count, sizeof *items, by_value);
        out.mean = sum / total;
        out.median = quantile(items, out.count, total, 0.5);
        out.p90 = quantile(items, out.count, total, 0.9);
    }
    free(items);
    return out;
}

double metrics_share_below(const metric_row* rows, size_t count, const unsigned char* pick, enum metric metric,
                           double limit) {
    double total = 0, below = 0;
    for (size_t i = 0; i < count; i++) {
        if ((pick != NULL && !pick[i]) || isnan(rows[i].value[metric])) continue;
        total += rows[i].weight;
        if (rows[i].value[metric] < limit) below += rows[i].weight;
    }
    return total > 0 ? below / total : NAN;
}

metric_calibration metrics_calibrate(const metric_row* rows, size_t count, const unsigned char* pick) {
    metric_calibration out = {.error = NAN};
    double total = 0, error = 0;
    for (size_t i = 0; i < count; i++) {
        const double stated = rows[i].value[METRIC_CONFIDENCE];
        if ((pick != NULL && !pick[i]) || isnan(stated)) continue;
        const int bin = (int)fmin(fmax(stated, 0) * METRICS_BINS, METRICS_BINS - 1);
        out.weight[bin] += rows[i].weight;
        out.stated[bin] += rows[i].weight * stated;
        out.right[bin] += rows[i].value[METRIC_POSE] < METRICS_RIGHT ? rows[i].weight : 0;
        total += rows[i].weight;
    }
    for (int bin = 0; bin < METRICS_BINS; bin++) {
        error += fabs(out.stated[bin] - out.right[bin]);
        out.stated[bin] = out.weight[bin] > 0 ? out.stated[bin] / out.weight[bin] : NAN;
        out.right[bin] = out.weight[bin] > 0 ? out.right[bin] / out.weight[bin] : NAN;
        out.weight[bin] = total > 0 ? out.weight[bin] / total : 0;
    }
    if (total > 0) out.error = error / total;
    return out;
}
