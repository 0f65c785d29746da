/* The joint of a node's clips: type, line, limits and duration of keys that a joint has made, and what is none. */
#include "assets/body_hints.h"

#include <math.h>

#include "base/random.h"
#include "math/joint.h"
#include "test_env.h"

enum { MOST_KEYS = 64 };

static const float centre[3] = {0.3f, 0.2f, -0.1f};
#define SIZE 2.0f

/* Keys of a clip. */
typedef struct keys {
    float times[MOST_KEYS];
    dm_pose poses[MOST_KEYS];
    dm_asset_clip clip;
} keys;

static void add_key(keys* k, float time, dm_pose pose) {
    k->times[k->clip.key_count] = time;
    k->poses[k->clip.key_count++] = pose;
    k->clip.times = k->times;
    k->clip.poses = k->poses;
}

/* A clip that takes the joint from one value to the other within 1.5 s, after half a second. */
static void add_way(keys* k, const dm_joint* joint, float from, float to, int count) {
    for (int i = 0; i < count; i++) {
        const float share = (float)i / (float)(count - 1);
        add_key(k, 0.5f + 1.5f * share, dmi_joint_pose(joint, from + (to - from) * share));
    }
}

static dmi_clip_joint find(const keys* k, uint32_t count) {
    dm_asset_clip clips[4];
    for (uint32_t i = 0; i < count; i++) clips[i] = k[i].clip;
    return dmi_clip_find_joint(clips, count, centre, SIZE);
}

static void expect_near(float got, float want, const char* what) {
    if (!(fabsf(got - want) < 1e-4f)) fail_msg("%s: %g, not %g", what, (double)got, (double)want);
}

/* Expects the joint, which opens to `upper`; its line may be given by any of its points. */
static void expect_joint(const dm_joint* got, const dm_joint* want, float lower, float upper) {
    assert_int_equal(got->type, want->type);
    assert_int_equal(got->source, DM_JOINT_FROM_HOST);
    expect_near(got->axis.x, want->axis.x, "axis x");
    expect_near(got->axis.y, want->axis.y, "axis y");
    expect_near(got->axis.z, want->axis.z, "axis z");
    expect_near(got->lower, lower, "lower");
    expect_near(got->upper, upper, "upper");
    expect_near(got->pitch, want->pitch, "pitch");
    if (!dmi_joint_turns(want->type)) return;
    dm_joint line = *want;
    dmi_joint_set_origin_near(&line, centre);
    expect_near(got->origin.x, line.origin.x, "origin x");
    expect_near(got->origin.y, line.origin.y, "origin y");
    expect_near(got->origin.z, line.origin.z, "origin z");
}

static dm_joint make_joint(int32_t type, uint64_t seed) {
    dmi_random random = dmi_random_make(seed, 0);
    float axis[3], length = 0;
    for (int k = 0; k < 3; k++) axis[k] = 2 * dmi_random_unit(&random) - 1;
    for (int k = 0; k < 3; k++) length += axis[k] * axis[k];
    length = sqrtf(length);
    dm_joint joint = {.struct_size = sizeof joint,
                      .type = type,
                      .pitch = type == DM_JOINT_SCREW ? 0.05f : 0,
                      .axis = {axis[0] / length, axis[1] / length, axis[2] / length}};
    joint.origin = (dm_vec3){dmi_random_unit(&random), dmi_random_unit(&random), dmi_random_unit(&random)};
    return joint;
}

static void each_type_comes_back(void** state) {
    (void)state;
    static const struct {
        int32_t type;
        float to;
    } ways[] = {{DM_JOINT_REVOLUTE, 1.8f}, {DM_JOINT_REVOLUTE, 0.1f},  {DM_JOINT_REVOLUTE, 3.1f},
                {DM_JOINT_REVOLUTE, 5},    {DM_JOINT_PRISMATIC, 0.7f}, {DM_JOINT_PRISMATIC, 0.01f},
                {DM_JOINT_SCREW, 9}};
    for (size_t w = 0; w < sizeof ways / sizeof *ways; w++)
        for (uint64_t seed = 0; seed < 20; seed++) {
            keys k = {.clip = {.key_count = 0}};
            const dm_joint joint = make_joint(ways[w].type, seed);
            add_way(&k, &joint, 0, ways[w].to, 9);
            const dmi_clip_joint got = find(&k, 1);
            assert_true(got.is_found);
            assert_int_equal(got.left_out, 0);
            expect_joint(&got.joint, &joint, 0, ways[w].to);
            expect_near(got.duration, 1.5f, "duration");
        }
}

/* The farther limit is the upper one, whichever way the clip goes. */
static void the_axis_points_where_it_opens(void** state) {
    (void)state;
    keys k = {.clip = {.key_count = 0}};
    dm_joint joint = make_joint(DM_JOINT_REVOLUTE, 7);
    add_way(&k, &joint, 0.2f, -1.8f, 9);
    dmi_clip_joint got = find(&k, 1);
    dmi_joint_reverse(&joint);
    expect_joint(&got.joint, &joint, -0.2f, 1.8f);
}

/* A clip that begins elsewhere: rest belongs to the range. */
static void rest_lies_in_the_range(void** state) {
    (void)state;
    keys k = {.clip = {.key_count = 0}};
    const dm_joint joint = make_joint(DM_JOINT_PRISMATIC, 3);
    add_way(&k, &joint, 0.2f, 0.5f, 5);
    const dmi_clip_joint got = find(&k, 1);
    expect_joint(&got.joint, &joint, 0, 0.5f);
}

static void two_keys_are_enough(void** state) {
    (void)state;
    keys k = {.clip = {.key_count = 0}};
    const dm_joint joint = make_joint(DM_JOINT_REVOLUTE, 4);
    add_way(&k, &joint, 0, 1.5f, 2);
    const dmi_clip_joint got = find(&k, 1);
    expect_joint(&got.joint, &joint, 0, 1.5f);
}

static void what_goes_round_has_no_limits(void** state) {
    (void)state;
    static const struct {
        float to;
        int count;
        int32_t type;
    } ways[] = {{6.2831853f, 25, DM_JOINT_CONTINUOUS},
                {6.2831853f * 23 / 24, 24, DM_JOINT_CONTINUOUS}, /* its last frame is its first */
                {20, 40, DM_JOINT_CONTINUOUS},
                {5, 25, DM_JOINT_REVOLUTE},
                {6.2831853f * 2 / 3, 3, DM_JOINT_REVOLUTE}};
    for (size_t w = 0; w < sizeof ways / sizeof *ways; w++) {
        keys k = {.clip = {.key_count = 0}};
        dm_joint joint = make_joint(DM_JOINT_REVOLUTE, w);
        add_way(&k, &joint, 0, ways[w].to, ways[w].count);
        const dmi_clip_joint got = find(&k, 1);
        joint.type = ways[w].type;
        expect_joint(&got.joint, &joint, 0, ways[w].type == DM_JOINT_CONTINUOUS ? 0 : ways[w].to);
    }
}

static void clips_of_one_joint_add_up(void** state) {
    (void)state;
    keys k[3] = {{.clip = {.key_count = 0}}};
    const dm_joint joint = make_joint(DM_JOINT_REVOLUTE, 5);
    add_way(&k[0], &joint, 0, 1, 9);
    add_way(&k[1], &joint, 1, -0.5f, 9); /* moves it farthest: the duration is its */
    add_way(&k[2], &joint, 0, 0, 4);     /* says nothing */
    k[1].times[8] = 9;
    const dmi_clip_joint got = find(k, 3);
    assert_int_equal(got.left_out, 0);
    expect_joint(&got.joint, &joint, -0.5f, 1);
    expect_near(got.duration, 8.5f, "duration");
}

/* A gate that folds by half a turn: its clips may end at half a turn either way. */
static void half_a_turn_is_the_same_in_both_clips(void** state) {
    (void)state;
    keys k[2] = {{.clip = {.key_count = 0}}};
    const dm_joint joint = make_joint(DM_JOINT_REVOLUTE, 6);
    add_way(&k[0], &joint, 0, 3.1415926f, 9);
    add_way(&k[1], &joint, -3.1415927f, -6.2831853f, 9); /* closes */
    const dmi_clip_joint got = find(k, 2);
    expect_joint(&got.joint, &joint, 0, 3.1415926f);
}

static void the_farthest_clip_wins(void** state) {
    (void)state;
    keys k[2] = {{.clip = {.key_count = 0}}};
    const dm_joint hinge = make_joint(DM_JOINT_REVOLUTE, 8), slide = make_joint(DM_JOINT_PRISMATIC, 9);
    add_way(&k[0], &slide, 0, 0.3f, 9);
    add_way(&k[1], &hinge, 0, 1.6f, 9);
    const dmi_clip_joint got = find(k, 2);
    assert_int_equal(got.left_out, DMI_CLIP_DISAGREES);
    expect_joint(&got.joint, &hinge, 0, 1.6f);
}

static void what_is_no_joint_is_said(void** state) {
    (void)state;
    keys k[2] = {{.clip = {.key_count = 0}}};
    const dm_joint hinge = make_joint(DM_JOINT_REVOLUTE, 10), other = make_joint(DM_JOINT_REVOLUTE, 11);
    add_way(&k[0], &hinge, 0, 1, 5);
    for (int i = 1; i < 5; i++) { /* then about another line */
        const dm_pose one = dmi_joint_pose(&hinge, 1), two = dmi_joint_pose(&other, 0.2f * (float)i);
        add_key(&k[0], 2 + (float)i, dmi_pose_multiply(&two, &one));
    }
    dmi_clip_joint got = find(k, 1);
    assert_false(got.is_found);
    assert_int_equal(got.left_out, DMI_CLIP_NO_JOINT);
    add_way(&k[1], &hinge, 0, 1, 5);
    got = find(k, 2);
    assert_true(got.is_found);
    assert_int_equal(got.left_out, DMI_CLIP_NO_JOINT);
    k[1].clip.flags = DM_CLIP_NOT_RIGID;
    got = find(k, 2);
    assert_false(got.is_found);
    assert_int_equal(got.left_out, DMI_CLIP_NO_JOINT | DMI_CLIP_NOT_RIGID);
}

static void what_stays_says_nothing(void** state) {
    (void)state;
    keys k = {.clip = {.key_count = 0}};
    const dm_joint hinge = make_joint(DM_JOINT_REVOLUTE, 12);
    add_way(&k, &hinge, 0, 1e-5f, 9);
    const dmi_clip_joint got = find(&k, 1);
    assert_false(got.is_found);
    assert_int_equal(got.left_out, 0);
    assert_false(find(&k, 0).is_found);
}

/* Opens, waits, closes: a way takes its second half of a second. */
static void waiting_is_no_way(void** state) {
    (void)state;
    keys k = {.clip = {.key_count = 0}};
    const dm_joint slide = make_joint(DM_JOINT_PRISMATIC, 13);
    const float times[6] = {0, 1, 1.5f, 4, 5, 8}, values[6] = {0, 0, 0.4f, 0.4f, 0, 0};
    for (int i = 0; i < 6; i++) add_key(&k, times[i], dmi_joint_pose(&slide, values[i]));
    expect_near(find(&k, 1).duration, 0.5f, "duration");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_type_comes_back),
        cmocka_unit_test(the_axis_points_where_it_opens),
        cmocka_unit_test(rest_lies_in_the_range),
        cmocka_unit_test(two_keys_are_enough),
        cmocka_unit_test(what_goes_round_has_no_limits),
        cmocka_unit_test(clips_of_one_joint_add_up),
        cmocka_unit_test(half_a_turn_is_the_same_in_both_clips),
        cmocka_unit_test(the_farthest_clip_wins),
        cmocka_unit_test(what_is_no_joint_is_said),
        cmocka_unit_test(what_stays_says_nothing),
        cmocka_unit_test(waiting_is_no_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
