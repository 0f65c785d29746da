/* A generated case's candidate joints, made and judged by the library's own kinematics as in a game. */
#ifndef DM_LAB_JUDGE_H
#define DM_LAB_JUDGE_H

#include "case.h"
#include "kinematics/evidence.h"
#include "kinematics/opinion.h"
#include "kinematics/sieve.h"

typedef struct lab_judged {
    lab_case made;
    dmi_study study;
    dmi_opinion opinion; /* with a network */
    dmi_candidate candidates[DMI_CANDIDATES_MAX];
    float evidence[DMI_CANDIDATES_MAX][DMI_EVIDENCE_COUNT];
    float score[DMI_CANDIDATES_MAX];
    float pose[DMI_CANDIDATES_MAX]; /* how far each leaves the part from where it should be (goal.h) */
    uint32_t count;
    dm_joint joint; /* the true one, positive along the drag */
    dmi_drag_hint hint;
} lab_judged;

/* What judges one case after the other. */
typedef struct lab_judge {
    dmi_env env;
    dmi_kpp_net* net;
    dmi_sieve* sieve; /* NULL: all candidates are judged */
    void* scratch;
    size_t scratch_size;
    lab_judged* work; /* the case at hand */
} lab_judge;

/* kinematics: bytes of a KPP-Net weights file, sieve: of a sieve's; either may be NULL. Close after success. */
dm_result lab_judge_open(const void* kinematics, size_t kinematics_size, const void* sieve, size_t sieve_size,
                         lab_judge* out);
void lab_judge_close(lab_judge* judge);

/* Takes what was judged. */
typedef void (*lab_judge_each)(const lab_judged* work, int with_drag, uint32_t index, void* user);

/* Judges the work's case, whose drag is set, and hands it on. with_drag 0: the kinematics does not see the drag, the
 * labels do. */
dm_result lab_judge_one(lab_judge* judge, int with_drag, uint32_t index, lab_judge_each each, void* user);
/* Opens, draws and judges the options' cases one after the other, hands each on, and closes. */
dm_result lab_judge_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                          const void* sieve, size_t sieve_size, lab_judge_each each, void* user);

#endif
