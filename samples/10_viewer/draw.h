/* 2D overlay of lines, boxes and text, in pixels; lines in space are projected here. */
#ifndef VIEWER_DRAW_H
#define VIEWER_DRAW_H

#include <epoxy/gl.h>

#include "camera.h"

typedef struct colour {
    float r, g, b, a;
} colour;

typedef struct draw_vertex {
    float x, y, z;        /* pixels, depth 0..1 */
    float u, v;           /* pixels along and across the line */
    float length, radius; /* of the line, pixels */
    float r, g, b, a;
} draw_vertex;

typedef struct draw_list {
    draw_vertex* vertices;
    size_t count, room;
} draw_list;

typedef struct draw {
    const camera* camera;
    draw_list space; /* hidden parts show faintly */
    draw_list flat;  /* on top of everything */
    GLuint program, array, buffer;
} draw;

int draw_open(draw* draw);
void draw_close(draw* draw);
void draw_begin(draw* draw, const camera* camera);

void draw_line(draw* draw, dm_vec3 from, dm_vec3 to, float width, colour colour);
void draw_arrow(draw* draw, dm_vec3 from, dm_vec3 to, float width, colour colour); /* with a head at `to` */
void draw_line_2d(draw* draw, float x0, float y0, float x1, float y1, float width, colour colour);
void draw_disc(draw* draw, float x, float y, float radius, colour colour);
void draw_box(draw* draw, float x, float y, float width, float height, colour colour);

/* Left end of the base line; size = height of a capital. Returns the x where the text ends. */
float draw_text(draw* draw, float x, float y, float size, colour colour, const char* text);
float draw_text_width(float size, const char* text);

/* Draws a label with a dark background beside a point of the scene, unless that is behind the camera. */
void draw_label(draw* draw, dm_vec3 at, float size, colour colour, const char* text);

/* Draws the queued primitives and empties the queue. */
void draw_end(draw* draw);

#endif
