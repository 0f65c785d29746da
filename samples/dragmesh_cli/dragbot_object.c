/* The scripted player on one object: prepares all parts at once and plays every joint from several cameras. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dragbot.h"

/* All by hand. */
enum { DIRECTIONS = 32, MAX_PARTS = 250 }; /* camera directions tried; parts, whose ids fit a byte */
static const double part_fill = 0.35;      /* least share of the view's radius that the part fills */
static const double view_margin = 1.05;    /* radius of the view over that of the part's ball */
static const double camera_distance = 2.5; /* from the centre, in radii of the whole */
static const double min_elevation = -0.2, max_elevation = 0.95; /* sine of the camera's elevation */

/* An object prepared and placed for the player. */
typedef struct setup {
    session* session;
    known_object object;
    uint8_t* face_parts;
    uint32_t* part_of_joint; /* 0: none of its own */
    uint32_t part_count;
    vec up, centre;
    double radius, size;
    dm_scene scene;
    bot_view view;
} setup;

/* ---- parts ---- */

static bool has_name(const name_list* list, const char* name) {
    for (unsigned i = 0; i < list->count; i++)
        if (strcmp(list->names[i], name) == 0) return true;
    return false;
}

static bool includes(const name_list* outer, const name_list* inner) {
    for (unsigned i = 0; i < inner->count; i++)
        if (!has_name(outer, inner->names[i])) return false;
    return true;
}

/* Joints of the same nodes share a part; ids from 1 on. */
static void number_parts(setup* s) {
    const known_joint* joints = s->object.joints;
    for (int i = 0; i < s->object.joint_count; i++) {
        for (int k = 0; k < i && !s->part_of_joint[i]; k++) {
            const int same =
                includes(&joints[i].moving, &joints[k].moving) && includes(&joints[k].moving, &joints[i].moving);
            if (same) s->part_of_joint[i] = s->part_of_joint[k];
        }
        if (!s->part_of_joint[i] && s->part_count < MAX_PARTS) s->part_of_joint[i] = ++s->part_count;
    }
}

/* Returns the joint whose part carries a joint's part: the smallest that holds all its nodes; -1: the body. */
static int carrier_of(const setup* s, int joint) {
    const known_joint* joints = s->object.joints;
    int best = -1;
    for (int i = 0; i < s->object.joint_count; i++) {
        if (s->part_of_joint[i] == s->part_of_joint[joint]) continue;
        if (!includes(&joints[i].moving, &joints[joint].moving)) continue;
        if (best < 0 || joints[i].moving.count < joints[best].moving.count) best = i;
    }
    return best;
}

/* Larger parts first, so that what they carry is marked over them. */
static dm_result mark_faces(setup* s) {
    const uint64_t faces = s->session->mesh.index_count / 3;
    unsigned most = 0;
    for (int i = 0; i < s->object.joint_count; i++)
        most = s->object.joints[i].moving.count > most ? s->object.joints[i].moving.count : most;
    for (unsigned count = most; count > 0; count--) {
        for (int i = 0; i < s->object.joint_count; i++) {
            const name_list* moving = &s->object.joints[i].moving;
            if (moving->count != count || !s->part_of_joint[i]) continue;
            const dm_result result = dm_gltf_mark_faces(s->session->gltf, (const char* const*)moving->names, count,
                                                        (uint8_t)s->part_of_joint[i], s->face_parts, faces);
            if (result != DM_OK) return result;
        }
    }
    return DM_OK;
}

static void drop_faceless_parts(setup* s) {
    const uint64_t faces = s->session->mesh.index_count / 3;
    uint64_t own[MAX_PARTS + 1] = {0};
    for (uint64_t i = 0; i < faces; i++) own[s->face_parts[i]]++;
    for (int i = 0; i < s->object.joint_count; i++)
        if (!own[s->part_of_joint[i]]) s->part_of_joint[i] = 0;
}

static dm_result prepare(setup* s) {
    dm_part_desc parts[MAX_PARTS];
    uint8_t known[MAX_PARTS + 1] = {0};
    uint32_t count = 0;
    for (int i = 0; i < s->object.joint_count; i++) {
        const uint32_t id = s->part_of_joint[i];
        if (!id || known[id]) continue;
        const int carrier = carrier_of(s, i);
        known[id] = 1;
        parts[count++] = (dm_part_desc){
            .struct_size = sizeof parts[0], .id = id, .parent = carrier < 0 ? 0 : s->part_of_joint[carrier]};
    }
    dm_mesh_desc mesh = s->session->mesh;
    mesh.part_ids = s->face_parts;
    mesh.part_id_bytes = mesh.index_count / 3;
    mesh.part_id_format = DM_UINT8;
    mesh.part_id_scope = DM_PER_FACE;
    const dm_object_desc desc = {
        .struct_size = sizeof desc, .mesh = &mesh, .parts = parts, .part_count = count, .model = s->session->model};
    session_release_object(s->session);
    return dm_object_prepare(s->session->context, &desc, &s->session->object);
}

/* ---- setup ---- */

static dm_result set_up(setup* s) {
    const dm_scene_desc scene = {.struct_size = sizeof scene};
    uint32_t instance;
    s->face_parts = cli_alloc_zeroed(s->session->mesh.index_count / 3);
    s->part_of_joint = cli_alloc_zeroed((size_t)s->object.joint_count * sizeof *s->part_of_joint);
    number_parts(s);
    dm_result result = mark_faces(s);
    if (result != DM_OK) return result;
    drop_faceless_parts(s);
    result = prepare(s);
    if (result == DM_OK) result = dm_scene_create(s->session->context, &scene, &s->scene);
    if (result == DM_OK) result = dm_scene_add(s->session->context, s->scene, s->session->object, NULL, &instance);
    if (result == DM_OK) result = dm_scene_commit(s->session->context, s->scene);
    dm_object_info info = {.struct_size = sizeof info};
    if (result == DM_OK) result = dm_object_get_info(s->session->context, s->session->object, &info);
    if (result != DM_OK) return result;
    s->centre = scale(add(vec_of(info.box_min), vec_of(info.box_max)), 0.5);
    s->radius = 0.5 * length(sub(vec_of(info.box_max), vec_of(info.box_min)));
    s->size = (double)info.size;
    return DM_OK;
}

static void take_down(setup* s) {
    if (s->scene) dm_scene_destroy(s->session->context, s->scene);
    session_release_object(s->session);
    free(s->face_parts);
    free(s->part_of_joint);
}

/* ---- cameras ---- */

/* Returns a camera direction: elevations spread evenly in golden-ratio order, azimuths by the golden angle. */
static vec direction(const setup* s, int index) {
    const double turned = 2.399963229728653 * index; /* the golden angle, rad */
    const double height = min_elevation + (max_elevation - min_elevation) *
                                              fmod(0.618033988749895 * (index + 1), 1); /* golden ratio - 1 */
    const vec side = fabs(s->up.z) > 0.5 ? (vec){1, 0, 0} : (vec){0, 0, 1};
    return add(scale(s->up, height), scale(turn(side, s->up, turned), sqrt(1 - height * height)));
}

/* Computes a ball round the part along its whole pull. */
static void frame_part(const setup* s, int joint, vec* out_centre, double* out_radius, vec* out_part_centre) {
    const known_joint* truth = &s->object.joints[joint];
    const uint32_t* indices = s->session->mesh.indices;
    const float* positions = s->session->mesh.positions;
    const double asked = bot_travel(truth, s->size);
    vec low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY}, sum = {0, 0, 0};
    double count = 0;
    for (uint64_t i = 0; i < s->session->mesh.index_count; i++) {
        if (s->face_parts[i / 3] != s->part_of_joint[joint]) continue;
        const vec point = vec_at(positions + 3 * (size_t)indices[i]);
        sum = add(sum, point), count++;
        for (int k = 0; k <= 4; k++) {
            const vec p = bot_true_move(truth, point, 0.25 * k * asked /* at quarters of the pull */);
            low = (vec){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
            high = (vec){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
        }
    }
    *out_part_centre = scale(sum, 1 / count);
    *out_centre = scale(add(low, high), 0.5);
    *out_radius = 0.5 * length(sub(high, low));
}

static int aim_and_choose(setup* s, int joint, int index, random_state* random, bot_pull* out_pull) {
    vec centre, part_centre;
    double radius;
    frame_part(s, joint, &centre, &radius, &part_centre);
    const double whole = fmax(s->radius + length(sub(centre, s->centre)), radius);
    const double wanted = fmin(fmax(radius / part_fill, radius * view_margin), whole);
    bot_view_aim(&s->view, direction(s, index), s->up, centre, fmax(wanted, view_margin * radius),
                 camera_distance * whole);
    bot_view_draw(&s->view, &s->session->mesh, s->face_parts);
    return bot_choose_pull(&s->view, s->part_of_joint[joint], &s->object.joints[joint], s->size, random, out_pull);
}

/* ---- playing ---- */

static bot_row* new_row(bot_score* score) {
    if (score->count == score->room) {
        score->room = score->room ? 2 * score->room : 1024;
        score->rows = cli_grow(score->rows, score->room * sizeof *score->rows);
    }
    bot_row* row = &score->rows[score->count++];
    memset(row, 0, sizeof *row);
    return row;
}

static dm_joint true_joint(const known_joint* truth) {
    dm_joint joint = {.struct_size = sizeof joint, .axis = vec_out(truth->axis), .origin = vec_out(truth->origin)};
    const bool limited = isfinite(truth->lower) && isfinite(truth->upper);
    joint.type = truth->slides ? DM_JOINT_PRISMATIC : limited ? DM_JOINT_REVOLUTE : DM_JOINT_CONTINUOUS;
    if (limited) joint.lower = (float)truth->lower, joint.upper = (float)truth->upper;
    return joint;
}

static void play_joint(setup* s, int joint, const bot_options* options, int given, bot_score* score) {
    const known_joint* truth = &s->object.joints[joint];
    random_state random = {(uint64_t)joint + 1};
    vec centre, part_centre;
    double radius;
    frame_part(s, joint, &centre, &radius, &part_centre);
    if (given) {
        const dm_joint exact = true_joint(truth);
        dm_object_set_joint(s->session->context, s->session->object, s->part_of_joint[joint], &exact);
    }
    int found = 0;
    for (int i = 0; i < DIRECTIONS && found < options->cameras; i++) {
        bot_pull pull;
        const int seen = aim_and_choose(s, joint, i, &random, &pull);
        if (given) score->unseen += seen == 0, score->undrawable += seen < 0;
        if (seen <= 0) continue;
        random_state hand_random = {random.state ^
                                    0x68616E64u}; /* independent, so that all hands grab the same points */
        bot_hand_draw(&options->hand, &hand_random, &pull);
        bot_row* row = NULL;
        char id[sizeof row->id];
        snprintf(id, sizeof id, "%s/%d/%d", s->object.name, joint, i);
        for (size_t r = score->count; given && r > 0 && row == NULL; r--)
            if (strcmp(score->rows[r - 1].id, id) == 0) row = &score->rows[r - 1];
        if (row == NULL) row = new_row(score);
        memcpy(row->id, id, sizeof id);
        row->slides = truth->slides, row->pull = pull, row->camera = i;
        bot_result* result = given ? &row->given : &row->found;
        if (bot_play(s->session, s->scene, &s->view, &pull, &options->hand, s->part_of_joint[joint], truth, part_centre,
                     &score->times, result) != DM_OK) {
            fprintf(stderr, "dragmesh dragbot: %s: %s\n", row->id, s->session->error);
            score->failed++;
        }
        found++;
    }
}

void bot_play_object(session* session, const char* folder, const char* name, const bot_options* options,
                     bot_score* score) {
    setup s = {.session = session};
    char error[512];
    if (dataset_read(folder, name, &s.object, error, sizeof error) != 0) {
        fprintf(stderr, "dragmesh dragbot: %s\n", error);
        score->failed++;
        return;
    }
    s.up = (vec){s.object.up == 'x', s.object.up == 'y', s.object.up == 'z'};
    s.view = bot_view_new();
    dm_result result = session_use_file(session, s.object.glb);
    if (result == DM_OK) result = set_up(&s);
    if (result != DM_OK) {
        fprintf(stderr, "dragmesh dragbot: %s: %s\n", name, session->error);
        score->failed++;
    }
    for (int given = options->given_only; given < 2 && result == DM_OK; given++) {
        for (int i = 0; i < s.object.joint_count; i++)
            if (s.part_of_joint[i]) play_joint(&s, i, options, given, score);
    }
    take_down(&s);
    bot_view_free(&s.view);
    dataset_free(&s.object);
}
