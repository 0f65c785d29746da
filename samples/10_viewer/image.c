/* PNG by libpng, JPEG by libjpeg. */
#include "image.h"

#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <png.h>

#if !defined(VIEWER_NO_JPEG)
#include <jpeglib.h>
#endif

enum { MOST_PIXELS = 1 << 26 }; /* by hand: 8192 x 8192, the largest that graphics cards are sure to take */

static uint8_t* room_for(size_t width, size_t height) {
    if (width > 0 && height > 0 && width <= MOST_PIXELS / height) return malloc(4 * width * height);
    fprintf(stderr, "viewer: an image of %zu x %zu pixels is left out\n", width, height);
    return NULL;
}

static uint8_t* decode_png(const void* data, size_t size, int* out_width, int* out_height) {
    png_image image = {.version = PNG_IMAGE_VERSION};
    uint8_t* pixels = NULL;
    if (png_image_begin_read_from_memory(&image, data, size)) {
        image.format = PNG_FORMAT_RGBA;
        pixels = room_for(image.width, image.height);
        *out_width = (int)image.width;
        *out_height = (int)image.height;
    }
    if (pixels != NULL && png_image_finish_read(&image, NULL, pixels, 0, NULL)) return pixels;
    if (image.message[0]) fprintf(stderr, "viewer: an image is left out: %s\n", image.message);
    png_image_free(&image);
    free(pixels);
    return NULL;
}

#if defined(VIEWER_NO_JPEG)
static uint8_t* decode_jpeg(const void* data, size_t size, int* out_width, int* out_height) {
    (void)data, (void)size, (void)out_width, (void)out_height;
    fprintf(stderr, "viewer: an image is left out: this build has no libjpeg\n");
    return NULL;
}
#else
/* libjpeg reports errors by a function that must not return. */
typedef struct jpeg_reader {
    struct jpeg_error_mgr errors; /* first, so that it can be found from the decoder */
    jmp_buf failed;
    struct jpeg_decompress_struct decoder;
    uint8_t* pixels;
} jpeg_reader;

static void fail_jpeg(j_common_ptr decoder) {
    char text[JMSG_LENGTH_MAX];
    decoder->err->format_message(decoder, text);
    fprintf(stderr, "viewer: an image is left out: %s\n", text);
    longjmp(((jpeg_reader*)(void*)decoder->err)->failed, 1);
}

static void pass_over(j_common_ptr decoder, int level) {
    (void)decoder, (void)level; /* warnings: what can be read is shown */
}

/* Reads rows of RGB and spreads them to RGBA, from the last pixel on. */
static void read_rows(jpeg_reader* r) {
    struct jpeg_decompress_struct* d = &r->decoder;
    while (d->output_scanline < d->output_height) {
        uint8_t* row = r->pixels + 4 * (size_t)d->output_width * d->output_scanline;
        jpeg_read_scanlines(d, &row, 1);
        for (size_t x = d->output_width; x-- > 0;) {
            const uint8_t rgb[3] = {row[3 * x], row[3 * x + 1], row[3 * x + 2]};
            memcpy(row + 4 * x, rgb, 3);
            row[4 * x + 3] = 255;
        }
    }
}

static uint8_t* decode_jpeg(const void* data, size_t size, int* out_width, int* out_height) {
    jpeg_reader* r = calloc(1, sizeof *r);
    if (r == NULL) return NULL;
    r->decoder.err = jpeg_std_error(&r->errors);
    r->errors.error_exit = fail_jpeg;
    r->errors.emit_message = pass_over;
    if (setjmp(r->failed) == 0) {
        jpeg_create_decompress(&r->decoder);
        jpeg_mem_src(&r->decoder, data, (unsigned long)size);
        jpeg_read_header(&r->decoder, TRUE);
        r->decoder.out_color_space = JCS_RGB;
        jpeg_start_decompress(&r->decoder);
        *out_width = (int)r->decoder.output_width;
        *out_height = (int)r->decoder.output_height;
        r->pixels = room_for(r->decoder.output_width, r->decoder.output_height);
        if (r->pixels != NULL) read_rows(r);
    } else {
        free(r->pixels);
        r->pixels = NULL;
    }
    jpeg_destroy_decompress(&r->decoder);
    uint8_t* pixels = r->pixels;
    free(r);
    return pixels;
}
#endif

uint8_t* image_decode(const void* data, size_t size, int* out_width, int* out_height) {
    if (size > 8 && memcmp(data, "\x89PNG", 4) == 0) return decode_png(data, size, out_width, out_height);
    if (size > 3 && memcmp(data, "\xFF\xD8\xFF", 3) == 0) return decode_jpeg(data, size, out_width, out_height);
    fprintf(stderr, "viewer: an image is left out: it is neither PNG nor JPEG\n");
    return NULL;
}
