/* Little .glb files for tests: a JSON text and a binary chunk put into one container, or taken out of it. */
#ifndef DM_TEST_GLB_H
#define DM_TEST_GLB_H

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct test_glb {
    uint8_t* data; /* free() */
    size_t size;
} test_glb;

static inline void test_glb_u32(uint8_t* at, uint32_t value) {
    for (int i = 0; i < 4; i++) at[i] = (uint8_t)(value >> (8 * i));
}

/* bin NULL: no binary chunk. */
static inline test_glb test_glb_pack(const char* json, const void* bin, size_t bin_size) {
    const size_t text = strlen(json), json_size = (text + 3) & ~(size_t)3;
    const size_t padded = (bin_size + 3) & ~(size_t)3, bin_chunk = bin ? 8 + padded : 0;
    test_glb glb = {NULL, 12 + 8 + json_size + bin_chunk};
    glb.data = calloc(1, glb.size);
    memcpy(glb.data, "glTF", 4);
    test_glb_u32(glb.data + 4, 2);
    test_glb_u32(glb.data + 8, (uint32_t)glb.size);
    test_glb_u32(glb.data + 12, (uint32_t)json_size);
    memcpy(glb.data + 16, "JSON", 4);
    memset(glb.data + 20, ' ', json_size);
    memcpy(glb.data + 20, json, text);
    if (!bin) return glb;
    uint8_t* chunk = glb.data + 20 + json_size;
    test_glb_u32(chunk, (uint32_t)padded);
    memcpy(chunk + 4, "BIN", 4);
    memcpy(chunk + 8, bin, bin_size);
    return glb;
}

static inline uint32_t test_glb_json_size(const void* data) {
    uint32_t size;
    memcpy(&size, (const uint8_t*)data + 12, 4);
    return size;
}

/* The JSON text, ended by a NUL; free(). */
static inline char* test_glb_json(const void* data) {
    const uint32_t size = test_glb_json_size(data);
    char* json = calloc(1, (size_t)size + 1);
    memcpy(json, (const uint8_t*)data + 20, size);
    return json;
}

/* The binary chunk, inside the container. */
static inline const uint8_t* test_glb_bin(const void* data, uint32_t* out_size) {
    const uint8_t* chunk = (const uint8_t*)data + 20 + test_glb_json_size(data);
    memcpy(out_size, chunk, 4);
    return chunk + 8;
}

#endif
