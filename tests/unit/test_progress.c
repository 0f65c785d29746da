/* Progress and cancelling of a large mesh: reports come the oftener the larger it is, rise, and stop the call where
 * they are told to, whatever picks. Counted, not timed. */
#include "dragmesh/ext/gltf.h"
#include "test_world.h"

/* Quads a side; the meshes have 131,000 and 262,000 triangles. */
enum { SMALL = 256, LARGE = 362 };

/* A mesh gets a report for so many triangles at least; measured: one for 400 (Embree) to 20,000 (no picking). */
enum { TRIANGLES_A_REPORT = 65536 };

/* Times that a call is stopped, spread over its reports. */
enum { MOST_STOPS = 8 };
#define LEAST_DONE 0.9f /* told by the last report of a whole call */

typedef struct grid {
    float (*xyz)[3];
    uint32_t (*corners)[3];
    uint8_t* part;
    uint32_t vertices, faces;
} grid;

/* A wavy sheet of side x side quads, the upper half of them a part. */
static grid make_grid(uint32_t side) {
    grid g = {.vertices = (side + 1) * (side + 1), .faces = 2 * side * side};
    g.xyz = malloc(g.vertices * sizeof *g.xyz);
    g.corners = malloc(g.faces * sizeof *g.corners);
    g.part = malloc(g.faces);
    for (uint32_t v = 0; v < g.vertices; v++) {
        const uint32_t x = v % (side + 1), y = v / (side + 1);
        g.xyz[v][0] = (float)x / (float)side;
        g.xyz[v][1] = (float)y / (float)side;
        g.xyz[v][2] = 0.0001f * (float)((x * 7 + y * 13) % 11);
    }
    for (uint32_t q = 0; q < side * side; q++) {
        const uint32_t a = q / side * (side + 1) + q % side, b = a + side + 1;
        memcpy(g.corners[2 * q], (uint32_t[]){a, a + 1, b + 1}, sizeof g.corners[0]);
        memcpy(g.corners[2 * q + 1], (uint32_t[]){a, b + 1, b}, sizeof g.corners[0]);
        g.part[2 * q] = g.part[2 * q + 1] = q >= side * side / 2;
    }
    return g;
}

static void free_grid(grid* g) {
    free(g->xyz);
    free(g->corners);
    free(g->part);
}

typedef struct reports {
    int count, stop_at;
    float last;
    int falls, outside;
} reports;

static int32_t DM_CALL report(void* user, float done) {
    reports* r = user;
    r->falls += done < r->last;
    r->outside += !(done >= 0 && done <= 1);
    r->last = done;
    return ++r->count == r->stop_at;
}

static dm_mesh_desc describe(const grid* g) {
    return (dm_mesh_desc){.struct_size = sizeof(dm_mesh_desc),
                          .positions = g->xyz,
                          .vertex_count = g->vertices,
                          .indices = g->corners,
                          .index_count = 3 * (uint64_t)g->faces,
                          .part_ids = g->part,
                          .part_id_bytes = g->faces,
                          .part_id_format = DM_UINT8,
                          .part_id_scope = DM_PER_FACE};
}

static dm_result prepare(test_world* w, const grid* g, reports* r, dm_object* out_object) {
    const dm_mesh_desc mesh = describe(g);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .progress = report, .progress_user = r};
    return dm_object_prepare(w->context, &desc, out_object);
}

/* Returns how many reports a whole preparation makes. */
static int count_reports(test_world* w, const grid* g) {
    reports r = {0};
    dm_object object = 0;
    assert_int_equal(prepare(w, g, &r, &object), DM_OK);
    assert_int_equal(dm_object_destroy(w->context, object), DM_OK);
    assert_int_equal(r.falls, 0);
    assert_int_equal(r.outside, 0);
    assert_true(r.last == 1);
    print_message("%u triangles: %d reports\n", g->faces, r.count);
    return r.count;
}

static void check(int32_t picking) {
    test_world w;
    test_world_init(&w);
    w.desc.picking = picking;
    test_world_open(&w);
    grid small = make_grid(SMALL), large = make_grid(LARGE);
    const int few = count_reports(&w, &small), many = count_reports(&w, &large);
    assert_true(many > few);
    assert_true(many >= (int)(large.faces / TRIANGLES_A_REPORT));
    const int64_t held = test_world_blocks(&w);
    for (int stop = 1; stop <= few; stop += 1 + few / 6) {
        reports r = {.stop_at = stop};
        dm_object object = 0;
        assert_int_equal(prepare(&w, &small, &r, &object), DM_ERROR_CANCELLED);
        assert_int_equal(r.count, stop); /* and no more of them afterwards */
        assert_int_equal(object, 0);
        assert_int_equal(test_world_blocks(&w), held);
        assert_int_equal(w.messages.code, DM_ERROR_CANCELLED);
    }
    free_grid(&small);
    free_grid(&large);
    test_world_close(&w);
}

/* A body and a row of boxes, each a part. */
static void reports_rise_whatever_the_count_of_parts(void** state) {
    (void)state;
    enum { MOST_PARTS = 40, BOX_FACES = 12, CORNERS = 8 };
    static const uint8_t faces[BOX_FACES][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    static float xyz[(MOST_PARTS + 1) * CORNERS][3];
    static uint32_t corners[(MOST_PARTS + 1) * BOX_FACES][3];
    static uint8_t part[(MOST_PARTS + 1) * BOX_FACES];
    test_world w;
    test_world_init(&w);
    w.desc.picking = DM_PICK_NONE;
    test_world_open(&w);
    for (uint32_t b = 0; b <= MOST_PARTS; b++) {
        for (uint32_t v = 0; v < CORNERS; v++) {
            const float low[3] = {b > 0 ? 1.3f * (float)b : -1, b > 0 ? 0 : -1, b > 0 ? 0 : -1},
                        high[3] = {b > 0 ? 1.3f * (float)b + 1 : 60, b > 0 ? 2 : 3, b > 0 ? 0.1f : 0};
            for (uint32_t k = 0; k < 3; k++) xyz[b * CORNERS + v][k] = v >> k & 1 ? high[k] : low[k];
        }
        for (uint32_t f = 0; f < BOX_FACES; f++) {
            for (uint32_t k = 0; k < 3; k++) corners[b * BOX_FACES + f][k] = b * CORNERS + faces[f][k];
            part[b * BOX_FACES + f] = (uint8_t)b;
        }
    }
    for (uint32_t parts = 1; parts <= MOST_PARTS; parts++) {
        const grid g = {xyz, corners, part, (parts + 1) * CORNERS, (parts + 1) * BOX_FACES};
        reports r = {0};
        dm_object object = 0;
        assert_int_equal(prepare(&w, &g, &r, &object), DM_OK);
        if (r.falls != 0 || r.outside != 0 || r.last != 1)
            fail_msg("%u parts: of %d reports %d fall, %d are no share; the last is %.9g", parts, r.count, r.falls,
                     r.outside, (double)r.last);
        assert_int_equal(dm_object_destroy(w.context, object), DM_OK);
    }
    test_world_close(&w);
}

static void with_code_of_our_own(void** state) {
    (void)state;
    check(DM_PICK_PORTABLE);
}

static void with_what_picks_by_itself(void** state) {
    (void)state;
    check(DM_PICK_AUTO);
}

static void without_picking(void** state) {
    (void)state;
    check(DM_PICK_NONE);
}

/* ---- the calls that the context's callback, or that of a glTF file, hears of ---- */

/* What the calls below have, and what they give. A stopped one must leave it as it is. */
typedef struct setting {
    test_world w;
    grid grid;
    dm_mesh_desc mesh;
    dm_object object; /* prepared, with weights */
    uint8_t* saved;
    size_t saved_size;
    uint8_t* face_ids;
    void* glb;
    size_t glb_size;
    dm_gltf* gltf;
    reports r;
} setting;

static const dm_drag_hint pull = {{0.5f, 0.9f, 0}, {0, 0, 1}};

static dm_gltf_desc describe_gltf(setting* s) {
    return (dm_gltf_desc){.struct_size = sizeof(dm_gltf_desc),
                          .data = s->glb,
                          .size = s->glb_size,
                          .allocator = s->w.desc.allocator,
                          .log = s->w.desc.log,
                          .progress = report,
                          .progress_user = &s->r};
}

static dm_result find_part(setting* s) {
    dm_mesh_desc whole = s->mesh;
    whole.part_ids = NULL;
    whole.part_id_bytes = 0;
    memset(s->face_ids, 7, s->grid.faces);
    const dm_result result = dm_mesh_find_part(s->w.context, &whole, &pull, s->face_ids, s->grid.faces);
    if (result != DM_OK)
        for (uint32_t f = 0; f < s->grid.faces; f++) assert_int_equal(s->face_ids[f], 7);
    return result == DM_ERROR_FULL_MASK ? DM_OK : result; /* it may take the sheet for one part, having looked at all */
}

static dm_result find_among_pieces(setting* s) {
    return dm_mesh_find_part(s->w.context, &s->mesh, &pull, s->face_ids, s->grid.faces);
}

static dm_result prepare_again(setting* s) {
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &s->mesh};
    dm_object object = 0;
    const dm_result result = dm_object_prepare(s->w.context, &desc, &object);
    assert_int_equal(object != 0, result == DM_OK);
    if (result == DM_OK) assert_int_equal(dm_object_destroy(s->w.context, object), DM_OK);
    return result;
}

static dm_result load(setting* s) {
    dm_object object = 0;
    const dm_result result = dm_object_load(s->w.context, s->saved, s->saved_size, 0, &object);
    assert_int_equal(object != 0, result == DM_OK);
    if (result == DM_OK) assert_int_equal(dm_object_destroy(s->w.context, object), DM_OK);
    return result;
}

static dm_result refine(setting* s) {
    dm_joint before = {.struct_size = sizeof before}, after = before;
    assert_int_equal(dm_object_get_joint(s->w.context, s->object, 1, &before), DM_OK);
    const dm_result result = dm_object_refine(s->w.context, s->object, 1, &pull);
    assert_int_equal(dm_object_get_joint(s->w.context, s->object, 1, &after), DM_OK);
    if (result != DM_OK) assert_memory_equal(&before, &after, sizeof before);
    return result;
}

static dm_result open_gltf(setting* s) {
    const dm_gltf_desc desc = describe_gltf(s);
    dm_gltf* gltf = NULL;
    const dm_result result = dm_gltf_open(&desc, &gltf);
    assert_int_equal(gltf != NULL, result == DM_OK);
    dm_gltf_close(gltf);
    return result;
}

static dm_result export_gltf(setting* s) {
    static const dm_pose poses[2] = {{{0, 0, 0, 1}, {0}}, {{0, 0, 0, 1}, {0}}};
    static const float times[2] = {0, 1};
    const dm_gltf_track track = {.face_ids = s->grid.part, .value = 1, .poses = poses, .times = times, .key_count = 2};
    void* data = NULL;
    size_t size = 0;
    const dm_result result = dm_gltf_export(s->gltf, &track, 1, &data, &size);
    assert_int_equal(data != NULL && size > 0, result == DM_OK);
    dm_gltf_release_bytes(s->gltf, data, size);
    return result;
}

static void open_setting(setting* s) {
    memset(s, 0, sizeof *s);
    test_world_init(&s->w);
    s->w.desc.progress = report;
    s->w.desc.progress_user = &s->r;
    test_world_open(&s->w);
    test_world_load_model(&s->w);
    s->grid = make_grid(LARGE);
    s->mesh = describe(&s->grid);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &s->mesh, .model = s->w.model};
    assert_int_equal(dm_object_prepare(s->w.context, &desc, &s->object), DM_OK);
    assert_int_equal(dm_object_save(s->w.context, s->object, NULL, 0, &s->saved_size), DM_OK);
    s->saved = malloc(s->saved_size);
    assert_int_equal(dm_object_save(s->w.context, s->object, s->saved, s->saved_size, &s->saved_size), DM_OK);
    s->face_ids = malloc(s->grid.faces);
    const dm_gltf_part part = {.positions = s->grid.xyz[0],
                               .indices = s->grid.corners[0],
                               .vertex_count = s->grid.vertices,
                               .index_count = 3 * (uint64_t)s->grid.faces};
    assert_int_equal(dm_gltf_write(&part, 1, NULL, NULL, &s->glb, &s->glb_size), DM_OK);
    const dm_gltf_desc gltf = describe_gltf(s);
    assert_int_equal(dm_gltf_open(&gltf, &s->gltf), DM_OK);
}

static void close_setting(setting* s) {
    dm_gltf_close(s->gltf);
    free(s->glb);
    free(s->face_ids);
    free(s->saved);
    free_grid(&s->grid);
    test_world_close(&s->w);
}

/* Reports rise, come often enough, and each of them stops the call, which leaves nothing behind and can be made again.
 */
static void check_call(setting* s, const char* name, dm_result (*call)(setting* s), int least) {
    s->r = (reports){0};
    assert_int_equal(call(s), DM_OK);
    const int all = s->r.count;
    print_message("%s: %d reports\n", name, all);
    assert_true(all >= least);
    assert_int_equal(s->r.falls, 0);
    assert_int_equal(s->r.outside, 0);
    assert_true(s->r.last >= LEAST_DONE);
    const int64_t held = test_world_blocks(&s->w);
    for (int stop = 1; stop <= all; stop += 1 + all / MOST_STOPS) {
        s->r = (reports){.stop_at = stop};
        assert_int_equal(call(s), DM_ERROR_CANCELLED);
        assert_int_equal(s->r.count, stop);
        assert_int_equal(test_world_blocks(&s->w), held);
        assert_int_equal(s->w.messages.code, DM_ERROR_CANCELLED);
    }
    s->r = (reports){0};
    assert_int_equal(call(s), DM_OK);
    assert_int_equal(s->r.count, all);
}

static void calls_without_a_callback_of_their_own(void** state) {
    (void)state;
    setting s;
    open_setting(&s);
    const int passes = (int)(s.grid.faces / TRIANGLES_A_REPORT);
    check_call(&s, "dm_mesh_find_part", find_part, 4 * passes);
    check_call(&s, "dm_mesh_find_part, of pieces", find_among_pieces, 2 * passes);
    check_call(&s, "dm_object_prepare", prepare_again, 4 * passes);
    check_call(&s, "dm_object_load", load, 2 * passes);
    check_call(&s, "dm_object_refine", refine, 2 * passes);
    check_call(&s, "dm_gltf_open", open_gltf, 2 * passes);
    check_call(&s, "dm_gltf_export", export_gltf, 2 * passes);
    close_setting(&s);
}

/* The callback of a preparation hears of it instead of the context's. */
static void one_callback_is_asked(void** state) {
    (void)state;
    test_world w;
    reports of_context = {0}, own = {0};
    dm_object object = 0;
    test_world_init(&w);
    w.desc.progress = report;
    w.desc.progress_user = &of_context;
    test_world_open(&w);
    grid g = make_grid(SMALL);
    assert_int_equal(prepare(&w, &g, &own, &object), DM_OK);
    assert_int_equal(of_context.count, 0);
    assert_true(own.count > 0);
    free_grid(&g);
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(with_code_of_our_own),  cmocka_unit_test(with_what_picks_by_itself),
        cmocka_unit_test(without_picking),       cmocka_unit_test(calls_without_a_callback_of_their_own),
        cmocka_unit_test(one_callback_is_asked), cmocka_unit_test(reports_rise_whatever_the_count_of_parts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
