/* Implements handles and knobs. */
#include "parts/hardware.h"

static dmg_handle handle_of(dmg_builder* b, dmg_handle_kind kind, float hand) {
    dmg_handle handle = {.kind = kind};
    handle.length = hand * dmg_scale_range(b, 0.5f, 2.2f);
    handle.thickness = hand * dmg_scale_range(b, 0.05f, 0.14f);
    handle.standoff = hand * dmg_scale_range(b, 0.12f, 0.4f);
    handle.post = dmg_range(b, 0.65f, 0.97f);
    return handle;
}

dmg_handle dmg_handle_pick(dmg_builder* b, float hand) {
    static const float weights[DMG_HANDLE_KINDS] = {1.2f, 2, 1.5f, 1.2f, 2, 0.8f, 0.7f, 0.7f, 0.6f, 0.4f, 0.7f};
    return handle_of(b, (dmg_handle_kind)dmg_weighted(b, weights, DMG_HANDLE_KINDS), hand);
}

dmg_handle dmg_handle_pick_bar(dmg_builder* b, float hand) {
    static const float weights[DMG_HANDLE_KINDS] = {0.6f, 3, 3, 2, 0.2f, 0, 0.4f, 0.2f, 0.6f, 0, 1};
    return handle_of(b, (dmg_handle_kind)dmg_weighted(b, weights, DMG_HANDLE_KINDS), hand);
}

static void draw_bar(dmg_builder* b, const dmg_handle* handle, float length) {
    float half = 0.5f * length, radius = 0.5f * handle->thickness, out = handle->standoff, post = half * handle->post;
    if (handle->kind == DMG_HANDLE_FLAT) {
        dmg_box(b, v3(0, 0, out), v3(2 * radius, length, radius));
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3(-radius, (float)s * post - radius, 0), v3(radius, (float)s * post + radius, out));
        return;
    }
    dmg_rod(b, v3(0, -half, out), v3(0, half, out), radius);
    for (int s = -1; s <= 1; s += 2) dmg_rod(b, v3(0, (float)s * post, 0), v3(0, (float)s * post, out), 0.7f * radius);
}

static void draw_arch(dmg_builder* b, const dmg_handle* handle, float length) {
    enum { POINTS = 9 };
    dmg_vec path[POINTS];
    /* Between a half ellipse and a rectangle with round corners. */
    float power = 0.3f + 0.7f * handle->post;
    for (int i = 0; i < POINTS; ++i) {
        float angle = DMG_PI * (float)i / (POINTS - 1), c = cosf(angle), s = sinf(angle);
        path[i] = v3(0, -0.5f * length * copysignf(powf(fabsf(c), power), c), handle->standoff * powf(fabsf(s), power));
    }
    dmg_sweep(b, path, POINTS, 0.5f * handle->thickness, 0.35f * handle->thickness + 0.25f * handle->thickness * power,
              false);
}

/* Draws a quarter of a shell, open below: fingers reach in from there. Its long side lies along Y, so "below" is -X. */
static void draw_cup(dmg_builder* b, const dmg_handle* handle, float length) {
    enum { COLUMNS = 9, ROWS = 4 };
    uint32_t previous = 0;
    dmg_piece_begin(b);
    for (int row = 0; row < ROWS; ++row) {
        float rise = 0.5f * DMG_PI * (float)row / (ROWS - 1);
        uint32_t first = b->vertex_count;
        for (int i = 0; i < COLUMNS; ++i) {
            float angle = DMG_PI * (float)i / (COLUMNS - 1);
            dmg_vertex(b, v3(handle->standoff * sinf(angle) * cosf(rise), -0.5f * length * cosf(angle),
                             handle->standoff * sinf(rise) * sinf(angle)));
        }
        for (uint32_t i = 0; row > 0 && i + 1 < COLUMNS; ++i)
            dmg_quad(b, previous + i, previous + i + 1, first + i + 1, first + i);
        previous = first;
    }
}

static void draw_ring(dmg_builder* b, const dmg_handle* handle) {
    float radius = 2.2f * handle->thickness, tube = 0.3f * handle->thickness;
    dmg_box(b, v3(0, 0, 0.2f * tube), v3(1.2f * radius, 1.2f * radius, tube));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 3 * tube), 1.5f * tube);
    dmg_torus(b, v3(-radius, 0, 2.2f * tube), v3(0, 0, 1), radius, tube);
}

void dmg_handle_draw(dmg_builder* b, const dmg_handle* handle, float room) {
    float length = fminf(handle->length, 0.9f * room), t = handle->thickness;
    switch (handle->kind) {
    case DMG_HANDLE_BAR:
    case DMG_HANDLE_FLAT:
        draw_bar(b, handle, length);
        break;
    case DMG_HANDLE_ARCH:
        draw_arch(b, handle, length);
        break;
    case DMG_HANDLE_KNOB: {
        const dmg_xy profile[] = {{0.6f * t, 0},
                                  {0.45f * t, 0.5f * handle->standoff},
                                  {1.2f * t, 0.7f * handle->standoff},
                                  {1.1f * t, handle->standoff},
                                  {0, 1.05f * handle->standoff}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), profile, 5);
        break;
    }
    case DMG_HANDLE_BALL:
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, handle->standoff), 0.5f * t);
        dmg_ellipsoid(b, v3(0, 0, handle->standoff), v3(1.3f * t, 1.3f * t, t));
        break;
    case DMG_HANDLE_BLOCK:
        dmg_box(b, v3(0, 0, 0.5f * t), v3(1.5f * t, 0.6f * length, t));
        break;
    case DMG_HANDLE_CUP:
        draw_cup(b, handle, 0.8f * length);
        break;
    case DMG_HANDLE_RECESSED:
        dmg_box(b, v3(0, 0, -0.2f * t), v3(2.2f * t, 0.7f * length, 0.5f * t));
        dmg_frame_draw(b, 2.6f * t, 0.75f * length, 0.25f * t, 0.2f * t);
        break;
    case DMG_HANDLE_RING:
        draw_ring(b, handle);
        break;
    case DMG_HANDLE_LIP:
        dmg_box(b, v3(0.3f * t, 0, 0.5f * t), v3(0.5f * t, 0.98f * room, t));
        break;
    case DMG_HANDLE_NONE:
    case DMG_HANDLE_KINDS:
        break;
    }
}

static void draw_lobes(dmg_builder* b, float radius, float height) {
    enum { LOBES = 6, POINTS = 24 };
    dmg_xy polygon[POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / POINTS, r = radius * (0.88f + 0.12f * cosf(LOBES * angle));
        polygon[i] = (dmg_xy){r * cosf(angle), r * sinf(angle)};
    }
    dmg_extrude(b, polygon, POINTS, 0, height);
}

void dmg_knob_draw(dmg_builder* b, int kind, float radius, float height) {
    const dmg_vec z = {0, 0, 1};
    dmg_vec end = v3(0, 0, height);
    switch (kind) {
    case 0:
        dmg_cone(b, v3(0, 0, 0), end, radius, 0.85f * radius);
        break;
    case 1: /* with a pointer */
        dmg_cone(b, v3(0, 0, 0), end, radius, 0.9f * radius);
        dmg_box(b, v3(0, 0.5f * radius, height), v3(0.15f * radius, 0.9f * radius, 0.1f * height));
        break;
    case 2: /* a wing on a disc */
        dmg_cone(b, v3(0, 0, 0), v3(0, 0, 0.4f * height), radius, radius);
        dmg_box(b, v3(0, 0, 0.7f * height), v3(0.35f * radius, 1.9f * radius, 0.6f * height));
        break;
    case 3: { /* mushroom */
        const dmg_xy profile[] = {{0.5f * radius, 0},      {0.45f * radius, 0.5f * height},
                                  {radius, 0.6f * height}, {0.95f * radius, 0.85f * height},
                                  {0.5f * radius, height}, {0, height}};
        dmg_lathe(b, v3(0, 0, 0), z, profile, 6);
        break;
    }
    case 4:
        draw_lobes(b, radius, height);
        break;
    case 5: { /* skirt and cap */
        const dmg_xy profile[] = {{radius, 0},
                                  {radius, 0.25f * height},
                                  {0.65f * radius, 0.3f * height},
                                  {0.6f * radius, height},
                                  {0, height}};
        dmg_lathe(b, v3(0, 0, 0), z, profile, 5);
        break;
    }
    default: /* a bar on a stem */
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.6f * height), 0.4f * radius);
        dmg_rounded_box(b, v3(0, 0, 0.75f * height), v3(0.5f * radius, 2 * radius, 0.5f * height), 0.1f * radius);
        break;
    }
}

void dmg_any_knob_draw(dmg_builder* b, float radius, float flattest, float tallest) {
    const float height = radius * dmg_range(b, flattest, tallest);
    dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), radius, height);
}
