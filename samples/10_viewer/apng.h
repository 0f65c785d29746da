/* Animated PNG: pictures of one size, one after the other, looping. */
#ifndef VIEWER_APNG_H
#define VIEWER_APNG_H

#include <stdint.h>

#include "../common/output_file.h"

typedef struct apng {
    output_file file;
    int width, height;
    uint32_t count, written, number; /* frames promised, frames written, sequence number */
    uint8_t* last;                   /* pixels of the last frame */
} apng;

/* `count` frames will follow. Returns 0, or -1 with errno set. */
int apng_open(apng* apng, const char* path, int width, int height, uint32_t count);

/* rgb: rows from top to bottom, three bytes a pixel. */
void apng_frame(apng* apng, const uint8_t* rgb, uint16_t milliseconds);

/* Returns 0, or -1 with errno set when something could not be written or frames are missing. */
int apng_close(apng* apng);

#endif
