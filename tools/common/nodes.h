/* Parts of an object made of the nodes of its file. */
#ifndef CLI_NODES_H
#define CLI_NODES_H

#include "session.h"

/* Position in the file's list of nodes with triangles that face `face` belongs to. */
uint32_t node_of_face(const dm_gltf* gltf, uint64_t face);
/* Writes the sides of the box around a node. */
void node_box_size(const session* session, uint32_t index, double out_size[3]);
/* Returns the node with the largest box, most likely the body. */
uint32_t largest_node(const session* session);
/* Part id of a node: 0 for `body`, else 1 + its position; of several entries of one bone, that of the first. */
uint16_t node_part_id(const session* session, uint32_t index, uint32_t body);
/* A part id a face. To be freed. */
uint16_t* node_part_ids(const session* session, uint32_t body);

#endif
