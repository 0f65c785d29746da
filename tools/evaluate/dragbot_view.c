/* The scripted player's view: a camera and a z-buffer of part ids, without the library's own picking. */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "dragbot.h"

static const float same_depth = 1e-5f;   /* relative difference of 1 / depth within which two surfaces coincide */
static const double max_view_sine = 0.7; /* of half the field of view; by hand */

#define PIXELS ((size_t)BOT_COLUMNS * BOT_ROWS)

bot_view bot_view_new(void) {
    bot_view view = {.depth = cli_alloc(PIXELS * sizeof(float)), .part = cli_alloc(PIXELS * sizeof(uint32_t))};
    return view;
}

void bot_view_free(bot_view* view) {
    free(view->depth);
    free(view->part);
}

void bot_view_aim(bot_view* view, vec from, vec up, vec centre, double radius, double distance) {
    const double fov = 2 * asin(fmin(radius / distance, max_view_sine));
    bot_view_look(view, add(centre, scale(from, distance)), scale(from, -1), up, fov);
}

void bot_view_look(bot_view* view, vec eye, vec forward, vec up, double fov) {
    view->eye = eye;
    view->forward = forward;
    view->right = unit(cross(view->forward, up));
    view->up = cross(view->right, view->forward);
    view->zoom = 0.5 * BOT_HEIGHT / tan(0.5 * fov);
    view->camera = (dm_camera){.struct_size = sizeof view->camera,
                               .fov_y = (float)fov,
                               .eye = vec_out(view->eye),
                               .forward = vec_out(view->forward),
                               .up = vec_out(view->up),
                               .viewport_width = BOT_WIDTH,
                               .viewport_height = BOT_HEIGHT};
}

bool bot_view_project(const bot_view* view, vec point, double* out_x, double* out_y) {
    const vec offset = sub(point, view->eye);
    const double depth = dot(offset, view->forward);
    if (!(depth > 0)) return false;
    *out_x = 0.5 * BOT_WIDTH + view->zoom * dot(offset, view->right) / depth;
    *out_y = 0.5 * BOT_HEIGHT - view->zoom * dot(offset, view->up) / depth;
    return true;
}

bool bot_view_on_screen(double x, double y) {
    return x >= 0 && y >= 0 && x < BOT_WIDTH && y < BOT_HEIGHT;
}

/* A corner of a triangle in columns and rows of the buffer, with 1 / depth, which is linear there. */
typedef struct corner {
    double x, y, near;
} corner;

static bool make_corner(const bot_view* view, const float* position, corner* out) {
    const vec point = vec_at(position);
    double x, y;
    if (!bot_view_project(view, point, &x, &y)) return false;
    *out = (corner){x / BOT_STEP, y / BOT_STEP, 1 / dot(sub(point, view->eye), view->forward)};
    return true;
}

static double edge(const corner* a, const corner* b, double x, double y) {
    return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

/* Depth test; where two parts share a surface, neither is visible. */
static void depth_test(bot_view* view, size_t at, float near, uint32_t part) {
    const float before = view->depth[at];
    if (part != view->part[at] && fabsf(near - before) <= same_depth * before) view->part[at] = BOT_CONTESTED;
    if (near <= before * (1 + same_depth)) return;
    view->depth[at] = near;
    view->part[at] = part;
}

/* Samples lie at whole columns and rows. */
static void fill(bot_view* view, const corner c[3], uint32_t part) {
    const double area = edge(&c[0], &c[1], c[2].x, c[2].y);
    if (area == 0) return;
    const double low_x = fmin(c[0].x, fmin(c[1].x, c[2].x)), high_x = fmax(c[0].x, fmax(c[1].x, c[2].x));
    const double low_y = fmin(c[0].y, fmin(c[1].y, c[2].y)), high_y = fmax(c[0].y, fmax(c[1].y, c[2].y));
    const int x0 = (int)fmax(0, ceil(low_x)), x1 = (int)fmin(BOT_COLUMNS - 1, floor(high_x));
    const int y0 = (int)fmax(0, ceil(low_y)), y1 = (int)fmin(BOT_ROWS - 1, floor(high_y));
    for (int y = y0; y <= y1; y++) {
        for (int x = x0; x <= x1; x++) {
            const double a = edge(&c[1], &c[2], x, y) / area, b = edge(&c[2], &c[0], x, y) / area, g = 1 - a - b;
            if (a < 0 || b < 0 || g < 0) continue;
            const float near = (float)(a * c[0].near + b * c[1].near + g * c[2].near);
            depth_test(view, (size_t)y * BOT_COLUMNS + (size_t)x, near, part);
        }
    }
}

void bot_view_draw(bot_view* view, const dm_mesh_desc* mesh, const uint8_t* face_parts) {
    const uint32_t* indices = mesh->indices;
    const float* positions = mesh->positions;
    memset(view->depth, 0, PIXELS * sizeof *view->depth);
    memset(view->part, 0, PIXELS * sizeof *view->part);
    for (uint64_t face = 0; face < mesh->index_count / 3; face++) {
        corner corners[3] = {{0, 0, 0}};
        bool seen = true;
        for (int k = 0; k < 3; k++) {
            seen &= make_corner(view, positions + 3 * (size_t)indices[3 * face + (uint64_t)k], &corners[k]);
        }
        if (seen) fill(view, corners, face_parts[face]);
    }
}

vec bot_view_point(const bot_view* view, int column, int row) {
    const double depth = 1 / (double)view->depth[(size_t)row * BOT_COLUMNS + (size_t)column];
    const double x = (column * BOT_STEP - 0.5 * BOT_WIDTH) / view->zoom,
                 y = (0.5 * BOT_HEIGHT - row * BOT_STEP) / view->zoom;
    const vec along = add(view->forward, add(scale(view->right, x), scale(view->up, y)));
    return add(view->eye, scale(along, depth));
}
