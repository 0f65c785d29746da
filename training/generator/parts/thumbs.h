/* Declares controls for thumbs and fingers on hand-held things (thumbs.c). */
#ifndef DMG_THUMBS_H
#define DMG_THUMBS_H

#include "core/build.h"

/* Rows of points joined by quads: outside is where `down the rows` x `along a row` points. A round row closes on
 * itself; its first and last row can be closed by a fan each. */
enum {
    DMG_ROWS_ROUND = 1,
    DMG_ROWS_CAP_FIRST = 2,
    DMG_ROWS_CAP_LAST = 4,
    DMG_ROWS_TUBE = DMG_ROWS_ROUND | DMG_ROWS_CAP_FIRST | DMG_ROWS_CAP_LAST
};
void dmg_rows_draw(dmg_builder* b, const dmg_vec* at, int rows, int columns, unsigned flags);

/* On z = 0, +Z out of the shell, +Y away from the player. `parent` is in use afterwards. */
void dmg_thumb_stick_draw(dmg_builder* b, uint32_t parent, float radius);
void dmg_touch_pad_draw(dmg_builder* b, uint32_t parent, float radius);
void dmg_thumb_key_draw(dmg_builder* b, uint32_t parent, const char* name, float radius);

/* Its root is the origin, it hangs towards -Y, the finger pulls its face +Z towards -Z. */
void dmg_trigger_shell_draw(dmg_builder* b, uint32_t parent, const char* name, float width, float length);

/* A handle's elliptical cross section, its middle this high; the handle runs along Z. */
typedef struct dmg_handle_section {
    float half_width, half_height, middle;
} dmg_handle_section;

void dmg_squeeze_draw(dmg_builder* b, const dmg_handle_section* h, float angle, float z, float length);

#endif
