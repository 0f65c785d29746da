/* Joints of key poses. Rest is the identity, and on the joint as well: a turn about a line through o along a, by angles
 * v, with a pitch h, is x -> R(v) (x - o) + o + h v a. Its translations t = (I - R) o + h v a give h by t.a, and o by
 * least squares in closed form, because the sum of (I - R)^T (I - R) across the axis is that of 2 (1 - cos v). */
#include "assets/body_hints.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "math/elementary.h"

/* A clip that moves no point by more than this share of the asset's size says nothing. By hand: what exporters leave of
 * a key that nobody has moved. */
#define STILL_SHARE 1e-4
/* Angle below which a clip slides, rad. By hand: as the share above, of an asset's half. */
#define STILL_TURN 2e-4
/* How far keys may be off a joint, in shares of the asset's size, and in rad. By hand: nobody sees it, and exporters
 * that bake curves stay below it. */
#define LENGTH_ERROR 5e-3
#define TURN_ERROR 5e-3
/* Advance of a turn along its axis from which on it is a screw, in shares of the asset's size. By hand. */
#define SCREW_SHARE 1e-3
/* Share of the way below which an end of it is rest. By hand: some steps of a float. */
#define REST_SHARE 1e-6
/* How much less than a full turn is one, rad. By hand: rounding. */
#define FULL_TURN_ERROR 1e-3
/* Largest last step of a turn that leaves out its last frame because it begins anew with the first, rad. By hand: 30
 * degrees. */
#define LOOP_STEP 0.5236
#define PI 3.14159265358979323846

/* A joint without limits. */
typedef struct axis_joint {
    int32_t type; /* DM_JOINT_PRISMATIC, REVOLUTE or SCREW */
    double axis[3], origin[3], pitch;
} axis_joint;

/* Values of a joint that a clip reaches. */
typedef struct value_range {
    double lower, upper;
    double last_step; /* change between its last two keys */
} value_range;

/* What moves clips are measured against. */
typedef struct scale {
    double centre[3], size;
} scale;

/* ---- poses ---- */

typedef struct rigid {
    double q[4], t[3];
} rigid;

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static double length_of(const double v[3]) {
    return sqrt(dot(v, v));
}

static rigid read_pose(const dm_pose* pose) {
    rigid out;
    double norm = 0, c[3];
    for (int k = 0; k < 4; k++) norm += (double)pose->real[k] * (double)pose->real[k];
    norm = sqrt(norm);
    for (int k = 0; k < 4; k++) out.q[k] = norm > 0 ? (double)pose->real[k] / norm : k == 3;
    const double d[4] = {(double)pose->dual[0], (double)pose->dual[1], (double)pose->dual[2], (double)pose->dual[3]};
    cross(out.q, d, c);
    for (int k = 0; k < 3; k++) out.t[k] = 2 * (out.q[3] * d[k] - d[3] * out.q[k] + c[k]) / (norm > 0 ? norm : 1);
    return out;
}

static void rotate(const double q[4], const double v[3], double out[3]) {
    double c[3], twice[3];
    cross(q, v, c);
    for (int k = 0; k < 3; k++) c[k] += q[3] * v[k];
    cross(q, c, twice);
    for (int k = 0; k < 3; k++) out[k] = v[k] + 2 * twice[k];
}

/* The angle of a rotation, 0 to pi. */
static double angle_of(const rigid* pose) {
    return 2 * dmi_atan2(length_of(pose->q), fabs(pose->q[3]));
}

/* How far a pose moves the centre. */
static double way_of(const rigid* pose, const scale* by) {
    double moved[3];
    rotate(pose->q, by->centre, moved);
    for (int k = 0; k < 3; k++) moved[k] += pose->t[k] - by->centre[k];
    return length_of(moved);
}

/* ---- values on a joint ---- */

static double nearest_turn(double angle, double near) {
    return angle + 2 * PI * floor((near - angle) / (2 * PI) + 0.5);
}

/* The value of a joint whose pose is nearest; of turns, the one nearest to `near`. */
static double value_of(const axis_joint* joint, const rigid* pose, double near) {
    if (joint->type == DM_JOINT_PRISMATIC) return dot(pose->t, joint->axis);
    return nearest_turn(2 * dmi_atan2(dot(pose->q, joint->axis), pose->q[3]), near);
}

/* Whether the joint at a value has the pose, but for what nobody sees. */
static bool is_on_joint(const axis_joint* joint, const rigid* pose, double value, const scale* by) {
    double off[3], turned[3];
    const bool slides = joint->type == DM_JOINT_PRISMATIC;
    const double along = dot(pose->q, joint->axis), advance = slides ? value : joint->pitch * value;
    for (int k = 0; k < 3; k++) off[k] = pose->q[k] - (slides ? 0 : along * joint->axis[k]);
    if (2 * length_of(off) > TURN_ERROR) return false;
    rotate(pose->q, joint->origin, turned);
    for (int k = 0; k < 3; k++) {
        const double turn = slides ? 0 : joint->origin[k] - turned[k];
        off[k] = turn + advance * joint->axis[k] - pose->t[k];
    }
    return length_of(off) <= LENGTH_ERROR * by->size;
}

/* Writes the values that the clip reaches. Returns false where a key is not on the joint. */
static bool find_range(const axis_joint* joint, const dm_asset_clip* clip, const scale* by, value_range* out) {
    double value = 0;
    for (uint32_t i = 0; i < clip->key_count; i++) {
        const rigid pose = read_pose(&clip->poses[i]);
        const double next = value_of(joint, &pose, value);
        if (!is_on_joint(joint, &pose, next, by)) return false;
        out->last_step = i > 0 ? fabs(next - value) : 0;
        out->lower = i > 0 ? dmi_fmin(out->lower, next) : next;
        out->upper = i > 0 ? dmi_fmax(out->upper, next) : next;
        value = next;
    }
    return true;
}

/* Widens a range by another one. Turns that begin at half a turn may be a whole one off: they go where the least is
 * added. */
static void widen(value_range* range, const value_range* by, bool turns) {
    double best = INFINITY, lower = 0, upper = 0;
    for (int turn = -1; turn <= 1; turn++) {
        const double shift = turns ? turn * 2 * PI : 0;
        const double low = dmi_fmin(range->lower, by->lower + shift), high = dmi_fmax(range->upper, by->upper + shift);
        const double least = high - low + (turn == 0 ? 0 : FULL_TURN_ERROR);
        if (least >= best) continue;
        best = least;
        lower = low;
        upper = high;
    }
    range->lower = lower;
    range->upper = upper;
    range->last_step = dmi_fmax(range->last_step, by->last_step);
}

/* ---- fitting ---- */

typedef enum fit { STILL, FITS, NO_JOINT } fit;

/* Finds the direction of keys that do not turn: between the two that are about farthest apart, rest among them. */
static void fit_slide(const dm_asset_clip* clip, axis_joint* out) {
    double ends[2][3] = {{0, 0, 0}, {0, 0, 0}};
    for (int end = 0; end < 2; end++) {
        const double* from = ends[1 - end];
        double farthest = end == 0 ? -1 : length_of(ends[0]);
        for (uint32_t i = 0; i < clip->key_count; i++) {
            const rigid pose = read_pose(&clip->poses[i]);
            const double way[3] = {pose.t[0] - from[0], pose.t[1] - from[1], pose.t[2] - from[2]};
            if (length_of(way) <= farthest) continue;
            farthest = length_of(way);
            memcpy(ends[end], pose.t, sizeof pose.t);
        }
    }
    for (int k = 0; k < 3; k++) out->axis[k] = ends[0][k] - ends[1][k];
    const double length = length_of(out->axis);
    for (int k = 0; k < 3; k++) out->axis[k] /= length;
    out->type = DM_JOINT_PRISMATIC;
}

/* Finds the mean axis of rotations that are all about one line, or the other way about it. */
static void fit_axis(const dm_asset_clip* clip, double out[3]) {
    double most = 0, sum[3] = {0, 0, 0};
    for (uint32_t i = 0; i < clip->key_count; i++) {
        const rigid pose = read_pose(&clip->poses[i]);
        if (length_of(pose.q) <= most) continue;
        most = length_of(pose.q);
        memcpy(out, pose.q, 3 * sizeof *out);
    }
    for (uint32_t i = 0; i < clip->key_count; i++) {
        const rigid pose = read_pose(&clip->poses[i]);
        const double sign = dot(pose.q, out) < 0 ? -1 : 1;
        for (int k = 0; k < 3; k++) sum[k] += sign * pose.q[k];
    }
    const double length = length_of(sum);
    for (int k = 0; k < 3; k++) out[k] = sum[k] / length;
}

/* Finds line and pitch of keys that turn about an axis. */
static void fit_line(const dm_asset_clip* clip, const scale* by, axis_joint* out) {
    double value = 0, advance = 0, squares = 0, farthest = 0, sum[3] = {0, 0, 0}, weight = 0;
    for (uint32_t i = 0; i < clip->key_count; i++) {
        const rigid pose = read_pose(&clip->poses[i]);
        value = value_of(out, &pose, value);
        const dmi_circle circle = dmi_circle_at(value);
        const double along = dot(pose.t, out->axis);
        double across[3], turned[3];
        for (int k = 0; k < 3; k++) across[k] = pose.t[k] - along * out->axis[k];
        cross(out->axis, across, turned); /* (I - R)^T t = (1 - cos) t + sin (a x t), across the axis */
        for (int k = 0; k < 3; k++) sum[k] += (1 - circle.cosine) * across[k] + circle.sine * turned[k];
        weight += 2 * (1 - circle.cosine);
        advance += value * along;
        squares += value * value;
        farthest = dmi_fmax(farthest, fabs(value));
    }
    for (int k = 0; k < 3; k++) out->origin[k] = sum[k] / weight;
    out->pitch = advance / squares;
    const bool is_screw = fabs(out->pitch) * farthest > SCREW_SHARE * by->size;
    if (!is_screw) out->pitch = 0;
    out->type = is_screw ? DM_JOINT_SCREW : DM_JOINT_REVOLUTE;
}

/* Finds the joint of one clip, and the values that it reaches. */
static fit fit_clip(const dm_asset_clip* clip, const scale* by, axis_joint* out, value_range* out_range) {
    double turn = 0, way = 0;
    *out = (axis_joint){.type = DM_JOINT_REVOLUTE};
    for (uint32_t i = 0; i < clip->key_count; i++) {
        const rigid pose = read_pose(&clip->poses[i]);
        turn = dmi_fmax(turn, angle_of(&pose));
        way = dmi_fmax(way, way_of(&pose, by));
    }
    if (turn * by->size / 2 + way < STILL_SHARE * by->size) return STILL;
    if (turn < STILL_TURN) {
        fit_slide(clip, out);
    } else {
        fit_axis(clip, out->axis);
        fit_line(clip, by, out);
    }
    return find_range(out, clip, by, out_range) ? FITS : NO_JOINT;
}

/* ---- duration ---- */

/* The least time that the clip takes from one end of its range to the other. */
static double find_duration(const axis_joint* joint, const dm_asset_clip* clip, const value_range* range) {
    const double near = STILL_SHARE * (range->upper - range->lower);
    double value = 0, left[2] = {-1, -1}, least = INFINITY; /* left: when it was last at an end; -1: not yet */
    for (uint32_t i = 0; i < clip->key_count; i++) {
        const rigid pose = read_pose(&clip->poses[i]);
        const double time = (double)clip->times[i] - (double)clip->times[0];
        value = value_of(joint, &pose, value);
        const int end = value <= range->lower + near ? 0 : value >= range->upper - near ? 1 : -1;
        if (end < 0) continue;
        if (left[1 - end] >= 0) least = dmi_fmin(least, time - left[1 - end]);
        left[end] = time;
    }
    return least < INFINITY ? least : 0;
}

/* ---- the answer ---- */

/* Whether the turn goes round: by a full turn, or by one but for the frame with which it begins anew. */
static bool goes_round(const axis_joint* joint, const value_range* range) {
    const double turn = range->upper - range->lower;
    const double step = range->last_step <= LOOP_STEP ? range->last_step : 0;
    return joint->type == DM_JOINT_REVOLUTE && turn + step >= 2 * PI - FULL_TURN_ERROR;
}

/* An end of a range; 0 where it is rest but for rounding. */
static float end_of(double end, const value_range* range) {
    return fabs(end) > REST_SHARE * (range->upper - range->lower) ? (float)end : 0;
}

static dm_joint make_joint(const axis_joint* from, const value_range* range, const scale* by) {
    const double sign = range->upper < -range->lower ? -1 : 1;
    const bool round = goes_round(from, range);
    double between[3];
    for (int k = 0; k < 3; k++) between[k] = by->centre[k] - from->origin[k];
    const double along = dot(between, from->axis);
    double origin[3];
    for (int k = 0; k < 3; k++) origin[k] = from->origin[k] + along * from->axis[k];
    if (from->type == DM_JOINT_PRISMATIC) memcpy(origin, by->centre, sizeof origin);
    return (dm_joint){
        .struct_size = sizeof(dm_joint),
        .type = round ? DM_JOINT_CONTINUOUS : from->type,
        .type_confidence = 1,
        .joint_confidence = 1,
        .pitch = (float)from->pitch,
        .axis = {(float)(sign * from->axis[0]), (float)(sign * from->axis[1]), (float)(sign * from->axis[2])},
        .origin = {(float)origin[0], (float)origin[1], (float)origin[2]},
        .lower = round ? 0 : end_of(sign > 0 ? range->lower : -range->upper, range),
        .upper = round ? 0 : end_of(sign > 0 ? range->upper : -range->lower, range),
        .source = DM_JOINT_FROM_HOST};
}

/* How far a clip moves the node, as a length. */
static double reach_of(const axis_joint* joint, const value_range* range, const scale* by) {
    const double values = range->upper - range->lower;
    return joint->type == DM_JOINT_PRISMATIC ? values : values * by->size / 2;
}

/* Finds the clip that moves the node farthest and by a joint. Returns its index; count: there is none. */
static uint32_t find_best(const dm_asset_clip* clips, uint32_t count, const scale* by, axis_joint* out,
                          uint32_t* out_left_out) {
    uint32_t best = count;
    double farthest = 0;
    for (uint32_t i = 0; i < count; i++) {
        axis_joint joint;
        value_range range = {0, 0, 0};
        if (clips[i].flags & DM_CLIP_NOT_RIGID) {
            *out_left_out |= DMI_CLIP_NOT_RIGID;
            continue;
        }
        const fit found = fit_clip(&clips[i], by, &joint, &range);
        if (found == NO_JOINT) *out_left_out |= DMI_CLIP_NO_JOINT;
        if (found != FITS || (best < count && reach_of(&joint, &range, by) <= farthest)) continue;
        best = i;
        farthest = reach_of(&joint, &range, by);
        *out = joint;
    }
    return best;
}

dmi_clip_joint dmi_clip_find_joint(const dm_asset_clip* clips, uint32_t count, const float centre[3], float size) {
    const scale by = {{(double)centre[0], (double)centre[1], (double)centre[2]}, (double)size};
    dmi_clip_joint out = {.is_found = false};
    axis_joint joint;
    const uint32_t best = find_best(clips, count, &by, &joint, &out.left_out);
    if (best == count) return out;
    value_range range = {0, 0, 0};
    for (uint32_t i = 0; i < count; i++) {
        axis_joint other;
        value_range of_clip = {0, 0, 0};
        if ((clips[i].flags & DM_CLIP_NOT_RIGID) || fit_clip(&clips[i], &by, &other, &of_clip) != FITS) continue;
        if (!find_range(&joint, &clips[i], &by, &of_clip))
            out.left_out |= DMI_CLIP_DISAGREES;
        else
            widen(&range, &of_clip, joint.type != DM_JOINT_PRISMATIC);
        if (i == best) out.duration = (float)find_duration(&joint, &clips[i], &of_clip);
    }
    out.is_found = true;
    out.joint = make_joint(&joint, &range, &by);
    return out;
}
