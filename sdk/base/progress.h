/* The progress of a long call, which is reported to the host's callback. The callback may cancel the call. Progress is
 * used only on the thread that has called the library. */
#ifndef DMI_BASE_PROGRESS_H
#define DMI_BASE_PROGRESS_H

#include "base/env.h"
#include "base/progress_stages.h"

/* Elements (triangles, vertices) between two reports of a loop: some milliseconds of work each; measured. */
#define DMI_PROGRESS_STEP ((uint32_t)1 << 16)

typedef struct dmi_progress {
    dmi_env* env;
    const char* function;          /* name of the function that the host has called, for messages */
    dm_progress_callback progress; /* NULL: nobody asks */
    void* user;
    float from, to; /* the stage of the call that is watched, 0 to 1 */
    float* told;    /* the last report: no later one is lower; NULL: the caller sees to that */
} dmi_progress;

/* Makes the progress of a whole call, for the callback of the context. told: a number of the caller's, which lives as
 * long as the call. */
dmi_progress dmi_progress_of(dmi_env* env, const char* function, float* told);

/* Makes the progress of a stage of what is watched, between two shares of it. `progress` may be NULL. */
dmi_progress dmi_progress_piece(const dmi_progress* progress, float from, float to);

/* Reports that a share, 0 to 1, of what is watched is done. Returns DM_ERROR_CANCELLED, with a message, when the host
 * asks to stop. With NULL it returns DM_OK. */
dm_result dmi_progress_tell(const dmi_progress* progress, float share);

/* Reports that element `i` of a loop over `count` is done, for one in DMI_PROGRESS_STEP elements. */
static inline dm_result dmi_progress_step(const dmi_progress* progress, uint32_t i, uint32_t count) {
    if (i % DMI_PROGRESS_STEP != DMI_PROGRESS_STEP - 1) return DM_OK;
    return dmi_progress_tell(progress, (float)i / (float)count);
}

#endif
