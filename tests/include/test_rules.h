/* A slide of one host unit along x with rules, moved by a hand whose way is a function of time, at any frame rate. */
#ifndef DM_TEST_RULES_H
#define DM_TEST_RULES_H

#include <string.h>

#include "test_math.h"

#include "drag/drag.h"

static const dm_joint test_slide = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = 0, .upper = 1};

/* A ray from above that asks the slide for `x`. */
static inline dm_ray test_ray_at(float x) {
    return (dm_ray){{x, 0, 5}, {0, 0, -1}};
}

static inline dm_hand test_pointer(dm_ray ray) {
    return (dm_hand){.kind = DM_HAND_RAY, .ray = ray};
}

static inline void test_begin(dmi_drag* drag, const dm_joint* joint, float value, const dm_drag_feel* feel,
                              const dm_drag_rules* rules) {
    const float grab[3] = {value, 0, 0};
    dmi_drag_begin(drag, joint, grab, value, feel);
    const dmi_rules kept = dmi_rules_from(rules, feel, joint, false, 1);
    dmi_drag_set_rules(drag, &kept);
}

/* What came of a whole way. */
typedef struct test_story {
    uint32_t order[32], count; /* events one by one, in their order */
    uint32_t detents;
    float time[32]; /* s of each */
    float value, impact;
} test_story;

static inline void test_note(test_story* story, const dm_drag_state* now, float time) {
    for (uint32_t bit = 1; bit != 0 && bit <= now->events; bit <<= 1) {
        if (!(now->events & bit)) continue;
        assert_true(story->count < 32);
        story->time[story->count] = time;
        story->order[story->count++] = bit;
    }
    story->detents += now->detents;
    story->value = now->value;
    story->impact = fmaxf(story->impact, now->impact);
}

/* A hand's place at a time, and the bounds of the update that ends then. */
typedef float (*test_way)(float time);
typedef void (*test_room)(float time, dm_drag_input* input);

/* Frame rates at which a way must come to the same; the last one has a hitch of a quarter of a second. */
enum { TEST_RATES = 4 };
static const float test_rates[TEST_RATES] = {30, 60, 144, 60};

static inline float test_frame(int rate, float time) {
    const float dt = 1 / test_rates[rate];
    return rate == TEST_RATES - 1 && time < 0.5f && time + dt >= 0.5f ? 0.25f : dt;
}

/* Plays a way of `seconds`, first the ray of the grab. room: NULL: none. */
static inline test_story test_play(dmi_drag* drag, test_way way, test_room room, float seconds, int rate) {
    test_story story = {0};
    dm_drag_state now = {0};
    float time = 0;
    const dm_ray grab = test_ray_at(way(0));
    dmi_drag_update(drag, &grab, 0, &now);
    while (time < seconds) {
        const float dt = test_frame(rate, time);
        dm_drag_input input = {.struct_size = sizeof input, .hand.kind = DM_HAND_RAY};
        time += dt;
        input.hand.ray = test_ray_at(way(time));
        if (room != NULL) room(time, &input);
        dmi_drag_step(drag, &input, dt, &now);
        test_note(&story, &now, time);
    }
    return story;
}

static inline void test_assert_events(const test_story* story, const uint32_t* wanted, uint32_t count) {
    for (uint32_t i = 0; i < story->count && i < count; i++) {
        if (story->order[i] != wanted[i]) fail_msg("event %u is %u, not %u", i, story->order[i], wanted[i]);
    }
    assert_int_equal(story->count, count);
}

#endif
