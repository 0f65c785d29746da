/* An RGB picture and its .png. */
#ifndef CLI_PICTURE_H
#define CLI_PICTURE_H

#include <stddef.h>
#include <stdint.h>

#include "vec.h"

typedef struct picture {
    int width, height;
    uint8_t* rgb; /* 3 a pixel, rows from the top */
} picture;

picture picture_new(int width, int height);
void picture_free(picture* picture);
/* A linear colour, tone-mapped. */
void picture_set(picture* picture, int x, int y, vec linear);
/* A line of `width` pixels, anti-aliased, over what is there; clipped to the columns [left, right). */
void picture_line(picture* picture, double x0, double y0, double x1, double y1, double width, const uint8_t rgb[3],
                  int left, int right);
/* Returns the bytes of a .png, to be freed; NULL when there is no memory. */
void* picture_encode(const picture* picture, size_t* out_size);
/* Writes a .png. Returns 0, or -1 with errno set. */
int picture_write(const picture* picture, const char* path);

#endif
