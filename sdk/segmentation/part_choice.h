/* Proposals of the part that was grabbed, and what tells which one is it. */
#ifndef DMI_SEGMENTATION_PART_CHOICE_H
#define DMI_SEGMENTATION_PART_CHOICE_H

#include "segmentation/part_growth.h"

#define DMI_PROPOSALS_MOST 64
#define DMI_CHOICE_FEATURES 55

typedef struct dmi_grab {
    uint32_t face;
    float point[3], drag[3]; /* drag unit; zeros: none */
} dmi_grab;

typedef struct dmi_proposal {
    const dmi_part_level* level;
    uint32_t seed;            /* the grabbed piece */
    uint8_t* inside;          /* a piece; 2: carried along */
    float lowest, last, next; /* log odds: of its pieces as they joined, and of the best that did not */
    uint32_t next_piece;      /* the best that did not; NONE: nothing else touches */
    uint32_t likely;          /* how many touch it that belong more likely than not … */
    float likely_area;        /* … and their area */
    float later,
        whole_area; /* of the growth that it is a stage of: the most certain piece that joined later, the end */
    float features[DMI_CHOICE_FEATURES];
} dmi_proposal;

typedef struct dmi_proposals {
    dmi_part_level levels[2];
    dmi_proposal items[DMI_PROPOSALS_MOST];
    uint32_t count;
} dmi_proposals;

/* Everything lives in the arena. */
dm_result dmi_proposals_make(dmi_arena* arena, const dmi_part_sheets* sheets, const dmi_grab* grab,
                             const dmi_part_net* growth, dmi_proposals* out);

/* Fills the proposals' features. */
dm_result dmi_proposals_measure(dmi_arena* arena, const dmi_grab* grab, dmi_proposals* proposals);

/* Room for working on which pieces outside a part touch each other. */
typedef struct dmi_part_groups {
    uint32_t* roots;  /* a piece: of its group */
    float* area;      /* a group, at its root */
    uint8_t* touches; /* the group touches the part */
    uint32_t largest; /* the largest group's root */
    float part_area;
} dmi_part_groups;

dm_result dmi_part_groups_make(dmi_arena* arena, const dmi_pieces* pieces, dmi_part_groups* out);
void dmi_part_groups_find(const dmi_pieces* pieces, const uint8_t* inside, dmi_part_groups* groups);
/* Small groups that hang on the rest through the part alone go along, marked 2. Answers how many pieces. */
uint32_t dmi_part_carry(const dmi_pieces* pieces, const dmi_part_groups* groups, uint8_t* inside);

#endif
