/* Samples the surfaces of a part and of the rest, and takes what the motion network reads of the samples. */
#include "mesh/cloud.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/env.h"
#include "base/random.h"
#include "math/elementary.h"
#include "math/linear3.h"
#include "mesh/surface_samples.h"

/* The values are set by hand; networks are trained with them. */
#define NEAR_GROWTH 0.2f                /* growth of the part's box on each side, share of its diagonal … */
#define NEAR_MIN_GROWTH 0.02f           /* … and at least this, share of the object's size */
#define NEAR_MIN_AREA 1e-9              /* share of the object's size squared; less near area counts as none */
#define CANDIDATES (4 * DMI_CLOUD_NEAR) /* samples of which the nearest are taken when none of the rest is near */
typedef struct sampler {
    dmi_env* env;
    const dmi_mesh* mesh;
    dmi_random random;
    uint8_t *moves, *stays; /* a byte a part: moves with the part sampled, or does not */
    double moving, staying; /* areas */
} sampler;

static void measure_areas(sampler* s) {
    s->moving = s->staying = 0;
    for (uint32_t f = 0; f < s->mesh->face_count; f++)
        *(s->moves[s->mesh->face_part[f]] ? &s->moving : &s->staying) += (double)s->mesh->face_area[f];
}

static dm_result sample_block(sampler* s, const uint8_t* wanted, const dmi_bounds* clip, double area, uint32_t count,
                              float (*xyz)[3], float (*normal)[3]) {
    const dmi_surface surface = {s->mesh, wanted, clip, area};
    return dmi_surface_sample(s->env, &surface, dmi_random_u32(&s->random), count, xyz, normal);
}

/* ---- the near block ---- */

/* Returns the grown box of the moving parts. */
static dmi_bounds near_box(const sampler* s) {
    dmi_bounds out = {{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
    for (uint32_t p = 0; p < s->mesh->part_count; p++) {
        const dmi_part* part = &s->mesh->parts[p];
        for (int k = 0; k < 3 && s->moves[p]; k++) {
            out.low[k] = dmi_min(out.low[k], part->box_min[k]);
            out.high[k] = dmi_max(out.high[k], part->box_max[k]);
        }
    }
    float square = 0;
    for (int k = 0; k < 3; k++) square += (out.high[k] - out.low[k]) * (out.high[k] - out.low[k]);
    float growth = dmi_max(NEAR_GROWTH * sqrtf(square), NEAR_MIN_GROWTH);
    for (int k = 0; k < 3; k++) {
        out.low[k] -= growth;
        out.high[k] += growth;
    }
    return out;
}

static float box_distance_squared(const dmi_bounds* box, const float p[3]) {
    float sum = 0;
    for (int k = 0; k < 3; k++) {
        float d = dmi_max(0, dmi_max(box->low[k] - p[k], p[k] - box->high[k]));
        sum += d * d;
    }
    return sum;
}

typedef struct candidates {
    float xyz[CANDIDATES][3], normal[CANDIDATES][3];
    float distance[CANDIDATES];
} candidates;

/* Returns the distance of the DMI_CLOUD_NEAR-th nearest candidate, by bisection on the bits, whose order is that of the
 * values for non-negative floats. */
static float near_limit(const candidates* c) {
    uint32_t low = 0, high = 0x7f800000; /* +infinity */
    while (low < high) {
        uint32_t middle = low + (high - low) / 2, within = 0;
        float limit;
        memcpy(&limit, &middle, sizeof limit);
        for (uint32_t i = 0; i < CANDIDATES; i++) within += c->distance[i] <= limit;
        if (within >= DMI_CLOUD_NEAR)
            high = middle;
        else
            low = middle + 1;
    }
    float limit;
    memcpy(&limit, &high, sizeof limit);
    return limit;
}

/* Fills the near block when none of the rest is near: with its samples nearest to the box. */
static dm_result sample_nearest(sampler* s, const dmi_bounds* near, float (*xyz)[3], float (*normal)[3]) {
    candidates* c = dmi_scratch_alloc(s->env, sizeof *c);
    if (c == NULL) return dmi_fail(s->env, DM_ERROR_OUT_OF_MEMORY, "no memory for %d surface samples", CANDIDATES);
    const dm_result result = sample_block(s, s->stays, NULL, s->staying, CANDIDATES, c->xyz, c->normal);
    for (uint32_t i = 0; i < CANDIDATES; i++) c->distance[i] = box_distance_squared(near, c->xyz[i]);
    float limit = near_limit(c);
    uint32_t taken = 0, ties = DMI_CLOUD_NEAR;
    for (uint32_t i = 0; i < CANDIDATES; i++) ties -= c->distance[i] < limit;
    for (uint32_t i = 0; i < CANDIDATES; i++) {
        if (c->distance[i] > limit || (c->distance[i] == limit && ties == 0)) continue;
        ties -= c->distance[i] == limit;
        memcpy(xyz[taken], c->xyz[i], sizeof c->xyz[i]);
        memcpy(normal[taken++], c->normal[i], sizeof c->normal[i]);
    }
    dmi_scratch_free(s->env, c);
    return result;
}

static dm_result sample_near(sampler* s, float (*xyz)[3], float (*normal)[3]) {
    const dmi_bounds near = near_box(s);
    const double area = dmi_area_inside(s->mesh, s->stays, &near);
    if (area <= NEAR_MIN_AREA) return sample_nearest(s, &near, xyz, normal);
    return sample_block(s, s->stays, &near, area, DMI_CLOUD_NEAR, xyz, normal);
}

/* ---- all blocks ---- */

/* Fills the other blocks with the part's samples: nothing stays when it moves. */
static void repeat_part(dmi_cloud* cloud) {
    const size_t size = sizeof(float[3]) * (DMI_CLOUD_POINTS - DMI_CLOUD_PART);
    memcpy(cloud->xyz + DMI_CLOUD_PART, cloud->xyz, size);
    memcpy(cloud->normal + DMI_CLOUD_PART, cloud->normal, size);
}

static dm_result sample_all(sampler* s, dmi_cloud* cloud) {
    enum { NEAR = DMI_CLOUD_PART, BODY = DMI_CLOUD_PART + DMI_CLOUD_NEAR };
    measure_areas(s);
    dm_result result = sample_block(s, s->moves, NULL, s->moving, DMI_CLOUD_PART, cloud->xyz, cloud->normal);
    if (result == DM_OK && s->staying <= 0) {
        repeat_part(cloud);
        return DM_OK;
    }
    if (result == DM_OK) result = sample_near(s, cloud->xyz + NEAR, cloud->normal + NEAR);
    if (result != DM_OK) return result;
    return sample_block(s, s->stays, NULL, s->staying, DMI_CLOUD_BODY, cloud->xyz + BODY, cloud->normal + BODY);
}

dm_result dmi_cloud_sample(dmi_env* env, const dmi_mesh* mesh, uint32_t part, uint64_t seed, dmi_cloud* out_cloud) {
    sampler s = {.env = env, .mesh = mesh, .random = dmi_random_make(seed, part)};
    s.moves = dmi_scratch_alloc(env, 2 * (size_t)mesh->part_count);
    dm_result result = DM_ERROR_OUT_OF_MEMORY;
    if (s.moves != NULL) {
        s.stays = s.moves + mesh->part_count;
        for (uint32_t p = 0; p < mesh->part_count; p++) {
            s.moves[p] = (uint8_t)dmi_mesh_moves_with(mesh, p, part);
            s.stays[p] = !s.moves[p];
        }
        result = sample_all(&s, out_cloud);
    } else {
        dmi_fail(env, result, "no memory to sample %u triangles", mesh->face_count);
    }
    dmi_scratch_free(env, s.moves);
    return result;
}

/* ---- the points that the motion network reads ---- */

static int16_t to_unit(float coordinate) {
    const float steps = floorf(coordinate / DMI_PART_POINT_UNIT + 0.5f);
    return (int16_t)dmi_fminf(dmi_fmaxf(steps, INT16_MIN), INT16_MAX);
}

void dmi_part_points_take(const float (*xyz)[3], size_t step, dmi_part_points* out) {
    for (size_t i = 0; i < DMI_PART_POINTS; i++)
        for (int k = 0; k < 3; k++) out->at[i][k] = to_unit(xyz[i * step][k]);
}

void dmi_part_points_place(const dmi_part_points* points, float out_xyz[DMI_PART_POINTS][3]) {
    for (size_t i = 0; i < DMI_PART_POINTS; i++)
        for (int k = 0; k < 3; k++) out_xyz[i][k] = (float)points->at[i][k] * DMI_PART_POINT_UNIT;
}

void dmi_part_points_of_cloud(const dmi_cloud* cloud, dmi_part_points* out) {
    dmi_part_points_take(cloud->xyz, DMI_CLOUD_POINTS / DMI_PART_POINTS, out);
}
