/* A glTF file opened as the nodes of an asset. */
#ifndef DM_TEST_GLTF_NODES_H
#define DM_TEST_GLTF_NODES_H

#include "test_glb.h"
#include "test_gltf.h"

typedef struct test_gltf_nodes {
    test_env t;
    dm_gltf* gltf;
    const dm_asset_node* nodes;
    uint32_t count;
} test_gltf_nodes;

static inline void test_gltf_nodes_open(test_gltf_nodes* o, const char* json, const void* bytes, size_t size) {
    const test_glb glb = test_glb_pack(json, bytes, size);
    *o = (test_gltf_nodes){.count = 0};
    test_env_open(&o->t, TEST_NEVER);
    o->gltf = test_gltf_open(&o->t, glb.data, glb.size);
    free(glb.data);
    assert_int_equal(dm_gltf_get_asset(o->gltf, 0, &o->nodes, &o->count), DM_OK);
}

static inline void test_gltf_nodes_close(test_gltf_nodes* o) {
    dm_gltf_close(o->gltf);
    test_env_close(&o->t);
}

/* Returns the place of a node in the list; fails the test where there is none. */
static inline uint32_t test_gltf_nodes_find(const test_gltf_nodes* o, const char* name) {
    for (uint32_t i = 0; i < o->count; i++)
        if (o->nodes[i].name && strcmp(o->nodes[i].name, name) == 0) return i;
    fail_msg("no node '%s'", name);
    return 0;
}

#endif
