/* Finds which faces, nodes and trees of nodes move with which track, and writes the keys of a track as an animated
 * node. */
#include "gltf/gltf_moves.h"

#include <inttypes.h>
#include <math.h>
#include <stdbool.h>

#include "math/dual_quat.h"
#include "math/elementary.h"

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

/* ---- keys of a track as an animated node ---- */

static void part_centre(const dmi_moves* moves, uint32_t track, float out[3]) {
    const dm_gltf* gltf = moves->gltf;
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint64_t corner = 0; corner < 3 * gltf->face_count; corner++) {
        if (moves->owners[corner / 3] != track + 1) continue;
        const float* position = gltf->positions + 3 * (size_t)gltf->indices[corner];
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], (double)position[k]);
            high[k] = fmax(high[k], (double)position[k]);
        }
    }
    for (int k = 0; k < 3; k++) out[k] = (float)((low[k] + high[k]) / 2);
}

/* Writes where the axis of the largest turn passes the part, or the part's centre when nothing turns. */
static void find_pivot(const dmi_moves* moves, const dm_gltf_track* from, uint32_t track, float out[3]) {
    part_centre(moves, track, out);
    float best = 1e-3f;
    dmi_screw screw = {{0, 0, 0}, {0, 0, 0}, 0, 0};
    for (uint32_t k = 0; k < from->key_count; k++) {
        const dmi_screw found = dmi_pose_to_screw(&from->poses[k]);
        const float turn = fabsf(dmi_sinf(found.angle / 2));
        if (turn <= best) continue;
        best = turn;
        screw = found;
    }
    if (screw.angle == 0) return;
    float along = 0;
    for (int k = 0; k < 3; k++) along += (out[k] - screw.point[k]) * screw.axis[k];
    for (int k = 0; k < 3; k++) out[k] = screw.point[k] + along * screw.axis[k];
}

/* Returns whether a motion ends where it starts. One that does not is followed by itself backwards, so that it repeats
 * without a jump. */
static int ends_where_it_starts(const dm_gltf_track* track, const float pivot[3]) {
    const dm_pose *first = &track->poses[0], *last = &track->poses[track->key_count - 1];
    float a[3], b[3], same = 0, distance = 0, length = 0;
    dmi_pose_apply(first, pivot, a);
    dmi_pose_apply(last, pivot, b);
    for (int k = 0; k < 4; k++) same += first->real[k] * last->real[k];
    for (int k = 0; k < 3; k++) {
        distance = dmi_fmaxf(distance, fabsf(a[k] - b[k]));
        length = dmi_fmaxf(length, fabsf(a[k]));
    }
    return track->key_count > 1 && fabsf(same) > 1 - 1e-6f && distance <= 1e-5f * length;
}

typedef struct keys {
    float *times, *translations, *rotations;
    uint32_t count;
} keys;

/* Writes key `at` of the new motion from key `k` of the track. */
static void write_key(keys* out, uint32_t at, const dm_gltf_track* track, uint32_t k, const float pivot[3],
                      const double origin[3]) {
    const dm_pose pose = dmi_pose_normalize(&track->poses[k]);
    const uint32_t last = track->key_count - 1;
    out->times[at] = at <= last ? track->times[k] : 2 * track->times[last] - track->times[k];
    float* translation = out->translations + 3 * (size_t)at;
    dmi_pose_apply(&pose, pivot, translation);
    for (int i = 0; i < 3; i++) translation[i] = (float)((double)translation[i] + origin[i]);
    float* rotation = out->rotations + 4 * (size_t)at;
    float same = 0;
    for (int i = 0; i < 4 && at > 0; i++) same += pose.real[i] * rotation[i - 4];
    for (int i = 0; i < 4; i++) rotation[i] = same < 0 ? -pose.real[i] : pose.real[i]; /* the shorter way */
}

static bool are_finite(const keys* k) {
    bool finite = true;
    for (size_t i = 0; i < 3 * (size_t)k->count; i++) finite = finite && isfinite(k->translations[i]);
    for (size_t i = 0; i < 4 * (size_t)k->count; i++) finite = finite && isfinite(k->rotations[i]);
    return finite;
}

static void add_channel(dmi_edit* e, cJSON* animation, int32_t node, const char* path, int32_t times, int32_t values) {
    cJSON* samplers = dmi_edit_list(e, animation, "samplers");
    cJSON* sampler = dmi_edit_new(e, cJSON_CreateObject());
    cJSON* channel = dmi_edit_new(e, cJSON_CreateObject());
    cJSON* target = dmi_edit_object(e, channel, "target");
    dmi_edit_number(e, sampler, "input", times);
    dmi_edit_number(e, sampler, "output", values);
    dmi_edit_text(e, sampler, "interpolation", "LINEAR");
    dmi_edit_number(e, channel, "sampler", cJSON_GetArraySize(samplers));
    dmi_edit_number(e, target, "node", node);
    dmi_edit_text(e, target, "path", path);
    dmi_edit_append(e, samplers, sampler);
    dmi_edit_append(e, dmi_edit_list(e, animation, "channels"), channel);
}

static void add_channels(dmi_edit* e, cJSON* animation, int32_t node, const keys* k) {
    const int32_t times_view = dmi_edit_add_view(e, k->times, k->count * sizeof(float), 0);
    const int32_t times =
        dmi_edit_add_accessor(e, times_view, DMI_GLTF_FLOAT, 1, k->count, &k->times[0], &k->times[k->count - 1]);
    const int32_t moves_view = dmi_edit_add_view(e, k->translations, 3 * sizeof(float) * k->count, 0);
    const int32_t moves = dmi_edit_add_accessor(e, moves_view, DMI_GLTF_FLOAT, 3, k->count, NULL, NULL);
    const int32_t turns_view = dmi_edit_add_view(e, k->rotations, 4 * sizeof(float) * k->count, 0);
    const int32_t turns = dmi_edit_add_accessor(e, turns_view, DMI_GLTF_FLOAT, 4, k->count, NULL, NULL);
    add_channel(e, animation, node, "translation", times, moves);
    add_channel(e, animation, node, "rotation", times, turns);
}

cJSON* dmi_animation_add(dmi_edit* e, const char* name) {
    cJSON* animations = dmi_edit_list(e, e->document.root, "animations");
    cJSON* animation = dmi_edit_new(e, cJSON_CreateObject());
    dmi_edit_text(e, animation, "name", name);
    if (e->problem.code == DM_OK && cJSON_InsertItemInArray(animations, 0, animation)) return animation;
    cJSON_Delete(animation);
    return NULL;
}

dmi_edit_item dmi_animation_add_track(dmi_edit* e, const dmi_moves* moves, cJSON* animation, const dm_gltf_track* track,
                                      uint32_t index, double out_pivot[3]) {
    const double* origin = moves->gltf->origin;
    float pivot[3];
    find_pivot(moves, track, index, pivot);
    for (int k = 0; k < 3; k++) out_pivot[k] = (double)pivot[k] + origin[k];
    const uint32_t count = ends_where_it_starts(track, pivot) ? track->key_count : 2 * track->key_count - 1;
    const dmi_edit_item node = dmi_edit_add(e, DMI_GLTF_NODES, NULL);
    float* room = dmi_alloc(e->env, (size_t)count * 8 * sizeof *room, 16);
    if (!room) {
        dmi_gltf_refuse(&e->problem, DM_ERROR_OUT_OF_MEMORY, "track %u: no memory for %u keys", index, count);
        return node;
    }
    keys k = {.times = room, .translations = room + count, .rotations = room + 4 * (size_t)count, .count = count};
    for (uint32_t i = 0; i < count; i++)
        write_key(&k, i, track, i < track->key_count ? i : count - 1 - i, pivot, origin);
    if (!are_finite(&k))
        dmi_gltf_refuse(&e->problem, DM_ERROR_NOT_FINITE, "track %u: the part moves beyond what a file holds", index);
    dmi_edit_text(e, node.json, "name", track->name ? track->name : "moving_part");
    dmi_edit_numbers(e, node.json, "translation", out_pivot, 3);
    add_channels(e, animation, node.index, &k);
    dmi_free(e->env, room, (size_t)count * 8 * sizeof *room);
    return node;
}
