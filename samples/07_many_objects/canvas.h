/* An RGB picture: lines, letters, and its .png. */
#ifndef SAMPLE_CANVAS_H
#define SAMPLE_CANVAS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct canvas {
    int width, height;
    uint8_t* rgb; /* 3 a pixel, rows from the top; NULL: no memory */
} canvas;

canvas canvas_new(int width, int height); /* white */
void canvas_free(canvas* c);
void canvas_blend(canvas* c, int x, int y, const uint8_t rgb[3], float cover);
void canvas_box(canvas* c, float x0, float y0, float x1, float y1, const uint8_t rgb[3]);
void canvas_line(canvas* c, float x0, float y0, float x1, float y1, float width, const uint8_t rgb[3]);
/* Capitals are `size` pixels high; (x, y) is the left end of the base line. Returns where the text ends. */
float canvas_text(canvas* c, float x, float y, float size, const char* text, const uint8_t rgb[3]);
/* Writes a .png. Returns 0, or -1 with errno set. */
int canvas_write(const canvas* c, const char* path);

#endif
