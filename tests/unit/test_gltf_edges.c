/* glTF in, at its edges: every type of number, the last byte of a file, the largest counts, each name, each failure. */
#include <math.h>
#include <stdio.h>

#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_glb.h"

enum { BYTE = 5120, UBYTE, SHORT, USHORT, UINT = 5125, FLOAT };
enum { TEXT = 8192, VERTICES = 4 };

typedef struct opened {
    test_env t;
    dm_gltf* gltf;
    dm_mesh_desc mesh;
    dm_result result;
    int reports, stop_at; /* stop_at: the report that stops the call; -1: none */
} opened;

static int32_t DM_CALL report(void* user, float done) {
    opened* o = user;
    assert_true(done >= 0 && done <= 1);
    return o->reports++ == o->stop_at;
}

static void open_glb(opened* o, const test_glb* glb, int64_t fail_at, bool once, int stop_at) {
    memset(o, 0, sizeof *o);
    test_env_open(&o->t, fail_at);
    o->t.memory.fail_once = once;
    o->stop_at = stop_at;
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = glb->data,
                               .size = glb->size,
                               .allocator = test_allocator(&o->t.memory),
                               .log = test_log(&o->t.messages),
                               .progress = report,
                               .progress_user = o};
    o->result = dm_gltf_open(&desc, &o->gltf);
    if (o->result != DM_OK) assert_null(o->gltf);
    if (o->result == DM_OK) assert_int_equal(dm_gltf_get_mesh(o->gltf, &o->mesh), DM_OK);
}

static void open_json(opened* o, const char* json, const void* bytes, size_t size) {
    const test_glb glb = test_glb_pack(json, bytes, size);
    open_glb(o, &glb, TEST_NEVER, false, -1);
    free(glb.data);
}

static void close_it(opened* o) {
    dm_gltf_close(o->gltf);
    test_env_close(&o->t);
}

static void expect(opened* o, dm_result result, const char* says) {
    if (o->result != result || (says && !strstr(o->t.messages.text, says)))
        fail_msg("%d '%s', not %d '%s'", o->result, o->t.messages.text, result, says ? says : "");
}

static const float* position(const opened* o, size_t vertex) {
    return (const float*)o->mesh.positions + 3 * vertex;
}

/* ---- numbers of every type ---- */

static const struct kind {
    int type, size;
    double values[6]; /* as they are stored */
    double whole;     /* that stands for 1 where they are normalised; 0: they never are */
} kinds[] = {{BYTE, 1, {-128, 127, -127, 1, -1, 64}, 127},
             {UBYTE, 1, {255, 0, 1, 128, 127, 3}, 255},
             {SHORT, 2, {-32768, 32767, -32767, 256, -257, 1}, 32767},
             {USHORT, 2, {65535, 0, 256, 255, 32768, 513}, 65535},
             {UINT, 4, {4294967040.0, 0, 65536, 16777216, 255, 2147483648.0}, 0},
             {FLOAT, 4, {-1.5, 0.1f, 3e9, -1e-3f, 0, 7}, 0}};

static void put_number(uint8_t* at, const struct kind* kind, double value) {
    const float real = (float)value;
    const int64_t whole = (int64_t)value;
    uint32_t bits = (uint32_t)whole;
    if (kind->type == FLOAT) memcpy(&bits, &real, sizeof bits);
    for (int i = 0; i < kind->size; i++) at[i] = (uint8_t)(bits >> (8 * i));
}

/* What the file means by a stored number (glTF 2.0, section 3.11). */
static double meaning(const struct kind* kind, bool normalised, double value) {
    if (!normalised || kind->whole == 0) return value;
    return fmax(value / kind->whole, -1);
}

/* A strip of four vertices; the positions are the last bytes of the file. */
typedef struct layout {
    const struct kind* kind;
    bool normalised, strided;
    int sparse;        /* 0: none; 1: changes some vertices; 2: without a view, all others are 0 */
    int index_type;    /* of sparse indices */
    int missing;       /* bytes that the view lacks */
    int first, second; /* vertices that are changed */
} layout;

enum { SPARSE = 48, FILE_BYTES = 128 }; /* SPARSE: bytes before the positions: two indices, two vertices */

static void open_layout(opened* o, const layout* l, double want[VERTICES][3]) {
    uint8_t bytes[FILE_BYTES] = {0};
    char json[TEXT], sparse[512] = "";
    const int element = 3 * l->kind->size, stride = l->strided ? (element + 7) & ~3 : element;
    const int length = (VERTICES - 1) * stride + element, at = FILE_BYTES - length;
    const int width = l->index_type == UINT ? 4 : l->index_type == USHORT ? 2 : 1;
    for (int v = 0; v < VERTICES; v++)
        for (int k = 0; k < 3; k++) {
            const double value = l->kind->values[(5 * v + k) % 6];
            put_number(bytes + at + v * stride + k * l->kind->size, l->kind, value);
            want[v][k] = l->sparse == 2 ? 0 : meaning(l->kind, l->normalised, value);
        }
    bytes[0] = (uint8_t)l->first, bytes[width] = (uint8_t)l->second;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++) {
            const double value = l->kind->values[(2 * i + k + 1) % 6];
            const int changed = i ? l->second : l->first;
            put_number(bytes + 8 + i * element + k * l->kind->size, l->kind, value);
            if (l->sparse && changed < VERTICES) want[changed][k] = meaning(l->kind, l->normalised, value);
        }
    if (l->sparse)
        snprintf(sparse, sizeof sparse,
                 ",\"sparse\":{\"count\":2,\"indices\":{\"bufferView\":1,\"componentType\":%d},"
                 "\"values\":{\"bufferView\":2}}",
                 l->index_type);
    snprintf(json, sizeof json,
             "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":%d}],\"bufferViews\":["
             "{\"buffer\":0,\"byteOffset\":%d,\"byteLength\":%d%s},{\"buffer\":0,\"byteLength\":%d},"
             "{\"buffer\":0,\"byteOffset\":8,\"byteLength\":%d}],\"accessors\":[{%s\"componentType\":%d,"
             "\"normalized\":%s,\"count\":%d,\"type\":\"VEC3\"%s}],"
             "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":5}]}],\"nodes\":[{\"mesh\":0}]}",
             FILE_BYTES, at, length - l->missing, l->strided ? ",\"byteStride\":" : "", 2 * width,
             2 * element - (l->sparse == 2 ? l->missing : 0), l->sparse == 2 ? "" : "\"bufferView\":0,", l->kind->type,
             l->normalised ? "true" : "false", VERTICES, sparse);
    if (l->strided) { /* the number behind its name */
        char whole[TEXT], *value = strstr(json, "\"byteStride\":") + 13;
        snprintf(whole, sizeof whole, "%.*s%d%s", (int)(value - json), json, stride, value);
        memcpy(json, whole, sizeof json);
    }
    open_json(o, json, bytes, sizeof bytes);
}

static void every_number_means_what_the_standard_says(void** state) {
    (void)state;
    static const int index_types[] = {UBYTE, USHORT, UINT};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        for (int way = 0; way < 36; way++) {
            const layout l = {.kind = &kinds[i],
                              .normalised = way & 1,
                              .strided = way >> 1 & 1,
                              .sparse = way / 4 % 3,
                              .index_type = index_types[way / 12],
                              .first = way % 3,
                              .second = 3};
            double want[VERTICES][3];
            opened o;
            open_layout(&o, &l, want);
            expect(&o, DM_OK, NULL);
            assert_int_equal(o.mesh.vertex_count, VERTICES);
            assert_int_equal(o.mesh.index_count, 6);
            for (size_t v = 0; v < VERTICES; v++)
                for (int k = 0; k < 3; k++)
                    if (position(&o, v)[k] != (float)want[v][k])
                        fail_msg("type %d, way %d, vertex %zu: %g, not %g", kinds[i].type, way, v,
                                 (double)position(&o, v)[k], want[v][k]);
            close_it(&o);
        }
}

static void a_byte_less_is_too_few(void** state) {
    (void)state;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        for (int way = 0; way < 6; way++) {
            const layout l = {&kinds[i], false, way & 1, way / 2, UBYTE, 1, 1, 2};
            double want[VERTICES][3];
            opened o;
            open_layout(&o, &l, want);
            expect(&o, DM_ERROR_BAD_DATA, l.sparse == 2 ? "leave buffer view 2" : "leave buffer view 0");
            close_it(&o);
        }
}

static void a_change_is_of_a_vertex_that_there_is(void** state) {
    (void)state;
    for (int sparse = 1; sparse <= 2; sparse++)
        for (int which = 0; which < 2; which++) {
            const layout l = {&kinds[5], false, false, sparse, UBYTE, 0, which ? 1 : 4, which ? 4 : 3};
            double want[VERTICES][3];
            opened o;
            open_layout(&o, &l, want);
            expect(&o, DM_ERROR_INDEX_OUT_OF_RANGE, "none of its 4 elements");
            close_it(&o);
        }
}

/* ---- indices at the end of the file ---- */

static void open_indices(opened* o, int type, int width, int mode, int count, const uint32_t* indices, int sparse) {
    uint8_t bytes[FILE_BYTES] = {0};
    char json[TEXT];
    const float xyz[VERTICES][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    const int at = FILE_BYTES - count * width;
    memcpy(bytes, xyz, sizeof xyz);
    bytes[sizeof xyz] = (uint8_t)(count - 1), bytes[sizeof xyz + 4] = 2; /* the last becomes 2 */
    for (int i = 0; i < count; i++)
        for (int b = 0; b < width; b++) bytes[at + i * width + b] = (uint8_t)(indices[i] >> (8 * b));
    snprintf(json, sizeof json,
             "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":%d}],\"bufferViews\":["
             "{\"buffer\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":%d,\"byteLength\":%d},"
             "{\"buffer\":0,\"byteOffset\":48,\"byteLength\":16}],"
             "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},"
             "{%s\"componentType\":%d,\"count\":%d,\"type\":\"SCALAR\"%s}],\"meshes\":[{\"primitives\":[{"
             "\"attributes\":{\"POSITION\":0},\"indices\":1,\"mode\":%d}]}],\"nodes\":[{\"name\":\"it\",\"mesh\":0}]}",
             FILE_BYTES, at, count * width, sparse == 2 ? "" : "\"bufferView\":1,", type, count,
             sparse ? ",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":2,\"componentType\":5121},"
                      "\"values\":{\"bufferView\":2,\"byteOffset\":4}}"
                    : "",
             mode);
    open_json(o, json, bytes, sizeof bytes);
}

/* The triangles that a list, a strip and a fan have (glTF 2.0, section 3.7.2.1), each turned until its first corner is
 * the one of the standard's formula. */
static void triangle_of(int mode, int face, const uint32_t* indices, uint32_t out[3]) {
    const int strip[3] = {face, face + (1 + face % 2), face + (2 - face % 2)};
    const int fan[3] = {face + 1, face + 2, 0};
    for (int k = 0; k < 3; k++) out[k] = indices[mode == 4 ? 3 * face + k : mode == 5 ? strip[k] : fan[k]];
}

static void indices_of_every_type_and_mode(void** state) {
    (void)state;
    static const uint32_t indices[12] = {3, 0, 2, 1, 3, 2, 0, 1, 2, 0, 3, 1};
    static const struct { int type, width; } types[] = {{UBYTE, 1}, {USHORT, 2}, {UINT, 4}};
    for (int t = 0; t < 3; t++)
        for (int mode = 4; mode <= 6; mode++)
            for (int count = 3; count <= 12; count++)
                for (int sparse = 0; sparse < 3; sparse++) {
                    uint32_t used[12] = {0};
                    opened o;
                    const int faces = mode == 4 ? count / 3 : count - 2;
                    memcpy(used, indices, (size_t)count * sizeof *used);
                    if (sparse == 2) memset(used, 0, sizeof used);
                    if (sparse) used[count - 1] = 2;
                    open_indices(&o, types[t].type, types[t].width, mode, count, indices, sparse);
                    expect(&o, DM_OK, NULL);
                    assert_int_equal(o.mesh.index_count, 3 * faces);
                    for (int face = 0; face < faces; face++) {
                        uint32_t want[3];
                        triangle_of(mode, face, used, want);
                        assert_memory_equal((const uint32_t*)o.mesh.indices + 3 * face, want, sizeof want);
                    }
                    const bool odd = mode == 4 && count % 3 != 0;
                    assert_int_equal(strstr(o.t.messages.text, "not a multiple of 3") != NULL, odd);
                    close_it(&o);
                }
}

static void every_corner_is_a_vertex_that_there_is(void** state) {
    (void)state;
    for (int mode = 4; mode <= 6; mode++)
        for (int corner = 0; corner < 6; corner++) {
            /* of a list, and of a strip, the triangles that have the corner; of a fan all have the first */
            const int first = corner > 2 ? corner - 2 : 0, last = corner < 3 ? corner : 3;
            const int of_fan = corner == 0 ? 4 : corner == 1 || corner == 5 ? 1 : 2;
            const int all = mode == 4 ? 2 : 4, bad = mode == 4 ? 1 : mode == 5 ? last - first + 1 : of_fan;
            uint32_t indices[6] = {0, 1, 2, 2, 1, 3};
            char says[64];
            opened o;
            indices[corner] = VERTICES;
            open_indices(&o, USHORT, 2, mode, 6, indices, 0);
            expect(&o, bad == all ? DM_ERROR_INDEX_OUT_OF_RANGE : DM_OK, "names vertex 4 of 4");
            snprintf(says, sizeof says, "bad triangles: %d of %d", bad, all);
            if (bad < all) expect(&o, DM_OK, says);
            assert_int_equal(o.mesh.index_count, 3 * (all - bad));
            assert_int_equal(dm_gltf_left_out(o.gltf), bad < all);
            close_it(&o);
        }
    const uint32_t two[2] = {0, 1};
    opened o;
    for (int mode = 4; mode <= 6; mode++) { /* too few for a triangle */
        open_indices(&o, UINT, 4, mode, 2, two, 0);
        expect(&o, DM_ERROR_DEGENERATE_MESH, "no triangle");
        close_it(&o);
    }
    for (int mode = 0; mode <= 7; mode += mode == 3 ? 4 : 1) {
        open_indices(&o, UINT, 4, mode, 2, two, 0);
        expect(&o, DM_ERROR_DEGENERATE_MESH, "points or lines");
        close_it(&o);
    }
}

/* ---- largest counts ---- */

static void as_many_elements_as_there_may_be(void** state) {
    (void)state;
    const float zeros[4] = {0};
    for (int64_t more = -1; more <= 1; more++) {
        char json[TEXT];
        opened o;
        snprintf(json, sizeof json,
                 "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":16}],\"bufferViews\":[{\"buffer\":0,"
                 "\"byteLength\":16}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%lld,"
                 "\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
                 "\"nodes\":[{\"mesh\":0}]}",
                 (long long)DM_MAX_ELEMENTS + more);
        open_json(&o, json, zeros, sizeof zeros);
        expect(&o, more > 0 ? DM_ERROR_TOO_LARGE : DM_ERROR_BAD_DATA, more > 0 ? "is the most" : "leave buffer view 0");
        close_it(&o);
    }
}

/* Sizes are checked first, then what is in the buffers: here a vertex that is not finite. */
static void as_many_elements_as_may_be_written(void** state) {
    (void)state;
    const float nan[3] = {NAN, 0, 0}, zeros[9] = {0};
    const uint32_t corners[3] = {0, 1, 2}, bad[3] = {0, 1, 3};
    const uint64_t most = DM_MAX_ELEMENTS;
    const struct {
        const float* positions;
        const uint32_t* indices;
        uint64_t vertices, corners;
        dm_result result;
        const char* says;
    } cases[] = {{nan, corners, most, 3, DM_ERROR_NOT_FINITE, "part 1: vertex 0"},
                 {nan, corners, most + 1, 3, DM_ERROR_TOO_LARGE, "part 1: more than"},
                 {nan, corners, 3, 3 * most, DM_ERROR_NOT_FINITE, "vertex 0"},
                 {nan, corners, 3, 3 * most + 3, DM_ERROR_TOO_LARGE, "more than"},
                 {nan, corners, 3, 2, DM_ERROR_INVALID_ARGUMENT, "3 vertices and 2 indices"},
                 {nan, corners, 3, 0, DM_ERROR_INVALID_ARGUMENT, "0 indices"},
                 {nan, corners, 0, 3, DM_ERROR_INVALID_ARGUMENT, "0 vertices"},
                 {NULL, corners, 3, 3, DM_ERROR_INVALID_ARGUMENT, "part 1"},
                 {zeros, NULL, 3, 3, DM_ERROR_INVALID_ARGUMENT, "part 1"},
                 {zeros, bad, 3, 3, DM_ERROR_INDEX_OUT_OF_RANGE, "part 1: index 2 names vertex 3 of 3"},
                 {zeros, corners, 3, 3, DM_OK, NULL}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        test_env t;
        void* data = NULL;
        size_t size = 0;
        test_env_open(&t, TEST_NEVER);
        const dm_allocator allocator = test_allocator(&t.memory);
        const dm_log log = test_log(&t.messages);
        const dm_gltf_part parts[2] = {
            {"one", zeros, corners, 3, 3, {1, 1, 1, 1}},
            {"two", cases[i].positions, cases[i].indices, cases[i].vertices, cases[i].corners, {1, 1, 1, 1}}};
        assert_int_equal(dm_gltf_write(parts, 2, &allocator, &log, &data, &size), cases[i].result);
        if (cases[i].says) assert_non_null(strstr(t.messages.text, cases[i].says));
        assert_int_equal(data != NULL, cases[i].result == DM_OK);
        if (data) allocator.release(allocator.user, data, size);
        assert_int_equal(dm_gltf_write(parts, 0, &allocator, &log, &data, &size), DM_ERROR_INVALID_ARGUMENT);
        assert_int_equal(dm_gltf_write(NULL, 2, &allocator, &log, &data, &size), DM_ERROR_INVALID_ARGUMENT);
        assert_int_equal(dm_gltf_write(parts, 1, &allocator, &log, NULL, &size), DM_ERROR_INVALID_ARGUMENT);
        assert_int_equal(dm_gltf_write(parts, 1, &allocator, &log, &data, NULL), DM_ERROR_INVALID_ARGUMENT);
        test_env_close(&t);
    }
}

/* ---- memory ---- */

/* A mesh of few bytes a vertex, or a triangle, that many nodes show: the memory of both is bounded. */
static void repeated_meshes_cost_what_they_hold(void** state) {
    (void)state;
    enum { ITEMS = 60000, FEW = 40, MANY = 100, BYTES = 3 * ITEMS + 16 };
    for (int triangles = 0; triangles < 2; triangles++)
        for (int nodes = FEW; nodes <= MANY; nodes += MANY - FEW) {
            char json[TEXT];
            uint8_t* bytes = calloc(1, BYTES);
            for (int i = 0; i < 3; i++) bytes[ITEMS * 3 + i] = (uint8_t)i;
            size_t length = (size_t)snprintf(
                json, sizeof json,
                "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":%d}],\"bufferViews\":[{\"buffer\":0,"
                "\"byteLength\":%d},{\"buffer\":0,\"byteOffset\":%d,\"byteLength\":3}],\"accessors\":[{\"bufferView\":"
                "0,"
                "\"componentType\":5121,\"count\":%d,\"type\":\"VEC3\"},{\"bufferView\":%d,\"componentType\":5121,"
                "\"count\":%d,\"type\":\"SCALAR\"}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},"
                "\"indices\":1}]}],\"nodes\":[{\"mesh\":0}",
                BYTES, 3 * ITEMS, 3 * ITEMS, triangles ? 3 : ITEMS, triangles ? 0 : 1, triangles ? 3 * ITEMS : 3);
            for (int i = 1; i < nodes; i++)
                length += (size_t)snprintf(json + length, sizeof json - length, ",{\"mesh\":0}");
            snprintf(json + length, sizeof json - length, "]}");
            opened o;
            open_json(&o, json, bytes, BYTES);
            expect(&o, nodes == FEW ? DM_OK : DM_ERROR_TOO_LARGE,
                   nodes == FEW ? NULL
                   : triangles  ? "glTF: the triangles"
                                : "glTF: the vertices");
            close_it(&o);
            free(bytes);
        }
}

#define TWO_PRIMITIVES                                                                                                 \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1,\"mode\":5},"                         \
    "{\"attributes\":{\"POSITION\":0},\"indices\":1,\"mode\":4}]}],"                                                   \
    "\"nodes\":[{\"mesh\":0,\"children\":[1]},{\"name\":\"x\",\"mesh\":0}]}"

static test_glb two_primitives(int corners) {
    char json[TEXT];
    const size_t size = 48 + (size_t)corners;
    uint8_t* bytes = calloc(1, size);
    const float xyz[VERTICES][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    memcpy(bytes, xyz, sizeof xyz);
    for (int i = 0; i < corners; i++) bytes[48 + i] = (uint8_t)(i % 4);
    snprintf(json, sizeof json,
             "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":%d}],\"bufferViews\":[{\"buffer\":0,"
             "\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48,\"byteLength\":%d}],\"accessors\":[{\"bufferView\":0,"
             "\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},{\"bufferView\":1,\"componentType\":5121,"
             "\"count\":%d,\"type\":\"SCALAR\"}]," TWO_PRIMITIVES,
             48 + corners, corners, corners);
    const test_glb glb = test_glb_pack(json, bytes, size);
    free(bytes);
    return glb;
}

/* A failed allocation fails the call, never a part of what is read; also where the next one succeeds. */
static void no_failed_allocation_is_passed_over(void** state) {
    (void)state;
    const test_glb glb = two_primitives(12);
    for (int once = 0; once < 2; once++) {
        int64_t n = 0;
        for (dm_result result = DM_ERROR_OUT_OF_MEMORY; result != DM_OK; n++) {
            opened o;
            open_glb(&o, &glb, n, once, -1);
            result = o.result;
            assert_int_equal(result, o.t.memory.calls > n ? DM_ERROR_OUT_OF_MEMORY : DM_OK);
            if (result != DM_OK) assert_non_null(strstr(o.t.messages.text, "no memory"));
            close_it(&o);
        }
        assert_true(n > 20);
    }
    free(glb.data);
}

/* Each report of a large file may stop it, wherever it is: nothing of it is left out instead. */
static void every_report_may_stop_the_call(void** state) {
    (void)state;
    const test_glb glb = two_primitives(3 << 16);
    opened o;
    open_glb(&o, &glb, TEST_NEVER, false, -1);
    expect(&o, DM_OK, NULL);
    const int reports = o.reports;
    close_it(&o);
    assert_true(reports > 8); /* five of every file, and some of its triangles */
    for (int stop = 0; stop < reports; stop++) {
        open_glb(&o, &glb, TEST_NEVER, false, stop);
        expect(&o, DM_ERROR_CANCELLED, "asked to stop at");
        assert_int_equal(o.reports, stop + 1);
        close_it(&o);
    }
    free(glb.data);
}

/* ---- names ---- */

static void numbers_of_nodes(void** state) {
    (void)state;
    const float xyz[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    static const struct {
        const char* name;
        int node; /* that it stands for; -1: none */
    } names[] = {{"#1", 1},   {"#2", 2},           {"#9", 9},   {"#10", 10}, {"#0", 4},   {"door", 0},
                 {"x1", 5},   {"#11", -1},         {"#12", -1}, {"x2", -1},  {"2", -1},   {"", -1},
                 {"#", -1},   {"#1 ", -1},         {"# 1", -1}, {"#+1", -1}, {"#-1", -1}, {"#1x", -1},
                 {"##1", -1}, {"#4294967297", -1}, {"#/", -1},  {"#:", -1},  {"#x1", -1}, {"#18446744073709551617", -1},
                 {"doo", -1}, {"door1", -1},       {"Door", -1}};
    char json[TEXT];
    size_t length =
        (size_t)snprintf(json, sizeof json,
                         "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36}],\"bufferViews\":[{"
                         "\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,"
                         "\"count\":3,\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}"
                         "}]}],\"nodes\":[{\"name\":\"door\",\"mesh\":0}");
    for (int i = 1; i < 11; i++)
        length += (size_t)snprintf(json + length, sizeof json - length, ",{%s\"mesh\":0}",
                                   i == 4   ? "\"name\":\"#0\","
                                   : i == 5 ? "\"name\":\"x1\","
                                            : "");
    snprintf(json + length, sizeof json - length, "]}");
    opened o;
    open_json(&o, json, xyz, sizeof xyz);
    expect(&o, DM_OK, NULL);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        uint8_t ids[11] = {0}, want[11] = {0};
        /* Nodes without a name are all called "". */
        for (int n = 1; names[i].name[0] == 0 && n < 11; n++) want[n] = n != 4 && n != 5;
        if (names[i].node >= 0) want[names[i].node] = 1;
        const dm_result result = dm_gltf_mark_faces(o.gltf, &names[i].name, 1, 1, ids, 11);
        const bool found = names[i].node >= 0 || names[i].name[0] == 0;
        if (result != (found ? DM_OK : DM_ERROR_NOT_FOUND) || memcmp(ids, want, sizeof ids) != 0)
            fail_msg("'%s': %d", names[i].name, result);
        /* Who looks for a name that there is not learns some that there are. */
        if (!found && !strstr(o.t.messages.text, "; the file has 'door', #1, #2, #3, '#0', 'x1', #6, #7 and 3 more"))
            fail_msg("%s", o.t.messages.text);
    }
    close_it(&o);
}

/* ---- the origin ---- */

/* Objects get an origin of their own from 256 times their size away on; whatever their size, and on
 * whichever side they lie. */
static void an_origin_for_what_is_far(void** state) {
    (void)state;
    const float xyz[VERTICES][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int way = 0; way < 3 * 2 * 3 * 2; way++) {
        const int axis = way % 3, far = way / 3 % 2;
        const double size = way / 6 % 3 == 0 ? 0.015625 : way / 6 % 3 == 1 ? 1 : 64, sign = way / 18 ? -1 : 1;
        double at[3] = {0, 0, 0}, origin[3];
        char json[TEXT];
        at[axis] = sign * size * (far ? 256.1 : 255.9) - size / 2;
        snprintf(json, sizeof json,
                 "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":48}],\"bufferViews\":[{\"buffer\":0,"
                 "\"byteLength\":48}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":"
                 "\"VEC3\"}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":5}]}],"
                 "\"nodes\":[{\"mesh\":0,\"scale\":[%.17g,%.17g,%.17g],\"translation\":[%.17g,%.17g,%.17g]}]}",
                 size, size, size, at[0], at[1], at[2]);
        opened o;
        open_json(&o, json, xyz, sizeof xyz);
        expect(&o, DM_OK, NULL);
        dm_gltf_get_origin(o.gltf, origin);
        for (int k = 0; k < 3; k++) {
            volatile float held = (float)origin[k]; /* as viewers hold it: no bit of it is lost */
            assert_true((double)held == origin[k]);
            assert_true(fabs(origin[k] - (far ? at[k] + size / 2 : 0)) < 2e-5 * size);
            for (size_t v = 0; v < VERTICES; v++)
                assert_float_equal(position(&o, v)[k], (float)(size * (double)xyz[v][k] + at[k] - origin[k]),
                                   1e-6f * (float)size);
        }
        close_it(&o);
    }
    double none[3] = {1, 2, 3};
    dm_gltf_get_origin(NULL, none);
    for (int k = 0; k < 3; k++) assert_true(none[k] == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_means_what_the_standard_says),
        cmocka_unit_test(a_byte_less_is_too_few),
        cmocka_unit_test(a_change_is_of_a_vertex_that_there_is),
        cmocka_unit_test(indices_of_every_type_and_mode),
        cmocka_unit_test(every_corner_is_a_vertex_that_there_is),
        cmocka_unit_test(as_many_elements_as_there_may_be),
        cmocka_unit_test(as_many_elements_as_may_be_written),
        cmocka_unit_test(repeated_meshes_cost_what_they_hold),
        cmocka_unit_test(no_failed_allocation_is_passed_over),
        cmocka_unit_test(every_report_may_stop_the_call),
        cmocka_unit_test(numbers_of_nodes),
        cmocka_unit_test(an_origin_for_what_is_far),
    };
    return cmocka_run_group_tests_name("gltf_edges", tests, NULL, NULL);
}
