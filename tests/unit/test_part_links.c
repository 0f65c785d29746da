/* Links between parts: order, cycles, both ways, limits, what is held. */
#include "test_math.h"

#include "drag/part_links.h"

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

/* No driver is nearer to rest than 0: what frees or holds from 0 on does so always, whichever way the driver opens. */
static void a_link_that_begins_at_rest_is_reached(void** state) {
    (void)state;
    const float drivers[] = {-0.3f, -1e-6f, 0, 1e-6f, 0.3f};
    for (size_t i = 0; i < sizeof drivers / sizeof *drivers; i++) {
        dmi_link links[2] = {link_of(0, 1, 1), link_of(0, 4, 1)};
        links[0].kind = DM_LINK_HOLDS, links[1].kind = DM_LINK_FREES;
        const float values[PARTS] = {drivers[i]};
        uint8_t held[PARTS];
        dmi_links_hold(links, 2, values, held, PARTS);
        assert_int_equal(held[1], 1);
        assert_int_equal(held[4], 0);
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

/* What a driven part is moved to, its driver comes along so that it stands there, offsets and beginnings included; one
 * that has not moved off its offset leaves a driver that has not begun. */
static void a_driver_comes_along_from_where_the_link_begins(void** state) {
    (void)state;
    const struct {
        float ratio, offset, from, driver, driven, wanted;
    } cases[] = {{2, 0.1f, 0, 0, 0.5f, 0.2f},       {2, 0.1f, 0.3f, 0, 0.5f, 0.5f}, {2, 0.1f, 0.3f, 0.2f, 0.1f, 0.2f},
                 {2, 0.1f, 0.3f, 0.4f, 0.1f, 0.3f}, {-2, 0, -0.3f, 0, 0.4f, -0.5f}, {-2, 0, -0.3f, -0.1f, 0, -0.1f},
                 {-2, 0, -0.3f, -0.4f, 0, -0.3f},   {0, 0.1f, 0, 0.7f, 0.5f, 0.7f}, {1, 0, 0, 0.7f, 5, 1},
                 {1, 0.1f, 0, 0.2f, 0.1f, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (int both = 0; both < 2; both++) {
            dmi_link link = link_of(0, 3, cases[i].ratio);
            link.offset = cases[i].offset, link.from = cases[i].from, link.both_ways = both;
            float values[PARTS] = {cases[i].driver, 0, 0, cases[i].driven, 0};
            uint8_t changed[PARTS] = {0};
            dmi_links_follow(&link, 1, all, 3, values, changed);
            assert_near(values[0], both ? cases[i].wanted : cases[i].driver, 1e-6);
            const bool moved = both && cases[i].wanted != cases[i].driver;
            assert_int_equal(changed[0], moved);
            assert_int_equal(changed[3], 1);
            if (!moved) assert_near(values[3], cases[i].driven, 0);
            if (moved) {
                const double over = (double)cases[i].wanted - (double)cases[i].from;
                assert_near(values[3], (double)cases[i].offset + (double)cases[i].ratio * over, 1e-6);
            }
        }
    }
}

/* At its beginning a link that frees lets go, and one that holds takes hold, on either side of rest. */
static void a_link_holds_from_its_beginning_on(void** state) {
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        for (int kind = 0; kind < 2; kind++) {
            for (int k = -1; k <= 1; k++) {
                dmi_link link = link_of(0, 1, 1);
                link.kind = kind ? DM_LINK_HOLDS : DM_LINK_FREES, link.from = 0.5f * (float)side;
                const float values[PARTS] = {(float)side * (0.5f + 0.001f * (float)k)};
                uint8_t held[PARTS] = {7, 7, 7, 7, 7};
                dmi_links_hold(&link, 1, values, held, PARTS);
                assert_int_equal(held[1], kind ? k >= 0 : k < 0);
                assert_true(held[0] == 0 && held[PARTS - 1] == 0);
            }
        }
    }
    const dmi_link moves = {.kind = DM_LINK_MOVES, .driver = 0, .driven = 1, .ratio = 1};
    const float values[PARTS] = {1};
    uint8_t held[PARTS];
    dmi_links_hold(&moves, 1, values, held, PARTS);
    assert_int_equal(held[1], 0);
}

/* However they are given, each link stands behind those that drive its driver. */
static void an_order_puts_drivers_first(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(6, 0);
    for (int round = 0; round < 200; round++) {
        enum { MANY = 8 };
        dmi_link links[MANY], scratch[MANY];
        for (uint32_t i = 0; i < MANY; i++) links[i] = link_of(dmi_random_u32(&random) % (i + 1), i + 1, (float)i);
        for (uint32_t i = MANY - 1; i > 0; i--) {
            const uint32_t other = dmi_random_u32(&random) % (i + 1);
            const dmi_link kept = links[i];
            links[i] = links[other], links[other] = kept;
        }
        if (round % 2) links[3].kind = DM_LINK_HOLDS;
        assert_true(dmi_links_order(links, MANY, scratch));
        uint32_t seen = 0;
        for (int i = 0; i < MANY; i++) {
            seen |= 1u << links[i].driven;
            for (int n = i + 1; n < MANY && links[i].kind == DM_LINK_MOVES; n++)
                assert_false(links[n].kind == DM_LINK_MOVES && links[n].driven == links[i].driver);
        }
        assert_int_equal(seen, 0x1fe); /* none is lost */
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gears_go_on_from_one_to_the_next),
        cmocka_unit_test(a_double_door_goes_both_ways),
        cmocka_unit_test(a_limit_stops_both),
        cmocka_unit_test(a_link_begins_somewhere),
        cmocka_unit_test(a_link_that_begins_at_rest_is_reached),
        cmocka_unit_test(cycles_and_two_drivers_are_refused),
        cmocka_unit_test(one_drawer_at_a_time_and_handle_then_door),
        cmocka_unit_test(any_tree_holds),
        cmocka_unit_test(a_driver_comes_along_from_where_the_link_begins),
        cmocka_unit_test(a_link_holds_from_its_beginning_on),
        cmocka_unit_test(an_order_puts_drivers_first),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
