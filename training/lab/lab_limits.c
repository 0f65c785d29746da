/* Computes the features from which limits are learnt, and the true limits. The joint is the candidate nearest to the
 * true one, as the library would find it. */
#include "lab_limits.h"

#include <math.h>
#include <string.h>

#include "evaluate_candidates.h"
#include "kinematics/limits/limits.h"
#include "math/linear3.h"

uint32_t dm_lab_limits_columns(void) {
    return DMI_LIMIT_FEATURES;
}

uint32_t dm_lab_limits_candidate_columns(void) {
    return DMI_FEATURE_COUNT;
}

/* Returns the candidate of the joint's type with the least pose error; the first candidate where there is none. */
static uint32_t nearest_candidate(const lab_evaluated_case* work) {
    const int slides = work->joint.type == DM_JOINT_PRISMATIC;
    float least = INFINITY;
    uint32_t nearest = 0;
    for (uint32_t i = 0; i < work->count; i++) {
        if ((work->candidates[i].type == DM_JOINT_PRISMATIC) != slides || !(work->pose[i] < least)) continue;
        least = work->pose[i];
        nearest = i;
    }
    return nearest;
}

static void write_case(const lab_evaluated_case* work, int with_drag, uint32_t at, void* user) {
    const dm_lab_limits* out = user;
    const uint32_t nearest = nearest_candidate(work);
    const dmi_candidate* c = &work->candidates[nearest];
    dm_joint joint = {.type = c->type,
                      .axis = {c->axis[0], c->axis[1], c->axis[2]},
                      .origin = {c->origin[0], c->origin[1], c->origin[2]}};
    if (!with_drag) dmi_limits_face_room(&work->analysis, &joint);
    const float unit = dmi_limits_features(&work->analysis, &work->ensemble.prediction, with_drag, &joint,
                                           out->features + (size_t)at * DMI_LIMIT_FEATURES);
    memcpy(out->candidate + (size_t)at * DMI_FEATURE_COUNT, work->features[nearest], sizeof work->features[nearest]);
    const dm_joint* truth = &work->joint;
    const int along = dmi_dot3(dmi_xyz(truth->axis).v, dmi_xyz(joint.axis).v) >= 0;
    out->lower[at] = (along ? truth->lower : -truth->upper) / unit;
    out->upper[at] = (along ? truth->upper : -truth->lower) / unit;
    out->free[at] = truth->type == DM_JOINT_CONTINUOUS;
    out->category[at] = (int32_t)work->made.category_id;
    out->pose[at] = work->pose[nearest];
    out->has_drag[at] = with_drag;
}

dm_result dm_lab_limits_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                              const void* prefilter, size_t prefilter_size, const dm_lab_limits* out) {
    dm_lab_limits to = *out;
    return lab_evaluate_batch(options, kinematics, kinematics_size, prefilter, prefilter_size, write_case, &to);
}
