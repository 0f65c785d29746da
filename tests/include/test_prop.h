/* A cabinet with a door and a handle, written in the ways in which props are shipped. Every way has the same triangles
 * in the scene: a body, a door at its front, a handle on the door.
 *
 *     test_prop p;
 *     test_prop_make(&p, TEST_PROP_SKIN);
 *     ... p.data, p.size, p.beside, p.beside_size ...
 *     test_prop_free(&p); */
#ifndef DM_TEST_PROP_H
#define DM_TEST_PROP_H

#include <stdio.h>

#include <cjson/cJSON.h>

#if !defined(DMI_NO_MESHOPT)
#include <meshoptimizer/meshoptimizer.h>
#endif

#include "test_glb.h"

typedef enum test_prop_way {
    TEST_PROP_PLAIN,
    TEST_PROP_BESIDE,     /* .gltf and a .bin in a folder beside it */
    TEST_PROP_EMBEDDED,   /* .gltf with a data: URI */
    TEST_PROP_SKIN,       /* one mesh, bones named body, door and handle */
    TEST_PROP_CHILD,      /* the handle is a child of the door */
    TEST_PROP_MIRRORED,   /* below a node of negative scale */
    TEST_PROP_STRETCHED,  /* below a turned node of uneven scale */
    TEST_PROP_QUANTISED,  /* KHR_mesh_quantization, required */
    TEST_PROP_MESHOPT,    /* EXT_meshopt_compression, required */
    TEST_PROP_DRACO,      /* KHR_draco_mesh_compression, required, of the door */
    TEST_PROP_PRIMITIVES, /* a primitive a box, with materials, all of one vertex buffer */
    TEST_PROP_COLLIDERS,  /* with nodes for collisions and an invisible one */
    TEST_PROP_FAR,        /* in centimetres, 80 km from the origin */
    TEST_PROP_WAYS
} test_prop_way;

/* What the pieces are, in metres: boxes from low to high. */
enum { TEST_PROP_BODY, TEST_PROP_DOOR, TEST_PROP_HANDLE, TEST_PROP_PIECES };
static const float test_prop_low[TEST_PROP_PIECES][3] = {
    {-0.3f, 0, -0.2f}, {-0.298f, 0.005f, 0.182f}, {0.24f, 0.25f, 0.2f}};
static const float test_prop_high[TEST_PROP_PIECES][3] = {
    {0.3f, 0.8f, 0.18f}, {0.298f, 0.56f, 0.2f}, {0.26f, 0.35f, 0.23f}};
static const char* const test_prop_names[TEST_PROP_PIECES] = {"body", "door", "handle"};
static const double test_prop_far[3] = {8e6, 0, -8e6}; /* cm */

typedef struct test_prop {
    uint8_t* data; /* of the .glb or .gltf */
    size_t size;
    uint8_t* beside; /* "parts/the cabinet.bin"; NULL: none */
    size_t beside_size;
    double unit; /* of the scene, in metres: 1, or 0.01 */
    int flipped; /* triangles turn the other way round */
    cJSON* json;
    uint8_t bin[1 << 13];
    size_t bin_size;
} test_prop;

enum { TEST_PROP_CORNERS = 36 };
static const uint16_t test_prop_box[TEST_PROP_CORNERS] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                                          2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};

/* ---- pieces of a document ---- */

static inline cJSON* test_prop_list(test_prop* p, const char* name) {
    cJSON* list = cJSON_GetObjectItem(p->json, name);
    return list ? list : cJSON_AddArrayToObject(p->json, name);
}

/* Appends the JSON text to a list of the document. Returns its index. */
static inline int test_prop_add(test_prop* p, const char* list, const char* text) {
    cJSON* item = cJSON_Parse(text);
    if (!item) abort();
    cJSON_AddItemToArray(test_prop_list(p, list), item);
    return cJSON_GetArraySize(test_prop_list(p, list)) - 1;
}

static inline size_t test_prop_bytes(test_prop* p, const void* data, size_t size) {
    const size_t at = (p->bin_size + 3) & ~(size_t)3;
    if (at + size > sizeof p->bin) abort();
    memcpy(p->bin + at, data, size);
    p->bin_size = at + size;
    return at;
}

static inline int test_prop_view(test_prop* p, const void* data, size_t size, const char* more) {
    char text[256];
    snprintf(text, sizeof text, "{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu%s}",
             test_prop_bytes(p, data, size), size, more);
    return test_prop_add(p, "bufferViews", text);
}

static inline int test_prop_accessor(test_prop* p, int view, int type, size_t count, const char* shape,
                                     const char* more) {
    char text[512], from[32] = "";
    if (view >= 0) snprintf(from, sizeof from, "\"bufferView\":%d,", view);
    snprintf(text, sizeof text, "{%s\"componentType\":%d,\"count\":%zu,\"type\":\"%s\"%s}", from, type, count, shape,
             more);
    return test_prop_add(p, "accessors", text);
}

/* min and max of positions, as members. */
static inline void test_prop_limits(const float (*v)[3], size_t count, char out[256]) {
    float low[3], high[3];
    for (int k = 0; k < 3; k++) {
        low[k] = high[k] = v[0][k];
        for (size_t i = 1; i < count; i++) {
            low[k] = v[i][k] < low[k] ? v[i][k] : low[k];
            high[k] = v[i][k] > high[k] ? v[i][k] : high[k];
        }
    }
    snprintf(out, 256, ",\"min\":[%.9g,%.9g,%.9g],\"max\":[%.9g,%.9g,%.9g]", (double)low[0], (double)low[1],
             (double)low[2], (double)high[0], (double)high[1], (double)high[2]);
}

static inline int test_prop_positions(test_prop* p, const float (*v)[3], size_t count) {
    char limits[256];
    test_prop_limits(v, count, limits);
    return test_prop_accessor(p, test_prop_view(p, v, count * sizeof *v, ",\"target\":34962"), 5126, count, "VEC3",
                              limits);
}

/* Corners of boxes whose vertices lie one after another, from vertex `first` on. */
static inline int test_prop_indices(test_prop* p, int first, int boxes) {
    uint16_t list[TEST_PROP_PIECES * TEST_PROP_CORNERS];
    for (int i = 0; i < boxes * TEST_PROP_CORNERS; i++)
        list[p->flipped ? i / 3 * 3 + 2 - i % 3 : i] =
            (uint16_t)(first + 8 * (i / TEST_PROP_CORNERS) + test_prop_box[i % TEST_PROP_CORNERS]);
    const size_t count = (size_t)boxes * TEST_PROP_CORNERS;
    return test_prop_accessor(p, test_prop_view(p, list, count * 2, ",\"target\":34963"), 5123, count, "SCALAR", "");
}

/* The 8 vertices of a piece. */
static inline void test_prop_vertices(int piece, float out[8][3]) {
    for (int i = 0; i < 8; i++) {
        for (int k = 0; k < 3; k++) out[i][k] = (i >> k & 1 ? test_prop_high : test_prop_low)[piece][k];
    }
}

static inline int test_prop_mesh(test_prop* p, const float (*v)[3]) {
    char text[160];
    snprintf(text, sizeof text,
             "{\"primitives\":[{\"attributes\":{\"POSITION\":%d},\"indices\":%d}],\"extras\":{\"kept\":0.1}}",
             test_prop_positions(p, v, 8), test_prop_indices(p, 0, 1));
    return test_prop_add(p, "meshes", text);
}

/* A node of one piece. fields: members after its name and mesh. */
static inline int test_prop_node(test_prop* p, int piece, int mesh, const char* fields) {
    char text[512];
    snprintf(text, sizeof text, "{\"name\":\"%s\",\"mesh\":%d%s}", test_prop_names[piece], mesh, fields);
    return test_prop_add(p, "nodes", text);
}

/* A node a piece, whose vertices `place` (NULL: nothing) has moved before. */
static inline void test_prop_nodes(test_prop* p, void (*place)(float v[3])) {
    for (int piece = 0; piece < TEST_PROP_PIECES; piece++) {
        float v[8][3];
        test_prop_vertices(piece, v);
        for (int i = 0; place && i < 8; i++) place(v[i]);
        test_prop_node(p, piece, test_prop_mesh(p, (const float(*)[3])v), "");
    }
}

static inline void test_prop_roots(test_prop* p, const char* roots) {
    char text[64];
    snprintf(text, sizeof text, "{\"nodes\":[%s]}", roots);
    test_prop_add(p, "scenes", text);
    cJSON_AddNumberToObject(p->json, "scene", 0);
}

static inline void test_prop_require(test_prop* p, const char* extension) {
    cJSON_AddItemToArray(test_prop_list(p, "extensionsUsed"), cJSON_CreateString(extension));
    cJSON_AddItemToArray(test_prop_list(p, "extensionsRequired"), cJSON_CreateString(extension));
}

/* ---- the ways ---- */

/* Bones stand at the hinge and at the handle; the mesh lies elsewhere, and so does its node, which a skin ignores. */
static inline void test_prop_skin(test_prop* p) {
    float v[24][3], weights[24][4] = {{0}}, inverse[3][16];
    uint8_t joints[24][4] = {{0}};
    const float bones[3][3] = {{0, 0, 0}, {-0.298f, 0, 0.19f}, {0.25f, 0.3f, 0.2f}};
    for (int i = 0; i < 24; i++) {
        float piece[8][3];
        test_prop_vertices(i / 8, piece);
        for (int k = 0; k < 3; k++) v[i][k] = piece[i % 8][k] + (float)k; /* the bind pose is (0, 1, 2) aside */
        joints[i][0] = (uint8_t)(i / 8);
        weights[i][0] = 1;
    }
    for (int b = 0; b < 3; b++) {
        for (int i = 0; i < 16; i++) inverse[b][i] = i % 5 == 0;
        for (int k = 0; k < 3; k++) inverse[b][12 + k] = -bones[b][k] - (float)k;
    }
    char text[256];
    const int positions = test_prop_positions(p, (const float(*)[3])v, 24), indices = test_prop_indices(p, 0, 3);
    const int bone =
        test_prop_accessor(p, test_prop_view(p, joints, sizeof joints, ",\"target\":34962"), 5121, 24, "VEC4", "");
    const int weight =
        test_prop_accessor(p, test_prop_view(p, weights, sizeof weights, ",\"target\":34962"), 5126, 24, "VEC4", "");
    const int matrices = test_prop_accessor(p, test_prop_view(p, inverse, sizeof inverse, ""), 5126, 3, "MAT4", "");
    snprintf(text, sizeof text,
             "{\"primitives\":[{\"attributes\":{\"POSITION\":%d,\"JOINTS_0\":%d,\"WEIGHTS_0\":%d},\"indices\":%d}]}",
             positions, bone, weight, indices);
    test_prop_add(p, "meshes", text);
    snprintf(text, sizeof text, "{\"joints\":[1,2,3],\"inverseBindMatrices\":%d}", matrices);
    test_prop_add(p, "skins", text);
    test_prop_add(p, "nodes", "{\"name\":\"cabinet\",\"mesh\":0,\"skin\":0,\"translation\":[5,5,5]}");
    test_prop_add(p, "nodes", "{\"name\":\"body\",\"children\":[2]}");
    test_prop_add(p, "nodes", "{\"name\":\"door\",\"translation\":[-0.298,0,0.19],\"children\":[3]}");
    test_prop_add(p, "nodes", "{\"name\":\"handle\",\"translation\":[0.548,0.3,0.01]}");
    test_prop_roots(p, "0,1");
}

static inline void test_prop_mirror(float v[3]) {
    v[0] = -v[0];
}

/* The inverse of a turn by a right angle about z and a scale of 2, 1, 0.5 after it. */
static inline void test_prop_stretch(float v[3]) {
    const float x = v[0] / 2, y = v[1];
    v[0] = y;
    v[1] = -x;
    v[2] *= 2;
}

static inline void test_prop_child(test_prop* p) {
    test_prop_nodes(p, NULL);
    cJSON* door = cJSON_GetArrayItem(test_prop_list(p, "nodes"), TEST_PROP_DOOR);
    cJSON_AddItemToObject(door, "children", cJSON_Parse("[2,3]"));
    test_prop_add(p, "nodes", "{\"name\":\"socket\",\"translation\":[0.25,0.3,0.2]}");
    test_prop_roots(p, "0,1");
}

/* Corners of the unit box in 16-bit steps, 8 bytes a vertex. */
static inline void test_prop_quantise(uint16_t out[8][4]) {
    for (int i = 0; i < 8; i++) {
        for (int k = 0; k < 4; k++) out[i][k] = k < 3 && (i >> k & 1) ? 65535 : 0;
    }
}

/* The node that takes the normalised box to its place. */
static inline void test_prop_quantised_node(test_prop* p, int piece, int positions) {
    char text[256], fields[256];
    const float *low = test_prop_low[piece], *high = test_prop_high[piece];
    snprintf(text, sizeof text, "{\"primitives\":[{\"attributes\":{\"POSITION\":%d},\"indices\":%d}]}", positions,
             test_prop_indices(p, 0, 1));
    snprintf(fields, sizeof fields, ",\"translation\":[%.9g,%.9g,%.9g],\"scale\":[%.9g,%.9g,%.9g]", (double)low[0],
             (double)low[1], (double)low[2], (double)(high[0] - low[0]), (double)(high[1] - low[1]),
             (double)(high[2] - low[2]));
    test_prop_node(p, piece, test_prop_add(p, "meshes", text), fields);
}

#define TEST_PROP_STEPS ",\"normalized\":true,\"min\":[0,0,0],\"max\":[65535,65535,65535]"

static inline void test_prop_quantised(test_prop* p) {
    for (int piece = 0; piece < TEST_PROP_PIECES; piece++) {
        uint16_t v[8][4];
        test_prop_quantise(v);
        const int view = test_prop_view(p, v, sizeof v, ",\"byteStride\":8,\"target\":34962");
        test_prop_quantised_node(p, piece, test_prop_accessor(p, view, 5123, 8, "VEC3", TEST_PROP_STEPS));
    }
    test_prop_require(p, "KHR_mesh_quantization");
}

#if !defined(DMI_NO_MESHOPT)
/* The decompressed bytes have no place but in a buffer without any, as gltfpack writes it. */
static inline void test_prop_meshopt(test_prop* p, const char* extension) {
    for (int piece = 0; piece < TEST_PROP_PIECES; piece++) {
        uint16_t v[8][4];
        uint8_t packed[256];
        char text[512];
        test_prop_quantise(v);
        const size_t size = meshopt_encodeVertexBuffer(packed, sizeof packed, v, 8, 8);
        const size_t at = test_prop_bytes(p, packed, size);
        snprintf(text, sizeof text,
                 "{\"buffer\":1,\"byteOffset\":%d,\"byteLength\":64,\"byteStride\":8,\"target\":34962,\"extensions\":{"
                 "\"%s\":{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu,\"byteStride\":8,\"count\":8,\"mode\":"
                 "\"ATTRIBUTES\"}}}",
                 64 * piece, extension, at, size);
        const int view = test_prop_add(p, "bufferViews", text);
        test_prop_quantised_node(p, piece, test_prop_accessor(p, view, 5123, 8, "VEC3", TEST_PROP_STEPS));
    }
    char text[160];
    snprintf(text, sizeof text, "{\"byteLength\":192,\"extensions\":{\"%s\":{\"fallback\":true}}}", extension);
    test_prop_add(p, "buffers", text);
    test_prop_require(p, extension);
    test_prop_require(p, "KHR_mesh_quantization");
}
#endif

/* Door and handle, encoded once by Draco 1.5.5 at speed 0 and 14 bits a coordinate: 16 points, 24 faces. */
static const uint8_t test_prop_draco_stream[] = {
    0x44, 0x52, 0x41, 0x43, 0x4f, 0x02, 0x02, 0x01, 0x01, 0x00, 0x00, 0x00, 0x10, 0x18, 0x00, 0x16, 0x00, 0x00,
    0x06, 0x5f, 0x4b, 0x95, 0xaf, 0xa5, 0x0a, 0x01, 0x01, 0x20, 0x01, 0xff, 0x00, 0x01, 0x01, 0x00, 0x09, 0x03,
    0x00, 0x00, 0x02, 0x01, 0x01, 0x01, 0x00, 0x0f, 0x07, 0x01, 0x04, 0x1b, 0x01, 0x04, 0x01, 0x04, 0x01, 0x14,
    0x01, 0x18, 0x01, 0x08, 0x07, 0x00, 0x06, 0x50, 0xfa, 0xb8, 0xbe, 0x81, 0x75, 0x8c, 0x27, 0xed, 0xa4, 0x28,
    0x11, 0xbc, 0x0a, 0x00, 0x92, 0x08, 0x00, 0x00, 0x24, 0x91, 0xbb, 0xfa, 0x66, 0x94, 0xc8, 0x5d, 0x05, 0x00,
    0x4a, 0x04, 0xaf, 0x7a, 0x8f, 0x24, 0x72, 0x57, 0xdf, 0x8c, 0x12, 0xc1, 0xab, 0x70, 0x86, 0x05, 0xe9, 0xa4,
    0xdf, 0x8c, 0x00, 0x78, 0x46, 0x00, 0x10, 0x04, 0xa0, 0x19, 0xbb, 0x07, 0x00, 0xa0, 0x11, 0x00, 0x02, 0xe0,
    0x19, 0x01, 0x00, 0x00, 0xa0, 0xb1, 0x7b, 0x02, 0x00, 0xc0, 0x7b, 0x00, 0x00, 0x00, 0x00, 0xff, 0x3f, 0x00,
    0x00, 0x75, 0x93, 0x98, 0xbe, 0x0a, 0xd7, 0xa3, 0x3b, 0x35, 0x5e, 0x3a, 0x3e, 0x75, 0x93, 0x18, 0x3f, 0x0e,
};

static inline void test_prop_draco(test_prop* p) {
    float v[8][3], low[3], high[3];
    char text[512], limits[256];
    test_prop_vertices(TEST_PROP_BODY, v);
    test_prop_node(p, TEST_PROP_BODY, test_prop_mesh(p, (const float(*)[3])v), "");
    for (int k = 0; k < 3; k++) {
        low[k] = test_prop_low[TEST_PROP_DOOR][k];
        high[k] = test_prop_high[k == 2 ? TEST_PROP_HANDLE : TEST_PROP_DOOR][k];
    }
    snprintf(limits, sizeof limits, ",\"min\":[%.9g,%.9g,%.9g],\"max\":[%.9g,%.9g,%.9g]", (double)low[0],
             (double)low[1], (double)low[2], (double)high[0], (double)high[1], (double)high[2]);
    const int view = test_prop_view(p, test_prop_draco_stream, sizeof test_prop_draco_stream, "");
    snprintf(text, sizeof text,
             "{\"primitives\":[{\"attributes\":{\"POSITION\":%d},\"indices\":%d,\"extensions\":{"
             "\"KHR_draco_mesh_compression\":{\"bufferView\":%d,\"attributes\":{\"POSITION\":0}}}}]}",
             test_prop_accessor(p, -1, 5126, 16, "VEC3", limits), test_prop_accessor(p, -1, 5125, 72, "SCALAR", ""),
             view);
    test_prop_node(p, TEST_PROP_DOOR, test_prop_add(p, "meshes", text), "");
    test_prop_require(p, "KHR_draco_mesh_compression");
}

static inline void test_prop_primitives(test_prop* p) {
    float v[24][3];
    char text[512];
    for (int piece = 0; piece < TEST_PROP_PIECES; piece++) test_prop_vertices(piece, v + 8 * piece);
    const int positions = test_prop_positions(p, (const float(*)[3])v, 24);
    test_prop_add(p, "materials", "{\"name\":\"wood\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0.25,0,1]}}");
    test_prop_add(p, "materials", "{\"name\":\"brass\"}");
    snprintf(text, sizeof text, "{\"primitives\":[{\"attributes\":{\"POSITION\":%d},\"indices\":%d,\"material\":0}]}",
             positions, test_prop_indices(p, 0, 1));
    test_prop_node(p, TEST_PROP_BODY, test_prop_add(p, "meshes", text), "");
    snprintf(text, sizeof text,
             "{\"primitives\":[{\"attributes\":{\"POSITION\":%d},\"indices\":%d,\"material\":0},"
             "{\"attributes\":{\"POSITION\":%d},\"indices\":%d,\"material\":1}]}",
             positions, test_prop_indices(p, 8, 1), positions, test_prop_indices(p, 16, 1));
    test_prop_node(p, TEST_PROP_DOOR, test_prop_add(p, "meshes", text), "");
}

static inline void test_prop_colliders(test_prop* p) {
    test_prop_nodes(p, NULL);
    cJSON* shape = cJSON_Duplicate(cJSON_GetArrayItem(test_prop_list(p, "meshes"), TEST_PROP_DOOR), 1);
    cJSON_AddStringToObject(shape, "name", "door-colonly");
    cJSON_AddItemToArray(test_prop_list(p, "meshes"), shape);
    static const char* const boxes[] = {"door_collider", "UCX_body_00", "UBX_door", "door-colonly.001"};
    char text[160];
    for (size_t i = 0; i < sizeof boxes / sizeof *boxes; i++) {
        snprintf(text, sizeof text, "{\"name\":\"%s\",\"mesh\":0}", boxes[i]);
        test_prop_add(p, "nodes", text);
    }
    test_prop_add(p, "nodes", "{\"name\":\"shape\",\"mesh\":3}");
    const char* hidden = "\"extensions\":{\"KHR_node_visibility\":{\"visible\":false}}";
    snprintf(text, sizeof text, "{\"name\":\"ghost\",\"children\":[9],%s}", hidden);
    test_prop_add(p, "nodes", text);
    test_prop_add(p, "nodes", "{\"name\":\"inside the ghost\",\"mesh\":0}");
    cJSON_AddItemToArray(test_prop_list(p, "extensionsUsed"), cJSON_CreateString("KHR_node_visibility"));
}

static inline void test_prop_away(test_prop* p) {
    char text[160];
    test_prop_nodes(p, NULL);
    snprintf(text, sizeof text,
             "{\"name\":\"level\",\"children\":[0,1,2],\"scale\":[100,100,100],\"translation\":[%.17g,%.17g,%.17g]}",
             test_prop_far[0], test_prop_far[1], test_prop_far[2]);
    test_prop_add(p, "nodes", text);
    test_prop_roots(p, "3");
    p->unit = 0.01;
}

/* ---- the file ---- */

static inline char* test_prop_base64(const uint8_t* bytes, size_t size) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    static const char start[] = "data:application/octet-stream;base64,";
    char *text = malloc(sizeof start + (size + 2) / 3 * 4), *to = text + sprintf(text, "%s", start);
    for (size_t i = 0; i < size; i += 3) {
        uint32_t bits = 0;
        for (size_t k = 0; k < 3; k++) bits = bits << 8 | (i + k < size ? bytes[i + k] : 0);
        for (int k = 3; k >= 0; k--) *to++ = digits[bits >> 6 * k & 63];
    }
    for (size_t i = size; i % 3 != 0; i++) to[-1 - (ptrdiff_t)(i - size)] = '=';
    *to = 0;
    return text;
}

static inline void test_prop_pack(test_prop* p, test_prop_way way) {
    cJSON *buffers = test_prop_list(p, "buffers"), *first = cJSON_CreateObject();
    cJSON_AddNumberToObject(first, "byteLength", (double)p->bin_size);
    cJSON_InsertItemInArray(buffers, 0, first);
    if (way == TEST_PROP_BESIDE) {
        cJSON_AddStringToObject(first, "uri", "parts/the%20cabinet.bin");
        p->beside = p->bin;
        p->beside_size = p->bin_size;
    } else if (way == TEST_PROP_EMBEDDED) {
        char* uri = test_prop_base64(p->bin, p->bin_size);
        cJSON_AddStringToObject(first, "uri", uri);
        free(uri);
    }
    cJSON_AddRawToObject(p->json, "ignored", "9007199254740991"); /* cJSON would write 15 digits of it */
    char* text = cJSON_PrintUnformatted(p->json);
    cJSON_DeleteItemFromObject(p->json, "ignored");
    if (way == TEST_PROP_BESIDE || way == TEST_PROP_EMBEDDED) {
        p->data = (uint8_t*)text;
        p->size = strlen(text);
        return;
    }
    const test_glb glb = test_glb_pack(text, p->bin, p->bin_size);
    p->data = glb.data;
    p->size = glb.size;
    free(text);
}

/* Returns 0 when this build has no encoder for the way. */
static inline int test_prop_make(test_prop* p, test_prop_way way) {
    memset(p, 0, sizeof *p);
    p->json = cJSON_Parse("{\"asset\":{\"version\":\"2.0\"},\"extras\":{\"empty\":null}}");
    p->unit = 1;
    switch (way) {
    case TEST_PROP_SKIN:
        test_prop_skin(p);
        break;
    case TEST_PROP_CHILD:
        test_prop_child(p);
        break;
    case TEST_PROP_MIRRORED:
        p->flipped = 1;
        test_prop_nodes(p, test_prop_mirror);
        test_prop_add(p, "nodes", "{\"name\":\"mirror\",\"children\":[0,1,2],\"scale\":[-1,1,1]}");
        break;
    case TEST_PROP_STRETCHED:
        test_prop_nodes(p, test_prop_stretch);
        test_prop_add(p, "nodes", "{\"name\":\"stretched\",\"children\":[4],\"scale\":[2,1,0.5]}");
        test_prop_add(p, "nodes",
                      "{\"name\":\"turned\",\"children\":[0,1,2],\"rotation\":[0,0,0.70710678118654752,"
                      "0.70710678118654752]}");
        test_prop_roots(p, "3");
        break;
    case TEST_PROP_QUANTISED:
        test_prop_quantised(p);
        break;
    case TEST_PROP_MESHOPT:
#if !defined(DMI_NO_MESHOPT)
        test_prop_meshopt(p, "EXT_meshopt_compression");
#endif
        break;
    case TEST_PROP_DRACO:
        test_prop_draco(p);
        break;
    case TEST_PROP_PRIMITIVES:
        test_prop_primitives(p);
        break;
    case TEST_PROP_COLLIDERS:
        test_prop_colliders(p);
        break;
    case TEST_PROP_FAR:
        test_prop_away(p);
        break;
    default:
        test_prop_nodes(p, NULL);
        break;
    }
    test_prop_pack(p, way);
    return cJSON_GetObjectItem(p->json, "nodes") != NULL;
}

static inline void test_prop_free(test_prop* p) {
    free(p->data);
    cJSON_Delete(p->json);
}

#endif
