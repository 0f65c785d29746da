/* Encodes RGB pictures as .png and writes them. It holds stb's encoder, so one source file of a program includes it. */
#ifndef SAMPLES_PNG_FILE_H
#define SAMPLES_PNG_FILE_H

#include <errno.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#ifndef __clang_analyzer__ /* which does not read that library's code */
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#else
unsigned char* stbi_write_png_to_mem(const unsigned char* pixels, int stride, int x, int y, int n, int* out_len);
#endif
#include <stb/stb_image_write.h>

#include "output_file.h"

/* Returns the bytes of the file, which the caller frees, or NULL without memory. rgb: rows of 3 bytes a pixel. */
static inline void* png_encode(const uint8_t* rgb, int width, int height, size_t* out_size) {
    int size = 0;
    void* bytes = stbi_write_png_to_mem(rgb, 3 * width, width, height, 3, &size);
    *out_size = (size_t)size;
    return bytes;
}

/* Writes the file whole or not at all. Returns 0, or -1 with errno set. */
static inline int png_write(const char* path, const uint8_t* rgb, int width, int height) {
    size_t size;
    void* bytes = png_encode(rgb, width, height, &size);
    if (bytes == NULL) errno = ENOMEM;
    const int status = bytes != NULL ? output_write(path, bytes, size) : -1;
    free(bytes);
    return status;
}

#endif
