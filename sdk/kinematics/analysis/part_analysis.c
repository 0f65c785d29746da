/* Analyses a part in steps; those of one idea each are in files of their own. */
#include "kinematics/analysis/part_analysis.h"

#include "base/progress_stages.h"
#include "kinematics/analysis/analysis_steps.h"
#include "math/elementary.h"
#include "math/linear3.h"
#include "math/place_hash.h"
#include "mesh/surface_samples.h"

#define MAX_VERTICES 32768    /* most vertices of the part; of more, about every n-th is used, by its place; by hand */
#define MIN_DIAGONAL 1e-5f    /* object sizes: avoids a division by zero */
#define MIN_PART_AREA 1e-12   /* object sizes squared: avoids a division by zero */
#define NEAR_MARGIN 0.6f      /* margin of the near box, in longest sides of the part; by hand */
#define MIN_NEAR_MARGIN 0.02f /* object sizes; by hand */
#define BODY_CELLS 88         /* cells along the body grid's longest side: collisions need so many; by hand */
#define PART_CELLS 56         /* cells along the part grid's longest side; by hand */
#define PART_MARGIN 0.05f     /* margin of the part's distance grid, in part diagonals; by hand */
#define NEAR_POINTS 8192      /* a power of two; by hand */
#define MIN_NEAR_AREA 1e-9    /* object sizes squared: less counts as none; by hand */
#define NEAR_SEED 91          /* arbitrary */

/* Returns 1 for the parts that move with one, NULL without memory. */
static uint8_t* mark_parts(dmi_arena* arena, const dmi_mesh* mesh, uint32_t part) {
    uint8_t* moving = dmi_arena_push(arena, mesh->part_count);
    for (uint32_t p = 0; p < mesh->part_count && moving != NULL; p++)
        moving[p] = dmi_mesh_moves_with(mesh, p, part) != 0;
    return moving;
}

/* Returns 1 for the faces of the moving parts, NULL without memory. */
static uint8_t* mark_faces(dmi_arena* arena, const dmi_mesh* mesh, const uint8_t* moving_parts) {
    uint8_t* moving = dmi_arena_push(arena, mesh->face_count);
    for (uint32_t f = 0; f < mesh->face_count && moving != NULL; f++) moving[f] = moving_parts[mesh->face_part[f]];
    return moving;
}

/* Marks the vertices of the part's faces. Returns their number. */
static uint32_t mark_vertices(const dmi_mesh* mesh, const uint8_t* moving, uint8_t* used) {
    uint32_t total = 0;
    memset(used, 0, mesh->vertex_count);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (!moving[f] || mesh->face_area[f] <= 0) continue;
        for (int k = 0; k < 3; k++) {
            uint32_t v = mesh->indices[3 * f + (uint32_t)k];
            total += !used[v];
            used[v] = 1;
        }
    }
    return total;
}

/* Returns the part's vertices, thinned to about MAX_VERTICES, and sets the box of all of them. NULL: no memory. */
static float (*part_vertices(dmi_arena* arena, const uint8_t* moving, dmi_part_analysis* analysis,
                             uint32_t* out_count))[3] {
    const dmi_mesh* mesh = analysis->mesh;
    uint8_t* used = dmi_arena_push(arena, mesh->vertex_count);
    if (used == NULL) return NULL;
    const uint32_t total = mark_vertices(mesh, moving, used), step = total / MAX_VERTICES + 1;
    float(*out)[3] = dmi_arena_push(arena, sizeof *out * (total + (size_t)1));
    if (out == NULL) return NULL;
    *out_count = 0;
    dmi_analysis_empty_box(analysis->low, analysis->high);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        if (!used[v]) continue;
        dmi_analysis_extend_box(mesh->positions + 3 * (size_t)v, analysis->low, analysis->high);
        const float* at = mesh->positions + 3 * (size_t)v;
        if (step == 1 || dmi_hash_place(at) % step == 0) dmi_copy3(at, out[(*out_count)++]);
    }
    return out;
}

static void add_cloud(const dmi_cloud* cloud, dmi_part_analysis* analysis) {
    const size_t size = sizeof(float[3]) * DMI_CLOUD_NEAR;
    memcpy(analysis->near_points, cloud->xyz + DMI_CLOUD_PART, size);
    memcpy(analysis->near_normals, cloud->normal + DMI_CLOUD_PART, size);
    analysis->near_count = DMI_CLOUD_NEAR;
}

/* Samples the body in the box low .. high evenly. moving: 1 for the parts that move. */
static dm_result find_near(dmi_arena* arena, const uint8_t* moving, const dmi_cloud* cloud, const float low[3],
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

static dm_result make_grids(dmi_arena* arena, const float low[3], const float high[3], dmi_part_analysis* analysis) {
    dm_result result = dmi_distance_grid_make(arena, (const float(*)[3])analysis->near_points, analysis->near_count,
                                              low, high, BODY_CELLS, &analysis->body_grid);
    if (result != DM_OK) return result;
    float margin = PART_MARGIN * analysis->diagonal, part_low[3], part_high[3];
    for (int k = 0; k < 3; k++) {
        part_low[k] = analysis->low[k] - margin;
        part_high[k] = analysis->high[k] + margin;
    }
    return dmi_distance_grid_make(arena, analysis->points, DMI_ANALYSIS_POINTS, part_low, part_high, PART_CELLS,
                                  &analysis->part_grid);
}

/* Computes principal directions and normal clusters, and from them extreme points and the box. */
static void find_directions(const float (*vertices)[3], uint32_t vertex_count, dmi_part_analysis* analysis) {
    double variances[3];
    dmi_principal3(analysis->points, DMI_ANALYSIS_POINTS, analysis->centre, variances, analysis->part_directions);
    float(*all)[3] = analysis->near_points, mean[3];
    dmi_principal3((const float(*)[3])all, analysis->near_count, mean, variances, analysis->all_directions);
    analysis->part_cluster_count = dmi_normal_clusters_find(analysis->normals, DMI_ANALYSIS_POINTS,
                                                            DMI_MAX_NORMAL_CLUSTERS, analysis->part_clusters);
    analysis->near_cluster_count =
        dmi_normal_clusters_find((const float(*)[3])analysis->near_normals, analysis->near_count,
                                 DMI_MAX_NORMAL_CLUSTERS, analysis->near_clusters);
    float directions[3 + 2 * DMI_MAX_NORMAL_CLUSTERS][3];
    uint32_t count = 0;
    for (int i = 0; i < 3; i++) dmi_copy3(analysis->part_directions[i], directions[count++]);
    for (uint32_t i = 0; i < analysis->part_cluster_count; i++)
        dmi_copy3(analysis->part_clusters[i].direction, directions[count++]);
    uint32_t box_directions = count;
    for (uint32_t i = 0; i < analysis->near_cluster_count; i++)
        dmi_copy3(analysis->near_clusters[i].direction, directions[count++]);
    analysis->extreme_point_count =
        dmi_extreme_points(vertices, vertex_count, (const float(*)[3])directions, count, analysis->extreme_points);
    dmi_min_volume_box((const float(*)[3])analysis->extreme_points, analysis->extreme_point_count,
                       (const float(*)[3])directions, box_directions, &analysis->box);
}

static float area_ratio(const dmi_mesh* mesh, const uint8_t* moving) {
    double part = 0, rest = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (moving[f])
            part += mesh->face_area[f];
        else
            rest += mesh->face_area[f];
    }
    return (float)(rest / dmi_fmax(part, MIN_PART_AREA));
}

void dmi_part_near_box(const float low[3], const float high[3], float out_low[3], float out_high[3]) {
    float side = 0;
    for (int k = 0; k < 3; k++) side = dmi_max(side, high[k] - low[k]);
    const float margin = dmi_max(NEAR_MARGIN * side, MIN_NEAR_MARGIN);
    for (int k = 0; k < 3; k++) out_low[k] = low[k] - margin, out_high[k] = high[k] + margin;
}

dm_result dmi_part_analysis_make(dmi_arena* arena, const dmi_mesh* mesh, const dmi_cloud* cloud, uint32_t part,
                                 const uint32_t* welded, const dmi_progress* progress, dmi_part_analysis* out) {
    *out = (dmi_part_analysis){.mesh = mesh,
                               .part = part,
                               .points = (const float(*)[3])cloud->xyz,
                               .normals = (const float(*)[3])cloud->normal};
    const uint8_t* moving_parts = mark_parts(arena, mesh, part);
    const uint8_t* moving = moving_parts != NULL ? mark_faces(arena, mesh, moving_parts) : NULL;
    uint32_t vertex_count;
    float(*vertices)[3] = moving != NULL ? part_vertices(arena, moving, out, &vertex_count) : NULL;
    if (vertices == NULL) return DM_ERROR_OUT_OF_MEMORY;
    float low[3], high[3];
    dmi_part_near_box(out->low, out->high, low, high);
    out->diagonal = dmi_max(dmi_distance3(out->low, out->high), MIN_DIAGONAL);
    out->area_ratio = area_ratio(mesh, moving);

    dm_result result = dmi_progress_tell(progress, DMI_STAGE_ANALYSE_VERTICES_TAKEN);
    if (result == DM_OK) result = find_near(arena, moving_parts, cloud, low, high, out);
    if (result == DM_OK) result = make_grids(arena, low, high, out);
    if (result == DM_OK) result = dmi_analysis_find_contacts(arena, out);
    if (result != DM_OK) return result;
    find_directions((const float(*)[3])vertices, vertex_count, out);
    result = dmi_analysis_find_slippage(arena, out);
    if (result == DM_OK) result = dmi_analysis_find_protrusions(arena, out);
    if (result == DM_OK) result = dmi_progress_tell(progress, DMI_STAGE_ANALYSE_MEASURED);
    if (result != DM_OK) return result;
    dmi_analysis_find_twin(out);
    dmi_analysis_find_clearance(moving, low, high, out);
    out->object_extreme_point_count =
        dmi_extreme_points((const float(*)[3])cloud->xyz, DMI_CLOUD_POINTS, (const float(*)[3])out->box.axes, 3,
                           out->object_extreme_points);
    return dmi_analysis_find_patches(arena, moving, low, high, welded, out);
}
