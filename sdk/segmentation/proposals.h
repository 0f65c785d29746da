/* Proposals: candidate parts, each a set of pieces that contains the grabbed point, with features that rate which one
 * is the part. */
#ifndef DMI_SEGMENTATION_PROPOSALS_H
#define DMI_SEGMENTATION_PROPOSALS_H

#include "nn/layers.h"
#include "segmentation/pieces.h"

/* ---- features, inputs of the choice network (proposal_features.c) ---- */

/* "Per sample" is relative to the part's number of samples, "share" to the part's area unless something else is named.
 * Lengths are object-normalised; axes are the part's principal ones, longest first. */
enum {
    /* how the part grew */
    DMI_PROPOSAL_LOG_AREA,     /* ln(share of the mesh's area) */
    DMI_PROPOSAL_SEED_AREA,    /* share of the seed piece */
    DMI_PROPOSAL_LOG_PIECES,   /* ln(number of pieces) */
    DMI_PROPOSAL_LOWEST_ODDS,  /* log odds, as of dmi_proposal, clamped */
    DMI_PROPOSAL_LAST_ODDS,    /* likewise */
    DMI_PROPOSAL_NEXT_ODDS,    /* likewise */
    DMI_PROPOSAL_SHEET_IS_CUT, /* the piece level's */
    DMI_PROPOSAL_CARRIED_AREA, /* share of the carried pieces */
    /* contact with the rest */
    DMI_PROPOSAL_CONTACTS,       /* samples in contact with the rest, per sample */
    DMI_PROPOSAL_REST_CONTACTS,  /* the rest's samples in contact with the part, per sample, clamped */
    DMI_PROPOSAL_CONTACT_SPREAD, /* root mean square distance of the contacts from their centre, in radii */
    DMI_PROPOSAL_CONTACT_OFFSET, /* distance of the contacts' centre from the part's, in radii */
    DMI_PROPOSAL_CONCAVE,        /* share of the contacts; see dmi_contact_kind */
    DMI_PROPOSAL_CONVEX,         /* likewise, as the next six */
    DMI_PROPOSAL_FLUSH,
    DMI_PROPOSAL_STACKED,
    DMI_PROPOSAL_REST_AHEAD, /* stacked, and the rest lies ahead along the drag */
    DMI_PROPOSAL_REST_BEHIND,
    DMI_PROPOSAL_SAME_SHEET,
    DMI_PROPOSAL_SAME_SHELL,
    /* motion along the drag */
    DMI_PROPOSAL_HAS_DRAG,
    DMI_PROPOSAL_SLIDE_SPEED,   /* root mean square speed along the contact normals when sliding with the drag */
    DMI_PROPOSAL_TURN_SPEED,    /* the same with the best rotation about the grabbed point */
    DMI_PROPOSAL_DRAG_LONGEST,  /* |cosine| of the drag with the longest axis */
    DMI_PROPOSAL_DRAG_SHORTEST, /* |cosine| of the drag with the shortest axis */
    /* shape */
    DMI_PROPOSAL_LOG_LENGTH,  /* ln(longest side of the box) */
    DMI_PROPOSAL_WIDTH,       /* second side / longest side */
    DMI_PROPOSAL_THICKNESS,   /* third side / longest side */
    DMI_PROPOSAL_BOX_AREA,    /* part's area / surface of the box, clamped */
    DMI_PROPOSAL_REST_IN_BOX, /* the rest's samples in the box, per sample, clamped */
    DMI_PROPOSAL_RADIUS,      /* dmi_proposal_box's */
    DMI_PROPOSAL_LOG_RADIUS,
    DMI_PROPOSAL_CONTACT_DISTANCE, /* mean, in contact distances */
    DMI_PROPOSAL_LOG_MESH_PIECES,  /* ln(number of pieces of the mesh) */
    /* what remains */
    DMI_PROPOSAL_DETACHED_AREA,   /* components of the rest that touch the part, the largest excepted; share, clamped */
    DMI_PROPOSAL_REPEATS_OUTSIDE, /* share of the pieces with a repeat outside the part */
    DMI_PROPOSAL_REPEATS_INSIDE,  /* share of the pieces with a repeat inside the part */
    DMI_PROPOSAL_SHEET_AREA,      /* the seed's sheet, share of the mesh's area */
    DMI_PROPOSAL_SHEET_TAKEN,     /* share of that sheet that is in the part */
    /* grabbed point: its distance from the centre along each axis, in half sides, clamped */
    DMI_PROPOSAL_GRAB,
    /* dmi_proposal_box_symmetry's */
    DMI_PROPOSAL_SYMMETRY = DMI_PROPOSAL_GRAB + 3,
    /* the piece that would join next; zeros: none */
    DMI_PROPOSAL_NEXT_IN_BOX = DMI_PROPOSAL_SYMMETRY + 3, /* share of its samples in the part's box */
    DMI_PROPOSAL_IN_NEXT_BOX,                             /* the part's samples in its box, per sample */
    DMI_PROPOSAL_LOG_NEXT_AREA,                           /* ln(its area / the part's), clamped */
    DMI_PROPOSAL_NEXT_CONTACTS,                           /* share of its samples in contact with the part */
    DMI_PROPOSAL_NEXT_REPEATS,                            /* 1: a piece of the part has its area */
    /* the rest of the growth */
    DMI_PROPOSAL_ENCLOSED_AREA, /* pieces mostly in the box, the largest component's excepted; share, clamped */
    DMI_PROPOSAL_LATER_ODDS,    /* dmi_proposal's, clamped */
    DMI_PROPOSAL_GROWTH_AREA,   /* area / final area of the growth */
    DMI_PROPOSAL_LOG_LIKELY,    /* ln(1 + number of likely neighbours) */
    DMI_PROPOSAL_LIKELY_AREA,   /* share of the likely neighbours, clamped */
    DMI_PROPOSAL_FEATURES
};

/* ---- proposals ---- */

#define DMI_MAX_PROPOSALS 64 /* set by hand */

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

/* Fills the proposals' features. Scratch memory comes from the arena. */
dm_result dmi_proposals_measure(dmi_arena* arena, const dmi_grab* grab, dmi_proposals* proposals);

#endif
