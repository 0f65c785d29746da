/* Rival joints of a dragged part: each follows the pointer on its own; what it can't follow speaks against it. */
#include "motion/drag_rivals.h"

#include <math.h>
#include <string.h>

#define FIRST_PULL 0.01f    /* of the part's size: less tells nothing … */
#define SURE_PULL 0.1f      /* … and so much rules hopeless rivals out */
#define SPREAD 0.2f         /* of the pull: how far off the right path a hand goes */
#define TREMOR 0.004f       /* of the part's size: and how far it is off at the start */
#define FLOOR 0.01f         /* no pull makes a joint impossible */
#define OTHER_SIDE 0.15f    /* how probable it is that a range lies on the other side of rest */
#define REST_SHARE 0.05f    /* of the range: so near to rest, a limit is a stop at rest */
#define MARGIN 0.7f         /* how much more probable another joint must be, log */
#define HOPELESS 7.0f       /* log */
#define SAME_COSINE 0.9998f /* of two axes, 20 mrad */
#define SAME_DISTANCE 0.02f /* of the part's size */

static int stops_at_rest(const dm_joint* joint) {
    if (!dmi_joint_has_limits(joint)) return 0;
    const float near = REST_SHARE * (joint->upper - joint->lower);
    return fabsf(joint->lower) <= near || fabsf(joint->upper) <= near;
}

static void add(dmi_rivals* rivals, const dm_joint* joint, float probability) {
    if (rivals->count == DMI_RIVALS) return;
    rivals->list[rivals->count++] =
        (dmi_rival){.joint = *joint, .prior = logf(probability), .score = logf(probability)};
}

static float distance_of_lines(const dm_joint* a, const dm_joint* b) {
    const float gap[3] = {b->origin.x - a->origin.x, b->origin.y - a->origin.y, b->origin.z - a->origin.z};
    const float axis[3] = {a->axis.x, a->axis.y, a->axis.z};
    float along = 0, square = 0;
    for (int i = 0; i < 3; i++) along += gap[i] * axis[i];
    for (int i = 0; i < 3; i++) square += (gap[i] - along * axis[i]) * (gap[i] - along * axis[i]);
    return sqrtf(square);
}

/* So alike that no pull would tell them apart. */
static int alike(const dm_joint* a, const dm_joint* b, float size) {
    const float cosine = fabsf(a->axis.x * b->axis.x + a->axis.y * b->axis.y + a->axis.z * b->axis.z);
    if (a->type != b->type || cosine < SAME_COSINE) return 0;
    return a->type == DM_JOINT_PRISMATIC || distance_of_lines(a, b) < SAME_DISTANCE * size;
}

static int known(const dmi_rivals* rivals, const dm_joint* joint) {
    for (uint32_t i = 0; i < rivals->count; i++) {
        if (alike(&rivals->list[i].joint, joint, rivals->size)) return 1;
    }
    return 0;
}

void dmi_rivals_init(dmi_rivals* rivals, const dm_joint* joints, uint32_t count, float size) {
    *rivals = (dmi_rivals){.size = size};
    for (uint32_t i = 0; i < count && rivals->count < DMI_RIVALS; i++) {
        const float probability = fmaxf(joints[i].confidence, 1e-3f);
        if (joints[i].type == DM_JOINT_FIXED || known(rivals, &joints[i])) continue;
        add(rivals, &joints[i], probability);
        if (!stops_at_rest(&joints[i])) continue;
        dm_joint mirrored = joints[i];
        mirrored.lower = -joints[i].upper, mirrored.upper = -joints[i].lower;
        add(rivals, &mirrored, OTHER_SIDE * probability);
    }
    if (rivals->count < 2) rivals->count = 0;
}

/* Where the pull may take a rival: a stop at rest is a stop, but how far a part opens is known less well. */
static void evidence_limits(const dm_joint* joint, float* lower, float* upper) {
    *lower = -INFINITY, *upper = INFINITY;
    if (!dmi_joint_has_limits(joint)) return;
    const float range = joint->upper - joint->lower, near = REST_SHARE * range;
    *lower = fabsf(joint->lower) <= near ? joint->lower : joint->lower - range;
    *upper = fabsf(joint->upper) <= near ? joint->upper : joint->upper + range;
}

/* How far apart the ray and a point look, as a length where the grabbed point was at the start. */
static float miss(const dm_ray* ray, const float point[3], const float grab[3], dmi_projection projection) {
    const float d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    const float eye[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    float along = 0, square = 0, depth = 0;
    for (int i = 0; i < 3; i++) along += (point[i] - eye[i]) * d[i], depth += (grab[i] - eye[i]) * d[i];
    for (int i = 0; i < 3; i++) {
        const float across = point[i] - eye[i] - along * d[i];
        square += across * across;
    }
    if (projection == DMI_PARALLEL) return sqrtf(square);
    return along > 0 ? sqrtf(square) / along * fabsf(depth) : INFINITY;
}

static float likelihood(float share) {
    return expf(-0.5f * share * share) + FLOOR;
}

static void weigh(dmi_rivals* rivals, dmi_rival* rival, const float grab[3], const dm_ray* ray,
                  dmi_projection projection) {
    float lower, upper, point[3];
    evidence_limits(&rival->joint, &lower, &upper);
    rival->reach = dmi_follow_ray(&rival->joint, grab, ray, projection, rival->reach, lower, upper);
    const dm_pose pose = dmi_joint_pose(&rival->joint, rival->reach);
    dmi_pose_apply(&pose, grab, point);
    const float off = miss(ray, point, grab, projection);
    rival->score = rival->prior + logf(likelihood(off / (SPREAD * rivals->pull + TREMOR * rivals->size)));
}

/* Leaves out what the pull has ruled out; the best stays. */
static void drop_hopeless(dmi_rivals* rivals) {
    const float least = rivals->list[rivals->best].score - HOPELESS;
    uint32_t kept = 0;
    for (uint32_t i = 0; i < rivals->count; i++) {
        if (i != rivals->best && rivals->list[i].score < least) continue;
        if (i == rivals->best) rivals->best = kept;
        rivals->list[kept++] = rivals->list[i];
    }
    rivals->count = kept;
}

int dmi_rivals_weigh(dmi_rivals* rivals, const float grab_point[3], const dm_ray* ray, dmi_projection projection) {
    const float pull = miss(ray, grab_point, grab_point, projection);
    if (isfinite(pull)) rivals->pull = fmaxf(rivals->pull, pull);
    uint32_t best = rivals->best;
    for (uint32_t i = 0; i < rivals->count; i++) weigh(rivals, &rivals->list[i], grab_point, ray, projection);
    if (rivals->pull < FIRST_PULL * rivals->size) return 0;
    for (uint32_t i = 0; i < rivals->count; i++) {
        const float margin = best == rivals->best ? MARGIN : 0;
        if (rivals->list[i].score > rivals->list[best].score + margin) best = i;
    }
    const int changed = best != rivals->best;
    rivals->best = best;
    if (rivals->pull > SURE_PULL * rivals->size) drop_hopeless(rivals);
    return changed;
}

float dmi_rivals_confidence(const dmi_rivals* rivals) {
    const float best = rivals->count ? rivals->list[rivals->best].score : 0;
    float sum = 0;
    for (uint32_t i = 0; i < rivals->count; i++) sum += expf(rivals->list[i].score - best);
    return sum > 0 ? 1 / sum : 1;
}
