/* A step of AdamW over all of a network's numbers at once. */
#ifndef DM_LAB_ADAM_H
#define DM_LAB_ADAM_H

#include <stddef.h>

#include "dragmesh_lab.h"

/* count numbers each. */
typedef struct dm_lab_adam_state {
    size_t count;
    float *weights, *mean, *square; /* running means of the gradient and of its square */
    float* average;                 /* of the weights over the steps */
    const float* gradient;
} dm_lab_adam_state;

typedef struct dm_lab_adam_step {
    uint32_t number; /* 1, 2, ... */
    float rate, decay;
    float share; /* of the new weights in their average */
    float most;  /* the gradient is shortened to this length */
} dm_lab_adam_step;

/* As torch.optim.AdamW with betas .9, .999 and epsilon 1e-8. */
DM_API void dm_lab_adam(const dm_lab_adam_state* state, const dm_lab_adam_step* step);

#endif
