/* Geometric analysis of one part and the body near it: box, directions, contact regions, patches, distance grids. It is
 * independent of a drag and of candidate joints. All coordinates are object-normalised. */
#ifndef DMI_ANALYSIS_PART_ANALYSIS_H
#define DMI_ANALYSIS_PART_ANALYSIS_H

#include <stdbool.h>

#include "base/arena.h"
#include "kinematics/analysis/bounding_box.h"
#include "kinematics/analysis/distance_grid.h"
#include "mesh/cloud.h"

#define DMI_ANALYSIS_POINTS 2048  /* surface points of the part: the cloud's part block */
#define DMI_CONTACT_REGIONS 3     /* absolute, relative and rank limit of the gap, see contacts.c */
#define DMI_MAX_PATCHES 24        /* patches of the part, and of the body near it; by hand */
#define DMI_MAX_NORMAL_CLUSTERS 6 /* clusters of the part, and of the body near it; by hand */
#define DMI_MOST_CLEARANCE 0.5f   /* sides: what lies farther than this is not told apart; by hand */
#define DMI_WELD_TOLERANCE 1e-5f  /* object sizes, of the welded vertices; by hand */

/* A cluster of parallel surface normals. */
typedef struct dmi_normal_cluster {
    float direction[3]; /* unit; its sign is arbitrary */
    float share;        /* share of all normals, 0 .. 1 */
} dmi_normal_cluster;

/* The two rotations and the two translations under which a surface slides along itself best (slippage analysis, Gelfand
 * and Guibas 2004). A residual is the root mean square normal speed of the surface for an angular velocity of 1, in
 * root mean square radii, or a linear velocity of 1; 0: a perfect bearing or rail. */
typedef struct dmi_slippage {
    float turn_axis[2][3], turn_point[2][3], turn_residual[2];
    float slide[2][3], slide_residual[2];
} dmi_slippage;

/* The part's points whose gap is below a limit. */
typedef struct dmi_contact {
    uint32_t* points; /* indices of part points */
    uint32_t count;
    float mean[3], box_centre[3]; /* box_centre: of their axis-aligned box */
    float directions[3][3];       /* principal, largest variance first */
} dmi_contact;

/* A shell or smooth region of the surface, and the axis of its best rotational slippage. */
typedef struct dmi_patch {
    float area, diagonal;
    float centroid[3], box_centre[3];
    float axis[3], point[3], residual; /* the turn's, as dmi_slippage has it; residual > 1: not computed */
    bool is_shell;
} dmi_patch;

typedef struct dmi_part_analysis {
    const dmi_mesh* mesh;
    uint32_t part;
    const float (*points)[3]; /* DMI_ANALYSIS_POINTS */
    const float (*normals)[3];
    float* gap;              /* part point -> distance to the body */
    uint32_t* nearest_near;  /* part point -> nearest of near_points; UINT32_MAX: there are none */
    float (*near_points)[3]; /* samples of the body near the part */
    float (*near_normals)[3];
    uint32_t near_count;
    float low[3], high[3]; /* axis-aligned box of the part's vertices */
    float centre[3];       /* mean of its points */
    float diagonal;        /* diagonal of the axis-aligned box */
    float area_ratio;      /* the body's area / the part's */
    float extreme_points[DMI_MAX_HULL_POINTS][3];
    uint32_t extreme_point_count;
    float object_extreme_points[DMI_MAX_HULL_POINTS][3]; /* extreme points of part and body together */
    uint32_t object_extreme_point_count;
    /* the points with the widest gaps: mean, longest direction, root mean square distance from the mean (0: no body) */
    float widest_gap_mean[3], widest_gap_direction[3];
    float widest_gap_spread;
    dmi_box box;
    float body_side[3]; /* side of the body along each axis of the box: 1, the body lies only in the negative direction;
                         * -1, only in the positive; 0, on both sides alike */
    /* the points that protrude beyond the box's outer face: mean, longest direction, root mean square distance from
     * the mean, share of the points (0: none) */
    float protrusion_mean[3], protrusion_direction[3];
    float protrusion_spread, protrusion_share;
    bool has_twin;     /* the body near the part is nothing but the part's mirror image beside it */
    float twin_way[3]; /* unit, from the part towards its twin; along an axis of the box */
    /* side of the box along its longest and its middle axis beyond which a leaf like the part stands in one frame with
     * it: 1 along the axis, -1 against it, 0 none or both */
    float leaf_side[2];
    /* how far the part may slide along each axis of the box, against it and along it, before the body stands in its
     * way, in sides of the box, at most DMI_MOST_CLEARANCE */
    float clearance[3][2];
    float part_directions[3][3], all_directions[3][3]; /* principal: of the points; of near_points */
    dmi_normal_cluster part_clusters[DMI_MAX_NORMAL_CLUSTERS], near_clusters[DMI_MAX_NORMAL_CLUSTERS];
    uint32_t part_cluster_count, near_cluster_count;
    dmi_contact contacts[DMI_CONTACT_REGIONS];
    dmi_slippage slippage[1 + 2 * DMI_CONTACT_REGIONS]; /* the part's; a contact's part side and body side */
    bool has_slippage[1 + 2 * DMI_CONTACT_REGIONS];
    dmi_patch part_patches[DMI_MAX_PATCHES], near_patches[DMI_MAX_PATCHES];
    uint32_t part_patch_count, near_patch_count;
    dmi_distance_grid body_grid, part_grid;
} dmi_part_analysis;

/* Analyses a part (index in mesh->parts). All memory comes from the arena; mesh and cloud must outlive `out`. welded:
 * from dmi_weld_vertices with DMI_WELD_TOLERANCE; NULL: computed here. */
dm_result dmi_part_analysis_make(dmi_arena* arena, const dmi_mesh* mesh, const dmi_cloud* cloud, uint32_t part,
                                 const uint32_t* welded, const dmi_progress* progress, dmi_part_analysis* out);

/* Grows a part's box to that of its surroundings, which the analysis reads of the body. */
void dmi_part_near_box(const float low[3], const float high[3], float out_low[3], float out_high[3]);

#endif
