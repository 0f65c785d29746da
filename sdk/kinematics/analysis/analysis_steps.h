/* The steps of dmi_part_analysis_make that have files of their own. Each fills a part of the analysis. */
#ifndef DMI_ANALYSIS_ANALYSIS_STEPS_H
#define DMI_ANALYSIS_ANALYSIS_STEPS_H

#include "kinematics/analysis/part_analysis.h"
#include "math/linear3.h"

/* near_samples.c: samples the body in the box low .. high. moving: 1 for the parts that move. */
dm_result dmi_analysis_find_near(dmi_arena* arena, const uint8_t* moving, const dmi_cloud* cloud, const float low[3],
                                 const float high[3], dmi_part_analysis* analysis);

/* contacts.c: gaps, contact regions, and the slippage of the part and of the regions. */
dm_result dmi_analysis_find_contacts(dmi_arena* arena, dmi_part_analysis* analysis);
dm_result dmi_analysis_find_slippage(dmi_arena* arena, dmi_part_analysis* analysis);

/* protrusions.c: points with the widest gaps, the body's side of the box, points that protrude from it. */
dm_result dmi_analysis_find_protrusions(dmi_arena* arena, dmi_part_analysis* analysis);

/* twin.c: has_twin and twin_way. */
void dmi_analysis_find_twin(dmi_part_analysis* analysis);

/* clearance.c: clearance, from the body's faces in the box low .. high. moving[f]: 1 for the faces of the part. */
void dmi_analysis_find_clearance(const uint8_t* moving, const float low[3], const float high[3],
                                 dmi_part_analysis* analysis);

/* patches.c: shells and smooth regions of the part and of the body in the box low .. high. moving[f]: 1 for the faces
 * of the part. */
dm_result dmi_analysis_find_patches(dmi_arena* arena, const uint8_t* moving, const float low[3], const float high[3],
                                    const uint32_t* welded, dmi_part_analysis* analysis);

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
