/* dm_gltf_export: the file again, with the moving faces in nodes of their own that an animation carries.
 *
 *   scene ─ … all that stays, as it was
 *         └ <track>            animated: at the pivot, moved by the poses
 *           └ (to the pivot)   translation -pivot, so that below it lies the scene's frame
 *             └ (transforms of the nodes above the part, when they have some)
 *               └ the part     a node that moves as a whole: itself, with all below it when that moves too; else the
 *                              moving triangles of its mesh
 */
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/fp_environment.h"
#include "gltf/gltf_buffers.h"
#include "gltf/gltf_edit.h"
#include "gltf/gltf_moves.h"
#include "gltf/gltf_tree.h"
#include "math/dual_quat.h"
#include "math/elementary.h"

/* What becomes of a node in the lists of children and roots, besides the index of its stand-in. */
enum { KEPT = -1, GONE = -2, MOVED_ALONE = -3 /* what is below it stays */ };

typedef struct exporter {
    dmi_edit edit;
    dmi_moves moves;
    dm_gltf* gltf;
    const dm_gltf_track* tracks;
    uint32_t track_count;
    dmi_edit_item* carriers; /* per track: the node below which the scene's frame lies */
    int32_t* places;         /* per node of the file: KEPT, GONE, or the node in its place */
    uint8_t* carried;        /* per node of the file: 1 when it went with one above it */
    /* Per node of the file: what stands for it below the carrier of the track that is being written. */
    dmi_edit_item* hooks;
    uint32_t* path; /* room for the nodes above one */
} exporter;

/* ---- images beside the document ---- */

/* Returns the media type by the first bytes, or NULL for one that glTF and its extensions lack. */
static const char* media_type(const uint8_t* data, size_t size) {
    static const struct {
        const char* type;
        const char* start;
        size_t length;
    } types[] = {{"image/png", "\x89PNG", 4},
                 {"image/jpeg", "\xFF\xD8\xFF", 3},
                 {"image/ktx2", "\xABKTX 20", 7},
                 {"image/vnd-ms.dds", "DDS ", 4}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++) {
        if (size >= types[i].length && memcmp(data, types[i].start, types[i].length) == 0) return types[i].type;
    }
    return size >= 12 && memcmp(data, "RIFF", 4) == 0 && memcmp(data + 8, "WEBP", 4) == 0 ? "image/webp" : NULL;
}

static void embed_image(dmi_edit* e, cJSON* image, const char* path) {
    const dm_gltf_files* files = &e->from->files;
    const void* data;
    size_t size = 0;
    const dm_result opened = files->open(files->user, path, &data, &size);
    if (opened == DM_ERROR_OUT_OF_MEMORY)
        dmi_gltf_refuse(&e->problem, opened, "glTF: no memory for the image '%s'", dmi_uri_shorten(path).text);
    if (opened != DM_OK) return;
    const char* type = media_type(data, size);
    if (type) {
        const int32_t view = dmi_edit_add_view(e, data, size, 0);
        dmi_edit_number(e, image, "bufferView", view);
        dmi_edit_text(e, image, "mimeType", type);
        cJSON_DeleteItemFromObjectCaseSensitive(image, "uri");
    }
    files->close(files->user, data, size);
}

/* Puts the images that the host hands over into the buffer. Others keep their URIs. */
static void images_embed(dmi_edit* e) {
    for (uint32_t i = 0; e->from->files.open && i < e->document.counts[DMI_GLTF_IMAGES]; i++) {
        if (e->problem.code != DM_OK) return;
        cJSON* image = e->document.items[DMI_GLTF_IMAGES][i];
        const char* uri = dmi_json_text(image, "uri");
        if (!uri || dmi_uri_is_data(uri)) continue;
        const size_t room = strlen(uri) + 1;
        dmi_gltf_problem elsewhere;
        char* path = dmi_alloc(e->env, room, 1);
        if (!path)
            dmi_gltf_refuse(&e->problem, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for a path");
        else if (dmi_uri_to_path(uri, &elsewhere, path) == DM_OK)
            embed_image(e, image, path);
        dmi_free(e->env, path, room);
    }
}

/* ---- checks ---- */

/* Checks a host's pose, by the bounds of a drag's poses. */
static dm_result check_pose(dmi_env* env, const dm_pose* pose, uint32_t track, uint32_t key) {
    float length, sum = 0, most = 0;
    for (int i = 0; i < 4; i++) {
        sum += fabsf(pose->real[i]) + fabsf(pose->dual[i]);
        most = dmi_fmaxf(most, fabsf(pose->dual[i]));
    }
    if (!isfinite(sum)) return dmi_fail(env, DM_ERROR_NOT_FINITE, "track %u: pose %u is not finite", track, key);
    if (!dmi_pose_is_near_unit(pose, &length))
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                        "track %u: pose %u has a rotation of length %g: it must be a unit quaternion", track, key,
                        (double)length);
    if (most > DMI_LARGEST_DUAL)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "track %u: pose %u moves by %g, more than %g", track, key,
                        2 * (double)most, 2 * (double)DMI_LARGEST_DUAL);
    return DM_OK;
}

static dm_result check_track(dmi_env* env, const dm_gltf_track* track, uint32_t which) {
    if (!track->face_ids || !track->poses || !track->times || track->key_count == 0)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "track %u: no faces, poses or times", which);
    if (track->key_count > DM_MAX_ELEMENTS)
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "track %u: more than %d keys", which, DM_MAX_ELEMENTS);
    for (uint32_t k = 0; k < track->key_count; k++) {
        const dm_result result = check_pose(env, &track->poses[k], which, k);
        if (result != DM_OK) return result;
        const float before = k ? track->times[k - 1] : -1;
        if (!(track->times[k] >= 0 && track->times[k] <= DMI_LARGEST && track->times[k] > before))
            return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                            "track %u: time %u is %g after %g, times must rise from 0, to %g at most", which, k,
                            (double)track->times[k], (double)before, (double)DMI_LARGEST);
    }
    return DM_OK;
}

/* ---- the nodes above a part ---- */

static int is_identity(const double m[16]) {
    for (int i = 0; i < 16; i++) {
        if (m[i] != (i % 5 == 0 ? 1.0 : 0.0)) return 0;
    }
    return 1;
}

/* Gives a node the transform of one of the file, as the file writes it. */
static void copy_transform(dmi_edit* e, const cJSON* from, cJSON* to) {
    static const char* const names[] = {"matrix", "translation", "rotation", "scale"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const cJSON* found = dmi_json_get(from, names[i]);
        if (found) dmi_edit_set(e, to, names[i], cJSON_Duplicate(found, 1));
    }
}

static void add_child(dmi_edit* e, cJSON* parent, int32_t child) {
    dmi_edit_append_number(e, dmi_edit_list(e, parent, "children"), child);
}

/* Clears the hooks of the track before. */
static void clear_hooks(exporter* x) {
    for (uint32_t i = 0; i < x->gltf->document.counts[DMI_GLTF_NODES]; i++) x->hooks[i] = (dmi_edit_item){NULL, -1};
}

/* Returns the node below the track's carrier that stands where the parent of `node` stands in the scene. It repeats the
 * chain of transforms. */
static dmi_edit_item hook_above(exporter* x, uint32_t track, uint32_t node) {
    dmi_edit* e = &x->edit;
    uint32_t length = 0;
    int32_t at = x->gltf->tree[node].parent;
    for (; at >= 0 && !x->hooks[at].json; at = x->gltf->tree[at].parent) x->path[length++] = (uint32_t)at;
    dmi_edit_item hook = at >= 0 ? x->hooks[at] : x->carriers[track];
    while (length > 0) {
        const uint32_t step = x->path[--length];
        double local[16];
        dmi_gltf_local_matrix(x->gltf->tree[step].json, local);
        if (!is_identity(local)) {
            const dmi_edit_item link = dmi_edit_add(e, DMI_GLTF_NODES, NULL);
            copy_transform(e, x->gltf->tree[step].json, link.json);
            add_child(e, hook.json, link.index);
            hook = link;
        }
        x->hooks[step] = hook;
    }
    return hook;
}

/* ---- the parts ---- */

static cJSON* node_of(exporter* x, uint32_t node) {
    return x->edit.problem.code == DM_OK ? x->edit.document.items[DMI_GLTF_NODES][node] : NULL;
}

/* Hangs a node of the file below the track. */
static void move_node(exporter* x, uint32_t track, uint32_t node, int alone) {
    add_child(&x->edit, hook_above(x, track, node).json, (int32_t)node);
    x->places[node] = alone ? MOVED_ALONE : GONE;
}

/* Hangs the triangles of a node that a track moves below it. */
static void move_triangles(exporter* x, uint32_t track, uint32_t node) {
    dmi_edit* e = &x->edit;
    const dmi_gltf_tree_node* from = &x->gltf->tree[node];
    const int skinned = x->gltf->pieces[x->moves.first_pieces[node]].joint >= 0;
    const int32_t mesh = dmi_split_mesh(e, &x->moves, node, track + 1);
    if (mesh < 0) return;
    const dmi_edit_item part = dmi_edit_add(e, DMI_GLTF_NODES, NULL);
    const double* origin = x->gltf->origin;
    if (from->name[0]) dmi_edit_text(e, part.json, "name", from->name);
    dmi_edit_number(e, part.json, "mesh", mesh);
    if (!skinned)
        copy_transform(e, from->json, part.json);
    else if (origin[0] != 0 || origin[1] != 0 || origin[2] != 0)
        dmi_edit_numbers(e, part.json, "translation", origin, 3);
    add_child(e, skinned ? x->carriers[track].json : hook_above(x, track, node).json, part.index);
}

/* Leaves a node the triangles that stay. */
static void leave_triangles(exporter* x, uint32_t node) {
    const int32_t mesh = dmi_split_mesh(&x->edit, &x->moves, node, 0);
    cJSON* json = node_of(x, node);
    if (!json) return;
    if (mesh >= 0) {
        dmi_edit_number(&x->edit, json, "mesh", mesh);
        return;
    }
    cJSON_DeleteItemFromObjectCaseSensitive(json, "mesh");
    cJSON_DeleteItemFromObjectCaseSensitive(json, "skin");
    cJSON_DeleteItemFromObjectCaseSensitive(json, "weights");
}

/* Returns whether some piece of the node has triangles of the track. */
static int has_triangles(const exporter* x, uint32_t node, uint32_t track) {
    const dm_gltf* gltf = x->gltf;
    for (uint32_t p = x->moves.first_pieces[node]; p < gltf->piece_count && gltf->pieces[p].mesh_node == node; p++) {
        if (dmi_moves_count(&x->moves, &gltf->pieces[p], track + 1) > 0) return 1;
    }
    return 0;
}

/* Returns whether the node is no body, and goes with one that the track moves as a whole. What bones place stays with
 * them. */
static bool goes_along(const exporter* x, uint32_t node, uint32_t track) {
    const int32_t followed = x->gltf->tree[node].follows;
    if (followed < 0 || dmi_json_get(x->gltf->tree[node].json, "skin")) return false;
    return x->moves.own[followed] == (int32_t)track || x->moves.below[followed] == (int32_t)track;
}

/* Moves the parts of a track. Parents come before their children, so that what moves as a whole is found from above. */
static void move_parts(exporter* x, uint32_t track) {
    clear_hooks(x);
    for (uint32_t at = 0; at < x->gltf->order_count; at++) {
        const uint32_t node = x->gltf->order[at];
        const int32_t parent = x->gltf->tree[node].parent;
        if (parent >= 0 && x->carried[parent]) x->carried[node] = 1;
        if (x->carried[node]) continue;
        if (x->moves.below[node] == (int32_t)track) {
            move_node(x, track, node, 0);
            x->carried[node] = 1;
        } else if (x->moves.own[node] == (int32_t)track) {
            move_node(x, track, node, 1);
        } else if (x->moves.own[node] == DMI_MOVES_MIXED && has_triangles(x, node, track)) {
            move_triangles(x, track, node);
        } else if (goes_along(x, node, track)) {
            x->carried[node] = x->moves.below[node] == DMI_MOVES_EMPTY;
            move_node(x, track, node, !x->carried[node]);
        }
    }
}

static void leave_parts(exporter* x) {
    for (uint32_t i = 0; i < x->gltf->document.counts[DMI_GLTF_NODES]; i++) {
        if (x->moves.own[i] == DMI_MOVES_MIXED) leave_triangles(x, i);
    }
}

/* ---- lists of nodes ---- */

/* Removes what has gone from a list of nodes of the file, and the list from its owner when nothing is left. */
static void mend_list(exporter* x, cJSON* owner, const char* name) {
    cJSON* list = owner ? cJSON_GetObjectItemCaseSensitive(owner, name) : NULL;
    for (cJSON *item = list ? list->child : NULL, *next; item; item = next) {
        next = item->next;
        const int64_t node = dmi_gltf_position(&x->gltf->document, DMI_GLTF_NODES, item->valuedouble);
        if (node < 0 || x->places[node] == KEPT) continue;
        if (x->places[node] == GONE)
            cJSON_Delete(cJSON_DetachItemViaPointer(list, item));
        else
            cJSON_SetNumberHelper(item, x->places[node]);
    }
    if (list && !list->child) cJSON_DeleteItemFromObjectCaseSensitive(owner, name);
}

/* Puts an unnamed node in the place of one that has gone from above others. */
static void stand_in(exporter* x, uint32_t node) {
    dmi_edit* e = &x->edit;
    cJSON* json = node_of(x, node);
    cJSON* children = json ? cJSON_DetachItemFromObjectCaseSensitive(json, "children") : NULL;
    x->places[node] = GONE;
    if (!children) return;
    const dmi_edit_item made = dmi_edit_add(e, DMI_GLTF_NODES, NULL);
    dmi_edit_set(e, made.json, "children", children);
    copy_transform(e, x->gltf->tree[node].json, made.json);
    x->places[node] = made.index;
}

/* Mends all lists. Children come before their parents, so that a place is known before it is needed. */
static void mend_lists(exporter* x) {
    for (uint32_t at = x->gltf->order_count; at-- > 0;) {
        const uint32_t node = x->gltf->order[at];
        mend_list(x, node_of(x, node), "children");
        if (x->places[node] == MOVED_ALONE) stand_in(x, node);
    }
    for (uint32_t i = 0; x->edit.problem.code == DM_OK && i < x->edit.document.counts[DMI_GLTF_SCENES]; i++)
        mend_list(x, x->edit.document.items[DMI_GLTF_SCENES][i], "nodes");
}

/* Returns the list of roots of the scene that a viewer shows. A scene that shows all roots gets them as a list. */
static cJSON* shown_roots(exporter* x) {
    dmi_edit* e = &x->edit;
    const dmi_gltf_document* old = &x->gltf->document;
    const double number = dmi_json_number(old->root, "scene", DMI_GLTF_NO_INDEX);
    const int64_t scene = dmi_gltf_position(old, DMI_GLTF_SCENES, number);
    const cJSON* listed = dmi_json_get(dmi_gltf_item(old, DMI_GLTF_SCENES, scene < 0 ? 0 : (double)scene), "nodes");
    if (scene < 0) dmi_edit_number(e, e->document.root, "scene", 0);
    cJSON* json = NULL;
    if (e->problem.code == DM_OK && old->counts[DMI_GLTF_SCENES] > 0)
        json = e->document.items[DMI_GLTF_SCENES][scene < 0 ? 0 : scene];
    else
        json = dmi_edit_add(e, DMI_GLTF_SCENES, NULL).json;
    cJSON* roots = dmi_edit_list(e, json, "nodes");
    for (uint32_t i = 0; !(listed && listed->child) && i < old->counts[DMI_GLTF_NODES]; i++) {
        if (x->gltf->tree[i].parent < 0 && x->places[i] != GONE)
            dmi_edit_append_number(e, roots, x->places[i] == KEPT ? (int32_t)i : x->places[i]);
    }
    return roots;
}

/* ---- the whole ---- */

/* Adds the animated node of a track, and behind it the one below that carries the scene's frame. */
static void add_track(exporter* x, cJSON* animation, uint32_t track) {
    dmi_edit* e = &x->edit;
    double pivot[3];
    const dmi_edit_item node = dmi_animation_add_track(e, &x->moves, animation, &x->tracks[track], track, pivot);
    const double back[3] = {-pivot[0], -pivot[1], -pivot[2]};
    x->carriers[track] = dmi_edit_add(e, DMI_GLTF_NODES, NULL);
    dmi_edit_numbers(e, x->carriers[track].json, "translation", back, 3);
    add_child(e, node.json, x->carriers[track].index);
}

static dm_result write_export(exporter* x, void** out_data, size_t* out_size) {
    dmi_edit* e = &x->edit;
    cJSON* animation = x->track_count > 0 ? dmi_animation_add(e, "dragmesh") : NULL;
    const int32_t first = (int32_t)e->counts[DMI_GLTF_NODES];
    dmi_edit_tell(e, DMI_STAGE_EXPORT_OPENED, DMI_PROGRESS_STEP);
    for (uint32_t t = 0; t < x->track_count; t++) add_track(x, animation, t);
    dmi_edit_tell(e, DMI_STAGE_EXPORT_TRACKS_ADDED, DMI_PROGRESS_STEP);
    for (uint32_t t = 0; t < x->track_count; t++) move_parts(x, t);
    dmi_edit_tell(e, DMI_STAGE_EXPORT_PARTS_MOVED, DMI_PROGRESS_STEP);
    leave_parts(x);
    mend_lists(x);
    dmi_edit_tell(e, DMI_STAGE_EXPORT_LISTS_MENDED, DMI_PROGRESS_STEP);
    cJSON* roots = shown_roots(x);
    for (uint32_t t = 0; t < x->track_count; t++) dmi_edit_append_number(e, roots, first + 2 * (int32_t)t);
    images_embed(e);
    dmi_edit_drop_unused(e, DMI_DRACO_NAME);
    dmi_edit_drop_unused(e, DMI_INSTANCING_NAME);
    return dmi_edit_write(e, out_data, out_size);
}

static dm_result open_exporter(exporter* x, dmi_env* env) {
    const uint32_t nodes = x->gltf->document.counts[DMI_GLTF_NODES];
    const dm_result result = dmi_moves_open(&x->moves, env, x->gltf, x->tracks, x->track_count);
    if (result != DM_OK) return result;
    x->carriers = dmi_alloc(env, x->track_count * sizeof *x->carriers, 16);
    x->places = dmi_alloc(env, nodes * sizeof *x->places, 16);
    x->carried = dmi_alloc_zeroed(env, nodes, 1);
    x->hooks = dmi_alloc(env, nodes * sizeof *x->hooks, 16);
    x->path = dmi_alloc(env, nodes * sizeof *x->path, 16);
    if (!x->carriers || !x->places || !x->carried || !x->hooks || !x->path)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_gltf_export: no memory for %u nodes", nodes);
    for (uint32_t i = 0; i < nodes; i++) x->places[i] = KEPT;
    return DM_OK;
}

static void close_exporter(exporter* x, dmi_env* env) {
    const uint32_t nodes = x->gltf->document.counts[DMI_GLTF_NODES];
    dmi_moves_close(&x->moves, env);
    dmi_free(env, x->carriers, x->track_count * sizeof *x->carriers);
    dmi_free(env, x->places, nodes * sizeof *x->places);
    dmi_free(env, x->carried, nodes);
    dmi_free(env, x->hooks, nodes * sizeof *x->hooks);
    dmi_free(env, x->path, nodes * sizeof *x->path);
    dmi_edit_close(&x->edit);
}

dm_result dm_gltf_export(const dm_gltf* gltf, const dm_gltf_track* tracks, uint32_t track_count, void** out_data,
                         size_t* out_size) {
    DMI_OWN_FP;
    if (!gltf) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env env;
    dmi_env_init(&env, &gltf->env.allocator, &gltf->env.log, NULL);
    if ((!tracks && track_count > 0) || !out_data || !out_size)
        return dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "dm_gltf_export: no tracks, or no place for the result");
    for (uint32_t t = 0; t < track_count; t++) {
        const dm_result result = check_track(&env, &tracks[t], t);
        if (result != DM_OK) return result;
    }
    dm_gltf* file = (dm_gltf*)gltf; /* the file keeps what it decompresses */
    file->bytes_left = file->bytes_most;
    file->told = 0;
    exporter x = {.edit = {.env = &env}, .gltf = file, .tracks = tracks, .track_count = track_count};
    dm_result result = open_exporter(&x, &env);
    if (result == DM_OK) {
        dmi_edit_open(&x.edit, &env, file);
        result = write_export(&x, out_data, out_size);
    }
    close_exporter(&x, &env);
    dmi_gltf_log_warnings(&env, &file->warnings);
    return result;
}
