/* Pictures of files, as pixels. */
#ifndef VIEWER_IMAGE_H
#define VIEWER_IMAGE_H

#include <stddef.h>
#include <stdint.h>

/* Pixels of a PNG or, where the build has libjpeg, a JPEG: four bytes each, R, G, B, A, sRGB, from the top left corner
 * on. To be freed; NULL, with a line on stderr, for other formats and for files that are broken or too large. */
uint8_t* image_decode(const void* data, size_t size, int* out_width, int* out_height);

#endif
