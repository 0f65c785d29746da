/* Declares free-form shells and the parts that are let into them or stand square to their surface (lofts.c). */
#ifndef DMG_LOFTS_H
#define DMG_LOFTS_H

#include "core/build.h"

enum { DMG_WINDOW_LIMIT = 8 };

/* An opening of a shell, on lines of its grid: from row to row, from column to column (beyond the last: round again).
 */
typedef struct dmg_window {
    int row0, row1, column0, column1;
    float depth;
} dmg_window;

/* A bent body: sections that are squared ellipses along a cubic curve. A place on it is a share of its length and an
 * angle round it: 0 towards `side`, a quarter turn on towards side x line. */
typedef struct dmg_bent {
    dmg_vec control[4];
    dmg_vec side;
    float wide[3], deep[3]; /* half sizes at the beginning, the middle and the end */
    float round[2];         /* share of the length over which an end is rounded off; 0: cut flat */
    float power, egg;       /* of the section: 2 an ellipse, more a box; narrower ahead */
    float twist;            /* from end to end */
    int rows, columns;
    dmg_window windows[DMG_WINDOW_LIMIT];
    int window_count;
} dmg_bent;

/* Returns a body with the given ends, bowed aside in the middle. */
dmg_bent dmg_bent_between(dmg_vec from, dmg_vec to, dmg_vec bow, dmg_vec side, float wide, float deep);
dmg_vec dmg_bent_middle(const dmg_bent* n, float s);
dmg_vec dmg_bent_point(const dmg_bent* n, float s, float angle, float out);
/* Saves the frame and goes to that place: +Z out of the shell, +Y along it. */
void dmg_bent_stand(dmg_builder* b, const dmg_bent* n, float s, float angle, float out);
/* An opening with a well below it, about an angle; on the grid's nearest lines. Before the shell is drawn. */
dmg_window dmg_bent_open(dmg_bent* n, float s, float angle, float length, float arc, float depth);
void dmg_bent_draw(dmg_builder* b, const dmg_bent* n);

/* How the part that fills an opening moves: straight in, about the line across its first or last end, about its middle.
 */
typedef enum dmg_key_motion {
    DMG_KEY_PRESS,
    DMG_KEY_FIRST,
    DMG_KEY_LAST,
    DMG_KEY_ROCK,
    DMG_KEY_ROCK_ASIDE
} dmg_key_motion;

/* Adds the part that fills an opening. Leaves `parent` in use. */
void dmg_bent_key_draw(dmg_builder* b, const dmg_bent* n, const dmg_window* w, uint32_t parent, const char* name,
                       dmg_key_motion motion);

/* A closed hoop about +Y whose section leans and swells on the way round. */
void dmg_hoop_draw(dmg_builder* b, float radius_x, float radius_z, float wide, float high, float lean, float swell);

/* Saves the frame, goes to `at` and turns: +Z to `out`, +Y as near to `up` as can be. */
void dmg_aim(dmg_builder* b, dmg_vec at, dmg_vec out, dmg_vec up);

/* ---- on z = 0, +Z out of the surface; `parent` is in use afterwards ---- */

/* What a finger pulls: it hangs along -Y from the origin, its face +Z goes in; the pin is inside, behind the root.
 * Returns the part. */
uint32_t dmg_finger_lever_draw(dmg_builder* b, uint32_t parent, const char* name, float wide, float length);
/* A bat, a paddle or a ball-ended rod that leans along Y about a pin below the surface. */
void dmg_bat_draw(dmg_builder* b, uint32_t parent, const char* name, float size);
/* A small stick with a cap that leans about one of two lines below the surface. */
void dmg_hat_draw(dmg_builder* b, uint32_t parent, const char* name, float size);
/* A rocker, its halves raised, about X below the surface. */
void dmg_rock_key_draw(dmg_builder* b, uint32_t parent, const char* name, float wide, float high);

#endif
