/* Runs KPP-Net's members and combines them: types by their mean, geometry by the medoid. Candidates are described in
 * the network's frame, as training/dragmesh_training/choice.py does, and scored a batch at a time. */
#include "kinematics/features/kpp_ensemble.h"

#include "math/elementary.h"
#include "math/linear3.h"
#include "nn/kernels.h"

#define MOST_OFFSET 2     /* radii of the part: a line farther off differs no more; by hand */
#define LARGEST 1e6f      /* largest output: shipped weights stay below 100; squares stay far inside a float's range */
#define FAR 3.0f          /* bound of offsets and speeds, in the part's radius; by hand */
#define LEAST_SIDE 0.02f  /* least side of the part's box, in its radius; by hand */
#define LEAST_SPEED 1e-3f /* avoids a division by 0 */

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

/* ---- scores of candidates ---- */

/* Where the shape numbers have the part's box and the drag (docs/networks.md). */
enum { BOX = 3 * DMI_KPP_DIRECTIONS, DRAG = BOX + 12 };

/* Where the numbers of a candidate lie. */
enum {
    SLIDES = 0,
    AXIS_SQUARES = 1,  /* 3 */
    AXIS_PRODUCTS = 4, /* 3 */
    FOOT = 7,          /* 3: of the perpendicular from the box's centre */
    IN_BOX = 10,       /* 3: the same in half sides */
    IN_BOX_SIZE = 13,  /* 3: without sign */
    MOTION = 16,
    DRAG_NUMBERS = 5
};
/* Features of the dragged point's motion: */
enum { FOLLOWED = 0, DIRECTION = 1, SPEED = 4 };
_Static_assert(MOTION + DRAG_NUMBERS == DMI_KPP_CANDIDATE_NUMBERS, "numbers of a candidate");

/* Writes the dragged point's motion: how well it follows the drag, its direction, how fast a turn moves it. */
static void write_drag(const dmi_candidate* c, const float shape[DMI_KPP_SHAPE], float out[DRAG_NUMBERS]) {
    const float *point = shape + DRAG, *drag = shape + DRAG + 3;
    if (dmi_length3(drag) == 0) {
        for (int k = 0; k < DRAG_NUMBERS; k++) out[k] = 0;
        return;
    }
    float velocity[3];
    dmi_candidate_velocity(c, point, velocity);
    const float speed = dmi_length3(velocity), along = dmi_dot3(velocity, drag);
    const float unit = (along < 0 ? -1.0f : 1.0f) / dmi_max(speed, LEAST_SPEED);
    out[FOLLOWED] = along * unit;
    for (int k = 0; k < 3; k++) out[DIRECTION + k] = velocity[k] * unit;
    out[SPEED] = c->type == DM_JOINT_PRISMATIC ? 0 : dmi_min(speed, FAR);
}

/* c: in the network's frame. Writes the same for an axis and its opposite. */
static void write_numbers(const dmi_candidate* c, const float shape[DMI_KPP_SHAPE],
                          float out[DMI_KPP_CANDIDATE_NUMBERS]) {
    const float *a = c->axis, *centre = shape + BOX, *half = shape + BOX + 3;
    const int slides = c->type == DM_JOINT_PRISMATIC;
    float foot[3] = {0, 0, 0};
    if (!slides) {
        dmi_sub3(c->origin, centre, foot);
        dmi_reject3(foot, a);
    }
    out[SLIDES] = (float)slides;
    for (int k = 0; k < 3; k++) {
        const float in_box = dmi_max(-FAR, dmi_min(FAR, foot[k] / (half[k] + LEAST_SIDE)));
        out[AXIS_SQUARES + k] = a[k] * a[k];
        out[AXIS_PRODUCTS + k] = a[k] * a[(k + 1) % 3];
        out[FOOT + k] = foot[k];
        out[IN_BOX + k] = in_box;
        out[IN_BOX_SIZE + k] = fabsf(in_box);
    }
    write_drag(c, shape, out + MOTION);
}

static dmi_candidate in_frame(const dmi_candidate* c, const dmi_kpp_frame* frame) {
    dmi_candidate inner = *c;
    float from[3];
    dmi_sub3(c->origin, frame->origin, from);
    dmi_kpp_frame_rotate(frame, c->axis, inner.axis);
    dmi_kpp_frame_rotate(frame, from, inner.origin);
    for (int k = 0; k < 3; k++) inner.origin[k] *= frame->scale;
    return inner;
}

void dmi_kpp_candidate_scores(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_input* input,
                              const dmi_kpp_output* output, const dmi_candidate* candidates, uint32_t count,
                              float* out_scores) {
    _Alignas(DMI_ALIGNMENT) float numbers[DMI_KPP_SCORE_BATCH][DMI_KPP_CANDIDATE_NUMBERS];
    for (uint32_t first = 0; first < count; first += DMI_KPP_SCORE_BATCH) {
        const uint32_t rows = count - first < DMI_KPP_SCORE_BATCH ? count - first : DMI_KPP_SCORE_BATCH;
        for (uint32_t i = 0; i < rows; i++) {
            const dmi_candidate inner = in_frame(&candidates[first + i], &input->frame);
            write_numbers(&inner, input->shape, numbers[i]);
        }
        dmi_kpp_net_score(net, isa, output, (const float(*)[DMI_KPP_CANDIDATE_NUMBERS])numbers, rows,
                          out_scores + first);
    }
}

/* Shifts log-likelihoods so that they add up to a probability of one. */
static void normalize(float* scores, uint32_t count) {
    float most = -INFINITY, sum = 0;
    for (uint32_t i = 0; i < count; i++) most = dmi_max(most, scores[i]);
    for (uint32_t i = 0; i < count; i++) sum += dmi_expf(scores[i] - most);
    for (uint32_t i = 0; i < count; i++) scores[i] -= most + dmi_logf(sum);
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
