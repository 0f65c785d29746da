/* Majority vote by area: the part that owns most of a piece of surface gets all of it. */
#include "mesh/mesh_repair.h"

#include <stdbool.h>
#include <string.h>

#include "mesh/connectivity.h"

/* The values are set by hand. A part that would lose more than both of the next two loses nothing. It must be both,
 * because a few leaked triangles of a coarse body can have ten times the area of a fine knob. */
#define OWNER_SHARE 0.6f    /* share of a piece's area that makes the piece its owner's */
#define MAX_AREA_LOSS 0.4f  /* share of a part's area */
#define MAX_FACE_LOSS 0.12f /* share of a part's triangles */
#define SMOOTH_COSINE 0.95f /* cosine between the normals of two faces of a smooth region, 18 degrees */

/* The pieces of the surface and their owners. */
typedef struct election {
    dmi_mesh* mesh;         /* face_part changes, parts do not yet */
    const uint32_t* labels; /* per face: its piece */
    uint32_t* owner;        /* per piece: the part that holds more than half of it, if any does */
    float *area, *lead;     /* per piece: its whole area, and what its owner holds */
    float* lost_area;       /* per part: what it would lose */
    uint32_t* lost_faces;
    uint32_t count;
} election;

static dm_result out_of_memory(const dmi_arena* arena, const dmi_mesh* mesh) {
    return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to repair the mask of %u triangles",
                    mesh->face_count);
}

/* Finds the owner of each piece, where there is one: majority vote (Boyer and Moore) weighted by area. */
static void find_owners(election* e) {
    const dmi_mesh* mesh = e->mesh;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t piece = e->labels[f], part = mesh->face_part[f];
        const float area = mesh->face_area[f];
        e->area[piece] += area;
        if (e->owner[piece] == part) {
            e->lead[piece] += area;
        } else if (e->lead[piece] < area) {
            e->owner[piece] = part;
            e->lead[piece] = area - e->lead[piece];
        } else {
            e->lead[piece] -= area;
        }
    }
    memset(e->lead, 0, e->count * sizeof *e->lead);
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (e->owner[e->labels[f]] == mesh->face_part[f]) e->lead[e->labels[f]] += mesh->face_area[f];
}

static bool is_stray(const election* e, uint32_t face) {
    const uint32_t piece = e->labels[face];
    return e->owner[piece] != e->mesh->face_part[face] && e->lead[piece] >= OWNER_SHARE * e->area[piece];
}

static bool can_lose(const election* e, uint32_t part) {
    const dmi_part* p = &e->mesh->parts[part];
    return e->lost_area[part] <= MAX_AREA_LOSS * p->area ||
           (float)e->lost_faces[part] <= MAX_FACE_LOSS * (float)p->face_count;
}

static void return_strays(election* e) {
    dmi_mesh* mesh = e->mesh;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (!is_stray(e, f)) continue;
        e->lost_area[mesh->face_part[f]] += mesh->face_area[f];
        e->lost_faces[mesh->face_part[f]]++;
    }
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (is_stray(e, f) && can_lose(e, mesh->face_part[f])) mesh->face_part[f] = e->owner[e->labels[f]];
}

static dm_result vote(dmi_arena* arena, dmi_mesh* mesh, const uint32_t* labels, uint32_t count) {
    election e = {.mesh = mesh, .labels = labels, .count = count};
    e.owner = dmi_arena_push(arena, count * sizeof *e.owner);
    e.area = dmi_arena_push(arena, count * sizeof *e.area);
    e.lead = dmi_arena_push(arena, count * sizeof *e.lead);
    e.lost_area = dmi_arena_push(arena, mesh->part_count * sizeof *e.lost_area);
    e.lost_faces = dmi_arena_push(arena, mesh->part_count * sizeof *e.lost_faces);
    if (e.owner == NULL || e.area == NULL || e.lead == NULL || e.lost_area == NULL || e.lost_faces == NULL)
        return out_of_memory(arena, mesh);
    memset(e.owner, 0, count * sizeof *e.owner);
    memset(e.area, 0, count * sizeof *e.area);
    memset(e.lead, 0, count * sizeof *e.lead);
    memset(e.lost_area, 0, mesh->part_count * sizeof *e.lost_area);
    memset(e.lost_faces, 0, mesh->part_count * sizeof *e.lost_faces);
    find_owners(&e);
    return_strays(&e);
    return DM_OK;
}

/* Finds whether faces of different parts share a vertex; otherwise no piece has two owners and nothing is repaired. */
static dm_result find_seam(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, bool* out_found) {
    uint32_t* part_at = dmi_arena_push(arena, mesh->vertex_count * sizeof *part_at);
    if (part_at == NULL) return out_of_memory(arena, mesh);
    memset(part_at, 0xff, mesh->vertex_count * sizeof *part_at); /* UINT32_MAX: none yet */
    for (size_t i = 0; i < (size_t)mesh->face_count * 3; i++) {
        uint32_t *at = &part_at[welded[mesh->indices[i]]], part = mesh->face_part[i / 3];
        if (*at == UINT32_MAX) *at = part;
        *out_found |= *at != part;
    }
    return DM_OK;
}

/* Votes by sheets, which a modeller makes in one operation, then by smooth regions within them. */
static dm_result vote_twice(dmi_arena* arena, const uint32_t* welded, const dmi_progress* progress, dmi_mesh* mesh) {
    const dmi_progress first = dmi_progress_piece(progress, 0, DMI_STAGE_REPAIR_FIRST_VOTE),
                       second = dmi_progress_piece(progress, DMI_STAGE_REPAIR_FIRST_VOTE, 1);
    uint32_t count;
    uint32_t* labels = dmi_arena_push(arena, mesh->face_count * sizeof *labels);
    uint8_t* all = dmi_arena_push(arena, mesh->face_count);
    if (labels == NULL || all == NULL) return out_of_memory(arena, mesh);
    dm_result result = dmi_face_sheets(arena, mesh, welded, &first, labels, &count);
    if (result == DM_OK) result = dmi_progress_tell(&first, 1);
    if (result == DM_OK) result = vote(arena, mesh, labels, count);
    memset(all, 1, mesh->face_count);
    if (result == DM_OK) result = dmi_progress_tell(&second, 0);
    if (result == DM_OK) result = dmi_face_regions(arena, mesh, welded, all, SMOOTH_COSINE, &second, labels, &count);
    if (result == DM_OK) result = dmi_progress_tell(&second, 1);
    return result == DM_OK ? vote(arena, mesh, labels, count) : result;
}

dm_result dmi_mesh_repair(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, const dmi_progress* progress,
                          dmi_mesh* out_repaired) {
    *out_repaired = *mesh;
    bool seam = false;
    dm_result result = find_seam(arena, mesh, welded, &seam);
    if (result != DM_OK || !seam) return result;
    out_repaired->face_part = dmi_arena_push(arena, mesh->face_count * sizeof *mesh->face_part);
    out_repaired->parts = dmi_arena_push(arena, mesh->part_count * sizeof *mesh->parts);
    if (out_repaired->face_part == NULL || out_repaired->parts == NULL) return out_of_memory(arena, mesh);
    memcpy(out_repaired->face_part, mesh->face_part, mesh->face_count * sizeof *mesh->face_part);
    memcpy(out_repaired->parts, mesh->parts, mesh->part_count * sizeof *mesh->parts);
    result = vote_twice(arena, welded, progress, out_repaired);
    return result == DM_OK ? dmi_mesh_measure_parts(arena->env, out_repaired) : result;
}
