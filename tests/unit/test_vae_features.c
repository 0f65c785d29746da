/* What the DQ-VAE reads of a drag: joint values and residuals of a path, unwrapping, neighbours, points. */
#include "test_env.h"

#include <math.h>

#include "base/random.h"
#include "math/joint.h"
#include "motion/dq_vae.h"

static float between(dmi_random* random, float low, float high) {
    return low + (high - low) * dmi_random_unit(random);
}

static dm_joint random_joint(dmi_random* random, int32_t type) {
    float axis[3], length = 0.0f;
    for (int i = 0; i < 3; ++i) axis[i] = dmi_random_normal(random);
    for (int i = 0; i < 3; ++i) length += axis[i] * axis[i];
    length = sqrtf(length);
    return (dm_joint){
        .type = type,
        .axis = {axis[0] / length, axis[1] / length, axis[2] / length},
        .origin = {between(random, -0.5f, 0.5f), between(random, -0.5f, 0.5f), between(random, -0.5f, 0.5f)},
        .pitch = type == DM_JOINT_SCREW ? between(random, -0.2f, 0.2f) : 0.0f,
        .lower = -1.0f,
        .upper = 2.0f,
    };
}

/* A drag of a random point whose path follows the joint to `end`. */
static dmi_vae_query follow(dmi_random* random, const dm_joint* joint, float end) {
    dmi_vae_query query = {.joint = *joint};
    for (int i = 0; i < 3; ++i) query.drag_point[i] = between(random, -0.5f, 0.5f);
    for (int i = 0; i < DMI_VAE_PATH; ++i) {
        const dm_pose pose = dmi_joint_pose(joint, end * (float)i / (DMI_VAE_PATH - 1));
        dmi_pose_apply(&pose, query.drag_point, query.path[i]);
    }
    for (int i = 0; i < 3; ++i) query.drag_vector[i] = query.path[1][i] - query.path[0][i];
    return query;
}

static const int32_t moving_types[] = {DM_JOINT_REVOLUTE, DM_JOINT_PRISMATIC, DM_JOINT_SCREW, DM_JOINT_CONTINUOUS};

static void paths_on_the_joint_give_its_values(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 0);
    for (int trial = 0; trial < 200; ++trial) {
        const dm_joint joint = random_joint(&random, moving_types[trial % 4]);
        const float end = dmi_joint_turns(joint.type) ? between(&random, -20.0f, 20.0f) : between(&random, -1.0f, 1.0f);
        const dmi_vae_query query = follow(&random, &joint, end);
        dmi_vae_features made;
        dmi_vae_features_make(&query, &made);
        for (int i = 0; i < DMI_VAE_PATH; ++i) {
            assert_float_equal(made.path[i][3], end * (float)i / (DMI_VAE_PATH - 1), 2e-3f);
            assert_float_equal(made.path[i][4], 0.0f, 1e-4f);
            for (int c = 0; c < 3; ++c) assert_true(made.path[i][c] == query.path[i][c] - query.drag_point[c]);
        }
        assert_true(made.amplitude[0] == made.path[DMI_VAE_PATH - 1][3]);
    }
}

static float distance_at(const dm_joint* joint, const float rest[3], const float target[3], float value) {
    float moved[3], squares = 0.0f;
    const dm_pose pose = dmi_joint_pose(joint, value);
    dmi_pose_apply(&pose, rest, moved);
    for (int c = 0; c < 3; ++c) squares += (moved[c] - target[c]) * (moved[c] - target[c]);
    return sqrtf(squares);
}

/* Off the joint, the residual is the distance left; and for all but screws no other value leaves less. */
static void residuals_are_what_the_joint_leaves(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(2, 0);
    for (int trial = 0; trial < 100; ++trial) {
        const dm_joint joint = random_joint(&random, moving_types[trial % 4]);
        dmi_vae_query query = follow(&random, &joint, 0.5f);
        dmi_vae_features made;
        for (int i = 1; i < DMI_VAE_PATH; ++i)
            for (int c = 0; c < 3; ++c) query.path[i][c] += 0.1f * dmi_random_normal(&random);
        dmi_vae_features_make(&query, &made);
        for (int i = 0; i < DMI_VAE_PATH; ++i) {
            const float value = made.path[i][3], residual = made.path[i][4];
            assert_float_equal(distance_at(&joint, query.drag_point, query.path[i], value), residual, 1e-4f);
            for (float step = -0.3f; step < 0.35f && joint.type != DM_JOINT_SCREW; step += 0.1f)
                assert_true(distance_at(&joint, query.drag_point, query.path[i], value + step) >= residual - 1e-4f);
        }
    }
}

static void a_drag_of_the_axis_itself_is_finite(void** state) {
    (void)state;
    dmi_vae_query query = {.joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}}, .drag_vector = {1, 0, 0}};
    dmi_vae_features made;
    for (int i = 0; i < DMI_VAE_PATH; ++i) query.path[i][0] = 0.1f * (float)i;
    dmi_vae_features_make(&query, &made);
    for (int i = 0; i < DMI_VAE_PATH; ++i) {
        assert_float_equal(made.path[i][3], 0.0f, 0.0f);
        assert_float_equal(made.path[i][4], 0.1f * (float)i, 1e-6f);
    }
    for (int c = 0; c < 3; ++c) assert_float_equal(made.rotation_direction[c], 0.0f, 0.0f);
}

static void the_drag_is_summed_up(void** state) {
    (void)state;
    dmi_vae_query query = {
        .joint = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .pitch = 9, .lower = -7, .upper = 0.5f},
        .drag_point = {0, 2, 0},
        .drag_vector = {0, 0, 3},
    };
    dmi_vae_features made;
    for (int i = 0; i < DMI_VAE_PATH; ++i) {
        query.path[i][0] = (float)(i * i);
        query.path[i][1] = 2.0f;
    }
    dmi_vae_features_make(&query, &made);
    const float scalars[3] = {4, -4, 0.5f}, direction[3] = {1, 0, 0}, chords[9] = {25, 0, 0, 100, 0, 0, 225, 0, 0};
    assert_memory_equal(made.joint_scalars, scalars, sizeof scalars);
    for (int c = 0; c < 3; ++c) assert_float_equal(made.rotation_direction[c], direction[c], 1e-6f);
    for (int c = 0; c < 9; ++c) assert_float_equal(made.chords[c], chords[c], 0.0f);
    assert_float_equal(made.mean_velocity[0], 225.0f / 15 * 16, 1e-4f);
    assert_float_equal(made.amplitude[0], 225.0f, 0.0f);
    assert_float_equal(made.amplitude[1], 225.0f, 1e-4f);
    query.joint.type = DM_JOINT_CONTINUOUS;
    dmi_vae_features_make(&query, &made);
    for (int c = 0; c < 3; ++c) assert_float_equal(made.joint_scalars[c], 0.0f, 0.0f);
}

/* A fixed joint takes the point nowhere: all of the path is residual. */
static void fixed_joints_leave_everything(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(3, 0);
    const dm_joint slide = random_joint(&random, DM_JOINT_PRISMATIC);
    dmi_vae_query query = follow(&random, &slide, 0.6f);
    dmi_vae_features made;
    query.joint.type = DM_JOINT_FIXED;
    dmi_vae_features_make(&query, &made);
    assert_float_equal(made.path[DMI_VAE_PATH - 1][3], 0.0f, 0.0f);
    assert_float_equal(made.path[DMI_VAE_PATH - 1][4], 0.6f, 1e-5f);
}

static float squared_distance(const float a[3], const float b[3]) {
    const float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z;
}

/* Each neighbour comes before every point that is farther, or as far with a larger index. */
static void neighbours_are_the_nearest(void** state) {
    (void)state;
    static dmi_vae_object object;
    dmi_random random = dmi_random_make(4, 0);
    for (int trial = 0; trial < 20; ++trial) {
        const float centre[3] = {0.5f, 1.0f, 1.5f};
        uint32_t found[DMI_VAE_NEIGHBOURS];
        int used[DMI_VAE_POINTS] = {0};
        for (int i = 0; i < DMI_VAE_POINTS; ++i) /* a coarse grid: many ties */
            for (int c = 0; c < 3; ++c) object.xyz[i][c] = (float)(dmi_random_u32(&random) % 5);
        dmi_vae_neighbours(&object, centre, found);
        for (int n = 0; n < DMI_VAE_NEIGHBOURS; ++n) {
            const float distance = squared_distance(object.xyz[found[n]], centre);
            used[found[n]] = 1;
            for (uint32_t i = 0; i < DMI_VAE_POINTS; ++i) {
                const float other = squared_distance(object.xyz[i], centre);
                assert_true(used[i] || other > distance || (other == distance && i > found[n]));
            }
        }
    }
}

/* A cloud keeps every 64th of its 4096 points: 32 of the part, 16 near it, 16 of the body. */
static void one_point_in_64_is_kept(void** state) {
    (void)state;
    static dmi_cloud cloud;
    static dmi_vae_object object;
    dmi_part_points points;
    int part = 0;
    for (int i = 0; i < DMI_CLOUD_POINTS; ++i) cloud.xyz[i][1] = (float)i / DMI_CLOUD_POINTS - 0.5f;
    dmi_part_points_of_cloud(&cloud, &points);
    dmi_vae_object_points(&points, &object);
    for (int i = 0; i < DMI_VAE_POINTS; ++i) {
        assert_float_equal(object.xyz[i][1], (float)i / 64 - 0.5f, 0.0f);
        assert_true(object.mask[i] == (64 * i < DMI_CLOUD_PART ? 1.0f : 0.0f));
        part += object.mask[i] > 0.5f;
    }
    assert_int_equal(part, DMI_VAE_POINTS / 2);
}

/* Half a unit is the most that a kept coordinate is off, but for 0.5 itself, which is a unit off. */
static void points_are_kept_to_a_unit(void** state) {
    (void)state;
    static const float edges[][2] = {
        {0, 0}, {-0.5f, -0.5f}, {0.5f, 0.5f - 0x1p-16f}, {1, 0.5f - 0x1p-16f}, {-1, -0.5f}};
    enum { EDGES = sizeof edges / sizeof *edges };
    dmi_random random = dmi_random_make(5, 0);
    float xyz[DMI_PART_POINTS][3] = {{0}}, kept[DMI_PART_POINTS][3];
    dmi_part_points points;
    for (int i = 0; i < DMI_PART_POINTS; ++i)
        for (int k = 0; k < 3; ++k) xyz[i][k] = dmi_random_unit(&random) - 0.5f;
    for (int i = 0; i < EDGES; ++i) xyz[i][0] = edges[i][0];
    dmi_part_points_take((const float(*)[3])xyz, 1, &points);
    dmi_part_points_place(&points, kept);
    for (int i = 0; i < DMI_PART_POINTS; ++i)
        for (int k = 0; k < 3; ++k)
            if (k != 0 || i >= EDGES) assert_float_equal(kept[i][k], xyz[i][k], 0x1p-16f);
    for (int i = 0; i < EDGES; ++i) assert_float_equal(kept[i][0], edges[i][1], 0.0f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(paths_on_the_joint_give_its_values),
        cmocka_unit_test(residuals_are_what_the_joint_leaves),
        cmocka_unit_test(a_drag_of_the_axis_itself_is_finite),
        cmocka_unit_test(the_drag_is_summed_up),
        cmocka_unit_test(fixed_joints_leave_everything),
        cmocka_unit_test(neighbours_are_the_nearest),
        cmocka_unit_test(one_point_in_64_is_kept),
        cmocka_unit_test(points_are_kept_to_a_unit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
