/* Joint hypotheses of one part, and their order under a drag, in closed form. */
#ifndef DMI_INFERENCE_HYPOTHESES_H
#define DMI_INFERENCE_HYPOTHESES_H

#include "math/joint.h"

typedef struct dmi_hypotheses {
    dm_joint joints[DM_MAX_HYPOTHESES]; /* best first, object-normalised frame */
    dmi_free_range free_range[DM_MAX_HYPOTHESES];
    uint32_t count;
} dmi_hypotheses;

/* Orders hypotheses by how well they explain a drag, and turns their signs so that positive follows it. Takes
 * microseconds. */
void dmi_hypotheses_rerank(const dmi_hypotheses* hypotheses, const dmi_drag_hint* hint, dmi_hypotheses* out);
/* Signs a joint so that a positive step moves the drag's point along its vector. Limits swap with the sign. Returns
 * whether the sign has changed. */
bool dmi_joint_orient(dm_joint* joint, const dmi_drag_hint* hint);

#endif
