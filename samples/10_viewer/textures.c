/* Textures of a file as the graphics card wants them. */
#include "textures.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "image.h"

/* An image and how it is laid out: one texture. */
typedef struct source {
    const void* image;
    int32_t wrap_u, wrap_v;
} source;

/* The card filters in linear light. */
static GLuint make_texture(const uint8_t* pixels, int width, int height, int32_t wrap_u, int32_t wrap_v) {
    GLuint name;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_u);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_v);
    return name;
}

/* Returns the slot of a surface's texture; 0: it has none that can be shown. */
static uint32_t slot_of(textures* textures, source* sources, const dm_gltf_surface* surface) {
    if (surface->image == NULL) return 0;
    for (uint32_t i = 1; i < textures->count; i++)
        if (sources[i].image == surface->image && sources[i].wrap_u == surface->wrap_u &&
            sources[i].wrap_v == surface->wrap_v)
            return textures->names[i] ? i : 0;
    int width, height;
    uint8_t* pixels = image_decode(surface->image, surface->image_size, &width, &height);
    const uint32_t slot = textures->count++;
    sources[slot] = (source){surface->image, surface->wrap_u, surface->wrap_v};
    if (pixels != NULL) textures->names[slot] = make_texture(pixels, width, height, surface->wrap_u, surface->wrap_v);
    free(pixels);
    return textures->names[slot] ? slot : 0;
}

/* Held between too dark and too bright to light well. */
static dm_vec3 lit_colour(const float c[4]) {
    return vec(glm_clamp(c[0], 0.03f, 0.8f), glm_clamp(c[1], 0.03f, 0.8f), glm_clamp(c[2], 0.03f, 0.8f));
}

static void read_surface(textures* textures, source* sources, dm_gltf* gltf, uint32_t index) {
    dm_gltf_surface surface;
    if (dm_gltf_get_surface(gltf, index, &surface) != DM_OK) return;
    float* uv = textures->uv[3 * surface.first_face];
    const bool placed = dm_gltf_get_texture_coordinates(gltf, index, uv, 3 * surface.face_count) == DM_OK;
    const uint32_t slot = placed ? slot_of(textures, sources, &surface) : 0;
    const dm_vec3 colour = lit_colour(surface.colour);
    for (uint64_t face = surface.first_face; face < surface.first_face + surface.face_count; face++) {
        textures->slots[face] = slot;
        textures->colours[face] = colour;
    }
}

void textures_open(textures* textures, const world* world) {
    static const uint8_t white[4] = {255, 255, 255, 255};
    const uint32_t surfaces = dm_gltf_surface_count(world->gltf);
    *textures = (struct textures){.count = 1,
                                  .names = take(surfaces + 1, sizeof *textures->names),
                                  .slots = take(world->face_count, sizeof *textures->slots),
                                  .colours = take(world->face_count, sizeof *textures->colours),
                                  .uv = take(3 * (size_t)world->face_count, sizeof *textures->uv)};
    source* sources = take(surfaces + 1, sizeof *sources);
    textures->names[0] = make_texture(white, 1, 1, GL_REPEAT, GL_REPEAT);
    for (uint32_t i = 0; i < surfaces; i++) read_surface(textures, sources, world->gltf, i);
    free(sources);
}

void textures_close(textures* textures) {
    if (textures->count > 0) glDeleteTextures((GLsizei)textures->count, textures->names);
    free(textures->names);
    free(textures->slots);
    free(textures->colours);
    free(textures->uv);
    memset(textures, 0, sizeof *textures);
}
