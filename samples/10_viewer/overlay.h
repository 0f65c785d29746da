/* Overlay of the picture: axis, limits, hypotheses, key poses, text. */
#ifndef VIEWER_OVERLAY_H
#define VIEWER_OVERLAY_H

#include "app.h"
#include "draw.h"
#include "render.h"

void overlay_ghosts(const app* app, render* render, const surface* surface);
void overlay_draw(const app* app, draw* draw);

/* How each part is lit: what is held, selected or under the pointer stands out. looks[0] is the body. */
void overlay_looks(const app* app, look* looks);

#endif
