/* One instance of a scene's object in a game: what it keeps of each part, and what it does in a frame. */
#ifndef LATCH_GAME_H
#define LATCH_GAME_H

#include "scene.h"

enum { GAME_HANDS = 2, GAME_NO_HAND = -1 };

typedef struct game_part {
    dm_joint joint;
    dm_drag drag;      /* in hand, or moving by itself; 0: neither */
    int32_t hands[2];  /* the hands that hold it, the first one first; GAME_NO_HAND: none */
    dm_vec3 second_at; /* where the second one has taken hold, in the frame of the part's carrier */
} game_part;

typedef struct game {
    dm_context* context;
    dm_object object;
    const scene* scene;
    float values[SCENE_PARTS]; /* joint values: all that a game saves */
    uint8_t held[SCENE_PARTS]; /* 1: a link holds the part */
    game_part parts[SCENE_PARTS];
    dm_pose poses[SCENE_PARTS]; /* of the parts from rest, with what carries them */
    dm_hand hands[GAME_HANDS];  /* as they were last; object frame */
    void* user;
    void (*heard)(void* user, uint32_t part_id, const dm_drag_state* now); /* after each update with events */
} game;

void game_open(game* game, const scene* scene, dm_context* context, dm_object object);

/* A hand takes hold of a part at a point, and lets go. */
dm_result game_grab(game* game, int32_t hand, uint32_t part_id, dm_vec3 point);
void game_release(game* game, int32_t hand);

/* One frame: where the hands are now, and everything moves. */
void game_step(game* game, const dm_hand hands[GAME_HANDS], float dt);

/* Puts a part at a joint value, out of any hand. */
void game_set(game* game, uint32_t part_id, float value);

/* What a game would play at an event (one bit of DM_EVENT_*), in words. */
const char* game_sound(uint32_t event);

/* ---- script.c ---- */

/* The hands of the scene itself. */
typedef struct script {
    float time;                 /* s so far */
    int32_t acting[GAME_HANDS]; /* which of scene.hands each hand is; -1: none */
    dm_vec3 from[GAME_HANDS];   /* where it took hold */
    dm_hand hands[GAME_HANDS];  /* where it is */
    uint32_t next;              /* of scene.hands */
} script;

void script_open(script* script);
/* One frame of the hands and of what they move. Returns 0 when the scene is over. */
int script_step(script* script, game* game, float dt);

#endif
