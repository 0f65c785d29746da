/* Where a drawer that is modelled open is closed: by what it meets and by a closed twin beside it. */
#include <math.h>

#include "test_analysis.h"
#include "test_world.h"

#include "kinematics/limits/limits.h"
#include "math/joint.h"

#define WALL 0.02f
#define FRONT 0.01f /* how far closed fronts stand out of the carcase */

typedef struct chest {
    float width, height, depth; /* of one drawer's opening */
    float open;                 /* how far the upper drawer stands out */
    int with_twin;
} chest;

static void box(test_shape* s, float x0, float y0, float z0, float x1, float y1, float z1, uint32_t part) {
    test_shape_box(s, (const float[]){x0, y0, z0}, (const float[]){x1, y1, z1}, part);
}

/* A drawer of five boards in an opening whose lower corner is (0, y, 0). Its front comes to z = FRONT when closed. */
static void add_drawer(test_shape* s, const chest* c, float y, float out, uint32_t part) {
    const float gap = 0.005f, w = c->width - gap, h = c->height - gap, back = -c->depth + WALL + out, z = FRONT + out;
    box(s, gap, y + gap, z - WALL, w, y + h, z, part);
    box(s, gap, y + gap, back, gap + 0.01f, y + 0.7f * h, z - WALL, part);
    box(s, w - 0.01f, y + gap, back, w, y + 0.7f * h, z - WALL, part);
    box(s, gap, y + gap, back, w, y + gap + 0.01f, z - WALL, part);
    box(s, gap, y + gap, back, w, y + 0.7f * h, back + 0.01f, part);
}

static void make_chest(test_shape* s, const chest* c) {
    const float tall = 2 * c->height;
    s->vertex_count = s->face_count = 0;
    box(s, -WALL, -WALL, -c->depth, 0, tall + WALL, 0, 0);
    box(s, c->width, -WALL, -c->depth, c->width + WALL, tall + WALL, 0, 0);
    box(s, 0, -WALL, -c->depth, c->width, 0, 0, 0);
    box(s, 0, tall, -c->depth, c->width, tall + WALL, 0, 0);
    box(s, 0, 0, -c->depth, c->width, tall, -c->depth + 0.01f, 0);
    if (c->with_twin) add_drawer(s, c, 0, 0, 0);
    add_drawer(s, c, c->height, c->open, 1);
}

/* Returns the value at which the upper drawer is closed, in the shape's units, along z; NAN: none is found. */
static float closed_of(const chest* c, float sign) {
    static test_shape shape;
    static test_analysis a;
    float value = NAN;
    make_chest(&shape, c);
    test_analysis_open(&a, &shape, 3);
    const dm_joint slide = {.type = DM_JOINT_PRISMATIC, .axis = {0, 0, sign}};
    if (dmi_closed_pose_find(&a.of_part, &slide, &value)) value *= (float)a.mesh->frame.size;
    test_analysis_close(&a);
    return value;
}

static const chest chests[] = {
    {0.75f, 0.22f, 0.47f, 0, 1}, {0.5f, 0.3f, 0.4f, 0, 1}, {0.9f, 0.18f, 0.55f, 0, 1}, {0.45f, 0.2f, 0.5f, 0, 1}};
enum { CHESTS = sizeof chests / sizeof *chests };

static void a_drawer_beside_a_closed_twin_closes_with_it(void** state) {
    (void)state;
    for (int i = 0; i < CHESTS; i++) {
        for (int step = 1; step <= 3; step++) {
            chest c = chests[i];
            c.open = (float)step * 0.15f * c.depth;
            for (int sign = -1; sign <= 1; sign += 2) {
                const float found = closed_of(&c, (float)sign);
                if (!(fabsf(found + (float)sign * c.open) < 0.005f))
                    fail_msg("chest %d open by %g: closed at %g", i, (double)c.open, (double)found);
            }
        }
    }
}

static void a_closed_drawer_is_closed_at_rest(void** state) {
    (void)state;
    for (int i = 0; i < CHESTS; i++) {
        chest c = chests[i];
        assert_true(isnan(closed_of(&c, 1)));
        c.with_twin = 0;
        assert_true(isnan(closed_of(&c, 1)));
    }
}

static void what_turns_or_meets_nothing_has_no_closed_pose(void** state) {
    (void)state;
    static test_shape shape;
    static test_analysis a;
    const dm_joint turn = {.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}},
                   across = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}};
    chest c = chests[0];
    float value;
    c.open = 0.2f;
    make_chest(&shape, &c);
    test_analysis_open(&a, &shape, 3);
    assert_false(dmi_closed_pose_find(&a.of_part, &turn, &value));
    assert_false(dmi_closed_pose_find(&a.of_part, &across, &value)); /* both sides stop it */
    test_analysis_close(&a);
}

/* Through the boundary: the limit is there, the joint says so, and a saved object keeps it. */
static void an_object_keeps_where_its_part_is_closed(void** state) {
    (void)state;
    test_world w;
    dm_object object = 0, loaded = 0;
    size_t size = 0;
    chest c = chests[0];
    c.open = 0.2f;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    make_chest(&w.shape, &c);
    const dm_mesh_desc mesh = test_shape_desc(&w.shape);
    const dm_part_desc part = {.struct_size = sizeof part, .id = 1, .joint_type = DM_JOINT_PRISMATIC};
    const dm_object_desc desc = {
        .struct_size = sizeof desc, .mesh = &mesh, .parts = &part, .part_count = 1, .model = w.model};
    dm_joint joint = dm_joint_default(), again = dm_joint_default();
    assert_int_equal(dm_object_prepare(w.context, &desc, &object), DM_OK);
    assert_int_equal(dm_object_get_joint(w.context, object, 1, &joint), DM_OK);
    assert_true(fabsf(fabsf(joint.closed) - 0.2f) < 0.005f);
    assert_true(joint.closed == joint.lower || joint.closed == joint.upper);
    assert_int_equal(dm_object_save(w.context, object, NULL, 0, &size), DM_OK);
    void* bytes = malloc(size);
    assert_int_equal(dm_object_save(w.context, object, bytes, size, &size), DM_OK);
    assert_int_equal(dm_object_load(w.context, bytes, size, w.model, &loaded), DM_OK);
    assert_int_equal(dm_object_get_joint(w.context, loaded, 1, &again), DM_OK);
    assert_memory_equal(&joint, &again, sizeof joint);
    free(bytes);
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_drawer_beside_a_closed_twin_closes_with_it),
        cmocka_unit_test(a_closed_drawer_is_closed_at_rest),
        cmocka_unit_test(what_turns_or_meets_nothing_has_no_closed_pose),
        cmocka_unit_test(an_object_keeps_where_its_part_is_closed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
