/* Describes candidates in KPP-Net's frame, as training/dragmesh_training/choice.py does, and runs the candidate-scoring
 * head over them, a batch at a time. */
#include "kinematics/features/kpp_candidate_scores.h"

#include "math/linear3.h"
#include "nn/kernels.h"

#define FAR 3.0f          /* bound of offsets and speeds, in the part's radius; by hand */
#define LEAST_SIDE 0.02f  /* least side of the part's box, in its radius; by hand */
#define LEAST_SPEED 1e-3f /* avoids a division by 0 */

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
