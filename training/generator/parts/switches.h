/* Declares panel controls: knobs that turn, keys that are pressed, switches that flip. Each is drawn on z = 0 facing
 * +Z round the origin, within a circle of the given radius, and adds its parts; rows of them run along X. */
#ifndef DMG_SWITCHES_H
#define DMG_SWITCHES_H

#include "core/build.h"

/* Properties of a knob, drawn once for all knobs of a row. */
typedef struct dmg_dial {
    int kind;
    float height; /* over the diameter */
    float sink;   /* how much of the height hides behind the panel */
    float lower, upper;
    bool endless, collar, pulled; /* pulled: it slides out instead of turning */
} dmg_dial;

dmg_dial dmg_dial_pick(dmg_builder* b);
void dmg_dial_draw(dmg_builder* b, const dmg_dial* dial, float radius);
/* Two or three knobs on one axis, the upper ones smaller. */
void dmg_dial_stack_draw(dmg_builder* b, float radius);

/* Draws a key that is pressed: low, and seldom round when it is not low. */
typedef struct dmg_key {
    int kind;
    float width, height; /* of a radius of 1 */
    float rise, travel;
    bool framed;
} dmg_key;

dmg_key dmg_key_pick(dmg_builder* b);
void dmg_key_draw(dmg_builder* b, const dmg_key* key, float radius);

/* A lever that flips across its row: pivot at or below the surface, about X. */
typedef struct dmg_toggle {
    int kind;
    float length, thin, pivot, swing, rest;
    float start; /* of what is drawn: the pivot, or the surface above it */
    bool nut;
} dmg_toggle;

dmg_toggle dmg_toggle_pick(dmg_builder* b);
void dmg_toggle_draw(dmg_builder* b, const dmg_toggle* toggle, float radius);

typedef struct dmg_rocker {
    int kind;
    float width, length, rise, depth, tilt;
    bool framed;
} dmg_rocker;

dmg_rocker dmg_rocker_pick(dmg_builder* b);
void dmg_rocker_draw(dmg_builder* b, const dmg_rocker* rocker, float radius);

void dmg_guard_draw(dmg_builder* b, float radius);       /* a cover that flips up from over a switch */
void dmg_breaker_draw(dmg_builder* b, float radius);     /* a button in a collar, pulled out or pushed in */
void dmg_plunger_draw(dmg_builder* b, float radius);     /* a knob or a T on a thin rod, pulled and pushed */
void dmg_key_switch_draw(dmg_builder* b, float radius);  /* a lock with its key */
void dmg_thumb_wheel_draw(dmg_builder* b, float radius); /* its rim stands out of a slot */
void dmg_fader_draw(dmg_builder* b, float radius);       /* slides along Y in a slot */
/* Draws fixed things: screens, labels, lamps, screws. */
void dmg_ornament_draw(dmg_builder* b, float radius);

typedef enum dmg_control_kind {
    DMG_CONTROL_DIAL,
    DMG_CONTROL_STACK,
    DMG_CONTROL_KEY,
    DMG_CONTROL_TOGGLE,
    DMG_CONTROL_ROCKER,
    DMG_CONTROL_GUARD,
    DMG_CONTROL_BREAKER,
    DMG_CONTROL_PLUNGER,
    DMG_CONTROL_LOCK,
    DMG_CONTROL_THUMB_WHEEL,
    DMG_CONTROL_FADER,
    DMG_CONTROL_ORNAMENT,
    DMG_CONTROL_KINDS
} dmg_control_kind;

/* Controls alike, `count` of them `pitch` apart along X round the origin; some places stay empty. */
void dmg_control_row_draw(dmg_builder* b, dmg_control_kind kind, int count, float pitch, float radius);

#endif
