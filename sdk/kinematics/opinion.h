/* What KPP-Net says of a part: it looks several times, each time at other points of the cloud, every second time with
 * two axes of its frame the other way round. Which way they point is half a convention, and where the looks differ the
 * truth is mostly between them. */
#ifndef DMI_KINEMATICS_OPINION_H
#define DMI_KINEMATICS_OPINION_H

#include "kinematics/kpp_choice.h"

#define DMI_LOOKS 4

typedef struct dmi_opinion {
    dmi_kpp_input input[DMI_LOOKS];
    dmi_kpp_output output[DMI_LOOKS];
    dmi_prediction prediction; /* of the look that the others agree with most; the type: the mean of all */
} dmi_opinion;

/* hint NULL: without a drag. scratch: as for dmi_kpp_net_forward. */
void dmi_opinion_form(const dmi_kpp_net* net, dmi_isa isa, const dmi_cloud* cloud, const dmi_drag_hint* hint,
                      void* scratch, dmi_opinion* out_opinion);
/* Log-likelihoods of candidates up to a constant: the mean of all looks. */
void dmi_opinion_score(const dmi_kpp_net* net, dmi_isa isa, const dmi_opinion* opinion, const dmi_candidate* candidates,
                       uint32_t count, float out_scores[DMI_CANDIDATES_MAX]);
/* The same by the first look alone. */
void dmi_opinion_glance(const dmi_kpp_net* net, dmi_isa isa, const dmi_opinion* opinion,
                        const dmi_candidate* candidates, uint32_t count, float out_scores[DMI_CANDIDATES_MAX]);

#endif
