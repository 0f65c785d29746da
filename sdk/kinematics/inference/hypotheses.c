/* Signs and re-ranks hypotheses by a drag, in closed form. */
#include "kinematics/inference/hypotheses.h"

#include "math/elementary.h"
#include "math/linear3.h"

#define DRAG_SPREAD 0.22f   /* rad: a hand is off by 5 to 10 degrees, and the part may have moved already; by hand */
#define FLOOR 0.02f         /* least likelihood: no drag rules a hypothesis out; by hand */
#define AGAINST_STOP 0.35f  /* factor of a joint that has no room along the drag; by hand */
#define LEAST_WEIGHT 1e-6f  /* keeps a hypothesis of no confidence in the order it had */
#define LEAST_SPEED 1e-6f   /* object sizes a radian or a unit of way; a slower point does not move */
#define LEAST_LENGTH 1e-20f /* shortest drag, object sizes */

static void velocity_at(const dm_joint* joint, const float point[3], float out[3]) {
    if (joint->type == DM_JOINT_FIXED || joint->type == DM_JOINT_UNKNOWN) {
        memset(out, 0, 3 * sizeof *out);
        return;
    }
    dmi_joint_velocity(joint, 0, point, out);
}

bool dmi_joint_orient(dm_joint* joint, const dmi_drag_hint* hint) {
    float v[3];
    velocity_at(joint, hint->point, v);
    const bool against = dmi_dot3(v, hint->vector) < 0;
    if (against) dmi_joint_reverse(joint);
    return against;
}

/* Returns how well an oriented joint explains the drag, by the direction of its motion and by its room to go there. */
static float likelihood(const dm_joint* joint, const dmi_drag_hint* hint) {
    float v[3], length = dmi_length3(hint->vector);
    velocity_at(joint, hint->point, v);
    float speed = dmi_length3(v);
    if (speed < LEAST_SPEED || length < LEAST_LENGTH) return FLOOR;
    float cosine = dmi_dot3(v, hint->vector) / (speed * length), angle = dmi_acosf(dmi_fminf(dmi_fmaxf(cosine, -1), 1));
    float spread = angle / DRAG_SPREAD;
    float fit = dmi_expf(-0.5f * spread * spread) + FLOOR;
    return joint->upper <= 0 && joint->lower < 0 ? fit * AGAINST_STOP : fit;
}

static int turning(const dm_joint* joint) {
    return dmi_joint_turns(joint->type);
}

void dmi_hypotheses_rerank(const dmi_hypotheses* hypotheses, const dmi_drag_hint* hint, dmi_hypotheses* out) {
    float weight[DM_MAX_HYPOTHESES], before = 0, after = 0, turns = 0;
    dmi_hypotheses result = {.count = hypotheses->count};
    for (uint32_t i = 0; i < hypotheses->count; i++) {
        dm_joint joint = hypotheses->joints[i];
        dmi_free_range range = hypotheses->free_range[i];
        if (dmi_joint_orient(&joint, hint)) range = dmi_reversed_range(range);
        float w = (joint.joint_confidence + LEAST_WEIGHT) * likelihood(&joint, hint);
        before += joint.joint_confidence + LEAST_WEIGHT, after += w;
        turns += turning(&joint) ? w : 0;
        uint32_t at = i;
        for (; at > 0 && weight[at - 1] < w; at--) {
            weight[at] = weight[at - 1], result.joints[at] = result.joints[at - 1];
            result.free_range[at] = result.free_range[at - 1];
        }
        weight[at] = w, result.joints[at] = joint, result.free_range[at] = range;
    }
    for (uint32_t i = 0; i < result.count; i++) {
        dm_joint* joint = &result.joints[i];
        joint->joint_confidence = weight[i] / after * dmi_fminf(before, 1);
        joint->type_confidence = (turning(joint) ? turns : after - turns) / after;
    }
    *out = result;
}
