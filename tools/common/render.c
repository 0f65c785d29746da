/* Ray-traced pictures of an answered object: visibility, shading and film strips. Light and colours are by hand. */
#include "render.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "nodes.h"

enum { GRID = 2, SKY_RAYS = 6, GAP = 6 /* pixels between panels */ };
static const double sky_reach = 0.7; /* share of the object's size: farther surfaces cast no ambient shadow */
static const vec sun_light = {1.55, 1.47, 1.32};
static const double accent_share = 0.6;
/* Accents of parts, in order of their ids, then again from the first one. */
static const vec accents[] = {{0.86, 0.33, 0.09}, {0.10, 0.38, 0.80}, {0.16, 0.58, 0.16}, {0.56, 0.18, 0.68},
                              {0.84, 0.66, 0.06}, {0.05, 0.58, 0.60}, {0.78, 0.08, 0.22}, {0.46, 0.32, 0.16}};

/* ---- the scene ---- */

static void read_colours(renderer* r) {
    const uint32_t count = dm_gltf_node_count(r->session->gltf);
    r->colours = cli_alloc(count * sizeof *r->colours);
    for (uint32_t i = 0; i < count; i++) {
        dm_gltf_node node;
        dm_gltf_get_node(r->session->gltf, i, &node);
        r->colours[i] = scale(vec_at(node.colour), 0.85); /* albedo below 1, as real surfaces have */
        for (uint64_t face = 0; face < node.face_count; face++) r->face_node[node.first_face + face] = i;
    }
}

static void measure(renderer* r) {
    dm_object_info info = {.struct_size = sizeof info};
    dm_object_get_info(r->session->context, r->session->object, &info);
    const vec low = vec_of(info.box_min), high = vec_of(info.box_max);
    r->centre = scale(add(low, high), 0.5);
    r->size = (double)info.size;
    r->floor = dot(r->up, low);
}

dm_result render_open_parts(renderer* r, session* session, char up, uint32_t* face_part, uint32_t part_count) {
    memset(r, 0, sizeof *r);
    r->session = session;
    r->face_part = face_part;
    r->part_count = part_count;
    r->up = (vec){up == 'x', up == 'y', up == 'z'};
    r->random.state = 1;
    r->grid = GRID;
    r->sky_rays = SKY_RAYS;
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    dm_result result = dm_scene_create(session->context, &desc, &r->scene);
    if (result != DM_OK) return result;
    result = dm_scene_add(session->context, r->scene, session->object, NULL, &r->instance);
    r->face_node = cli_alloc_zeroed(session->mesh.index_count / 3 * sizeof *r->face_node);
    r->normals = smooth_build(&session->mesh);
    read_colours(r);
    measure(r);
    return result;
}

dm_result render_open(renderer* r, session* session, char up) {
    const uint64_t faces = session->mesh.index_count / 3;
    uint32_t* face_part = cli_alloc(faces * sizeof *face_part);
    uint8_t* moving = session_moving_faces(session);
    for (uint64_t face = 0; face < faces; face++) face_part[face] = moving[face] ? JOB_PART : 0;
    free(moving);
    return render_open_parts(r, session, up, face_part, 0);
}

void render_close(renderer* r) {
    if (r->scene) dm_scene_destroy(r->session->context, r->scene);
    smooth_free(&r->normals);
    free(r->face_node);
    free(r->colours);
    free(r->face_part);
}

vec render_accent(uint32_t part_id) {
    return accents[(part_id - 1) % (sizeof accents / sizeof *accents)];
}

/* ---- light ---- */

static bool cast(const renderer* r, vec origin, vec direction, dm_hit* out_hit) {
    const dm_ray ray = {vec_out(origin), vec_out(direction)};
    return dm_scene_pick(r->session->context, r->scene, &ray, out_hit) == DM_OK && out_hit->object != 0;
}

static vec mix(vec a, vec b, double share) {
    return add(scale(a, 1 - share), scale(b, share));
}

/* What the sky, and the floor below it, send from a direction. */
static vec sky(const renderer* r, vec direction) {
    const vec ground = {0.46, 0.44, 0.42}, zenith = {0.62, 0.72, 0.86};
    return mix(ground, zenith, 0.5 + 0.5 * dot(direction, r->up));
}

/* A direction about `normal`, by its cosine; stratum i of r->sky_rays. */
static vec sky_direction(renderer* r, vec normal, int i) {
    const vec helper = fabs(normal.x) < 0.6 ? (vec){1, 0, 0} : (vec){0, 1, 0};
    const vec tangent = unit(cross(helper, normal)), other = cross(normal, tangent);
    const double square = (i + random_unit(&r->random)) / r->sky_rays, angle = TWO_PI * random_unit(&r->random);
    const double radius = sqrt(square);
    return add(scale(normal, sqrt(1 - square)),
               add(scale(tangent, radius * cos(angle)), scale(other, radius * sin(angle))));
}

/* Returns the light on a surface: the sun where it is not occluded, and the unoccluded part of the sky. */
static vec light_at(renderer* r, vec point, vec normal) {
    dm_hit hit = {.struct_size = sizeof hit};
    vec light = {0, 0, 0};
    const vec start =
        add(point, scale(normal, 2e-4 * r->size /* off the surface, so that a ray does not hit it again */));
    const double facing = dot(normal, r->sun);
    const vec jitter = {random_unit(&r->random) - 0.5, random_unit(&r->random) - 0.5, random_unit(&r->random) - 0.5};
    if (facing > 0 && !cast(r, start, add(r->sun, scale(jitter, 0.07 /* radius of the sun: soft shadows */)), &hit))
        light = scale(sun_light, facing);
    for (int i = 0; i < r->sky_rays; i++) {
        const vec direction = sky_direction(r, normal, i);
        const bool open = !cast(r, start, direction, &hit) || (double)hit.distance > sky_reach * r->size;
        light = add(light, scale(sky(r, direction), (open ? 1.0 : 0.12 /* light between surfaces */) / r->sky_rays));
    }
    return light;
}

static vec surface(renderer* r, const dm_hit* hit, vec view) {
    vec normal = smooth_at(&r->normals, hit->triangle, (double)hit->u, (double)hit->v);
    if (hit->part_id != 0) {
        const float* real = render_pose(r, r->poses, 0, hit->part_id)->real;
        const vec axis = vec_at(real);
        const double angle = 2 * atan2(length(axis), (double)real[3]);
        normal = turn(normal, unit(axis), angle);
    }
    if (dot(normal, view) > 0) normal = scale(normal, -1); /* inside out, or seen from inside */
    vec albedo = r->colours[r->face_node[hit->triangle]];
    const uint32_t part = r->face_part[hit->triangle];
    if (part != 0) albedo = mix(albedo, render_accent(part), accent_share);
    const vec light = light_at(r, vec_of(hit->point), normal);
    return (vec){albedo.x * light.x, albedo.y * light.y, albedo.z * light.z};
}

static vec background(double height) {
    const vec low = {0.83, 0.84, 0.86}, high = {0.55, 0.64, 0.76};
    return mix(low, high, height);
}

/* The floor is the background, darker where the object takes the light away. */
static vec floor_or_sky(renderer* r, vec origin, vec direction, double height) {
    const vec behind = background(height);
    const double down = dot(direction, r->up), distance = (r->floor - dot(origin, r->up)) / down;
    if (!(down < -1e-6) || distance < 0) return behind;
    const vec point = add(origin, scale(direction, distance));
    const double away = length(sub(point, r->centre)) / r->size;
    if (away > 2) return behind;
    const vec shaded = light_at(r, point, r->up);
    const vec open = add(scale(sun_light, dot(r->up, r->sun)), (vec){0.59, 0.67, 0.78});
    const double share = fmin(1, (shaded.x + shaded.y + shaded.z) / (open.x + open.y + open.z));
    const double fade = fmin(1, fmax(0, away - 1));
    return scale(behind, mix((vec){share, 0, 0}, (vec){1, 0, 0}, fade).x);
}

static vec trace(renderer* r, double x, double y) {
    dm_ray ray;
    dm_hit hit = {.struct_size = sizeof hit};
    if (dm_camera_ray(r->session->context, &r->camera, (float)x, (float)y, &ray) != DM_OK) return (vec){0, 0, 0};
    const vec origin = vec_of(ray.origin), direction = unit(vec_of(ray.direction));
    if (cast(r, origin, direction, &hit)) return surface(r, &hit, direction);
    return floor_or_sky(r, origin, direction, 1 - y / (double)r->camera.viewport_height);
}

/* ---- pictures ---- */

/* Moves all parts of the object. */
static dm_result place_parts(const renderer* r, const dm_pose* poses) {
    dm_context* context = r->session->context;
    dm_object_info info = dm_object_info_default();
    dm_result result = dm_object_get_info(context, r->session->object, &info);
    for (uint32_t i = 0; i < info.part_count && result == DM_OK; i++) {
        dm_part_info part = dm_part_info_default();
        result = dm_object_get_part(context, r->session->object, i, &part);
        if (result == DM_OK)
            result = dm_scene_move(context, r->scene, r->instance, part.id, render_pose(r, poses, 0, part.id));
    }
    return result == DM_OK ? dm_scene_commit(context, r->scene) : result;
}

dm_result render_draw(renderer* r, const dm_pose* poses, picture* picture, int left) {
    const dm_result result = place_parts(r, poses);
    if (result != DM_OK) return result;
    r->poses = poses;
    for (int y = 0; y < (int)r->camera.viewport_height; y++) {
        for (int x = 0; x < (int)r->camera.viewport_width; x++) {
            vec sum = {0, 0, 0};
            for (int row = 0; row < r->grid; row++)
                for (int column = 0; column < r->grid; column++)
                    sum = add(sum, trace(r, x + (column + 0.5) / r->grid, y + (row + 0.5) / r->grid));
            picture_set(picture, left + x, y, scale(sum, 1.0 / (r->grid * r->grid)));
        }
    }
    return DM_OK;
}

void render_segment(const renderer* r, vec from, vec to, const uint8_t rgb[3], picture* picture, int left) {
    const uint8_t dark[3] = {rgb[0] / 3, rgb[1] / 3, rgb[2] / 3};
    double x0, y0, x1, y1;
    render_project(r, from, &x0, &y0);
    render_project(r, to, &x1, &y1);
    const int right = left + (int)r->camera.viewport_width;
    picture_line(picture, x0 + left, y0, x1 + left, y1, 4, dark, left, right);
    picture_line(picture, x0 + left, y0, x1 + left, y1, 2, rgb, left, right);
}

void render_axis(const renderer* r, const dm_joint* joint, const uint8_t rgb[3], picture* picture, int left) {
    const vec half = scale(vec_of(joint->axis), 0.65 * r->size), middle = vec_of(joint->origin);
    render_segment(r, sub(middle, half), add(middle, half), rgb, picture, left);
}

void* render_film(renderer* r, const dm_pose* poses, uint32_t count, const dm_joint* axis, size_t* out_size) {
    const int width = (int)r->camera.viewport_width, height = (int)r->camera.viewport_height;
    picture strip = picture_new((width + GAP) * (int)count - GAP, height);
    dm_result result = DM_OK;
    static const uint8_t blue[3] = {70, 150, 255};
    for (uint32_t i = 0; i < count && result == DM_OK; i++) {
        const int left = (int)i * (width + GAP);
        result = render_draw(r, &poses[i], &strip, left);
        if (axis != NULL) render_axis(r, axis, blue, &strip, left);
    }
    void* png = result == DM_OK ? picture_encode(&strip, out_size) : NULL;
    if (result == DM_OK && png == NULL)
        session_fail(r->session, DM_ERROR_OUT_OF_MEMORY, "no memory for the picture of %d x %d", strip.width, height);
    picture_free(&strip);
    return png;
}
