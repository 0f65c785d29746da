/* Shader programs. */
#ifndef VIEWER_SHADER_H
#define VIEWER_SHADER_H

#include <epoxy/gl.h>

#include "vec.h"

/* Compiles and links two GLSL 3.30 sources (without their #version line); returns 0, and prints the compiler's
 * messages, on failure. */
GLuint shader_make(const char* name, const char* vertex, const char* fragment);

void shader_matrix(GLuint program, const char* name, mat4 value);
void shader_vec3(GLuint program, const char* name, dm_vec3 value);
void shader_vec4(GLuint program, const char* name, const float value[4]);
void shader_float(GLuint program, const char* name, float value);
void shader_int(GLuint program, const char* name, int value);

#endif
