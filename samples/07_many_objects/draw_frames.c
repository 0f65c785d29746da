/* Frame times as bars, the budget as a line; below, the props that are there and those that are still to come. */
#include <math.h>
#include <stdio.h>

#include "draw.h"

enum { WIDTH = 960, HEIGHT = 480, LEFT = 70, RIGHT = 940, TOP = 50, MIDDLE = 300, LOWER = 340, BOTTOM = 430 };

static const uint8_t ink[3] = {40, 44, 52}, faint[3] = {205, 210, 216}, streaming[3] = {52, 120, 190},
                     rest[3] = {160, 172, 186}, limit[3] = {200, 60, 50}, here[3] = {60, 150, 105},
                     to_come[3] = {225, 140, 50};

static float x_of(uint32_t frame, uint32_t count) {
    return (float)LEFT + (float)(RIGHT - LEFT) * (float)frame / (float)count;
}

/* Returns the least of 1, 2, 5, 10, 20 … by powers of ten of which four reach `most`. */
static float step_of(float most) {
    const float power = powf(10, floorf(log10f(most / 4)));
    for (int i = 0; i < 3; i++) {
        static const float factors[3] = {1, 2, 5};
        if (4 * factors[i] * power >= most) return factors[i] * power;
    }
    return 10 * power;
}

/* Four steps of a scale between two heights, with their numbers. Returns how many pixels one is high. */
static float draw_scale(canvas* c, int top, int bottom, float most) {
    const float step = step_of(most), height = (float)(bottom - top) / 4;
    for (int i = 0; i <= 4; i++) {
        const float y = (float)bottom - height * (float)i;
        char text[32];
        snprintf(text, sizeof text, "%g", (double)((float)i * step));
        canvas_line(c, LEFT, y, RIGHT, y, 1, faint);
        canvas_text(c, LEFT - 45, y + 4, 9, text, ink);
    }
    return height / step;
}

static void draw_times(canvas* c, const frame_note* notes, uint32_t count, float budget) {
    float most = 1.1f * budget;
    for (uint32_t i = 0; i < count; i++) most = fmaxf(most, notes[i].stream_ms + notes[i].rest_ms);
    const float a_ms = draw_scale(c, TOP, MIDDLE, most);
    for (uint32_t i = 0; i < count; i++) {
        const float x0 = x_of(i, count), x1 = x_of(i + 1, count);
        const float top = MIDDLE - a_ms * notes[i].rest_ms;
        canvas_box(c, x0, top, x1, MIDDLE, rest);
        canvas_box(c, x0, top - a_ms * notes[i].stream_ms, x1, top, streaming);
    }
    canvas_line(c, LEFT, MIDDLE - a_ms * budget, RIGHT, MIDDLE - a_ms * budget, 1.5f, limit);
}

static void draw_props(canvas* c, const frame_note* notes, uint32_t count) {
    float most = 1;
    for (uint32_t i = 0; i < count; i++) most = fmaxf(most, (float)(notes[i].placed + notes[i].missing));
    const float each = draw_scale(c, LOWER, BOTTOM, most);
    for (uint32_t i = 0; i < count; i++) {
        const float x0 = x_of(i, count), x1 = x_of(i + 1, count), top = BOTTOM - each * (float)notes[i].placed;
        canvas_box(c, x0, top, x1, BOTTOM, here);
        canvas_box(c, x0, top - each * (float)notes[i].missing, x1, top, to_come);
    }
}

static float draw_key(canvas* c, float x, float y, const uint8_t rgb[3], const char* text) {
    canvas_box(c, x, y - 10, x + 10, y, rgb);
    return canvas_text(c, x + 16, y, 11, text, ink) + 24;
}

canvas draw_frames(const frame_note* notes, uint32_t count, float budget) {
    canvas c = canvas_new(WIDTH, HEIGHT);
    char text[64];
    if (c.rgb == NULL || count == 0) return c;
    draw_times(&c, notes, count, budget);
    draw_props(&c, notes, count);
    float x = draw_key(&c, LEFT, 30, streaming, "streaming");
    x = draw_key(&c, x, 30, rest, "drags, commit, picks");
    snprintf(text, sizeof text, "budget of %g ms", (double)budget);
    draw_key(&c, x, 30, limit, text);
    canvas_text(&c, RIGHT - 110, 30, 11, "ms a frame", ink);
    x = draw_key(&c, LEFT, 328, here, "props in the scene");
    draw_key(&c, x, 328, to_come, "within reach, still to come");
    canvas_text(&c, LEFT, 455, 11, "frame 0", ink);
    snprintf(text, sizeof text, "%u", (unsigned)count);
    canvas_text(&c, RIGHT - 40, 455, 11, text, ink);
    return c;
}
