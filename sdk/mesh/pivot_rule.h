/* Whether the pivots of an asset's nodes follow one rule, as programs set them that nobody told where a part turns: all
 * in the middle of their boxes, at their lowest corners, at one point of the scene. Such a pivot says nothing. The
 * parts of a mesh are measured about their pivots for that. */
#ifndef DMI_MESH_PIVOT_RULE_H
#define DMI_MESH_PIVOT_RULE_H

#include <stdbool.h>
#include <stdint.h>

#include "mesh/mesh.h"

/* Places of a box on which each coordinate is at the low end, in the middle or at the high end. */
#define DMI_BOX_PLACES 27
#define DMI_PIVOT_LEAST_SHAPES 3 /* parts of different shapes that make a rule without the body; by hand */

/* The measures of one node that tell which rules its pivot follows. Fill it face by face. */
typedef struct dmi_pivot_gauge {
    double origin[3];
    double axes[3][3];            /* unit rows; those of the scene where the node's are unknown */
    double scale[3];              /* lengths that they had */
    double low[2][3], high[2][3]; /* box of the faces about the origin: along the node's axes, then along the scene's */
    double area, moment[3];       /* sums over the faces: area, and area times the middle */
    double volume, volume_moment[3];
    uint32_t face_count;
} dmi_pivot_gauge;

/* axes: three rows of any length; rows without a length stand for the scene's axes. */
void dmi_pivot_gauge_begin(const double origin[3], const float axes[9], dmi_pivot_gauge* out);
void dmi_pivot_gauge_add_face(dmi_pivot_gauge* gauge, const double corners[3][3]);

/* What is compared of a node. */
typedef struct dmi_pivot_witness {
    uint64_t rules; /* a bit for each rule that its pivot follows */
    double origin[3];
    double sides[3];      /* sides of the node's box along the scene's axes */
    double mesh_sides[3]; /* sides along its own axes, as its mesh has them: without the node's scale */
    uint32_t face_count;
    double area; /* 0: it has no faces or no pivot, and does not count */
} dmi_pivot_witness;

dmi_pivot_witness dmi_pivot_gauge_finish(const dmi_pivot_gauge* gauge);

typedef enum dmi_pivot_kind {
    DMI_PIVOT_UNJUDGED, /* no rule is known */
    DMI_PIVOT_UNSET,    /* it follows the rule of the asset's nodes, and says nothing */
    DMI_PIVOT_SET       /* it breaks that rule: somebody has set it */
} dmi_pivot_kind;

/* Judges the pivots of all nodes of an asset, the body's among them. A rule holds where the node with the largest
 * surface follows it and more than half of the nodes do, not all of them copies of one mesh: what one artist has put on
 * a hinge is there in each copy. */
void dmi_pivots_judge(const dmi_pivot_witness* nodes, uint32_t count, dmi_pivot_kind* out);
/* Returns whether the pivots of an object's parts follow one rule, where that of the body is not known: all of three or
 * more of different shapes, and, where the rule is an edge or corner, in boxes that stretch different ways. Doors of
 * one row have their hinges on the same edge. */
bool dmi_part_pivots_follow_rule(const dmi_pivot_witness* parts, uint32_t count);

/* ---- pivots of parts ---- */

/* pivots: one a part of the mesh, host frame; NULL: it has none, and does not count. scratch: one a part. */
void dmi_part_pivots_measure(const dmi_mesh* mesh, const dm_pivot* const* pivots, dmi_pivot_gauge* scratch,
                             dmi_pivot_witness* out);

#endif
