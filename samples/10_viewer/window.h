/* The window, its OpenGL context, and SDL events converted to events of a session. */
#ifndef VIEWER_WINDOW_H
#define VIEWER_WINDOW_H

#include <SDL2/SDL.h>
#include <stdbool.h>

#include "session.h"

typedef struct window {
    SDL_Window* handle;
    SDL_GLContext gl;
} window;

/* 0, or -1 with a line on stderr that says what is missing. */
int window_open(window* window, int width, int height, int hidden);
void window_close(window* window);

/* Gets the player's next event, with its frame left 0. Returns false when there is none. */
bool window_next(event* out_event, int* out_resized);

#endif
