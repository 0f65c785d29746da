/* The viewer's mind: what the pointer and the keys do to the world. What keys do: keys.c. */
#include "app.h"

#include <string.h>

#include "keys.h"
#include "parts.h"

/* Pixels the pointer goes before the pull says enough to imagine the whole motion. */
static const float imagine_pixels = 20; /* pull after which the motion is previewed; by hand */

void app_open(app* app, world* world, int width, int height, int z_up) {
    memset(app, 0, sizeof *app);
    app->world = world;
    app->show = SHOW_AXIS | SHOW_PANEL | SHOW_LABEL;
    app->brush = 0.03f;
    app->camera.width = width;
    app->camera.height = height;
    app->camera.z_up = z_up;
    keys_frame(app);
}

static dm_ray pointer_ray(const app* app) {
    const dm_camera camera = camera_for_picking(&app->camera);
    dm_ray ray = {{0, 0, 0}, {0, 0, 1}};
    dm_camera_ray(app->world->context, &camera, app->x, app->y, &ray);
    return ray;
}

static void look_under_pointer(app* app) {
    const dm_ray ray = pointer_ray(app);
    app->under = world_pick(app->world, &ray);
    app->hovered = app->under.part_id;
}

static void paint(app* app) {
    if (app->under.distance <= 0) return;
    const float radius = app->brush * app->world->size;
    if (parts_paint(app->world, app->under.object_point, radius, app->shift ? 0 : app->selected)) app->repaint = 1;
}

static void press(app* app, int button) {
    app->button = button;
    app->press_x = app->x;
    app->press_y = app->y;
    app->playing = 0;
    look_under_pointer(app);
    if (button != BUTTON_LEFT) return;
    if (app->painting) {
        paint(app);
    } else if (app->under.distance > 0 && world_grab(app->world, &app->under) == 0) {
        app->selected = app->world->held;
    }
}

static void release(app* app) {
    app->button = 0;
    if (app->world->held) world_release(app->world);
}

/* The pointer moves with a button down: part, brush or camera follow. */
static void drag_pointer(app* app, float dx, float dy) {
    if (app->button == BUTTON_MIDDLE || (app->button == BUTTON_RIGHT && app->shift))
        camera_pan(&app->camera, dx, dy);
    else if (app->button == BUTTON_RIGHT || (app->button == BUTTON_LEFT && !app->world->held && !app->painting))
        camera_orbit(&app->camera, dx, dy);
    else if (app->button == BUTTON_LEFT && app->painting) {
        look_under_pointer(app);
        paint(app);
    }
}

void app_event(app* app, const event* event) {
    const float* n = event->numbers;
    app->shift = event->shift || (event->kind == EVENT_MOVE && app->shift);
    switch (event->kind) {
    case EVENT_CAMERA:
        app->camera.yaw = n[0], app->camera.pitch = n[1], app->camera.distance = n[2];
        app->camera.target = vec_from(n + 3);
        break;
    case EVENT_MOVE: {
        const float dx = n[0] - app->x, dy = n[1] - app->y;
        app->x = n[0], app->y = n[1];
        drag_pointer(app, dx, dy);
        break;
    }
    case EVENT_PRESS:
        press(app, event->button);
        break;
    case EVENT_RELEASE:
        release(app);
        break;
    case EVENT_WHEEL:
        camera_zoom(&app->camera, n[0]);
        break;
    case EVENT_KEY:
        keys_press(app, event->key);
        break;
    default:
        break;
    }
}

/* There and back along the whole range, two seconds each way. */
static void play(app* app) {
    const dm_joint* joint = &app->world->parts[app->selected].state.joint;
    const float whole = joint->type == DM_JOINT_CONTINUOUS ? 2 * GLM_PIf : 0;
    const float lower = whole > 0 ? 0 : joint->lower, upper = whole > 0 ? whole : joint->upper;
    const float t = 0.5f - 0.5f * cosf(app->playing * GLM_PIf / 2);
    const float start = fabsf(lower) < fabsf(upper) ? lower : upper, end = start == lower ? upper : lower;
    app->playing += frame_seconds;
    world_set_value(app->world, app->selected, start + t * (end - start));
}

void app_tick(app* app) {
    world* world = app->world;
    const dm_ray ray = pointer_ray(app);
    if (!world->held && app->playing > 0 && app->selected) play(app);
    world_step(world, &ray, frame_seconds);
    const float moved = hypotf(app->x - app->press_x, app->y - app->press_y);
    if (world->held && moved >= imagine_pixels && !world->parts[world->held].has_keys) world_imagine(world, &ray);
    if (!app->button) look_under_pointer(app);
}
