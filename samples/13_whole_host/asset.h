/* A .glb as flat arrays, as an engine's importer leaves them in memory. */
#ifndef WHOLE_HOST_ASSET_H
#define WHOLE_HOST_ASSET_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct asset {
    const float* positions;   /* vertex_count x 3, scene frame, node transforms applied */
    const uint32_t* indices;  /* index_count, three a triangle */
    const uint32_t* part_ids; /* vertex_count; 0 is the body */
    uint64_t vertex_count, index_count;
    const char* const* names; /* part_count: the node of part 0 (the body), 1, 2 … */
    uint32_t part_count;
    void* storage; /* owns all of it */
} asset;

/* Reads the triangles of a file's default scene. The node called `body` stays; every other node with a mesh is a part,
 * and what hangs below a part belongs to it. Prints why and returns false where the file can't be read. */
bool asset_read(const char* path, const char* body, asset* out);
void asset_free(asset* asset);

#ifdef __cplusplus
}
#endif

#endif
