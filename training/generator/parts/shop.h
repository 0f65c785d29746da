/* Declares what machine tools share. */
#ifndef DMG_SHOP_H
#define DMG_SHOP_H

#include "core/build.h"

/* A hand wheel, crank or capstan on a shaft out of `at`; `turn` about Y brings +Z to where it faces. */
void dmg_handwheel_place(dmg_builder* b, uint32_t parent, const char* name, dmg_vec at, float turn, float r);
/* A lever on a boss there. */
void dmg_machine_lever_place(dmg_builder* b, uint32_t parent, const char* name, dmg_vec at, float turn, float length);
/* The operator's panel, on an arm that turns about the origin or fixed. */
void dmg_pendant_draw(dmg_builder* b, float size);
/* Walls round a workroom, x and z centred, floor at y = 0, the front open or behind doors that slide along it. */
void dmg_enclosure_draw(dmg_builder* b, dmg_vec room, float t);
/* Below a machine: a cabinet, two pedestals with doors, legs, nothing. Top at y = 0; returns its height. */
float dmg_machine_stand_draw(dmg_builder* b, float low_x, float high_x, float deep, float unit);

#endif
