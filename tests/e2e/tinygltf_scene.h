/* A glTF file as tinygltf reads it: what a second, independent reader says of its nodes. */
#ifndef DM_TINYGLTF_SCENE_H
#define DM_TINYGLTF_SCENE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A node with a mesh that the default scene holds. */
typedef struct tinygltf_node {
    const char* name;
    uint32_t node;         /* its index in the file */
    double to_scene[16];   /* column-major */
    const double* corners; /* corner_count x 3, scene frame */
    uint64_t corner_count; /* three a triangle, in the order of the file */
} tinygltf_node;

typedef struct tinygltf_scene {
    const tinygltf_node* nodes; /* by their indices in the file */
    uint32_t node_count;
    void* storage;
} tinygltf_scene;

/* Returns NULL, or what tinygltf can't read; valid until the next call. */
const char* tinygltf_scene_read(const char* path, tinygltf_scene* out);
void tinygltf_scene_free(tinygltf_scene* scene);

#ifdef __cplusplus
}
#endif

#endif
