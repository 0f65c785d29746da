/* Makes tracks for dm_gltf_export: which faces go with a body, and how it goes from rest to open and back. */
#include "export/rig_formats.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"
#include "math/joint.h"

enum { KEYS = 41 };    /* key frames there and back; by hand */
enum { VALUES = 255 }; /* part ids that one array of bytes tells apart */
#define NO_TRACK UINT32_MAX
static const float seconds_open = 2; /* duration of the opening, s; by hand */
/* Share of the range; a part whose end is this near to rest rests there; by hand. */
static const float rest_share = 0.05f;
static const float far_share = 0.5f; /* share of its size that a part without limits slides; by hand */
static const float quarter_turn = 1.57079633f;

/* Returns the value at which a body counts as open: the end of its range that is away from rest. Without limits, it is
 * a quarter turn or half the body's size. */
static float open_value(const dmi_rig_model* model, const dmi_rig_body* body) {
    const dm_joint* joint = &model->desc->joints[body->part];
    const dm_asset_part* part = &model->desc->parts[body->part];
    if (dmi_joint_has_limits(joint))
        return joint->upper > rest_share * (joint->upper - joint->lower) ? joint->upper : joint->lower;
    if (joint->type != DM_JOINT_PRISMATIC) return quarter_turn;
    const double sides[3] = {(double)(part->box_max.x - part->box_min.x), (double)(part->box_max.y - part->box_min.y),
                             (double)(part->box_max.z - part->box_min.z)};
    return far_share * (float)sqrt(sides[0] * sides[0] + sides[1] * sides[1] + sides[2] * sides[2]);
}

/* Returns the share of the way at a key, by minimum jerk, so that the motion starts and ends at rest. */
static float share_at(uint32_t key) {
    const float way = 2 * (float)key / (KEYS - 1), t = way <= 1 ? way : 2 - way;
    return t * t * t * (10 - 15 * t + 6 * t * t); /* literal: its polynomial */
}

/* Writes the poses of all bodies at a key, those that carry them included: KEYS a body. */
static void pose_bodies(const dmi_rig_model* model, uint32_t key, dm_pose* poses) {
    poses[key] = dmi_pose_identity();
    for (uint32_t b = 1; b < model->body_count; b++) {
        const dmi_rig_body* body = &model->bodies[b];
        const dm_pose own = dmi_joint_pose(&model->desc->joints[body->part], open_value(model, body) * share_at(key));
        poses[(size_t)b * KEYS + key] = dmi_pose_multiply(&poses[(size_t)body->parent * KEYS + key], &own);
    }
}

bool dmi_rig_is_left_to_clip(const dmi_rig_model* model, uint32_t body) {
    for (; body != 0; body = model->bodies[body].parent)
        if (model->desc->parts[model->bodies[body].part].basis == DM_ASSET_FROM_CLIP) return true;
    return false;
}

/* Lists the bodies that get a track. */
static uint32_t list_bodies(const dmi_rig_model* model, uint32_t* track_of, uint32_t* body_of) {
    uint32_t count = 0;
    for (uint32_t b = 0; b < model->body_count; b++) {
        const bool has_track = b > 0 && !dmi_rig_is_left_to_clip(model, b);
        track_of[b] = has_track ? count : NO_TRACK;
        if (has_track) body_of[count++] = b;
    }
    return count;
}

/* Marks the faces of the file by the track that moves each. There is an array for each VALUES tracks. */
static void mark_faces(const dmi_rig_model* model, const uint32_t* track_of, uint64_t face_count, uint8_t* ids) {
    for (uint32_t i = 0; i < model->shape_count; i++) {
        const dmi_rig_shape* shape = &model->shapes[i];
        dm_gltf_node node;
        const uint32_t track = track_of[shape->body];
        if (track == NO_TRACK || dm_gltf_get_node(model->desc->gltf, shape->node, &node) != DM_OK) continue;
        memset(ids + track / VALUES * face_count + node.first_face, (int)(track % VALUES + 1), node.face_count);
    }
}

dm_result dmi_rig_make_tracks(dmi_rig_model* model, dm_gltf_track** out_tracks, uint32_t* out_count) {
    dm_mesh_desc mesh;
    const uint32_t bodies = model->body_count, arrays = (bodies + VALUES - 1) / VALUES;
    if (dm_gltf_get_mesh(model->desc->gltf, &mesh) != DM_OK) return DM_ERROR_INVALID_ARGUMENT;
    const uint64_t faces = mesh.index_count / 3;
    dm_gltf_track* tracks = dmi_rig_push(model, bodies, sizeof *tracks);
    dm_pose* poses = dmi_rig_push(model, (size_t)bodies * KEYS, sizeof *poses);
    float* times = dmi_rig_push(model, KEYS, sizeof *times);
    uint32_t *track_of = dmi_rig_push(model, bodies, sizeof *track_of),
             *body_of = dmi_rig_push(model, bodies, sizeof *body_of);
    uint8_t* ids = dmi_rig_push(model, arrays * faces, sizeof *ids);
    if (tracks == NULL || poses == NULL || times == NULL || track_of == NULL || body_of == NULL || ids == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    memset(ids, 0, arrays * faces);
    *out_count = list_bodies(model, track_of, body_of);
    mark_faces(model, track_of, faces, ids);
    for (uint32_t key = 0; key < KEYS; key++) {
        times[key] = seconds_open * 2 * (float)key / (KEYS - 1);
        pose_bodies(model, key, poses);
    }
    for (uint32_t t = 0; t < *out_count; t++)
        tracks[t] = (dm_gltf_track){.name = model->bodies[body_of[t]].name,
                                    .face_ids = ids + t / VALUES * faces,
                                    .value = (uint8_t)(t % VALUES + 1),
                                    .poses = poses + (size_t)body_of[t] * KEYS,
                                    .times = times,
                                    .key_count = KEYS};
    *out_tracks = tracks;
    return DM_OK;
}
