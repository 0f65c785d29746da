/* One period of a sine is taken off the value about each snap value, as about a detent (drag_feel.c), but each side of
 * it has its own length. Both ends of the period leave the value as it is, so neighbours join. */
#include "motion/drag_snaps.h"

#include <math.h>

#include "math/constants.h"
#include "math/elementary.h"

#define BISECTIONS 40 /* halvings of twice the longest reach, which end below a float's rounding */

/* Returns the index of the snap value nearest to a value. */
static uint32_t nearest_snap(const dmi_snaps* snaps, float value) {
    uint32_t best = 0;
    while (best + 1 < snaps->count && value > 0.5f * (snaps->values[best] + snaps->values[best + 1])) best++;
    return best;
}

/* Returns how far a snap value reaches to one side. */
static float reach_of(const dmi_snaps* snaps, uint32_t index, bool upwards) {
    const bool has_next = upwards ? index + 1 < snaps->count : index > 0;
    if (!has_next) return snaps->outer_reach;
    const uint32_t low = upwards ? index : index - 1;
    const float half = 0.5f * (snaps->values[low + 1] - snaps->values[low]);
    return snaps->reach > 0 ? dmi_fminf(snaps->reach, half) : half;
}

float dmi_snaps_pull(const dmi_snaps* snaps, float value) {
    if (snaps->count == 0) return value;
    const uint32_t i = nearest_snap(snaps, value);
    const float off = value - snaps->values[i], reach = reach_of(snaps, i, off > 0);
    if (!(fabsf(off) < reach)) return value;
    return value - snaps->pull * reach / DMI_PI_F * dmi_sinf(DMI_PI_F * off / reach);
}

float dmi_snaps_invert(const dmi_snaps* snaps, float target) {
    if (snaps->count == 0) return target;
    const uint32_t i = nearest_snap(snaps, target);
    const float off = target - snaps->values[i], reach = reach_of(snaps, i, off > 0);
    if (!(fabsf(off) < reach)) return target;
    float low = target - reach, high = target + reach;
    for (int k = 0; k < BISECTIONS; k++) {
        const float middle = 0.5f * (low + high);
        if (dmi_snaps_pull(snaps, middle) < target)
            low = middle;
        else
            high = middle;
    }
    return 0.5f * (low + high);
}

bool dmi_snaps_catch(const dmi_snaps* snaps, const dm_joint* joint, float value, float* out_snap) {
    if (snaps->count == 0) return false;
    const uint32_t i = nearest_snap(snaps, value);
    const float snap = snaps->values[i], off = value - snap;
    if (!(fabsf(off) < reach_of(snaps, i, off > 0)) || dmi_joint_clamp(joint, snap) != snap) return false;
    *out_snap = snap;
    return true;
}

float dmi_snaps_place(const dmi_snaps* snaps, float value) {
    const uint32_t i = nearest_snap(snaps, value);
    const float off = value - snaps->values[i];
    const bool outer = off > 0 ? i + 1 == snaps->count : i == 0;
    return (float)i +
           dmi_fminf(dmi_fmaxf(0.5f * off / reach_of(snaps, i, off > 0), outer ? -1 : -0.5f), outer ? 1 : 0.5f);
}
