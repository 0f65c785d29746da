/* What KPP-Net sees: a cloud in a frame made of the drag and the part, grouped into tokens (docs/networks.md).
 * Training builds its batches with this very code. */
#ifndef DMI_KPP_KPP_INPUT_H
#define DMI_KPP_KPP_INPUT_H

#include "kinematics/kpp/farthest_point_sampling.h"
#include "math/drag_hint.h"
#include "math/linear3.h"
#include "mesh/cloud.h"

#define DMI_KPP_GROUP DMI_FPS_GROUP /* points a group */
#define DMI_KPP_GLOBAL_GROUPS 48
#define DMI_KPP_LOCAL_GROUPS 24
#define DMI_KPP_QUARTERS 4 /* of a cloud: each fills the groups with points of its own */
/* xyz 3, mask 1, drag point 3, drag vector 3 (the paper's 10), offset in group 3, normal 3, nearness of the other side
 * 1
 */
#define DMI_KPP_CHANNELS 17
/* The part's own, the body's, the part's principal ones: what a joint may follow exactly. */
#define DMI_KPP_DIRECTIONS 9
/* Of the whole: directions, boxes of the part and of the object (centre, half sides), drag point, drag vector, size of
 * the part, how well the directions of part, body and frame fit, where the part touches (mean, spread, share). */
#define DMI_KPP_SHAPE (3 * DMI_KPP_DIRECTIONS + 6 + 6 + 3 + 3 + 1 + 3 + 7)

/* inner = (rotation (x - origin)) * scale, rows of rotation are its axes. */
typedef struct dmi_kpp_frame {
    float rotation[9];
    float origin[3];
    float scale;
} dmi_kpp_frame;

/* A direction in the frame. */
static inline void dmi_kpp_turn_in(const dmi_kpp_frame* frame, const float v[3], float out[3]) {
    for (int r = 0; r < 3; r++) out[r] = dmi_dot3(frame->rotation + 3 * r, v);
}

typedef struct dmi_kpp_input {
    dmi_kpp_frame frame;
    float global_points[DMI_KPP_GLOBAL_GROUPS][DMI_KPP_GROUP][DMI_KPP_CHANNELS];
    float global_centres[DMI_KPP_GLOBAL_GROUPS][3];
    float local_points[DMI_KPP_LOCAL_GROUPS][DMI_KPP_GROUP][DMI_KPP_CHANNELS];
    float local_centres[DMI_KPP_LOCAL_GROUPS][3];
    float shape[DMI_KPP_SHAPE];
} dmi_kpp_input;

/* quarter: which of the cloud's points are looked at, below DMI_KPP_QUARTERS; the network is trained on the first. hint
 * NULL: without a drag. Deterministic; allocates nothing. */
void dmi_kpp_input_make(const dmi_cloud* cloud, uint32_t quarter, const dmi_drag_hint* hint, dmi_kpp_input* out_input);
/* The same in a frame whose second and third axis point the other way; out_input may be input. */
void dmi_kpp_input_turn(const dmi_kpp_input* input, dmi_kpp_input* out_input);

#endif
