/* The lit picture of an object: one sun with shadows, a sky, a floor. */
#ifndef VIEWER_RENDER_H
#define VIEWER_RENDER_H

#include "camera.h"
#include "surface.h"

/* Appearance of a part. */
typedef struct look {
    dm_pose pose;
    float tint[4]; /* colour, and how much of it */
    float glow;    /* of its outline */
} look;

typedef struct render {
    GLuint solid, ghost, sky, floor; /* programs */
    GLuint shadow, shadow_frame, shadow_map;
    GLuint nothing; /* vertex array of shaders that make their own vertices */
    mat4 light;
} render;

int render_open(render* render); /* 0, or -1 with a line on stderr */
void render_close(render* render);

/* Draws sky, floor and every part, the body first. */
void render_scene(render* render, const surface* surface, const camera* camera, const look* looks, uint32_t parts);

/* Draws a part again, transparent. */
void render_ghost(render* render, const surface* surface, const camera* camera, uint32_t part, const look* look);

#endif
