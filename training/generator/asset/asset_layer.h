/* Declares the steps that turn a drawn object into an asset. Internal to the generator. Each draws its own chance and
 * works on the closed object, before dmg_finish, in the frame in which categories draw: +Y up, the front towards +Z. */
#ifndef DMG_ASSET_LAYER_H
#define DMG_ASSET_LAYER_H

#include "asset.h"
#include "core/build.h"

/* ---- removing (asset_remove.c) ---- */

typedef enum dmg_fate {
    DMG_KEPT,
    DMG_WELDED, /* becomes one with what carries it */
    DMG_DROPPED /* goes, with all that it carries */
} dmg_fate;

/* Gives every part its fate. fates: part_count, that of part i at i - 1. */
void dmg_part_fates(dmg_builder* b, dmg_fate fates[DMG_PART_LIMIT]);
/* Removes pieces with their vertices. drop: piece_count. */
void dmg_drop_pieces(dmg_builder* b, const bool* drop);

/* ---- what moves no more (asset_stills.c) ---- */

/* Removes all parts from some objects, so that nothing moves. Returns whether it did. */
bool dmg_make_still(dmg_builder* b);
/* Draws something without moving parts instead of the object: stairs, a fence, a monument (asset_scenes.c). */
void dmg_draw_scene(dmg_builder* b);
/* Turns some drawers into blind fronts and some leaves into fixed panels, welds some small parts to what carries them.
 */
void dmg_fix_parts(dmg_builder* b);

/* Cuts some boxes into boards, or into a frame and its infill (asset_boards.c). */
void dmg_cut_boards(dmg_builder* b);

/* ---- places on surfaces (asset_places.c) ---- */

typedef struct dmg_place {
    dmg_frame frame; /* origin on the surface, third column its normal, second column as far up as it goes */
    uint32_t part;   /* whose surface it is */
    float clearance; /* free way along the normal, at most 1e30 */
    float radius;    /* the surface is flat that far round the origin */
} dmg_place;

/* Follows a ray. Returns the distance to the first face, or 1e30; writes the face. direction: unit. */
float dmg_cast(const dmg_builder* b, dmg_vec origin, dmg_vec direction, uint32_t* out_face);
/* Draws a place, by area, among faces of the body (part 0) or of moving parts (part 1 and above: any of them) whose
 * normal's y is within the limits, flat and free for `radius` metres round it. Returns whether it found one. */
bool dmg_find_place(dmg_builder* b, bool on_body, float least_up, float most_up, float radius, dmg_place* out);
/* Whether a moving part other than `part`, or what carries it, sweeps the box. */
bool dmg_is_swept(const dmg_builder* b, uint32_t part, const dmg_bounds* box);
/* Enters the place's frame: what is drawn next stands on it, belongs to its part. Left with dmg_restore. */
void dmg_enter_place(dmg_builder* b, const dmg_place* place);

/* ---- additions ---- */

/* Puts things on shelves, on tops, into drawers and chests (asset_things.c). */
void dmg_add_things(dmg_builder* b);
/* Screws fixed hardware to surfaces: handles, plates, trims, hinge plates, feet, cables (asset_fixtures.c). */
void dmg_add_fixtures(dmg_builder* b);
/* Adds small moving parts that others carry: buttons, knobs, latches on doors, trays in drawers (asset_carried.c). */
void dmg_add_carried(dmg_builder* b);

/* ---- nodes ---- */

/* Deals the faces to nodes, one or many a part (asset_split.c). Allocates face_node and nodes; sets part, face_count,
 * loose and mesh, no names and identity transforms. Pieces first_thing to thing_end lie loose. Returns 0 on success. */
int dmg_split_nodes(dmg_builder* b, uint32_t first_thing, uint32_t thing_end, dmg_asset* asset);
/* Gives nodes and meshes names (asset_names.c). */
void dmg_name_nodes(dmg_builder* b, dmg_asset* asset);
/* Gives instances of one mesh one number and pivots at one place of it (asset_instances.c). Returns 0 on success. */
int dmg_share_meshes(dmg_asset* asset);
/* Puts empty nodes over the nodes and gives all of them pivots (asset_tree.c). Returns 0 on success. */
int dmg_plant_nodes(dmg_builder* b, dmg_asset* asset);

#endif
