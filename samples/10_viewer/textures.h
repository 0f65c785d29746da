/* Base colour textures of the object's materials, and where its corners lie in them. */
#ifndef VIEWER_TEXTURES_H
#define VIEWER_TEXTURES_H

#include <epoxy/gl.h>

#include "world.h"

typedef struct textures {
    GLuint* names;    /* [0] is white, for what has no texture */
    uint32_t count;   /* of names */
    uint32_t* slots;  /* a face: its texture's position in names */
    dm_vec3* colours; /* a face: its material's colour, linear */
    float (*uv)[2];   /* a corner of the mesh */
} textures;

/* Reads them from the world's file, once. */
void textures_open(textures* textures, const world* world);
void textures_close(textures* textures);

#endif
