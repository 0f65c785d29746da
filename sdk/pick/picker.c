/* Chooses the backend of a context. */
#include "pick/picker.h"

#include <stdio.h>

#define MOST_BACKENDS 3 /* a choice tries, and the NULL behind them */

/* What each choice tries, in this order. */
static const dmi_pick_backend* const choices[][MOST_BACKENDS] = {
    [DM_PICK_AUTO] = {DMI_PICK_EMBREE DMI_PICK_PORTABLE NULL},
    [DM_PICK_EMBREE] = {DMI_PICK_EMBREE NULL},
    [DM_PICK_PORTABLE] = {DMI_PICK_PORTABLE NULL},
    [DM_PICK_NONE] = {NULL},
};

/* Opens the first backend that works here; leaves none, and the reason, where there is none. */
static dm_result open_backend(dmi_picker* picker, int32_t choice) {
    const dmi_pick_backend* const* backend = choices[choice];
    snprintf(picker->why, sizeof picker->why, "%s",
             choice == DM_PICK_NONE ? "the host wants none (DM_PICK_NONE)" : "this build has none (--pick)");
    for (; *backend != NULL; backend++) {
        const dm_result result = (*backend)->open(picker->env, &picker->device, picker->why, sizeof picker->why);
        if (result == DM_OK) picker->backend = *backend;
        if (result != DM_ERROR_UNSUPPORTED) return result;
    }
    return choice == DM_PICK_AUTO || choice == DM_PICK_NONE ? DM_OK : DM_ERROR_UNSUPPORTED;
}

dm_result dmi_picker_create(dmi_env* env, int32_t choice, dmi_picker** out_picker) {
    dmi_picker* picker = dmi_alloc_zeroed(env, sizeof *picker, _Alignof(dmi_picker));
    if (picker == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for the ray picker");
    picker->env = env;
    picker->choice = choice;
    dm_result result = open_backend(picker, choice);
    if (result != DM_OK) {
        result = dmi_fail(env, result, "picking: %s", picker->why);
        dmi_free(env, picker, sizeof *picker);
        return result;
    }
    *out_picker = picker;
    return DM_OK;
}

void dmi_picker_destroy(dmi_picker* picker) {
    if (picker == NULL) return;
    if (picker->backend != NULL) picker->backend->close(picker->device);
    dmi_free(picker->env, picker, sizeof *picker);
}

const char* dmi_picker_backend(const dmi_picker* picker) {
    return picker->backend != NULL ? picker->backend->name : "none";
}
