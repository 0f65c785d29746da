/* Finds the part at a grabbed point.
 *
 * In a mesh of several rigid pieces (nodes of a scene), the part is the grabbed piece with the small pieces that are
 * attached to it alone, such as a handle on a door. In a mesh of one piece, the part is the proposal with the greatest
 * score of a fitted network. */
#include "segmentation/part_finder.h"

#include <string.h>

#include "math/elementary.h"
#include "math/linear3.h"
#include "segmentation/part_networks.h"
#include "segmentation/proposals.h"
#include "segmentation/region_contacts.h"

/* ---- nearest face ---- */

enum { CLOSED_TRIANGLE = 4 }; /* the three corners and the first one again */

/* Returns the squared distance of p from the segment a b. */
static float segment_distance(const float p[3], const float a[3], const float b[3]) {
    float along[3], offset[3], nearest[3];
    dmi_sub3(b, a, along), dmi_sub3(p, a, offset);
    const float length = dmi_dot3(along, along);
    const float t = length > 0 ? dmi_fminf(dmi_fmaxf(dmi_dot3(offset, along) / length, 0), 1) : 0;
    dmi_madd3(a, t, along, nearest);
    dmi_sub3(p, nearest, offset);
    return dmi_dot3(offset, offset);
}

/* Returns the squared distance of p from the triangle a b c, by barycentric coordinates (Ericson, Real-Time Collision
 * Detection, 2005, 3.4 and 5.1.5). */
static float triangle_distance(const float p[3], const float a[3], const float b[3], const float c[3]) {
    float ab[3], ac[3], ap[3], nearest[3], offset[3];
    dmi_sub3(b, a, ab), dmi_sub3(c, a, ac), dmi_sub3(p, a, ap);
    const float d00 = dmi_dot3(ab, ab), d01 = dmi_dot3(ab, ac), d11 = dmi_dot3(ac, ac);
    const float d20 = dmi_dot3(ap, ab), d21 = dmi_dot3(ap, ac), area = d00 * d11 - d01 * d01;
    float v = area > 0 ? (d11 * d20 - d01 * d21) / area : -1, w = area > 0 ? (d00 * d21 - d01 * d20) / area : -1;
    if (v >= 0 && w >= 0 && v + w <= 1) {
        for (int k = 0; k < 3; k++) nearest[k] = a[k] + v * ab[k] + w * ac[k];
        dmi_sub3(p, nearest, offset);
        return dmi_dot3(offset, offset);
    }
    const float* corners[CLOSED_TRIANGLE] = {a, b, c, a};
    float best = INFINITY;
    for (int i = 0; i < 3; i++) best = dmi_fminf(best, segment_distance(p, corners[i], corners[i + 1]));
    return best;
}

dm_result dmi_mesh_nearest_face(const dmi_mesh* mesh, const float point[3], const dmi_progress* progress,
                                uint32_t* out_face) {
    float least = INFINITY;
    *out_face = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t* corner = mesh->indices + (size_t)f * 3;
        const float distance =
            triangle_distance(point, mesh->positions + (size_t)corner[0] * 3, mesh->positions + (size_t)corner[1] * 3,
                              mesh->positions + (size_t)corner[2] * 3);
        if (distance < least) *out_face = f;
        least = dmi_fminf(distance, least);
        if (dmi_progress_step(progress, f, mesh->face_count) != DM_OK) return DM_ERROR_CANCELLED;
    }
    return DM_OK;
}

/* ---- search ---- */

#define ARENA_BLOCK ((size_t)1 << 20) /* bytes; by hand */

static bool has_given_pieces(const dmi_mesh* mesh) {
    uint32_t filled = 0;
    for (uint32_t p = 0; p < mesh->part_count; p++) filled += mesh->parts[p].face_count > 0;
    return filled > 1;
}

static dm_result find_among_given(dmi_arena* arena, const dmi_part_query* query, uint8_t* out_faces) {
    const dmi_mesh* mesh = query->mesh;
    dmi_pieces pieces;
    dmi_remaining_components components;
    dm_result result = dmi_pieces_make(arena, mesh, mesh->face_part, mesh->part_count, &pieces);
    if (result == DM_OK) result = dmi_progress_tell(query->progress, DMI_STAGE_SEARCH_DIVIDED);
    if (result == DM_OK) result = dmi_remaining_components_make(arena, &pieces, &components);
    if (result != DM_OK) return result;
    uint8_t* inside = dmi_arena_push(arena, pieces.count);
    if (inside == NULL)
        return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to find a part among %u", pieces.count);
    memset(inside, 0, pieces.count);
    const dmi_progress finding = dmi_progress_piece(query->progress, DMI_STAGE_SEARCH_DIVIDED, 1);
    uint32_t face;
    result = dmi_mesh_nearest_face(mesh, query->point, &finding, &face);
    if (result != DM_OK) return result;
    inside[mesh->face_part[face]] = 1;
    dmi_remaining_components_find(&pieces, inside, &components);
    dmi_remaining_components_carry(&pieces, &components, inside);
    for (uint32_t f = 0; f < mesh->face_count; f++) out_faces[f] = inside[mesh->face_part[f]] != 0;
    return DM_OK;
}

static void read_networks(dmi_loader* loader, void* network) {
    dmi_part_networks* networks = network;
    dmi_part_growth_read(loader, &networks->growth);
    dmi_part_choice_read(loader, &networks->choice);
}

/* Returns the proposal with the greatest score; NULL without proposals. */
static const dmi_proposal* best_proposal(const dmi_perceptron* choice, dmi_isa isa, const dmi_proposals* proposals) {
    float features[DMI_MAX_PROPOSALS][DMI_PROPOSAL_FEATURES], scores[DMI_MAX_PROPOSALS], most = -INFINITY;
    const dmi_proposal* best = NULL;
    for (uint32_t i = 0; i < proposals->count; i++)
        memcpy(features[i], proposals->items[i].features, sizeof features[i]);
    dmi_part_network_apply(choice, isa, features[0], proposals->count, scores);
    for (uint32_t i = 0; i < proposals->count; i++) {
        if (scores[i] <= most) continue;
        most = scores[i];
        best = &proposals->items[i];
    }
    return best;
}

static dm_result find_among_proposals(dmi_arena* arena, const dmi_part_query* query, uint8_t* out_faces) {
    const dmi_isa isa = dmi_cpu_best_isa();
    const dmi_mesh* mesh = query->mesh;
    const dmi_progress searching = dmi_progress_piece(query->progress, 0, DMI_STAGE_SEARCH_FACE_FOUND),
                       dividing =
                           dmi_progress_piece(query->progress, DMI_STAGE_SEARCH_FACE_FOUND, DMI_STAGE_SEARCH_DIVIDED),
                       proposing =
                           dmi_progress_piece(query->progress, DMI_STAGE_SEARCH_DIVIDED, DMI_STAGE_SEARCH_PROPOSED);
    dmi_part_networks networks;
    dmi_mesh_sheets sheets;
    dmi_grab grab;
    dmi_copy3(query->point, grab.point);
    dmi_copy3(query->drag, grab.drag);
    dm_result result = dmi_mesh_nearest_face(mesh, query->point, &searching, &grab.face);
    if (result == DM_OK) result = dmi_progress_tell(query->progress, DMI_STAGE_SEARCH_FACE_FOUND);
    if (result != DM_OK) return result;
    result = dmi_load_network(arena->env, dmi_part_finder_weights, dmi_part_finder_weights_size,
                              DMI_PART_FINDER_ARCHITECTURE, read_networks, &networks, arena);
    if (result != DM_OK) return result;
    dmi_proposals* proposals = dmi_arena_push(arena, sizeof *proposals);
    if (proposals == NULL) return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to find a part");
    result = dmi_mesh_sheets_make(arena, mesh, &dividing, &sheets);
    if (result == DM_OK) result = dmi_progress_tell(query->progress, DMI_STAGE_SEARCH_DIVIDED);
    if (result == DM_OK)
        result = dmi_proposals_make(arena, &sheets, &grab, &networks.growth, isa, &proposing, proposals);
    if (result == DM_OK) result = dmi_progress_tell(query->progress, DMI_STAGE_SEARCH_PROPOSED);
    if (result != DM_OK) return result;
    const dmi_proposal* best = best_proposal(&networks.choice, isa, proposals);
    for (uint32_t f = 0; f < mesh->face_count; f++)
        out_faces[f] = best == NULL || best->inside[best->level->pieces.labels[f]] != 0;
    return DM_OK;
}

/* Returns whether the faces outside the part have no area. */
static bool is_whole_mesh(const dmi_mesh* mesh, const uint8_t* faces) {
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (!faces[f] && mesh->face_area[f] > 0) return false;
    return true;
}

static dm_result find(dmi_arena* arena, const dmi_part_query* query, uint8_t* out_faces) {
    const dmi_mesh* mesh = query->mesh;
    uint8_t* faces = dmi_arena_push(arena, mesh->face_count); /* an error leaves out_faces as it was */
    if (faces == NULL) return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to find a part");
    const dm_result result =
        has_given_pieces(mesh) ? find_among_given(arena, query, faces) : find_among_proposals(arena, query, faces);
    if (result != DM_OK) return result;
    if (is_whole_mesh(mesh, faces))
        return dmi_fail(arena->env, DM_ERROR_FULL_MASK,
                        "the grabbed point's part is the whole mesh: nothing would stay");
    const dm_result told = dmi_progress_tell(query->progress, 1);
    if (told == DM_OK) memcpy(out_faces, faces, mesh->face_count);
    return told;
}

dm_result dmi_part_find(dmi_env* env, const dmi_part_query* query, uint8_t* out_faces) {
    dmi_arena arena;
    dmi_arena_init(&arena, env, ARENA_BLOCK);
    dm_result result = find(&arena, query, out_faces);
    dmi_arena_release(&arena);
    return result;
}
