/* Vertex buffers of the object: smooth normals, colours, places in textures, one range for each part. */
#ifndef VIEWER_SURFACE_H
#define VIEWER_SURFACE_H

#include <epoxy/gl.h>

#include "textures.h"
#include "world.h"

/* Triangles of one part with one texture. */
typedef struct surface_run {
    GLint first;
    GLsizei count;
    GLuint texture;
} surface_run;

typedef struct surface {
    GLuint array, buffer;
    GLint first[WORLD_MAX_PARTS + 2]; /* of every part's range; [0] the body, closed by the end of the last */
    surface_run* runs;
    uint32_t first_run[WORLD_MAX_PARTS + 2]; /* of every part's runs, as `first` */
    dm_vec3 box_min, box_max;
} surface;

/* Where two faces meet at less than 40 degrees they share a normal. */
void surface_make(surface* surface, const world* world, const textures* textures);
void surface_free(surface* surface);

#endif
