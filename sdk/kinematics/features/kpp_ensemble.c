/* Runs KPP-Net's members and combines them: types by their mean, geometry by the medoid. */
#include "kinematics/features/kpp_ensemble.h"

#include "math/elementary.h"
#include "math/linear3.h"

#define MOST_OFFSET 2 /* radii of the part: a line farther off differs no more; by hand */
#define LARGEST 1e6f  /* largest output: shipped weights stay below 100; squares stay far inside a float's range */

/* Shifts log-likelihoods so that they add up to a probability of one. */
static void normalize(float* scores, uint32_t count) {
    float most = -INFINITY, sum = 0;
    for (uint32_t i = 0; i < count; i++) most = dmi_max(most, scores[i]);
    for (uint32_t i = 0; i < count; i++) sum += dmi_expf(scores[i] - most);
    for (uint32_t i = 0; i < count; i++) scores[i] -= most + dmi_logf(sum);
}

/* Makes a member's input. Each takes other points of the cloud, every second one a turned frame. */
static void make_input(const dmi_cloud* cloud, uint32_t index, const dmi_drag_hint* hint, dmi_kpp_input* out) {
    dmi_kpp_input_make(cloud, index % DMI_KPP_SUBSETS, hint, out);
    if (index % 2 == 1) dmi_kpp_input_flip(out, out);
}

/* Returns how differently two members turn the part: an angle in rad plus a distance over the part's radius. */
static float turn_gap(const dmi_prediction* a, const dmi_prediction* b, float per_radius) {
    const float angle = dmi_acosf(dmi_min(fabsf(dmi_dot3(a->turn_axis, b->turn_axis)), 1));
    return angle + dmi_min(dmi_line_distance3(a->origin, b->turn_axis, b->origin) * per_radius, MOST_OFFSET);
}

static float slide_gap(const dmi_prediction* a, const dmi_prediction* b, float per_radius) {
    (void)per_radius;
    return dmi_acosf(dmi_min(fabsf(dmi_dot3(a->slide_axis, b->slide_axis)), 1));
}

/* Returns the medoid, the member that the others agree with most: the mean of two hinges would be none. */
static const dmi_prediction* medoid(const dmi_prediction members[DMI_KPP_MEMBERS], float per_radius,
                                    float (*gap)(const dmi_prediction*, const dmi_prediction*, float)) {
    const dmi_prediction* best = members;
    float least = INFINITY;
    for (int i = 0; i < DMI_KPP_MEMBERS; i++) {
        float sum = 0;
        for (int k = 0; k < DMI_KPP_MEMBERS; k++) sum += gap(&members[i], &members[k], per_radius);
        if (sum < least) least = sum, best = &members[i];
    }
    return best;
}

static bool are_usable(const float* numbers, int count) {
    for (int i = 0; i < count; i++)
        if (!(fabsf(numbers[i]) <= LARGEST)) return false;
    return true;
}

static bool is_usable(const dmi_kpp_output* o) {
    return are_usable(o->type_logits, DMI_KPP_TYPES) && are_usable(o->turn_axis, 3) && are_usable(o->slide_axis, 3) &&
           are_usable(o->origin, 3) && are_usable(o->context, DMI_KPP_CONTEXT) && are_usable(o->limits, DMI_KPP_LIMITS);
}

bool dmi_kpp_ensemble_run(const dmi_kpp_net* net, dmi_isa isa, const dmi_cloud* cloud, const dmi_drag_hint* hint,
                          void* scratch, dmi_kpp_ensemble* out_ensemble) {
    dmi_kpp_ensemble* o = out_ensemble;
    dmi_prediction members[DMI_KPP_MEMBERS];
    float type[DMI_KPP_TYPES] = {0};
    for (uint32_t i = 0; i < DMI_KPP_MEMBERS; i++) {
        make_input(cloud, i, hint, &o->input[i]);
        dmi_kpp_net_forward(net, isa, &o->input[i], scratch, &o->output[i]);
        if (!is_usable(&o->output[i])) return false;
        dmi_prediction_read(&o->input[i].frame, &o->output[i], &members[i]);
        for (int k = 0; k < DMI_KPP_TYPES; k++) type[k] += members[i].type[k] / DMI_KPP_MEMBERS;
    }
    const dmi_prediction* slide = medoid(members, o->input[0].frame.scale, slide_gap);
    o->prediction = *medoid(members, o->input[0].frame.scale, turn_gap);
    dmi_copy3(slide->slide_axis, o->prediction.slide_axis);
    memcpy(o->prediction.slide_limits, slide->slide_limits, sizeof slide->slide_limits);
    memcpy(o->prediction.type, type, sizeof type);
    return true;
}

void dmi_kpp_ensemble_score(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_ensemble* ensemble,
                            const dmi_candidate* candidates, uint32_t count, float out_scores[DMI_CANDIDATES_MAX]) {
    float one[DMI_CANDIDATES_MAX];
    memset(out_scores, 0, count * sizeof *out_scores);
    for (int i = 0; i < DMI_KPP_MEMBERS; i++) {
        dmi_kpp_candidate_scores(net, isa, &ensemble->input[i], &ensemble->output[i], candidates, count, one);
        normalize(one, count);
        for (uint32_t c = 0; c < count; c++) out_scores[c] += one[c] / DMI_KPP_MEMBERS;
    }
}

void dmi_kpp_ensemble_score_first(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_ensemble* ensemble,
                                  const dmi_candidate* candidates, uint32_t count,
                                  float out_scores[DMI_CANDIDATES_MAX]) {
    dmi_kpp_candidate_scores(net, isa, &ensemble->input[0], &ensemble->output[0], candidates, count, out_scores);
}
