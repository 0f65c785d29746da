/* Samples the body near a part evenly. */
#include "kinematics/analysis/analysis_steps.h"
#include "mesh/surface_samples.h"

#define NEAR_POINTS 8192   /* a power of two; by hand */
#define MIN_NEAR_AREA 1e-9 /* object sizes squared: less counts as none; by hand */
#define NEAR_SEED 91       /* arbitrary */

static void add_cloud(const dmi_cloud* cloud, dmi_part_analysis* analysis) {
    const size_t size = sizeof(float[3]) * DMI_CLOUD_NEAR;
    memcpy(analysis->near_points, cloud->xyz + DMI_CLOUD_PART, size);
    memcpy(analysis->near_normals, cloud->normal + DMI_CLOUD_PART, size);
    analysis->near_count = DMI_CLOUD_NEAR;
}

dm_result dmi_analysis_find_near(dmi_arena* arena, const uint8_t* moving, const dmi_cloud* cloud, const float low[3],
                                 const float high[3], dmi_part_analysis* analysis) {
    const dmi_mesh* mesh = analysis->mesh;
    analysis->near_points = dmi_arena_push(arena, sizeof(float[3]) * NEAR_POINTS);
    analysis->near_normals = dmi_arena_push(arena, sizeof(float[3]) * NEAR_POINTS);
    uint8_t* stays = dmi_arena_push(arena, mesh->part_count);
    if (analysis->near_points == NULL || analysis->near_normals == NULL || stays == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t p = 0; p < mesh->part_count; p++) stays[p] = !moving[p];
    dmi_bounds box;
    dmi_copy3(low, box.low), dmi_copy3(high, box.high);
    const double area = dmi_area_inside(mesh, stays, &box);
    if (area > MIN_NEAR_AREA) {
        analysis->near_count = NEAR_POINTS;
        const dmi_surface surface = {mesh, stays, &box, area};
        return dmi_surface_sample(arena->env, &surface, NEAR_SEED + analysis->part, NEAR_POINTS, analysis->near_points,
                                  analysis->near_normals);
    }
    if (analysis->area_ratio > 0) add_cloud(cloud, analysis);
    return DM_OK;
}
