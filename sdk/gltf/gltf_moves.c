/* Finds which faces, nodes and trees of nodes move with which track. */
#include "gltf/gltf_moves.h"

#include <inttypes.h>

static dm_result claim_faces(dmi_moves* m, dmi_env* env, const dm_gltf_track* tracks) {
    for (uint64_t face = 0; face < m->gltf->face_count; face++) {
        for (uint32_t t = m->track_count; t-- > 0;) {
            if (tracks[t].face_ids[face] == tracks[t].value) m->owners[face] = t + 1;
        }
        if (m->owners[face]) m->faces[m->owners[face] - 1]++;
    }
    for (uint32_t t = 0; t < m->track_count; t++) {
        if (m->faces[t] == 0) return dmi_fail(env, DM_ERROR_EMPTY_MASK, "track %u moves no triangle", t);
    }
    return DM_OK;
}

static int32_t join_owners(int32_t a, int32_t b) {
    if (a == b || b == DMI_MOVES_EMPTY) return a;
    return a == DMI_MOVES_EMPTY ? b : DMI_MOVES_MIXED;
}

/* Finds the track of each node. Bones place what a skin moves, so a node with a skin is never moved itself. */
static void find_own(dmi_moves* m) {
    const dm_gltf* gltf = m->gltf;
    for (uint32_t p = 0; p < gltf->piece_count; p++) {
        const dmi_gltf_piece* piece = &gltf->pieces[p];
        int32_t* own = &m->own[piece->mesh_node];
        for (uint64_t face = piece->first_face; face < piece->first_face + piece->face_count; face++) {
            const int32_t moves = (int32_t)m->owners[face] - 1;
            *own = join_owners(*own, piece->joint >= 0 && moves >= 0 ? DMI_MOVES_MIXED : moves);
        }
    }
}

/* Finds the track of each node with all below it. A joint stays where the other joints of its skin are. */
static void find_below(dmi_moves* m) {
    const dm_gltf* gltf = m->gltf;
    for (uint32_t i = 0; i < gltf->document.counts[DMI_GLTF_NODES]; i++)
        m->below[i] = gltf->tree[i].joint ? DMI_MOVES_MIXED : m->own[i];
    for (uint32_t at = gltf->order_count; at-- > 0;) {
        const uint32_t node = gltf->order[at];
        const int32_t parent = gltf->tree[node].parent;
        if (parent >= 0) m->below[parent] = join_owners(m->below[parent], m->below[node]);
    }
}

dm_result dmi_moves_open(dmi_moves* m, dmi_env* env, dm_gltf* gltf, const dm_gltf_track* tracks, uint32_t track_count) {
    const uint32_t nodes = gltf->document.counts[DMI_GLTF_NODES];
    *m = (dmi_moves){.gltf = gltf,
                     .track_count = track_count,
                     .owners = dmi_alloc_zeroed(env, gltf->face_count * sizeof *m->owners, 16),
                     .faces = dmi_alloc_zeroed(env, track_count * sizeof *m->faces, 16),
                     .own = dmi_alloc(env, nodes * sizeof *m->own, 16),
                     .below = dmi_alloc(env, nodes * sizeof *m->below, 16),
                     .first_pieces = dmi_alloc_zeroed(env, nodes * sizeof *m->first_pieces, 16),
                     .places = dmi_alloc_zeroed(env, gltf->vertex_count * sizeof *m->places, 16)};
    if (!m->owners || !m->faces || !m->own || !m->below || !m->first_pieces || !m->places)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_gltf_export: no memory for %" PRIu64 " triangles",
                        gltf->face_count);
    for (uint32_t i = 0; i < nodes; i++) m->own[i] = DMI_MOVES_EMPTY;
    for (uint32_t p = gltf->piece_count; p-- > 0;) m->first_pieces[gltf->pieces[p].mesh_node] = p;
    const dm_result result = claim_faces(m, env, tracks);
    if (result != DM_OK) return result;
    find_own(m);
    find_below(m);
    return DM_OK;
}

void dmi_moves_close(dmi_moves* m, dmi_env* env) {
    const uint32_t nodes = m->gltf->document.counts[DMI_GLTF_NODES];
    dmi_free(env, m->owners, m->gltf->face_count * sizeof *m->owners);
    dmi_free(env, m->faces, m->track_count * sizeof *m->faces);
    dmi_free(env, m->own, nodes * sizeof *m->own);
    dmi_free(env, m->below, nodes * sizeof *m->below);
    dmi_free(env, m->first_pieces, nodes * sizeof *m->first_pieces);
    dmi_free(env, m->places, m->gltf->vertex_count * sizeof *m->places);
}

uint64_t dmi_moves_count(const dmi_moves* m, const dmi_gltf_piece* piece, uint32_t owner) {
    uint64_t count = 0;
    for (uint64_t face = piece->first_face; face < piece->first_face + piece->face_count; face++)
        count += m->owners[face] == owner;
    return count;
}
