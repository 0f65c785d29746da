/* Declares crank trains, which engines and benches of mechanisms share. The crank turns about +Z at the origin, the
 * slider moves along +X. */
#ifndef DMG_CRANKS_H
#define DMG_CRANKS_H

#include "core/build.h"

typedef struct dmg_crank {
    float throw, rod, angle; /* of the pin as drawn, from +X */
    float t;                 /* thickness of rods and webs */
    int bar;                 /* of the rod: plate, round, two bars and a web, tapered, forked */
    float eye;               /* radius of the rod's eyes; 0: none show */
} dmg_crank;

dmg_crank dmg_crank_pick(dmg_builder* b, float throw);
/* Where the slider's pin is while the crank stands at an angle. */
float dmg_crank_at(const dmg_crank* c, float angle);
dmg_vec dmg_crank_pin(const dmg_crank* c, float z);
/* Adds the slider with its true way; nothing is drawn. */
uint32_t dmg_crank_slider(dmg_builder* b, const dmg_crank* c, const char* name);
/* The rod, carried by the slider, in the plane z. */
uint32_t dmg_crank_rod(dmg_builder* b, const dmg_crank* c, uint32_t slider, float z);
/* A straight link between two pins about Z. */
void dmg_link_draw(dmg_builder* b, const dmg_crank* c, dmg_vec from, dmg_vec to);
/* A tube along `axis` from `at`: `bore` and `wall` are radii's. */
void dmg_tube_draw(dmg_builder* b, dmg_vec at, dmg_vec axis, float length, float bore, float wall);
/* A web or disc about Z that carries the pin, `thick` from z on; kind 0 … 3. */
void dmg_web_draw(dmg_builder* b, const dmg_crank* c, int kind, float z, float thick);

#endif
