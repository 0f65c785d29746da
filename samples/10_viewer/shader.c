/* Shader programs. */
#include "shader.h"

#include <stdio.h>

static GLuint compile(const char* name, GLenum stage, const char* source) {
    const char* lines[2] = {"#version 330 core\n", source};
    const GLuint shader = glCreateShader(stage);
    GLint done = 0;
    glShaderSource(shader, 2, lines, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done) return shader;
    char log[2048];
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    fprintf(stderr, "viewer: shader %s: %s\n", name, log);
    glDeleteShader(shader);
    return 0;
}

GLuint shader_make(const char* name, const char* vertex, const char* fragment) {
    const GLuint v = compile(name, GL_VERTEX_SHADER, vertex), f = compile(name, GL_FRAGMENT_SHADER, fragment);
    GLuint program = v && f ? glCreateProgram() : 0;
    GLint done = 0;
    if (program) {
        glAttachShader(program, v);
        glAttachShader(program, f);
        glLinkProgram(program);
        glGetProgramiv(program, GL_LINK_STATUS, &done);
    }
    if (program && !done) {
        char log[2048];
        glGetProgramInfoLog(program, sizeof log, NULL, log);
        fprintf(stderr, "viewer: shader %s: %s\n", name, log);
        glDeleteProgram(program);
        program = 0;
    }
    glDeleteShader(v);
    glDeleteShader(f);
    return program;
}

void shader_matrix(GLuint program, const char* name, mat4 value) {
    glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, value[0]);
}

void shader_vec3(GLuint program, const char* name, dm_vec3 value) {
    glUniform3f(glGetUniformLocation(program, name), value.x, value.y, value.z);
}

void shader_vec4(GLuint program, const char* name, const float value[4]) {
    glUniform4f(glGetUniformLocation(program, name), value[0], value[1], value[2], value[3]);
}

void shader_float(GLuint program, const char* name, float value) {
    glUniform1f(glGetUniformLocation(program, name), value);
}

void shader_int(GLuint program, const char* name, int value) {
    glUniform1i(glGetUniformLocation(program, name), value);
}
