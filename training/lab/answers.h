/* Declares the evaluation of the library's answers on generated cases, for calibration and scores. */
#ifndef DM_LAB_ANSWERS_H
#define DM_LAB_ANSWERS_H

#include "dragmesh_lab.h"
#include "lab_hints.h"

/* One entry a case. */
typedef struct dm_lab_answers {
    float* pose;       /* as dm_lab_ranker.pose, of the first hypothesis */
    float* confidence; /* as the library states it */
    int32_t* right_type;
    float* axis_error; /* rad */
    float* line_error; /* object sizes; -1 where a slide is answered */
    int32_t* has_drag;
    int32_t* category; /* id */
} dm_lab_answers;

/* Infers the joints of options->count cases. kinematics: bytes of a KPP-Net weights file; ranker: of a file
 * of joint models (sdk/models/ranker.safetensors); NULL: without. */
DM_API dm_result dm_lab_answer(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                               const void* ranker, size_t ranker_size, const dm_lab_answers* out);
/* The same with labels and pivots drawn for the parts; hints NULL: none. options->rotated must be 0. */
DM_API dm_result dm_lab_answer_hinted(const dm_lab_options* options, const dm_lab_hint_options* hints,
                                      const void* kinematics, size_t kinematics_size, const void* ranker,
                                      size_t ranker_size, const dm_lab_answers* out);

#endif
