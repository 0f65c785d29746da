/* Reports to the host's progress callback. */
#include "base/progress.h"

#define PERCENT 100.0f

dmi_progress dmi_progress_piece(const dmi_progress* progress, float from, float to) {
    if (progress == NULL) return (dmi_progress){0};
    dmi_progress piece = *progress;
    piece.from = progress->from + from * (progress->to - progress->from);
    piece.to = progress->from + to * (progress->to - progress->from);
    return piece;
}

dm_result dmi_progress_tell(const dmi_progress* progress, float share) {
    if (progress == NULL || progress->progress == NULL) return DM_OK;
    const float done = progress->from + (share < 1 ? share : 1) * (progress->to - progress->from);
    if (!progress->progress(progress->user, done)) return DM_OK;
    return dmi_fail(progress->env, DM_ERROR_CANCELLED,
                    "dm_object_prepare: the progress callback asked to stop at %.0f %%", (double)(done * PERCENT));
}
