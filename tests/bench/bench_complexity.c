/* Inputs that are slow where work grows faster than its input, each at a size and at twice that size, for callgrind to
 * count (complexity.sh):
 *
 *     bench_complexity           prints the families' names
 *     bench_complexity FAMILY    runs one
 *
 * What is counted happens within counted_once and counted_twice. */
#include <dragmesh/ext/gltf.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../include/test_glb.h"
#include "../include/test_shapes.h"
#include "base/random.h"
#include "mesh/connectivity.h"
#include "world.h"

#define COUNTED __attribute__((noinline))
#define CHECK(call) bench_check(call, #call)
#define BODY 1.0f  /* half of a side of the box that every mesh begins with */
#define ABOVE 1.1f /* height of what lies above it */
#define TURN 6.2831853f
#define NODE_TEXT 64 /* bytes of a node in a JSON text, at most */
/* The same of a mesh with its node, and of what comes before them. */
#define SHARING_TEXT 96
#define SHARING_HEAD 1024
#define WELD_TOLERANCE 1e-5f /* that of prepare */
#define ARENA_BLOCK 65536
#define NODE_NAME 16       /* bytes of "#4294967295" and its end */
#define VERTICES_A_MESH 64 /* a word of the marks of used vertices */

typedef struct input input;

typedef struct family {
    const char* name;
    uint32_t size; /* items; then twice as many */
    void (*make)(input* in, uint32_t items);
    void (*run)(input* in);
} family;

struct input {
    bench_world world;
    bench_mesh mesh; /* positions, indices and part ids one a face */
    dmi_random random;
    test_glb glb;
    uint32_t items;
};

/* ---- meshes: a box, the body, and many items above it, the part ---- */

static void mesh_begin(input* in, uint32_t items) {
    const size_t vertices = TEST_BOX_VERTICES * ((size_t)items + 1), faces = TEST_BOX_FACES * ((size_t)items + 1);
    in->mesh = (bench_mesh){.positions = bench_alloc(vertices * 3 * sizeof(float)),
                            .indices = bench_alloc(faces * 3 * sizeof(uint32_t)),
                            .part_ids = bench_alloc(faces * sizeof(uint32_t)),
                            .parts = 1};
    in->random = dmi_random_make(1, 0);
}

static float unit(input* in) {
    return dmi_random_unit(&in->random);
}

/* From -1 to 1. */
static float both(input* in) {
    return 2 * unit(in) - 1;
}

static uint32_t vertex(input* in, float x, float y, float z) {
    float* at = in->mesh.positions + (size_t)in->mesh.vertex_count * 3;
    at[0] = x;
    at[1] = y;
    at[2] = z;
    return in->mesh.vertex_count++;
}

static void face(input* in, uint32_t a, uint32_t b, uint32_t c, uint32_t part) {
    uint32_t* at = in->mesh.indices + (size_t)in->mesh.face_count * 3;
    at[0] = a;
    at[1] = b;
    at[2] = c;
    in->mesh.part_ids[in->mesh.face_count++] = part;
}

static void box(input* in, const float low[3], float side, uint32_t part) {
    const uint32_t first = in->mesh.vertex_count;
    for (uint32_t c = 0; c < TEST_BOX_VERTICES; c++)
        vertex(in, low[0] + side * (float)(c & 1), low[1] + side * (float)(c >> 1 & 1),
               low[2] + side * (float)(c >> 2));
    for (uint32_t t = 0; t < TEST_BOX_FACES; t++) {
        const uint8_t* at = test_box_corners[t];
        face(in, first + at[0], first + at[1], first + at[2], part);
    }
}

static void body(input* in, uint32_t items) {
    const float low[3] = {-BODY, -BODY, -BODY};
    mesh_begin(in, items);
    box(in, low, 2 * BODY, 0);
}

/* Triangles with almost no area, each by itself. */
static void make_slivers(input* in, uint32_t items) {
    const float width = 1e-6f;
    body(in, items);
    for (uint32_t i = 0; i < items; i++) {
        const float y = both(in);
        const uint32_t a = vertex(in, -1, y, ABOVE), b = vertex(in, 1, y, ABOVE);
        face(in, a, b, vertex(in, 1, y + width, ABOVE), 1);
    }
}

/* Pages of one book: triangles on one edge. */
static void make_one_edge(input* in, uint32_t items) {
    body(in, items);
    const uint32_t a = vertex(in, 0, 0, ABOVE), b = vertex(in, 0, 0, 2 * ABOVE);
    for (uint32_t i = 0; i < items; i++) {
        const float angle = TURN * (float)i / (float)items;
        face(in, a, b, vertex(in, cosf(angle), sinf(angle), 1.5f * ABOVE), 1);
    }
}

/* The same, each triangle with an edge of its own near the others'. */
static void make_near_edges(input* in, uint32_t items) {
    const float apart = 1e-3f;
    body(in, items);
    for (uint32_t i = 0; i < items; i++) {
        const float angle = TURN * (float)i / (float)items;
        const uint32_t a = vertex(in, apart * both(in), apart * both(in), ABOVE),
                       b = vertex(in, apart * both(in), apart * both(in), 2 * ABOVE);
        face(in, a, b, vertex(in, cosf(angle), sinf(angle), 1.5f * ABOVE), 1);
    }
}

/* Triangles round one vertex. */
static void make_fan(input* in, uint32_t items) {
    body(in, items);
    const uint32_t centre = vertex(in, 0, 0, 1.5f * ABOVE), first = in->mesh.vertex_count;
    for (uint32_t i = 0; i < items; i++) {
        const float angle = TURN * (float)i / (float)items;
        vertex(in, cosf(angle), sinf(angle), ABOVE);
    }
    for (uint32_t i = 0; i < items; i++) face(in, centre, first + i, first + (i + 1) % items, 1);
}

/* Small boxes strewn over the body. */
static void make_shells(input* in, uint32_t items) {
    const float side = 0.002f;
    body(in, items);
    for (uint32_t i = 0; i < items; i++) {
        const float low[3] = {both(in), both(in), 1.01f};
        box(in, low, side, i % 2);
    }
}

/* A row of boxes, each on the one before; each is a piece of its own where the pieces are given. */
static void make_row(input* in, uint32_t items) {
    const float side = 2 * BODY / (float)items;
    body(in, items);
    for (uint32_t i = 0; i < items; i++) {
        const float low[3] = {-BODY + side * (float)i, 0, ABOVE};
        box(in, low, side, i + 1);
    }
}

/* Triangles anywhere, of both parts. */
static void make_soup(input* in, uint32_t items) {
    const float spread = 0.1f;
    body(in, items);
    for (uint32_t i = 0; i < items; i++) {
        const float x = both(in), y = both(in), z = ABOVE + unit(in);
        uint32_t corners[3];
        for (int c = 0; c < 3; c++)
            corners[c] = vertex(in, x + spread * unit(in), y + spread * unit(in), z + spread * unit(in));
        face(in, corners[0], corners[1], corners[2], i % 2);
    }
}

/* The same triangle again and again, each with vertices of its own. */
static void make_coincident(input* in, uint32_t items) {
    body(in, items);
    for (uint32_t i = 0; i < items; i++) {
        const uint32_t a = vertex(in, -0.9f, -0.9f, ABOVE), b = vertex(in, 0.9f, -0.9f, ABOVE);
        face(in, a, b, vertex(in, 0, 0.9f, ABOVE), 1);
    }
}

/* The middle of a cell of the grid that vertices are welded by, among those that a hash with known factors (that of
 * version 0.1) puts into its first bucket. */
static uint32_t vertex_in_first_bucket(input* in, uint32_t buckets) {
    const float cells_a_unit = 0.25f / WELD_TOLERANCE;
    uint32_t cell[3], hash;
    do {
        for (int k = 0; k < 3; k++) cell[k] = dmi_random_u32(&in->random) % (uint32_t)(2 * cells_a_unit);
        hash = cell[0] * 0x9e3779b1u ^ cell[1] * 0x85ebca6bu ^ cell[2] * 0xc2b2ae35u;
    } while (((hash ^ hash >> 15) & (buckets - 1)) != 0);
    float at[3];
    for (int k = 0; k < 3; k++) at[k] = ((float)cell[k] + 0.5f) / cells_a_unit - 1 - WELD_TOLERANCE;
    return vertex(in, at[0], at[1], at[2]);
}

static void make_bucket(input* in, uint32_t items) {
    uint32_t buckets = 16;
    while (buckets < items) buckets *= 2;
    mesh_begin(in, items);
    for (uint32_t i = 0; i < items; i++) vertex_in_first_bucket(in, buckets);
}

static void run_weld(input* in) {
    const dmi_mesh mesh = {.positions = in->mesh.positions, .vertex_count = in->mesh.vertex_count};
    uint32_t* welded = bench_alloc(mesh.vertex_count * sizeof *welded);
    dmi_env env;
    dmi_arena arena;
    dmi_env_init(&env, NULL, NULL, NULL);
    dmi_arena_init(&arena, &env, ARENA_BLOCK);
    bench_check(dmi_weld_vertices(&arena, &mesh, WELD_TOLERANCE, NULL, welded), "dmi_weld_vertices");
    dmi_arena_release(&arena);
    free(welded);
}

static dm_mesh_desc whole_mesh(const input* in) {
    dm_mesh_desc mesh = bench_mesh_desc(&in->mesh);
    mesh.part_ids = NULL;
    mesh.part_id_bytes = 0;
    return mesh;
}

static void run_find(input* in) {
    const dm_mesh_desc mesh = whole_mesh(in);
    const float* last = in->mesh.positions + (size_t)(in->mesh.vertex_count - 1) * 3;
    const dm_drag_hint drag = {{last[0], last[1], last[2]}, {0, 0, 1}};
    uint8_t* faces = bench_alloc(in->mesh.face_count);
    const dm_result result = dm_mesh_find_part(in->world.context, &mesh, &drag, faces, in->mesh.face_count);
    if (result != DM_ERROR_FULL_MASK) bench_check(result, "dm_mesh_find_part");
    free(faces);
}

static void run_find_given(input* in) {
    const dm_mesh_desc mesh = bench_mesh_desc(&in->mesh);
    const dm_drag_hint drag = {{0, 0, ABOVE}, {0, 0, 1}};
    uint8_t* faces = bench_alloc(in->mesh.face_count);
    CHECK(dm_mesh_find_part(in->world.context, &mesh, &drag, faces, in->mesh.face_count));
    free(faces);
}

static void run_prepare(input* in) {
    const dm_mesh_desc mesh = bench_mesh_desc(&in->mesh);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = in->world.model};
    CHECK(dm_object_prepare(in->world.context, &desc, &in->world.object));
}

/* Soup that is prepared, saved and loaded; loading is what is counted. */
static void make_saved(input* in, uint32_t items) {
    make_soup(in, items);
    run_prepare(in);
    CHECK(dm_object_save(in->world.context, in->world.object, NULL, 0, &in->glb.size));
    in->glb.data = bench_alloc(in->glb.size);
    CHECK(dm_object_save(in->world.context, in->world.object, in->glb.data, in->glb.size, &in->glb.size));
}

static void run_load(input* in) {
    dm_object object;
    CHECK(dm_object_load(in->world.context, in->glb.data, in->glb.size, 0, &object));
}

/* ---- glTF ---- */

/* Nodes of one name that share a mesh of one triangle; nested: each is the child of the one before. */
static void make_nodes(input* in, uint32_t items, bool nested) {
    static const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const char head[] =
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"nodes\":[";
    char* text = bench_alloc(sizeof head + (size_t)items * NODE_TEXT + NODE_TEXT);
    char* end = stpcpy(text, head);
    for (uint32_t i = 0; i < items; i++) {
        end += sprintf(end, "%s{\"name\":\"door\",\"mesh\":0", i > 0 ? "," : "");
        if (nested && i + 1 < items) end += sprintf(end, ",\"children\":[%u]", i + 1);
        *end++ = '}';
    }
    strcpy(end, "]}");
    in->glb = test_glb_pack(text, corners, sizeof corners);
    free(text);
}

/* ---- glTF: text that grows, and a binary chunk ---- */

typedef struct document {
    char *text, *end;
    uint8_t* bytes;
    uint32_t size; /* of bytes */
} document;

static document document_new(size_t text, size_t bytes) {
    document d = {.text = bench_alloc(text), .bytes = bench_alloc(bytes)};
    d.end = d.text;
    return d;
}

static void put(document* d, const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    d->end += vsprintf(d->end, format, arguments);
    va_end(arguments);
}

/* Appends bytes; returns where they begin. */
static uint32_t put_bytes(document* d, const void* data, size_t size) {
    const uint32_t at = d->size;
    memcpy(d->bytes + at, data, size);
    d->size += (uint32_t)size;
    return at;
}

static void pack(input* in, document* d) {
    in->glb = test_glb_pack(d->text, d->bytes, d->size);
    free(d->text);
    free(d->bytes);
}

/* Meshes of one triangle each, from the first to the last vertex of one accessor of `vertices`, of which `changed` are
 * changed by a sparse accessor. */
static void make_sharing(input* in, uint32_t meshes, uint32_t vertices, uint32_t changed) {
    document d =
        document_new((size_t)meshes * SHARING_TEXT + SHARING_HEAD, (size_t)vertices * 12 + (size_t)changed * 16 + 12);
    const uint32_t corners[3] = {0, vertices / 2, vertices - 1};
    for (uint32_t v = 0; v < vertices; v++) {
        const float xyz[3] = {(float)(v & 1), (float)(v >> 1 & 1), (float)v};
        put_bytes(&d, xyz, sizeof xyz);
    }
    const uint32_t indices = put_bytes(&d, corners, sizeof corners), changes = d.size;
    for (uint32_t i = 0; i < changed; i++) put_bytes(&d, &i, sizeof i);
    const uint32_t values = d.size;
    for (uint32_t i = 0; i < changed; i++) put_bytes(&d, d.bytes + (size_t)i * 12, 12);
    put(&d, "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":%u}],\"bufferViews\":[", d.size);
    put(&d, "{\"buffer\":0,\"byteLength\":%u},{\"buffer\":0,\"byteOffset\":%u,\"byteLength\":12}", vertices * 12,
        indices);
    if (changed > 0)
        put(&d,
            ",{\"buffer\":0,\"byteOffset\":%u,\"byteLength\":%u},{\"buffer\":0,\"byteOffset\":%u,\"byteLength\":%u}",
            changes, changed * 4, values, changed * 12);
    put(&d, "],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%u,\"type\":\"VEC3\"", vertices);
    if (changed > 0)
        put(&d,
            ",\"sparse\":{\"count\":%u,\"indices\":{\"bufferView\":2,\"componentType\":5125},"
            "\"values\":{\"bufferView\":3}}",
            changed);
    put(&d, "},{\"bufferView\":1,\"componentType\":5125,\"count\":3,\"type\":\"SCALAR\"}],\"meshes\":[");
    for (uint32_t i = 0; i < meshes; i++)
        put(&d, "%s{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}", i ? "," : "");
    put(&d, "],\"nodes\":[");
    for (uint32_t i = 0; i < meshes; i++) put(&d, "%s{\"mesh\":%u}", i ? "," : "", i);
    put(&d, "]}");
    pack(in, &d);
}

static void make_shared_vertices(input* in, uint32_t items) {
    make_sharing(in, items, VERTICES_A_MESH * items, 0);
}

static void make_shared_changes(input* in, uint32_t items) {
    make_sharing(in, items, items, items);
}

static void run_open(input* in) {
    const dm_gltf_desc desc = {.struct_size = sizeof desc, .data = in->glb.data, .size = in->glb.size};
    dm_gltf* gltf;
    CHECK(dm_gltf_open(&desc, &gltf));
    dm_gltf_close(gltf);
}

static void make_namesakes(input* in, uint32_t items) {
    make_nodes(in, items, false);
}

static void make_chain(input* in, uint32_t items) {
    make_nodes(in, items, true);
}

static void run_gltf(input* in) {
    static const char* const names[] = {"door", "door_41"};
    const dm_gltf_desc desc = {.struct_size = sizeof desc, .data = in->glb.data, .size = in->glb.size};
    dm_gltf* gltf;
    dm_mesh_desc mesh = {.struct_size = sizeof mesh};
    CHECK(dm_gltf_open(&desc, &gltf));
    CHECK(dm_gltf_get_mesh(gltf, &mesh));
    uint8_t* faces = bench_alloc(mesh.index_count / 3);
    dm_gltf_mark_faces(gltf, names, 2, 1, faces, mesh.index_count / 3); /* the second name is missing */
    free(faces);
    dm_gltf_close(gltf);
}

/* Names every node, and asks what its names and its pivot say. */
static void run_all_names(input* in) {
    const dm_gltf_desc desc = {.struct_size = sizeof desc, .data = in->glb.data, .size = in->glb.size};
    dm_gltf* gltf;
    CHECK(dm_gltf_open(&desc, &gltf));
    const uint32_t count = dm_gltf_node_count(gltf);
    char(*text)[NODE_NAME] = bench_alloc(count * sizeof *text);
    const char** names = bench_alloc(count * sizeof *names);
    uint8_t* faces = bench_alloc(count);
    for (uint32_t i = 0; i < count; i++) {
        snprintf(text[i], NODE_NAME, "#%u", i);
        names[i] = text[i];
    }
    CHECK(dm_gltf_mark_faces(gltf, names, count, 1, faces, count)); /* a triangle a node */
    for (uint32_t i = 0; i < count; i++) {
        char label[NODE_NAME];
        dm_pivot pivot;
        CHECK(dm_gltf_get_hints(gltf, names[i], label, sizeof label, &pivot));
        dm_gltf_pivots_are_lost(gltf);
    }
    free(faces);
    free(names);
    free(text);
    dm_gltf_close(gltf);
}

/* Buffers without bytes, which hold the place of decompressed data, behind the one of a triangle. */
static void make_buffers(input* in, uint32_t items) {
    static const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const char head[] =
        "{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"name\":\"door\",\"mesh\":0}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"buffers\":[{\"byteLength\":36}";
    static const char empty[] = ",{\"byteLength\":1,\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}}";
    char* text = bench_alloc(sizeof head + items * sizeof empty + NODE_TEXT);
    char* end = stpcpy(text, head);
    for (uint32_t i = 0; i < items; i++) end = stpcpy(end, empty);
    strcpy(end, "]}");
    in->glb = test_glb_pack(text, corners, sizeof corners);
    free(text);
}

static void run_export(input* in) {
    static const uint8_t faces[1] = {1};
    static const dm_pose poses[2] = {{.real = {0, 0, 0, 1}}, {.real = {0, 0, 0, 1}}};
    static const float times[2] = {0, 1};
    const dm_gltf_desc desc = {.struct_size = sizeof desc, .data = in->glb.data, .size = in->glb.size};
    const dm_gltf_track track = {.face_ids = faces, .value = 1, .poses = poses, .times = times, .key_count = 2};
    dm_gltf* gltf;
    void* data;
    size_t size;
    CHECK(dm_gltf_open(&desc, &gltf));
    CHECK(dm_gltf_export(gltf, &track, 1, &data, &size));
    dm_gltf_release_bytes(gltf, data, size);
    dm_gltf_close(gltf);
}

/* ---- scenes ---- */

static void make_object(input* in, uint32_t items) {
    const uint32_t triangles = 100;
    in->mesh = bench_mesh_new(triangles, 1);
    in->items = items;
    run_prepare(in);
}

/* Instances come, move, are seen, and go. */
static void run_scene(input* in) {
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    uint32_t* instances = bench_alloc(in->items * sizeof *instances);
    dm_scene scene;
    CHECK(dm_scene_create(in->world.context, &desc, &scene));
    for (uint32_t i = 0; i < in->items; i++) {
        const dm_pose pose = {{0, 0, 0, 1}, {(float)i, 0, 0, 0}};
        CHECK(dm_scene_add(in->world.context, scene, in->world.object, &pose, &instances[i]));
    }
    CHECK(dm_scene_commit(in->world.context, scene));
    for (uint32_t i = 0; i < in->items; i++) {
        const dm_pose pose = {{0, 0, 0, 1}, {0, (float)i, 0, 0}};
        CHECK(dm_scene_move(in->world.context, scene, instances[i], 1, &pose));
        CHECK(dm_scene_commit(in->world.context, scene));
    }
    for (uint32_t i = 0; i < in->items; i++) CHECK(dm_scene_remove(in->world.context, scene, instances[i]));
    CHECK(dm_scene_destroy(in->world.context, scene));
    free(instances);
}

/* Instances that all stand in one place, where no box tells them apart: they move there one by one, and are seen. */
static void run_overlap(input* in) {
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    const dm_pose rest = {{0, 0, 0, 1}, {0, 0, 0, 0}};
    const dm_ray ray = {{0, 0, 2 * ABOVE}, {0, 0, -1}};
    dm_hit hit = {.struct_size = sizeof hit};
    dm_scene scene;
    CHECK(dm_scene_create(in->world.context, &desc, &scene));
    for (uint32_t i = 0; i < in->items; i++) {
        uint32_t instance;
        CHECK(dm_scene_add(in->world.context, scene, in->world.object, NULL, &instance));
        CHECK(dm_scene_commit(in->world.context, scene));
    }
    for (uint32_t i = 0; i < in->items; i++) {
        CHECK(dm_scene_move(in->world.context, scene, i, 1, &rest));
        CHECK(dm_scene_commit(in->world.context, scene));
    }
    CHECK(dm_scene_pick(in->world.context, scene, &ray, &hit));
    CHECK(dm_scene_destroy(in->world.context, scene));
}

/* ---- counting ---- */

static const family families[] = {
    {"find_slivers", 2000, make_slivers, run_find},
    {"find_one_edge", 500, make_one_edge, run_find},
    {"find_few_at_edge", 128, make_one_edge, run_find},
    {"find_near_edges", 256, make_near_edges, run_find},
    {"find_fan", 8000, make_fan, run_find},
    {"find_shells", 2000, make_shells, run_find},
    {"find_soup", 4000, make_soup, run_find},
    {"find_coincident", 4000, make_coincident, run_find},
    {"weld_bucket", 1500, make_bucket, run_weld},
    {"find_row_given", 1500, make_row, run_find_given},
    {"prepare_parts", 16, make_row, run_prepare},
    {"prepare_slivers", 8000, make_slivers, run_prepare},
    {"prepare_one_edge", 8000, make_one_edge, run_prepare},
    {"prepare_fan", 8000, make_fan, run_prepare},
    {"prepare_shells", 2000, make_shells, run_prepare},
    {"prepare_soup", 8000, make_soup, run_prepare},
    {"prepare_coincident", 8000, make_coincident, run_prepare},
    {"load_soup", 8000, make_saved, run_load},
    {"gltf_shared_vertices", 1000, make_shared_vertices, run_open},
    {"gltf_shared_changes", 1000, make_shared_changes, run_open},
    {"gltf_namesakes", 4000, make_namesakes, run_gltf},
    {"gltf_all_names", 2000, make_namesakes, run_all_names},
    {"gltf_chain", 100, make_chain, run_gltf},
    {"gltf_buffers", 8000, make_buffers, run_export},
    {"scene", 1000, make_object, run_scene},
    {"scene_overlap", 1000, make_object, run_overlap},
};
enum { FAMILIES = sizeof families / sizeof families[0] };

COUNTED static void counted_once(const family* of, input* in) {
    of->run(in);
}

COUNTED static void counted_twice(const family* of, input* in) {
    of->run(in);
}

static void run(const family* of, uint32_t items, void (*counted)(const family* of, input* in)) {
    input in = {.items = 0};
    bench_world_open(&in.world, "sdk/models", NULL);
    of->make(&in, items);
    counted(of, &in);
    bench_world_close(&in.world);
    bench_mesh_free(&in.mesh);
    free(in.glb.data);
}

int main(int argc, char** argv) {
    for (int f = 0; f < FAMILIES; f++) {
        if (argc < 2) puts(families[f].name);
        if (argc < 2 || strcmp(argv[1], families[f].name) != 0) continue;
        run(&families[f], families[f].size, counted_once);
        run(&families[f], 2 * families[f].size, counted_twice);
        return 0;
    }
    return argc < 2 ? 0 : 1;
}
