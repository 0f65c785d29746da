/* An RGB picture and its .png. */
#include "picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "png_file.h"

picture picture_new(int width, int height) {
    const size_t size = (size_t)width * (size_t)height * 3;
    picture out = {width, height, cli_alloc(size)};
    memset(out.rgb, 255, size);
    return out;
}

void picture_free(picture* picture) {
    free(picture->rgb);
    picture->rgb = NULL;
}

/* Linear light to an sRGB byte (IEC 61966-2-1). */
static uint8_t encode(double linear) {
    const double c = fmin(fmax(linear, 0), 1);
    const double s = c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - 0.055;
    return (uint8_t)(255 * s + 0.5);
}

void picture_set(picture* picture, int x, int y, vec linear) {
    uint8_t* out = picture->rgb + 3 * ((size_t)y * (size_t)picture->width + (size_t)x);
    out[0] = encode(linear.x);
    out[1] = encode(linear.y);
    out[2] = encode(linear.z);
}

static double distance_to_segment(double x, double y, double x0, double y0, double x1, double y1) {
    const double dx = x1 - x0, dy = y1 - y0, square = dx * dx + dy * dy;
    const double t = square > 0 ? fmin(fmax(((x - x0) * dx + (y - y0) * dy) / square, 0), 1) : 0;
    return hypot(x - x0 - t * dx, y - y0 - t * dy);
}

void picture_line(picture* picture, double x0, double y0, double x1, double y1, double width, const uint8_t rgb[3],
                  int left, int right) {
    for (int y = 0; y < picture->height; y++) {
        for (int x = left; x < right; x++) {
            const double away = distance_to_segment(x + 0.5, y + 0.5, x0, y0, x1, y1);
            const double cover = fmin(fmax(width / 2 + 0.5 - away, 0), 1);
            uint8_t* out = picture->rgb + 3 * ((size_t)y * (size_t)picture->width + (size_t)x);
            for (int k = 0; k < 3 && cover > 0; k++) out[k] = (uint8_t)(out[k] + cover * (rgb[k] - out[k]));
        }
    }
}

void* picture_encode(const picture* picture, size_t* out_size) {
    return png_encode(picture->rgb, picture->width, picture->height, out_size);
}

int picture_write(const picture* picture, const char* path) {
    return png_write(path, picture->rgb, picture->width, picture->height);
}
