/* The lit picture of an object: one sun with shadows, a sky, a floor. */
#include "render.h"

#include <string.h>

#include "shader.h"
#include "shaders.h"

enum { SHADOW_PIXELS = 2048 }; /* side of the shadow map; by hand */
enum { PICTURE_UNIT = 1 };     /* that base colour textures are bound to; the shadow map has unit 0 */

static void open_shadow(render* render) {
    glGenTextures(1, &render->shadow_map);
    glBindTexture(GL_TEXTURE_2D, render->shadow_map);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, SHADOW_PIXELS, SHADOW_PIXELS, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                 NULL);
    const GLint settings[][2] = {{GL_TEXTURE_MIN_FILTER, GL_LINEAR},
                                 {GL_TEXTURE_MAG_FILTER, GL_LINEAR},
                                 {GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE},
                                 {GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE},
                                 {GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE},
                                 {GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL}};
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++)
        glTexParameteri(GL_TEXTURE_2D, (GLenum)settings[i][0], settings[i][1]);
    glGenFramebuffers(1, &render->shadow_frame);
    glBindFramebuffer(GL_FRAMEBUFFER, render->shadow_frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, render->shadow_map, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
}

int render_open(render* render) {
    memset(render, 0, sizeof *render);
    render->solid = shader_make("solid", solid_vertex, solid_fragment);
    render->ghost = shader_make("ghost", solid_vertex, ghost_fragment);
    render->shadow = shader_make("shadow", solid_vertex, depth_fragment);
    render->sky = shader_make("sky", sky_vertex, sky_fragment);
    render->floor = shader_make("floor", floor_vertex, floor_fragment);
    glGenVertexArrays(1, &render->nothing);
    open_shadow(render);
    return render->solid && render->ghost && render->shadow && render->sky && render->floor ? 0 : -1;
}

void render_close(render* render) {
    const GLuint programs[] = {render->solid, render->ghost, render->shadow, render->sky, render->floor};
    for (size_t i = 0; i < sizeof programs / sizeof *programs; i++) glDeleteProgram(programs[i]);
    glDeleteFramebuffers(1, &render->shadow_frame);
    glDeleteTextures(1, &render->shadow_map);
    glDeleteVertexArrays(1, &render->nothing);
}

/* The sun stands behind the viewer's first place, high and to the left; the object's front is lit. */
static dm_vec3 sun_of(const camera* camera) {
    return unit(camera->z_up ? vec(-0.45f, -0.75f, 1.05f) : vec(-0.45f, 1.05f, 0.75f));
}

static dm_vec3 middle_of(const surface* surface) {
    return scale(add(surface->box_min, surface->box_max), 0.5f);
}

/* Opened parts reach out of the box at rest: twice its radius is lit with shadows. */
static float reach_of(const surface* surface) {
    return length(sub(surface->box_max, surface->box_min));
}

static void draw_part(const surface* surface, uint32_t part, GLuint program, const dm_pose* pose) {
    mat4 model;
    dm_pose_to_matrix(pose, (float*)model);
    shader_matrix(program, "model", model);
    glDrawArrays(GL_TRIANGLES, surface->first[part], surface->first[part + 1] - surface->first[part]);
}

/* Draws a part with its textures. */
static void draw_textured(const surface* surface, uint32_t part, GLuint program, const dm_pose* pose) {
    mat4 model;
    dm_pose_to_matrix(pose, (float*)model);
    shader_matrix(program, "model", model);
    glActiveTexture(GL_TEXTURE0 + PICTURE_UNIT);
    for (uint32_t r = surface->first_run[part]; r < surface->first_run[part + 1]; r++) {
        glBindTexture(GL_TEXTURE_2D, surface->runs[r].texture);
        glDrawArrays(GL_TRIANGLES, surface->runs[r].first, surface->runs[r].count);
    }
    glActiveTexture(GL_TEXTURE0);
}

static void draw_shadows(render* render, const surface* surface, const camera* camera, const look* looks,
                         uint32_t parts) {
    const float reach = reach_of(surface);
    const dm_vec3 sun = sun_of(camera), eye = along(middle_of(surface), sun, 2 * reach);
    mat4 view, box;
    glm_look(raw(eye).v, raw(scale(sun, -1)).v, raw(camera_up(camera)).v, view);
    glm_ortho(-reach, reach, -reach, reach, 0, 4 * reach, box);
    glm_mat4_mul(box, view, render->light);
    GLint frame;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, render->shadow_frame);
    glViewport(0, 0, SHADOW_PIXELS, SHADOW_PIXELS);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 2);
    glUseProgram(render->shadow);
    shader_matrix(render->shadow, "view_projection", render->light);
    for (uint32_t part = 0; part <= parts; part++) draw_part(surface, part, render->shadow, &looks[part].pose);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glBindFramebuffer(GL_FRAMEBUFFER, (GLuint)frame);
    glViewport(0, 0, camera->width, camera->height);
}

static void draw_sky(const render* render) {
    glUseProgram(render->sky);
    glBindVertexArray(render->nothing);
    glDisable(GL_DEPTH_TEST);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
}

static void draw_floor(render* render, const surface* surface, const camera* camera, mat4 both) {
    const dm_vec3 up = camera_up(camera), side = vec(1, 0, 0), ahead = cross(side, up);
    const float reach = 2.2f * reach_of(surface);
    const dm_vec3 middle = middle_of(surface);
    if (dot(sub(camera_eye(camera), surface->box_min), up) <= 0) return; /* it would hide the object */
    const float sunk = dot(sub(middle, surface->box_min), up) + 0.001f * reach;
    glUseProgram(render->floor);
    shader_matrix(render->floor, "view_projection", both);
    shader_matrix(render->floor, "light", render->light);
    shader_vec3(render->floor, "middle", along(middle, up, -sunk));
    shader_vec3(render->floor, "side", scale(side, reach));
    shader_vec3(render->floor, "ahead", scale(ahead, reach));
    glBindVertexArray(render->nothing);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_BLEND);
}

void render_scene(render* render, const surface* surface, const camera* camera, const look* looks, uint32_t parts) {
    mat4 both;
    camera_matrix(camera, both);
    glBindVertexArray(surface->array);
    glEnable(GL_DEPTH_TEST);
    draw_shadows(render, surface, camera, looks, parts);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_sky(render);
    glBindTexture(GL_TEXTURE_2D, render->shadow_map);
    draw_floor(render, surface, camera, both);
    glUseProgram(render->solid);
    glBindVertexArray(surface->array);
    shader_matrix(render->solid, "view_projection", both);
    shader_matrix(render->solid, "light", render->light);
    shader_vec3(render->solid, "eye", camera_eye(camera));
    shader_vec3(render->solid, "sun", sun_of(camera));
    shader_vec3(render->solid, "up", camera_up(camera));
    shader_int(render->solid, "picture", PICTURE_UNIT);
    for (uint32_t part = 0; part <= parts; part++) {
        shader_vec4(render->solid, "tint", looks[part].tint);
        shader_float(render->solid, "glow", looks[part].glow);
        draw_textured(surface, part, render->solid, &looks[part].pose);
    }
}

void render_ghost(render* render, const surface* surface, const camera* camera, uint32_t part, const look* look) {
    mat4 both;
    camera_matrix(camera, both);
    glUseProgram(render->ghost);
    glBindVertexArray(surface->array);
    shader_matrix(render->ghost, "view_projection", both);
    shader_vec3(render->ghost, "eye", camera_eye(camera));
    shader_vec4(render->ghost, "tint", look->tint);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    draw_part(surface, part, render->ghost, &look->pose);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}
