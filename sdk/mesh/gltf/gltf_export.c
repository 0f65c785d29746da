/* dm_gltf_export: the file again, with the moving faces in nodes of their own that an animation carries.
 *
 *   scene ─ … all that stays, as it was
 *         └ <track>            animated: at the pivot, moved by the poses
 *           └ (to the pivot)   translation -pivot, so that below it lies the scene's frame
 *             └ (transforms of the nodes above the part, when they have some)
 *               └ the part     a node that moves as a whole: itself; else the moving triangles of its mesh, which
 *                              share the vertices of those that stay
 *
 * The pivot lies on the axis of the motion, so a turn is a rotation alone and viewers interpolate it exactly. */
#include <inttypes.h>
#include <math.h>

#include "math/dual_quat.h"
#include "mesh/gltf/gltf_file.h"
#include "mesh/gltf/gltf_write.h"

typedef struct exporter {
    dmi_env* env;
    const dm_gltf* gltf;
    dmi_tiny* tiny; /* a copy of gltf's, being edited */
    const dm_gltf_track* tracks;
    uint32_t track_count;
    uint32_t* owner;   /* a face: 1 + the track that moves it, 0 = stays */
    uint64_t* moving;  /* faces a track */
    uint32_t* corners; /* room for the indices of any piece */
    int32_t* carriers; /* a track: the node below which the scene's frame lies */
    int32_t last_carrier, last_parent, last_hook;
} exporter;

static dm_result check_track(dmi_env* env, const dm_gltf_track* track, uint32_t which) {
    if (!track->face_ids || !track->poses || !track->times || track->key_count == 0)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "track %u: no faces, poses or times", which);
    for (uint32_t k = 0; k < track->key_count; k++) {
        const dm_pose* pose = &track->poses[k];
        float sum = 0;
        for (int i = 0; i < 4; i++) sum += pose->real[i] * pose->real[i] + fabsf(pose->dual[i]);
        if (!isfinite(sum)) return dmi_fail(env, DM_ERROR_NOT_FINITE, "track %u: pose %u is not finite", which, k);
        const float before = k ? track->times[k - 1] : -1;
        if (!isfinite(track->times[k]) || track->times[k] < 0 || track->times[k] <= before)
            return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "track %u: time %u is %g after %g, times must rise from 0",
                            which, k, (double)track->times[k], (double)before);
    }
    return DM_OK;
}

/* Whose is each face; the first of two tracks that claim one gets it. */
static dm_result claim_faces(exporter* e) {
    for (uint64_t face = 0; face < e->gltf->face_count; face++) {
        for (uint32_t t = e->track_count; t-- > 0;) {
            if (e->tracks[t].face_ids[face] == e->tracks[t].value) e->owner[face] = t + 1;
        }
        if (e->owner[face]) e->moving[e->owner[face] - 1]++;
    }
    for (uint32_t t = 0; t < e->track_count; t++) {
        if (e->moving[t] == 0) return dmi_fail(e->env, DM_ERROR_EMPTY_MASK, "track %u moves no triangle", t);
    }
    return DM_OK;
}

/* ---- the animation ---- */

static void part_centre(const exporter* e, uint32_t track, float out[3]) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint64_t corner = 0; corner < 3 * e->gltf->face_count; corner++) {
        if (e->owner[corner / 3] != track + 1) continue;
        const float* position = e->gltf->positions + 3 * (size_t)e->gltf->indices[corner];
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], (double)position[k]);
            high[k] = fmax(high[k], (double)position[k]);
        }
    }
    for (int k = 0; k < 3; k++) out[k] = (float)((low[k] + high[k]) / 2);
}

/* Where the axis of the largest turn passes the part; the part's centre when nothing turns. */
static void find_pivot(const exporter* e, uint32_t track, float out[3]) {
    const dm_gltf_track* from = &e->tracks[track];
    part_centre(e, track, out);
    float best = 1e-3f;
    dmi_screw screw = {{0, 0, 0}, {0, 0, 0}, 0, 0};
    for (uint32_t k = 0; k < from->key_count; k++) {
        const dmi_screw found = dmi_pose_to_screw(&from->poses[k]);
        const float turn = fabsf(sinf(found.angle / 2));
        if (turn <= best) continue;
        best = turn;
        screw = found;
    }
    if (screw.angle == 0) return;
    float along = 0;
    for (int k = 0; k < 3; k++) along += (out[k] - screw.point[k]) * screw.axis[k];
    for (int k = 0; k < 3; k++) out[k] = screw.point[k] + along * screw.axis[k];
}

/* A motion that ends elsewhere than it starts is followed by itself backwards, so that it repeats without a jump. */
static int ends_where_it_starts(const dm_gltf_track* track, const float pivot[3]) {
    const dm_pose *first = &track->poses[0], *last = &track->poses[track->key_count - 1];
    float a[3], b[3], same = 0, distance = 0, length = 0;
    dmi_pose_apply(first, pivot, a);
    dmi_pose_apply(last, pivot, b);
    for (int k = 0; k < 4; k++) same += first->real[k] * last->real[k];
    for (int k = 0; k < 3; k++) {
        distance = fmaxf(distance, fabsf(a[k] - b[k]));
        length = fmaxf(length, fabsf(a[k]));
    }
    return track->key_count > 1 && fabsf(same) > 1 - 1e-6f && distance <= 1e-5f * length;
}

typedef struct keys {
    float *times, *translations, *rotations;
    uint32_t count;
} keys;

/* Key `at` of the written motion from key `k` of the track. */
static void write_key(keys* out, uint32_t at, const dm_gltf_track* track, uint32_t k, const float pivot[3]) {
    const dm_pose pose = dmi_pose_normalize(&track->poses[k]);
    const uint32_t last = track->key_count - 1;
    out->times[at] = at <= last ? track->times[k] : 2 * track->times[last] - track->times[k];
    dmi_pose_apply(&pose, pivot, out->translations + 3 * (size_t)at);
    float* rotation = out->rotations + 4 * (size_t)at;
    float same = 0;
    for (int i = 0; i < 4 && at > 0; i++) same += pose.real[i] * rotation[i - 4];
    for (int i = 0; i < 4; i++) rotation[i] = same < 0 ? -pose.real[i] : pose.real[i]; /* the shorter way */
}

static void add_channels(exporter* e, int32_t animation, int32_t node, const keys* k) {
    const int32_t times_view = dmi_tiny_add_view(e->tiny, k->times, k->count * sizeof(float), 0);
    const int32_t times =
        dmi_tiny_add_accessor(e->tiny, times_view, DMI_TINY_FLOAT, 1, k->count, &k->times[0], &k->times[k->count - 1]);
    const int32_t moves_view = dmi_tiny_add_view(e->tiny, k->translations, k->count * 3 * sizeof(float), 0);
    const int32_t moves = dmi_tiny_add_accessor(e->tiny, moves_view, DMI_TINY_FLOAT, 3, k->count, NULL, NULL);
    const int32_t turns_view = dmi_tiny_add_view(e->tiny, k->rotations, k->count * 4 * sizeof(float), 0);
    const int32_t turns = dmi_tiny_add_accessor(e->tiny, turns_view, DMI_TINY_FLOAT, 4, k->count, NULL, NULL);
    dmi_tiny_add_channel(e->tiny, animation, node, "translation", times, moves);
    dmi_tiny_add_channel(e->tiny, animation, node, "rotation", times, turns);
}

static dm_result add_track(exporter* e, uint32_t track, int32_t animation) {
    const dm_gltf_track* from = &e->tracks[track];
    float pivot[3];
    find_pivot(e, track, pivot);
    const uint32_t count = ends_where_it_starts(from, pivot) ? from->key_count : 2 * from->key_count - 1;
    float* room = dmi_alloc(e->env, count * 8 * sizeof *room, 16);
    if (!room) return dmi_fail(e->env, DM_ERROR_OUT_OF_MEMORY, "track %u: no memory for %u keys", track, count);
    keys k = {.times = room, .translations = room + count, .rotations = room + 4 * (size_t)count, .count = count};
    for (uint32_t i = 0; i < count; i++) write_key(&k, i, from, i < from->key_count ? i : count - 1 - i, pivot);
    const double at[3] = {(double)pivot[0], (double)pivot[1], (double)pivot[2]};
    const double back[3] = {-at[0], -at[1], -at[2]};
    const int32_t node = dmi_tiny_add_node(e->tiny, from->name ? from->name : "moving_part", -1);
    e->carriers[track] = dmi_tiny_add_node(e->tiny, NULL, -1);
    dmi_tiny_set_translation(e->tiny, node, at);
    dmi_tiny_set_translation(e->tiny, e->carriers[track], back);
    dmi_tiny_add_root(e->tiny, node);
    dmi_tiny_add_child(e->tiny, node, e->carriers[track]);
    add_channels(e, animation, node, &k);
    dmi_free(e->env, room, count * 8 * sizeof *room);
    return DM_OK;
}

/* ---- the parts ---- */

static int is_identity(const double m[16]) {
    for (int i = 0; i < 16; i++) {
        if (m[i] != (i % 5 == 0 ? 1.0 : 0.0)) return 0;
    }
    return 1;
}

/* The node below the track's carrier that stands where `parent` stands in the scene: its chain of transforms again. */
static int32_t hook_below(exporter* e, int32_t carrier, int32_t parent) {
    if (parent < 0) return carrier;
    if (carrier == e->last_carrier && parent == e->last_parent) return e->last_hook;
    dmi_tiny_node from;
    dmi_tiny_get_node(e->gltf->tiny, (uint32_t)parent, &from);
    int32_t hook = hook_below(e, carrier, e->gltf->parents[parent]);
    if (!is_identity(from.matrix)) {
        const int32_t link = dmi_tiny_add_node(e->tiny, NULL, -1);
        dmi_tiny_copy_transform(e->tiny, parent, link);
        dmi_tiny_add_child(e->tiny, hook, link);
        hook = link;
    }
    e->last_carrier = carrier;
    e->last_parent = parent;
    e->last_hook = hook;
    return hook;
}

/* An accessor of the piece's triangles that `owner` has, as the primitive counts its vertices. */
static int32_t split_indices(exporter* e, const dmi_gltf_piece* piece, uint32_t owner) {
    uint64_t count = 0;
    for (uint64_t face = piece->first_face; face < piece->first_face + piece->face_count; face++) {
        if (e->owner[face] != owner) continue;
        const uint32_t* from = e->gltf->indices + 3 * face;
        for (int corner = 0; corner < 3; corner++)
            e->corners[count++] = from[piece->mirrored ? 2 - corner : corner] - (uint32_t)piece->first_vertex;
    }
    const int32_t view = dmi_tiny_add_view(e->tiny, e->corners, count * sizeof *e->corners, DMI_TINY_INDICES);
    return dmi_tiny_add_accessor(e->tiny, view, DMI_TINY_UINT, 1, count, NULL, NULL);
}

static uint64_t owned_faces(const exporter* e, uint64_t first, uint64_t count, uint32_t owner) {
    uint64_t owned = 0;
    for (uint64_t face = first; face < first + count; face++) owned += e->owner[face] == owner;
    return owned;
}

/* A mesh of the node's triangles that `owner` has; with owner 0 also of what has no triangles. -1: nothing. */
static int32_t split_mesh(exporter* e, uint32_t node, int32_t mesh, uint32_t owner) {
    int32_t split = -1;
    uint32_t at = 0;
    const dm_gltf* gltf = e->gltf;
    for (uint32_t p = 0; p < dmi_tiny_primitive_count(gltf->tiny, mesh); p++) {
        while (at < gltf->piece_count &&
               (gltf->pieces[at].node < node || (gltf->pieces[at].node == node && gltf->pieces[at].primitive < p)))
            at++;
        const dmi_gltf_piece* piece = &gltf->pieces[at];
        const int merged = at < gltf->piece_count && piece->node == node && piece->primitive == p;
        const uint64_t owned = merged ? owned_faces(e, piece->first_face, piece->face_count, owner) : 0;
        if (owned == 0 && (merged || owner != 0)) continue;
        if (split < 0) split = dmi_tiny_add_mesh(e->tiny, NULL, mesh);
        const int whole = !merged || owned == piece->face_count;
        dmi_tiny_copy_primitive(e->tiny, mesh, p, split, whole ? -1 : split_indices(e, piece, owner));
    }
    return split;
}

/* Hangs what track `t` moves of the merged node below the track. */
static void move_node(exporter* e, uint32_t node, uint32_t t) {
    const dm_gltf_node* merged = &e->gltf->nodes[node];
    dmi_tiny_node from;
    dmi_tiny_get_node(e->gltf->tiny, merged->node, &from);
    const int32_t hook = hook_below(e, e->carriers[t], e->gltf->parents[merged->node]);
    int32_t moved = (int32_t)merged->node;
    if (owned_faces(e, merged->first_face, merged->face_count, t + 1) == merged->face_count) {
        dmi_tiny_unhook(e->tiny, moved);
    } else {
        moved = dmi_tiny_add_node(e->tiny, merged->name, split_mesh(e, node, from.mesh, t + 1));
        dmi_tiny_copy_transform(e->tiny, (int32_t)merged->node, moved);
    }
    dmi_tiny_add_child(e->tiny, hook, moved);
}

static void move_parts(exporter* e) {
    for (uint32_t node = 0; node < e->gltf->node_count; node++) {
        const dm_gltf_node* merged = &e->gltf->nodes[node];
        int whole = 0, touched = 0;
        for (uint32_t t = 0; t < e->track_count; t++) {
            const uint64_t owned = owned_faces(e, merged->first_face, merged->face_count, t + 1);
            if (owned == 0) continue;
            move_node(e, node, t);
            touched = 1;
            whole |= owned == merged->face_count;
        }
        if (!touched || whole) continue;
        dmi_tiny_node from;
        dmi_tiny_get_node(e->gltf->tiny, merged->node, &from);
        dmi_tiny_set_mesh(e->tiny, (int32_t)merged->node, split_mesh(e, node, from.mesh, 0));
    }
}

/* ---- the whole ---- */

static dm_result run(exporter* e, void** out_data, size_t* out_size) {
    if (!e->owner || !e->moving || !e->corners || !e->carriers || !e->tiny)
        return dmi_fail(e->env, DM_ERROR_OUT_OF_MEMORY, "dm_gltf_export: no memory for %" PRIu64 " triangles",
                        e->gltf->face_count);
    dm_result result = claim_faces(e);
    if (result != DM_OK) return result;
    dmi_tiny_embed(e->tiny);
    const int32_t animation = dmi_tiny_add_animation(e->tiny, "dragmesh");
    for (uint32_t t = 0; t < e->track_count && result == DM_OK; t++) result = add_track(e, t, animation);
    if (result != DM_OK) return result;
    move_parts(e);
    return dmi_gltf_finish(e->env, e->tiny, out_data, out_size);
}

dm_result dm_gltf_export(const dm_gltf* gltf, const dm_gltf_track* tracks, uint32_t track_count, void** out_data,
                         size_t* out_size) {
    if (!gltf) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env env;
    dmi_env_init(&env, &gltf->env.allocator, &gltf->env.log, NULL);
    if (!tracks || track_count == 0 || !out_data || !out_size)
        return dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_export: no track, or no place for the result");
    for (uint32_t t = 0; t < track_count; t++) {
        const dm_result result = check_track(&env, &tracks[t], t);
        if (result != DM_OK) return result;
    }
    const uint64_t faces = gltf->face_count;
    exporter e = {.env = &env,
                  .gltf = gltf,
                  .tiny = dmi_tiny_clone(gltf->tiny),
                  .tracks = tracks,
                  .track_count = track_count,
                  .owner = dmi_alloc_zeroed(&env, faces * sizeof *e.owner, 16),
                  .moving = dmi_alloc_zeroed(&env, track_count * sizeof *e.moving, 16),
                  .corners = dmi_alloc(&env, 3 * faces * sizeof *e.corners, 16),
                  .carriers = dmi_alloc_zeroed(&env, track_count * sizeof *e.carriers, 16),
                  .last_carrier = -1};
    const dm_result result = run(&e, out_data, out_size);
    dmi_free(&env, e.owner, faces * sizeof *e.owner);
    dmi_free(&env, e.moving, track_count * sizeof *e.moving);
    dmi_free(&env, e.corners, 3 * faces * sizeof *e.corners);
    dmi_free(&env, e.carriers, track_count * sizeof *e.carriers);
    dmi_tiny_free(e.tiny);
    return result;
}
