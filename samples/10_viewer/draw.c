/* Lines, boxes and words over the picture. A line is a quad whose fragment shader measures the distance to the line,
 * so ends are round and edges are smooth at any width. */
#include "draw.h"

#include <stdlib.h>
#include <string.h>

#include "font.h"
#include "shader.h"

static const char* const vertex_shader =
    "layout(location = 0) in vec3 place; layout(location = 1) in vec4 shape; layout(location = 2) in vec4 tint;\n"
    "uniform vec3 view;\n"
    "out vec4 s; out vec4 t;\n"
    "void main() {\n"
    "    s = shape; t = tint;\n"
    "    gl_Position = vec4(place.x / view.x * 2.0 - 1.0, 1.0 - place.y / view.y * 2.0, place.z * 2.0 - 1.0, 1.0);\n"
    "}\n";

static const char* const fragment_shader =
    "in vec4 s; in vec4 t; out vec4 colour;\n"
    "uniform float strength;\n"
    "void main() {\n"
    "    float away = length(vec2(s.x - clamp(s.x, 0.0, s.z), s.y));\n"
    "    colour = vec4(t.rgb, t.a * strength * clamp(s.w + 0.5 - away, 0.0, 1.0));\n"
    "}\n";

int draw_open(draw* draw) {
    memset(draw, 0, sizeof *draw);
    draw->program = shader_make("lines", vertex_shader, fragment_shader);
    glGenVertexArrays(1, &draw->array);
    glGenBuffers(1, &draw->buffer);
    glBindVertexArray(draw->array);
    glBindBuffer(GL_ARRAY_BUFFER, draw->buffer);
    static const GLint sizes[3] = {3, 4, 4}; /* place; u, v, length, radius; colour */
    const float* offset = NULL;              /* of the attribute in a vertex, as OpenGL wants it: a pointer */
    for (GLuint i = 0; i < 3; offset += sizes[i++]) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, sizes[i], GL_FLOAT, GL_FALSE, sizeof(draw_vertex), offset);
    }
    return draw->program ? 0 : -1;
}

void draw_close(draw* draw) {
    glDeleteBuffers(1, &draw->buffer);
    glDeleteVertexArrays(1, &draw->array);
    glDeleteProgram(draw->program);
    free(draw->space.vertices);
    free(draw->flat.vertices);
}

void draw_begin(draw* draw, const camera* camera) {
    draw->camera = camera;
    draw->space.count = draw->flat.count = 0;
}

static void push(draw_list* list, const draw_vertex* vertex) {
    if (list->count == list->room) {
        const size_t room = list->room ? list->room * 2 : 4096;
        draw_vertex* grown = realloc(list->vertices, room * sizeof *grown);
        if (grown == NULL) return;
        list->vertices = grown;
        list->room = room;
    }
    list->vertices[list->count++] = *vertex;
}

/* A quad round the line from a to b (x, y, depth), one pixel wider than the line for the soft edge. */
static void push_line(draw_list* list, const float a[3], const float b[3], float width, colour c) {
    float dx = b[0] - a[0], dy = b[1] - a[1];
    const float l = hypotf(dx, dy), radius = width / 2, out = radius + 1;
    dx = l > 0 ? dx / l : 1;
    dy = l > 0 ? dy / l : 0;
    draw_vertex corners[4];
    for (int i = 0; i < 4; i++) {
        const float u = i & 1 ? l + out : -out, v = i & 2 ? out : -out;
        const float t = i & 1 ? 1.0f : 0.0f;
        corners[i] = (draw_vertex){a[0] + dx * u - dy * v,
                                   a[1] + dy * u + dx * v,
                                   a[2] + t * (b[2] - a[2]),
                                   u,
                                   v,
                                   l,
                                   radius,
                                   c.r,
                                   c.g,
                                   c.b,
                                   c.a};
    }
    static const int order[6] = {0, 1, 2, 2, 1, 3};
    for (int i = 0; i < 6; i++) push(list, &corners[order[i]]);
}

/* What lies behind the camera is cut off first. */
void draw_line(draw* draw, dm_vec3 from, dm_vec3 to, float width, colour colour) {
    const dm_vec3 eye = camera_eye(draw->camera), forward = camera_forward(draw->camera);
    const float near = draw->camera->distance * 0.02f;
    const float a = dot(sub(from, eye), forward), b = dot(sub(to, eye), forward);
    if (a < near && b < near) return;
    if (a < near) from = mix(from, to, (near - a) / (b - a));
    if (b < near) to = mix(to, from, (near - b) / (a - b));
    float p[3], q[3];
    if (camera_project(draw->camera, from, p) && camera_project(draw->camera, to, q))
        push_line(&draw->space, p, q, width, colour);
}

void draw_arrow(draw* draw, dm_vec3 from, dm_vec3 to, float width, colour colour) {
    draw_line(draw, from, to, width, colour);
    float p[3], q[3];
    if (!camera_project(draw->camera, from, p) || !camera_project(draw->camera, to, q)) return;
    const float dx = p[0] - q[0], dy = p[1] - q[1], l = hypotf(dx, dy), size = 4 + 2 * width;
    if (l < 1) return;
    for (int side = -1; side <= 1; side += 2) {
        const float x = (dx * 0.87f - dy * 0.5f * (float)side) / l, y = (dy * 0.87f + dx * 0.5f * (float)side) / l;
        const float tip[3] = {q[0] + x * size, q[1] + y * size, q[2]};
        push_line(&draw->space, q, tip, width, colour);
    }
}

void draw_line_2d(draw* draw, float x0, float y0, float x1, float y1, float width, colour colour) {
    push_line(&draw->flat, (float[3]){x0, y0, 0}, (float[3]){x1, y1, 0}, width, colour);
}

void draw_disc(draw* draw, float x, float y, float radius, colour colour) {
    draw_line_2d(draw, x, y, x, y, 2 * radius, colour);
}

/* Every point of a box is on its line. */
void draw_box(draw* draw, float x, float y, float width, float height, colour c) {
    static const int order[6] = {0, 1, 2, 2, 1, 3};
    for (int i = 0; i < 6; i++) {
        const int k = order[i];
        const draw_vertex v = {x + (k & 1 ? width : 0), y + (k & 2 ? height : 0), 0, 0, 0, 0, 2, c.r, c.g, c.b, c.a};
        push(&draw->flat, &v);
    }
}

float draw_text_width(float size, const char* text) {
    float width = 0;
    for (; *text; text++) width += font_advance(*text) * size;
    return width;
}

float draw_text(draw* draw, float x, float y, float size, colour colour, const char* text) {
    const float width = fmaxf(1.2f, size * 0.13f);
    for (; *text; text++) {
        font_stroke strokes[FONT_STROKES];
        const int count = font_glyph(*text, strokes);
        for (int i = 0; i < count; i++)
            draw_line_2d(draw, x + strokes[i].x0 * size, y - strokes[i].y0 * size, x + strokes[i].x1 * size,
                         y - strokes[i].y1 * size, width, colour);
        x += font_advance(*text) * size;
    }
    return x;
}

void draw_label(draw* draw, dm_vec3 at, float size, colour c, const char* text) {
    float p[3];
    if (!camera_project(draw->camera, at, p)) return;
    const float width = draw_text_width(size, text), margin = size * 0.6f;
    const float x = glm_clamp(p[0] + size, margin, (float)draw->camera->width - width - margin);
    const float y = glm_clamp(p[1] - size, size + margin, (float)draw->camera->height - margin);
    draw_box(draw, x - margin, y - size - margin, width + 2 * margin, size + 2 * margin,
             (colour){0.07f, 0.08f, 0.1f, 0.78f});
    draw_text(draw, x, y, size, c, text);
}

static void show(const draw* draw, const draw_list* list, float strength) {
    if (!list->count) return;
    shader_float(draw->program, "strength", strength);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(list->count * sizeof *list->vertices), list->vertices, GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, (GLsizei)list->count);
}

void draw_end(draw* draw) {
    glUseProgram(draw->program);
    shader_vec3(draw->program, "view", vec((float)draw->camera->width, (float)draw->camera->height, 0));
    glBindVertexArray(draw->array);
    glBindBuffer(GL_ARRAY_BUFFER, draw->buffer);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glDisable(GL_DEPTH_TEST);
    show(draw, &draw->space, 0.28f);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    show(draw, &draw->space, 1);
    glDisable(GL_DEPTH_TEST);
    show(draw, &draw->flat, 1);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}
