/* The steps of dmi_part_analysis_make that have files of their own, and what they measure with. Each step fills a part
 * of the analysis. */
#ifndef DMI_ANALYSIS_ANALYSIS_STEPS_H
#define DMI_ANALYSIS_ANALYSIS_STEPS_H

#include "kinematics/analysis/part_analysis.h"
#include "math/linear3.h"

/* contacts.c: gaps, contact regions, and the slippage of the part and of the regions. */
dm_result dmi_analysis_find_contacts(dmi_arena* arena, dmi_part_analysis* analysis);
dm_result dmi_analysis_find_slippage(dmi_arena* arena, dmi_part_analysis* analysis);

/* protrusions.c: points with the widest gaps, the body's side of the box, points that protrude from it. */
dm_result dmi_analysis_find_protrusions(dmi_arena* arena, dmi_part_analysis* analysis);

/* twin.c: has_twin, twin_way and leaf_side. */
void dmi_analysis_find_twin(dmi_part_analysis* analysis);

/* clearance.c: clearance, from the body's faces in the box low .. high. moving[f]: 1 for the faces of the part. */
void dmi_analysis_find_clearance(const uint8_t* moving, const float low[3], const float high[3],
                                 dmi_part_analysis* analysis);

/* patches.c: shells and smooth regions of the part and of the body in the box low .. high. moving[f]: 1 for the faces
 * of the part. */
dm_result dmi_analysis_find_patches(dmi_arena* arena, const uint8_t* moving, const float low[3], const float high[3],
                                    const uint32_t* welded, dmi_part_analysis* analysis);

/* ---- what the steps measure with ---- */

/* extreme_points.c: computes the points that are farthest along, or against, fixed directions over the half sphere and
 * the unit `extra` ones: an approximate convex hull. Returns their number, at most DMI_MAX_HULL_POINTS. */
uint32_t dmi_extreme_points(const float (*points)[3], uint32_t count, const float (*extra)[3], uint32_t extra_count,
                            float (*out)[3]);

/* normal_clusters.c: finds the directions that many of the unit normals are parallel to, regardless of sign, most
 * frequent first. Returns their number, at most max_clusters. */
uint32_t dmi_normal_clusters_find(const float (*normals)[3], uint32_t count, uint32_t max_clusters,
                                  dmi_normal_cluster* out);

/* slippage.c: computes the slippage of a surface. weights: of its samples; NULL: all equal. */
void dmi_slippage_compute(const float (*points)[3], const float (*normals)[3], const float* weights, uint32_t count,
                          dmi_slippage* out);

/* patch_faces.c: the faces of the part, or of the body near it, copied out of the mesh with vertices numbered anew. */
typedef struct dmi_patch_faces {
    dmi_mesh mesh;       /* has no positions; its indices are those of welded vertices */
    float (*corners)[3]; /* positions of the three corners of each face */
    float* gap;          /* least of a face's corners to the other side; object-normalised */
} dmi_patch_faces;

/* Copies the faces, the largest ones when there are very many. Overwrites `faces`. other_grid: distance grid of the
 * other side. The copy costs as much as there are faces, whatever the size of the mesh. */
dm_result dmi_patch_faces_make(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, uint32_t* faces,
                               uint32_t count, const dmi_distance_grid* other_grid, dmi_patch_faces* out);

static inline void dmi_analysis_empty_box(float low[3], float high[3]) {
    for (int k = 0; k < 3; k++) low[k] = INFINITY, high[k] = -INFINITY;
}

static inline void dmi_analysis_extend_box(const float point[3], float low[3], float high[3]) {
    for (int k = 0; k < 3; k++) {
        low[k] = dmi_min(low[k], point[k]);
        high[k] = dmi_max(high[k], point[k]);
    }
}

#endif
