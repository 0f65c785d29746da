/* Text on the screen. */
#ifndef VIEWER_PANEL_H
#define VIEWER_PANEL_H

#include "app.h"
#include "draw.h"

/* `part` gets a label of its own in the scene; 0 = none. */
void panel_draw(const app* app, draw* draw, uint32_t part);

#endif
