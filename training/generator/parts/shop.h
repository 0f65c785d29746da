/* Declares what machine tools share. */
#ifndef DMG_SHOP_H
#define DMG_SHOP_H

#include "core/build.h"

/* A hand wheel, crank or capstan on a shaft out of `at`; `turn` about Y brings +Z to where it faces. */
void dmg_handwheel_place(dmg_builder* b, uint32_t parent, const char* name, dmg_vec at, float turn, float r);
/* A lever on a boss there. */
void dmg_machine_lever_place(dmg_builder* b, uint32_t parent, const char* name, dmg_vec at, float turn, float length);

#endif
