/* Reports to the host's progress callback. */
#include "base/progress.h"

#define PERCENT 100.0f

dmi_progress dmi_progress_of(dmi_env* env, const char* function, float* told) {
    *told = 0;
    return (dmi_progress){env, function, env->progress, env->progress_user, 0, 1, told};
}

dmi_progress dmi_progress_piece(const dmi_progress* progress, float from, float to) {
    if (progress == NULL) return (dmi_progress){0};
    dmi_progress piece = *progress;
    piece.from = progress->from + from * (progress->to - progress->from);
    piece.to = progress->from + to * (progress->to - progress->from);
    return piece;
}

dm_result dmi_progress_tell(const dmi_progress* progress, float share) {
    if (progress == NULL || progress->progress == NULL) return DM_OK;
    float done = progress->from + (share < 1 ? share : 1) * (progress->to - progress->from);
    if (progress->told != NULL) { /* shares of shares round differently */
        if (done < *progress->told) done = *progress->told;
        *progress->told = done;
    }
    if (!progress->progress(progress->user, done)) return DM_OK;
    return dmi_fail(progress->env, DM_ERROR_CANCELLED, "%s: the progress callback asked to stop at %.0f %%",
                    progress->function, (double)(done * PERCENT));
}
