/* KPP-Net (paper §3.5): predicts joint type, axis, origin and limits from a grouped cloud and a drag. Forward pass. */
#ifndef DMI_KPP_KPP_NET_H
#define DMI_KPP_KPP_NET_H

#include "base/cpu.h"
#include "kinematics/kpp/kpp_input.h"

#define DMI_KPP_TYPES 4              /* revolute, prismatic, screw, continuous: DM_JOINT_* minus 1 */
#define DMI_KPP_LIMITS 5             /* turn lower, upper, slide lower, upper, pitch */
#define DMI_KPP_CONTEXT 128          /* hidden units of the candidate-scoring head (docs/networks.md) */
#define DMI_KPP_CANDIDATE_NUMBERS 21 /* features of a candidate joint, see kpp_ensemble.c */
#define DMI_KPP_SCORE_BATCH 32       /* most candidates of one call */

typedef struct dmi_kpp_net dmi_kpp_net;

/* Raw outputs of the heads, in the input's frame. */
typedef struct dmi_kpp_output {
    float type_logits[DMI_KPP_TYPES];
    float turn_axis[3];  /* not normalised */
    float slide_axis[3]; /* not normalised */
    float origin[3];
    float context[DMI_KPP_CONTEXT]; /* the part's share of the candidate-scoring head's first layer */
    float limits[DMI_KPP_LIMITS];   /* turns in pi rad, slides in the frame's unit, pitch in units per rad */
} dmi_kpp_output;

dm_result dmi_kpp_net_load(dmi_env* env, const void* data, size_t size, dmi_kpp_net** out_net);
void dmi_kpp_net_destroy(dmi_kpp_net* net);
size_t dmi_kpp_net_scratch_size(const dmi_kpp_net* net);
/* Runs the network. scratch: dmi_kpp_net_scratch_size bytes, 64-byte aligned. Several threads may run it at once, each
 * with scratch of its own. */
void dmi_kpp_net_forward(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_input* input, void* scratch,
                         dmi_kpp_output* out_output);
/* Computes the candidate-scoring head's score (a logit) for each candidate. output: of a forward pass. count <=
 * DMI_KPP_SCORE_BATCH. */
void dmi_kpp_net_score(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_output* output,
                       const float (*candidates)[DMI_KPP_CANDIDATE_NUMBERS], uint32_t count, float* out_scores);

/* ---- what the network predicts ---- */

typedef struct dmi_prediction {
    float type[DMI_KPP_TYPES];                    /* probabilities, sum 1 */
    float turn_axis[3], slide_axis[3], origin[3]; /* unit axes; a point of the turn's axis */
    float turn_limits[2];                         /* lower, upper; rad */
    float slide_limits[2];                        /* lower, upper; object sizes */
    float pitch;                                  /* object sizes per rad */
} dmi_prediction;

/* Converts the network's raw outputs: normalises axes, computes probabilities, transforms out of the input's frame. */
void dmi_prediction_read(const dmi_kpp_frame* frame, const dmi_kpp_output* raw, dmi_prediction* out);

#endif
