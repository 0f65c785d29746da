/* The viewer's controller: applies pointer and key events to the world. No window, no graphics. */
#ifndef VIEWER_APP_H
#define VIEWER_APP_H

#include "camera.h"
#include "session.h"
#include "world.h"

static const float frame_seconds = 1.0f / 60; /* of every frame, live or replayed */

enum {
    SHOW_AXIS = 1,
    SHOW_HYPOTHESES = 2,
    SHOW_GHOSTS = 4,
    SHOW_PANEL = 8,
    SHOW_HELP = 16,
    SHOW_CLAY = 32,
    SHOW_LABEL = 64
};

typedef struct app {
    world* world;
    camera camera;
    const char* save_path;
    uint32_t show; /* SHOW_* */
    uint32_t selected, hovered;
    float x, y; /* pointer */
    float press_x, press_y;
    int button; /* held down; 0 = none */
    int shift;
    int painting;
    float brush;    /* radius, share of the object's size */
    dm_hit under;   /* what the pointer meets */
    float playing;  /* 0: not; else seconds since the preview began */
    int repaint;    /* the parts of the surface changed */
    int hide_times; /* pictures that are compared show no timings */
    int quit;
} app;

void app_open(app* app, world* world, int width, int height, int z_up);
void app_event(app* app, const event* event);

/* One frame: a sixtieth of a second. */
void app_tick(app* app);

#endif
