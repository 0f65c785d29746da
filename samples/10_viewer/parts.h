/* Assignment of the file's faces to parts. */
#ifndef VIEWER_PARTS_H
#define VIEWER_PARTS_H

#include "world.h"

/* Assigns parts from lists of nodes: a list inside another is a part carried by it. */
int parts_from_names(world* world, const char* const* lists, uint32_t count);

/* Asks the library which nodes of the file move, and which of them as one: those are the parts. With `prepare` the
 * world's object becomes the one that the library makes of them; where nothing moves there is none, and the message
 * says so. Returns 0, or -1 with a line in message. */
int parts_from_asset(world* world, const char* file, int prepare);

/* Assigns every node but the largest, which is the body, to a part of its own, as viewers before 0.3 did. */
void parts_from_nodes(world* world);

/* Forgets all parts. */
void parts_clear(world* world);

/* From FILE.parts.npy, as parts_encode made it. */
int parts_load(world* world, const char* path);
/* Returns the bytes of such a file, to be freed. */
uint8_t* parts_encode(const world* world, size_t* out_size);

/* A new part without faces; its id, 0 when there are too many. */
uint32_t parts_add(world* world, const char* name);

/* Node that holds a face. */
uint32_t parts_node_of_face(const world* world, uint32_t face);

/* Toggles the node of a face: from body to a part of its own, from part to body. */
void parts_toggle_node(world* world, uint32_t face);

/* Assigns to `part` the faces with a corner within a radius of a point, or all connected to a face. Returns how many.
 */
uint32_t parts_paint(world* world, dm_vec3 point, float radius, uint32_t part);
uint32_t parts_fill(world* world, uint32_t face, uint32_t part);

/* Removes parts without faces; ids become consecutive. */
void parts_tidy(world* world);

#endif
