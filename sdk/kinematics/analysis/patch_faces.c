/* Selects the largest faces by radix selection and copies them. */
#include "kinematics/analysis/analysis_steps.h"

#include <stdlib.h>

#include "math/linear3.h"
#include "math/place_hash.h"

#define MAX_FACES 24576 /* most faces of one side; by hand */
#define NO_BYTE 0xff    /* memset value that makes every uint32_t UINT32_MAX */

enum { DIGIT_BITS = 16, DIGITS = 1 << DIGIT_BITS }; /* digits of the radix selection */

/* Returns the area's bits: positive floats are ordered as their bits are. */
static uint32_t area_key(const dmi_mesh* mesh, uint32_t face) {
    uint32_t bits;
    memcpy(&bits, &mesh->face_area[face], sizeof bits);
    return bits;
}

/* Returns the digit at `shift` of the key with the given rank, from the greatest on, among keys whose higher digit is
 * `prefix`. *rank becomes the rank among the keys that share both digits. */
static uint32_t select_digit(const dmi_mesh* mesh, const uint32_t* faces, uint32_t count, uint32_t prefix,
                             uint32_t shift, uint32_t* histogram, uint32_t* rank) {
    uint32_t digit = DIGITS - 1;
    memset(histogram, 0, DIGITS * sizeof *histogram);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t key = area_key(mesh, faces[i]);
        if (shift > 0 || key >> DIGIT_BITS == prefix) histogram[key >> shift & (DIGITS - 1)]++;
    }
    for (; *rank >= histogram[digit]; digit--) *rank -= histogram[digit];
    return digit;
}

/* Keeps the MAX_FACES largest faces, of equal ones the first, in their order. */
static dm_result keep_largest(dmi_arena* arena, const dmi_mesh* mesh, uint32_t* faces, uint32_t* count) {
    if (*count <= MAX_FACES) return DM_OK;
    uint32_t* histogram = dmi_arena_push(arena, DIGITS * sizeof *histogram);
    if (histogram == NULL) return DM_ERROR_OUT_OF_MEMORY;
    uint32_t rank = MAX_FACES - 1, kept = 0;
    const uint32_t high = select_digit(mesh, faces, *count, 0, DIGIT_BITS, histogram, &rank);
    const uint32_t least = high << DIGIT_BITS | select_digit(mesh, faces, *count, high, 0, histogram, &rank);
    for (uint32_t i = 0, equal = 0; i < *count; i++) {
        const uint32_t key = area_key(mesh, faces[i]);
        if (key > least || (key == least && equal++ <= rank)) faces[kept++] = faces[i];
    }
    *count = kept;
    return DM_OK;
}

/* ---- an order that belongs to the places of the faces ---- */

typedef struct placed_face {
    uint64_t key;
    uint32_t face, first; /* first: the corner that is copied first */
} placed_face;

static int compare_keys(const void* a, const void* b) {
    const placed_face *p = a, *q = b;
    if (p->key != q->key) return p->key < q->key ? -1 : 1;
    return p->face < q->face ? -1 : p->face > q->face; /* one qsort keeps equal ones in order, another does not */
}

static placed_face place_face(const dmi_mesh* mesh, uint32_t face) {
    placed_face out = {.face = face};
    uint64_t least = UINT64_MAX;
    for (uint32_t k = 0; k < 3; k++) {
        const uint64_t hash = dmi_hash_place(mesh->positions + 3 * (size_t)mesh->indices[3 * (size_t)face + k]);
        out.key += hash;
        if (hash < least) least = hash, out.first = k;
    }
    return out;
}

/* Returns the listed faces in an order that their order in the mesh does not change. NULL: no memory. */
static placed_face* place_faces(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* faces, uint32_t count) {
    placed_face* out = dmi_arena_push(arena, (count + (size_t)1) * sizeof *out);
    if (out == NULL) return NULL;
    for (uint32_t i = 0; i < count; i++) out[i] = place_face(mesh, faces[i]);
    qsort(out, count, sizeof *out, compare_keys);
    return out;
}

static dm_result allocate(dmi_arena* arena, uint32_t count, dmi_patch_faces* out) {
    const size_t faces = (size_t)count + 1;
    out->mesh = (dmi_mesh){.face_count = count,
                           .indices = dmi_arena_push(arena, faces * sizeof(uint32_t[3])),
                           .face_area = dmi_arena_push(arena, faces * sizeof(float)),
                           .face_normal = dmi_arena_push(arena, faces * sizeof(float[3]))};
    /* One float more: patches.c reads corners four floats at a time. */
    out->corners = dmi_arena_push(arena, 3 * faces * sizeof *out->corners + sizeof(float));
    out->gap = dmi_arena_push(arena, faces * sizeof *out->gap);
    return out->mesh.indices != NULL && out->mesh.face_area != NULL && out->mesh.face_normal != NULL &&
                   out->corners != NULL && out->gap != NULL
               ? DM_OK
               : DM_ERROR_OUT_OF_MEMORY;
}

/* Copies the listed faces. */
static dm_result copy_faces(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, const uint32_t* faces,
                            uint32_t count, const dmi_distance_grid* other_grid, dmi_patch_faces* out) {
    uint32_t* number = dmi_arena_push(arena, sizeof *number * mesh->vertex_count);
    const placed_face* placed = place_faces(arena, mesh, faces, count);
    if (number == NULL || placed == NULL || allocate(arena, count, out) != DM_OK) return DM_ERROR_OUT_OF_MEMORY;
    memset(number, NO_BYTE, sizeof *number * mesh->vertex_count);
    for (size_t i = 0; i < count; i++) {
        const size_t f = placed[i].face;
        for (size_t k = 0; k < 3; k++) {
            const uint32_t v = mesh->indices[3 * f + (placed[i].first + k) % 3];
            uint32_t* own = &number[welded[v]];
            if (*own == UINT32_MAX) *own = out->mesh.vertex_count++;
            out->mesh.indices[3 * i + k] = *own;
            dmi_copy3(mesh->positions + 3 * (size_t)v, out->corners[3 * i + k]);
        }
        dmi_copy3(mesh->face_normal + 3 * f, out->mesh.face_normal + 3 * i);
        out->mesh.face_area[i] = mesh->face_area[f];
        out->gap[i] = INFINITY;
        for (size_t k = 0; k < 3; k++)
            out->gap[i] = dmi_min(out->gap[i], dmi_distance_grid_distance(other_grid, out->corners[3 * i + k]));
    }
    return DM_OK;
}

dm_result dmi_patch_faces_make(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, uint32_t* faces,
                               uint32_t count, const dmi_distance_grid* other_grid, dmi_patch_faces* out) {
    dm_result result = keep_largest(arena, mesh, faces, &count);
    return result == DM_OK ? copy_faces(arena, mesh, welded, faces, count, other_grid, out) : result;
}
