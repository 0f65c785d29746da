/* A scene as a .glb: one buffer, and for each part a node, a mesh, a colour and two accessors. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene.h"

enum { JSON_BYTES = 8192, GLB_MAGIC = 0x46546c67, GLB_VERSION = 2, CHUNK_JSON = 0x4e4f534a, CHUNK_BINARY = 0x004e4942 };
enum { GLB_HEADER = 12, CHUNK_HEADER = 8 }; /* bytes */

/* Text that grows inside a fixed room. */
typedef struct text {
    char bytes[JSON_BYTES];
    size_t length;
} text;

#define ADD(text, ...)                                                                                                 \
    ((text)->length += (size_t)snprintf((text)->bytes + (text)->length, JSON_BYTES - (text)->length, __VA_ARGS__))

/* Linear colours of the body and of the parts in turn. */
static const float colours[SCENE_PARTS + 1][3] = {
    {0.55f, 0.52f, 0.48f}, {0.33f, 0.19f, 0.09f}, {0.55f, 0.38f, 0.10f}, {0.10f, 0.22f, 0.35f}, {0.16f, 0.30f, 0.14f}};

static void add_parts(text* json, const scene* scene, const scene_mesh* mesh) {
    ADD(json, "\"nodes\":[");
    for (uint32_t i = 0; i <= scene->part_count; i++)
        ADD(json, "%s{\"mesh\":%u,\"name\":\"%s\"}", i ? "," : "", i, i ? scene->parts[i - 1].name : "body");
    ADD(json, "],\"meshes\":[");
    for (uint32_t i = 0; i <= scene->part_count; i++)
        ADD(json, "%s{\"primitives\":[{\"attributes\":{\"POSITION\":%u},\"indices\":%u,\"material\":%u}]}",
            i ? "," : "", 2 * i, 2 * i + 1, i);
    ADD(json, "],\"materials\":[");
    for (uint32_t i = 0; i <= scene->part_count; i++) {
        const float* c = colours[i];
        ADD(json, "%s{\"pbrMetallicRoughness\":{\"baseColorFactor\":[%g,%g,%g,1]}}", i ? "," : "", (double)c[0],
            (double)c[1], (double)c[2]);
    }
    ADD(json, "],\"accessors\":[");
    for (uint32_t i = 0; i <= scene->part_count; i++) {
        float low[3], high[3];
        for (int k = 0; k < 3; k++) low[k] = high[k] = mesh->positions[mesh->first_vertex[i]][k];
        for (uint32_t v = mesh->first_vertex[i]; v < mesh->first_vertex[i + 1]; v++) {
            for (int k = 0; k < 3; k++) {
                const float p = mesh->positions[v][k];
                low[k] = p < low[k] ? p : low[k], high[k] = p > high[k] ? p : high[k];
            }
        }
        ADD(json,
            "%s{\"bufferView\":0,\"byteOffset\":%zu,\"componentType\":5126,\"count\":%u,\"type\":\"VEC3\","
            "\"min\":[%.9g,%.9g,%.9g],\"max\":[%.9g,%.9g,%.9g]},"
            "{\"bufferView\":1,\"byteOffset\":%zu,\"componentType\":5125,\"count\":%u,\"type\":\"SCALAR\"}",
            i ? "," : "", sizeof *mesh->positions * mesh->first_vertex[i],
            mesh->first_vertex[i + 1] - mesh->first_vertex[i], (double)low[0], (double)low[1], (double)low[2],
            (double)high[0], (double)high[1], (double)high[2], sizeof *mesh->indices * mesh->first_index[i],
            mesh->first_index[i + 1] - mesh->first_index[i]);
    }
    ADD(json, "]");
}

static void write_json(text* json, const scene* scene, const scene_mesh* mesh) {
    const size_t positions = sizeof *mesh->positions * mesh->vertex_count;
    const size_t indices = sizeof *mesh->indices * mesh->index_count;
    json->length = 0;
    ADD(json, "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[");
    for (uint32_t i = 0; i <= scene->part_count; i++) ADD(json, "%s%u", i ? "," : "", i);
    ADD(json, "]}],");
    add_parts(json, scene, mesh);
    ADD(json, ",\"buffers\":[{\"byteLength\":%zu}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":%zu},",
        positions + indices, positions);
    ADD(json, "{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}]}", positions, indices);
    while (json->length % 4 != 0) ADD(json, " ");
}

static uint8_t* put(uint8_t* to, const void* bytes, size_t size) {
    memcpy(to, bytes, size);
    return to + size;
}

void* scene_glb(const scene* scene, size_t* out_size) {
    static text json;
    static scene_mesh mesh;
    scene_mesh_make(scene, &mesh);
    write_json(&json, scene, &mesh);
    /* Indices of a part count from its first vertex. */
    for (uint32_t part = 0; part <= scene->part_count; part++)
        for (uint32_t i = mesh.first_index[part]; i < mesh.first_index[part + 1]; i++)
            mesh.indices[i] -= mesh.first_vertex[part];
    const size_t positions = sizeof *mesh.positions * mesh.vertex_count;
    const size_t indices = sizeof *mesh.indices * mesh.index_count;
    *out_size = GLB_HEADER + 2 * CHUNK_HEADER + json.length + positions + indices;
    const uint32_t head[3] = {GLB_MAGIC, GLB_VERSION, (uint32_t)*out_size};
    const uint32_t text_head[2] = {(uint32_t)json.length, CHUNK_JSON};
    const uint32_t data_head[2] = {(uint32_t)(positions + indices), CHUNK_BINARY};
    uint8_t *bytes = malloc(*out_size), *to = bytes;
    if (bytes == NULL) return NULL;
    to = put(to, head, sizeof head);
    to = put(to, text_head, sizeof text_head);
    to = put(to, json.bytes, json.length);
    to = put(to, data_head, sizeof data_head);
    to = put(to, mesh.positions, positions);
    put(to, mesh.indices, indices);
    return bytes;
}
