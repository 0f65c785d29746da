/* Progress and cancelling of a large mesh: reports come the oftener the larger it is, rise, and stop the call where
 * they are told to, whatever picks. Counted, not timed. */
#include "test_world.h"

/* Quads a side; the meshes have 131,000 and 262,000 triangles. */
enum { SMALL = 256, LARGE = 362 };

/* A mesh gets a report for so many triangles at least; measured: one for 400 (Embree) to 20,000 (no picking). */
enum { TRIANGLES_A_REPORT = 65536 };

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

static dm_result prepare(test_world* w, const grid* g, reports* r, dm_object* out_object) {
    const dm_mesh_desc mesh = {.struct_size = sizeof mesh,
                               .positions = g->xyz,
                               .vertex_count = g->vertices,
                               .indices = g->corners,
                               .index_count = 3 * (uint64_t)g->faces,
                               .part_ids = g->part,
                               .part_id_bytes = g->faces,
                               .part_id_format = DM_UINT8,
                               .part_id_scope = DM_PER_FACE};
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
    const int64_t held = w.memory.live_blocks;
    for (int stop = 1; stop <= few; stop += 1 + few / 6) {
        reports r = {.stop_at = stop};
        dm_object object = 0;
        assert_int_equal(prepare(&w, &small, &r, &object), DM_ERROR_CANCELLED);
        assert_int_equal(r.count, stop); /* and no more of them afterwards */
        assert_int_equal(object, 0);
        assert_int_equal(w.memory.live_blocks, held);
        assert_int_equal(w.messages.code, DM_ERROR_CANCELLED);
    }
    free_grid(&small);
    free_grid(&large);
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(with_code_of_our_own),
        cmocka_unit_test(with_what_picks_by_itself),
        cmocka_unit_test(without_picking),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
