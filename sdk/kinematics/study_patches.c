/* Shells and smooth regions of the part and of the body near it: hinge hardware, knobs, shafts and rims show there. */
#include <stdlib.h>

#include "kinematics/linear3.h"
#include "kinematics/study.h"
#include "mesh/connectivity.h"

#define MAX_FACES 24576 /* of each side; the largest are kept */
#define WELD_TOLERANCE 1e-5f
#define LARGEST 10 /* regions kept by area, then as many by nearness */

typedef struct region {
    uint32_t label, faces;
    float area, gap;
} region;

typedef struct face_rank {
    float area;
    uint32_t face;
} face_rank;

static int by_area(const void* a, const void* b) {
    const face_rank *p = a, *q = b;
    if (p->area != q->area) return p->area > q->area ? -1 : 1;
    return p->face < q->face ? -1 : 1;
}

/* Keeps the MAX_FACES largest faces of a selection. */
static dm_result thin_selection(dmi_arena* arena, const dmi_mesh* mesh, uint8_t* select) {
    uint32_t count = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) count += select[f] != 0;
    if (count <= MAX_FACES) return DM_OK;
    face_rank* rank = dmi_arena_push(arena, sizeof *rank * count);
    if (rank == NULL) return DM_ERROR_OUT_OF_MEMORY;
    uint32_t n = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (select[f]) rank[n++] = (face_rank){mesh->face_area[f], f};
    qsort(rank, n, sizeof *rank, by_area);
    for (uint32_t i = MAX_FACES; i < n; i++) select[rank[i].face] = 0;
    return DM_OK;
}

static const float* corner(const dmi_mesh* mesh, uint32_t face, uint32_t k) {
    return mesh->positions + 3 * (size_t)mesh->indices[3 * face + k];
}

static int by_region_area(const void* a, const void* b) {
    const region *p = a, *q = b;
    if (p->area != q->area) return p->area > q->area ? -1 : 1;
    return p->label < q->label ? -1 : 1;
}

static int by_region_gap(const void* a, const void* b) {
    const region *p = a, *q = b;
    if (p->gap != q->gap) return p->gap < q->gap ? -1 : 1;
    return p->label < q->label ? -1 : 1;
}

static region* measure_regions(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* labels, uint32_t count,
                               const dmi_field* other) {
    region* regions = dmi_arena_push(arena, sizeof *regions * (count + 1));
    if (regions == NULL) return NULL;
    for (uint32_t r = 0; r < count; r++) regions[r] = (region){r, 0, 0, INFINITY};
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (labels[f] == UINT32_MAX) continue;
        region* r = &regions[labels[f]];
        r->faces++, r->area += mesh->face_area[f];
        r->gap = fminf(r->gap, dmi_field_distance(other, corner(mesh, f, 0)));
    }
    return regions;
}

/* The region's surface as weighted points: corners and middle of every face (at most 512 faces of it). */
static void fit_line(const dmi_mesh* mesh, const uint32_t* labels, const region* r, dmi_patch* patch) {
    float xyz[2048][3], normal[2048][3], weight[2048];
    uint32_t count = 0, step = r->faces / 512 + 1, seen = 0;
    for (uint32_t f = 0; f < mesh->face_count && count + 4 <= 2048; f++) {
        if (labels[f] != r->label || seen++ % step != 0) continue;
        for (uint32_t k = 0; k < 4; k++, count++) {
            for (int i = 0; i < 3; i++)
                xyz[count][i] = k < 3 ? corner(mesh, f, k)[i]
                                      : (corner(mesh, f, 0)[i] + corner(mesh, f, 1)[i] + corner(mesh, f, 2)[i]) / 3;
            dmi_copy3(mesh->face_normal + 3 * (size_t)f, normal[count]);
            weight[count] = mesh->face_area[f] + 1e-12f;
        }
    }
    dmi_slippage s;
    dmi_shape_slippage((const float(*)[3])xyz, (const float(*)[3])normal, weight, count, &s);
    dmi_copy3(s.turn_axis[0], patch->axis);
    dmi_copy3(s.turn_point[0], patch->point);
    patch->residual = s.turn_residual[0];
}

static void make_patch(const dmi_mesh* mesh, const uint32_t* labels, const region* r, int shell, dmi_patch* out) {
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    *out = (dmi_patch){.area = r->area, .residual = 2, .shell = shell};
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (labels[f] != r->label) continue;
        for (uint32_t k = 0; k < 3; k++) {
            const float* x = corner(mesh, f, k);
            for (int i = 0; i < 3; i++) {
                low[i] = fminf(low[i], x[i]), high[i] = fmaxf(high[i], x[i]);
                out->centroid[i] += x[i] * mesh->face_area[f] / (3 * r->area);
            }
        }
    }
    for (int i = 0; i < 3; i++) out->box_centre[i] = (low[i] + high[i]) / 2;
    out->diagonal = dmi_distance3(low, high);
    if (r->faces >= 6) fit_line(mesh, labels, r, out);
}

static int same_patch(const dmi_patch* a, const dmi_patch* b) {
    return fabsf(a->area - b->area) < 1e-3f * a->area && dmi_distance3(a->box_centre, b->box_centre) < 1e-4f;
}

static void add_patches(const dmi_mesh* mesh, const uint32_t* labels, const region* regions, uint32_t count,
                        uint32_t most, int shell, dmi_patch* patches, uint32_t* patch_count) {
    for (uint32_t r = 0, added = 0; r < count && added < most && *patch_count < DMI_STUDY_PATCHES; r++) {
        if (regions[r].faces < (shell ? 2u : 6u) || regions[r].area <= 0) continue;
        dmi_patch patch;
        make_patch(mesh, labels, &regions[r], shell, &patch);
        uint32_t k = 0;
        while (k < *patch_count && !same_patch(&patch, &patches[k])) k++;
        if (k == *patch_count) patches[(*patch_count)++] = patch;
        added++;
    }
}

/* Shells first, then regions bounded by creases of 53 and of 26 degrees. */
static dm_result side_patches(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, uint8_t* select,
                              const dmi_field* other, dmi_patch* patches, uint32_t* patch_count) {
    static const float cosines[3] = {-2.0f, 0.6f, 0.9f};
    uint32_t* labels = dmi_arena_push(arena, sizeof *labels * mesh->face_count);
    if (labels == NULL || thin_selection(arena, mesh, select) != DM_OK) return DM_ERROR_OUT_OF_MEMORY;
    for (int level = 0; level < 3; level++) {
        uint32_t count;
        dm_result result = dmi_face_regions(arena, mesh, welded, select, cosines[level], labels, &count);
        if (result != DM_OK) return result;
        region* regions = measure_regions(arena, mesh, labels, count, other);
        if (regions == NULL) return DM_ERROR_OUT_OF_MEMORY;
        qsort(regions, count, sizeof *regions, by_region_area);
        add_patches(mesh, labels, regions, count, LARGEST / 2, level == 0, patches, patch_count);
        qsort(regions, count, sizeof *regions, by_region_gap);
        add_patches(mesh, labels, regions, count, LARGEST / 2, level == 0, patches, patch_count);
    }
    return DM_OK;
}

static int face_in_box(const dmi_mesh* mesh, uint32_t face, const float low[3], const float high[3]) {
    for (uint32_t k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            if (corner(mesh, face, k)[i] < low[i] || corner(mesh, face, k)[i] > high[i]) return 0;
    return mesh->face_area[face] > 0;
}

dm_result dmi_study_patches(dmi_arena* arena, const uint8_t* moving, const float low[3], const float high[3],
                            const uint32_t* welded, dmi_study* study) {
    const dmi_mesh* mesh = study->mesh;
    uint8_t* select = dmi_arena_push(arena, mesh->face_count);
    if (select == NULL) return DM_ERROR_OUT_OF_MEMORY;
    if (welded == NULL) {
        uint32_t* own = dmi_arena_push(arena, sizeof *own * mesh->vertex_count);
        if (own == NULL) return DM_ERROR_OUT_OF_MEMORY;
        dm_result result = dmi_weld_vertices(arena, mesh, WELD_TOLERANCE, own);
        if (result != DM_OK) return result;
        welded = own;
    }
    for (uint32_t f = 0; f < mesh->face_count; f++) select[f] = moving[f] && mesh->face_area[f] > 0;
    dm_result result =
        side_patches(arena, mesh, welded, select, &study->body_field, study->part_patches, &study->part_patch_count);
    if (result != DM_OK) return result;
    for (uint32_t f = 0; f < mesh->face_count; f++) select[f] = !moving[f] && face_in_box(mesh, f, low, high);
    return side_patches(arena, mesh, welded, select, &study->part_field, study->near_patches, &study->near_patch_count);
}
