/* Many parts of one shape in the same surroundings share one inference; one that differs, or whose surroundings do, is
 * inferred by itself. */
#include "test_world.h"

enum { COLUMNS = 20, ROWS = 15, KEYS = COLUMNS * ROWS, FEW_KEYS = 250, BOX_FACES = 12, BOX_CORNERS = 8 };
enum { ODD_KEY = 7 * COLUMNS + 10, NEIGHBOUR = ODD_KEY + 1, INNER_KEY = 4 * COLUMNS + 4, HINTED = 5 * COLUMNS + 5 };

#define PITCH 1.25f /* from one key to the next, whose sides are 1 */
#define HEIGHT 0.2f
#define ODD_HEIGHT 0.9f /* of one key */

typedef struct board {
    float xyz[(KEYS + 1) * BOX_CORNERS][3];
    uint32_t corners[(KEYS + 1) * BOX_FACES][3];
    uint16_t part[(KEYS + 1) * BOX_FACES];
    uint32_t boxes;
} board;

static void add_box(board* b, const float low[3], const float high[3], uint16_t part) {
    static const uint8_t faces[BOX_FACES][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    const uint32_t box = b->boxes++;
    for (uint32_t v = 0; v < BOX_CORNERS; v++)
        for (uint32_t k = 0; k < 3; k++) b->xyz[box * BOX_CORNERS + v][k] = v >> k & 1 ? high[k] : low[k];
    for (uint32_t f = 0; f < BOX_FACES; f++) {
        for (uint32_t k = 0; k < 3; k++) b->corners[box * BOX_FACES + f][k] = box * BOX_CORNERS + faces[f][k];
        b->part[box * BOX_FACES + f] = part;
    }
}

/* A board that reaches far beyond its keys, so that these see no border. */
static void make_board(board* b, uint32_t keys) {
    const float low[3] = {-40, -40, -1}, high[3] = {65, 60, 0};
    b->boxes = 0;
    add_box(b, low, high, 0);
    for (uint32_t i = 0; i < keys; i++) {
        const float x = PITCH * (float)(i % COLUMNS), y = PITCH * (float)(i / COLUMNS);
        const float from[3] = {x, y, 0.02f}, to[3] = {x + 1, y + 1, i == ODD_KEY ? ODD_HEIGHT : HEIGHT};
        add_box(b, from, to, (uint16_t)(i + 1));
    }
}

/* Prepares the board; a pull of one key is a hint. */
static dm_object prepare(test_world* w, const board* b, uint32_t keys) {
    static dm_part_desc parts[KEYS];
    const dm_drag_hint pull = {{PITCH * 5 + 0.5f, PITCH * 5 + 0.5f, HEIGHT}, {0, 0, 1}};
    const dm_mesh_desc mesh = {.struct_size = sizeof mesh,
                               .positions = b->xyz,
                               .vertex_count = (uint64_t)b->boxes * BOX_CORNERS,
                               .indices = b->corners,
                               .index_count = 3 * (uint64_t)b->boxes * BOX_FACES,
                               .part_ids = b->part,
                               .part_id_bytes = (uint64_t)b->boxes * BOX_FACES * sizeof *b->part,
                               .part_id_format = DM_UINT16,
                               .part_id_scope = DM_PER_FACE};
    for (uint32_t i = 0; i < keys; i++)
        parts[i] = (dm_part_desc){.struct_size = sizeof *parts, .id = i + 1, .drag = i == HINTED ? &pull : NULL};
    const dm_object_desc desc = {
        .struct_size = sizeof desc, .mesh = &mesh, .parts = parts, .part_count = keys, .seed = 3};
    dm_object object = 0;
    assert_int_equal(dm_object_prepare(w->context, &desc, &object), DM_OK);
    return object;
}

static dm_joint joint_of(const test_world* w, dm_object object, uint32_t key) {
    dm_joint joint = dm_joint_default();
    assert_int_equal(dm_object_get_joint(w->context, object, key + 1, &joint), DM_OK);
    return joint;
}

static bool same_answer(const dm_joint* a, const dm_joint* b) {
    return a->type == b->type && a->joint_confidence == b->joint_confidence && a->axis.x == b->axis.x &&
           a->axis.y == b->axis.y && a->axis.z == b->axis.z && a->lower == b->lower && a->upper == b->upper;
}

static void alike_keys_share_an_answer(void** state) {
    (void)state;
    static board b;
    test_world w;
    test_world_init(&w);
    w.desc.picking = DM_PICK_NONE;
    test_world_open(&w);
    make_board(&b, KEYS);
    const dm_object object = prepare(&w, &b, KEYS);
    const dm_joint inner = joint_of(&w, object, INNER_KEY);
    uint32_t shared = 0;
    for (uint32_t i = 0; i < KEYS; i++) {
        const dm_joint joint = joint_of(&w, object, i);
        if (!same_answer(&joint, &inner)) continue;
        const float across = PITCH * ((float)(i % COLUMNS) - (float)(INNER_KEY % COLUMNS)),
                    along = PITCH * ((float)(i / COLUMNS) - (float)(INNER_KEY / COLUMNS));
        assert_float_equal(joint.origin.x, inner.origin.x + across, 1e-3);
        assert_float_equal(joint.origin.y, inner.origin.y + along, 1e-3);
        assert_float_equal(joint.origin.z, inner.origin.z, 1e-3);
        shared++;
    }
    print_message("%u of %d keys share an answer\n", shared, KEYS);
    assert_true(shared > KEYS / 3);
    const uint32_t others[] = {ODD_KEY, NEIGHBOUR, HINTED, 0};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        const dm_joint joint = joint_of(&w, object, others[i]);
        if (same_answer(&joint, &inner)) fail_msg("key %u has the answer of one that it is not like", others[i]);
    }
    test_world_close(&w);
}

/* Below the number from which on parts are compared, each is inferred by itself. */
static void few_keys_have_answers_of_their_own(void** state) {
    (void)state;
    static board b;
    test_world w;
    test_world_init(&w);
    w.desc.picking = DM_PICK_NONE;
    test_world_open(&w);
    make_board(&b, FEW_KEYS);
    const dm_object object = prepare(&w, &b, FEW_KEYS);
    const dm_joint inner = joint_of(&w, object, INNER_KEY), next = joint_of(&w, object, INNER_KEY + 1);
    assert_false(same_answer(&inner, &next));
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(alike_keys_share_an_answer),
        cmocka_unit_test(few_keys_have_answers_of_their_own),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
