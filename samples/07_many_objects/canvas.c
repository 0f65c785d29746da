/* Pixels, lines and words. */
#include "canvas.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../10_viewer/font.h"
#include "../common/png_file.h"

canvas canvas_new(int width, int height) {
    const size_t size = (size_t)width * (size_t)height * 3;
    canvas c = {width, height, malloc(size)};
    if (c.rgb != NULL) memset(c.rgb, 255, size);
    return c;
}

void canvas_free(canvas* c) {
    free(c->rgb);
}

void canvas_blend(canvas* c, int x, int y, const uint8_t rgb[3], float cover) {
    if (x < 0 || y < 0 || x >= c->width || y >= c->height) return;
    uint8_t* at = c->rgb + 3 * ((size_t)y * (size_t)c->width + (size_t)x);
    for (int k = 0; k < 3; k++) at[k] = (uint8_t)((float)at[k] + cover * ((float)rgb[k] - (float)at[k]) + 0.5f);
}

/* How much of the pixel at `p` lies between two edges. */
static float overlap(int p, float low, float high) {
    const float from = fmaxf(low, (float)p), to = fminf(high, (float)p + 1);
    return to > from ? to - from : 0;
}

void canvas_box(canvas* c, float x0, float y0, float x1, float y1, const uint8_t rgb[3]) {
    for (int y = (int)floorf(y0); (float)y < y1; y++)
        for (int x = (int)floorf(x0); (float)x < x1; x++)
            canvas_blend(c, x, y, rgb, overlap(x, x0, x1) * overlap(y, y0, y1));
}

static float distance_to_segment(float x, float y, float x0, float y0, float x1, float y1) {
    const float dx = x1 - x0, dy = y1 - y0, square = dx * dx + dy * dy;
    const float t = square > 0 ? fminf(fmaxf(((x - x0) * dx + (y - y0) * dy) / square, 0), 1) : 0;
    return hypotf(x - x0 - t * dx, y - y0 - t * dy);
}

void canvas_line(canvas* c, float x0, float y0, float x1, float y1, float width, const uint8_t rgb[3]) {
    const float edge = 0.5f * width + 1;
    for (int y = (int)(fminf(y0, y1) - edge); (float)y <= fmaxf(y0, y1) + edge; y++) {
        for (int x = (int)(fminf(x0, x1) - edge); (float)x <= fmaxf(x0, x1) + edge; x++) {
            const float away = distance_to_segment((float)x + 0.5f, (float)y + 0.5f, x0, y0, x1, y1);
            const float cover = fminf(fmaxf(0.5f * width + 0.5f - away, 0), 1);
            if (cover > 0) canvas_blend(c, x, y, rgb, cover);
        }
    }
}

float canvas_text(canvas* c, float x, float y, float size, const char* text, const uint8_t rgb[3]) {
    for (; *text != 0; text++) {
        font_stroke strokes[FONT_STROKES];
        const int count = font_glyph(*text, strokes);
        for (int i = 0; i < count; i++) {
            const font_stroke* s = &strokes[i];
            canvas_line(c, x + size * s->x0, y - size * s->y0, x + size * s->x1, y - size * s->y1, 0.12f * size, rgb);
        }
        x += size * font_advance(*text);
    }
    return x;
}

int canvas_write(const canvas* c, const char* path) {
    if (c->rgb != NULL) return png_write(path, c->rgb, c->width, c->height);
    errno = ENOMEM;
    return -1;
}
