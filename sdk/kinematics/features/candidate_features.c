/* Fills the rows of candidate features, group by group. Features that compare a candidate with the others of the part
 * come last: whether this part slides better than it turns shows only between candidates. */
#include "kinematics/features/candidate_features.h"

#include "kinematics/features/feature_groups.h"
#include "math/linear3.h"

#define HIGHEST_COST 1 /* costs run from about 0 to 1 */

/* A cost, and where it stands above the least of the candidate's own type and of the other type. */
static const struct {
    int cost, same_type, other_type;
} compared[] = {
#define COMPARED(name)                                                                                                 \
    { DMI_FEATURE_##name, DMI_FEATURE_SAME_TYPE_##name, DMI_FEATURE_OTHER_TYPE_##name }
    COMPARED(SURFACE_SLIP),
    COMPARED(TOUCHING_PART_NORMAL_SPEED),
    COMPARED(NEAREST_PART_NORMAL_SPEED),
    COMPARED(NEAREST_BODY_NORMAL_SPEED),
    COMPARED(NEAREST_SLIP),
    COMPARED(HIT_SHORT_ALONG),
    COMPARED(HIT_MIDDLE_ALONG),
    COMPARED(HIT_LONG_ALONG),
    COMPARED(DETACHED_MIDDLE_ALONG),
    COMPARED(FRACTION_TURN_DISTANCE),
    COMPARED(ALONG_BODY_MEAN),
    COMPARED(DRAG_ANGLE),
#undef COMPARED
};

/* Returns whether a candidate counts for the least cost. Candidates whose direction was made from the drag follow the
 * drag by construction. They do not count for DRAG_ANGLE, so that this cost is compared with the shape's directions.
 */
static bool counts(const dmi_candidate* candidate, int column) {
    return column != DMI_FEATURE_DRAG_ANGLE || (candidate->direction_families & DMI_DIRECTION_DRAG) == 0;
}

static void compare_costs(const dmi_candidate* candidates, uint32_t count, float (*rows)[DMI_FEATURE_COUNT]) {
    for (size_t k = 0; k < sizeof compared / sizeof *compared; k++) {
        const int cost = compared[k].cost;
        float best[2] = {HIGHEST_COST, HIGHEST_COST}; /* least costs of turns and of slides */
        for (uint32_t i = 0; i < count; i++) {
            const int type = rows[i][DMI_FEATURE_PRISMATIC] > 0;
            if (counts(&candidates[i], cost)) best[type] = dmi_min(best[type], rows[i][cost]);
        }
        for (uint32_t i = 0; i < count; i++) {
            const int type = rows[i][DMI_FEATURE_PRISMATIC] > 0;
            rows[i][compared[k].same_type] = rows[i][cost] - best[type];
            rows[i][compared[k].other_type] = rows[i][cost] - best[!type];
        }
    }
}

/* out = column - the least of all candidates. */
static void above_least(float (*rows)[DMI_FEATURE_COUNT], uint32_t count, int column, int out) {
    float least = HIGHEST_COST;
    for (uint32_t i = 0; i < count; i++) least = dmi_min(least, rows[i][column]);
    for (uint32_t i = 0; i < count; i++) rows[i][out] = rows[i][column] - least;
}

/* out = the most of any turn - (first + second). */
static void below_most(const dmi_candidate* candidates, uint32_t count, float (*rows)[DMI_FEATURE_COUNT], int first,
                       int second, int out) {
    float most = 0;
    for (uint32_t i = 0; i < count; i++)
        if (!dmi_candidate_slides(&candidates[i])) most = dmi_max(most, rows[i][first] + rows[i][second]);
    for (uint32_t i = 0; i < count; i++) rows[i][out] = most - (rows[i][first] + rows[i][second]);
}

static void compare_candidates(const dmi_candidate* candidates, uint32_t count, float (*rows)[DMI_FEATURE_COUNT]) {
    compare_costs(candidates, count, rows);
    above_least(rows, count, DMI_FEATURE_MIRROR_AXIS_PART, DMI_FEATURE_MIRROR_AXIS_PART_ABOVE_LEAST);
    above_least(rows, count, DMI_FEATURE_MIRROR_AXIS_BODY, DMI_FEATURE_MIRROR_AXIS_BODY_ABOVE_LEAST);
    below_most(candidates, count, rows, DMI_FEATURE_ROUND_PART_COUNT, DMI_FEATURE_CENTRED_PART_COUNT,
               DMI_FEATURE_HARDWARE_PART_BELOW_MOST);
    below_most(candidates, count, rows, DMI_FEATURE_ROUND_BODY_COUNT, DMI_FEATURE_CENTRED_BODY_COUNT,
               DMI_FEATURE_HARDWARE_BODY_BELOW_MOST);
}

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
    compare_candidates(candidates, count, out);
}
