/* Draws contact sheets by a small rasteriser: a depth buffer, flat shading, four samples a pixel; parts in colour. */
#include "sheet.h"

#include <errno.h>
#include <math.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../samples/common/output_file.h"
#include "asset.h"

enum { SIDE = 104, SAMPLES = 2, FINE = SIDE * SAMPLES };

/* The picture of one object, at twice the resolution of the sheet. */
typedef struct tile {
    float depth[FINE * FINE];
    unsigned char rgb[FINE * FINE][3];
} tile;

typedef struct view {
    float right[3], up[3], out[3]; /* rows of the camera */
    float centre[3], scale;
} view;

static float dot3(const float* a, const float* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Moves x to where the joint's value takes it. */
static void move(const dmg_joint* joint, float value, const float x[3], float out[3]) {
    const float turn = joint->type == DM_JOINT_PRISMATIC ? 0.0f : value, *a = joint->axis;
    const float advance =
        joint->type == DM_JOINT_PRISMATIC ? value : (joint->type == DM_JOINT_SCREW ? value * joint->pitch : 0.0f);
    float r[3];
    for (int k = 0; k < 3; ++k) r[k] = x[k] - joint->origin[k];
    const float c = cosf(turn), s = sinf(turn), along = dot3(a, r) * (1.0f - c);
    const float side[3] = {a[1] * r[2] - a[2] * r[1], a[2] * r[0] - a[0] * r[2], a[0] * r[1] - a[1] * r[0]};
    for (int k = 0; k < 3; ++k) out[k] = joint->origin[k] + r[k] * c + side[k] * s + a[k] * (along + advance);
}

/* Returns the value to which a part is opened for the second picture. */
static float open_value(const dmg_joint* joint) {
    if (joint->type == DM_JOINT_CONTINUOUS) return 0.7f;
    const float most = joint->opens > 0 ? joint->upper : joint->lower;
    return joint->type != DM_JOINT_REVOLUTE ? 0.8f * most : fmaxf(-1.2f, fminf(1.2f, 0.8f * most));
}

/* Every vertex where its part and all that carry it have moved to: the joints are all given at rest, so a part moves
 * first and its carriers after it. */
static float* posed(const dmg_object* object, int open) {
    float* out = malloc((size_t)object->vertex_count * 3 * sizeof *out);
    if (!out) return NULL;
    memcpy(out, object->positions, (size_t)object->vertex_count * 3 * sizeof *out);
    for (uint32_t i = 0; open && i < object->face_count * 3; ++i) {
        const uint32_t v = object->indices[i];
        float x[3];
        memcpy(x, object->positions + (size_t)v * 3, sizeof x);
        for (uint32_t part = object->face_part[i / 3]; part != 0; part = object->joints[part - 1].parent) {
            float moved[3];
            move(&object->joints[part - 1], open_value(&object->joints[part - 1]), x, moved);
            memcpy(x, moved, sizeof x);
        }
        memcpy(out + (size_t)v * 3, x, sizeof x);
    }
    return out;
}

static view look_at(const float* points, uint32_t count) {
    static const float yaw = 0.6f, pitch = 0.42f;
    view v = {.right = {cosf(yaw), 0, -sinf(yaw)},
              .up = {-sinf(pitch) * sinf(yaw), cosf(pitch), -sinf(pitch) * cosf(yaw)},
              .out = {cosf(pitch) * sinf(yaw), sinf(pitch), cosf(pitch) * cosf(yaw)}};
    float low[3] = {HUGE_VALF, HUGE_VALF, HUGE_VALF}, high[3] = {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};
    for (uint32_t i = 0; i < count; ++i) {
        const float* at = points + (size_t)3 * i;
        const float p[3] = {dot3(v.right, at), dot3(v.up, at), dot3(v.out, at)};
        for (int k = 0; k < 3; ++k) {
            low[k] = fminf(low[k], p[k]);
            high[k] = fmaxf(high[k], p[k]);
        }
    }
    for (int k = 0; k < 3; ++k) v.centre[k] = 0.5f * (low[k] + high[k]);
    v.scale = 0.92f * FINE / fmaxf(fmaxf(high[0] - low[0], high[1] - low[1]), 1e-9f);
    return v;
}

static void project(const view* v, const float* p, float out[3]) {
    out[0] = 0.5f * FINE + v->scale * (dot3(v->right, p) - v->centre[0]);
    out[1] = 0.5f * FINE - v->scale * (dot3(v->up, p) - v->centre[1]);
    out[2] = dot3(v->out, p);
}

/* Computes the shade: light from the upper left, the same on both sides of a face. */
static float shade(const float* a, const float* b, const float* c) {
    static const float light[3] = {-0.35f, 0.8f, 0.49f};
    float u[3], w[3];
    for (int k = 0; k < 3; ++k) {
        u[k] = b[k] - a[k];
        w[k] = c[k] - a[k];
    }
    const float n[3] = {u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
    const float length = sqrtf(dot3(n, n));
    return length > 0.0f ? 0.4f + 0.6f * fabsf(dot3(n, light)) / length : 1.0f;
}

static void part_colour(uint32_t part, float light, unsigned char out[3]) {
    static const float palette[7][3] = {{0.87f, 0.3f, 0.2f},  {0.25f, 0.5f, 0.9f},   {0.3f, 0.68f, 0.3f},
                                        {0.93f, 0.66f, 0.2f}, {0.62f, 0.38f, 0.78f}, {0.25f, 0.7f, 0.7f},
                                        {0.9f, 0.45f, 0.65f}};
    for (int k = 0; k < 3; ++k)
        out[k] = (unsigned char)(255.0f * light * (part == 0 ? 0.8f : palette[(part - 1) % 7][k]));
}

static void fill(tile* t, const float a[3], const float b[3], const float c[3], const unsigned char rgb[3]) {
    const float area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (fabsf(area) < 1e-12f) return;
    const int x0 = (int)fmaxf(0, fminf(a[0], fminf(b[0], c[0]))), y0 = (int)fmaxf(0, fminf(a[1], fminf(b[1], c[1])));
    const float x1 = fminf(FINE - 1, fmaxf(a[0], fmaxf(b[0], c[0]))),
                y1 = fminf(FINE - 1, fmaxf(a[1], fmaxf(b[1], c[1])));
    for (int y = y0; (float)y <= y1; ++y) {
        for (int x = x0; (float)x <= x1; ++x) {
            const float px = (float)x + 0.5f, py = (float)y + 0.5f;
            const float u = ((px - a[0]) * (c[1] - a[1]) - (py - a[1]) * (c[0] - a[0])) / area;
            const float w = ((b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0])) / area;
            if (u < 0.0f || w < 0.0f || u + w > 1.0f) continue;
            const float z = a[2] + u * (b[2] - a[2]) + w * (c[2] - a[2]);
            const int at = y * FINE + x;
            if (z <= t->depth[at]) continue;
            t->depth[at] = z;
            memcpy(t->rgb[at], rgb, 3);
        }
    }
}

/* Returns the share of light in which a node is drawn, so that neighbours differ. */
static float node_light(const dmg_asset* asset, uint32_t face) {
    if (asset->face_node == NULL) return 1.0f;
    return 1.0f - 0.07f * (float)(asset->face_node[face] * 5 % 8);
}

static void draw_object(tile* t, const dmg_asset* asset, const float* points, const view* v) {
    const dmg_object* object = &asset->object;
    for (int i = 0; i < FINE * FINE; ++i) t->depth[i] = -HUGE_VALF;
    memset(t->rgb, 255, sizeof t->rgb);
    for (uint32_t f = 0; f < object->face_count; ++f) {
        const float* corner[3];
        float at[3][3];
        for (uint32_t k = 0; k < 3; ++k) {
            corner[k] = points + (size_t)object->indices[3 * f + k] * 3;
            project(v, corner[k], at[k]);
        }
        unsigned char rgb[3];
        part_colour(object->face_part[f], node_light(asset, f) * shade(corner[0], corner[1], corner[2]), rgb);
        fill(t, at[0], at[1], at[2], rgb);
    }
}

/* Copies the tile, averaged and in 32 shades a channel, which halves the file, into the sheet at pixel column `left`,
 * row `top`. */
static void paste(const tile* t, unsigned char* sheet, uint32_t width, uint32_t left, uint32_t top) {
    for (uint32_t y = 0; y < SIDE; ++y) {
        for (uint32_t x = 0; x < SIDE; ++x) {
            for (int k = 0; k < 3; ++k) {
                unsigned sum = 0;
                for (uint32_t s = 0; s < SAMPLES * SAMPLES; ++s)
                    sum += t->rgb[(y * SAMPLES + s / SAMPLES) * FINE + x * SAMPLES + s % SAMPLES][k];
                sheet[((size_t)(top + y) * width + left + x) * 3 + (size_t)k] =
                    (unsigned char)(sum / (SAMPLES * SAMPLES) | 7);
            }
        }
    }
}

/* Makes an object, or an asset with its nodes. */
static int make(uint32_t category, uint64_t seed, uint32_t flags, int assets, dmg_asset* out) {
    memset(out, 0, sizeof *out);
    return assets ? dmg_make_asset(category, seed, flags, out) : dmg_make(category, seed, flags, &out->object);
}

/* Draws the object at rest and open, side by side, in one scale. */
static int draw_pair(tile* t, const dmg_asset* asset, unsigned char* sheet, uint32_t width, uint32_t left,
                     uint32_t top) {
    const dmg_object* object = &asset->object;
    float *rest = posed(object, 0), *open = posed(object, 1);
    for (int i = 0; rest && open && i < 2; ++i) {
        const view v = look_at(i ? open : rest, object->vertex_count);
        draw_object(t, asset, i ? open : rest, &v);
        paste(t, sheet, width, left + (uint32_t)i * SIDE, top);
    }
    const int result = rest && open ? 0 : -1;
    free(rest);
    free(open);
    return result;
}

static int write_png(const char* path, const unsigned char* rgb, uint32_t width, uint32_t height) {
    png_image image = {.version = PNG_IMAGE_VERSION, .width = width, .height = height, .format = PNG_FORMAT_RGB};
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    void* bytes = malloc(size);
    int status = -1;
    if (bytes != NULL && png_image_write_to_memory(&image, bytes, &size, 0, rgb, 0, NULL))
        status = output_write(path, bytes, size);
    else
        errno = ENOMEM;
    free(bytes);
    if (status != 0) fprintf(stderr, "dragmesh_generate: can't write %s: %s\n", path, strerror(errno));
    return status;
}

int sheet_write(const char* path, const uint32_t* categories, uint32_t count, uint32_t columns, uint64_t first_seed,
                uint32_t flags, int assets) {
    const uint32_t width = columns * 2 * SIDE, height = count * SIDE;
    unsigned char* sheet = malloc((size_t)width * height * 3);
    tile* t = malloc(sizeof *t);
    int result = sheet && t ? 0 : -1;
    for (uint32_t i = 0; result == 0 && i < count * columns; ++i) {
        dmg_asset asset;
        result = make(categories[i / columns], first_seed + i % columns, flags, assets, &asset);
        if (result == 0) result = draw_pair(t, &asset, sheet, width, i % columns * 2 * SIDE, i / columns * SIDE);
        dmg_asset_release(&asset);
    }
    if (result != 0) fprintf(stderr, "dragmesh_generate: out of memory\n");
    if (result == 0) result = write_png(path, sheet, width, height);
    free(t);
    free(sheet);
    return result;
}
