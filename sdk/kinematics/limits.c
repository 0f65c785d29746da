/* Limits from a sweep of the part's samples through the body's distance grid. */
#include "kinematics/limits.h"

#include "kinematics/linear3.h"

#define POINTS 192
#define TURN_STEP 0.05f
#define HALF_TURN 3.14159265f
#define TURN_STEPS 63 /* to half a turn */
#define SLIDE_STEPS 48
#define STOPPED 0.03f /* share of the free points that must meet the body */
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

/* Largest value, in steps, that the part reaches in the direction of `step`. */
static float reach(const sweeper* s, float step, int steps) {
    for (int i = 1; i <= steps; i++)
        if (blocked(s, step * (float)i) > STOPPED) return step * (float)(i - 1);
    return step * (float)steps;
}

static float extent_along(const sweeper* s) {
    const dmi_study* study = s->study;
    float low, high;
    dmi_shape_limits((const float(*)[3])study->extremes, study->extreme_count, &s->axis, 1, &low, &high);
    return high - low;
}

/* The part looks the same at several angles: a knob, a wheel, a cap. */
static int is_round(const sweeper* s) {
    placement at[3];
    float mean = 0;
    for (int i = 0; i < 3; i++) at[i] = place(s, 0.4f + 2.1f * (float)i);
    for (uint32_t i = 0; i < POINTS; i++) {
        float x[3];
        moved(s, s->study->points[i], at[i % 3], x);
        mean += dmi_field_distance(&s->study->part_field, x) / POINTS;
    }
    return mean < ROUND * s->study->diagonal + 0.5f * s->study->part_field.cell;
}

static void limit_turn(const sweeper* s, dm_joint* joint) {
    float up = reach(s, TURN_STEP, TURN_STEPS), down = reach(s, -TURN_STEP, TURN_STEPS);
    if (up >= 3.1f && down <= -3.1f && joint->type == DM_JOINT_REVOLUTE && is_round(s)) {
        joint->type = DM_JOINT_CONTINUOUS;
        joint->lower = -HALF_TURN, joint->upper = HALF_TURN;
        return;
    }
    /* It rests closed: the side with more room is the one it opens to. */
    joint->upper = up >= -down ? fminf(up, USUAL_OPENING) : 0;
    joint->lower = up >= -down ? 0 : fmaxf(down, -USUAL_OPENING);
    if (joint->upper - joint->lower < TURN_STEP) joint->upper = USUAL_OPENING, joint->lower = 0;
}

static void limit_slide(const sweeper* s, dm_joint* joint) {
    float most = USUAL_TRAVEL * fmaxf(extent_along(s), 0.01f);
    float step = most / SLIDE_STEPS, up = reach(s, step, SLIDE_STEPS), down = reach(s, -step, SLIDE_STEPS);
    joint->upper = up >= -down ? up : 0;
    joint->lower = up >= -down ? 0 : down;
    if (joint->upper - joint->lower < step) joint->upper = most, joint->lower = 0;
}

void dmi_limits_set(const dmi_study* study, const dmi_prediction* prediction, dm_joint* joint) {
    (void)prediction;
    sweeper s = {.study = study,
                 .joint = joint,
                 .axis = {joint->axis.x, joint->axis.y, joint->axis.z},
                 .origin = {joint->origin.x, joint->origin.y, joint->origin.z}};
    for (uint32_t i = 0; i < POINTS; i++) {
        s.free[i] = dmi_field_distance(&study->body_field, study->points[i]) > 2.1f * study->body_field.cell;
        s.free_count += s.free[i];
    }
    if (joint->type == DM_JOINT_PRISMATIC)
        limit_slide(&s, joint);
    else
        limit_turn(&s, joint);
}
