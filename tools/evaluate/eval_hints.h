/* Hints of `dragmesh eval`: labels and pivots that the dataset has of its joints, and lies in their place. */
#ifndef CLI_EVAL_HINTS_H
#define CLI_EVAL_HINTS_H

#include "dataset.h"
#include "random.h"

enum { HINTS_NAMES = 1, HINTS_PIVOTS = 2 };

/* Returns HINTS_* of "names", "pivots" or "both"; 0 for another word. */
int eval_hints_of(const char* name);

/* Returns a pivot at a place, with axes of three unit directions. */
dm_pivot eval_hints_pivot(vec origin, const vec axes[3]);
/* Sets the job's label, pivot and up direction to those of a joint. which: HINTS_*; the rest is set to none. lies:
 * share of the joints that get another joint's label and a pivot anywhere in the box low..high with axes of any
 * direction. */
void eval_hints_set(int which, double lies, const known_object* object, int index, vec low, vec high,
                    random_state* random, job* out);

#endif
