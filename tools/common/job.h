/* A job (a file, the part that moves, and the drag) and its answer. */
#ifndef CLI_JOB_H
#define CLI_JOB_H

#include <cjson/cJSON.h>

#include "choose.h"
#include "options.h"
#include "session.h"

#define JOB_PART 1 /* id of the moving part */

typedef struct job {
    const char* file;
    name_list moving;
    int find_part;    /* `moving` is "auto": the part is found at the drag point */
    const char* mask; /* a file that replaces `moving`; NULL: none */
    int64_t mask_value;
    int has_mask_value;
    double mask_noise; /* share of the part's vertices lost and leaked, for experiments */
    int has_drag;
    double drag_point[3];    /* in the file's frame */
    dm_drag_hint drag;       /* in the session's, once the file is open */
    int32_t type;            /* DM_JOINT_*; UNKNOWN: to be inferred */
    int no_hints;            /* the names and pivots of the asset do not count */
    const char* label;       /* NULL: the file's own, "": none */
    int has_pivot, no_pivot; /* neither: the file's own */
    double pivot_origin[3];  /* in the file's frame */
    dm_pivot pivot;          /* in the session's, once the file is open */
    dm_vec3 up;              /* 0: +Y, glTF's */
    job_choice choice;       /* among the hypotheses */
} job;

typedef struct joint_answer {
    dm_joint joint; /* active: the best hypothesis */
    dm_joint hypotheses[DM_MAX_HYPOTHESES];
    uint32_t hypothesis_count;
    choice_answer choice;
    bool ambiguous_mask;
    double frame[3];                             /* origin of the joints' frame, in the file's */
    double prepare_ms, kinematics_ms, motion_ms; /* kinematics is part of prepare */
} joint_answer;

/* Answers a job, whose drag then is in the session's frame; its file and object become the session's. */
dm_result job_answer(session* session, job* job, joint_answer* out_answer);
/* The same for a mesh that is no file's; part_ids as `mesh` says. */
dm_result job_answer_mesh(session* session, const dm_mesh_desc* mesh, const job* job, joint_answer* out_answer);

#endif
