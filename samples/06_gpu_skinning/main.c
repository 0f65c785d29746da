/* Poses on the graphics card: one vertex buffer for the whole object, a part number a vertex, a dual quaternion a part.
 * The vertex shader moves the vertices; what it computes is read back and compared with dm_pose_apply_points. */
#include <math.h>
#include <string.h>

#include <SDL2/SDL.h>
#include <epoxy/gl.h>

#include "../common/cabinet.h"
#include "../common/weights.h"

enum { PARTS = 3 }; /* the body, the door, the drawer */

/* x' = R(q) x + t, with t = 2 d q* out of the dual part: a skin of rigid parts needs no blending and no matrices. */
static const char* const skin_shader =
    "#version 330 core\n"
    "layout(location = 0) in vec3 place;\n"
    "layout(location = 1) in float part;\n"
    "uniform vec4 real[3];\n"
    "uniform vec4 dual[3];\n"
    "out vec3 moved;\n"
    "void main() {\n"
    "    vec4 q = real[int(part)], d = dual[int(part)];\n"
    "    vec3 turned = place + 2.0 * cross(q.xyz, cross(q.xyz, place) + q.w * place);\n"
    "    vec3 shift = 2.0 * (q.w * d.xyz - d.w * q.xyz + cross(q.xyz, d.xyz));\n"
    "    moved = turned + shift;\n"
    "    gl_Position = vec4(moved, 1.0);\n"
    "}\n";

/* ---- the graphics card ---- */

static SDL_Window* open_graphics(SDL_GLContext* out_gl) {
    if (SDL_Init(SDL_INIT_VIDEO) != 0) return NULL;
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_Window* window = SDL_CreateWindow("skin", 0, 0, 64, 64, SDL_WINDOW_OPENGL | SDL_WINDOW_HIDDEN);
    *out_gl = window != NULL ? SDL_GL_CreateContext(window) : NULL;
    return *out_gl != NULL ? window : NULL;
}

/* A program whose vertices are caught after the vertex shader (transform feedback). */
static GLuint make_program(void) {
    const GLuint shader = glCreateShader(GL_VERTEX_SHADER), program = glCreateProgram();
    const char* caught = "moved";
    GLint done = 0;
    glShaderSource(shader, 1, &skin_shader, NULL);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glTransformFeedbackVaryings(program, 1, &caught, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    return done ? program : 0;
}

/* Uploaded once: the mesh never changes. */
static void upload_mesh(const cabinet* shape) {
    GLuint names[3], array;
    float parts[CABINET_VERTICES];
    for (int v = 0; v < CABINET_VERTICES; v++) parts[v] = shape->parts[v];
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(3, names);
    glBindBuffer(GL_ARRAY_BUFFER, names[0]);
    glBufferData(GL_ARRAY_BUFFER, sizeof shape->positions, shape->positions, GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, NULL);
    glBindBuffer(GL_ARRAY_BUFFER, names[1]);
    glBufferData(GL_ARRAY_BUFFER, sizeof parts, parts, GL_STATIC_DRAW);
    glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, 0, NULL);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, names[2]);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, sizeof shape->positions, NULL, GL_STREAM_READ);
}

/* Every frame: 32 bytes a part. */
static void skin_on_gpu(GLuint program, const dm_pose poses[PARTS], float out[CABINET_VERTICES][3]) {
    float real[PARTS][4], dual[PARTS][4];
    for (int i = 0; i < PARTS; i++) {
        memcpy(real[i], poses[i].real, sizeof real[i]);
        memcpy(dual[i], poses[i].dual, sizeof dual[i]);
    }
    glUseProgram(program);
    glUniform4fv(glGetUniformLocation(program, "real"), PARTS, real[0]);
    glUniform4fv(glGetUniformLocation(program, "dual"), PARTS, dual[0]);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, CABINET_VERTICES);
    glEndTransformFeedback();
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof(float[CABINET_VERTICES][3]), out);
}

/* ---- the comparison ---- */

static float farthest(const cabinet* shape, const dm_pose poses[PARTS], float gpu[CABINET_VERTICES][3]) {
    float most = 0;
    for (int v = 0; v < CABINET_VERTICES; v++) {
        float cpu[3];
        dm_pose_apply_points(&poses[shape->parts[v]], shape->positions[v], 0, cpu, 0, 1);
        for (int k = 0; k < 3; k++) most = fmaxf(most, fabsf(cpu[k] - gpu[v][k]));
    }
    return most;
}

static dm_result prepare(dm_context* context, dm_mesh_desc mesh, const char* models, dm_joint joints[PARTS]) {
    dm_model model;
    dm_object object;
    dm_result result = load_weights(context, models, &model);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = model};
    if (result == DM_OK) result = dm_object_prepare(context, &desc, &object);
    for (uint32_t part = 1; part < PARTS && result == DM_OK; part++) {
        joints[part] = dm_joint_default();
        result = dm_object_get_joint(context, object, part, &joints[part]);
    }
    return result;
}

int main(int argc, char** argv) {
    static cabinet shape;
    static float gpu[CABINET_VERTICES][3];
    const dm_context_desc host = {.struct_size = sizeof host, .log = {NULL, print_message}};
    dm_context* context;
    dm_joint joints[PARTS];
    SDL_GLContext gl;
    SDL_Window* window = open_graphics(&gl);
    if (window == NULL) {
        fprintf(stderr, "no OpenGL 3.3: %s\n", SDL_GetError());
        return 3;
    }
    const GLuint program = make_program();
    const dm_mesh_desc mesh = cabinet_make(&shape);
    if (!program || dm_context_create(&host, &context) != DM_OK) return 1;
    if (prepare(context, mesh, argc > 1 ? argv[1] : "sdk/models", joints) != DM_OK) return 1;
    upload_mesh(&shape);
    float worst = 0;
    dm_pose poses[PARTS] = {{{0, 0, 0, 1}, {0, 0, 0, 0}}};
    for (int frame = 0; frame <= 10; frame++) {
        for (int part = 1; part < PARTS; part++) {
            const float open = (float)frame / 10;
            dm_joint_pose(&joints[part], joints[part].lower + open * (joints[part].upper - joints[part].lower),
                          &poses[part]);
        }
        skin_on_gpu(program, poses, gpu);
        worst = fmaxf(worst, farthest(&shape, poses, gpu));
    }
    printf("%s: %d vertices in 11 poses, at most %.1e m from dm_pose_apply_points\n",
           (const char*)glGetString(GL_RENDERER), CABINET_VERTICES, (double)worst);
    dm_context_destroy(context);
    SDL_GL_DeleteContext(gl);
    SDL_DestroyWindow(window);
    SDL_Quit();
    return worst < 1e-5f ? 0 : 1;
}
