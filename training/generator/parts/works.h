/* Declares what working machines share: prisms across the machine, road wheels, cabs with doors, hydraulic rams. */
#ifndef DMG_WORKS_H
#define DMG_WORKS_H

#include "core/build.h"

/* ---- shapes drawn in side view: outlines and lines are (z, y), counter-clockwise with +Z to the right ---- */

void dmg_side_prism(dmg_builder* b, const dmg_xy* outline, int count, float x0, float x1);
/* A sheet along a line, `width` wide about x = 0. */
void dmg_side_sheet(dmg_builder* b, const dmg_xy* line, int count, float thickness, float width);

/* ---- joints across the machine: positive raises what lies ahead (+Z); the axis has either sign ---- */

uint32_t dmg_hinge_across(dmg_builder* b, uint32_t parent, const char* name, dmg_vec origin, float lower, float upper);

/* ---- road wheels ---- */

typedef struct dmg_tyre {
    float radius, width;
    int kind, spokes;
    bool turns, steers; /* a wheel that steers does so on a knuckle, or is itself the part that steers */
    int knuckle;        /* 0 a block behind the wheel, 1 an upright pin above it, 2 the wheel itself */
} dmg_tyre;

dmg_tyre dmg_tyre_pick(dmg_builder* b, float radius);
/* Centred at (x, radius, z); the axle goes from there to `inner`. Leaves the parent in use. */
void dmg_tyre_draw(dmg_builder* b, const dmg_tyre* tyre, uint32_t parent, float x, float z, float inner);
/* One at either side, the axle between them on the parent. */
void dmg_axle_draw(dmg_builder* b, const dmg_tyre* tyre, uint32_t parent, float half, float z);

/* ---- a driver's cab between two corners ---- */

typedef struct dmg_cab {
    dmg_vec low, high;
    int shell;             /* block, sloped block with panes, posts with a roof, hollow with walls */
    bool left, right;      /* sides that have a door */
    bool back_hung, panes; /* hinges at the rear edge; doors in two panels */
    float slope;           /* of the screen, share of the length */
    float swing;
} dmg_cab;

dmg_cab dmg_cab_pick(dmg_builder* b, dmg_vec low, dmg_vec high);
/* On `parent`, which stays in use. */
void dmg_cab_draw(dmg_builder* b, const dmg_cab* cab, uint32_t parent);

/* ---- rams ---- */

typedef enum dmg_ram_kind {
    DMG_RAM_NONE,
    DMG_RAM_STILL,  /* the barrel is one with what carries it, the rod with what it moves */
    DMG_RAM_JOINTED /* the barrel swings on its pin, the rod slides in it */
} dmg_ram_kind;

dmg_ram_kind dmg_ram_pick(dmg_builder* b);
/* From a pin on `carrier` to one on `mover`, which is left in use; its pins lie across the machine. */
void dmg_ram_draw(dmg_builder* b, dmg_ram_kind kind, uint32_t carrier, uint32_t mover, dmg_vec from, dmg_vec to,
                  float radius);

#endif
