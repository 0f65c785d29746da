/* Fills the rows of candidate features, group by group. */
#include "kinematics/features/candidate_features.h"

#include "kinematics/features/axis_hardware.h"
#include "kinematics/features/feature_groups.h"
#include "kinematics/features/symmetry_features.h"

void dmi_candidate_features_make(const dmi_part_analysis* analysis, const dmi_drag_hint* hint,
                                 const dmi_prediction* prediction, const float* scores, const dmi_candidate* candidates,
                                 uint32_t count, float (*out)[DMI_FEATURE_COUNT]) {
    dmi_feature_context context = {.analysis = analysis, .hint = hint};
    dmi_symmetry symmetry;
    dmi_cheap_features_begin(analysis, hint, prediction, &context.cheap);
    dmi_sweep_features_begin(&context);
    dmi_symmetry_begin(analysis, &symmetry);
    for (uint32_t i = 0; i < count; i++) {
        dmi_cheap_features_row(&context.cheap, &candidates[i], out[i]);
        dmi_slip_features(&context, &candidates[i], out[i]);
        dmi_sweep_features(&context, &candidates[i], out[i]);
        dmi_place_features(&context, &candidates[i], out[i]);
        dmi_symmetry_features(&symmetry, &candidates[i], out[i]);
        dmi_axis_hardware_features(analysis, &candidates[i], out[i]);
    }
    dmi_cheap_features_kpp_scores(scores, count, out);
    dmi_relative_features(candidates, count, out);
}
