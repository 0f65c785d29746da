/* First touch on whole assets: the naive hand grabs true parts and static nodes of folders of object.glb + asset.json,
 * on what `dragmesh rig` answers. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dragbot_rig.h"
#include "files.h"
#include "json.h"
#include "nodes.h"
#include "rig.h"

enum { MOST_STATIC = 8 };              /* static nodes of an asset that are grabbed; by hand */
static const double right_faces = 0.9; /* IoU by area, from which on the right faces follow; as rig scores count */
static const double usual_moves = 0.5; /* probability from which on a part moves */

/* ---- what is true of an asset ---- */

typedef struct rig_truth {
    known_object known; /* its joints: true parts, then static nodes as if they slid */
    int part_count;     /* of true parts */
} rig_truth;

static vec read_vec(const cJSON* json, const char* name) {
    const cJSON* list = cJSON_GetObjectItemCaseSensitive(json, name);
    double numbers[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        if (cJSON_IsNumber(cJSON_GetArrayItem(list, i))) numbers[i] = cJSON_GetArrayItem(list, i)->valuedouble;
    return (vec){numbers[0], numbers[1], numbers[2]};
}

static double number_or_nan(const cJSON* json, const char* name) {
    const cJSON* found = cJSON_GetObjectItemCaseSensitive(json, name);
    return cJSON_IsNumber(found) ? found->valuedouble : NAN;
}

static void add_names(const cJSON* part, name_list* out) {
    const cJSON* name;
    cJSON_ArrayForEach(name, cJSON_GetObjectItemCaseSensitive(part, "nodes")) {
        if (cJSON_IsString(name)) name_list_add(out, name->valuestring, strlen(name->valuestring));
    }
}

/* Whether part `index` is carried by `above`, over others too. */
static bool is_carried(const cJSON* parts, int index, int above) {
    for (int steps = cJSON_GetArraySize(parts); steps > 0; steps--) {
        const cJSON* parent = cJSON_GetObjectItemCaseSensitive(cJSON_GetArrayItem(parts, index), "parent");
        if (!cJSON_IsNumber(parent) || parent->valueint < 0) return false;
        index = parent->valueint;
        if (index == above) return true;
    }
    return false;
}

static known_joint* new_joint(rig_truth* truth) {
    known_object* known = &truth->known;
    known->joints = cli_grow(known->joints, (size_t)(known->joint_count + 1) * sizeof *known->joints);
    known_joint* joint = &known->joints[known->joint_count++];
    *joint = (known_joint){.name = cli_copy_text(""), .label = cli_copy_text(""), .weight = 1};
    return joint;
}

static void read_parts(const cJSON* parts, rig_truth* out) {
    for (int i = 0; i < cJSON_GetArraySize(parts); i++) {
        const cJSON* part = cJSON_GetArrayItem(parts, i);
        const char* type = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(part, "type"));
        if (cJSON_GetArraySize(cJSON_GetObjectItemCaseSensitive(part, "nodes")) == 0 || type == NULL) continue;
        known_joint* joint = new_joint(out);
        joint->slides = strcmp(type, "prismatic") == 0;
        joint->axis = unit(read_vec(part, "axis"));
        joint->origin = read_vec(part, "origin");
        joint->lower = number_or_nan(part, "lower");
        joint->upper = number_or_nan(part, "upper");
        add_names(part, &joint->moving);
        for (int k = 0; k < cJSON_GetArraySize(parts); k++)
            if (is_carried(parts, k, i)) add_names(cJSON_GetArrayItem(parts, k), &joint->moving);
        out->part_count++;
    }
}

/* Takes static nodes evenly from all of them. */
static void read_static_nodes(const cJSON* nodes, rig_truth* out) {
    const cJSON* node;
    int count = 0, seen = 0, taken = 0;
    cJSON_ArrayForEach(node, nodes) count += cJSON_IsString(node) && strcmp(node->valuestring, "static") == 0;
    cJSON_ArrayForEach(node, nodes) {
        if (!cJSON_IsString(node) || strcmp(node->valuestring, "static") != 0) continue;
        const int due = count > MOST_STATIC ? (seen + 1) * MOST_STATIC / count : seen + 1;
        seen++;
        if (taken >= due) continue;
        taken++;
        known_joint* joint = new_joint(out);
        joint->slides = true;
        joint->axis = (vec){0, 0, 1};
        joint->lower = joint->upper = NAN;
        name_list_add(&joint->moving, node->string, strlen(node->string));
    }
}

static bool read_truth(const char* folder, const char* name, rig_truth* out) {
    size_t size;
    char *asset = path_join(folder, name), *path = path_join(asset, "asset.json"), *text = file_read(path, &size);
    cJSON* json = text != NULL ? cJSON_ParseWithLength(text, size) : NULL;
    const char* up = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, "up"));
    *out = (rig_truth){.known = {.name = cli_copy_text(name),
                                 .glb = path_join(asset, "object.glb"),
                                 .category = cli_copy_text(""),
                                 .up = up != NULL ? up[0] : 'y'}};
    out->known.up_direction = (vec){out->known.up == 'x', out->known.up == 'y', out->known.up == 'z'};
    read_parts(cJSON_GetObjectItemCaseSensitive(json, "parts"), out);
    read_static_nodes(cJSON_GetObjectItemCaseSensitive(json, "nodes"), out);
    const bool found = json != NULL;
    cJSON_Delete(json);
    free(text);
    free(path);
    free(asset);
    return found;
}

/* ---- what is grabbed ---- */

/* A true part or a static node, and where it is grabbed. */
typedef struct target {
    bot_truth truth;
    bot_part part;
    bot_grab grabs[BOT_NAIVE_MOST];
    int grab_count;
} target;

static bool is_named(const session* session, const known_joint* joint, uint64_t face) {
    dm_gltf_node node;
    dm_gltf_get_node(session->gltf, node_of_face(session->gltf, face), &node);
    for (unsigned i = 0; i < joint->moving.count; i++)
        if (strcmp(joint->moving.names[i], node.name) == 0) return true;
    return false;
}

/* Prepares a target alone, to see where it can be grabbed; by geometry, because the joint is not asked for. */
static void find_grabs(session* session, rig_truth* truth, int joint, int cameras, target* out) {
    bot_object object = {.session = session, .known = truth->known, .up = truth->known.up_direction};
    const dm_model model = session->model;
    int hidden;
    *out = (target){.grab_count = 0};
    session->model = 0;
    dm_result result = bot_object_set_up_alone(&object, joint);
    session->model = model;
    if (result == DM_OK && object.part_of_joint[joint]) result = bot_truth_make(&object, joint, &out->truth);
    if (result == DM_OK && object.part_of_joint[joint]) {
        out->part = bot_object_part(&object, joint);
        object.view = bot_view_new();
        out->grab_count = bot_naive_find_grabs(&object, &out->truth, cameras, out->grabs, &hidden);
        bot_view_free(&object.view);
    }
    bot_object_take_down(&object);
}

/* ---- what follows ---- */

typedef struct play {
    session* session;
    rig_truth* truth;
    const bot_options* options;
    rig rig;
    dm_scene scene; /* of the rig's object; 0: nothing moves */
    uint32_t* face_parts;
    bot_times times;
} play;

static bool goes_with(const rig* rig, uint32_t id, uint32_t moved) {
    while (id != 0 && id != moved) {
        const uint32_t parent = rig->parts[id - 1].part.parent;
        id = parent == DM_ASSET_NO_PART ? 0 : parent + 1;
    }
    return id == moved;
}

static double area_of(const session* session, uint64_t face) {
    const uint32_t* corners = (const uint32_t*)session->mesh.indices + 3 * face;
    const float* positions = session->mesh.positions;
    const vec a = vec_at(positions + 3 * (size_t)corners[0]);
    return 0.5 * length(cross(sub(vec_at(positions + 3 * (size_t)corners[1]), a),
                              sub(vec_at(positions + 3 * (size_t)corners[2]), a)));
}

/* Whether the faces that go with a part of the rig are those of the true part. */
static bool follows_rightly(const play* p, const known_joint* joint, uint32_t moved) {
    double both = 0, either = 0;
    for (uint64_t face = 0; face < p->session->mesh.index_count / 3; face++) {
        const bool truly = is_named(p->session, joint, face), goes = goes_with(&p->rig, p->face_parts[face], moved);
        const double area = truly || goes ? area_of(p->session, face) : 0;
        either += area;
        both += truly && goes ? area : 0;
    }
    return either > 0 && both >= right_faces * either;
}

/* Picks the grabbed point on the rig's object. Returns the part's id; 0: it stays. */
static uint32_t pick(const play* p, const bot_grab* grab, uint64_t* out_face) {
    dm_ray ray;
    dm_hit hit = dm_hit_default();
    dm_context* context = p->session->context;
    *out_face = UINT64_MAX;
    if (dm_camera_ray(context, &grab->view.camera, (float)grab->x, (float)grab->y, &ray) != DM_OK) return 0;
    if (dm_scene_pick(context, p->scene, &ray, &hit) != DM_OK || hit.object == 0) return 0;
    *out_face = hit.triangle;
    return hit.part_id;
}

static bool pull_rightly(play* p, target* t, const bot_grab* grab, uint32_t part, bool* out_drawn) {
    bot_pull* pull = cli_alloc_zeroed(sizeof *pull);
    bot_hand hand = p->options->hand;
    bot_result result = {.picked = false};
    random_state random = {0};
    hand.regrab = 0;
    *out_drawn = bot_naive_draw(&hand, grab, &t->truth, pull);
    if (*out_drawn) {
        bot_plan plan = bot_plan_make(&hand, pull, &random);
        t->part.id = part;
        const bot_case played = {.id = p->truth->known.name,
                                 .view = &grab->view,
                                 .pull = pull,
                                 .hand = &hand,
                                 .plan = &plan,
                                 .part = &t->part,
                                 .truth = t->truth.joint,
                                 .up = p->truth->known.up_direction};
        if (bot_play(p->session, p->scene, &played, &p->times, &result) != DM_OK) result.picked = false;
        free(plan.steps);
    }
    free(pull);
    return result.picked && bot_truth_compare(&t->truth, &result.end.joint) == BOT_RIGHT;
}

/* Grabs a true part wherever it is seen. */
static void touch_part(play* p, target* t, bot_rig_score* score) {
    int grabs = 0, follow = 0, right = 0;
    for (int i = 0; i < t->grab_count; i++) {
        uint64_t face;
        bool drawn = true;
        const uint32_t part = p->scene ? pick(p, &t->grabs[i], &face) : 0;
        const bool follows = part != 0 && follows_rightly(p, t->truth.joint, part);
        const bool joint = part != 0 && pull_rightly(p, t, &t->grabs[i], part, &drawn);
        if (!drawn) continue;
        grabs++, follow += follows, right += follows && joint;
    }
    if (grabs == 0) {
        score->unseen++;
        return;
    }
    score->parts++;
    score->follow += (double)follow / grabs;
    score->right += (double)right / grabs;
}

/* Grabs a static node wherever it is seen. */
static void touch_static(play* p, const target* t, bot_rig_score* score) {
    int grabs = 0, stay = 0;
    for (int i = 0; i < t->grab_count; i++) {
        uint64_t face = UINT64_MAX;
        const uint32_t part = p->scene ? pick(p, &t->grabs[i], &face) : 0;
        if (p->scene && (face == UINT64_MAX || !is_named(p->session, t->truth.joint, face))) continue;
        grabs++, stay += part == 0;
    }
    if (grabs == 0) return;
    score->static_nodes++;
    score->stay += (double)stay / grabs;
}

/* ---- one asset ---- */

static dm_result open_rig(play* p) {
    session* s = p->session;
    const rig_options options = {.without_clips = p->options->no_clips, .min_moves = usual_moves};
    const dm_scene_desc scene = {.struct_size = sizeof scene};
    uint32_t instance;
    dm_result result = rig_make(s, p->truth->known.glb, &options, &p->rig);
    if (result != DM_OK) return result;
    p->face_parts = rig_face_parts(s, &p->rig);
    if (p->rig.info.moving_count == 0) return DM_OK;
    session_release_object(s);
    result = dm_asset_make_object(s->context, p->rig.asset, &s->object);
    if (result == DM_OK) result = dm_scene_create(s->context, &scene, &p->scene);
    if (result == DM_OK) result = dm_scene_add(s->context, p->scene, s->object, NULL, &instance);
    return result == DM_OK ? dm_scene_commit(s->context, p->scene) : result;
}

static dm_result play_asset(session* session, rig_truth* truth, const bot_options* options, bot_rig_score* score) {
    const int count = truth->known.joint_count;
    play p = {.session = session, .truth = truth, .options = options};
    dm_result result = session_use_file(session, truth->known.glb);
    if (result != DM_OK) return result;
    dataset_enter_frame(&truth->known, session->origin);
    target* targets = cli_alloc((size_t)count * sizeof *targets);
    for (int i = 0; i < count; i++) find_grabs(session, truth, i, options->cameras, &targets[i]);
    result = open_rig(&p);
    for (int i = 0; i < count && result == DM_OK; i++) {
        if (i < truth->part_count)
            touch_part(&p, &targets[i], score);
        else
            touch_static(&p, &targets[i], score);
    }
    if (p.scene) dm_scene_destroy(session->context, p.scene);
    session_release_object(session);
    rig_free(session, &p.rig);
    free(p.face_parts);
    free(p.times.ns);
    free(targets);
    return result;
}

/* ---- the folder ---- */

static bool is_wanted(const bot_options* options, const char* name) {
    for (unsigned i = 0; i < options->only.count; i++)
        if (strstr(name, options->only.names[i]) != NULL) return true;
    return options->only.count == 0;
}

static void report(const bot_rig_score* score, bool as_json) {
    const double parts = fmax(score->parts, 1), still = fmax(score->static_nodes, 1);
    if (!as_json) {
        printf("%d assets, %d failed. Of %d true parts (%d not grabbed) the right faces follow %.3f, and the joint is "
               "right too %.3f.\nOf %d static nodes %.3f stay.\n",
               score->assets, score->failed, score->parts, score->unseen, score->follow / parts, score->right / parts,
               score->static_nodes, score->stay / still);
        return;
    }
    cJSON* out = cJSON_CreateObject();
    cJSON_AddNumberToObject(out, "assets", score->assets);
    cJSON_AddNumberToObject(out, "failed", score->failed);
    cJSON_AddNumberToObject(out, "parts", score->parts);
    cJSON_AddNumberToObject(out, "unseen", score->unseen);
    json_add_number(out, "follow", score->follow / parts, 4);
    json_add_number(out, "right", score->right / parts, 4);
    cJSON_AddNumberToObject(out, "static_nodes", score->static_nodes);
    json_add_number(out, "stay", score->stay / still, 4);
    json_print_line(out);
}

int bot_rig_play(session* session, const char* folder, const bot_options* options, bool as_json) {
    name_list names = dataset_list(folder, "asset.json");
    bot_rig_score score = {0};
    if (names.count == 0) {
        fprintf(stderr, "dragmesh dragbot: '%s' has no folders with an asset.json\n", folder);
        return CLI_USAGE;
    }
    session->is_quiet = true;
    for (unsigned i = 0; i < names.count; i++) {
        rig_truth truth;
        if (!is_wanted(options, names.names[i])) continue;
        const bool readable = read_truth(folder, names.names[i], &truth);
        score.assets++;
        if (!readable || play_asset(session, &truth, options, &score) != DM_OK) {
            score.failed++;
            fprintf(stderr, "dragmesh dragbot: %s: %s\n", names.names[i],
                    readable ? session->error : "its asset.json can't be read");
        }
        dataset_free(&truth.known);
    }
    report(&score, as_json);
    name_list_free(&names);
    return score.failed > 0 ? CLI_FAILED : CLI_OK;
}
