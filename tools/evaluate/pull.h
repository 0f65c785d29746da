/* Pulls of `dragmesh eval`: the drag that a person makes of a joint, instead of the stored one. */
#ifndef CLI_PULL_H
#define CLI_PULL_H

#include "dataset.h"

typedef enum pull_kind {
    PULL_EXACT, /* the stored drag: where the grabbed point starts to move */
    PULL_CHORD, /* straight from where the grabbed point is to where it is half open */
    PULL_AXIS,  /* along the room's axis nearest to the stored drag's way */
    PULL_KINDS
} pull_kind;

/* Returns the kind of that name ("exact", "chord", "axis"); PULL_KINDS for an unknown one. */
pull_kind pull_kind_of(const char* name);

/* Returns the drag that `kind` makes of a stored one. A chord or axis pull of a turning joint grabs the part's vertex
 * farthest from the axis; of a sliding joint, the stored point. part: all `count` vertices of the part, at least one.
 * size: largest side of the object's box. */
known_drag pull_make(pull_kind kind, const known_joint* truth, const known_drag* stored, const vec* part, size_t count,
                     double size);

#endif
