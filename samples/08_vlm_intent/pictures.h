/* Pictures of what a hypothesis would do: three panels, the part at one end of its range, at rest, and at the other
 * end. Ray casts by the library itself, in a context of their own, because a callback may call nothing of the one that
 * prepares. */
#ifndef SAMPLE_PICTURES_H
#define SAMPLE_PICTURES_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <png.h>

#include "dragmesh/dragmesh.h"

enum { PANEL = 192, PANELS = 3, PICTURE_WIDTH = PANEL * PANELS }; /* pixels */

typedef struct studio {
    dm_context* context;
    dm_object object;
    dm_scene scene;
    uint32_t instance;
} studio;

static inline dm_result studio_open(const dm_context_desc* host, const dm_mesh_desc* mesh, studio* out) {
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = mesh}; /* no weights: its joints don't count */
    const dm_scene_desc scene = {.struct_size = sizeof scene};
    dm_result result = dm_context_create(host, &out->context);
    if (result == DM_OK) result = dm_object_prepare(out->context, &desc, &out->object);
    if (result == DM_OK) result = dm_scene_create(out->context, &scene, &out->scene);
    return result == DM_OK ? dm_scene_add(out->context, out->scene, out->object, NULL, &out->instance) : result;
}

/* From the right above the front (+z), so far away that an object twice as large would still be in the picture. */
static inline dm_camera studio_camera(const studio* s) {
    dm_object_info info = {.struct_size = sizeof info};
    dm_object_get_info(s->context, s->object, &info);
    const dm_vec3 a = info.box_min, b = info.box_max, centre = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
    const dm_vec3 from = {1.6f * info.size, 1.4f * info.size, 2.6f * info.size};
    return (dm_camera){.struct_size = sizeof(dm_camera),
                       .fov_y = 0.7f,
                       .eye = {centre.x + from.x, centre.y + from.y, centre.z + from.z},
                       .forward = {-from.x, -from.y, -from.z},
                       .up = {0, 1, 0},
                       .viewport_width = PANEL,
                       .viewport_height = PANEL};
}

/* White where nothing is, the part orange, the rest grey, each by how it faces the camera. */
static inline void shade(const dm_ray* ray, const dm_hit* hit, uint32_t part, uint8_t rgb[3]) {
    static const float orange[3] = {240, 130, 30}, grey[3] = {170, 170, 175};
    const dm_vec3 n = hit->normal, d = ray->direction;
    const float facing = fabsf(n.x * d.x + n.y * d.y + n.z * d.z);
    for (int k = 0; k < 3; k++) {
        const float colour = hit->part_id == part ? orange[k] : grey[k];
        rgb[k] = hit->object == 0 ? 255 : (uint8_t)(colour * (0.35f + 0.65f * facing));
    }
}

static inline void draw_panel(const studio* s, uint32_t part, const dm_pose* pose, int panel, uint8_t* rgb) {
    const dm_camera camera = studio_camera(s);
    dm_scene_move(s->context, s->scene, s->instance, part, pose);
    dm_scene_commit(s->context, s->scene);
    for (int y = 0; y < PANEL; y++) {
        for (int x = 0; x < PANEL; x++) {
            dm_ray ray;
            dm_hit hit = {.struct_size = sizeof hit};
            dm_camera_ray(s->context, &camera, (float)x + 0.5f, (float)y + 0.5f, &ray);
            dm_scene_pick(s->context, s->scene, &ray, &hit);
            shade(&ray, &hit, part, rgb + 3 * (size_t)(y * PICTURE_WIDTH + panel * PANEL + x));
        }
    }
}

/* The bytes of a .png, to be freed; NULL when there is no memory. */
static inline void* draw_hypothesis(const studio* s, uint32_t part, const dm_hypothesis* hypothesis, size_t* out_size) {
    static uint8_t rgb[3 * PICTURE_WIDTH * PANEL];
    const dm_pose rest = {.real = {0, 0, 0, 1}};
    const dm_pose* const poses[PANELS] = {&hypothesis->ends[0].pose, &rest, &hypothesis->ends[1].pose};
    for (int i = 0; i < PANELS; i++) draw_panel(s, part, poses[i], i, rgb);
    dm_scene_move(s->context, s->scene, s->instance, part, &rest);
    png_image image = {.version = PNG_IMAGE_VERSION, .width = PICTURE_WIDTH, .height = PANEL, .format = PNG_FORMAT_RGB};
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    void* png = malloc(size);
    *out_size = 0;
    if (png != NULL && png_image_write_to_memory(&image, png, &size, 0, rgb, 0, NULL)) *out_size = size;
    return png;
}

/* A data: URL of a .png, to be freed. */
static inline char* data_url(const unsigned char* bytes, size_t size) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    static const char head[] = "data:image/png;base64,";
    char *out = malloc(sizeof head + (size + 2) / 3 * 4), *to = out;
    if (out == NULL) return NULL;
    memcpy(out, head, sizeof head);
    to += sizeof head - 1;
    for (size_t i = 0; i < size; i += 3) {
        const unsigned b1 = i + 1 < size ? bytes[i + 1] : 0, b2 = i + 2 < size ? bytes[i + 2] : 0;
        const unsigned three = (unsigned)bytes[i] << 16 | b1 << 8 | b2;
        for (int k = 0; k < 4; k++) *to++ = digits[three >> (18 - 6 * k) & 63];
    }
    if (size % 3) to[-1] = '=';
    if (size % 3 == 1) to[-2] = '=';
    *to = 0;
    return out;
}

#endif
