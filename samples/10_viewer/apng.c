/* Animated PNG (https://wiki.mozilla.org/APNG_Specification). After the first frame only the rectangle that changed is
 * written, with the pixels in it that stayed left transparent: they pack to nearly nothing. */
#include "apng.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <zlib.h>

#include "files.h"

typedef struct box {
    int left, top, right, bottom;
} box;

static void put32(uint8_t* out, uint32_t value) {
    for (int i = 0; i < 4; i++) out[i] = (uint8_t)(value >> (24 - 8 * i));
}

/* `head` (may be empty) and `body` together are the chunk's data. */
static void write_chunk(apng* apng, const char* name, const uint8_t* head, size_t head_size, const uint8_t* body,
                        size_t body_size) {
    uint8_t size[4], check[4];
    uLong crc = crc32(0, (const Bytef*)name, 4);
    if (head_size) crc = crc32(crc, head, (uInt)head_size);
    if (body_size) crc = crc32(crc, body, (uInt)body_size);
    put32(size, (uint32_t)(head_size + body_size));
    put32(check, (uint32_t)crc);
    output_put(&apng->file, size, 4);
    output_put(&apng->file, name, 4);
    output_put(&apng->file, head, head_size);
    output_put(&apng->file, body, body_size);
    output_put(&apng->file, check, 4);
}

int apng_open(apng* apng, const char* path, int width, int height, uint32_t count) {
    memset(apng, 0, sizeof *apng);
    apng->width = width;
    apng->height = height;
    apng->count = count;
    if (output_open(&apng->file, path) != 0) return -1;
    apng->last = take((size_t)width * (size_t)height, 3);
    uint8_t header[13] = {[8] = 8, [9] = 6}; /* 8 bits, RGBA */
    uint8_t control[8] = {0};                /* frames, 0 = loops for ever */
    put32(header, (uint32_t)width);
    put32(header + 4, (uint32_t)height);
    put32(control, count);
    output_put(&apng->file, "\x89PNG\r\n\x1a\n", 8);
    write_chunk(apng, "IHDR", header, sizeof header, NULL, 0);
    write_chunk(apng, "acTL", control, sizeof control, NULL, 0);
    return 0;
}

/* What differs; one pixel when nothing does. */
static box changed_box(const apng* apng, const uint8_t* rgb) {
    box b = {apng->width, apng->height, 0, 0};
    for (int y = 0; y < apng->height; y++) {
        for (int x = 0; x < apng->width; x++) {
            const size_t at = 3 * ((size_t)y * (size_t)apng->width + (size_t)x);
            if (memcmp(rgb + at, apng->last + at, 3) == 0) continue;
            b.left = x < b.left ? x : b.left;
            b.right = x + 1 > b.right ? x + 1 : b.right;
            b.top = y < b.top ? y : b.top;
            b.bottom = y + 1;
        }
    }
    return b.right > 0 ? b : (box){0, 0, 1, 1};
}

static void copy_row(const apng* apng, const uint8_t* rgb, box b, int y, uint8_t* rgba) {
    for (int x = b.left; x < b.right; x++, rgba += 4) {
        const size_t at = 3 * ((size_t)y * (size_t)apng->width + (size_t)x);
        const bool same = apng->written > 0 && memcmp(rgb + at, apng->last + at, 3) == 0;
        memset(rgba, 0, 4);
        if (same) continue;
        memcpy(rgba, rgb + at, 3);
        rgba[3] = 255;
    }
}

/* PNG's filters none, sub and up; the one with the least sum of differences is kept. */
static void filter_row(const uint8_t* row, const uint8_t* above, size_t size, uint8_t* out) {
    unsigned long best = ~0ul;
    for (int kind = 0; kind < 3; kind++) {
        unsigned long sum = 0;
        for (size_t i = 0; i < size; i++) {
            const uint8_t d = (uint8_t)(row[i] - (kind == 1 && i >= 4 ? row[i - 4] : kind == 2 ? above[i] : 0));
            sum += d < 128 ? d : 256u - d;
        }
        if (sum >= best) continue;
        best = sum;
        out[0] = (uint8_t)kind;
    }
    for (size_t i = 0; i < size; i++)
        out[1 + i] = (uint8_t)(row[i] - (out[0] == 1 && i >= 4 ? row[i - 4] : out[0] == 2 ? above[i] : 0));
}

/* The box's rows, filtered and deflated; to be freed. */
static uint8_t* pack(const apng* apng, const uint8_t* rgb, box b, uLongf* out_size) {
    const size_t stride = 4 * (size_t)(b.right - b.left), rows = (size_t)(b.bottom - b.top);
    uint8_t *raw = take(rows, stride + 1), *above = take(stride, 1), *row = take(stride, 1);
    for (size_t y = 0; y < rows; y++) {
        copy_row(apng, rgb, b, b.top + (int)y, row);
        filter_row(row, above, stride, raw + y * (stride + 1));
        memcpy(above, row, stride);
    }
    *out_size = compressBound(rows * (stride + 1));
    uint8_t* packed = take(*out_size, 1);
    if (compress2(packed, out_size, raw, rows * (stride + 1), 9) != Z_OK) *out_size = 0;
    free(raw);
    free(above);
    free(row);
    return packed;
}

static void write_control(apng* apng, box b, uint16_t milliseconds) {
    uint8_t control[26] = {0};
    put32(control, apng->number++);
    put32(control + 4, (uint32_t)(b.right - b.left));
    put32(control + 8, (uint32_t)(b.bottom - b.top));
    put32(control + 12, (uint32_t)b.left);
    put32(control + 16, (uint32_t)b.top);
    control[20] = (uint8_t)(milliseconds >> 8), control[21] = (uint8_t)milliseconds;
    control[22] = 1000 >> 8, control[23] = 1000 & 255;
    control[25] = apng->written > 0; /* laid over the frame before */
    write_chunk(apng, "fcTL", control, sizeof control, NULL, 0);
}

void apng_frame(apng* apng, const uint8_t* rgb, uint16_t milliseconds) {
    const box b = apng->written ? changed_box(apng, rgb) : (box){0, 0, apng->width, apng->height};
    uLongf size = 0;
    uint8_t *packed = pack(apng, rgb, b, &size), number[4];
    write_control(apng, b, milliseconds);
    put32(number, apng->number);
    if (apng->written) apng->number++;
    write_chunk(apng, apng->written ? "fdAT" : "IDAT", number, apng->written ? 4 : 0, packed, size);
    memcpy(apng->last, rgb, 3 * (size_t)apng->width * (size_t)apng->height);
    apng->written++;
    free(packed);
}

int apng_close(apng* apng) {
    write_chunk(apng, "IEND", NULL, 0, NULL, 0);
    free(apng->last);
    if (apng->written == apng->count) return output_close(&apng->file);
    output_discard(&apng->file);
    errno = ECANCELED;
    return -1;
}
