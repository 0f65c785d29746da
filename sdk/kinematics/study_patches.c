/* Shells and smooth regions of the part and of the body near it: hinge hardware, knobs, shafts and rims show there. */
#include <stdlib.h>

#include "kinematics/linear3.h"
#include "kinematics/study.h"
#include "mesh/connectivity.h"

#define MAX_FACES 24576 /* of each side; the largest are kept */
#define WELD_TOLERANCE 1e-5f
#define LARGEST 10 /* regions kept by area, then as many by nearness */

typedef struct region {
    uint32_t label, first, faces; /* order[first] .. order[first + faces - 1] of the side */
    float area, gap;
} region;

/* One side of the contact, the part or the body near it: its faces, grouped by region at the level in hand. */
typedef struct side {
    const dmi_mesh* mesh;
    const dmi_field* other;
    uint32_t *labels, *order;
    region* regions;
    uint32_t region_count;
    dmi_patch* patches;
    uint32_t* patch_count;
} side;

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

/* Groups the selected faces by label (a counting sort) and measures the regions. */
static dm_result measure_regions(dmi_arena* arena, uint32_t count, side* s) {
    s->regions = dmi_arena_push(arena, sizeof *s->regions * (count + 1));
    s->region_count = count;
    if (s->regions == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t r = 0; r < count; r++) s->regions[r] = (region){.label = r, .gap = INFINITY};
    for (uint32_t f = 0; f < s->mesh->face_count; f++)
        if (s->labels[f] != UINT32_MAX) s->regions[s->labels[f]].faces++;
    for (uint32_t r = 1; r < count; r++) s->regions[r].first = s->regions[r - 1].first + s->regions[r - 1].faces;
    for (uint32_t r = 0; r < count; r++) s->regions[r].faces = 0;
    for (uint32_t f = 0; f < s->mesh->face_count; f++) {
        if (s->labels[f] == UINT32_MAX) continue;
        region* r = &s->regions[s->labels[f]];
        s->order[r->first + r->faces++] = f;
        r->area += s->mesh->face_area[f];
        r->gap = fminf(r->gap, dmi_field_distance(s->other, corner(s->mesh, f, 0)));
    }
    return DM_OK;
}

/* The region's surface as weighted points: corners and middle of every face (at most 512 faces of it). */
static void fit_line(const side* s, const region* r, dmi_patch* patch) {
    float xyz[2048][3], normal[2048][3], weight[2048];
    uint32_t count = 0, step = r->faces / 512 + 1;
    for (uint32_t n = 0; n < r->faces && count + 4 <= 2048; n += step) {
        uint32_t f = s->order[r->first + n];
        const float *a = corner(s->mesh, f, 0), *b = corner(s->mesh, f, 1), *c = corner(s->mesh, f, 2);
        for (uint32_t k = 0; k < 4; k++, count++) {
            for (int i = 0; i < 3; i++) xyz[count][i] = k < 3 ? corner(s->mesh, f, k)[i] : (a[i] + b[i] + c[i]) / 3;
            dmi_copy3(s->mesh->face_normal + 3 * (size_t)f, normal[count]);
            weight[count] = s->mesh->face_area[f] + 1e-12f;
        }
    }
    dmi_slippage slip;
    dmi_shape_slippage((const float(*)[3])xyz, (const float(*)[3])normal, weight, count, &slip);
    dmi_copy3(slip.turn_axis[0], patch->axis);
    dmi_copy3(slip.turn_point[0], patch->point);
    patch->residual = slip.turn_residual[0];
}

static void make_patch(const side* s, const region* r, int shell, dmi_patch* out) {
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    *out = (dmi_patch){.area = r->area, .residual = 2, .shell = shell};
    for (uint32_t n = 0; n < r->faces; n++) {
        uint32_t f = s->order[r->first + n];
        for (uint32_t k = 0; k < 3; k++) {
            const float* x = corner(s->mesh, f, k);
            for (int i = 0; i < 3; i++) {
                low[i] = fminf(low[i], x[i]), high[i] = fmaxf(high[i], x[i]);
                out->centroid[i] += x[i] * s->mesh->face_area[f] / (3 * r->area);
            }
        }
    }
    for (int i = 0; i < 3; i++) out->box_centre[i] = (low[i] + high[i]) / 2;
    out->diagonal = dmi_distance3(low, high);
    if (r->faces >= 6) fit_line(s, r, out);
}

static int same_patch(const dmi_patch* a, const dmi_patch* b) {
    return fabsf(a->area - b->area) < 1e-3f * a->area && dmi_distance3(a->box_centre, b->box_centre) < 1e-4f;
}

/* The first `most` regions, in the order they are sorted in, that have enough faces. */
static void add_patches(side* s, uint32_t most, int shell) {
    for (uint32_t r = 0, added = 0; r < s->region_count && added < most && *s->patch_count < DMI_STUDY_PATCHES; r++) {
        if (s->regions[r].faces < (shell ? 2u : 6u) || s->regions[r].area <= 0) continue;
        dmi_patch patch;
        make_patch(s, &s->regions[r], shell, &patch);
        uint32_t k = 0;
        while (k < *s->patch_count && !same_patch(&patch, &s->patches[k])) k++;
        if (k == *s->patch_count) s->patches[(*s->patch_count)++] = patch;
        added++;
    }
}

/* Shells first, then regions bounded by creases of 53 and of 26 degrees. */
static dm_result side_patches(dmi_arena* arena, const uint32_t* welded, uint8_t* select, side* s) {
    static const float cosines[3] = {-2.0f, 0.6f, 0.9f};
    s->labels = dmi_arena_push(arena, sizeof *s->labels * s->mesh->face_count);
    s->order = dmi_arena_push(arena, sizeof *s->order * s->mesh->face_count);
    if (s->labels == NULL || s->order == NULL || thin_selection(arena, s->mesh, select) != DM_OK)
        return DM_ERROR_OUT_OF_MEMORY;
    for (int level = 0; level < 3; level++) {
        uint32_t count;
        dm_result result = dmi_face_regions(arena, s->mesh, welded, select, cosines[level], s->labels, &count);
        if (result == DM_OK) result = measure_regions(arena, count, s);
        if (result != DM_OK) return result;
        qsort(s->regions, count, sizeof *s->regions, by_region_area);
        add_patches(s, LARGEST / 2, level == 0);
        qsort(s->regions, count, sizeof *s->regions, by_region_gap);
        add_patches(s, LARGEST / 2, level == 0);
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
        uint32_t* fresh = dmi_arena_push(arena, sizeof *fresh * mesh->vertex_count);
        if (fresh == NULL) return DM_ERROR_OUT_OF_MEMORY;
        dm_result welding = dmi_weld_vertices(arena, mesh, WELD_TOLERANCE, fresh);
        if (welding != DM_OK) return welding;
        welded = fresh;
    }
    side own = {.mesh = mesh,
                .other = &study->body_field,
                .patches = study->part_patches,
                .patch_count = &study->part_patch_count};
    for (uint32_t f = 0; f < mesh->face_count; f++) select[f] = moving[f] && mesh->face_area[f] > 0;
    dm_result result = side_patches(arena, welded, select, &own);
    if (result != DM_OK) return result;
    side near = {.mesh = mesh,
                 .other = &study->part_field,
                 .patches = study->near_patches,
                 .patch_count = &study->near_patch_count};
    for (uint32_t f = 0; f < mesh->face_count; f++) select[f] = !moving[f] && face_in_box(mesh, f, low, high);
    return side_patches(arena, welded, select, &near);
}
