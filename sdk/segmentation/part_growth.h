/* A part put together piece by piece: what tells whether a piece that touches it belongs to it. */
#ifndef DMI_SEGMENTATION_PART_GROWTH_H
#define DMI_SEGMENTATION_PART_GROWTH_H

#include "segmentation/part_level.h"

/* One hidden layer of rectified units, one output. */
typedef struct dmi_part_net {
    uint32_t inputs, hidden;
    const float *weights, *biases, *outputs; /* hidden x inputs, hidden, hidden */
    float bias;
} dmi_part_net;

float dmi_part_net_run(const dmi_part_net* net, const float* features);

#define DMI_GROWTH_FEATURES 31

typedef struct dmi_growth {
    const dmi_part_level* level;
    float drag[3];                          /* unit; zeros: none */
    uint8_t* inside;                        /* a piece: of the part */
    uint8_t *shell_inside, *sheet_inside;   /* some piece of it is */
    float (*features)[DMI_GROWTH_FEATURES]; /* a piece that touches the part */
    uint32_t* touching;                     /* such pieces … */
    uint32_t touching_count;                /* … and how many */
    uint32_t member_count;
    uint32_t* border; /* samples that touch anything */
    uint32_t border_count;
    struct dmi_piece_shape* shapes; /* a piece */
    struct dmi_touch_sums* sums;    /* a piece */
} dmi_growth;

/* Everything lives in the arena; no piece is inside yet. */
dm_result dmi_growth_make(dmi_arena* arena, const dmi_part_level* level, const float drag[3], dmi_growth* out);
void dmi_growth_add(dmi_growth* growth, uint32_t piece);
/* Fills touching and their features. */
void dmi_growth_look(dmi_growth* growth);

/* How two samples of different pieces that touch lie to each other. */
typedef struct dmi_touch_kind {
    int flush, stacked;  /* parallel faces, side by side or one on the other */
    int concave, convex; /* each lies before the other's plane, or each behind it */
    float ahead;         /* of the first one along the drag, in reaches */
} dmi_touch_kind;

dmi_touch_kind dmi_touch_classify(const dmi_pieces* pieces, const dmi_piece_sample* sample,
                                  const dmi_piece_touch* touch, const float drag[3]);

#endif
