/* A whole host: a .glb read by tinygltf, a camera made by cglm, a pixel that picks a part, a mouse that drags it.
 *   whole_host [FILE.glb BODY X Y DX DY [MODELS]]    BODY: the node that stays; grabs pixel (X, Y), pulls by (DX, DY)
 */
#include <cglm/cglm.h>
#include <stdio.h>
#include <stdlib.h>

#include "asset.h"
#include "dragmesh/dragmesh.h"

#ifndef MODELS
#define MODELS "sdk/models"
#endif

enum { WIDTH = 1280, HEIGHT = 720, FRAMES = 30 };
#define FOV_Y 0.8f /* rad */
#define FRAME_SECONDS (1.0f / 60)

typedef struct host {
    dm_context* context;
    dm_model model;
    dm_object object;
    dm_scene scene;
    uint32_t instance;
    mat4 place;      /* of the object in the world */
    mat4 projection; /* what a renderer draws with … */
    mat4 view;
    dm_camera camera; /* … and the same as the library takes it */
} host;

static void check(dm_result result, const char* what) {
    if (result == DM_OK) return;
    fprintf(stderr, "%s: %s\n", what, dm_result_string(result));
    exit(1);
}

static void DM_CALL print_message(void* user, int32_t level, dm_result code, const char* text) {
    if (level <= DM_LOG_WARNING) fprintf(user, "%s: %s\n", dm_result_string(code), text);
}

static dm_vec3 from_cglm(const vec3 v) {
    return (dm_vec3){v[0], v[1], v[2]};
}

static size_t read_weights(const char* folder, const char* name, void* out, size_t capacity) {
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE* file = fopen(path, "rb");
    const size_t size = file != NULL ? fread(out, 1, capacity, file) : 0;
    if (file != NULL) fclose(file);
    return size;
}

/* Once: a context, and the weights. */
static void start(host* host, const char* models) {
    static char kinematics[4 << 20], ranker[4 << 20];
    const dm_context_desc desc = {.struct_size = sizeof desc, .axes = DM_AXES_GLTF, .log = {stderr, print_message}};
    check(dm_context_create(&desc, &host->context), "dm_context_create");
    dm_model_desc weights = {.struct_size = sizeof weights, .kinematics = kinematics, .ranker = ranker};
    weights.kinematics_size = read_weights(models, "kpp_net.safetensors", kinematics, sizeof kinematics);
    weights.ranker_size = read_weights(models, "ranker.safetensors", ranker, sizeof ranker);
    check(dm_model_load(host->context, &weights, &host->model), "dm_model_load");
}

/* Once an object: the importer's buffers are handed over as they are, and read during the call alone. */
static void prepare(host* host, const asset* asset) {
    dm_mesh_desc mesh = {.struct_size = sizeof mesh};
    mesh.positions = asset->positions, mesh.vertex_count = asset->vertex_count;
    mesh.indices = asset->indices, mesh.index_count = asset->index_count;
    mesh.part_ids = asset->part_ids, mesh.part_id_bytes = asset->vertex_count * sizeof *asset->part_ids;
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = host->model};
    check(dm_object_prepare(host->context, &desc, &host->object), "dm_object_prepare");
}

/* Puts the object into the room, a metre to the right and turned by a quarter of a right angle. */
static void place(host* host) {
    vec3 up = {0, 1, 0}, where = {1, 0, 0};
    versor turn;
    dm_pose placement;
    glm_quatv(turn, glm_rad(22.5f), up);
    glm_translate_make(host->place, where);
    glm_quat_rotate(host->place, turn, host->place);
    check(dm_pose_from_rotation(turn, from_cglm(where), &placement), "dm_pose_from_rotation");
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    check(dm_scene_create(host->context, &desc, &host->scene), "dm_scene_create");
    check(dm_scene_add(host->context, host->scene, host->object, &placement, &host->instance), "dm_scene_add");
    check(dm_scene_commit(host->context, host->scene), "dm_scene_commit");
}

/* Looks at all of the object from the front, above and the right. */
static void aim(host* host, const asset* asset) {
    vec3 box[2] = {{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}}, centre, eye, forward, up = {0, 1, 0};
    for (uint64_t i = 0; i < asset->vertex_count; i++) {
        vec3 point = {asset->positions[3 * i], asset->positions[3 * i + 1], asset->positions[3 * i + 2]};
        glm_vec3_minv(box[0], point, box[0]);
        glm_vec3_maxv(box[1], point, box[1]);
    }
    const float distance = 1.2f * glm_vec3_distance(box[0], box[1]);
    glm_vec3_center(box[0], box[1], centre);
    glm_mat4_mulv3(host->place, centre, 1, centre);
    glm_vec3_copy((vec3){0.5f, 0.4f, 1}, eye);
    glm_vec3_scale_as(eye, distance, eye);
    glm_vec3_add(centre, eye, eye);
    glm_vec3_sub(centre, eye, forward);
    glm_look(eye, forward, up, host->view);
    glm_perspective(FOV_Y, (float)WIDTH / HEIGHT, 0.02f * distance, 20 * distance, host->projection);
    host->camera = (dm_camera){.struct_size = sizeof host->camera, .fov_y = FOV_Y};
    host->camera.eye = from_cglm(eye), host->camera.forward = from_cglm(forward), host->camera.up = from_cglm(up);
    host->camera.viewport_width = WIDTH, host->camera.viewport_height = HEIGHT;
}

static dm_ray ray_at(const host* host, float x, float y) {
    dm_ray ray;
    check(dm_camera_ray(host->context, &host->camera, x, y, &ray), "dm_camera_ray");
    return ray;
}

/* What the mouse is on. */
static dm_hit pick(host* host, const asset* asset, float x, float y) {
    const dm_ray ray = ray_at(host, x, y);
    dm_hit hit = {.struct_size = sizeof hit};
    check(dm_scene_pick(host->context, host->scene, &ray, &hit), "dm_scene_pick");
    if (hit.object == 0 || hit.part_id == 0) {
        fprintf(stderr, "pixel (%.0f, %.0f) is on no part\n", (double)x, (double)y);
        exit(1);
    }
    mat4 to_clip;
    vec3 pixel;
    glm_mat4_mul(host->projection, host->view, to_clip);
    glm_project((vec3){hit.point.x, hit.point.y, hit.point.z}, to_clip, (vec4){0, 0, WIDTH, HEIGHT}, pixel);
    printf("pixel (%.0f, %.0f) is on %s; its point is drawn at (%.1f, %.1f)\n", (double)x, (double)y,
           asset->names[hit.part_id], (double)pixel[0], (double)(HEIGHT - pixel[1]));
    return hit;
}

/* Rays of a drag are in the frame of the object. */
static dm_ray to_object(host* host, dm_ray ray) {
    mat4 back;
    vec3 origin = {ray.origin.x, ray.origin.y, ray.origin.z};
    vec3 direction = {ray.direction.x, ray.direction.y, ray.direction.z};
    glm_mat4_inv(host->place, back);
    glm_mat4_mulv3(back, origin, 1, origin);
    glm_mat4_mulv3(back, direction, 0, direction);
    return (dm_ray){from_cglm(origin), from_cglm(direction)};
}

/* Every frame while the button is down: the part's matrix in the world, to draw it with. */
static void frame(host* host, dm_drag drag, const dm_hit* hit, float x, float y) {
    const dm_ray ray = to_object(host, ray_at(host, x, y));
    dm_drag_state state = {.struct_size = sizeof state};
    mat4 matrix;
    check(dm_drag_update(host->context, drag, &ray, FRAME_SECONDS, &state), "dm_drag_update");
    check(dm_scene_move(host->context, host->scene, hit->instance, hit->part_id, &state.pose), "dm_scene_move");
    check(dm_scene_commit(host->context, host->scene), "dm_scene_commit");
    dm_pose_to_matrix(&state.pose, (float*)matrix);
    glm_mat4_mul(host->place, matrix, matrix);
    printf("value %6.3f  matrix", (double)state.value);
    for (int i = 0; i < 16; i++) printf(" %.3f", (double)matrix[i / 4][i % 4]);
    printf("\n");
}

int main(int argc, char** argv) {
    const char *path = argc > 1 ? argv[1] : "samples/cabinet.glb", *body = argc > 2 ? argv[2] : "body";
    float mouse[4] = {600, 400, -100, 50}; /* the handle of the left door, and to the left and down */
    for (int i = 0; i < 4 && i + 3 < argc; i++) mouse[i] = strtof(argv[i + 3], NULL);
    static host host;
    asset asset;
    if (!asset_read(path, body, &asset)) return 1;
    start(&host, argc > 7 ? argv[7] : MODELS);
    prepare(&host, &asset);
    place(&host);
    aim(&host, &asset);
    const dm_hit hit = pick(&host, &asset, mouse[0], mouse[1]);
    dm_drag_desc grab = {.struct_size = sizeof grab, .object = hit.object, .part_id = hit.part_id};
    grab.grab_point = hit.object_point;
    dm_drag drag;
    check(dm_drag_begin(host.context, &grab, &drag), "dm_drag_begin");
    for (int i = 0; i <= FRAMES; i++) {
        const float share = (float)i / FRAMES;
        frame(&host, drag, &hit, mouse[0] + share * mouse[2], mouse[1] + share * mouse[3]);
    }
    check(dm_drag_end(host.context, drag, NULL), "dm_drag_end");
    dm_context_destroy(host.context); /* and with it the model, the object and the scene */
    asset_free(&asset);
    return 0;
}
