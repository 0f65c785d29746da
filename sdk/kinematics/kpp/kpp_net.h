/* KPP-Net (paper §3.5): joint type, axis, origin and limits from a grouped cloud and a drag. Forward pass. */
#ifndef DMI_KPP_KPP_NET_H
#define DMI_KPP_KPP_NET_H

#include "base/cpu.h"
#include "kinematics/kpp/kpp_input.h"

#define DMI_KPP_TYPES 4              /* revolute, prismatic, screw, continuous: DM_JOINT_* minus 1 */
#define DMI_KPP_CONTEXT 128          /* what the choice head knows of the part */
#define DMI_KPP_CANDIDATE_NUMBERS 21 /* numbers of a candidate joint, see kpp_choice.c */
#define DMI_KPP_SCORE_BATCH 32       /* candidates at once */

typedef struct dmi_kpp_net dmi_kpp_net;

/* Raw head outputs, in the input's frame; and what the choice head makes of the part, whatever the candidate. */
typedef struct dmi_kpp_output {
    float type_logits[DMI_KPP_TYPES];
    float turn_axis[3];  /* not normalised */
    float slide_axis[3]; /* not normalised */
    float origin[3];
    float context[DMI_KPP_CONTEXT];
    float limits[5]; /* turn lower, upper (units of pi rad), slide lower, upper, pitch (inner units, a radian) */
} dmi_kpp_output;

dm_result dmi_kpp_net_load(dmi_env* env, const void* data, size_t size, dmi_kpp_net** out_net);
void dmi_kpp_net_destroy(dmi_kpp_net* net);
size_t dmi_kpp_net_scratch_size(const dmi_kpp_net* net);
/* scratch: 64-byte aligned. Const net: any number of threads at once. */
void dmi_kpp_net_forward(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_input* input, void* scratch,
                         dmi_kpp_output* out_output);
/* The choice head: a score each candidate, at most DMI_KPP_SCORE_BATCH of them. output: of a forward pass. */
void dmi_kpp_net_score(const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_output* output,
                       const float (*lines)[DMI_KPP_CANDIDATE_NUMBERS], uint32_t count, float* out_scores);

#endif
