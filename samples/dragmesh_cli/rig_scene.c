/* The file again, with an animation of its parts. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rig.h"

enum { KEYS = 41, NAME = 80 };       /* key frames there and back; bytes of a part's name; by hand */
enum { VALUES = 255 };               /* part ids that one array of bytes tells apart */
static const float seconds_open = 2; /* duration of the opening, s; by hand */

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
    const rig_part* part = &rig->parts[index];
    const char* name = part->part.node_count > 0 ? rig->nodes[part->nodes[0]].name : NULL;
    snprintf(out, NAME, "part_%u_%.60s", index + 1, name != NULL ? name : "");
    dm_gltf_mend_text(out);
}

/* Marks the faces of track k by a value that is its own in its array. */
static void mark_faces(const session* session, const uint32_t* face_part, const uint32_t* track_of, tracks* out) {
    const uint64_t faces = session->mesh.index_count / 3;
    out->arrays = (out->count + VALUES - 1) / VALUES;
    out->face_ids = cli_alloc(out->arrays * sizeof *out->face_ids);
    for (uint32_t i = 0; i < out->arrays; i++) out->face_ids[i] = cli_alloc_zeroed(faces);
    for (uint64_t face = 0; face < faces; face++) {
        if (face_part[face] == 0) continue;
        const uint32_t track = track_of[face_part[face]];
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
            if (rig->parts[i].part.part_id != 0) out->poses[(size_t)track_of[i + 1] * KEYS + key] = now[i + 1];
    }
    free(now);
    return result;
}

static dm_result make_tracks(const session* session, const rig* rig, tracks* out) {
    *out = (tracks){.count = rig->info.moving_count};
    uint32_t* track_of = cli_alloc_zeroed((rig->info.part_count + 1) * sizeof *track_of); /* by part id */
    uint32_t* face_part = rig_face_parts(session, rig);
    out->list = cli_alloc_zeroed(out->count * sizeof *out->list);
    out->names = cli_alloc(out->count * sizeof *out->names);
    out->poses = cli_alloc((size_t)out->count * KEYS * sizeof *out->poses);
    for (uint32_t i = 0, next = 0; i < rig->info.part_count; i++)
        if (rig->parts[i].part.part_id != 0) {
            name_track(rig, i, out->names[next]);
            track_of[i + 1] = next++;
        }
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

dm_result rig_make_scene(session* session, const rig* rig, void** out_data, size_t* out_size) {
    tracks tracks;
    dm_result result = make_tracks(session, rig, &tracks);
    if (result == DM_OK) result = dm_gltf_export(session->gltf, tracks.list, tracks.count, out_data, out_size);
    free_tracks(&tracks);
    return result;
}
