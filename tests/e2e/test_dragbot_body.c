/* The scripted player's measure of a part that goes through the body (tools/evaluate/dragbot_body.c), on a plate
 * above a single sheet, which has no inside, and above two. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "dragbot_body.c" /* NOLINT: on its own, without the tool round it */
#include "dragbot_grid.c" /* NOLINT */

/* ---- what they need of the tool ---- */

void* cli_alloc(size_t size) {
    void* memory = malloc(size);
    assert_non_null(memory);
    return memory;
}

void* cli_alloc_zeroed(size_t size) {
    return memset(cli_alloc(size), 0, size);
}

vec bot_true_move(const known_joint* truth, vec point, double value) {
    return add(point, scale(truth->axis, value));
}

vec bot_true_direction(const known_joint* truth, vec point, double value) {
    (void)point;
    return scale(truth->axis, value < 0 ? -1 : 1);
}

double bot_travel(const known_joint* truth, double size) {
    (void)size;
    return truth->upper;
}

vec bot_moved(const dm_pose* pose, vec point) {
    float xyz[3] = {(float)point.x, (float)point.y, (float)point.z};
    dm_pose_apply_points(pose, xyz, 0, xyz, 0, 1);
    return vec_at(xyz);
}

double bot_apart(const bot_part* part, const dm_pose* a, const dm_pose* b) {
    return length(sub(bot_moved(a, part->centre), bot_moved(b, part->centre))) / part->object_size;
}

void bot_object_moving(const bot_object* object, int joint, bool out_moves[BOT_MAX_PARTS + 1]) {
    (void)object, (void)joint;
    memset(out_moves, 0, BOT_MAX_PARTS + 1);
    out_moves[1] = true;
}

/* Points of the plate: a square of side 0.4 round the middle, at height 0.1. */
void bot_object_sample(const bot_object* object, const bool parts[BOT_MAX_PARTS + 1], random_state* random,
                       vec* out_points, int count) {
    (void)object, (void)parts;
    for (int i = 0; i < count; i++)
        out_points[i] = (vec){0.4 * random_unit(random) - 0.2, 0.1, 0.4 * random_unit(random) - 0.2};
}

/* ---- the object ---- */

/* A sheet of side 1 at height 0, and one below it at height -0.5; the plate's face comes first. */
static const float positions[] = {-0.2f, 0.1f,  -0.2f, 0.2f,  0.1f,  -0.2f, 0.0f,  0.1f,  0.2f,  -0.5f, 0,
                                  -0.5f, 0.5f,  0,     -0.5f, 0.5f,  0,     0.5f,  -0.5f, 0,     0.5f,  -0.5f,
                                  -0.5f, -0.5f, 0.5f,  -0.5f, -0.5f, 0.5f,  -0.5f, 0.5f,  -0.5f, -0.5f, 0.5f};
static const uint32_t indices[] = {0, 1, 2, 3, 4, 5, 3, 5, 6, 7, 8, 9, 7, 9, 10};
static uint8_t faces[] = {1, 0, 0, 0, 0};
static uint32_t part_of_joint = 1;

/* Returns how deep the plate gets when it goes straight in steps; its true joint slides along `axis`. */
static double depth_of(vec axis, vec way, bool two) {
    known_joint truth = {.slides = true, .axis = axis, .lower = 0, .upper = 0.5};
    session session = {.mesh = {.positions = positions, .indices = indices, .index_count = two ? 15 : 9}};
    bot_object object = {.session = &session, .face_parts = faces, .part_of_joint = &part_of_joint, .size = 1};
    object.known.joints = &truth;
    bot_frame frames[50] = {0};
    for (int i = 0; i < 50; i++) {
        const vec half = scale(way, 0.5 * (i + 1) / 50);
        frames[i].pose = (dm_pose){.real = {0, 0, 0, 1}, .dual = {(float)half.x, (float)half.y, (float)half.z, 0}};
    }
    const bot_part part = {.id = 1, .centre = {0, 0.1, 0}, .object_size = 1};
    bot_body* body = bot_body_new(&object, 0);
    const double depth = bot_body_depth(body, &part, frames, 50);
    bot_body_free(body);
    return depth;
}

static void assert_near(double a, double b) {
    if (fabs(a - b) > 1e-3) fail_msg("%g is not %g", a, b);
}

/* ---- tests ---- */

static const vec up = {0, 1, 0}, aside = {1, 0, 0};

static void test_own_way(void** state) {
    (void)state;
    assert_near(depth_of(up, (vec){0, 0.5, 0}, true), 0);
    assert_near(depth_of(aside, (vec){0.5, 0, 0}, true), 0);
    assert_near(depth_of(aside, (vec){-0.3, 0.2, 0}, true), 0); /* another way, but free */
}

static void test_through_a_sheet(void** state) {
    (void)state;
    for (int two = 0; two < 2; two++) {
        assert_near(depth_of(up, (vec){0, -0.1 - 0.05, 0}, two), 0.05);
        assert_near(depth_of(aside, (vec){0, -0.1 - 0.2, 0}, two), 0.2);
    }
}

/* Points that the true motion takes through the body say nothing. */
static void test_true_way_through(void** state) {
    (void)state;
    const vec down = {0, -1, 0};
    assert_near(depth_of(down, (vec){0, -0.4, 0}, true), 0);
    assert_near(depth_of(down, (vec){0.1, -0.4, 0}, true), 0);
}

static void test_beside(void** state) {
    (void)state;
    assert_near(depth_of(up, (vec){8, -1, 0}, true), 0); /* passes the sheet's edge */
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_own_way), cmocka_unit_test(test_through_a_sheet),
                                       cmocka_unit_test(test_true_way_through), cmocka_unit_test(test_beside)};
    return cmocka_run_group_tests_name("dragbot_body", tests, NULL, NULL);
}
