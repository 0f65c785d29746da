/* How far a long call is: told to the host's progress callback, which may cancel it. Used on the thread that has
 * called, and there alone. */
#ifndef DMI_BASE_PROGRESS_H
#define DMI_BASE_PROGRESS_H

#include "base/env.h"
#include "base/progress_stages.h"

/* Elements (triangles, vertices) between two reports of a loop: some milliseconds of work each; measured. */
#define DMI_PROGRESS_STEP ((uint32_t)1 << 16)

typedef struct dmi_progress {
    dmi_env* env;
    const char* function;          /* that the host has called; for the message */
    dm_progress_callback progress; /* NULL: nobody asks */
    void* user;
    float from, to; /* what part of the call is watched, 0 to 1 */
    float* told;    /* the last report, below which none falls; NULL: who calls sees to it */
} dmi_progress;

/* Watches a whole call for the callback of the context. told: the caller's, as long as the call lasts. */
dmi_progress dmi_progress_of(dmi_env* env, const char* function, float* told);

/* The same for a piece of what is watched, by shares of it. `progress` may be NULL. */
dmi_progress dmi_progress_piece(const dmi_progress* progress, float from, float to);

/* Reports that a share, 0 to 1, of what is watched is done. Returns DM_ERROR_CANCELLED, with a message, when the host
 * asks to stop. NULL: DM_OK. */
dm_result dmi_progress_tell(const dmi_progress* progress, float share);

/* The same after element `i` of a loop over `count`, for one in DMI_PROGRESS_STEP of them. */
static inline dm_result dmi_progress_step(const dmi_progress* progress, uint32_t i, uint32_t count) {
    if (i % DMI_PROGRESS_STEP != DMI_PROGRESS_STEP - 1) return DM_OK;
    return dmi_progress_tell(progress, (float)i / (float)count);
}

#endif
