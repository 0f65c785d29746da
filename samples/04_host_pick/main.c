/* The host picks by itself (its physics, its GPU, its selection buffer): dragmesh keeps no triangles and is told the
 * point that was hit. */
#include <math.h>

#include "../common/cabinet.h"
#include "../common/weights.h"

typedef struct hit {
    float distance;
    int part; /* 0 = body, or nothing hit */
    dm_vec3 point;
} hit;

/* What a physics engine answers: here, the nearest of the cabinet's boxes (slabs method). */
static hit host_raycast(const dm_ray* ray) {
    const float o[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    const float d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    hit best = {.distance = INFINITY};
    for (int b = 0; b < CABINET_BOXES; b++) {
        float enter = 0, leave = INFINITY;
        for (int k = 0; k < 3; k++) {
            const float t0 = (cabinet_boxes[b][k] - o[k]) / d[k], t1 = (cabinet_boxes[b][k + 3] - o[k]) / d[k];
            enter = fmaxf(enter, fminf(t0, t1));
            leave = fminf(leave, fmaxf(t0, t1));
        }
        if (enter > leave || enter >= best.distance) continue;
        best = (hit){enter, (int)cabinet_boxes[b][6], {o[0] + enter * d[0], o[1] + enter * d[1], o[2] + enter * d[2]}};
    }
    return best;
}

int main(int argc, char** argv) {
    static cabinet shape;
    const dm_context_desc host = {.struct_size = sizeof host, .log = {NULL, print_message}};
    dm_context* context;
    dm_model model;
    dm_object object;
    if (dm_context_create(&host, &context) != DM_OK) return 1;
    if (load_weights(context, argc > 1 ? argv[1] : "sdk/models", &model) != DM_OK) return 1;
    const dm_mesh_desc mesh = cabinet_make(&shape);
    const dm_object_desc desc = {
        .struct_size = sizeof desc, .flags = DM_PREPARE_WITHOUT_PICKING, .mesh = &mesh, .model = model};
    if (dm_object_prepare(context, &desc, &object) != DM_OK) return 1;

    /* The player points at the drawer's handle and pulls: down and to the left on the screen, that is towards them. */
    const dm_camera camera = {.struct_size = sizeof camera,
                              .fov_y = 0.8f,
                              .eye = {1.3f, 1.7f, 2.0f},
                              .forward = {-1.0f, -0.95f, -1.8f},
                              .up = {0, 1, 0},
                              .viewport_width = 1280,
                              .viewport_height = 720};
    float x = 640, y = 320;
    dm_ray ray;
    dm_camera_ray(context, &camera, x, y, &ray);
    const hit picked = host_raycast(&ray);
    printf("the host's ray hits part %d at (%.3f, %.3f, %.3f)\n", picked.part, (double)picked.point.x,
           (double)picked.point.y, (double)picked.point.z);
    if (picked.part == 0) return 1;

    const dm_drag_desc grab = {
        .struct_size = sizeof grab, .object = object, .part_id = (uint32_t)picked.part, .grab_point = picked.point};
    dm_drag drag;
    dm_drag_state state = {.struct_size = sizeof state};
    if (dm_drag_begin(context, &grab, &drag) != DM_OK) return 1;
    for (int frame = 0; frame <= 60; frame++, x -= 2.0f, y += 2.4f) {
        dm_camera_ray(context, &camera, x, y, &ray);
        if (dm_drag_update(context, drag, &ray, 1.0f / 60, &state) != DM_OK) return 1;
        if (frame % 15 == 0)
            printf("pointer (%4.0f, %4.0f)  value %6.3f  grabbed point (%.3f, %.3f, %.3f)\n", (double)x, (double)y,
                   (double)state.value, (double)state.grab_point.x, (double)state.grab_point.y,
                   (double)state.grab_point.z);
    }
    dm_context_destroy(context);
    return 0;
}
