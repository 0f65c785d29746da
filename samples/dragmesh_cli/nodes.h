/* Parts of an object made of the nodes of its file. */
#ifndef CLI_NODES_H
#define CLI_NODES_H

#include "session.h"

/* Position in the file's list of nodes with triangles that face `face` belongs to. */
uint32_t node_of_face(const dm_gltf* gltf, uint64_t face);
/* Returns the node with the largest box, most likely the body. */
uint32_t largest_node(const session* session);
/* A part id a face: 0 for `body`, else 1 + the node's position. To be freed. */
uint16_t* node_part_ids(const session* session, uint32_t body);

#endif
