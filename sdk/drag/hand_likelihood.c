/* Three hands may have made a pull. One follows the part, and misses the grabbed point by little. One goes straight to
 * where the part should end, along a chord of a turn's circle. One does not know the way: it goes straight, roughly
 * along the first motion of the point that it holds. The likelihood of a pull is the sum over the three.
 *
 * All numbers are fitted to scripted drags of generated objects (docs/research/trials_drag.md), unless their comment
 * says otherwise. */
#include "drag/joint_hypothesis.h"

#include <math.h>

#include "math/elementary.h"
#include "math/linear3.h"

#define NOISE_PER_LENGTH 0.01f /* expected residual on the right joint, share of the pull's length */
#define NOISE_FLOOR 0.0015f    /* expected residual at the start, share of the part's size */
#define TAIL_EXPONENT 3.5f     /* exponent of the power law that residuals follow */
/* Log prior of a pull along a path that is straight, by a hand that knows it: some slide, and some turn about a far
 * axis, lies along a straight pull by chance. It fades where pull or path bends. Fitted with the knowing hands of the
 * development set in view. */
#define STRAIGHT_PATH_LOG_PRIOR (-0.8f)
/* Log prior by which a slide along the up direction is less likely still. A hand that lifts what it holds goes straight
 * up the screen, and so does every such slide. */
#define LIFT_LOG_PRIOR (-1.2f)
#define CHORD_LOG_PRIOR (-2.5f)        /* log prior of a hand that goes straight to where a turn should end */
#define ROUGH_TURN_LOG_PRIOR (-2.67f)  /* log prior of a hand that goes roughly along a turn's first motion */
#define ROUGH_SLIDE_LOG_PRIOR (-3.0f)  /* the same of a slide */
#define ROUGH_ANGLE 0.66f              /* rad between such a pull and the first motion, as seen: 38 degrees */
#define ASTRAY_LOG_LIKELIHOOD (-13.2f) /* log likelihood of such a hand that pulls at any angle */
/* Log likelihood of such a hand that does not go straight, because it wavered at first. */
#define WAVERING_LOG_LIKELIHOOD (-6.0f)
/* Log likelihood of such a hand that pulls away from the side on which the range lies. */
#define AGAINST_LOG_LIKELIHOOD (-0.59f)
#define INTO_BODY_LOG_LIKELIHOOD (-4.0f) /* the same where the part would go into its body; by hand */
#define SAGITTA 0.125f                   /* sagitta of an arc, over its squared chord and its curvature; geometry */
#define LEAST_SEEN 0.18f    /* share of the first motion that is seen; people do not pull along what they cannot see */
#define STRAIGHT_BEND 0.03f /* largest bend of a straight pull, share of its length; by hand */
#define NEGLIGIBLE_LOG_RATIO 8.0f /* a term smaller than the other by exp(8) is left out; by hand */

float dmi_expected_residual(const dmi_grasp* grasp) {
    return NOISE_PER_LENGTH * grasp->pull.length + NOISE_FLOOR * grasp->size;
}

/* Returns the log of a power law of the largest residual, relative to the expected one. The largest counts, because a
 * slide crosses the arc of a hinge and matches it there alone. It is relative to the pull so far, so that an early
 * error fades. The heavy tail stands for a hand of unknown skill: where no joint fits well, a near one is little better
 * than a farther one. */
static float residual_log_likelihood(const dmi_grasp* grasp, float residual) {
    return -TAIL_EXPONENT * dmi_logf(1 + residual / dmi_expected_residual(grasp));
}

void dmi_grasp_add(dmi_grasp* grasp, const dm_ray* ray) {
    dmi_pull_add(&grasp->pull, ray);
    grasp->straightness = residual_log_likelihood(grasp, grasp->pull.bend);
    dmi_copy3(grasp->pull.pointer.way, grasp->way);
    dmi_normalize3(grasp->way);
}

bool dmi_grasp_is_straight(const dmi_grasp* grasp) {
    return grasp->pull.bend <= STRAIGHT_BEND * grasp->pull.length + NOISE_FLOOR * grasp->size;
}

/* Returns the log of a sum whose terms are given as logs. */
static float log_sum(float a, float b) {
    const float more = dmi_fmaxf(a, b), apart = fabsf(a - b);
    return apart < NEGLIGIBLE_LOG_RATIO ? more + dmi_logf(1 + dmi_expf(-apart)) : more;
}

/* Returns how straight the joint's path is along the pull: 1 for a slide, towards 0 where its sagitta exceeds what the
 * hand misses. */
static float straightness_of_path(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis) {
    const float length = grasp->pull.length, expected = dmi_expected_residual(grasp);
    return expected / (expected + SAGITTA * length * length * hypothesis->curvature);
}

bool dmi_joint_hypothesis_is_end_on(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis) {
    const dmi_pull* pull = &grasp->pull;
    return hypothesis->grabbed && dmi_is_seen_end_on(&hypothesis->joint, pull->grab, pull->pointer.sight);
}

float dmi_followed_log_likelihood(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis, float residual) {
    if (dmi_joint_hypothesis_is_end_on(grasp, hypothesis)) return 0;
    const float followed = residual_log_likelihood(grasp, residual);
    if (grasp->was_open) return followed;
    const float by_chance = STRAIGHT_PATH_LOG_PRIOR + (hypothesis->upright ? LIFT_LOG_PRIOR : 0);
    return followed + by_chance * straightness_of_path(grasp, hypothesis) / (1 - grasp->straightness);
}

/* Returns the log likelihood of the direction in which a hand pulls that goes roughly along the first motion. It is
 * flat near that motion and falls off beyond ROUGH_ANGLE: the fourth power of the angle, of which 2 - 2 cos is the
 * square for small ones. */
static float direction_log_likelihood(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis) {
    const float* motion = hypothesis->first_motion;
    const float hidden = dmi_dot3(motion, grasp->pull.pointer.sight), seen = 1 - hidden * hidden;
    if (grasp->was_open || !(seen > LEAST_SEEN * LEAST_SEEN)) return -INFINITY;
    const float cosine = dmi_dot3(motion, grasp->way) / sqrtf(seen);
    const float square = 2 * dmi_fmaxf(1 - fabsf(cosine), 0) / (ROUGH_ANGLE * ROUGH_ANGLE);
    const float along = dmi_fmaxf(-0.5f * square * square, ASTRAY_LOG_LIKELIHOOD);
    if (!(hypothesis->side * cosine < 0)) return along;
    return along + (hypothesis->other_side_blocked ? INTO_BODY_LOG_LIKELIHOOD : AGAINST_LOG_LIKELIHOOD);
}

float dmi_joint_hypothesis_log_likelihood(const dmi_grasp* grasp, const dmi_joint_hypothesis* hypothesis,
                                          float residual) {
    const bool turns = dmi_joint_turns(hypothesis->joint.type);
    const float followed = dmi_followed_log_likelihood(grasp, hypothesis, residual);
    const float steadiness = dmi_fmaxf(grasp->straightness, WAVERING_LOG_LIKELIHOOD);
    const float rough = steadiness + (turns ? ROUGH_TURN_LOG_PRIOR : ROUGH_SLIDE_LOG_PRIOR) +
                        direction_log_likelihood(grasp, hypothesis);
    float sum = log_sum(followed, rough);
    const float chord = grasp->straightness + CHORD_LOG_PRIOR;
    if (turns && chord > sum - NEGLIGIBLE_LOG_RATIO && dmi_pull_is_on_chord(&grasp->pull, &hypothesis->joint))
        sum = log_sum(sum, chord);
    return sum;
}
