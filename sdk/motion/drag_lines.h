/* Fits the lines of rivals' turns to the pull, one remembered ray an update. */
#ifndef DMI_MOTION_DRAG_LINES_H
#define DMI_MOTION_DRAG_LINES_H

#include "motion/joint_hypothesis.h"

#define DMI_TRACKED_HYPOTHESES 64
#define DMI_NOBODY UINT32_MAX

/* A rival on its way through the pull: as it is, and then, if that promises more, with its line shifted. */
typedef struct dmi_lines {
    dmi_fit fit;
    uint32_t rival, thinned;
    int shifted;
    float shift[2], lean;      /* tried now */
    float before;              /* how well the line as it was explains the pull, log */
    float promise[DMI_TRACKED_HYPOTHESES]; /* by which rivals are chosen: the last score, and what comes with waiting */
    uint32_t fits;
} dmi_lines;

void dmi_lines_begin(dmi_lines* lines);
/* Of a rival that has come. */
void dmi_lines_add(dmi_lines* lines, uint32_t index, const dmi_joint_hypothesis* rival);
/* One step. The rival whose line has become another, its score with it; mostly nobody. */
uint32_t dmi_lines_fit(dmi_lines* lines, const dmi_hold* hold, dmi_joint_hypothesis* rivals, uint32_t count, uint32_t best);

#endif
