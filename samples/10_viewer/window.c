/* The window, its OpenGL context and what SDL reports as events of a session. */
#include "window.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

int window_open(window* window, int width, int height, int hidden) {
    memset(window, 0, sizeof *window);
    if (SDL_Init(SDL_INIT_VIDEO) != 0) {
        fprintf(stderr, "viewer: no screen: %s (SDL_VIDEODRIVER=offscreen needs none)\n", SDL_GetError());
        return -1;
    }
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    const Uint32 flags = SDL_WINDOW_OPENGL | (hidden ? SDL_WINDOW_HIDDEN : SDL_WINDOW_RESIZABLE);
    window->handle =
        SDL_CreateWindow("dragmesh viewer", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height, flags);
    if (window->handle != NULL) window->gl = SDL_GL_CreateContext(window->handle);
    if (window->gl != NULL) {
        SDL_GL_SetSwapInterval(1);
        return 0;
    }
    fprintf(stderr, "viewer: no OpenGL 3.3: %s (Debian: libgl1-mesa-dri draws in software)\n", SDL_GetError());
    window_close(window);
    return -1;
}

void window_close(window* window) {
    if (window->gl != NULL) SDL_GL_DeleteContext(window->gl);
    if (window->handle != NULL) SDL_DestroyWindow(window->handle);
    SDL_Quit();
    memset(window, 0, sizeof *window);
}

static int button_of(const SDL_Event* sdl) {
    switch (sdl->button.button) {
    case SDL_BUTTON_LEFT:
        return BUTTON_LEFT;
    case SDL_BUTTON_MIDDLE:
        return BUTTON_MIDDLE;
    case SDL_BUTTON_RIGHT:
        return BUTTON_RIGHT;
    default:
        return 0;
    }
}

static bool translate(const SDL_Event* sdl, event* out) {
    switch (sdl->type) {
    case SDL_QUIT:
        out->kind = EVENT_KEY;
        snprintf(out->key, sizeof out->key, "Escape");
        return true;
    case SDL_MOUSEMOTION:
        out->kind = EVENT_MOVE;
        out->numbers[0] = (float)sdl->motion.x, out->numbers[1] = (float)sdl->motion.y;
        return true;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        out->kind = sdl->type == SDL_MOUSEBUTTONDOWN ? EVENT_PRESS : EVENT_RELEASE;
        out->button = button_of(sdl);
        return out->button != 0;
    case SDL_MOUSEWHEEL:
        out->kind = EVENT_WHEEL;
        out->numbers[0] = (float)sdl->wheel.y;
        return true;
    case SDL_KEYDOWN:
        out->kind = EVENT_KEY;
        snprintf(out->key, sizeof out->key, "%s", SDL_GetKeyName(sdl->key.keysym.sym));
        return out->key[0] && strchr(out->key, ' ') == NULL;
    default:
        return false;
    }
}

bool window_next(event* out_event, int* out_resized) {
    SDL_Event sdl;
    while (SDL_PollEvent(&sdl)) {
        memset(out_event, 0, sizeof *out_event);
        out_event->shift = (SDL_GetModState() & KMOD_SHIFT) != 0;
        if (sdl.type == SDL_WINDOWEVENT && sdl.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) *out_resized = 1;
        if (translate(&sdl, out_event)) return true;
    }
    return false;
}
