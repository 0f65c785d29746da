/* Declares the steps of dmg_make, between which the layer of assets changes an object. Internal to the generator. */
#ifndef DMG_MAKE_H
#define DMG_MAKE_H

#include "core/build.h"

/* Initialises the builder and draws the object, closed, as dmg_make does. category: a row; flags: of dmg_make. */
void dmg_draw_category(dmg_builder* b, uint32_t category, uint64_t seed, uint32_t flags);
/* Copies a finished object out of the builder. soup: every corner gets a vertex of its own. Returns 0 on success. */
int dmg_take_object(dmg_builder* b, uint32_t category, bool soup, dmg_object* out_object);

#endif
