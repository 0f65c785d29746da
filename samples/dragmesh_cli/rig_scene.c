/* The file again, with an animation of its parts, and their joints in `extras`. What a clip of the file moves, with all
 * that it carries, is left to that clip: both together would move it twice. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "json.h"
#include "rig.h"

enum { KEYS = 41, NAME = 80 }; /* key frames there and back; bytes of a part's name; by hand */
enum { VALUES = 255 };         /* part ids that one array of bytes tells apart */
#define NO_TRACK UINT32_MAX
enum { GLB_HEADER = 12, GLB_CHUNK = 8 }; /* bytes: glTF 2.0, chapter 4 */
static const float seconds_open = 2;     /* duration of the opening, s; by hand */

/* The tracks of the parts that move, and all that they point to. */
typedef struct tracks {
    dm_gltf_track* list;
    uint32_t count;
    char (*names)[NAME];
    dm_pose* poses;     /* KEYS a track */
    uint8_t** face_ids; /* one array for VALUES tracks */
    uint32_t arrays;
    float times[KEYS];
} tracks;

static void name_track(const rig* rig, uint32_t index, char out[NAME]) {
    snprintf(out, NAME, "part_%u_%.60s", index + 1, rig_part_name(rig, index));
    dm_gltf_mend_text(out);
}

/* Whether the file's own clip moves a part, or what carries it. */
static bool is_left_to_clip(const rig* rig, uint32_t index) {
    for (; index != DM_ASSET_NO_PART; index = rig->parts[index].part.parent)
        if (rig->parts[index].part.basis == DM_ASSET_FROM_CLIP) return true;
    return false;
}

static bool has_track(const rig* rig, uint32_t index) {
    return rig->parts[index].part.part_id != 0 && !is_left_to_clip(rig, index);
}

/* Marks the faces of track k by a value that is its own in its array. track_of: NO_TRACK: the part has none. */
static void mark_faces(const session* session, const uint32_t* face_part, const uint32_t* track_of, tracks* out) {
    const uint64_t faces = session->mesh.index_count / 3;
    out->arrays = (out->count + VALUES - 1) / VALUES;
    out->face_ids = cli_alloc(out->arrays * sizeof *out->face_ids);
    for (uint32_t i = 0; i < out->arrays; i++) out->face_ids[i] = cli_alloc_zeroed(faces);
    for (uint64_t face = 0; face < faces; face++) {
        const uint32_t track = track_of[face_part[face]];
        if (track == NO_TRACK) continue;
        out->face_ids[track / VALUES][face] = (uint8_t)(track % VALUES + 1);
    }
}

static dm_result fill_poses(const rig* rig, const uint32_t* track_of, tracks* out) {
    dm_pose* now = cli_alloc((rig->info.part_count + 1) * sizeof *now);
    dm_result result = DM_OK;
    for (uint32_t key = 0; key < KEYS && result == DM_OK; key++) {
        const float way = 2 * (float)key / (KEYS - 1);
        out->times[key] = seconds_open * way;
        result = rig_pose(rig, way <= 1 ? way : 2 - way, now);
        for (uint32_t i = 0; i < rig->info.part_count; i++)
            if (track_of[i + 1] != NO_TRACK) out->poses[(size_t)track_of[i + 1] * KEYS + key] = now[i + 1];
    }
    free(now);
    return result;
}

static dm_result make_tracks(const session* session, const rig* rig, tracks* out) {
    *out = (tracks){.count = 0};
    uint32_t* track_of = cli_alloc((rig->info.part_count + 1) * sizeof *track_of); /* by part id */
    uint32_t* face_part = rig_face_parts(session, rig);
    track_of[0] = NO_TRACK;
    for (uint32_t i = 0; i < rig->info.part_count; i++) track_of[i + 1] = has_track(rig, i) ? out->count++ : NO_TRACK;
    out->list = cli_alloc_zeroed(out->count * sizeof *out->list);
    out->names = cli_alloc(out->count * sizeof *out->names);
    out->poses = cli_alloc((size_t)out->count * KEYS * sizeof *out->poses);
    for (uint32_t i = 0; i < rig->info.part_count; i++)
        if (track_of[i + 1] != NO_TRACK) name_track(rig, i, out->names[track_of[i + 1]]);
    mark_faces(session, face_part, track_of, out);
    const dm_result result = fill_poses(rig, track_of, out);
    for (uint32_t t = 0; t < out->count; t++)
        out->list[t] = (dm_gltf_track){.name = out->names[t],
                                       .face_ids = out->face_ids[t / VALUES],
                                       .value = (uint8_t)(t % VALUES + 1),
                                       .poses = out->poses + (size_t)t * KEYS,
                                       .times = out->times,
                                       .key_count = KEYS};
    free(face_part);
    free(track_of);
    return result;
}

static void free_tracks(tracks* tracks) {
    for (uint32_t i = 0; i < tracks->arrays; i++) free(tracks->face_ids[i]);
    free(tracks->face_ids);
    free(tracks->poses);
    free(tracks->names);
    free(tracks->list);
}

/* ---- joints in `extras` ---- */

static uint32_t read_u32(const uint8_t* bytes) {
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

static void write_u32(uint8_t* bytes, uint32_t value) {
    for (int i = 0; i < 4; i++) bytes[i] = (uint8_t)(value >> 8 * i);
}

/* The joint in the scene's frame, as dm_gltf_get_asset reads it. */
static void add_joint(const session* session, const rig_part* part, cJSON* node) {
    cJSON* extras = cJSON_GetObjectItemCaseSensitive(node, "extras");
    if (!cJSON_IsObject(extras)) {
        cJSON_DeleteItemFromObjectCaseSensitive(node, "extras");
        extras = cJSON_AddObjectToObject(node, "extras");
    }
    cJSON* joint = cJSON_AddObjectToObject(extras, "dragmesh");
    joint_to_json(&part->joint, session->origin, joint);
    json_add_number(joint, "moves", (double)part->part.moves, 4);
}

/* Returns the node of a part that its file's clip moves; of one that goes along with such a part, its first. */
static uint32_t node_of_clip(const session* session, const rig* rig, const rig_part* part) {
    uint32_t number = 0, first = 0;
    while (first + 1 < part->part.node_count && rig->nodes[part->nodes[first]].clip_count == 0) first++;
    if (rig->nodes[part->nodes[first]].clip_count == 0) first = 0;
    dm_gltf_get_asset_node(session->gltf, part->nodes[first], &number);
    return number;
}

/* The nodes of the file keep their indices; those of the tracks are found by their names. */
static void add_joints(const session* session, const rig* rig, const tracks* tracks, cJSON* document) {
    cJSON *nodes = cJSON_GetObjectItemCaseSensitive(document, "nodes"), *node;
    for (uint32_t i = 0; i < rig->info.part_count; i++) {
        const rig_part* part = &rig->parts[i];
        if (part->part.part_id == 0 || !is_left_to_clip(rig, i)) continue;
        node = cJSON_GetArrayItem(nodes, (int)node_of_clip(session, rig, part));
        if (node != NULL) add_joint(session, part, node);
    }
    cJSON_ArrayForEach(node, nodes) {
        const char* name = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(node, "name"));
        for (uint32_t i = 0, t = 0; name != NULL && i < rig->info.part_count; i++) {
            if (!has_track(rig, i)) continue;
            if (strcmp(name, tracks->names[t++]) == 0) add_joint(session, &rig->parts[i], node);
        }
    }
}

/* Puts another document in the place of that of a .glb. Returns the bytes, to be freed. */
static uint8_t* replace_document(const uint8_t* glb, size_t size, const char* text, size_t* out_size) {
    const size_t old = read_u32(glb + GLB_HEADER), length = strlen(text), room = (length + 3) / 4 * 4;
    const size_t rest = size - GLB_HEADER - GLB_CHUNK - old;
    *out_size = GLB_HEADER + GLB_CHUNK + room + rest;
    uint8_t* out = cli_alloc(*out_size);
    memcpy(out, glb, GLB_HEADER + GLB_CHUNK);
    memset(out + GLB_HEADER + GLB_CHUNK, ' ', room);
    memcpy(out + GLB_HEADER + GLB_CHUNK, text, length);
    memcpy(out + GLB_HEADER + GLB_CHUNK + room, glb + GLB_HEADER + GLB_CHUNK + old, rest);
    write_u32(out + 8, (uint32_t)*out_size); /* behind magic and version */
    write_u32(out + GLB_HEADER, (uint32_t)room);
    return out;
}

static dm_result write_with_joints(session* session, const rig* rig, const tracks* tracks, const uint8_t* glb,
                                   size_t size, const char* path) {
    const char* text = (const char*)glb + GLB_HEADER + GLB_CHUNK;
    cJSON* document = cJSON_ParseWithLength(text, read_u32(glb + GLB_HEADER));
    add_joints(session, rig, tracks, document);
    char* print = cJSON_PrintUnformatted(document);
    cJSON_Delete(document);
    if (print == NULL) return session_fail(session, DM_ERROR_OUT_OF_MEMORY, "no memory for the scene");
    size_t out_size;
    uint8_t* out = replace_document(glb, size, print, &out_size);
    const dm_result result = session_write(session, path, out, out_size);
    free(out);
    cJSON_free(print);
    return result;
}

dm_result rig_write_scene(session* session, const rig* rig, const char* path) {
    tracks tracks;
    void* data = NULL;
    size_t size = 0;
    dm_result result = make_tracks(session, rig, &tracks);
    if (result == DM_OK) result = dm_gltf_export(session->gltf, tracks.list, tracks.count, &data, &size);
    if (result == DM_OK) result = write_with_joints(session, rig, &tracks, data, size, path);
    dm_gltf_release_bytes(session->gltf, data, size);
    free_tracks(&tracks);
    return result;
}
