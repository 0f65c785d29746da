/* Everything measured about one part and its surroundings before any joint is thought of: box, symmetry directions,
 * contact regions, patches, distance grids. Independent of a drag. */
#ifndef DMI_ANALYSIS_PART_ANALYSIS_H
#define DMI_ANALYSIS_PART_ANALYSIS_H

#include "base/arena.h"
#include "kinematics/analysis/distance_grid.h"
#include "kinematics/analysis/shape.h"
#include "mesh/cloud.h"

#define DMI_ANALYSIS_POINTS 2048       /* surface points of the part: the cloud's part block */
#define DMI_ANALYSIS_NEAR_POINTS 12288 /* most samples of the body near the part */
#define DMI_CONTACT_REGIONS 3
#define DMI_MAX_PATCHES 24
#define DMI_MAX_NORMAL_CLUSTERS 6

/* Part points close to the body, by three notions of close. */
typedef struct dmi_contact {
    uint32_t* points; /* indices of part points */
    uint32_t count;
    float mean[3], box_centre[3];
    float directions[3][3]; /* principal, largest first */
} dmi_contact;

/* A shell or smooth region of the surface, and the line about which it turns on itself, if it does. */
typedef struct dmi_patch {
    float area, diagonal;
    float centroid[3], box_centre[3];
    float axis[3], point[3], residual; /* residual > 1: no such line */
    int32_t shell;
} dmi_patch;

typedef struct dmi_part_analysis {
    const dmi_mesh* mesh;
    uint32_t part;
    const float (*points)[3]; /* DMI_ANALYSIS_POINTS */
    const float (*normals)[3];
    float* gap;       /* part point -> distance to the body */
    uint32_t* facing; /* part point -> nearest near sample, UINT32_MAX without a body near */
    float (*near_points)[3];
    float (*near_normals)[3];
    uint32_t near_count;
    float low[3], high[3]; /* axis-aligned box of the part */
    float centre[3];       /* mean of its points */
    float diagonal;
    float area_ratio; /* of the body's area to the part's */
    float extremes[DMI_SHAPE_MAX_HULL][3];
    uint32_t extreme_count;
    float outline[DMI_SHAPE_MAX_HULL][3]; /* extremes of the whole object */
    uint32_t outline_count;
    float handle[3], handle_direction[3]; /* mean and longest direction of what stands out farthest from the body */
    float handle_spread;                  /* root mean square distance from its mean; 0: no body near */
    dmi_box box;
    float lean[3]; /* along the box's axes: 1, the body lies down the axis alone; -1, up the axis; 0, on both sides
                      alike */
    float grip[3], grip_direction[3]; /* mean and longest direction of what stands proud of the box's outer face */
    float grip_spread, grip_share;    /* root mean square distance from the mean; share of the points, 0: none */
    float part_directions[3][3], all_directions[3][3];
    dmi_normal_cluster part_clusters[DMI_MAX_NORMAL_CLUSTERS], near_clusters[DMI_MAX_NORMAL_CLUSTERS];
    uint32_t part_cluster_count, near_cluster_count;
    dmi_contact contacts[DMI_CONTACT_REGIONS];
    dmi_slippage slippage[1 + 2 * DMI_CONTACT_REGIONS]; /* of the part; of a contact's part side and body side */
    int32_t has_slippage[1 + 2 * DMI_CONTACT_REGIONS];
    dmi_patch part_patches[DMI_MAX_PATCHES], near_patches[DMI_MAX_PATCHES];
    uint32_t part_patch_count, near_patch_count;
    dmi_distance_grid body_field, part_field;
} dmi_part_analysis;

#define DMI_WELD_TOLERANCE 1e-5f /* tolerance */

/* Everything lives in the arena. welded: from dmi_weld_vertices with the tolerance above, or NULL to weld here. */
dm_result dmi_part_analysis_make(dmi_arena* arena, const dmi_mesh* mesh, const dmi_cloud* cloud, uint32_t part,
                                 const uint32_t* welded, dmi_part_analysis* out);

/* study_patches.c: shells and smooth regions of the part and of the body near it. */
dm_result dmi_part_analysis_patches(dmi_arena* arena, const uint8_t* moving, const float low[3], const float high[3],
                                    const uint32_t* welded, dmi_part_analysis* study);

#endif
