/* The checked mesh: formats and strides, normalisation, parts, and a named error for every kind of bad input. */
#include "test_env.h"

#include <float.h>
#include <math.h>

#include "mesh/mesh.h"
#include "test_shapes.h"

static test_shape shape;

static dmi_axes gltf_axes(void) {
    dmi_axes axes;
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    return axes;
}

static dmi_mesh* create(test_env* t, const dm_mesh_desc* desc, const dm_part_desc* parts, uint32_t count) {
    dmi_axes axes = gltf_axes();
    dmi_mesh* mesh = NULL;
    dm_result result = dmi_mesh_create(&t->env, &axes, desc, parts, count, NULL, &mesh);
    if (result != DM_OK) print_error("%s\n", t->messages.text);
    assert_int_equal(result, DM_OK);
    return mesh;
}

/* The call must fail with `code`, say `words`, leave the output alone and leak nothing. */
static void expect_failure(const dm_mesh_desc* desc, const dm_part_desc* parts, uint32_t count, dm_result code,
                           const char* words) {
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_axes axes = gltf_axes();
    dmi_mesh* untouched = (dmi_mesh*)&t;
    assert_int_equal(dmi_mesh_create(&t.env, &axes, desc, parts, count, NULL, &untouched), code);
    assert_ptr_equal(untouched, &t);
    assert_int_equal(t.messages.count, 1);
    assert_int_equal(t.messages.code, code);
    if (strstr(t.messages.text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", t.messages.text, words);
    test_env_close(&t);
}

static dm_mesh_desc cabinet(void) {
    test_shape_cabinet(&shape);
    return test_shape_desc(&shape);
}

static dm_part_desc part_desc(uint32_t id, uint32_t parent) {
    return (dm_part_desc){.struct_size = sizeof(dm_part_desc), .id = id, .parent = parent};
}

/* ---- what comes out ---------------------------------------------------------------------------------------------- */

static void normalises_and_measures(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dm_mesh_desc desc = cabinet();
    dmi_mesh* mesh = create(&t, &desc, NULL, 0);
    assert_int_equal(mesh->vertex_count, 24);
    assert_int_equal(mesh->face_count, 36);
    assert_int_equal(mesh->part_count, 3);
    assert_float_equal(mesh->frame.size, 2, 1e-6);
    assert_float_equal(mesh->frame.centre[0], 1, 1e-6);
    assert_float_equal(mesh->frame.centre[2], 1.07 / 2, 1e-6);
    const dmi_part* door = &mesh->parts[1];
    assert_int_equal(door->id, 1);
    assert_int_equal(door->face_count, 12);
    assert_float_equal(door->box_min[0], -0.5, 1e-6);
    assert_float_equal(door->box_max[0], 0, 1e-6);
    assert_float_equal(door->centre[0], -0.25, 1e-6);
    assert_float_equal(door->centre[1], 0, 1e-6);
    assert_float_equal(door->area, (2 * 1 + 4 * 0.04) / 4, 1e-5);
    assert_float_equal(mesh->winding, 1, 0);
    for (uint32_t f = 0; f < 12; f++) { /* the body's normals point away from its centre */
        const float* n = mesh->face_normal + 3 * f;
        const float* p = mesh->positions + 3 * mesh->indices[3 * f];
        float out = 0;
        for (int k = 0; k < 3; k++) out += n[k] * (p[k] - mesh->parts[0].centre[k]);
        assert_true(out > 0);
        assert_float_equal(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-6);
    }
    float tail[4];
    memcpy(tail, mesh->positions + 3 * mesh->vertex_count, sizeof tail); /* the readable padding */
    dmi_mesh_destroy(&t.env, mesh);
    dmi_mesh_destroy(&t.env, NULL);
    test_env_close(&t);
}

static void a_mesh_wound_inside_out_gets_outward_normals(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dm_mesh_desc desc = cabinet();
    dmi_mesh* straight = create(&t, &desc, NULL, 0);
    for (uint32_t f = 0; f < shape.face_count; f++) {
        uint32_t swap = shape.corners[f][1];
        shape.corners[f][1] = shape.corners[f][2];
        shape.corners[f][2] = swap;
    }
    dmi_mesh* reversed = create(&t, &desc, NULL, 0);
    assert_float_equal(reversed->winding, -1, 0);
    for (uint32_t i = 0; i < 3 * shape.face_count; i++) {
        assert_float_equal(straight->face_normal[i], reversed->face_normal[i], 1e-6);
    }
    dmi_mesh_destroy(&t.env, straight);
    dmi_mesh_destroy(&t.env, reversed);
    test_env_close(&t);
}

/* A big offset costs double input nothing. */
static void doubles_far_from_the_origin_stay_exact(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dm_mesh_desc desc = cabinet();
    dmi_mesh* near = create(&t, &desc, NULL, 0);
    static double far[TEST_SHAPE_MAX][4];
    for (uint32_t v = 0; v < shape.vertex_count; v++) {
        for (int k = 0; k < 3; k++) far[v][k] = (double)shape.xyz[v][k] + 1e7;
    }
    desc.positions = far;
    desc.position_stride = sizeof far[0];
    desc.position_format = DM_FLOAT64;
    dmi_mesh* away = create(&t, &desc, NULL, 0);
    for (uint32_t i = 0; i < 3 * shape.vertex_count; i++) {
        assert_float_equal(near->positions[i], away->positions[i], 1e-6);
    }
    dmi_mesh_destroy(&t.env, near);
    dmi_mesh_destroy(&t.env, away);
    test_env_close(&t);
}

static void host_axes_give_the_same_inner_mesh(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dm_mesh_desc desc = cabinet();
    dmi_mesh* gltf = create(&t, &desc, NULL, 0);
    dmi_axes unreal;
    assert_true(dmi_axes_init(&unreal, DM_AXES_UNREAL, NULL, 0.01f));
    for (uint32_t v = 0; v < shape.vertex_count; v++) { /* centimetres, y and z change places */
        float* p = shape.xyz[v];
        float y = p[1];
        p[0] *= 100;
        p[1] = p[2] * 100;
        p[2] = y * 100;
    }
    dmi_mesh* mesh = NULL;
    assert_int_equal(dmi_mesh_create(&t.env, &unreal, &desc, NULL, 0, NULL, &mesh), DM_OK);
    for (uint32_t i = 0; i < 3 * shape.vertex_count; i++) {
        assert_float_equal(gltf->positions[i], mesh->positions[i], 1e-6);
        assert_float_equal(gltf->face_normal[i], mesh->face_normal[i], 1e-6);
    }
    dmi_mesh_destroy(&t.env, gltf);
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

static void vertices_of_no_triangle_do_not_count(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dm_mesh_desc desc = cabinet();
    test_shape_vertex(&shape, 1e30f, -1e30f, 0);
    desc.vertex_count = shape.vertex_count;
    dmi_mesh* mesh = create(&t, &desc, NULL, 0);
    assert_float_equal(mesh->frame.size, 2, 1e-6);
    for (uint32_t i = 0; i < 3 * mesh->vertex_count; i++) assert_true(fabsf(mesh->positions[i]) <= 1);
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

/* ---- formats and strides ------------------------------------------------------------------------------------------
 */

static void same_mesh(const dmi_mesh* a, const dmi_mesh* b) {
    assert_int_equal(a->vertex_count, b->vertex_count);
    assert_int_equal(a->face_count, b->face_count);
    assert_memory_equal(a->positions, b->positions, a->vertex_count * 12);
    assert_memory_equal(a->indices, b->indices, a->face_count * 12);
    assert_memory_equal(a->face_part, b->face_part, a->face_count * 4);
}

static void every_index_format_reads_the_same(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dm_mesh_desc desc = cabinet();
    dmi_mesh* plain = create(&t, &desc, NULL, 0);
    uint16_t u16[108];
    uint8_t u8[108];

    for (int i = 0; i < 108; i++) {
        u16[i] = (uint16_t)shape.corners[i / 3][i % 3];
        u8[i] = (uint8_t)shape.corners[i / 3][i % 3];
    }
    const void* buffers[] = {[DM_UINT16] = u16, [DM_UINT8] = u8};
    for (int format = DM_UINT16; format <= DM_UINT8; format++) {
        desc.indices = buffers[format];
        desc.index_format = format;
        dmi_mesh* mesh = create(&t, &desc, NULL, 0);
        same_mesh(plain, mesh);
        dmi_mesh_destroy(&t.env, mesh);
    }
    dmi_mesh_destroy(&t.env, plain);
    test_env_close(&t);
}

static void triangle_soup_needs_no_indices(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dm_mesh_desc desc = cabinet();
    static float soup[108][3];
    for (int i = 0; i < 108; i++) memcpy(soup[i], shape.xyz[shape.corners[i / 3][i % 3]], sizeof soup[i]);
    desc.positions = soup;
    desc.vertex_count = 108;
    desc.indices = NULL;
    for (int i = 0; i < 2; i++) { /* a count that says the same is no mistake */
        desc.index_count = i == 0 ? 0 : 108;
        dmi_mesh* mesh = create(&t, &desc, NULL, 0);
        assert_int_equal(mesh->face_count, 36);
        assert_int_equal(mesh->indices[107], 107);
        assert_int_equal(mesh->parts[1].face_count, 12);
        dmi_mesh_destroy(&t.env, mesh);
    }
    desc.index_count = 3;
    expect_failure(&desc, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "indices: NULL");
    desc.index_count = 0;
    desc.vertex_count = 107;
    expect_failure(&desc, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "multiple of 3");
    test_env_close(&t);
}

/* An interleaved, unaligned vertex: position, a byte of part id, odd padding. */
static void interleaved_and_unaligned_buffers_are_read_in_place(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dm_mesh_desc desc = cabinet();
    dmi_mesh* plain = create(&t, &desc, NULL, 0);
    enum { STRIDE = 17 };
    static char packed[1 + STRIDE * 24];
    for (uint32_t v = 0; v < 24; v++) {
        memcpy(packed + 1 + STRIDE * v, shape.xyz[v], 12);
        packed[1 + STRIDE * v + 13] = (char)(v / 8);
    }
    desc.positions = packed + 1;
    desc.position_stride = STRIDE;
    desc.part_ids = packed + 1 + 13;
    desc.part_id_stride = STRIDE;
    desc.part_id_format = DM_UINT8;
    desc.part_id_scope = DM_PER_VERTEX;
    dmi_mesh* mesh = create(&t, &desc, NULL, 0);
    same_mesh(plain, mesh);
    dmi_mesh_destroy(&t.env, mesh);
    dmi_mesh_destroy(&t.env, plain);
    test_env_close(&t);
}

static void part_ids_come_in_four_formats(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dm_mesh_desc desc = cabinet();
    dmi_mesh* plain = create(&t, &desc, NULL, 0);
    uint16_t u16[36];
    uint8_t u8[36];
    int32_t i32[36];
    for (int f = 0; f < 36; f++) {
        u16[f] = (uint16_t)shape.part[f];
        u8[f] = (uint8_t)shape.part[f];
        i32[f] = shape.part[f] == 0 ? -7 - f : (int32_t)shape.part[f]; /* negative = body */
    }
    const void* buffers[] = {[DM_UINT32] = shape.part, [DM_UINT16] = u16, [DM_UINT8] = u8, [DM_INT32] = i32};
    for (int format = DM_UINT32; format <= DM_INT32; format++) {
        desc.part_ids = buffers[format];
        desc.part_id_format = format;
        dmi_mesh* mesh = create(&t, &desc, NULL, 0);
        same_mesh(plain, mesh);
        dmi_mesh_destroy(&t.env, mesh);
    }
    dmi_mesh_destroy(&t.env, plain);
    test_env_close(&t);
}

/* ---- parts --------------------------------------------------------------------------------------------------------
 */

static void a_triangle_follows_two_of_its_corners_else_the_smallest_id(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    shape.vertex_count = shape.face_count = 0;
    static const uint32_t ids[][3] = {{5, 5, 9}, {5, 9, 5}, {9, 5, 5}, {9, 7, 5},
                                      {9, 0, 7}, {0, 0, 9}, {9, 9, 9}, {7, 7, 0}};
    static const uint32_t expected[] = {5, 5, 5, 5, 0, 0, 9, 7};
    uint32_t vertex_ids[24];
    for (uint32_t f = 0; f < 8; f++) {
        for (uint32_t i = 0; i < 3; i++) vertex_ids[3 * f + i] = ids[f][i];
        uint32_t a = test_shape_vertex(&shape, (float)f, 0, 0);
        test_shape_vertex(&shape, (float)f + 1, 0, 0);
        test_shape_vertex(&shape, (float)f, 1, 0);
        test_shape_face(&shape, a, a + 1, a + 2, 0);
    }
    dm_mesh_desc desc = test_shape_desc(&shape);
    desc.part_ids = vertex_ids;
    desc.part_id_scope = DM_PER_VERTEX;
    dmi_mesh* mesh = create(&t, &desc, NULL, 0);
    for (uint32_t f = 0; f < 8; f++) assert_int_equal(mesh->parts[mesh->face_part[f]].id, expected[f]);
    dmi_mesh_destroy(&t.env, mesh);

    /* With a list that does not know 5 and 9 they are the body's, before the corners vote. */
    dm_part_desc seven = part_desc(7, 0);
    mesh = create(&t, &desc, &seven, 1);
    for (uint32_t f = 0; f < 8; f++) assert_int_equal(mesh->parts[mesh->face_part[f]].id, f == 7 ? 7 : 0);
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

static void sparse_ids_are_sorted_and_found(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    shape.vertex_count = shape.face_count = 0;
    static const uint32_t ids[] = {UINT32_MAX, 0, 100000, 7, 8192, 16384, 4000000000u};
    for (int i = 0; i < 7; i++) {
        float low[3] = {(float)i, 0, 0}, high[3] = {(float)i + 0.5f, 1, 1};
        test_shape_box(&shape, low, high, ids[i]);
    }
    dm_mesh_desc desc = test_shape_desc(&shape);
    dmi_mesh* mesh = create(&t, &desc, NULL, 0);
    assert_int_equal(mesh->part_count, 7);
    for (uint32_t p = 0; p < 7; p++) {
        if (p > 0) assert_true(mesh->parts[p].id > mesh->parts[p - 1].id);
        assert_int_equal(mesh->parts[p].face_count, 12);
        assert_int_equal(dmi_mesh_find_part(mesh, mesh->parts[p].id), p);
    }
    assert_int_equal(dmi_mesh_find_part(mesh, 8), -1);
    assert_int_equal(dmi_mesh_find_part(mesh, UINT32_MAX - 1), -1);
    for (uint32_t f = 0; f < 84; f++) assert_int_equal(mesh->parts[mesh->face_part[f]].id, ids[f / 12]);
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

static void many_parts_up_to_the_limit(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    static float xyz[DM_MAX_PARTS + 2][3][3];
    static uint32_t ids[DM_MAX_PARTS + 2];
    for (uint32_t f = 0; f < DM_MAX_PARTS + 2; f++) {
        ids[f] = f == 0 ? 0 : (f * 2654435761u) | 1; /* odd times odd: all different */
        for (int i = 0; i < 3; i++) {
            xyz[f][i][0] = (float)f + (i == 1);
            xyz[f][i][1] = i == 2 ? 100 : 0;
        }
    }
    dm_mesh_desc desc = {
        .positions = xyz, .vertex_count = 3 * (DM_MAX_PARTS + 1), .part_ids = ids, .part_id_scope = DM_PER_FACE};
    dmi_mesh* mesh = create(&t, &desc, NULL, 0);
    uint32_t distinct = mesh->part_count;
    assert_true(distinct > DM_MAX_PARTS / 2);
    for (uint32_t f = 0; f < mesh->face_count; f++) assert_int_equal(mesh->parts[mesh->face_part[f]].id, ids[f]);
    dmi_mesh_destroy(&t.env, mesh);
    for (uint32_t f = 0; f < DM_MAX_PARTS + 2; f++) ids[f] = f * 3;
    mesh = create(&t, &desc, NULL, 0);
    assert_int_equal(mesh->part_count, DM_MAX_PARTS + 1);
    dmi_mesh_destroy(&t.env, mesh);
    desc.vertex_count += 3;
    expect_failure(&desc, NULL, 0, DM_ERROR_TOO_LARGE, "more than 4096 parts");
    test_env_close(&t);
}

static void parts_carry_parts(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dm_mesh_desc desc = cabinet();
    dm_part_desc parts[] = {part_desc(2, 1), part_desc(1, 0)}; /* the handle hangs on the door; in any order */
    dmi_mesh* mesh = create(&t, &desc, parts, 2);
    assert_int_equal(mesh->parts[2].parent, 1);
    assert_int_equal(mesh->parts[1].parent, 0);
    static const int moves[3][3] = {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}};
    for (uint32_t i = 0; i < 3; i++) {
        for (uint32_t k = 0; k < 3; k++) assert_int_equal(dmi_mesh_moves_with(mesh, i, k), moves[i][k]);
    }
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

/* ---- bad input ----------------------------------------------------------------------------------------------------
 */

static void wrong_descriptions_are_named(void** state) {
    (void)state;
    expect_failure(NULL, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "dm_mesh_desc: NULL");
    const dm_mesh_desc good = cabinet();
    dm_mesh_desc d;
    d = good;
    d.positions = NULL;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "positions: NULL");
    d = good;
    d.part_ids = NULL;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "part_ids: NULL");
    d = good;
    d.vertex_count = 0;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "vertex_count: 0");
    d = good;
    d.vertex_count = DM_MAX_ELEMENTS + 1ull;
    expect_failure(&d, NULL, 0, DM_ERROR_TOO_LARGE, "vertex_count: 268435457");
    d = good;
    d.vertex_count = UINT64_MAX;
    expect_failure(&d, NULL, 0, DM_ERROR_TOO_LARGE, "vertex_count");
    d = good;
    d.index_count = 0;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "index_count: 0");
    d = good;
    d.index_count = 107;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "index_count: 107");
    d = good;
    d.index_count = UINT64_MAX;
    expect_failure(&d, NULL, 0, DM_ERROR_TOO_LARGE, "index_count");
    d = good;
    d.index_count = 3 * (DM_MAX_ELEMENTS + 1ull);
    expect_failure(&d, NULL, 0, DM_ERROR_TOO_LARGE, "index_count");
    d = good;
    d.position_format = 2;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "position_format: unknown value 2");
    d = good;
    d.position_format = -1;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "position_format");
    d = good;
    d.index_format = DM_INT32;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "index_format: unknown value 3");
    d = good;
    d.index_format = 99;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "index_format");
    d = good;
    d.part_id_format = 4;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "part_id_format: unknown value 4");
    d = good;
    d.part_id_scope = 2;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "part_id_scope: unknown value 2");
    d = good;
    d.position_stride = 11;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "position_stride: 11 bytes, an element has 12");
    d = good;
    d.position_stride = 23;
    d.position_format = DM_FLOAT64;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "position_stride: 23");
    d = good;
    d.part_id_stride = 3;
    expect_failure(&d, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "part_id_stride: 3 bytes, an element has 4");
}

static void bad_numbers_name_their_place(void** state) {
    (void)state;
    const float bad[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 3; i++) {
        dm_mesh_desc desc = cabinet();
        shape.xyz[17][i] = bad[i];
        expect_failure(&desc, NULL, 0, DM_ERROR_NOT_FINITE, "vertex 17");
    }
    dm_mesh_desc desc = cabinet();
    static double wide[TEST_SHAPE_MAX][3];
    for (uint32_t v = 0; v < shape.vertex_count; v++) {
        for (int k = 0; k < 3; k++) wide[v][k] = (double)shape.xyz[v][k];
    }
    wide[3][1] = 1e300; /* a number, but no float */
    desc.positions = wide;
    desc.position_format = DM_FLOAT64;
    expect_failure(&desc, NULL, 0, DM_ERROR_NOT_FINITE, "vertex 3 is (2, 1e+300, 0)");
    desc = cabinet();
    shape.corners[5][2] = 24;
    expect_failure(&desc, NULL, 0, DM_ERROR_INDEX_OUT_OF_RANGE, "face 5 names vertex 24, there are 24 vertices");
    shape.corners[5][2] = UINT32_MAX;
    expect_failure(&desc, NULL, 0, DM_ERROR_INDEX_OUT_OF_RANGE, "vertex 4294967295");
}

/* A door leaf alone has no body: it counts as a point in the object's middle. */
static void a_body_may_be_missing(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    const dm_mesh_desc desc = cabinet();
    for (uint32_t f = 0; f < shape.face_count; f++) shape.part[f] = 1;
    dmi_mesh* mesh = create(&t, &desc, NULL, 0);
    assert_int_equal(mesh->part_count, 2);
    assert_int_equal(mesh->parts[0].face_count, 0);
    assert_int_equal(mesh->parts[1].face_count, 36);
    for (int k = 0; k < 3; k++) {
        assert_float_equal(mesh->parts[0].box_min[k], 0, 0);
        assert_float_equal(mesh->parts[0].box_max[k], 0, 0);
        assert_float_equal(mesh->parts[0].centre[k], 0, 0);
    }
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

static void masks_need_a_part(void** state) {
    (void)state;
    dm_mesh_desc desc = cabinet();
    dm_part_desc parts[] = {part_desc(1, 0), part_desc(2, 0), part_desc(77, 0)};
    expect_failure(&desc, parts, 3, DM_ERROR_EMPTY_MASK, "part 77");
    memset(shape.part, 0, sizeof shape.part);
    expect_failure(&desc, NULL, 0, DM_ERROR_EMPTY_MASK, "no triangle belongs to a part");
    expect_failure(&desc, parts, 1, DM_ERROR_EMPTY_MASK, "part 1");
}

static void part_lists_are_checked(void** state) {
    (void)state;
    dm_mesh_desc desc = cabinet();
    dm_part_desc one = part_desc(1, 0);
    expect_failure(&desc, NULL, 2, DM_ERROR_INVALID_ARGUMENT, "parts: NULL, but part_count is 2");
    expect_failure(&desc, &one, 0, DM_ERROR_INVALID_ARGUMENT, "part_count: 0");
    expect_failure(&desc, &one, DM_MAX_PARTS + 1, DM_ERROR_TOO_LARGE, "part_count: 4097");
    dm_part_desc zero[] = {part_desc(1, 0), part_desc(0, 0)};
    expect_failure(&desc, zero, 2, DM_ERROR_INVALID_ARGUMENT, "0 (the body) in parts[1]");
    dm_part_desc twice[] = {part_desc(2, 0), part_desc(1, 0), part_desc(2, 0)};
    expect_failure(&desc, twice, 3, DM_ERROR_INVALID_ARGUMENT, "2 in both parts[0] and parts[2]");
    dm_part_desc stranger[] = {part_desc(1, 0), part_desc(2, 3)};
    expect_failure(&desc, stranger, 2, DM_ERROR_INVALID_ARGUMENT, "parent: 3 in parts[1]");
    dm_part_desc self[] = {part_desc(1, 1)};
    expect_failure(&desc, self, 1, DM_ERROR_INVALID_ARGUMENT, "circle");
    dm_part_desc circle[] = {part_desc(1, 2), part_desc(2, 1)};
    expect_failure(&desc, circle, 2, DM_ERROR_INVALID_ARGUMENT, "circle");
}

static void meshes_without_area_are_degenerate(void** state) {
    (void)state;
    dm_mesh_desc desc = cabinet();
    for (uint32_t v = 0; v < 24; v++) memcpy(shape.xyz[v], shape.xyz[0], 12);
    expect_failure(&desc, NULL, 0, DM_ERROR_DEGENERATE_MESH, "in one point");
    desc = cabinet();
    for (uint32_t v = 0; v < 24; v++) { /* a line, askew */
        for (int k = 0; k < 3; k++) shape.xyz[v][k] = (float)v * (0.1f + 0.17f * (float)k);
    }
    expect_failure(&desc, NULL, 0, DM_ERROR_DEGENERATE_MESH, "no triangle has an area");
    desc = cabinet();
    for (uint32_t v = 16; v < 24; v++) memcpy(shape.xyz[v], shape.xyz[16], 12);
    expect_failure(&desc, NULL, 0, DM_ERROR_DEGENERATE_MESH, "12 triangles of part 2 has an area");
    desc = cabinet();
    for (uint32_t v = 0; v < 8; v++) memcpy(shape.xyz[v], shape.xyz[0], 12);
    expect_failure(&desc, NULL, 0, DM_ERROR_DEGENERATE_MESH, "part 0 (the body)");
    desc = cabinet();
    for (uint32_t v = 0; v < 24; v++) shape.xyz[v][0] *= 1e30f;
    expect_failure(&desc, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "m large");
    desc = cabinet();
    for (uint32_t v = 0; v < 24; v++) shape.xyz[v][0] += 2e37f;
    expect_failure(&desc, NULL, 0, DM_ERROR_INVALID_ARGUMENT, "too far away");
}

static void slivers_get_no_normal(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dm_mesh_desc desc = cabinet();
    uint32_t a = test_shape_vertex(&shape, 0, 0, 0), b = test_shape_vertex(&shape, 2, 1, 1);
    test_shape_face(&shape, a, b, test_shape_vertex(&shape, 1, 0.5f, 0.5f), 1);
    test_shape_face(&shape, a, a, b, 1);
    desc = test_shape_desc(&shape);
    dmi_mesh* mesh = create(&t, &desc, NULL, 0);
    for (uint32_t f = 36; f < 38; f++) {
        assert_float_equal(mesh->face_area[f], 0, 0);
        for (uint32_t k = 0; k < 3; k++) assert_float_equal(mesh->face_normal[3 * f + k], 0, 0);
    }
    assert_int_equal(mesh->parts[1].face_count, 14);
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

static void every_refused_allocation_is_reported(void** state) {
    (void)state;
    dm_mesh_desc desc = cabinet();
    dm_part_desc parts[] = {part_desc(1, 0), part_desc(2, 1)};
    for (int with_list = 0; with_list < 2; with_list++) {
        for (int64_t n = 0;; n++) {
            test_env t;
            test_env_open(&t, n);
            dmi_axes axes = gltf_axes();
            dmi_mesh* mesh = NULL;
            dm_result result =
                dmi_mesh_create(&t.env, &axes, &desc, with_list ? parts : NULL, with_list ? 2 : 0, NULL, &mesh);
            if (result == DM_OK) {
                dmi_mesh_destroy(&t.env, mesh);
                test_env_close(&t);
                assert_true(n >= 9);
                break;
            }
            assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
            assert_int_equal(t.messages.code, DM_ERROR_OUT_OF_MEMORY);
            assert_null(mesh);
            test_env_close(&t);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normalises_and_measures),
        cmocka_unit_test(a_mesh_wound_inside_out_gets_outward_normals),
        cmocka_unit_test(doubles_far_from_the_origin_stay_exact),
        cmocka_unit_test(host_axes_give_the_same_inner_mesh),
        cmocka_unit_test(vertices_of_no_triangle_do_not_count),
        cmocka_unit_test(every_index_format_reads_the_same),
        cmocka_unit_test(triangle_soup_needs_no_indices),
        cmocka_unit_test(interleaved_and_unaligned_buffers_are_read_in_place),
        cmocka_unit_test(part_ids_come_in_four_formats),
        cmocka_unit_test(a_triangle_follows_two_of_its_corners_else_the_smallest_id),
        cmocka_unit_test(sparse_ids_are_sorted_and_found),
        cmocka_unit_test(many_parts_up_to_the_limit),
        cmocka_unit_test(parts_carry_parts),
        cmocka_unit_test(wrong_descriptions_are_named),
        cmocka_unit_test(bad_numbers_name_their_place),
        cmocka_unit_test(a_body_may_be_missing),
        cmocka_unit_test(masks_need_a_part),
        cmocka_unit_test(part_lists_are_checked),
        cmocka_unit_test(meshes_without_area_are_degenerate),
        cmocka_unit_test(slivers_get_no_normal),
        cmocka_unit_test(every_refused_allocation_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
