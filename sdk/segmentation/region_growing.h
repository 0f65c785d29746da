/* Region growing: a part grows from a seed piece; features of its neighbours rate whether they belong to it. */
#ifndef DMI_SEGMENTATION_REGION_GROWING_H
#define DMI_SEGMENTATION_REGION_GROWING_H

#include "segmentation/pieces.h"
#include "segmentation/region_contacts.h"

/* Features of a piece that is in contact with the region, inputs of the growth network. "Share" is in 0 .. 1; lengths
 * are object-normalised. */
enum {
    /* contacts, in numbers of samples */
    DMI_NEIGHBOUR_CONTACT_SHARE,    /* share with the region, of the piece's contacts with anything */
    DMI_NEIGHBOUR_REGION_CONTACTS,  /* those with the region, per sample of the piece */
    DMI_NEIGHBOUR_OTHER_CONTACTS,   /* those with other pieces, per sample of the piece */
    DMI_NEIGHBOUR_COVERED_REGION,   /* share of the region's samples in contact with the piece */
    DMI_NEIGHBOUR_FLUSH,            /* share of the contacts with the region; see dmi_contact_kind */
    DMI_NEIGHBOUR_STACKED,          /* likewise */
    DMI_NEIGHBOUR_CONTACT_DISTANCE, /* mean, in contact distances */
    /* size */
    DMI_NEIGHBOUR_LOG_AREA_RATIO, /* ln(piece / region) */
    DMI_NEIGHBOUR_AREA,           /* share of the mesh's area */
    DMI_NEIGHBOUR_REGION_AREA,    /* share of the mesh's area */
    DMI_NEIGHBOUR_RADIUS,         /* root mean square distance of the piece's surface from its centre */
    DMI_NEIGHBOUR_REGION_RADIUS,
    DMI_NEIGHBOUR_LOG_RADIUS_GROWTH, /* ln(radius of both together / radius of the region) */
    DMI_NEIGHBOUR_SAME_SHELL,        /* 1: some piece of the region is of the same shell */
    /* drag; all along the drag's direction */
    DMI_NEIGHBOUR_HAS_DRAG,
    DMI_NEIGHBOUR_NORMAL_COSINE,        /* mean |cosine| of the piece's normals with the drag */
    DMI_NEIGHBOUR_REGION_NORMAL_COSINE, /* the same of the region */
    DMI_NEIGHBOUR_EXCESS_AHEAD,         /* how far the piece extends beyond the region, ahead */
    DMI_NEIGHBOUR_EXCESS_BEHIND,        /* and behind */
    DMI_NEIGHBOUR_OFFSET_ALONG,         /* distance of the piece's centre from the region's */
    DMI_NEIGHBOUR_REGION_EXTENT,
    DMI_NEIGHBOUR_EXTENT,
    DMI_NEIGHBOUR_OFFSET_ACROSS,  /* distance of the centres, perpendicular to the drag */
    DMI_NEIGHBOUR_STACKED_AHEAD,  /* share of the contacts with the region */
    DMI_NEIGHBOUR_STACKED_BEHIND, /* likewise */
    /* relation to the region */
    DMI_NEIGHBOUR_REGION_IS_SEED, /* 1: the region is a single piece */
    DMI_NEIGHBOUR_CONCAVE,        /* share of the contacts with the region */
    DMI_NEIGHBOUR_CONVEX,         /* likewise */
    DMI_NEIGHBOUR_SAME_SHEET,     /* 1: some piece of the region is of the same sheet */
    DMI_NEIGHBOUR_REPEAT,         /* 1: some piece of the region has the same area */
    DMI_NEIGHBOUR_SHEET_IS_CUT,   /* the piece level's */
    DMI_NEIGHBOUR_FEATURES
};

typedef struct dmi_region {
    const dmi_piece_level* level;
    float drag[3];                             /* unit; zeros: none */
    uint8_t* inside;                           /* per piece: 1 in the region */
    uint8_t *shell_inside, *sheet_inside;      /* per shell, sheet: 1 if a piece of it is in the region */
    uint32_t* neighbours;                      /* pieces outside the region that are in contact with it */
    float (*features)[DMI_NEIGHBOUR_FEATURES]; /* per neighbour, in the same order */
    uint32_t neighbour_count;
    uint32_t piece_count; /* pieces of the region */
    dmi_region_contacts contacts;
    struct dmi_piece_extent* extents; /* per piece */
} dmi_region;

/* Makes an empty region. All memory comes from the arena. drag: unit, or zeros: none. */
dm_result dmi_region_make(dmi_arena* arena, const dmi_piece_level* level, const float drag[3], dmi_region* out);
void dmi_region_add(dmi_region* region, uint32_t piece);
/* Finds the region's neighbours and computes their features. */
void dmi_region_find_neighbours(dmi_region* region);

#endif
