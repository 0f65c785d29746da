/* The host's choice among a part's hypotheses: an index, or a designer's rule. */
#ifndef CLI_CHOOSE_H
#define CLI_CHOOSE_H

#include <stdbool.h>

#include <cjson/cJSON.h>

#include "session.h"

enum choice_kind { CHOICE_NONE, CHOICE_KEEP, CHOICE_INDEX, CHOICE_RULE };

/* What picks a hypothesis. A rule picks the first one that fits all it states; where none does, nothing is picked. */
typedef struct job_choice {
    enum choice_kind kind;
    int index;
    int32_t type;        /* DM_JOINT_*; UNKNOWN: any */
    int has_axis, opens; /* which of the directions below are stated */
    double axis[3];      /* about or along which it moves, whatever the sign; file's frame */
    double toward[3];    /* which way the part's centre goes when it opens; file's frame */
} job_choice;

/* What the library showed, and what was picked. */
typedef struct choice_answer {
    uint32_t count; /* of hypotheses; 0: nothing was asked */
    int chosen;     /* -1: the library's answer was kept */
    dm_joint_end ends[DM_MAX_HYPOTHESES][2];
} choice_answer;

typedef struct chooser {
    const job_choice* choice;
    choice_answer* answer;
} chooser;

/* A dm_choice_callback; `user` is a chooser. */
int32_t DM_CALL choose_hypothesis(void* user, const dm_choice* choice);

/* Reads "choose" of a job: an index, "keep", or an object with "type", "axis" or "opens"; absent or null: none. */
dm_result choice_from_json(session* session, const cJSON* json, job_choice* out);
/* Adds "ends" to a hypothesis. frame: origin of the joints' frame. */
void choice_ends_to_json(const choice_answer* answer, uint32_t hypothesis, const double frame[3], cJSON* out);

#endif
