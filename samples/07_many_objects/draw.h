/* Pictures for people: the level as the scene has it, and how long the frames took. */
#ifndef SAMPLE_DRAW_H
#define SAMPLE_DRAW_H

#include "canvas.h"
#include "hands.h"

typedef struct frame_note {
    float stream_ms, rest_ms; /* processor time of the game thread */
    uint32_t placed, missing; /* props */
} frame_note;

/* What picks find is what is drawn: a ray and one towards the sun for each of four samples a pixel. */
canvas draw_level(const hands* h, const dm_camera* camera, int width, int height);
/* budget: ms. */
canvas draw_frames(const frame_note* notes, uint32_t count, float budget);

#endif
