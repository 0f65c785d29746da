/* A camera on a sphere round a point: orbit, pan, zoom. */
#include "camera.h"

#include <stdbool.h>

dm_vec3 camera_up(const camera* camera) {
    return camera->z_up ? vec(0, 0, 1) : vec(0, 1, 0);
}

/* y-up words to the world's: what is (x, y, z) there is (x, -z, y) here. */
static dm_vec3 turned(const camera* camera, dm_vec3 v) {
    return camera->z_up ? vec(v.x, -v.z, v.y) : v;
}

dm_vec3 camera_forward(const camera* camera) {
    const float level = cosf(camera->pitch);
    return turned(camera, vec(-sinf(camera->yaw) * level, -sinf(camera->pitch), -cosf(camera->yaw) * level));
}

dm_vec3 camera_eye(const camera* camera) {
    return along(camera->target, camera_forward(camera), -camera->distance);
}

void camera_frame(camera* camera, dm_vec3 box_min, dm_vec3 box_max) {
    const float radius = 0.5f * length(sub(box_max, box_min));
    camera->yaw = 0.6f;
    camera->pitch = 0.38f;
    camera->fov_y = 0.6f;
    camera->target = scale(add(box_min, box_max), 0.5f);
    const float aspect = (float)camera->width / (float)camera->height;
    camera->distance = 1.15f * radius / sinf(camera->fov_y / 2) / fminf(1, aspect);
}

void camera_orbit(camera* camera, float dx, float dy) {
    camera->yaw -= dx * 0.008f;
    camera->pitch = glm_clamp(camera->pitch + dy * 0.008f, -1.5f, 1.5f);
}

void camera_pan(camera* camera, float dx, float dy) {
    const dm_vec3 forward = camera_forward(camera), side = unit(cross(forward, camera_up(camera)));
    const float unit_of_pixel = 2 * camera->distance * tanf(camera->fov_y / 2) / (float)camera->height;
    camera->target = along(camera->target, side, -dx * unit_of_pixel);
    camera->target = along(camera->target, cross(side, forward), dy * unit_of_pixel);
}

void camera_zoom(camera* camera, float steps) {
    camera->distance *= powf(0.9f, steps);
}

void camera_matrix(const camera* camera, mat4 out) {
    mat4 view, projection;
    glm_look(raw(camera_eye(camera)).v, raw(camera_forward(camera)).v, raw(camera_up(camera)).v, view);
    glm_perspective(camera->fov_y, (float)camera->width / (float)camera->height, camera->distance * 0.02f,
                    camera->distance * 20, projection);
    glm_mat4_mul(projection, view, out);
}

dm_camera camera_for_picking(const camera* camera) {
    return (dm_camera){.struct_size = sizeof(dm_camera),
                       .fov_y = camera->fov_y,
                       .eye = camera_eye(camera),
                       .forward = camera_forward(camera),
                       .up = camera_up(camera),
                       .viewport_width = (float)camera->width,
                       .viewport_height = (float)camera->height};
}

bool camera_project(const camera* camera, dm_vec3 p, float out[3]) {
    mat4 matrix;
    vec4 clip, point = {p.x, p.y, p.z, 1};
    camera_matrix(camera, matrix);
    glm_mat4_mulv(matrix, point, clip);
    if (clip[3] <= 0) return false;
    out[0] = (clip[0] / clip[3] * 0.5f + 0.5f) * (float)camera->width;
    out[1] = (0.5f - clip[1] / clip[3] * 0.5f) * (float)camera->height;
    out[2] = clip[2] / clip[3] * 0.5f + 0.5f;
    return true;
}
