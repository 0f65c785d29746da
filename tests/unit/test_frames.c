/* Frames: every preset and unit commutes with what joints, poses, points and rays mean. */
#include "test_math.h"

#include "math/frames.h"

enum { CASES = 300, PRESETS = 5 };

static const int32_t types[] = {DM_JOINT_REVOLUTE, DM_JOINT_PRISMATIC, DM_JOINT_SCREW, DM_JOINT_CONTINUOUS};

/* A skew orthogonal matrix, so that no test passes by the luck of signed permutations. */
static void skew_axes(dmi_random* random, int mirrored, float out[9]) {
    dm_pose pose = test_pose(random, 1);
    float m[16];
    dmi_pose_to_matrix(&pose, m);
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++) out[3 * row + column] = m[4 * column + row];
    }
    if (mirrored) {
        for (int column = 0; column < 3; column++) out[column] = -out[column];
    }
}

/* A frame of preset `preset`; the object's size is about 1 inner unit a `host_size` host units. */
static dmi_frame random_frame(dmi_random* random, int32_t preset, float host_size) {
    dmi_frame frame;
    float custom[9];
    const float units[] = {0, 0.01f, 0.0254f, 1000};
    const float unit = units[dmi_random_u32(random) % 4];
    skew_axes(random, (int)(dmi_random_u32(random) % 2), custom);
    assert_true(dmi_axes_init(&frame.axes, preset, custom, unit));
    frame.size = (double)host_size * (double)frame.axes.unit;
    for (int i = 0; i < 3; i++) frame.centre[i] = frame.size * (double)test_range(random, -2, 2);
    return frame;
}

static void presets_are_what_they_say(void** state) {
    (void)state;
    const float up[4][3] = {{0, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}}, canonical_up[3] = {0, 1, 0};
    const float hands[4] = {1, -1, -1, 1};
    for (int preset = 0; preset < 4; preset++) {
        dmi_frame frame = {.size = 1};
        float out[3];
        assert_true(dmi_axes_init(&frame.axes, preset, NULL, 0));
        assert_near(frame.axes.handedness, hands[preset], 0);
        assert_near(frame.axes.unit, 1, 0);
        dmi_frame_direction_in(&frame, up[preset], out);
        assert_near3(out, canonical_up, 0);
    }
    /* The importers' own mappings: Unity (-x, y, z), Unreal (x, z, y), Blender (x, z, -y). */
    const float host[3] = {1, 2, 3}, expected[4][3] = {{1, 2, 3}, {-1, 2, 3}, {1, 3, 2}, {1, 3, -2}};
    for (int preset = 0; preset < 4; preset++) {
        dmi_frame frame = {.size = 1};
        float out[3];
        assert_true(dmi_axes_init(&frame.axes, preset, NULL, 0));
        dmi_frame_direction_in(&frame, host, out);
        assert_near3(out, expected[preset], 0);
    }
}

/* The numbers of an object must be floats in metres and in host units. */
static void frames_that_leave_the_range_of_floats(void** state) {
    (void)state;
    static const struct {
        double size, centre;
        float unit;
        bool usable;
    } cases[] = {{1, 0, 1, true},          {1e18, 0, 1, true},    {1e19, 0, 1, false},     {1e-19, 0, 1, false},
                 {1, 0, 1e-17f, true},     {1, 0, 1e-19f, false}, {1e-10, 0, 1e9f, false}, {1, 1e30, 1, true},
                 {1, 1e30, 1e-10f, false}, {1, 1e38, 1, false},   {1, NAN, 1, false},      {NAN, 0, 1, false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        dmi_frame frame = {.size = cases[i].size, .centre = {0, -cases[i].centre, 0}};
        assert_true(dmi_axes_init(&frame.axes, DM_AXES_GLTF, NULL, cases[i].unit));
        assert_int_equal(dmi_frame_is_usable(&frame), cases[i].usable);
    }
}

static void bad_axes_are_refused(void** state) {
    (void)state;
    dmi_axes axes;
    const float good[9] = {0, 1, 0, 1, 0, 0, 0, 0, 1};
    const float bad[5][9] = {
        {0},
        {2, 0, 0, 0, 1, 0, 0, 0, 1},
        {1, 0, 0, 1, 0, 0, 0, 0, 1},
        {NAN, 0, 0, 0, 1, 0, 0, 0, 1},
        {1, 0.01f, 0, 0, 1, 0, 0, 0, 1},
    };
    assert_true(dmi_axes_init(&axes, DM_AXES_CUSTOM, good, 1));
    assert_near(axes.handedness, -1, 0);
    for (int i = 0; i < 5; i++) assert_false(dmi_axes_init(&axes, DM_AXES_CUSTOM, bad[i], 1));
    assert_false(dmi_axes_init(&axes, DM_AXES_CUSTOM, NULL, 1));
    assert_false(dmi_axes_init(&axes, -1, good, 1));
    assert_false(dmi_axes_init(&axes, 5, good, 1));
    assert_false(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, -1));
    assert_false(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, NAN));
    assert_false(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, INFINITY));
}

static void points_vectors_and_directions_there_and_back(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 3);
    for (int i = 0; i < CASES * PRESETS; i++) {
        dmi_frame frame = random_frame(&random, i % PRESETS, 3);
        float host[3], other[3], inner[3], inner_other[3], back[3], vector[3], direction[3];
        test_point(&random, 5, host);
        test_point(&random, 5, other);
        const double wide[3] = {(double)host[0], (double)host[1], (double)host[2]};
        const double wide_other[3] = {(double)other[0], (double)other[1], (double)other[2]};
        dmi_frame_point_in(&frame, wide, inner);
        dmi_frame_point_in(&frame, wide_other, inner_other);
        dmi_frame_point_out(&frame, inner, back);
        assert_near3(back, host, 1e-5);
        assert_near(dmi_frame_length_out(&frame), 3, 1e-6);
        assert_near(test_distance(inner, inner_other) * 3, test_distance(host, other), 1e-5);
        for (int k = 0; k < 3; k++) vector[k] = other[k] - host[k], inner_other[k] -= inner[k];
        dmi_frame_vector_in(&frame, vector, inner);
        assert_near3(inner, inner_other, 5e-6);
        dmi_frame_vector_out(&frame, inner, back);
        assert_near3(back, vector, 1e-5);
        test_direction(&random, vector);
        dmi_frame_direction_in(&frame, vector, direction);
        dmi_frame_direction_out(&frame, direction, back);
        assert_near3(back, vector, 2e-6);
    }
}

/* The matrix, column-major 3x4 in doubles, says what point_out does. */
static void matrices_say_the_same(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(6, 3);
    for (int i = 0; i < CASES * PRESETS; i++) {
        dmi_frame frame = random_frame(&random, i % PRESETS, 3);
        double m[12];
        dmi_frame_matrix_out(&frame, m);
        float inner[3], expected[3], actual[3];
        test_point(&random, 0.5f, inner);
        dmi_frame_point_out(&frame, inner, expected);
        for (int k = 0; k < 3; k++) {
            actual[k] =
                (float)(m[k] * (double)inner[0] + m[3 + k] * (double)inner[1] + m[6 + k] * (double)inner[2] + m[9 + k]);
        }
        assert_near3(actual, expected, 2e-6);
    }
}

static void move_inside(const dmi_frame* frame, const dm_pose* inner_pose, const float host[3], float out[3]) {
    const double wide[3] = {(double)host[0], (double)host[1], (double)host[2]};
    float inner[3];
    dmi_frame_point_in(frame, wide, inner);
    dmi_pose_apply(inner_pose, inner, inner);
    dmi_frame_point_out(frame, inner, out);
}

/* Moving a host point by the host's pose = in, by the inner pose, out. */
static void poses_commute_with_points(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(2, 3);
    for (int i = 0; i < CASES * PRESETS; i++) {
        dmi_frame frame = random_frame(&random, i % PRESETS, 1);
        dm_pose inner = test_pose(&random, 0.5f), host = dmi_frame_pose_out(&frame, &inner);
        assert_is_unit(&host, 5e-6);
        dm_pose back = dmi_frame_pose_in(&frame, &host);
        assert_same_motion(&back, &inner, 0.5f, 1e-5);
        float point[3], expected[3], actual[3];
        test_point(&random, 2, point);
        dmi_pose_apply(&host, point, actual);
        move_inside(&frame, &inner, point, expected);
        assert_near3(actual, expected, 2e-5);
    }
}

/* A joint means the same motion in either frame, and comes back as it was. */
static void joints_commute_with_points(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(3, 3);
    for (int i = 0; i < CASES * PRESETS * 4; i++) {
        dmi_frame frame = random_frame(&random, i % PRESETS, 3);
        dm_joint inner = test_joint(&random, types[i / PRESETS % 4], 0.5f), host = dmi_frame_joint_out(&frame, &inner);
        const float share = test_range(&random, 0, 1);
        const float inner_value = inner.lower + share * (inner.upper - inner.lower);
        const float host_value = host.lower + share * (host.upper - host.lower);
        dm_pose inner_pose = dmi_joint_pose(&inner, inner_value), host_pose = dmi_joint_pose(&host, host_value);
        float point[3], expected[3], actual[3];
        test_point(&random, 3, point);
        dmi_pose_apply(&host_pose, point, actual);
        move_inside(&frame, &inner_pose, point, expected);
        assert_near3(actual, expected, 3e-5);
        dm_joint back = dmi_frame_joint_in(&frame, &host);
        assert_near3(dmi_xyz(back.axis).v, dmi_xyz(inner.axis).v, 2e-6);
        assert_near3(dmi_xyz(back.origin).v, dmi_xyz(inner.origin).v, 2e-6);
        assert_near(back.pitch, inner.pitch, 1e-6);
        assert_near(back.lower, inner.lower, 1e-6);
        assert_near(back.upper, inner.upper, 1e-6);
        assert_int_equal(back.type, inner.type);
    }
}

/* A point on a ray stays on it. */
static void rays_keep_their_points(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(4, 3);
    for (int i = 0; i < CASES * PRESETS; i++) {
        dmi_frame frame = random_frame(&random, i % PRESETS, 3);
        float origin[3], direction[3];
        test_point(&random, 3, origin);
        test_point(&random, 3, direction);
        dm_ray host = {dmi_vec3(origin), dmi_vec3(direction)}, inner = dmi_frame_ray_in(&frame, &host);
        const double wide[3] = {(double)(origin[0] + direction[0]), (double)(origin[1] + direction[1]),
                                (double)(origin[2] + direction[2])};
        float there[3], start[3] = {inner.origin.x, inner.origin.y, inner.origin.z};
        dmi_frame_point_in(&frame, wide, there);
        for (int k = 0; k < 3; k++) there[k] = (there[k] - start[k]) * 3; /* direction keeps its host length */
        assert_near3(dmi_xyz(inner.direction).v, there, 2e-5);
    }
}

/* Kilometres from the frame's origin an object still has its full precision inside. */
static void far_objects_keep_their_precision(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(5, 3);
    for (int i = 0; i < CASES; i++) {
        dmi_frame frame = random_frame(&random, i % PRESETS, 1);
        const double far = 1e6, middle[3] = {far, -far, 0.5 * far};
        const dmi_frame at_zero = {.axes = frame.axes, .size = 1};
        float canonical[3];
        dmi_frame_point_in(&at_zero, middle, canonical); /* rounded: any centre nearby will do */
        for (int k = 0; k < 3; k++) frame.centre[k] = (double)canonical[k];
        double a[3], b[3];
        float inner_a[3], inner_b[3];
        for (int k = 0; k < 3; k++) {
            a[k] = middle[k] + (double)test_range(&random, -0.5f, 0.5f);
            b[k] = middle[k] + (double)test_range(&random, -0.5f, 0.5f);
        }
        dmi_frame_point_in(&frame, a, inner_a);
        dmi_frame_point_in(&frame, b, inner_b);
        const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
        /* a skew matrix of floats is orthogonal to 1e-7 alone */
        assert_near(test_distance(inner_a, inner_b), sqrt(x * x + y * y + z * z), 1e-6);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(presets_are_what_they_say),
        cmocka_unit_test(frames_that_leave_the_range_of_floats),
        cmocka_unit_test(bad_axes_are_refused),
        cmocka_unit_test(points_vectors_and_directions_there_and_back),
        cmocka_unit_test(matrices_say_the_same),
        cmocka_unit_test(poses_commute_with_points),
        cmocka_unit_test(joints_commute_with_points),
        cmocka_unit_test(rays_keep_their_points),
        cmocka_unit_test(far_objects_keep_their_precision),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
