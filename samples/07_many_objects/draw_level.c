/* Ray casts by the scene itself: parts that move are orange, those that were moved bright, props that are still to come
 * dark places on the ground. */
#include <math.h>

#include "../common/vectors.h"
#include "draw.h"

enum { SAMPLES = 2 /* a side of a pixel */ };
#define FOOT 0.45f /* m: half of the side of the place of a prop that is not there */
#define LINE 0.03f /* m: half the width of the line where the reach ends */

static const dm_vec3 sun = {0.45f, 0.75f, 0.48f}, sky = {0.80f, 0.87f, 0.95f};

static dm_vec3 ground_colour(const stream* s, float x, float z, float eye_x, float eye_z) {
    dm_vec3 colour = {0.62f, 0.64f, 0.63f};
    if (fabsf(x) < 0.6f * STREET) colour = (dm_vec3){0.50f, 0.51f, 0.53f};
    for (int row = (int)(-z / PITCH) - 1; row <= (int)(-z / PITCH) + 2; row++) {
        for (uint32_t column = 0; column < COLUMNS && row >= 0; column++) {
            const uint32_t index = (uint32_t)row * COLUMNS + column;
            if (index >= s->level->prop_count) continue;
            const prop* p = &s->level->props[index];
            if (!p->placed && fabsf(p->x - x) < FOOT && fabsf(p->z - z) < FOOT) colour = (dm_vec3){0.33f, 0.36f, 0.40f};
        }
    }
    if (fabsf(hypotf(x - eye_x, z - eye_z) - s->reach) < 4 * LINE) colour = (dm_vec3){0.15f, 0.45f, 0.75f};
    return colour;
}

static dm_vec3 part_colour(const stream* s, const dm_hit* hit) {
    static const dm_vec3 woods[6] = {{0.86f, 0.74f, 0.56f}, {0.42f, 0.58f, 0.68f}, {0.66f, 0.76f, 0.56f},
                                     {0.70f, 0.48f, 0.40f}, {0.56f, 0.52f, 0.72f}, {0.90f, 0.86f, 0.76f}};
    const uint32_t prop = s->prop_of[hit->instance];
    if (hit->part_id == 0) return woods[s->level->props[prop].kind % 6];
    if (level_kept(s->level, prop, hit->part_id) != NULL) return (dm_vec3){0.10f, 0.66f, 0.40f};
    return (dm_vec3){0.96f, 0.55f, 0.18f};
}

static bool is_in_shadow(const stream* s, dm_vec3 point, dm_vec3 normal) {
    const dm_ray ray = {along(point, normal, 1e-3f), sun};
    dm_hit hit = {.struct_size = sizeof hit};
    return dm_scene_pick(s->context, s->scene, &ray, &hit) == DM_OK && hit.object != 0;
}

static dm_vec3 lit(const stream* s, dm_vec3 colour, dm_vec3 point, dm_vec3 normal) {
    const float facing = fmaxf(dot(normal, unit(sun)), 0);
    const float light = facing > 0 && !is_in_shadow(s, point, normal) ? facing : 0;
    return scale(colour, 0.42f + 0.10f * normal.y + 0.60f * light);
}

static dm_vec3 shade(const stream* s, const dm_ray* ray, const dm_vec3* eye) {
    dm_hit hit = {.struct_size = sizeof hit};
    const dm_vec3 direction = unit(ray->direction);
    float distance = direction.y < 0 ? -ray->origin.y / direction.y : INFINITY;
    dm_scene_pick(s->context, s->scene, ray, &hit);
    const bool ground = hit.object == 0 || hit.distance > distance;
    if (ground && distance > 400) return sky;
    if (!ground) distance = hit.distance;
    const dm_vec3 point = along(ray->origin, direction, distance);
    dm_vec3 colour, normal = {0, 1, 0};
    if (ground) {
        colour = ground_colour(s, point.x, point.z, eye->x, eye->z);
    } else {
        colour = part_colour(s, &hit);
        normal = dot(hit.normal, direction) < 0 ? hit.normal : scale(hit.normal, -1);
    }
    return mix(lit(s, colour, point, normal), sky, 1 - expf(-distance / 120));
}

canvas draw_level(const hands* h, const dm_camera* camera, int width, int height) {
    const stream* s = h->stream;
    canvas c = canvas_new(width, height);
    dm_camera view = *camera;
    view.viewport_width = (float)width, view.viewport_height = (float)height;
    for (int i = 0; i < width * height && c.rgb != NULL; i++) {
        const int column = i % width, row = i / width;
        dm_vec3 sum = {0, 0, 0};
        for (int k = 0; k < SAMPLES * SAMPLES; k++) {
            const int across = k % SAMPLES, down = k / SAMPLES;
            const float x = (float)column + ((float)across + 0.5f) / SAMPLES;
            const float y = (float)row + ((float)down + 0.5f) / SAMPLES;
            dm_ray ray;
            if (dm_camera_ray(s->context, &view, x, y, &ray) != DM_OK) continue;
            sum = add(sum, shade(s, &ray, &camera->eye));
        }
        const dm_vec3 mean = scale(sum, 255.0f / (SAMPLES * SAMPLES));
        const uint8_t rgb[3] = {(uint8_t)fminf(mean.x, 255), (uint8_t)fminf(mean.y, 255), (uint8_t)fminf(mean.z, 255)};
        canvas_blend(&c, column, row, rgb, 1);
    }
    return c;
}
