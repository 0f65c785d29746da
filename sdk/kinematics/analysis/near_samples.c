/* Samples the body near a part in proportion to area. */
#include "base/random.h"
#include "kinematics/analysis/analysis_steps.h"

#define MAX_TRIES 32768     /* samples drawn, those outside the box included; by hand */
#define MIN_NEAR_POINTS 256 /* fewest samples: where there are fewer, the cloud's near points are added; by hand */
#define RANDOM_STREAM 91    /* stream of the samples' random numbers; arbitrary */
#define GUIDE_ENTRIES 4096  /* entries of the table that speeds up the search; by hand */

/* Lists the body's faces whose boxes overlap low .. high, with cumulated areas. Returns their number. */
static uint32_t list_faces(const dmi_mesh* mesh, const uint8_t* moving, const float low[3], const float high[3],
                           uint32_t* out_faces, float* out_area) {
    uint32_t count = 0;
    double total = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (moving[f] || mesh->face_area[f] <= 0) continue;
        bool overlaps = true;
        for (int k = 0; k < 3; k++) {
            float a = mesh->positions[3 * (size_t)mesh->indices[3 * (size_t)f] + (size_t)k];
            float b = mesh->positions[3 * (size_t)mesh->indices[3 * (size_t)f + 1] + (size_t)k];
            float c = mesh->positions[3 * (size_t)mesh->indices[3 * (size_t)f + 2] + (size_t)k];
            overlaps &= dmi_min(a, dmi_min(b, c)) <= high[k] && dmi_max(a, dmi_max(b, c)) >= low[k];
        }
        if (!overlaps) continue;
        total += mesh->face_area[f];
        out_faces[count] = f, out_area[count++] = (float)total;
    }
    return count;
}

/* Sets guide[g] to the first face whose cumulated area reaches g / GUIDE_ENTRIES of the total. */
static void make_guide(const float* area, uint32_t count, uint32_t guide[GUIDE_ENTRIES]) {
    uint32_t face = 0;
    for (uint32_t g = 0; g < GUIDE_ENTRIES; g++) {
        while (face + 1 < count && area[face] < area[count - 1] * ((float)g / GUIDE_ENTRIES)) face++;
        guide[g] = face;
    }
}

/* Returns the first face whose cumulated area reaches a share, in [0, 1), of the total. */
static uint32_t find_face(const float* area, uint32_t count, const uint32_t guide[GUIDE_ENTRIES], float share) {
    const float at = share * area[count - 1];
    uint32_t face = guide[(uint32_t)(share * GUIDE_ENTRIES)];
    while (face > 0 && area[face - 1] >= at) face--;
    while (face + 1 < count && area[face] < at) face++;
    return face;
}

/* Draws a uniformly distributed point of the face. Returns whether it lies in the box. */
static bool sample_face(const dmi_mesh* mesh, uint32_t f, dmi_random* random, const float low[3], const float high[3],
                        float out[3]) {
    float r = sqrtf(dmi_random_unit(random)), s = dmi_random_unit(random);
    const float* a = mesh->positions + 3 * (size_t)mesh->indices[3 * (size_t)f];
    const float* b = mesh->positions + 3 * (size_t)mesh->indices[3 * (size_t)f + 1];
    const float* c = mesh->positions + 3 * (size_t)mesh->indices[3 * (size_t)f + 2];
    bool inside = true;
    for (int k = 0; k < 3; k++) {
        out[k] = (1 - r) * a[k] + r * (1 - s) * b[k] + r * s * c[k];
        inside &= out[k] >= low[k] && out[k] <= high[k];
    }
    return inside;
}

/* Draws samples of the listed faces in proportion to area, and keeps those in the box. */
static void sample_faces(const uint32_t* faces, const float* area, uint32_t count, const float low[3],
                         const float high[3], dmi_part_analysis* analysis) {
    const dmi_mesh* mesh = analysis->mesh;
    dmi_random random = dmi_random_make(analysis->part, RANDOM_STREAM);
    uint32_t guide[GUIDE_ENTRIES];
    make_guide(area, count, guide);
    for (uint32_t t = 0; t < MAX_TRIES && analysis->near_count < DMI_ANALYSIS_NEAR_POINTS; t++) {
        uint32_t f = faces[find_face(area, count, guide, dmi_random_unit(&random))];
        float x[3];
        if (!sample_face(mesh, f, &random, low, high, x)) continue;
        dmi_copy3(x, analysis->near_points[analysis->near_count]);
        dmi_copy3(mesh->face_normal + 3 * (size_t)f, analysis->near_normals[analysis->near_count++]);
    }
}

static void add_cloud(const dmi_cloud* cloud, dmi_part_analysis* analysis) {
    const size_t size = sizeof(float[3]) * DMI_CLOUD_NEAR;
    memcpy(analysis->near_points + analysis->near_count, cloud->xyz + DMI_CLOUD_PART, size);
    memcpy(analysis->near_normals + analysis->near_count, cloud->normal + DMI_CLOUD_PART, size);
    analysis->near_count += DMI_CLOUD_NEAR;
}

dm_result dmi_analysis_find_near(dmi_arena* arena, const uint8_t* moving, const dmi_cloud* cloud, const float low[3],
                                 const float high[3], dmi_part_analysis* analysis) {
    const dmi_mesh* mesh = analysis->mesh;
    const size_t room = DMI_ANALYSIS_NEAR_POINTS + DMI_CLOUD_NEAR;
    uint32_t* faces = dmi_arena_push(arena, sizeof *faces * mesh->face_count);
    float* area = dmi_arena_push(arena, sizeof *area * mesh->face_count);
    analysis->near_points = dmi_arena_push(arena, sizeof(float[3]) * room);
    analysis->near_normals = dmi_arena_push(arena, sizeof(float[3]) * room);
    if (faces == NULL || area == NULL || analysis->near_points == NULL || analysis->near_normals == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    uint32_t count = list_faces(mesh, moving, low, high, faces, area);
    if (count > 0) sample_faces(faces, area, count, low, high, analysis);
    const bool has_body = analysis->area_ratio > 0;
    if (has_body && analysis->near_count < MIN_NEAR_POINTS) add_cloud(cloud, analysis);
    return DM_OK;
}
