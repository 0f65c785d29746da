/* The frame buffer: multisampled, resolved to the window or to a .png. */
#ifndef VIEWER_CANVAS_H
#define VIEWER_CANVAS_H

#include <stdint.h>

#include <epoxy/gl.h>

typedef struct canvas {
    int width, height;
    GLuint frame, colour, depth;            /* multisampled */
    GLuint resolved_frame, resolved_colour; /* one sample a pixel, for reading back */
} canvas;

int canvas_open(canvas* canvas, int width, int height); /* 0, or -1 with a line on stderr */
void canvas_close(canvas* canvas);
void canvas_begin(const canvas* canvas);
void canvas_to_window(const canvas* canvas);
/* RGB rows from top to bottom, to be freed. */
uint8_t* canvas_pixels(const canvas* canvas);
/* Writes the picture. Returns 0, or -1 with errno set. */
int canvas_to_png(const canvas* canvas, const char* path);

#endif
