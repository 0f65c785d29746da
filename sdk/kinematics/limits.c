/* Limits from a sweep of the part's samples through the body's distance grid: what stops the part, weighed with what is
 * known of its kind by a small network, or by rules without one. */
#include "kinematics/limits.h"

#include "kinematics/linear3.h"

#define POINTS 192
#define TURN_STEP 0.05f
#define HALF_TURN 3.14159265f
#define TURN_STEPS 63 /* to half a turn */
#define SLIDE_STEPS 48
#define STOPPED 0.03f /* share of the free points that must meet the body */
#define JAMMED 0.15f  /* share that no gap or thin shell explains */
#define ROUND 0.02f   /* most distance from itself, over its diagonal, of a turned part that counts as round */
#define USUAL_OPENING 1.5707963f
#define USUAL_TRAVEL 0.8f /* of the part's extent along a slide: drawers stay on their runners */

typedef struct sweeper {
    const dmi_study* study;
    const dm_joint* joint;
    float axis[3], origin[3];
    uint8_t free[POINTS];
    uint32_t free_count;
} sweeper;

/* The joint at a value. */
typedef struct placement {
    float value, cosine, sine;
} placement;

static placement place(const sweeper* s, float value) {
    if (s->joint->type == DM_JOINT_PRISMATIC) return (placement){value, 1, 0};
    return (placement){value, cosf(value), sinf(value)};
}

static void moved(const sweeper* s, const float point[3], placement at, float out[3]) {
    if (s->joint->type == DM_JOINT_PRISMATIC) {
        dmi_madd3(point, at.value, s->axis, out);
        return;
    }
    dmi_turn3(s->axis, s->origin, at.cosine, at.sine, point, out);
    if (s->joint->type == DM_JOINT_SCREW) dmi_madd3(out, s->joint->pitch * at.value, s->axis, out);
}

/* Share of the free points that are inside the body's cells at a value. */
static float blocked(const sweeper* s, float value) {
    const placement at = place(s, value);
    uint32_t hits = 0;
    for (uint32_t i = 0; i < POINTS; i++) {
        float x[3];
        if (!s->free[i]) continue;
        moved(s, s->study->points[i], at, x);
        hits += dmi_field_distance(&s->study->body_field, x) < 0.9f * s->study->body_field.cell;
    }
    return s->free_count > 0 ? (float)hits / (float)s->free_count : 0;
}

/* Largest values, in steps, that the part reaches in the direction of `step` before it is stopped, and jammed. */
static void reach(const sweeper* s, float step, int steps, float out[2]) {
    out[0] = out[1] = step * (float)steps;
    int stopped = 0;
    for (int i = 1; i <= steps; i++) {
        float share = blocked(s, step * (float)i);
        if (!stopped && share > STOPPED) out[0] = step * (float)(i - 1), stopped = 1;
        if (share <= JAMMED) continue;
        out[1] = step * (float)(i - 1);
        return;
    }
}

static float extent_along(const sweeper* s) {
    const dmi_study* study = s->study;
    float low, high;
    dmi_shape_limits((const float(*)[3])study->extremes, study->extreme_count, &s->axis, 1, &low, &high);
    return high - low;
}

/* Mean distance from itself of the part turned by three angles: small for a knob, a wheel, a cap. */
static float roundness(const sweeper* s) {
    placement at[3];
    float mean = 0;
    for (int i = 0; i < 3; i++) at[i] = place(s, 0.4f + 2.1f * (float)i);
    for (uint32_t i = 0; i < POINTS; i++) {
        float x[3];
        moved(s, s->study->points[i], at[i % 3], x);
        mean += dmi_field_distance(&s->study->part_field, x) / POINTS;
    }
    return mean;
}

static int is_round(const sweeper* s) {
    return roundness(s) < ROUND * s->study->diagonal + 0.5f * s->study->part_field.cell;
}

static void limit_turn(const sweeper* s, dm_joint* joint) {
    float up[2], down[2];
    reach(s, TURN_STEP, TURN_STEPS, up);
    reach(s, -TURN_STEP, TURN_STEPS, down);
    if (up[0] >= 3.1f && down[0] <= -3.1f && joint->type == DM_JOINT_REVOLUTE && is_round(s)) {
        joint->type = DM_JOINT_CONTINUOUS;
        joint->lower = -HALF_TURN, joint->upper = HALF_TURN;
        return;
    }
    /* It rests closed: the side with more room is the one it opens to. */
    joint->upper = up[0] >= -down[0] ? fminf(up[0], USUAL_OPENING) : 0;
    joint->lower = up[0] >= -down[0] ? 0 : fmaxf(down[0], -USUAL_OPENING);
    if (joint->upper - joint->lower < TURN_STEP) joint->upper = USUAL_OPENING, joint->lower = 0;
}

static void limit_slide(const sweeper* s, dm_joint* joint) {
    float most = USUAL_TRAVEL * fmaxf(extent_along(s), 0.01f), step = most / SLIDE_STEPS, up[2], down[2];
    reach(s, step, SLIDE_STEPS, up);
    reach(s, -step, SLIDE_STEPS, down);
    joint->upper = up[0] >= -down[0] ? up[0] : 0;
    joint->lower = up[0] >= -down[0] ? 0 : down[0];
    if (joint->upper - joint->lower < step) joint->upper = most, joint->lower = 0;
}

static sweeper make_sweeper(const dmi_study* study, const dm_joint* joint) {
    sweeper s = {.study = study,
                 .joint = joint,
                 .axis = {joint->axis.x, joint->axis.y, joint->axis.z},
                 .origin = {joint->origin.x, joint->origin.y, joint->origin.z}};
    for (uint32_t i = 0; i < POINTS; i++) {
        s.free[i] = dmi_field_distance(&study->body_field, study->points[i]) > 2.1f * study->body_field.cell;
        s.free_count += s.free[i];
    }
    return s;
}

/* Least distance from the body of the part moved to a value, over its diagonal: how far it has come off. */
static float detached(const sweeper* s, float value) {
    const placement at = place(s, value);
    float least = INFINITY;
    for (uint32_t i = 0; i < POINTS; i += 2) {
        float x[3];
        moved(s, s->study->points[i], at, x);
        least = fminf(least, dmi_field_distance(&s->study->body_field, x));
    }
    return fminf(least / s->study->diagonal, 1);
}

static void network_features(const dmi_prediction* p, const sweeper* s, int slides, float unit, float out[5]) {
    const float* axis = slides ? p->slide_axis : p->turn_axis;
    const float* limits = slides ? p->slide_limits : p->turn_limits;
    int along = dmi_dot3(axis, s->axis) >= 0;
    out[0] = 1;
    out[1] = fminf(fmaxf((along ? limits[0] : -limits[1]) / unit, -4), 4);
    out[2] = fminf(fmaxf((along ? limits[1] : -limits[0]) / unit, -4), 4);
    out[3] = p->type[DM_JOINT_REVOLUTE - 1];
    out[4] = p->type[DM_JOINT_CONTINUOUS - 1];
}

float dmi_limits_features(const dmi_study* study, const dmi_prediction* prediction, int with_drag,
                          const dm_joint* joint, float out[DMI_LIMIT_FEATURES]) {
    sweeper s = make_sweeper(study, joint);
    int slides = joint->type == DM_JOINT_PRISMATIC;
    float extent = fmaxf(extent_along(&s), 0.01f), unit = slides ? extent : 1, up[2], down[2], side[3];
    float step = slides ? 1.2f * extent / SLIDE_STEPS : TURN_STEP;
    int steps = slides ? SLIDE_STEPS : TURN_STEPS;
    reach(&s, step, steps, up);
    reach(&s, -step, steps, down);
    memset(out, 0, sizeof(float) * DMI_LIMIT_FEATURES);
    out[0] = slides ? 1.0f : 0.0f;
    out[1] = with_drag ? 1.0f : 0.0f;
    for (int k = 0; k < 2; k++) out[2 + k] = up[k] / unit, out[4 + k] = down[k] / unit;
    out[6] = slides ? 0 : fminf(roundness(&s) / study->diagonal, 0.5f);
    out[7] = extent / study->diagonal;
    out[8] = slides ? 0 : fminf(dmi_line_distance3(study->centre, s.axis, s.origin) / study->diagonal, 2);
    for (int k = 0; k < 3; k++) side[k] = study->box.high[k] - study->box.low[k];
    out[9] = side[2] / fmaxf(side[0], 1e-6f);
    out[10] = side[1] / fmaxf(side[0], 1e-6f);
    out[11] = logf(study->diagonal);
    out[12] = logf(1 + study->area_ratio) / 5;
    out[13] = (float)s.free_count / POINTS;
    static const float shares[3] = {0.15f, 0.4f, 0.8f};
    for (int k = 0; k < 3; k++) {
        out[14 + k] = detached(&s, (slides ? extent : 1.8f) * shares[k]);
        out[17 + k] = detached(&s, -(slides ? extent : 1.8f) * shares[k]);
    }
    for (int k = 0; k < 3; k++) out[20 + k] = fabsf(dmi_dot3(s.axis, study->box.axes[k]));
    if (prediction != NULL) network_features(prediction, &s, slides, unit, out + 23);
    return unit;
}

/* Mean distance of the part from the body at a value, over its diagonal. */
static float distance_at(const sweeper* s, float value) {
    const placement at = place(s, value);
    float sum = 0;
    for (uint32_t i = 0; i < POINTS; i++) {
        float x[3];
        moved(s, s->study->points[i], at, x);
        sum += fminf(dmi_field_distance(&s->study->body_field, x), s->study->diagonal);
    }
    return sum / (POINTS * s->study->diagonal);
}

void dmi_limits_face_room(const dmi_study* study, dm_joint* joint) {
    const sweeper s = make_sweeper(study, joint);
    int slides = joint->type == DM_JOINT_PRISMATIC, steps = slides ? SLIDE_STEPS : TURN_STEPS;
    float step = slides ? fmaxf(extent_along(&s), 0.01f) / SLIDE_STEPS : TURN_STEP, up[2], down[2];
    reach(&s, step, steps, up);
    reach(&s, -step, steps, down);
    /* Opening leads away from the body even where the sweep meets nothing on either side. */
    const float room = (up[0] + up[1] + down[0] + down[1]) / (step * (float)steps);
    const float away = distance_at(&s, 0.2f * step * (float)steps) - distance_at(&s, -0.2f * step * (float)steps);
    if (room + 4 * away >= 0) return;
    const float lower = joint->lower;
    joint->axis = (dm_vec3){-joint->axis.x, -joint->axis.y, -joint->axis.z};
    joint->lower = -joint->upper, joint->upper = -lower;
}

static void ask_network(const dmi_study* study, const dmi_prediction* prediction, int with_drag,
                        const dmi_limit_net* net, dm_joint* joint) {
    float features[DMI_LIMIT_FEATURES], lower, upper, free;
    if (!with_drag) dmi_limits_face_room(study, joint);
    float unit = dmi_limits_features(study, prediction, with_drag, joint, features);
    dmi_limit_net_forward(net, features, &lower, &upper, &free);
    if (joint->type == DM_JOINT_REVOLUTE && free > 0) {
        joint->type = DM_JOINT_CONTINUOUS;
        joint->lower = -HALF_TURN, joint->upper = HALF_TURN;
        return;
    }
    joint->lower = unit * lower, joint->upper = unit * upper;
}

void dmi_limits_set(const dmi_study* study, const dmi_prediction* prediction, int with_drag, const dmi_limit_net* net,
                    dm_joint* joint) {
    if (net != NULL) {
        ask_network(study, prediction, with_drag, net, joint);
        return;
    }
    sweeper s = make_sweeper(study, joint);
    if (joint->type == DM_JOINT_PRISMATIC)
        limit_slide(&s, joint);
    else
        limit_turn(&s, joint);
}
