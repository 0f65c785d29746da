/* A recorded session: the player's events, frame by frame, as text.
 *
 *     dragmesh-session 1
 *     size 640 400            pixels of the window
 *     up z                    optional: the file's up axis (y or z)
 *     scene house_door        optional: of samples/12_latch, in place of a file
 *     part door,handle        optional, repeated: nodes that move as one
 *     0 camera 0.6 0.38 2.9 0 0.4 0      yaw, pitch, distance, target
 *     3 move 310 205          pointer, pixels from the top left corner
 *     3 press left            left, middle, right; with "shift" after it when that was held
 *     40 release left
 *     41 wheel 1
 *     45 key H                as SDL names keys; with "shift" after it
 *     60 end
 *
 * A frame is a sixtieth of a second. */
#ifndef VIEWER_SESSION_H
#define VIEWER_SESSION_H

#include <stdint.h>
#include <stdio.h>

#include "../common/output_file.h"
#include "camera.h"
#include "world.h"

enum { EVENT_CAMERA, EVENT_MOVE, EVENT_PRESS, EVENT_RELEASE, EVENT_WHEEL, EVENT_KEY, EVENT_END };
enum { BUTTON_LEFT = 1, BUTTON_MIDDLE = 2, BUTTON_RIGHT = 3 };

typedef struct event {
    uint32_t frame;
    int32_t kind;
    float numbers[6]; /* camera: yaw, pitch, distance, target; move: x, y; wheel: steps */
    int32_t button;
    int32_t shift;
    char key[16];
} event;

typedef struct session {
    int width, height, z_up;
    char scene[WORLD_NAME]; /* "": none */
    char* parts[WORLD_MAX_PARTS];
    uint32_t part_count;
    event* events;
    uint32_t event_count, end; /* end: number of frames */
} session;

int session_read(session* session, const char* path); /* 0, or -1 with a line on stderr */
void session_free(session* session);

void session_write_head(output_file* file, const camera* camera, const world_options* options);
void session_write_event(output_file* file, const event* event);

#endif
