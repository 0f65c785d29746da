/* Measures one part: samples the body near it, finds contacts, boxes, directions and slippage. */
#include "kinematics/analysis/part_analysis.h"

#include "base/random.h"
#include "base/sort.h"
#include "math/linear3.h"

#define NEAR_TRIES 32768
#define GUIDE 4096
#define NEAREST_SHARE 20   /* the third contact region: the nearest 1 / 20 of the part's points */
#define HANDLE_SHARE 32    /* what stands out: the farthest 1 / 32 of its points */
#define GRIP_HEIGHT 0.015f /* over the diagonal */
#define GRIP_POINTS 8
#define MAX_VERTICES 32768

static void grow(const float point[3], float low[3], float high[3]) {
    for (int k = 0; k < 3; k++) {
        low[k] = dmi_min(low[k], point[k]);
        high[k] = dmi_max(high[k], point[k]);
    }
}

static void empty_box(float low[3], float high[3]) {
    for (int k = 0; k < 3; k++) low[k] = INFINITY, high[k] = -INFINITY;
}

/* moving[f] = 1 for the faces that move with the part. */
static uint8_t* mark_faces(dmi_arena* arena, const dmi_mesh* mesh, uint32_t part) {
    uint8_t* moving = dmi_arena_push(arena, mesh->face_count);
    uint8_t* with = dmi_arena_push(arena, mesh->part_count);
    if (moving == NULL || with == NULL) return NULL;
    for (uint32_t p = 0; p < mesh->part_count; p++) with[p] = dmi_mesh_moves_with(mesh, p, part) != 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) moving[f] = with[mesh->face_part[f]];
    return moving;
}

/* The part's vertices, thinned when there are very many; their box goes to the study. */
static float (*part_vertices(dmi_arena* arena, const uint8_t* moving, dmi_part_analysis* study,
                             uint32_t* out_count))[3] {
    const dmi_mesh* mesh = study->mesh;
    uint8_t* used = dmi_arena_push(arena, mesh->vertex_count);
    if (used == NULL) return NULL;
    memset(used, 0, mesh->vertex_count);
    uint32_t total = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (!moving[f] || mesh->face_area[f] <= 0) continue;
        for (int k = 0; k < 3; k++) {
            uint32_t v = mesh->indices[3 * f + (uint32_t)k];
            total += !used[v];
            used[v] = 1;
        }
    }
    uint32_t step = total / MAX_VERTICES + 1, seen = 0;
    float(*out)[3] = dmi_arena_push(arena, sizeof *out * (total / step + 2));
    if (out == NULL) return NULL;
    *out_count = 0;
    empty_box(study->low, study->high);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        if (!used[v]) continue;
        grow(mesh->positions + 3 * (size_t)v, study->low, study->high);
        if (seen++ % step == 0) dmi_copy3(mesh->positions + 3 * (size_t)v, out[(*out_count)++]);
    }
    return out;
}

/* Faces of the rest that reach into the box; cumulated area beside them. */
static uint32_t faces_in_box(const dmi_mesh* mesh, const uint8_t* moving, const float low[3], const float high[3],
                             uint32_t* out_faces, float* out_area) {
    uint32_t count = 0;
    double total = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (moving[f] || mesh->face_area[f] <= 0) continue;
        int inside = 1;
        for (int k = 0; k < 3; k++) {
            float a = mesh->positions[3 * (size_t)mesh->indices[3 * f] + (size_t)k];
            float b = mesh->positions[3 * (size_t)mesh->indices[3 * f + 1] + (size_t)k];
            float c = mesh->positions[3 * (size_t)mesh->indices[3 * f + 2] + (size_t)k];
            inside &= dmi_min(a, dmi_min(b, c)) <= high[k] && dmi_max(a, dmi_max(b, c)) >= low[k];
        }
        if (!inside) continue;
        total += mesh->face_area[f];
        out_faces[count] = f, out_area[count++] = (float)total;
    }
    return count;
}

/* guide[g] is the first face whose cumulated area reaches g / GUIDE of it all. */
static void make_guide(const float* area, uint32_t count, uint32_t guide[GUIDE]) {
    uint32_t face = 0;
    for (uint32_t g = 0; g < GUIDE; g++) {
        while (face + 1 < count && area[face] < area[count - 1] * ((float)g / GUIDE)) face++;
        guide[g] = face;
    }
}

/* The first face whose cumulated area reaches a share of it all, in [0, 1). */
static uint32_t pick_face(const float* area, uint32_t count, const uint32_t guide[GUIDE], float share) {
    const float at = share * area[count - 1];
    uint32_t face = guide[(uint32_t)(share * GUIDE)];
    while (face > 0 && area[face - 1] >= at) face--;
    while (face + 1 < count && area[face] < at) face++;
    return face;
}

/* Area-weighted samples of the listed faces that fall into the box. */
static void sample_near(const uint32_t* faces, const float* area, uint32_t count, const float low[3],
                        const float high[3], dmi_part_analysis* study) {
    const dmi_mesh* mesh = study->mesh;
    dmi_random random = dmi_random_make(study->part, 91);
    uint32_t guide[GUIDE];
    make_guide(area, count, guide);
    for (uint32_t t = 0; t < NEAR_TRIES && study->near_count < DMI_ANALYSIS_NEAR_POINTS; t++) {
        uint32_t f = faces[pick_face(area, count, guide, dmi_random_unit(&random))];
        float r = sqrtf(dmi_random_unit(&random)), s = dmi_random_unit(&random), x[3];
        const float* a = mesh->positions + 3 * (size_t)mesh->indices[3 * f];
        const float* b = mesh->positions + 3 * (size_t)mesh->indices[3 * f + 1];
        const float* c = mesh->positions + 3 * (size_t)mesh->indices[3 * f + 2];
        int inside = 1;
        for (int k = 0; k < 3; k++) {
            x[k] = (1 - r) * a[k] + r * (1 - s) * b[k] + r * s * c[k];
            inside &= x[k] >= low[k] && x[k] <= high[k];
        }
        if (!inside) continue;
        dmi_copy3(x, study->near_points[study->near_count]);
        dmi_copy3(mesh->face_normal + 3 * (size_t)f, study->near_normals[study->near_count++]);
    }
}

/* The body near the part: samples in `low`..`high`, or the cloud's when none falls there. */
static dm_result find_near(dmi_arena* arena, const uint8_t* moving, const dmi_cloud* cloud, const float low[3],
                           const float high[3], dmi_part_analysis* study) {
    const dmi_mesh* mesh = study->mesh;
    uint32_t* faces = dmi_arena_push(arena, sizeof *faces * mesh->face_count);
    float* area = dmi_arena_push(arena, sizeof *area * mesh->face_count);
    study->near_points = dmi_arena_push(arena, sizeof(float[3]) * (DMI_ANALYSIS_NEAR_POINTS + DMI_CLOUD_NEAR));
    study->near_normals = dmi_arena_push(arena, sizeof(float[3]) * (DMI_ANALYSIS_NEAR_POINTS + DMI_CLOUD_NEAR));
    if (faces == NULL || area == NULL || study->near_points == NULL || study->near_normals == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    uint32_t count = faces_in_box(mesh, moving, low, high, faces, area);
    if (count > 0) sample_near(faces, area, count, low, high, study);
    if (study->near_count < 256) {
        memcpy(study->near_points + study->near_count, cloud->xyz + DMI_CLOUD_PART, sizeof(float[3]) * DMI_CLOUD_NEAR);
        memcpy(study->near_normals + study->near_count, cloud->normal + DMI_CLOUD_PART,
               sizeof(float[3]) * DMI_CLOUD_NEAR);
        study->near_count += DMI_CLOUD_NEAR;
    }
    return DM_OK;
}

static dm_result make_fields(dmi_arena* arena, const float low[3], const float high[3], dmi_part_analysis* study) {
    dm_result result = dmi_distance_grid_make(arena, (const float(*)[3])study->near_points, study->near_count, low,
                                              high, &study->body_field);
    if (result != DM_OK) return result;
    float pad = 0.05f * study->diagonal, part_low[3], part_high[3];
    for (int k = 0; k < 3; k++) part_low[k] = study->low[k] - pad, part_high[k] = study->high[k] + pad;
    return dmi_distance_grid_make(arena, study->points, DMI_ANALYSIS_POINTS, part_low, part_high, &study->part_field);
}

static dm_result measure_gaps(dmi_arena* arena, dmi_part_analysis* study) {
    study->gap = dmi_arena_push(arena, sizeof *study->gap * DMI_ANALYSIS_POINTS);
    study->facing = dmi_arena_push(arena, sizeof *study->facing * DMI_ANALYSIS_POINTS);
    if (study->gap == NULL || study->facing == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++)
        study->facing[i] = dmi_distance_grid_nearest(&study->body_field, study->points[i], &study->gap[i]);
    return DM_OK;
}

static void sort_points(float values[DMI_ANALYSIS_POINTS]) {
    float spare[DMI_ANALYSIS_POINTS];
    dmi_sort_floats(values, DMI_ANALYSIS_POINTS, spare);
}

static dm_result make_contact(dmi_arena* arena, float limit, const dmi_part_analysis* study, dmi_contact* out) {
    *out = (dmi_contact){0};
    out->points = dmi_arena_push(arena, sizeof *out->points * DMI_ANALYSIS_POINTS);
    float(*xyz)[3] = dmi_arena_push(arena, sizeof *xyz * DMI_ANALYSIS_POINTS);
    if (out->points == NULL || xyz == NULL) return DM_ERROR_OUT_OF_MEMORY;
    float low[3], high[3];
    empty_box(low, high);
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++) {
        if (!(study->gap[i] <= limit)) continue;
        grow(study->points[i], low, high);
        dmi_copy3(study->points[i], xyz[out->count]);
        out->points[out->count++] = i;
    }
    if (out->count == 0) return DM_OK;
    double variances[3];
    dmi_principal3((const float(*)[3])xyz, out->count, out->mean, variances, out->directions);
    for (int k = 0; k < 3; k++) out->box_centre[k] = (low[k] + high[k]) / 2;
    return DM_OK;
}

static dm_result find_contacts(dmi_arena* arena, dmi_part_analysis* study) {
    float sorted[DMI_ANALYSIS_POINTS];
    memcpy(sorted, study->gap, sizeof sorted);
    sort_points(sorted);
    const float limits[DMI_CONTACT_REGIONS] = {0.01f, 0.03f * study->diagonal,
                                               sorted[DMI_ANALYSIS_POINTS / NEAREST_SHARE]};
    for (int c = 0; c < DMI_CONTACT_REGIONS; c++) {
        float limit = isfinite(limits[c]) ? limits[c] : -1;
        if (make_contact(arena, limit, study, &study->contacts[c]) != DM_OK) return DM_ERROR_OUT_OF_MEMORY;
    }
    return DM_OK;
}

static void find_directions(const float (*vertices)[3], uint32_t vertex_count, dmi_part_analysis* study) {
    double variances[3];
    dmi_principal3(study->points, DMI_ANALYSIS_POINTS, study->centre, variances, study->part_directions);
    float(*all)[3] = study->near_points, mean[3];
    dmi_principal3((const float(*)[3])all, study->near_count, mean, variances, study->all_directions);
    study->part_cluster_count =
        dmi_shape_normal_clusters(study->normals, DMI_ANALYSIS_POINTS, DMI_MAX_NORMAL_CLUSTERS, study->part_clusters);
    study->near_cluster_count = dmi_shape_normal_clusters((const float(*)[3])study->near_normals, study->near_count,
                                                          DMI_MAX_NORMAL_CLUSTERS, study->near_clusters);
    float directions[3 + 2 * DMI_MAX_NORMAL_CLUSTERS][3];
    uint32_t count = 0;
    for (int i = 0; i < 3; i++) dmi_copy3(study->part_directions[i], directions[count++]);
    for (uint32_t i = 0; i < study->part_cluster_count; i++)
        dmi_copy3(study->part_clusters[i].direction, directions[count++]);
    uint32_t box_directions = count;
    for (uint32_t i = 0; i < study->near_cluster_count; i++)
        dmi_copy3(study->near_clusters[i].direction, directions[count++]);
    study->extreme_count =
        dmi_shape_extremes(vertices, vertex_count, (const float(*)[3])directions, count, study->extremes);
    dmi_shape_box((const float(*)[3])study->extremes, study->extreme_count, (const float(*)[3])directions,
                  box_directions, &study->box);
}

/* Mean and longest direction of points; answers their root mean square distance from the mean. */
static float spread(const float (*points)[3], uint32_t count, float mean[3], float direction[3]) {
    double variances[3];
    float directions[3][3];
    dmi_principal3(points, count, mean, variances, directions);
    dmi_copy3(directions[0], direction);
    return (float)sqrt(variances[0] + variances[1] + variances[2]);
}

/* The part's points with the widest gaps: a handle where there is one. */
static void find_handle(dmi_part_analysis* study) {
    float sorted[DMI_ANALYSIS_POINTS], xyz[DMI_ANALYSIS_POINTS][3];
    memcpy(sorted, study->gap, sizeof sorted);
    sort_points(sorted);
    float least = sorted[DMI_ANALYSIS_POINTS - DMI_ANALYSIS_POINTS / HANDLE_SHARE];
    if (!isfinite(sorted[DMI_ANALYSIS_POINTS - 1])) return;
    uint32_t count = 0;
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++)
        if (study->gap[i] >= least) dmi_copy3(study->points[i], xyz[count++]);
    study->handle_spread = spread((const float(*)[3])xyz, count, study->handle, study->handle_direction);
}

/* On which side of the part's box, along one of its axes, the body is nearer. */
static float lean_along(const dmi_part_analysis* study, const float centre[3], int axis) {
    const dmi_box* box = &study->box;
    const float out = 0.5f * (box->high[axis] - box->low[axis]) + 0.02f * study->diagonal;
    float distance[2] = {0, 0};
    for (int i = 0; i < 9; i++) {
        float at[3], x[3];
        dmi_copy3(centre, at);
        for (int k = 0, n = 0; k < 3; k++) {
            if (k == axis) continue;
            const int step = (n++ == 0 ? i % 3 : i / 3) - 1;
            dmi_madd3(at, 0.35f * (float)step * (box->high[k] - box->low[k]), box->axes[k], at);
        }
        for (int side = 0; side < 2; side++) {
            dmi_madd3(at, side ? out : -out, box->axes[axis], x);
            distance[side] += dmi_distance_grid_distance(&study->body_field, x);
        }
    }
    return (distance[1] - distance[0]) / (distance[0] + distance[1] + 1e-9f);
}

static void find_lean(dmi_part_analysis* study) {
    float centre[3];
    dmi_box_centre(&study->box, centre);
    for (int k = 0; k < 3; k++) study->lean[k] = lean_along(study, centre, k);
}

/* The height of the outer face: where, above the median, most points lie at one height. */
static float face_height(const float sorted[DMI_ANALYSIS_POINTS], float window) {
    uint32_t best = 0;
    float height = sorted[DMI_ANALYSIS_POINTS - 1];
    for (uint32_t i = DMI_ANALYSIS_POINTS / 2, end = i; i < DMI_ANALYSIS_POINTS; i++) {
        while (end < DMI_ANALYSIS_POINTS && sorted[end] - sorted[i] < window) end++;
        if (end - i > best) best = end - i, height = sorted[(i + end - 1) / 2];
    }
    return height;
}

/* The part's points that stand proud of its outer face, across the thinnest side of its box and away from the body: a
 * handle, a knob, a lip. */
static void find_grip(dmi_part_analysis* study) {
    float out[3], sorted[DMI_ANALYSIS_POINTS], xyz[DMI_ANALYSIS_POINTS][3];
    for (int k = 0; k < 3; k++) out[k] = study->lean[2] < 0 ? -study->box.axes[2][k] : study->box.axes[2][k];
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++) sorted[i] = dmi_dot3(study->points[i], out);
    sort_points(sorted);
    const float proud = face_height(sorted, 0.01f * study->diagonal) + GRIP_HEIGHT * study->diagonal;
    uint32_t count = 0;
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++)
        if (dmi_dot3(study->points[i], out) > proud) dmi_copy3(study->points[i], xyz[count++]);
    if (count < GRIP_POINTS || count > DMI_ANALYSIS_POINTS / 3) return;
    study->grip_spread = spread((const float(*)[3])xyz, count, study->grip, study->grip_direction);
    study->grip_share = (float)count / DMI_ANALYSIS_POINTS;
}

/* Slippage of a contact's part side (side 0) or of the body facing it. */
static void contact_slippage(const dmi_contact* contact, int side, dmi_part_analysis* study, int slot) {
    float xyz[DMI_ANALYSIS_POINTS][3], normal[DMI_ANALYSIS_POINTS][3];
    uint32_t count = 0;
    for (uint32_t i = 0; i < contact->count; i++) {
        uint32_t p = contact->points[i], q = study->facing[p];
        if (side == 1 && q == UINT32_MAX) continue;
        dmi_copy3(side == 0 ? study->points[p] : study->near_points[q], xyz[count]);
        dmi_copy3(side == 0 ? study->normals[p] : study->near_normals[q], normal[count++]);
    }
    study->has_slippage[slot] = count >= 20;
    if (count >= 20)
        dmi_shape_slippage((const float(*)[3])xyz, (const float(*)[3])normal, NULL, count, &study->slippage[slot]);
}

static void find_slippage(dmi_part_analysis* study) {
    dmi_shape_slippage(study->points, study->normals, NULL, DMI_ANALYSIS_POINTS, &study->slippage[0]);
    study->has_slippage[0] = 1;
    for (int c = 0; c < DMI_CONTACT_REGIONS; c++)
        for (int side = 0; side < 2; side++) contact_slippage(&study->contacts[c], side, study, 1 + 2 * c + side);
}

static float area_ratio(const dmi_mesh* mesh, const uint8_t* moving) {
    double part = 0, rest = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (moving[f])
            part += mesh->face_area[f];
        else
            rest += mesh->face_area[f];
    }
    return (float)(rest / fmax(part, 1e-12));
}

dm_result dmi_part_analysis_make(dmi_arena* arena, const dmi_mesh* mesh, const dmi_cloud* cloud, uint32_t part,
                                 const uint32_t* welded, dmi_part_analysis* out) {
    *out = (dmi_part_analysis){.mesh = mesh,
                               .part = part,
                               .points = (const float(*)[3])cloud->xyz,
                               .normals = (const float(*)[3])cloud->normal};
    uint8_t* moving = mark_faces(arena, mesh, part);
    uint32_t vertex_count;
    float(*vertices)[3] = moving != NULL ? part_vertices(arena, moving, out, &vertex_count) : NULL;
    if (vertices == NULL) return DM_ERROR_OUT_OF_MEMORY;
    float side = 0, low[3], high[3];
    for (int k = 0; k < 3; k++) side = dmi_max(side, out->high[k] - out->low[k]);
    out->diagonal = dmi_max(dmi_distance3(out->low, out->high), 1e-5f);
    out->area_ratio = area_ratio(mesh, moving);
    float pad = dmi_max(0.6f * side, 0.02f);
    for (int k = 0; k < 3; k++) low[k] = out->low[k] - pad, high[k] = out->high[k] + pad;

    dm_result result = find_near(arena, moving, cloud, low, high, out);
    if (result == DM_OK) result = make_fields(arena, low, high, out);
    if (result == DM_OK) result = measure_gaps(arena, out);
    if (result == DM_OK) result = find_contacts(arena, out);
    if (result != DM_OK) return result;
    find_directions((const float(*)[3])vertices, vertex_count, out);
    find_slippage(out);
    find_handle(out);
    find_lean(out);
    find_grip(out);
    out->outline_count = dmi_shape_extremes((const float(*)[3])cloud->xyz, DMI_CLOUD_POINTS,
                                            (const float(*)[3])out->box.axes, 3, out->outline);
    return dmi_part_analysis_patches(arena, moving, low, high, welded, out);
}
