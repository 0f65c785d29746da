/* Where a frame is drawn: a multisampled buffer, resolved to the window or to a .png. */
#include "canvas.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <png.h>

#include "../common/output_file.h"
#include "files.h"

enum { SAMPLES = 4 }; /* of a pixel, multisampling; by hand */

static GLuint buffer(GLenum format, GLenum attachment, const canvas* canvas, int samples) {
    GLuint name;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, canvas->width, canvas->height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
    return name;
}

int canvas_open(canvas* canvas, int width, int height) {
    memset(canvas, 0, sizeof *canvas);
    canvas->width = width;
    canvas->height = height;
    glGenFramebuffers(1, &canvas->resolved_frame);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas->resolved_frame);
    canvas->resolved_colour = buffer(GL_RGBA8, GL_COLOR_ATTACHMENT0, canvas, 0);
    glGenFramebuffers(1, &canvas->frame);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas->frame);
    canvas->colour = buffer(GL_RGBA8, GL_COLOR_ATTACHMENT0, canvas, SAMPLES);
    canvas->depth = buffer(GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, canvas, SAMPLES);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return 0;
    fprintf(stderr, "viewer: no frame buffer of %d x %d pixels\n", width, height);
    canvas_close(canvas);
    return -1;
}

void canvas_close(canvas* canvas) {
    const GLuint buffers[3] = {canvas->colour, canvas->depth, canvas->resolved_colour};
    const GLuint frames[2] = {canvas->frame, canvas->resolved_frame};
    glDeleteRenderbuffers(3, buffers);
    glDeleteFramebuffers(2, frames);
}

void canvas_begin(const canvas* canvas) {
    glBindFramebuffer(GL_FRAMEBUFFER, canvas->frame);
    glViewport(0, 0, canvas->width, canvas->height);
}

static void resolve(const canvas* canvas, GLuint to) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, canvas->frame);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, canvas->width, canvas->height, 0, 0, canvas->width, canvas->height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
}

void canvas_to_window(const canvas* canvas) {
    resolve(canvas, 0);
}

uint8_t* canvas_pixels(const canvas* canvas) {
    const size_t stride = (size_t)canvas->width * 3, rows = (size_t)canvas->height;
    uint8_t *pixels = take(rows, stride), *turned = take(rows, stride);
    resolve(canvas, canvas->resolved_frame);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, canvas->resolved_frame);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, canvas->width, canvas->height, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    for (size_t y = 0; y < rows; y++) memcpy(turned + y * stride, pixels + (rows - 1 - y) * stride, stride);
    free(pixels);
    return turned;
}

int canvas_to_png(const canvas* canvas, const char* path) {
    uint8_t* pixels = canvas_pixels(canvas);
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.width = (png_uint_32)canvas->width;
    image.height = (png_uint_32)canvas->height;
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    void* bytes = take(size, 1);
    int status = -1;
    if (bytes != NULL && png_image_write_to_memory(&image, bytes, &size, 0, pixels, 0, NULL))
        status = output_write(path, bytes, size);
    else
        errno = ENOMEM;
    free(bytes);
    free(pixels);
    return status;
}
