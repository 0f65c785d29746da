/* Vertex buffers of the object: smooth normals, colours, one range for each part. */
#ifndef VIEWER_SURFACE_H
#define VIEWER_SURFACE_H

#include <epoxy/gl.h>

#include "world.h"

typedef struct surface {
    GLuint array, buffer;
    GLint first[WORLD_MAX_PARTS + 2]; /* of every part's range; [0] the body, closed by the end of the last */
    vec3 box_min, box_max;
} surface;

/* Where two faces meet at less than 40 degrees they share a normal. */
void surface_make(surface* surface, const world* world);
void surface_free(surface* surface);

#endif
