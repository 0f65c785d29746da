/* Adds segmentation errors to a part mask, for experiments: a patch of the part is lost, a patch of the rest leaks in.
 */
#ifndef CLI_MASK_NOISE_H
#define CLI_MASK_NOISE_H

#include "dragmesh/dragmesh.h"
#include "random.h"

/* vertex_ids: 1 a vertex of the part, else 0. `fraction` of the part's vertices change each way (at most a quarter of
 * the rest leaks). */
void mask_noise_apply(const float* positions, uint64_t vertex_count, double fraction, random_state* random,
                      uint8_t* vertex_ids);
/* Per face to per vertex: a vertex moves when one of its faces does. */
void mask_vertices_of_faces(const uint32_t* indices, uint64_t face_count, const uint8_t* face_ids,
                            uint64_t vertex_count, uint8_t* out_vertex_ids);

#endif
