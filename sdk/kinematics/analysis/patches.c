/* Shells and smooth regions of the part and of the body near it: hinge hardware, knobs, shafts and rims show there. */
#include <stdlib.h>

#include "kinematics/analysis/part_analysis.h"
#include "math/linear3.h"
#include "mesh/connectivity.h"

#define MAX_FACES 24576 /* of each side; the largest are kept */
#define RADIX ((uint32_t)1 << 16)
#define LARGEST 10 /* regions kept by area, then as many by nearness */

typedef struct region {
    uint32_t label, first, faces; /* order[first] .. order[first + faces - 1] of the side */
    float area, gap;
    int32_t made; /* its patch has been looked at */
} region;

/* One side of the contact, the part or the body near it: its faces by themselves, and grouped by region at the level
 * in hand. */
typedef struct side {
    dmi_mesh mesh;       /* indices are those of welded vertices, numbered anew; no positions, but … */
    float (*corners)[3]; /* … three corners a face */
    uint32_t* welded;    /* the identity */
    uint8_t* select;     /* all */
    float* gap;          /* of a face's first corner to the other side */
    uint32_t *labels, *order;
    region* regions;
    uint32_t region_count;
    dmi_patch* patches;
    uint32_t* patch_count;
} side;

/* ---- the faces of a side ---- */

/* Areas are positive: their bits order as they do. */
static uint32_t area_key(const dmi_mesh* mesh, uint32_t face) {
    uint32_t bits;
    memcpy(&bits, &mesh->face_area[face], sizeof bits);
    return bits;
}

/* The 16 bits at `shift` of the key that comes `rank`th from the top among keys that agree with `prefix` above those
 * bits; *rank becomes its place among the keys that share them. */
static uint32_t radix_step(const dmi_mesh* mesh, const uint32_t* faces, uint32_t count, uint32_t prefix, uint32_t shift,
                           uint32_t* histogram, uint32_t* rank) {
    uint32_t digit = RADIX - 1;
    memset(histogram, 0, RADIX * sizeof *histogram);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t key = area_key(mesh, faces[i]);
        if (shift > 0 || key >> 16 == prefix) histogram[key >> shift & (RADIX - 1)]++;
    }
    for (; *rank >= histogram[digit]; digit--) *rank -= histogram[digit];
    return digit;
}

/* Keeps the MAX_FACES largest faces, of equal ones the first, in their order. */
static dm_result thin_faces(dmi_arena* arena, const dmi_mesh* mesh, uint32_t* faces, uint32_t* count) {
    if (*count <= MAX_FACES) return DM_OK;
    uint32_t* histogram = dmi_arena_push(arena, RADIX * sizeof *histogram);
    if (histogram == NULL) return DM_ERROR_OUT_OF_MEMORY;
    uint32_t rank = MAX_FACES - 1, kept = 0;
    const uint32_t high = radix_step(mesh, faces, *count, 0, 16, histogram, &rank);
    const uint32_t least = high << 16 | radix_step(mesh, faces, *count, high, 0, histogram, &rank);
    for (uint32_t i = 0, equal = 0; i < *count; i++) {
        const uint32_t key = area_key(mesh, faces[i]);
        if (key > least || (key == least && equal++ <= rank)) faces[kept++] = faces[i];
    }
    *count = kept;
    return DM_OK;
}

static dm_result allocate_side(dmi_arena* arena, uint32_t count, side* s) {
    const size_t faces = (size_t)count + 1;
    s->mesh = (dmi_mesh){.face_count = count,
                         .indices = dmi_arena_push(arena, faces * sizeof(uint32_t[3])),
                         .face_area = dmi_arena_push(arena, faces * sizeof(float)),
                         .face_normal = dmi_arena_push(arena, faces * sizeof(float[3]))};
    s->corners = dmi_arena_push(arena, 3 * faces * sizeof *s->corners + sizeof(float)); /* read four at a time */
    s->welded = dmi_arena_push(arena, 3 * faces * sizeof *s->welded);
    s->select = dmi_arena_push(arena, faces);
    s->gap = dmi_arena_push(arena, faces * sizeof *s->gap);
    s->labels = dmi_arena_push(arena, faces * sizeof *s->labels);
    s->order = dmi_arena_push(arena, faces * sizeof *s->order);
    return s->mesh.indices && s->mesh.face_area && s->mesh.face_normal && s->corners && s->welded && s->select &&
                   s->gap && s->labels && s->order
               ? DM_OK
               : DM_ERROR_OUT_OF_MEMORY;
}

/* Copies the faces out of the mesh: what follows costs as much as they are many, however large the object is. */
static dm_result cut_out(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, const uint32_t* faces,
                         uint32_t count, const dmi_distance_grid* other, side* s) {
    uint32_t* number = dmi_arena_push(arena, sizeof *number * mesh->vertex_count);
    if (number == NULL || allocate_side(arena, count, s) != DM_OK) return DM_ERROR_OUT_OF_MEMORY;
    memset(number, 0xff, sizeof *number * mesh->vertex_count);
    memset(s->select, 1, count);
    for (size_t i = 0; i < count; i++) {
        const size_t f = faces[i];
        for (size_t k = 0; k < 3; k++) {
            const uint32_t v = mesh->indices[3 * f + k];
            uint32_t* own = &number[welded[v]];
            if (*own == UINT32_MAX) *own = s->mesh.vertex_count++;
            s->mesh.indices[3 * i + k] = *own;
            dmi_copy3(mesh->positions + 3 * (size_t)v, s->corners[3 * i + k]);
        }
        dmi_copy3(mesh->face_normal + 3 * f, s->mesh.face_normal + 3 * i);
        s->mesh.face_area[i] = mesh->face_area[f];
        s->gap[i] = dmi_distance_grid_distance(other, s->corners[3 * i]);
    }
    for (uint32_t v = 0; v < s->mesh.vertex_count; v++) s->welded[v] = v;
    return DM_OK;
}

/* ---- its regions ---- */

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

/* Groups the faces by label (a counting sort) and measures the regions. */
static dm_result measure_regions(dmi_arena* arena, uint32_t count, side* s) {
    s->regions = dmi_arena_push(arena, sizeof *s->regions * (count + 1));
    s->region_count = count;
    if (s->regions == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t r = 0; r < count; r++) s->regions[r] = (region){.label = r, .gap = INFINITY};
    for (uint32_t f = 0; f < s->mesh.face_count; f++) s->regions[s->labels[f]].faces++;
    for (uint32_t r = 1; r < count; r++) s->regions[r].first = s->regions[r - 1].first + s->regions[r - 1].faces;
    for (uint32_t r = 0; r < count; r++) s->regions[r].faces = 0;
    for (uint32_t f = 0; f < s->mesh.face_count; f++) {
        region* r = &s->regions[s->labels[f]];
        s->order[r->first + r->faces++] = f;
        r->area += s->mesh.face_area[f];
        r->gap = dmi_min(r->gap, s->gap[f]);
    }
    return DM_OK;
}

/* ---- a region's patch ---- */

/* The region's surface as weighted points: corners and middle of every face (at most 512 faces of it). */
static void fit_line(const side* s, const region* r, dmi_patch* patch) {
    float xyz[2048][3], normal[2048][3], weight[2048];
    uint32_t count = 0, step = r->faces / 512 + 1;
    for (uint32_t n = 0; n < r->faces && count + 4 <= 2048; n += step) {
        uint32_t f = s->order[r->first + n];
        const float(*x)[3] = (const float(*)[3])s->corners + 3 * (size_t)f;
        for (uint32_t k = 0; k < 4; k++, count++) {
            for (int i = 0; i < 3; i++) xyz[count][i] = k < 3 ? x[k][i] : (x[0][i] + x[1][i] + x[2][i]) / 3;
            dmi_copy3(s->mesh.face_normal + 3 * (size_t)f, normal[count]);
            weight[count] = s->mesh.face_area[f] + 1e-12f;
        }
    }
    dmi_slippage slip;
    dmi_shape_slippage((const float(*)[3])xyz, (const float(*)[3])normal, weight, count, &slip);
    dmi_copy3(slip.turn_axis[0], patch->axis);
    dmi_copy3(slip.turn_point[0], patch->point);
    patch->residual = slip.turn_residual[0];
}

typedef float quad __attribute__((vector_size(4 * sizeof(float))));
typedef int32_t int_quad __attribute__((vector_size(4 * sizeof(int32_t))));

static inline quad select_quad(int_quad mask, quad yes, quad no) {
    return (quad)((mask & (int_quad)yes) | (~mask & (int_quad)no));
}

/* Box and centroid over all its faces; the fourth lane holds whatever follows a corner. */
static void measure_patch(const side* s, const region* r, float low[4], float high[4], float centroid[4]) {
    quad least = INFINITY - (quad){0}, most = -least, sum = {0};
    for (uint32_t n = 0; n < r->faces; n++) {
        const size_t f = s->order[r->first + n];
        for (size_t k = 0; k < 3; k++) {
            quad x;
            memcpy(&x, s->corners[3 * f + k], sizeof x);
            least = select_quad(x < least, x, least), most = select_quad(x > most, x, most);
            sum += x * s->mesh.face_area[f] / (3 * r->area);
        }
    }
    memcpy(low, &least, sizeof least), memcpy(high, &most, sizeof most), memcpy(centroid, &sum, sizeof sum);
}

static void make_patch(const side* s, const region* r, int shell, dmi_patch* out) {
    float low[4], high[4], centroid[4];
    *out = (dmi_patch){.area = r->area, .residual = 2, .shell = shell};
    measure_patch(s, r, low, high, centroid);
    dmi_copy3(centroid, out->centroid);
    for (int i = 0; i < 3; i++) out->box_centre[i] = (low[i] + high[i]) / 2;
    out->diagonal = dmi_distance3(low, high);
    if (r->faces >= 6) fit_line(s, r, out);
}

static int same_patch(const dmi_patch* a, const dmi_patch* b) {
    return fabsf(a->area - b->area) < 1e-3f * a->area && dmi_distance3(a->box_centre, b->box_centre) < 1e-4f;
}

/* The first `most` regions, in the order they are sorted in, that have enough faces. */
static void add_patches(side* s, uint32_t most, int shell) {
    for (uint32_t n = 0, added = 0; n < s->region_count && added < most && *s->patch_count < DMI_MAX_PATCHES; n++) {
        region* r = &s->regions[n];
        if (r->faces < (shell ? 2u : 6u) || r->area <= 0) continue;
        added++;
        if (r->made) continue;
        r->made = 1;
        dmi_patch patch;
        make_patch(s, r, shell, &patch);
        uint32_t k = 0;
        while (k < *s->patch_count && !same_patch(&patch, &s->patches[k])) k++;
        if (k == *s->patch_count) s->patches[(*s->patch_count)++] = patch;
    }
}

static dm_result add_level(dmi_arena* arena, int shell, float min_cosine, side* s) {
    uint32_t count;
    dm_result result = dmi_face_regions(arena, &s->mesh, s->welded, s->select, min_cosine, s->labels, &count);
    if (result == DM_OK) result = measure_regions(arena, count, s);
    if (result != DM_OK) return result;
    qsort(s->regions, count, sizeof *s->regions, by_region_area);
    add_patches(s, LARGEST / 2, shell);
    qsort(s->regions, count, sizeof *s->regions, by_region_gap);
    add_patches(s, LARGEST / 2, shell);
    return DM_OK;
}

/* Shells first, then regions bounded by creases of 53 and of 26 degrees; each level in the memory of the last. */
static dm_result add_levels(dmi_arena* arena, side* s) {
    static const float cosines[3] = {-2.0f, 0.6f, 0.9f};
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    dm_result result = DM_OK;
    for (int level = 0; level < 3 && result == DM_OK; level++) {
        result = add_level(arena, level == 0, cosines[level], s);
        dmi_arena_rewind(arena, mark);
    }
    return result;
}

/* The faces' patches; the arena is left as it was found, `faces` is overwritten. */
static dm_result side_patches(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, uint32_t* faces,
                              uint32_t count, const dmi_distance_grid* other, side* s) {
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    dm_result result = thin_faces(arena, mesh, faces, &count);
    if (result == DM_OK) result = cut_out(arena, mesh, welded, faces, count, other, s);
    if (result == DM_OK) result = add_levels(arena, s);
    dmi_arena_rewind(arena, mark);
    return result;
}

static int face_in_box(const dmi_mesh* mesh, uint32_t face, const float low[3], const float high[3]) {
    for (size_t k = 0; k < 3; k++) {
        const float* x = mesh->positions + 3 * (size_t)mesh->indices[3 * (size_t)face + k];
        for (int i = 0; i < 3; i++)
            if (x[i] < low[i] || x[i] > high[i]) return 0;
    }
    return 1;
}

/* The part's faces (low NULL), or the body's that lie in a box; slivers left out. */
static uint32_t list_faces(const dmi_mesh* mesh, const uint8_t* moving, const float* low, const float* high,
                           uint32_t* out_faces) {
    uint32_t count = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (mesh->face_area[f] <= 0 || moving[f] != (low == NULL)) continue;
        if (low == NULL || face_in_box(mesh, f, low, high)) out_faces[count++] = f;
    }
    return count;
}

dm_result dmi_part_analysis_patches(dmi_arena* arena, const uint8_t* moving, const float low[3], const float high[3],
                                    const uint32_t* welded, dmi_part_analysis* study) {
    const dmi_mesh* mesh = study->mesh;
    uint32_t* faces = dmi_arena_push(arena, sizeof *faces * mesh->face_count);
    if (faces == NULL) return DM_ERROR_OUT_OF_MEMORY;
    if (welded == NULL) {
        uint32_t* fresh = dmi_arena_push(arena, sizeof *fresh * mesh->vertex_count);
        if (fresh == NULL) return DM_ERROR_OUT_OF_MEMORY;
        dm_result welding = dmi_weld_vertices(arena, mesh, DMI_WELD_TOLERANCE, fresh);
        if (welding != DM_OK) return welding;
        welded = fresh;
    }
    side own = {.patches = study->part_patches, .patch_count = &study->part_patch_count};
    uint32_t count = list_faces(mesh, moving, NULL, NULL, faces);
    dm_result result = side_patches(arena, mesh, welded, faces, count, &study->body_field, &own);
    if (result != DM_OK) return result;
    side near = {.patches = study->near_patches, .patch_count = &study->near_patch_count};
    count = list_faces(mesh, moving, low, high, faces);
    return side_patches(arena, mesh, welded, faces, count, &study->part_field, &near);
}
