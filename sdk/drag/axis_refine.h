/* Refines the axis lines of turning hypotheses by the recorded pull: one Gauss-Newton step a hypothesis, spread over
 * many updates, one recorded ray in each. */
#ifndef DMI_DRAG_AXIS_REFINE_H
#define DMI_DRAG_AXIS_REFINE_H

#include "drag/joint_hypothesis.h"

#define DMI_TRACKED_HYPOTHESES 64 /* 8 ranked, 48 alternatives and 3 fallback slides fit */
#define DMI_NO_HYPOTHESIS UINT32_MAX

/* A hypothesis goes through the recorded rays with its axis line as it is, and then, if the step promises a higher
 * posterior, with the line shifted. */
typedef struct dmi_axis_refiner {
    dmi_pull_fit fit;
    uint32_t hypothesis; /* being refined; DMI_NO_HYPOTHESIS: none */
    uint32_t thinned;    /* the pull's `thinned` when the fit began */
    bool shifted;        /* second pass, with the shifted line */
    float shift[2];      /* the shift under test, in part sizes */
    float shift_cost;    /* negative log prior of that shift */
    float unshifted_log_posterior;
    /* Last log posterior plus a bonus for waiting; the highest is refined next. */
    float priority[DMI_TRACKED_HYPOTHESES];
    uint32_t rounds; /* hypotheses refined so far */
} dmi_axis_refiner;

void dmi_axis_refiner_init(dmi_axis_refiner* refiner);
/* Announces a new hypothesis. */
void dmi_axis_refiner_add(dmi_axis_refiner* refiner, uint32_t index, const dmi_joint_hypothesis* hypothesis);
/* Follows one recorded ray. Returns the hypothesis whose line has changed (its posterior is then up to date), mostly
 * DMI_NO_HYPOTHESIS. */
uint32_t dmi_axis_refiner_step(dmi_axis_refiner* refiner, const dmi_grasp* grasp, dmi_joint_hypothesis* hypotheses,
                               uint32_t count, uint32_t best);

#endif
