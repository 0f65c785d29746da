/* Writes an asset as a .glb and its labels as JSON. */
#include "asset_file.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- labels ---- */

static void add_numbers(cJSON* to, const char* key, const float* values, int count) {
    cJSON* array = cJSON_AddArrayToObject(to, key);
    for (int i = 0; i < count; ++i) cJSON_AddItemToArray(array, cJSON_CreateNumber((double)values[i]));
}

static void add_limits(cJSON* to, const dmg_joint* joint) {
    if (joint->type == DM_JOINT_CONTINUOUS) {
        cJSON_AddNullToObject(to, "lower");
        cJSON_AddNullToObject(to, "upper");
    } else {
        cJSON_AddNumberToObject(to, "lower", (double)joint->lower);
        cJSON_AddNumberToObject(to, "upper", (double)joint->upper);
        cJSON_AddNumberToObject(to, "closed", (double)joint->closed);
    }
    cJSON_AddBoolToObject(to, "continuous", joint->type == DM_JOINT_CONTINUOUS);
    if (joint->type == DM_JOINT_SCREW) cJSON_AddNumberToObject(to, "pitch", (double)joint->pitch);
}

static cJSON* part_json(const dmg_asset* asset, uint32_t part) {
    const dmg_joint* joint = &asset->object.joints[part - 1];
    cJSON* out = cJSON_CreateObject();
    cJSON_AddStringToObject(out, "name", joint->name);
    cJSON* nodes = cJSON_AddArrayToObject(out, "nodes");
    for (uint32_t i = 0; i < asset->node_count; ++i)
        if (asset->nodes[i].face_count > 0 && asset->nodes[i].part == part)
            cJSON_AddItemToArray(nodes, cJSON_CreateString(asset->nodes[i].name));
    if (joint->parent == 0)
        cJSON_AddNullToObject(out, "parent");
    else
        cJSON_AddNumberToObject(out, "parent", joint->parent - 1);
    cJSON_AddStringToObject(out, "type", joint->type == DM_JOINT_PRISMATIC ? "prismatic" : "revolute");
    add_numbers(out, "axis", joint->axis, 3);
    add_numbers(out, "origin", joint->origin, 3);
    add_limits(out, joint);
    return out;
}

static void add_labels(cJSON* root, const dmg_asset* asset) {
    cJSON *nodes = cJSON_AddObjectToObject(root, "nodes"), *loose = cJSON_AddArrayToObject(root, "loose");
    for (uint32_t i = 0; i < asset->node_count; ++i) {
        const dmg_asset_node* node = &asset->nodes[i];
        if (node->face_count == 0) continue;
        cJSON_AddStringToObject(nodes, node->name, node->part == 0 ? "static" : "mover");
        if (node->loose) cJSON_AddItemToArray(loose, cJSON_CreateString(node->name));
    }
    cJSON* parts = cJSON_AddArrayToObject(root, "parts");
    for (uint32_t part = 1; part <= asset->object.joint_count; ++part)
        cJSON_AddItemToArray(parts, part_json(asset, part));
}

char* asset_json(const dmg_asset* asset, uint64_t seed, uint32_t flags) {
    char name[96];
    snprintf(name, sizeof name, "%s_%llu%s", asset->object.category, (unsigned long long)seed,
             flags & DMG_MESSY ? "_messy" : "");
    cJSON* root = cJSON_CreateObject();
    cJSON_AddStringToObject(root, "id", name);
    cJSON_AddStringToObject(root, "source", "dragmesh_generate");
    cJSON_AddStringToObject(root, "path", "training/generator");
    cJSON_AddStringToObject(root, "license", "MIT");
    cJSON_AddStringToObject(root, "category", asset->object.joint_count > 0 ? asset->object.category : "static");
    cJSON_AddStringToObject(root, "family", asset->object.category);
    cJSON_AddStringToObject(root, "up", flags & DMG_MESSY ? "unknown" : "y");
    cJSON_AddStringToObject(root, "units", "m");
    cJSON_AddNumberToObject(root, "largest_dimension", (double)dmg_object_size(&asset->object));
    cJSON_AddStringToObject(root, "set", asset->object.joint_count == 0 ? "static" : "objects");
    cJSON_AddBoolToObject(root, "complete", 1);
    add_labels(root, asset);
    char* text = cJSON_Print(root);
    cJSON_Delete(root);
    return text;
}

/* ---- the scene ---- */

typedef struct scene {
    const dmg_asset* asset;
    cJSON *meshes, *accessors, *views;
    unsigned char* bytes;
    size_t size;
    uint32_t* remap; /* of vertices, for the mesh that is written */
} scene;

/* Writes x in the frame of a transform whose axes are at right angles and of one length. */
static void to_local(const float transform[16], const float x[3], float out[3]) {
    for (int k = 0; k < 3; ++k) {
        const float* axis = transform + 4 * k;
        float along = 0.0f, square = 0.0f;
        for (int i = 0; i < 3; ++i) {
            along += axis[i] * (x[i] - transform[12 + i]);
            square += axis[i] * axis[i];
        }
        out[k] = along / square;
    }
}

static void vector_to_local(const float transform[16], const float x[3], float out[3]) {
    float from[3];
    for (int k = 0; k < 3; ++k) from[k] = x[k] + transform[12 + k];
    to_local(transform, from, out);
}

/* Adds a view and an accessor of the bytes that were written since `from`. Returns the accessor. */
static cJSON* add_accessor(scene* s, size_t from, int component, uint32_t count, const char* type) {
    cJSON *view = cJSON_CreateObject(), *accessor = cJSON_CreateObject();
    cJSON_AddNumberToObject(view, "buffer", 0);
    cJSON_AddNumberToObject(view, "byteOffset", (double)from);
    cJSON_AddNumberToObject(view, "byteLength", (double)(s->size - from));
    cJSON_AddNumberToObject(accessor, "bufferView", cJSON_GetArraySize(s->views));
    cJSON_AddNumberToObject(accessor, "componentType", component);
    cJSON_AddNumberToObject(accessor, "count", count);
    cJSON_AddStringToObject(accessor, "type", type);
    cJSON_AddItemToArray(s->views, view);
    cJSON_AddItemToArray(s->accessors, accessor);
    return accessor;
}

/* Writes the positions of a node's vertices in its own frame; fills remap. Returns their number. */
static uint32_t put_positions(scene* s, uint32_t node, float low[3], float high[3]) {
    const dmg_object* object = &s->asset->object;
    uint32_t count = 0;
    for (int k = 0; k < 3; ++k) low[k] = HUGE_VALF, high[k] = -HUGE_VALF;
    memset(s->remap, 0xff, (object->vertex_count + 1) * sizeof *s->remap);
    for (uint32_t i = 0; i < 3 * object->face_count; ++i) {
        const uint32_t v = object->indices[i];
        if (s->asset->face_node[i / 3] != node || s->remap[v] != UINT32_MAX) continue;
        float at[3];
        to_local(s->asset->nodes[node].transform, object->positions + 3 * (size_t)v, at);
        for (int k = 0; k < 3; ++k) low[k] = fminf(low[k], at[k]), high[k] = fmaxf(high[k], at[k]);
        memcpy(s->bytes + s->size, at, sizeof at);
        s->size += sizeof at;
        s->remap[v] = count++;
    }
    return count;
}

static void put_indices(scene* s, uint32_t node) {
    const dmg_object* object = &s->asset->object;
    for (uint32_t i = 0; i < 3 * object->face_count; ++i) {
        if (s->asset->face_node[i / 3] != node) continue;
        memcpy(s->bytes + s->size, &s->remap[object->indices[i]], sizeof(uint32_t));
        s->size += sizeof(uint32_t);
    }
}

/* Adds the mesh of a node. */
static void add_mesh(scene* s, uint32_t node) {
    enum { FLOAT = 5126, UNSIGNED_INT = 5125 };
    float low[3], high[3];
    size_t from = s->size;
    const uint32_t count = put_positions(s, node, low, high);
    cJSON* positions = add_accessor(s, from, FLOAT, count, "VEC3");
    add_numbers(positions, "min", low, 3);
    add_numbers(positions, "max", high, 3);
    from = s->size;
    put_indices(s, node);
    add_accessor(s, from, UNSIGNED_INT, 3 * s->asset->nodes[node].face_count, "SCALAR");
    cJSON *mesh = cJSON_CreateObject(), *primitive = cJSON_CreateObject();
    const int last = cJSON_GetArraySize(s->accessors) - 1;
    if (s->asset->nodes[node].mesh_name[0]) cJSON_AddStringToObject(mesh, "name", s->asset->nodes[node].mesh_name);
    cJSON_AddNumberToObject(cJSON_AddObjectToObject(primitive, "attributes"), "POSITION", last - 1);
    cJSON_AddNumberToObject(primitive, "indices", last);
    cJSON_AddItemToArray(cJSON_AddArrayToObject(mesh, "primitives"), primitive);
    cJSON_AddItemToArray(s->meshes, mesh);
}

/* Adds where a node is below its parent. */
static void add_placement(cJSON* out, const dmg_asset* asset, const dmg_asset_node* node) {
    float local[16];
    memcpy(local, node->transform, sizeof local);
    if (node->parent != DMG_NO_NODE) {
        const float* above = asset->nodes[node->parent].transform;
        for (int column = 0; column < 3; ++column)
            vector_to_local(above, node->transform + 4 * column, local + 4 * column);
        to_local(above, node->transform + 12, local + 12);
    }
    static const float one[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    float off = 0.0f;
    for (int i = 0; i < 12; ++i) off = fmaxf(off, fabsf(local[i] - one[i]));
    if (off > 1e-6f)
        add_numbers(out, "matrix", local, 16);
    else if (local[12] != 0.0f || local[13] != 0.0f || local[14] != 0.0f)
        add_numbers(out, "translation", local + 12, 3);
}

static cJSON* node_json(const dmg_asset* asset, uint32_t index, const uint32_t* mesh_of) {
    const dmg_asset_node* node = &asset->nodes[index];
    cJSON *out = cJSON_CreateObject(), *children = cJSON_CreateArray();
    if (node->name[0]) cJSON_AddStringToObject(out, "name", node->name);
    if (node->face_count > 0) cJSON_AddNumberToObject(out, "mesh", mesh_of[node->mesh]);
    add_placement(out, asset, node);
    for (uint32_t i = 0; i < asset->node_count; ++i)
        if (asset->nodes[i].parent == index) cJSON_AddItemToArray(children, cJSON_CreateNumber(i));
    if (cJSON_GetArraySize(children) > 0)
        cJSON_AddItemToObject(out, "children", children);
    else
        cJSON_Delete(children);
    return out;
}

/* Returns the document; writes the meshes into the scene's bytes. */
static cJSON* document(scene* s, uint32_t* mesh_of) {
    const dmg_asset* asset = s->asset;
    cJSON *root = cJSON_CreateObject(), *nodes = cJSON_CreateArray(), *roots = cJSON_CreateArray();
    cJSON_AddStringToObject(cJSON_AddObjectToObject(root, "asset"), "version", "2.0");
    s->meshes = cJSON_AddArrayToObject(root, "meshes");
    s->accessors = cJSON_AddArrayToObject(root, "accessors");
    s->views = cJSON_AddArrayToObject(root, "bufferViews");
    for (uint32_t i = 0; i < asset->node_count; ++i) {
        const dmg_asset_node* node = &asset->nodes[i];
        if (node->face_count > 0 && mesh_of[node->mesh] == UINT32_MAX) {
            mesh_of[node->mesh] = (uint32_t)cJSON_GetArraySize(s->meshes);
            add_mesh(s, i);
        }
        cJSON_AddItemToArray(nodes, node_json(asset, i, mesh_of));
        if (node->parent == DMG_NO_NODE) cJSON_AddItemToArray(roots, cJSON_CreateNumber(i));
    }
    cJSON_AddItemToObject(root, "nodes", nodes);
    cJSON *scenes = cJSON_AddArrayToObject(root, "scenes"), *first = cJSON_CreateObject();
    cJSON_AddItemToObject(first, "nodes", roots);
    cJSON_AddItemToArray(scenes, first);
    cJSON_AddNumberToObject(root, "scene", 0);
    cJSON* buffer = cJSON_CreateObject();
    cJSON_AddNumberToObject(buffer, "byteLength", (double)s->size);
    cJSON_AddItemToArray(cJSON_AddArrayToObject(root, "buffers"), buffer);
    return root;
}

static unsigned char* put_u32(unsigned char* to, size_t value) {
    for (int i = 0; i < 4; ++i) to[i] = (unsigned char)(value >> (8 * i));
    return to + 4;
}

/* Joins the text and the bytes to a .glb. */
static void* pack(const char* text, const unsigned char* bytes, size_t size, size_t* out_size) {
    enum { GLTF = 0x46546C67, JSON = 0x4E4F534A, BIN = 0x004E4942, HEADER = 12, CHUNK = 8 };
    const size_t length = strlen(text), padded = (length + 3) & ~(size_t)3;
    *out_size = HEADER + CHUNK + padded + CHUNK + size;
    unsigned char* out = malloc(*out_size);
    if (!out) return NULL;
    unsigned char* at = put_u32(put_u32(put_u32(out, GLTF), 2), *out_size);
    at = put_u32(put_u32(at, padded), JSON);
    memset(at, ' ', padded);
    memcpy(at, text, length);
    at = put_u32(put_u32(at + padded, size), BIN);
    memcpy(at, bytes, size);
    return out;
}

void* asset_glb(const dmg_asset* asset, size_t* out_size) {
    const size_t corners = 3 * (size_t)asset->object.face_count;
    scene s = {.asset = asset};
    void* out = NULL;
    s.bytes = malloc(corners * (3 * sizeof(float) + sizeof(uint32_t)));
    s.remap = malloc(((size_t)asset->object.vertex_count + 1) * sizeof *s.remap);
    uint32_t* mesh_of = malloc((asset->node_count + 1) * sizeof *mesh_of);
    if (s.bytes && s.remap && mesh_of) {
        memset(mesh_of, 0xff, (asset->node_count + 1) * sizeof *mesh_of);
        cJSON* root = document(&s, mesh_of);
        char* text = cJSON_PrintUnformatted(root);
        cJSON_Delete(root);
        if (text) out = pack(text, s.bytes, s.size, out_size);
        free(text);
    }
    free(s.bytes);
    free(s.remap);
    free(mesh_of);
    return out;
}
