/* Checks of the feel that a host asks for. */
#include <math.h>
#include <string.h>

#include "api_check.h"
#include "api_drag.h"
#include "math/elementary.h"

dm_result dmi_check_feel(dmi_env* env, const dm_drag_feel* feel) {
    const float numbers[6] = {feel->smoothing_time, feel->soft_limit,  feel->coast_time,
                              feel->detent,         feel->detent_pull, feel->return_time};
    static const char* const names[6] = {
        "dm_drag_begin: desc.feel.smoothing_time", "dm_drag_begin: desc.feel.soft_limit",
        "dm_drag_begin: desc.feel.coast_time",     "dm_drag_begin: desc.feel.detent",
        "dm_drag_begin: desc.feel.detent_pull",    "dm_drag_begin: desc.feel.return_time"};
    for (int i = 0; i < 6; i++) {
        dm_result result = dmi_check_finite(env, names[i], &numbers[i], 1);
        if (result != DM_OK) return result;
        if (numbers[i] == 0 || fabsf(numbers[i]) >= DMI_SMALLEST_FEEL) continue;
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s is %g: numbers below %g are too small to compute with",
                        names[i], (double)numbers[i], (double)DMI_SMALLEST_FEEL);
    }
    for (int i = 1; i <= 4; i++) { /* soft_limit, detent and detent_pull; coast_time may be negative */
        const bool share = i == 1 || i == 4;
        if (i == 2 || (numbers[i] >= 0.0f && !(share && numbers[i] > 1.0f))) continue;
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s is %g: it must be %s", names[i], (double)numbers[i],
                        share ? "0 to 1" : "0 or more");
    }
    return DM_OK;
}

dm_drag_feel dmi_usable_feel(const dm_drag_feel* given) {
    dm_drag_feel feel = *given;
    float* const times[3] = {&feel.smoothing_time, &feel.coast_time, &feel.return_time};
    for (int i = 0; i < 3; i++) *times[i] = dmi_clamp_within(*times[i], DMI_LARGEST_TIME);
    feel.detent = dmi_fminf(feel.detent, DMI_LARGEST);
    return feel;
}

bool dmi_is_usable_feel(const dm_drag_feel* feel) {
    const dm_drag_feel usable = dmi_usable_feel(feel);
    /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): what clamping has left as it was has the same bits */
    return dmi_check_feel(NULL, feel) == DM_OK && memcmp(feel, &usable, sizeof usable) == 0;
}
