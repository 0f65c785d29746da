/* Proposals: candidate parts, each a set of pieces that contains the grabbed point, with features that rate which one
 * is the part. */
#ifndef DMI_SEGMENTATION_PROPOSALS_H
#define DMI_SEGMENTATION_PROPOSALS_H

#include "nn/layers.h"
#include "segmentation/pieces.h"

#define DMI_MAX_PROPOSALS 64     /* set by hand */
#define DMI_PROPOSAL_FEATURES 55 /* listed in proposal_features.h */

typedef struct dmi_grab {
    uint32_t face;
    float point[3], drag[3]; /* object-normalised; drag unit, zeros: none */
} dmi_grab;

typedef struct dmi_proposal {
    const dmi_piece_level* level;
    uint32_t seed;         /* the grabbed piece */
    uint8_t* inside;       /* per piece: 0 outside, 1 in the region, DMI_PIECE_CARRIED */
    float lowest_log_odds; /* least of the region's pieces, each as it was added */
    float last_log_odds;   /* log odds of the piece added last */
    float next_log_odds;   /* log odds of the best neighbour */
    uint32_t next_piece;   /* the best neighbour; DMI_PIECE_NONE: there is none */
    uint32_t likely_count; /* neighbours with positive log odds */
    float likely_area;     /* and their area */
    float later_log_odds;  /* greatest of the pieces added after this proposal in the same growth */
    float final_area;      /* area of the region at the end of that growth */
    float features[DMI_PROPOSAL_FEATURES];
} dmi_proposal;

typedef struct dmi_proposals {
    dmi_piece_level levels[2]; /* one of whole sheets; one with the grabbed sheet cut at its creases */
    dmi_proposal items[DMI_MAX_PROPOSALS];
    uint32_t count;
} dmi_proposals;

/* Makes the proposals and computes their features. All memory comes from the arena. growth_network: of
 * dmi_part_networks. progress: may be NULL. */
dm_result dmi_proposals_make(dmi_arena* arena, const dmi_mesh_sheets* sheets, const dmi_grab* grab,
                             const dmi_perceptron* growth_network, dmi_isa isa, const dmi_progress* progress,
                             dmi_proposals* out);

#endif
