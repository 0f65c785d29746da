/* Animated PNG: pictures of one size, one after the other, looping. */
#ifndef VIEWER_APNG_H
#define VIEWER_APNG_H

#include <stdint.h>
#include <stdio.h>

typedef struct apng {
    FILE* file;
    int width, height;
    uint32_t count, written, number; /* frames promised, frames written, sequence number */
    uint8_t* last;                   /* pixels of the last frame */
    int failed;
} apng;

/* `count` frames will follow. 0, or -1 with a line on stderr. */
int apng_open(apng* apng, const char* path, int width, int height, uint32_t count);

/* rgb: rows from top to bottom, three bytes a pixel. */
void apng_frame(apng* apng, const uint8_t* rgb, uint16_t milliseconds);

int apng_close(apng* apng); /* 0, or -1 when something could not be written */

#endif
