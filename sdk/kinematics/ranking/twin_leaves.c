/* Weighs turns of a leaf by where their axis passes its twin, or a leaf in the same frame: at the seam, at the far
 * side, or at an end. Weighs slides by whether the body stands in their way. */
#include "kinematics/ranking/twin_leaves.h"

#include <float.h>

#include "math/elementary.h"
#include "math/linear3.h"

#define ALONG 0.9f /* cosine between an axis and the side of the box that it runs along; by hand */
#define EDGE 0.6f  /* half sides from the middle of the box, from which an axis lies at an edge; by hand */

/* Log-likelihoods, fitted by conditional logit on generated leaves of the retired category bare_leaves, and rounded. */
#define OUTSIDE 5.0f    /* bonus of turns along the seam, at the side away from it */
#define AT_SEAM (-4.0f) /* bonus of turns along the seam, at the seam */
#define AT_END 3.0f     /* bonus of turns across the seam, at one of its ends: flaps side by side */

/* Log-likelihood of turns at the seam with a leaf in the same frame: such leaves hang on the frame. By hand: on
 * generated objects any value from -0.5 to -1.5 is as good (docs/research/trials_joints.md). */
#define AT_LEAF (-1.0f)
#define ACROSS 0.3f /* cosine between an axis and each of two others, below which it runs along the third; by hand */

#define BLOCKED 0.08f /* sides: a slide with less clearance than this both ways is blocked; by hand */
/* Log-likelihood of blocked slides, by hand. The ranker has seen them, since displaced parts of the generator's messy
 * objects overlap the body; a part that a player pulls cannot go there. */
#define CANNOT_SLIDE (-1.5f)

/* The sides of the part's box: across the seam, and of the other two the longer and the shorter. */
typedef struct leaf_sides {
    int across, along, thin;
    float sign; /* sign of the side `across` that leads to the twin */
} leaf_sides;

static leaf_sides sides_of(const dmi_part_analysis* a) {
    leaf_sides sides = {0};
    float most = -1;
    for (int k = 0; k < 3; k++) {
        const float cosine = dmi_dot3(a->box.axes[k], a->twin_way);
        if (fabsf(cosine) <= most) continue;
        most = fabsf(cosine);
        sides.across = k, sides.sign = cosine < 0 ? -1.0f : 1.0f;
    }
    sides.along = sides.across == 0 ? 1 : 0; /* the box's longest side comes first */
    sides.thin = sides.across == 2 ? 1 : 2;
    return sides;
}

static float log_likelihood_beside_twin(const dmi_part_analysis* a, const leaf_sides* sides, const dmi_candidate* c) {
    if (c->type == DM_JOINT_PRISMATIC) return 0;
    if (fabsf(dmi_dot3(c->axis, a->box.axes[sides->along])) > ALONG) {
        const float place = sides->sign * dmi_box_place(&a->box, sides->across, c->origin);
        return place < -EDGE ? OUTSIDE : place > EDGE ? AT_SEAM : 0;
    }
    const bool crosses = fabsf(dmi_dot3(c->axis, a->box.axes[sides->across])) > ALONG;
    return crosses && fabsf(dmi_box_place(&a->box, sides->along, c->origin)) > EDGE ? AT_END : 0;
}

static float log_likelihood_beside_leaf(const dmi_part_analysis* a, const dmi_candidate* c) {
    if (c->type == DM_JOINT_PRISMATIC || fabsf(dmi_dot3(c->axis, a->box.axes[2])) > ACROSS) return 0;
    for (int axis = 0; axis < 2; axis++) {
        const bool crosses = fabsf(dmi_dot3(c->axis, a->box.axes[axis])) > ACROSS;
        if (!crosses && a->leaf_side[axis] * dmi_box_place(&a->box, axis, c->origin) > EDGE) return AT_LEAF;
    }
    return 0;
}

uint32_t dmi_twin_add_candidates(const dmi_part_analysis* analysis, const dmi_drag_hint* hint,
                                 dmi_candidate* candidates, uint32_t count) {
    if (!analysis->has_twin) return count;
    const dmi_box* box = &analysis->box;
    const leaf_sides sides = sides_of(analysis);
    const float outside = sides.sign < 0 ? box->high[sides.across] : box->low[sides.across];
    for (int i = 0; i < 3; i++) {
        const float depth = box->low[sides.thin] + 0.5f * (float)i * (box->high[sides.thin] - box->low[sides.thin]);
        float point[3] = {0};
        dmi_madd3(point, outside, box->axes[sides.across], point);
        dmi_madd3(point, depth, box->axes[sides.thin], point);
        dmi_madd3(point, (box->low[sides.along] + box->high[sides.along]) / 2, box->axes[sides.along], point);
        count = dmi_candidates_add_through(analysis, hint, point, &box->axes[sides.along], 1, candidates, count);
    }
    return count;
}

static float log_likelihood_of_slide(const dmi_part_analysis* a, const dmi_candidate* c) {
    if (c->type != DM_JOINT_PRISMATIC) return 0;
    for (int k = 0; k < 3; k++) {
        const bool along = fabsf(dmi_dot3(c->axis, a->box.axes[k])) > ALONG;
        if (along && dmi_max(a->clearance[k][0], a->clearance[k][1]) < BLOCKED) return CANNOT_SLIDE;
    }
    return 0;
}

void dmi_leaves_weigh(const dmi_part_analysis* analysis, const dmi_candidate* candidates, uint32_t count,
                      float* probability) {
    const leaf_sides sides = sides_of(analysis);
    float sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        float log_likelihood = log_likelihood_of_slide(analysis, &candidates[i]);
        log_likelihood += analysis->has_twin ? log_likelihood_beside_twin(analysis, &sides, &candidates[i])
                                             : log_likelihood_beside_leaf(analysis, &candidates[i]);
        sum += probability[i] *= dmi_expf(log_likelihood);
    }
    for (uint32_t i = 0; i < count; i++) probability[i] /= dmi_max(sum, FLT_MIN);
}
