/* Numbers of candidates in the network's frame (training/dragmesh_training/choice.py has the same), and the head over
 * them, some at a time. */
#include "kinematics/features/kpp_candidate_scores.h"

#include "math/linear3.h"

#define FAR 3.0f /* numbers beyond it say no more */
#define LEAST_SIDE 0.02f

/* Of the shape numbers (docs/networks.md). */
enum { BOX = 3 * DMI_KPP_DIRECTIONS, DRAG = BOX + 12 };

/* The dragged point's motion: how well it follows the drag, where it goes (forwards), how fast a turn moves it. */
static void write_drag(const dmi_candidate* c, const float shape[DMI_KPP_SHAPE], float out[5]) {
    const float *point = shape + DRAG, *drag = shape + DRAG + 3;
    if (dmi_length3(drag) == 0) {
        for (int k = 0; k < 5; k++) out[k] = 0;
        return;
    }
    float velocity[3];
    dmi_candidate_velocity(c, point, velocity);
    const float speed = dmi_length3(velocity), along = dmi_dot3(velocity, drag);
    const float unit = (along < 0 ? -1.0f : 1.0f) / dmi_max(speed, 1e-3f);
    out[0] = along * unit;
    for (int k = 0; k < 3; k++) out[1 + k] = velocity[k] * unit;
    out[4] = c->type == DM_JOINT_PRISMATIC ? 0 : dmi_min(speed, FAR);
}

/* c: in the network's frame. The same for an axis and its opposite. */
static void write_numbers(const dmi_candidate* c, const float shape[DMI_KPP_SHAPE],
                          float out[DMI_KPP_CANDIDATE_NUMBERS]) {
    const float *a = c->axis, *centre = shape + BOX, *half = shape + BOX + 3;
    const int slides = c->type == DM_JOINT_PRISMATIC;
    float foot[3] = {0, 0, 0};
    if (!slides) {
        dmi_sub3(c->origin, centre, foot);
        dmi_reject3(foot, a);
    }
    out[0] = (float)slides;
    for (int k = 0; k < 3; k++) {
        const float in_box = dmi_max(-FAR, dmi_min(FAR, foot[k] / (half[k] + LEAST_SIDE)));
        out[1 + k] = a[k] * a[k];
        out[4 + k] = a[k] * a[(k + 1) % 3];
        out[7 + k] = foot[k];
        out[10 + k] = in_box;
        out[13 + k] = fabsf(in_box);
    }
    write_drag(c, shape, out + 16);
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
    _Alignas(64) float numbers[DMI_KPP_SCORE_BATCH][DMI_KPP_CANDIDATE_NUMBERS];
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
