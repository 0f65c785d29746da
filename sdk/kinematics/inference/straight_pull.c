/* Compares the drag with the velocity of the dragged point. */
#include "kinematics/inference/straight_pull.h"

#include <float.h>

#include "math/elementary.h"

#define EXPLAINED 1e-3f  /* rad: the drag's angle as a feature, where a candidate explains the drag; by hand */
#define LEAST_BEND 0.05f /* rad between the drag and the first movement; a smaller angle is a hand's error; by hand */
/* Share of the part's farthest distance from the axis, from which on a hand pulls straight: it takes hold of the far
 * end or a handle. A hand that holds nearer to the axis gives the exact drag of another joint (measured: slides that
 * are dragged along the room). */
#define FAR_OUT 0.9f

bool dmi_straight_pull_read(const dmi_candidate* candidate, const float features[DMI_FEATURE_COUNT],
                            const dmi_drag_hint* hint, dmi_drag_hint* out_hint) {
    if (features[DMI_FEATURE_DRAG_ANGLE] > EXPLAINED || features[DMI_FEATURE_DRAG_REACH] < FAR_OUT) return false;
    float way[3];
    dmi_candidate_velocity(candidate, hint->point, way);
    const float speed = dmi_max(dmi_length3(way), FLT_MIN), length = dmi_length3(hint->vector);
    const float cosine = dmi_dot3(way, hint->vector) / dmi_max(speed * length, FLT_MIN);
    if (dmi_acosf(dmi_max(dmi_min(cosine, 1), -1)) < LEAST_BEND) return false;
    *out_hint = *hint;
    for (int k = 0; k < 3; k++) out_hint->vector[k] = length / speed * way[k];
    return true;
}
