/* Finds patches: shells and smooth regions of the part and of the body near it, such as hinge knuckles, knobs, shafts
 * and rims. */
#include <stdlib.h>

#include "base/compiler.h"
#include "kinematics/analysis/analysis_steps.h"
#include "math/linear3.h"
#include "math/place_hash.h"
#include "mesh/connectivity.h"

#define LARGEST_REGIONS 5    /* regions of a level that become patches; by hand */
#define NEAREST_REGIONS 5    /* the same by gap; by hand */
#define MIN_SHELL_FACES 2u   /* fewest faces of a patch that is a shell; by hand */
#define MIN_REGION_FACES 6u  /* fewest faces of a smooth region, and of a patch with an axis; by hand */
#define MAX_FITTED_FACES 512 /* faces of a region that its axis is fitted to, evenly chosen; by hand */
#define MIN_WEIGHT 1e-12f    /* object sizes squared, added to the weight of samples: keeps the sum positive */
#define ROUNDED_BITS 7       /* bits of 23 that rounding leaves out of sums of areas */
#define NO_AXIS 2            /* residual of a patch without an axis; see dmi_patch */
#define SAME_AREA 1e-3f      /* relative difference below which patches are the same; by hand */
#define SAME_CENTRE 1e-4f    /* object sizes between their box centres; by hand */

enum { FACE_SAMPLES = 3, MAX_SAMPLES = FACE_SAMPLES * MAX_FITTED_FACES, LEVELS = 3, LANES = 4 };

typedef struct region {
    uint32_t label, first, faces; /* order[first] .. order[first + faces - 1] */
    float area, gap;              /* gap: least of its faces' */
    uint64_t place;               /* least hash of its corners' places */
    bool is_done;                 /* its patch has been made */
} region;

/* What fit_axis() fits an axis to. */
typedef struct samples {
    float xyz[MAX_SAMPLES][3], normal[MAX_SAMPLES][3], weight[MAX_SAMPLES];
} samples;

/* The part, or the body near it: faces, their regions at one level, patches. */
typedef struct side {
    dmi_patch_faces faces;
    uint32_t* welded; /* the identity: vertices are welded already */
    uint8_t* select;  /* all faces */
    uint32_t *labels, *order;
    region* regions;
    uint32_t region_count;
    samples* samples;
    dmi_patch* patches;
    uint32_t* patch_count;
} side;

/* ---- regions ---- */

/* Returns the bits of a positive number, or of 0 or infinity, rounded to 1e-5 of it: sums of the same areas in another
 * order differ by less. They are ordered as the numbers are. */
static uint32_t rounded_bits(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return (bits + (1u << (ROUNDED_BITS - 1))) >> ROUNDED_BITS;
}

/* Which of two regions comes first depends on neither the order of the faces nor the diagonals of flat polygons. */
static int compare_regions(const region* a, const region* b, uint32_t bits_a, uint32_t bits_b) {
    if (bits_a != bits_b) return bits_a < bits_b ? -1 : 1;
    if (a->place != b->place) return a->place < b->place ? -1 : 1;
    return a->label < b->label ? -1 : a->label > b->label; /* one qsort keeps equal ones in order, another does not */
}

static int compare_area(const void* a, const void* b) {
    const region *p = a, *q = b;
    return compare_regions(p, q, rounded_bits(q->area), rounded_bits(p->area));
}

static int compare_gap(const void* a, const void* b) {
    const region *p = a, *q = b;
    return compare_regions(p, q, rounded_bits(p->gap), rounded_bits(q->gap));
}

static dm_result allocate_labels(dmi_arena* arena, side* s) {
    const size_t faces = (size_t)s->faces.mesh.face_count + 1;
    s->welded = dmi_arena_push(arena, 3 * faces * sizeof *s->welded);
    s->select = dmi_arena_push(arena, faces);
    s->labels = dmi_arena_push(arena, faces * sizeof *s->labels);
    s->order = dmi_arena_push(arena, faces * sizeof *s->order);
    s->samples = dmi_arena_push(arena, sizeof *s->samples);
    if (s->welded == NULL || s->select == NULL || s->labels == NULL || s->order == NULL || s->samples == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    memset(s->select, 1, s->faces.mesh.face_count);
    for (uint32_t v = 0; v < s->faces.mesh.vertex_count; v++) s->welded[v] = v;
    return DM_OK;
}

/* Sorts the faces by label (counting sort) and measures the regions. */
static dm_result measure_regions(dmi_arena* arena, uint32_t count, side* s) {
    const dmi_mesh* mesh = &s->faces.mesh;
    s->regions = dmi_arena_push(arena, sizeof *s->regions * (count + 1));
    s->region_count = count;
    if (s->regions == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t r = 0; r < count; r++) s->regions[r] = (region){.label = r, .gap = INFINITY, .place = UINT64_MAX};
    for (uint32_t f = 0; f < mesh->face_count; f++) s->regions[s->labels[f]].faces++;
    for (uint32_t r = 1; r < count; r++) s->regions[r].first = s->regions[r - 1].first + s->regions[r - 1].faces;
    for (uint32_t r = 0; r < count; r++) s->regions[r].faces = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        region* r = &s->regions[s->labels[f]];
        s->order[r->first + r->faces++] = f;
        r->area += mesh->face_area[f];
        r->gap = dmi_min(r->gap, s->faces.gap[f]);
        for (size_t k = 0; k < 3; k++) {
            const uint64_t place = dmi_hash_place(s->faces.corners[3 * (size_t)f + k]);
            r->place = place < r->place ? place : r->place;
        }
    }
    return DM_OK;
}

/* ---- a region's patch ---- */

/* Computes the axis of the best rotational slippage from weighted samples: the middles of the edges of up to about
 * MAX_FITTED_FACES faces. They integrate what slippage sums exactly, so that no diagonal of a flat polygon counts. */
static void fit_axis(const side* s, const region* r, dmi_patch* patch) {
    float(*xyz)[3] = s->samples->xyz, (*normal)[3] = s->samples->normal, *weight = s->samples->weight;
    uint32_t count = 0, step = r->faces / MAX_FITTED_FACES + 1;
    for (uint32_t n = 0; n < r->faces && count + FACE_SAMPLES <= MAX_SAMPLES; n += step) {
        uint32_t f = s->order[r->first + n];
        const float(*x)[3] = (const float(*)[3])s->faces.corners + 3 * (size_t)f;
        for (uint32_t k = 0; k < FACE_SAMPLES; k++, count++) {
            for (int i = 0; i < 3; i++) xyz[count][i] = (x[k][i] + x[(k + 1) % FACE_SAMPLES][i]) / 2;
            dmi_copy3(s->faces.mesh.face_normal + 3 * (size_t)f, normal[count]);
            weight[count] = s->faces.mesh.face_area[f] + MIN_WEIGHT;
        }
    }
    dmi_slippage slip;
    dmi_slippage_compute((const float(*)[3])xyz, (const float(*)[3])normal, weight, count, &slip);
    dmi_copy3(slip.turn_axis[0], patch->axis);
    dmi_copy3(slip.turn_point[0], patch->point);
    patch->residual = slip.turn_residual[0];
}

typedef DMI_VECTOR(float, LANES) lanes;
typedef DMI_VECTOR(int32_t, LANES) int_lanes;

static inline lanes select_lanes(int_lanes mask, lanes yes, lanes no) {
    return (lanes)((mask & (int_lanes)yes) | (~mask & (int_lanes)no));
}

/* Computes the box and the area-weighted centroid of all faces. The fourth lane holds whatever follows a corner. */
static void measure_patch(const side* s, const region* r, float low[LANES], float high[LANES], float centroid[LANES]) {
    lanes least = INFINITY - (lanes){0}, most = -least, sum = {0};
    for (uint32_t n = 0; n < r->faces; n++) {
        const size_t f = s->order[r->first + n];
        for (size_t k = 0; k < 3; k++) {
            lanes x;
            memcpy(&x, s->faces.corners[3 * f + k], sizeof x);
            least = select_lanes((int_lanes)(x < least), x, least);
            most = select_lanes((int_lanes)(x > most), x, most);
            sum += x * s->faces.mesh.face_area[f] / (3 * r->area);
        }
    }
    memcpy(low, &least, sizeof least), memcpy(high, &most, sizeof most), memcpy(centroid, &sum, sizeof sum);
}

static void make_patch(const side* s, const region* r, bool is_shell, dmi_patch* out) {
    float low[LANES], high[LANES], centroid[LANES];
    *out = (dmi_patch){.area = r->area, .residual = NO_AXIS, .is_shell = is_shell};
    measure_patch(s, r, low, high, centroid);
    dmi_copy3(centroid, out->centroid);
    for (int i = 0; i < 3; i++) out->box_centre[i] = (low[i] + high[i]) / 2;
    out->diagonal = dmi_distance3(low, high);
    if (r->faces >= MIN_REGION_FACES) fit_axis(s, r, out);
}

static bool is_same_patch(const dmi_patch* a, const dmi_patch* b) {
    return fabsf(a->area - b->area) < SAME_AREA * a->area && dmi_distance3(a->box_centre, b->box_centre) < SAME_CENTRE;
}

/* Adds patches of the first max_regions regions, in the order they are sorted in, that have enough faces. */
static void add_patches(side* s, uint32_t max_regions, bool is_shell) {
    const uint32_t min_faces = is_shell ? MIN_SHELL_FACES : MIN_REGION_FACES;
    for (uint32_t n = 0, added = 0; n < s->region_count && added < max_regions; n++) {
        region* r = &s->regions[n];
        if (*s->patch_count == DMI_MAX_PATCHES) return;
        if (r->faces < min_faces || r->area <= 0) continue;
        added++;
        if (r->is_done) continue;
        r->is_done = true;
        dmi_patch patch;
        make_patch(s, r, is_shell, &patch);
        uint32_t k = 0;
        while (k < *s->patch_count && !is_same_patch(&patch, &s->patches[k])) k++;
        if (k == *s->patch_count) s->patches[(*s->patch_count)++] = patch;
    }
}

/* ---- levels ---- */

/* Divides the faces at creases below min_cosine (below -1: into shells) and adds patches of the regions. */
static dm_result add_level(dmi_arena* arena, bool is_shell, float min_cosine, side* s) {
    uint32_t count;
    dm_result result =
        dmi_face_regions(arena, &s->faces.mesh, s->welded, s->select, min_cosine, NULL, s->labels, &count);
    if (result == DM_OK) result = measure_regions(arena, count, s);
    if (result != DM_OK) return result;
    qsort(s->regions, count, sizeof *s->regions, compare_area);
    add_patches(s, LARGEST_REGIONS, is_shell);
    qsort(s->regions, count, sizeof *s->regions, compare_gap);
    add_patches(s, NEAREST_REGIONS, is_shell);
    return DM_OK;
}

/* Adds the levels one after the other, each in the memory of the last. */
static dm_result add_levels(dmi_arena* arena, side* s) {
    /* Shells, then regions that end at creases of 53 and of 26 degrees; by hand. */
    static const float cosines[LEVELS] = {-2.0f, 0.6f, 0.9f};
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    dm_result result = DM_OK;
    for (int level = 0; level < LEVELS && result == DM_OK; level++) {
        result = add_level(arena, level == 0, cosines[level], s);
        dmi_arena_rewind(arena, mark);
    }
    return result;
}

/* Finds the patches of the listed faces. Overwrites `faces`; leaves the arena as it was. */
static dm_result find_side(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, uint32_t* faces,
                           uint32_t count, const dmi_distance_grid* other_grid, side* s) {
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    dm_result result = dmi_patch_faces_make(arena, mesh, welded, faces, count, other_grid, &s->faces);
    if (result == DM_OK) result = allocate_labels(arena, s);
    if (result == DM_OK) result = add_levels(arena, s);
    dmi_arena_rewind(arena, mark);
    return result;
}

/* ---- both sides ---- */

static bool is_face_in_box(const dmi_mesh* mesh, uint32_t face, const float low[3], const float high[3]) {
    for (size_t k = 0; k < 3; k++) {
        const float* x = mesh->positions + 3 * (size_t)mesh->indices[3 * (size_t)face + k];
        for (int i = 0; i < 3; i++)
            if (x[i] < low[i] || x[i] > high[i]) return false;
    }
    return true;
}

/* Lists the part's faces (low NULL), or the body's that lie in a box. Leaves out faces without area. */
static uint32_t list_faces(const dmi_mesh* mesh, const uint8_t* moving, const float* low, const float* high,
                           uint32_t* out_faces) {
    uint32_t count = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (mesh->face_area[f] <= 0 || moving[f] != (low == NULL)) continue;
        if (low == NULL || is_face_in_box(mesh, f, low, high)) out_faces[count++] = f;
    }
    return count;
}

/* Computes the welded vertices if *welded is NULL. */
static dm_result weld(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t** welded) {
    if (*welded != NULL) return DM_OK;
    uint32_t* computed = dmi_arena_push(arena, sizeof *computed * mesh->vertex_count);
    if (computed == NULL) return DM_ERROR_OUT_OF_MEMORY;
    *welded = computed;
    return dmi_weld_vertices(arena, mesh, DMI_WELD_TOLERANCE, NULL, computed);
}

dm_result dmi_analysis_find_patches(dmi_arena* arena, const uint8_t* moving, const float low[3], const float high[3],
                                    const uint32_t* welded, dmi_part_analysis* analysis) {
    const dmi_mesh* mesh = analysis->mesh;
    uint32_t* faces = dmi_arena_push(arena, sizeof *faces * mesh->face_count);
    if (faces == NULL) return DM_ERROR_OUT_OF_MEMORY;
    dm_result result = weld(arena, mesh, &welded);
    if (result != DM_OK) return result;
    side part = {.patches = analysis->part_patches, .patch_count = &analysis->part_patch_count};
    uint32_t count = list_faces(mesh, moving, NULL, NULL, faces);
    result = find_side(arena, mesh, welded, faces, count, &analysis->body_grid, &part);
    if (result != DM_OK) return result;
    side near = {.patches = analysis->near_patches, .patch_count = &analysis->near_patch_count};
    count = list_faces(mesh, moving, low, high, faces);
    return find_side(arena, mesh, welded, faces, count, &analysis->part_grid, &near);
}
