/* Links between parts: order, cycles, both ways, limits, what is held. */
#include "test_math.h"

#include "motion/part_links.h"

enum { PARTS = 5 };

/* Parts of one unit to both sides. */
static const dm_joint joints[PARTS] = {{.type = DM_JOINT_REVOLUTE, .lower = -1, .upper = 1},
                                       {.type = DM_JOINT_REVOLUTE, .lower = -1, .upper = 1},
                                       {.type = DM_JOINT_PRISMATIC, .lower = 0, .upper = 0.3f},
                                       {.type = DM_JOINT_CONTINUOUS},
                                       {.type = DM_JOINT_REVOLUTE, .lower = -1, .upper = 1}};
static const dmi_linked_joints all = {joints, sizeof *joints};

static dmi_link link_of(uint32_t driver, uint32_t driven, float ratio) {
    return (dmi_link){.driver = driver, .driven = driven, .ratio = ratio};
}

static void follow(const dmi_link* links, uint32_t count, uint32_t moved, float values[PARTS]) {
    uint8_t changed[PARTS] = {0};
    dmi_links_follow(links, count, all, moved, values, changed);
}

static void gears_go_on_from_one_to_the_next(void** state) {
    (void)state;
    dmi_link links[3] = {link_of(1, 2, 0.1f), link_of(0, 1, -0.5f), link_of(2, 3, 4)}, scratch[3]; /* not in order */
    float values[PARTS] = {0.8f, 0, 0, 0, 0.7f};
    links[0].ratio = -0.1f;
    assert_true(dmi_links_order(links, 3, scratch));
    assert_int_equal(links[0].driver, 0);
    follow(links, 3, 0, values);
    assert_near(values[1], -0.4, 1e-6);
    assert_near(values[2], 0.04, 1e-6);
    assert_near(values[3], 0.16, 1e-6);
    assert_near(values[4], 0.7, 1e-6); /* not linked */
    values[1] = 0.5f;                  /* moved by hand: its driver stays, what it drives goes along */
    follow(links, 3, 1, values);
    assert_near(values[0], 0.8, 1e-6);
    assert_near(values[2], 0, 1e-6); /* its lower limit */
}

static void a_double_door_goes_both_ways(void** state) {
    (void)state;
    dmi_link links[2] = {link_of(0, 1, -1), link_of(1, 4, 1)}, scratch[2];
    links[0].both_ways = links[1].both_ways = true;
    assert_true(dmi_links_order(links, 2, scratch));
    float values[PARTS] = {0, 0, 0, 0, 0.6f};
    follow(links, 2, 4, values);
    assert_near(values[1], 0.6, 1e-6);
    assert_near(values[0], -0.6, 1e-6);
    values[0] = 0.25f;
    follow(links, 2, 0, values);
    assert_near(values[4], -0.25, 1e-6);
}

/* A driver that is at its limit stops what drives it. */
static void a_limit_stops_both(void** state) {
    (void)state;
    dmi_link links[1] = {link_of(2, 3, 10)}, scratch[1]; /* rack and pinion: 0.3 m are 3 rad */
    links[0].both_ways = true;
    assert_true(dmi_links_order(links, 1, scratch));
    float values[PARTS] = {0, 0, 0, 5, 0};
    follow(links, 1, 3, values);
    assert_near(values[2], 0.3, 1e-6);
    assert_near(values[3], 3, 1e-5);
}

static void a_link_begins_somewhere(void** state) {
    (void)state;
    dmi_link links[2] = {link_of(0, 1, 2), link_of(0, 4, 1)}, scratch[2];
    links[0].from = 0.5f, links[0].offset = -0.2f;
    links[1].from = -0.5f;
    assert_true(dmi_links_order(links, 2, scratch));
    const struct {
        float driver, second, fifth;
    } cases[] = {{0.3f, -0.2f, 0},  {0.5f, -0.2f, 0},      {0.7f, 0.2f, 0},
                 {-0.4f, -0.2f, 0}, {-0.9f, -0.2f, -0.4f}, {1, 0.8f, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        float values[PARTS] = {cases[i].driver};
        follow(links, 2, 0, values);
        assert_near(values[1], cases[i].second, 1e-6);
        assert_near(values[4], cases[i].fifth, 1e-6);
    }
}

static void cycles_and_two_drivers_are_refused(void** state) {
    (void)state;
    dmi_link scratch[3];
    dmi_link itself[1] = {link_of(1, 1, 1)}, ring[3] = {link_of(0, 1, 1), link_of(1, 2, 1), link_of(2, 0, 1)},
             twice[2] = {link_of(0, 2, 1), link_of(1, 2, 1)},
             fan[3] = {link_of(0, 2, 1), link_of(0, 1, 1), link_of(1, 3, 1)};
    assert_false(dmi_links_order(itself, 1, scratch));
    assert_false(dmi_links_order(ring, 3, scratch));
    assert_false(dmi_links_order(twice, 2, scratch));
    assert_true(dmi_links_order(fan, 3, scratch));
    ring[2].kind = DM_LINK_FREES; /* what is held may go round: a handle that its own door locks */
    assert_true(dmi_links_order(ring, 3, scratch));
}

static void one_drawer_at_a_time_and_handle_then_door(void** state) {
    (void)state;
    dmi_link links[4] = {link_of(0, 1, 1), link_of(1, 0, 1), link_of(3, 4, 1), link_of(2, 4, 1)}, scratch[4];
    links[0].kind = links[1].kind = DM_LINK_HOLDS, links[0].from = links[1].from = 0.05f;
    links[2].kind = links[3].kind = DM_LINK_FREES, links[2].from = -0.7f, links[3].from = 0.1f;
    assert_true(dmi_links_order(links, 4, scratch));
    float values[PARTS] = {0.5f, 0, 0.2f, 0, 0};
    uint8_t held[PARTS];
    dmi_links_hold(links, 4, values, held, PARTS);
    const uint8_t one[PARTS] = {0, 1, 0, 0, 1};
    assert_memory_equal(held, one, PARTS);
    values[0] = 0, values[1] = 0.06f, values[3] = -0.8f;
    dmi_links_hold(links, 4, values, held, PARTS);
    const uint8_t other[PARTS] = {1, 0, 0, 0, 0};
    assert_memory_equal(held, other, PARTS);
}

/* Trees of any shape: each driven part stands where its driver says, or at its limit. */
static void any_tree_holds(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(5, 0);
    for (int round = 0; round < 500; round++) {
        dmi_link links[PARTS - 1], scratch[PARTS - 1];
        float values[PARTS];
        for (uint32_t i = 1; i < PARTS; i++) {
            links[PARTS - 1 - i] = link_of(dmi_random_u32(&random) % i, i, test_range(&random, -2, 2));
            links[PARTS - 1 - i].both_ways = dmi_random_u32(&random) % 2;
        }
        for (int i = 0; i < PARTS; i++) values[i] = test_range(&random, joints[i].lower, joints[i].upper);
        assert_true(dmi_links_order(links, PARTS - 1, scratch));
        follow(links, PARTS - 1, 0, values);
        for (int i = 0; i < PARTS - 1; i++) {
            const float wanted = dmi_joint_clamp(&joints[links[i].driven], links[i].ratio * values[links[i].driver]);
            assert_near(values[links[i].driven], wanted, 1e-6);
        }
        follow(links, PARTS - 1, dmi_random_u32(&random) % PARTS, values); /* nothing has moved: nothing moves */
        for (int i = 0; i < PARTS; i++) assert_true(isfinite(values[i]));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gears_go_on_from_one_to_the_next),
        cmocka_unit_test(a_double_door_goes_both_ways),
        cmocka_unit_test(a_limit_stops_both),
        cmocka_unit_test(a_link_begins_somewhere),
        cmocka_unit_test(cycles_and_two_drivers_are_refused),
        cmocka_unit_test(one_drawer_at_a_time_and_handle_then_door),
        cmocka_unit_test(any_tree_holds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
