/* Where the camera of a picture stands. */
#include "render.h"

#include <math.h>

#include "cli.h"

static const double fov_y = 0.5; /* rad: a long lens, little distortion */
static const double margin = 1.06;
enum { FIT_VERTICES = 4000, FIT_ROUNDS = 4 };

typedef struct basis {
    vec right, up, forward;
} basis;

const dm_pose* render_pose(const renderer* r, const dm_pose* poses, uint32_t index, uint32_t part_id) {
    return r->part_count == 0 ? &poses[index] : &poses[(size_t)index * r->part_count + part_id];
}

static basis camera_basis(const dm_camera* camera) {
    basis b = {.forward = unit(vec_of(camera->forward))};
    b.right = unit(cross(b.forward, vec_of(camera->up)));
    b.up = cross(b.right, b.forward);
    return b;
}

/* The horizontal direction from the object to the camera: a third of a quarter turn beside the way the part moves. */
static vec azimuth(const renderer* r, vec toward) {
    vec way = sub(toward, scale(r->up, dot(toward, r->up)));
    if (length(way) < 0.3 * length(toward) || length(toward) == 0) {
        /* No side to prefer: the file's front, +Z where Y is up (glTF), -Y where Z is up. */
        way = r->up.y > 0.5 ? (vec){0, 0, 1} : r->up.z > 0.5 ? (vec){0, -1, 0} : (vec){0, 0, 1};
    }
    return turn(unit(way), r->up, 0.6);
}

/* Extremes of the picture coordinates (x right, y up, as slopes) of all that must be seen. */
typedef struct extent {
    double left, right, bottom, top;
} extent;

static void grow(extent* e, const basis* b, vec eye, vec point) {
    const vec d = sub(point, eye);
    const double depth = fmax(dot(d, b->forward), 1e-9);
    const double x = dot(d, b->right) / depth, y = dot(d, b->up) / depth;
    e->left = fmin(e->left, x);
    e->right = fmax(e->right, x);
    e->bottom = fmin(e->bottom, y);
    e->top = fmax(e->top, y);
}

vec render_moved(const dm_pose* pose, vec point) {
    float xyz[3] = {(float)point.x, (float)point.y, (float)point.z};
    dm_pose_apply_points(pose, xyz, 0, xyz, 0, 1);
    return vec_at(xyz);
}

static extent measure(const renderer* r, const basis* b, vec eye, const dm_pose* poses, uint32_t count) {
    const dm_mesh_desc* mesh = &r->session->mesh;
    const uint64_t step = mesh->index_count > FIT_VERTICES ? mesh->index_count / FIT_VERTICES : 1;
    extent e = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (uint64_t i = 0; i < mesh->index_count; i += step) {
        const vec point = vec_at((const float*)mesh->positions + 3 * (size_t)((const uint32_t*)mesh->indices)[i]);
        const uint32_t part = r->face_part[i / 3];
        if (part == 0) grow(&e, b, eye, point);
        for (uint32_t k = 0; k < count && part != 0; k++)
            grow(&e, b, eye, render_moved(render_pose(r, poses, k, part), point));
    }
    return e;
}

void render_aim(renderer* r, vec toward, const dm_pose* poses, uint32_t count, int width, int height) {
    const vec side = azimuth(r, toward);
    const vec away = unit(add(side, scale(r->up, 0.5)));
    r->camera = (dm_camera){.struct_size = sizeof r->camera,
                            .fov_y = (float)fov_y,
                            .forward = vec_out(scale(away, -1)),
                            .up = vec_out(r->up),
                            .viewport_width = (float)width,
                            .viewport_height = (float)height};
    const basis b = camera_basis(&r->camera);
    const double slope_y = tan(fov_y / 2), slope_x = slope_y * width / height;
    vec target = r->centre;
    double distance = 3 * r->size / slope_y;
    for (int round = 0; round < FIT_ROUNDS; round++) {
        const extent e = measure(r, &b, add(target, scale(away, distance)), poses, count);
        target = add(target, add(scale(b.right, distance * (e.left + e.right) / 2),
                                 scale(b.up, distance * (e.bottom + e.top) / 2)));
        distance *= margin * fmax((e.right - e.left) / (2 * slope_x), (e.top - e.bottom) / (2 * slope_y));
    }
    r->camera.eye = vec_out(add(target, scale(away, distance)));
    r->sun = unit(add(add(scale(r->up, 1.0), scale(b.right, -0.55)), scale(away, 0.45)));
}

void render_project(const renderer* r, vec point, double* out_x, double* out_y) {
    const basis b = camera_basis(&r->camera);
    const vec d = sub(point, vec_of(r->camera.eye));
    const double depth = dot(d, b.forward), pixels = (double)r->camera.viewport_height / (2 * tan(fov_y / 2));
    *out_x = (double)r->camera.viewport_width / 2 + pixels * dot(d, b.right) / depth;
    *out_y = (double)r->camera.viewport_height / 2 - pixels * dot(d, b.up) / depth;
}
