/* Declares the evaluation of a generated case's candidate joints by the library's own code. */
#ifndef DM_LAB_EVALUATE_CANDIDATES_H
#define DM_LAB_EVALUATE_CANDIDATES_H

#include "case.h"
#include "kinematics/features/candidate_features.h"
#include "kinematics/features/kpp_ensemble.h"
#include "kinematics/ranking/candidate_prefilter.h"

typedef struct lab_evaluated_case {
    lab_case made;
    dmi_part_analysis analysis;
    dmi_kpp_ensemble ensemble; /* with a network */
    dmi_candidate candidates[DMI_CANDIDATES_MAX];
    float features[DMI_CANDIDATES_MAX][DMI_FEATURE_COUNT];
    float score[DMI_CANDIDATES_MAX];
    float pose[DMI_CANDIDATES_MAX]; /* pose error of each candidate, object sizes (pose_error.h) */
    uint32_t count;
    dm_joint joint; /* the true one, positive along the drag */
    dmi_drag_hint hint;
} lab_evaluated_case;

/* Weights and scratch memory for evaluating cases one after the other. */
typedef struct lab_evaluator {
    dmi_env env;
    dmi_kpp_net* net;
    dmi_arena weights; /* holds the prefilter's layers */
    dmi_prefilter prefilter;
    bool has_prefilter; /* false: all candidates are kept */
    void* scratch;
    size_t scratch_size;
    lab_evaluated_case* work; /* the current case */
} lab_evaluator;

/* Loads the weights. kinematics: bytes of a KPP-Net weights file, prefilter: of a prefilter's; either may be NULL.
 * Close after success. */
dm_result lab_evaluator_open(const void* kinematics, size_t kinematics_size, const void* prefilter,
                             size_t prefilter_size, lab_evaluator* out);
void lab_evaluator_close(lab_evaluator* evaluator);

/* Receives an evaluated case. */
typedef void (*lab_evaluated_visit)(const lab_evaluated_case* work, int with_drag, uint32_t index, void* user);

/* Evaluates the current case, whose drag is set, and passes it to `each`. with_drag 0: candidates are made without the
 * drag, labels with it. */
dm_result lab_evaluate_case(lab_evaluator* evaluator, int with_drag, uint32_t index, lab_evaluated_visit each,
                            void* user);
/* Makes and evaluates the options' cases one after the other and passes each to `each`. */
dm_result lab_evaluate_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                             const void* prefilter, size_t prefilter_size, lab_evaluated_visit each, void* user);

#endif
