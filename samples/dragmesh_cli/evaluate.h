/* Runs the library over a folder of known objects and measures every joint. */
#ifndef CLI_EVALUATE_H
#define CLI_EVALUATE_H

#include "metrics.h"
#include "mistakes.h"
#include "random.h"
#include "session.h"

typedef struct eval_options {
    int no_drag, given_type, drags; /* drags: how many of each joint's */
    double drag_noise;              /* degrees: directions off by |N(0, s)|, as a hand's are */
    double mask_noise;              /* share of the part's vertices lost and leaked, in patches */
    int turn_seed, has_turn;        /* every object in a random pose and unit */
    int find_part, merged;          /* the part is found from the drag's point; as if the file were one mesh */
    mistake_book* mistakes;         /* NULL: none is kept */
} eval_options;

typedef struct eval_rows {
    metric_row* rows;
    size_t count, room;
} eval_rows;

/* Appends a row a joint and drag. A joint that gets no answer is a row too, and a line on standard error. 0, or -1 when
 * the object itself can't be read. */
int evaluate_object(session* session, const char* folder, const char* name, const eval_options* options,
                    random_state* random, eval_rows* rows);

#endif
