/* Runs the library on objects with known joints and measures every joint. */
#ifndef CLI_EVALUATE_H
#define CLI_EVALUATE_H

#include "error_report.h"
#include "eval_hints.h"
#include "metrics.h"
#include "pull.h"
#include "random.h"
#include "session.h"

typedef struct eval_options {
    int no_drag, given_type, drags; /* drags: how many of each joint's */
    pull_kind pull;                 /* what is made of the stored drags */
    int hints;                      /* HINTS_* that are handed over */
    double lies;                    /* share of the hints that lie */
    double drag_noise;              /* degrees: standard deviation of the error of drag directions */
    double mask_noise;              /* share of the part's vertices lost and leaked, in patches */
    int turn_seed, has_turn;        /* every object in a random pose and unit */
    int alone;                      /* each part as if it were alone in its file */
    int find_part, merged;          /* the part is found from the drag's point; as if the file were one mesh */
    error_report* error_report;     /* NULL: no pictures of wrong answers */
} eval_options;

typedef struct eval_rows {
    metric_row* rows;
    size_t count, room;
} eval_rows;

/* Appends a row for each joint and drag. A joint without an answer gets a row too, and a line on standard error.
 * Returns 0, or -1 when the object itself can't be read. */
int evaluate_object(session* session, const char* folder, const char* name, const eval_options* options,
                    random_state* random, eval_rows* rows);

#endif
