/* A generated case's candidate joints, made and judged by the library's own kinematics as in a game. */
#ifndef DM_LAB_EVALUATE_CANDIDATES_H
#define DM_LAB_EVALUATE_CANDIDATES_H

#include "case.h"
#include "kinematics/evidence.h"
#include "kinematics/opinion.h"
#include "kinematics/sieve.h"

typedef struct lab_evaluated_case {
    lab_case made;
    dmi_study study;
    dmi_opinion opinion; /* with a network */
    dmi_candidate candidates[DMI_CANDIDATES_MAX];
    float evidence[DMI_CANDIDATES_MAX][DMI_EVIDENCE_COUNT];
    float score[DMI_CANDIDATES_MAX];
    float pose[DMI_CANDIDATES_MAX]; /* how far each leaves the part from where it should be (pose_error.h) */
    uint32_t count;
    dm_joint joint; /* the true one, positive along the drag */
    dmi_drag_hint hint;
} lab_evaluated_case;

/* What judges one case after the other. */
typedef struct lab_evaluator {
    dmi_env env;
    dmi_kpp_net* net;
    dmi_sieve* sieve; /* NULL: all candidates are judged */
    void* scratch;
    size_t scratch_size;
    lab_evaluated_case* work; /* the case at hand */
} lab_evaluator;

/* kinematics: bytes of a KPP-Net weights file, sieve: of a sieve's; either may be NULL. Close after success. */
dm_result lab_evaluator_open(const void* kinematics, size_t kinematics_size, const void* sieve, size_t sieve_size,
                             lab_evaluator* out);
void lab_evaluator_close(lab_evaluator* evaluator);

/* Takes what was judged. */
typedef void (*lab_evaluated_visit)(const lab_evaluated_case* work, int with_drag, uint32_t index, void* user);

/* Judges the work's case, whose drag is set, and hands it on. with_drag 0: the kinematics does not see the drag, the
 * labels do. */
dm_result lab_evaluate_case(lab_evaluator* evaluator, int with_drag, uint32_t index, lab_evaluated_visit each,
                            void* user);
/* Opens, draws and judges the options' cases one after the other, hands each on, and closes. */
dm_result lab_evaluate_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                             const void* sieve, size_t sieve_size, lab_evaluated_visit each, void* user);

#endif
