/* Drags: the grabbed point follows the pointer, on its joint, inside the limits, without jumps, at any frame rate. */
#include "test_math.h"

#include <string.h>

#include "drag/drag.h"
#include "math/frames.h"

enum { CASES = 400 };
#define PI 3.14159265358979f
#define FRAME (1.0f / 60)

static const int32_t types[] = {DM_JOINT_REVOLUTE, DM_JOINT_PRISMATIC, DM_JOINT_SCREW, DM_JOINT_CONTINUOUS};
static const dm_drag_feel immediate = {.smoothing_time = -1};
static const dm_drag_feel plain = {0};

static void point_at(const dm_joint* joint, float value, const float rest[3], float out[3]) {
    dm_pose pose = dmi_joint_pose(joint, value);
    dmi_pose_apply(&pose, rest, out);
}

static dm_ray ray_through(const float eye[3], const float point[3]) {
    return (dm_ray){dmi_vec3(eye), {point[0] - eye[0], point[1] - eye[1], point[2] - eye[2]}};
}

static void random_eye(dmi_random* random, float out[3]) {
    test_direction(random, out);
    const float distance = test_range(random, 2, 4);
    for (int i = 0; i < 3; i++) out[i] *= distance;
}

/* Sine of the angle between the point's way and the line of sight: small where the pointer says little. */
static float visibility(const dm_joint* joint, float value, const float rest[3], const float eye[3]) {
    float v[3], p[3], s[3], vv = 0, ss = 0, vs = 0;
    dmi_joint_velocity(joint, value, rest, v);
    point_at(joint, value, rest, p);
    for (int i = 0; i < 3; i++) {
        s[i] = p[i] - eye[i];
        vv += v[i] * v[i];
        ss += s[i] * s[i];
        vs += v[i] * s[i];
    }
    return sqrtf(fmaxf(0, 1 - vs * vs / (vv * ss)));
}

static float arm_length(const dm_joint* joint, const float rest[3]) {
    float v[3], nothing[3] = {0, 0, 0};
    dmi_joint_velocity(joint, 0, rest, v);
    return (float)test_distance(v, nothing);
}

/* A hand that draws the point exactly along its way: the drag must come along to the same value. */
static void exact_rays_recover_the_value(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 5);
    int told = 0;
    for (int i = 0; i < 4 * CASES; i++) {
        dm_joint joint = test_joint(&random, types[i % 4], 0.5f);
        float rest[3], eye[3], point[3];
        test_point(&random, 0.5f, rest);
        random_eye(&random, eye);
        const float from = test_range(&random, joint.lower, joint.upper);
        const float to = test_range(&random, joint.lower, joint.upper);
        float seen = 1;
        for (int k = 0; k <= 20; k++) {
            seen = fminf(seen, visibility(&joint, from + (to - from) * (float)k / 20, rest, eye));
        }
        if (seen < 0.15f || arm_length(&joint, rest) < 0.05f) continue;
        dmi_drag drag;
        dm_drag_state now;
        point_at(&joint, from, rest, point);
        dmi_drag_begin(&drag, &joint, point, from, &immediate);
        for (int k = 0; k <= 20; k++) {
            point_at(&joint, from + (to - from) * (float)k / 20, rest, point);
            dm_ray ray = ray_through(eye, point);
            dmi_drag_update(&drag, &ray, FRAME, &now);
        }
        assert_near(now.target, to, 1e-4);
        assert_near(now.value, now.target, 0);
        assert_near3(dmi_xyz(now.grab_point).v, point, 1e-4);
        told++;
    }
    assert_true(told > CASES);
}

/* The same through an orthographic camera, whose rays may start in front of the point or behind it. */
static void parallel_rays_recover_the_value(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(2, 5);
    int told = 0;
    for (int i = 0; i < 4 * CASES; i++) {
        dm_joint joint = test_joint(&random, types[i % 4], 0.5f);
        float rest[3], sight[3], eye[3], point[3];
        test_point(&random, 0.5f, rest);
        test_direction(&random, sight);
        const float to = test_range(&random, joint.lower, joint.upper), back = test_range(&random, -2, 2);
        for (int k = 0; k < 3; k++) eye[k] = -1000 * sight[k];
        float seen = 1;
        for (int k = 0; k <= 20; k++) seen = fminf(seen, visibility(&joint, to * (float)k / 20, rest, eye));
        if (seen < 0.15f || arm_length(&joint, rest) < 0.05f) continue;
        dmi_drag drag;
        dm_drag_state now;
        dmi_drag_begin(&drag, &joint, rest, 0, &immediate);
        for (int k = 0; k <= 20; k++) {
            point_at(&joint, to * (float)k / 20, rest, point);
            /* ray origins in a plane across the sight, as a camera makes them */
            float along = 0;
            for (int n = 0; n < 3; n++) along += point[n] * sight[n];
            for (int n = 0; n < 3; n++) point[n] += (back - along) * sight[n] * (i % 3 ? 1.0f : 1000.0f);
            dm_ray ray = {dmi_vec3(point), dmi_vec3(sight)};
            dmi_drag_update(&drag, &ray, FRAME, &now);
        }
        assert_near(now.target, to, i % 3 ? 2e-4 : 0.02); /* a thousand units away, floats tell no more */
        told++;
    }
    assert_true(told > CASES);
}

static float ray_line_distance(const dm_ray* ray, const float point[3]) {
    float d[3] = {ray->direction.x, ray->direction.y, ray->direction.z}, g[3], dd = 0, gg = 0, dg = 0;
    g[0] = point[0] - ray->origin.x, g[1] = point[1] - ray->origin.y, g[2] = point[2] - ray->origin.z;
    for (int i = 0; i < 3; i++) dd += d[i] * d[i], gg += g[i] * g[i], dg += d[i] * g[i];
    return sqrtf(fmaxf(0, gg - dg * dg / dd));
}

/* Whatever rays come: finite, inside the limits, on the joint, and no farther at once than 16 times the pointer. */
static void wild_rays_do_no_harm(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(3, 5);
    const float dt = 1e-4f; /* so short that catching up adds little */
    for (int i = 0; i < 4 * CASES; i++) {
        const int32_t type = types[i % 4];
        dm_joint joint = test_joint(&random, type, 0.5f);
        float rest[3], eye[3], aim[3] = {0}, before[3];
        test_point(&random, 0.5f, rest);
        random_eye(&random, eye);
        dmi_drag drag;
        dm_drag_state now;
        const dm_drag_feel feel = {.smoothing_time = -1, .soft_limit = i % 8 < 4 ? 0 : 0.2f};
        dmi_drag_begin(&drag, &joint, rest, 0, &feel);
        dmi_drag_get_state(&drag, &now);
        const float arm = arm_length(&joint, rest);
        for (int k = 0; k < 40; k++) {
            const float old = now.target;
            dm_ray last = ray_through(eye, aim);
            for (int n = 0; n < 3; n++) aim[n] += 0.05f * dmi_random_normal(&random);
            dm_ray ray = ray_through(eye, aim);
            point_at(&joint, old, rest, before);
            dmi_drag_update(&drag, &ray, dt, &now);
            assert_true(isfinite(now.value) && isfinite(now.velocity) && isfinite(now.target));
            if (type != DM_JOINT_CONTINUOUS) {
                assert_true(now.value >= joint.lower && now.value <= joint.upper);
                assert_true(now.target >= joint.lower && now.target <= joint.upper);
            }
            dm_pose pose = dmi_joint_pose(&joint, now.value);
            assert_same_motion(&pose, &now.pose, 1, 1e-6);
            assert_is_unit(&now.pose, 2e-6);
            if (k == 0) continue; /* the first ray may be anywhere */
            const float moved = fabsf(now.target - old) * arm;
            const float pointer = ray_line_distance(&last, before) + ray_line_distance(&ray, before);
            assert_true(moved <= 16 * pointer + 0.01f);
        }
    }
}

static void nonsense_keeps_the_last_target(void** state) {
    (void)state;
    const float huge = 3e38f;
    const dm_ray bad[] = {
        {{NAN, 0, 0}, {0, 0, 1}},      {{0, 0, 0}, {NAN, 0, 1}},      {{0, 0, 0}, {0, 0, 0}},
        {{INFINITY, 0, 0}, {0, 0, 1}}, {{0, 0, 0}, {INFINITY, 0, 0}}, {{huge, huge, huge}, {huge, huge, 1}},
        {{0, 0, 1e20f}, {0, 1, 0}},
    };
    const float times[] = {FRAME, 0, -1, NAN, INFINITY, 1e30f, 1e-30f};
    dmi_random random = dmi_random_make(4, 5);
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, types[i % 4], 0.5f);
        float rest[3], eye[3];
        test_point(&random, 0.5f, rest);
        random_eye(&random, eye);
        dmi_drag drag;
        dm_drag_state now;
        dmi_drag_begin(&drag, &joint, rest, 0, i % 2 ? &immediate : &plain);
        dm_ray good = ray_through(eye, rest);
        dmi_drag_update(&drag, &good, FRAME, &now);
        for (int k = 0; k < 7; k++) {
            for (int n = 0; n < 7; n++) {
                const float target = now.target;
                dmi_drag_update(&drag, &bad[k], times[n], &now);
                assert_true(isfinite(now.value) && isfinite(now.velocity) && isfinite(now.target));
                if (k < 5) assert_near(now.target, target, 0);
                if (joint.type != DM_JOINT_CONTINUOUS) {
                    assert_true(now.value >= joint.lower && now.value <= joint.upper);
                }
            }
        }
    }
}

static void fixed_joints_stay(void** state) {
    (void)state;
    dm_joint joint = {.type = DM_JOINT_FIXED, .axis = {0, 0, 1}};
    const float rest[3] = {1, 0, 0}, eye[3] = {0, 0, 5}, aim[3] = {0, 1, 0};
    dmi_drag drag;
    dm_drag_state now;
    dmi_drag_begin(&drag, &joint, rest, 0, &plain);
    dm_ray ray = ray_through(eye, aim);
    dmi_drag_update(&drag, &ray, FRAME, &now);
    assert_near(now.value, 0, 0);
    assert_near3(dmi_xyz(now.grab_point).v, rest, 0);
    assert_int_equal(now.at_limit, 0);
}

/* A point on the axis has no way to go: a turn must not spin on rounding. */
static void grabbing_the_axis_turns_nothing(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(8, 5);
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, DM_JOINT_CONTINUOUS, 0.5f);
        float rest[3], eye[3], aim[3];
        const float along = test_range(&random, -1, 1);
        rest[0] = joint.origin.x + along * joint.axis.x;
        rest[1] = joint.origin.y + along * joint.axis.y;
        rest[2] = joint.origin.z + along * joint.axis.z;
        random_eye(&random, eye);
        dmi_drag drag;
        dm_drag_state now;
        dmi_drag_begin(&drag, &joint, rest, 0, &plain);
        for (int k = 0; k < 5; k++) {
            test_point(&random, 0.5f, aim);
            dm_ray ray = ray_through(eye, aim);
            dmi_drag_update(&drag, &ray, FRAME, &now);
            assert_near(now.value, 0, 0);
        }
    }
}

/* Across a wheel's hub the nearest point of the rim changes sides at once; the wheel goes there in its own time. */
static void crossing_the_hub_makes_no_jump(void** state) {
    (void)state;
    dm_joint joint = {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, 1}};
    const float rest[3] = {0.5f, 0, 0}, eye[3] = {0, 0, 3}, step = 0.002f;
    dmi_drag drag;
    dm_drag_state now;
    dmi_drag_begin(&drag, &joint, rest, 0, &immediate);
    float last = 0;
    for (int k = 0; k <= 500; k++) {
        const float aim[3] = {0.5f - step * (float)k, 1e-4f, 0};
        dm_ray ray = ray_through(eye, aim);
        dmi_drag_update(&drag, &ray, 1e-4f, &now);
        assert_true(fabsf(now.value - last) <= 16.5f * step / 0.5f + 1e-3f * PI);
        last = now.value;
    }
    const float aim[3] = {-0.5f, 1e-4f, 0};
    dm_ray ray = ray_through(eye, aim);
    for (int k = 0; k < 120; k++) dmi_drag_update(&drag, &ray, FRAME, &now);
    assert_near(fabs((double)now.value), (double)PI, 1e-3);
    /* And a wish far from where the pointer went waits for its time: it is turned to at 6 rad/s. */
    dmi_drag_begin(&drag, &joint, rest, 0, &immediate);
    const float hub_before[3] = {1e-5f, 0, 0}, hub_behind[3] = {-1e-5f, 1e-7f, 0};
    ray = ray_through(eye, hub_before);
    for (int k = 0; k < 10; k++) dmi_drag_update(&drag, &ray, FRAME, &now);
    assert_near(now.value, 0, 1e-4);
    ray = ray_through(eye, hub_behind);
    dmi_drag_update(&drag, &ray, 0.1f, &now);
    assert_near(fabs((double)now.value), 0.6, 1e-3);
    for (int k = 0; k < 60; k++) dmi_drag_update(&drag, &ray, FRAME, &now);
    assert_near(fabs((double)now.value), (double)PI, 0.05);
}

/* Wheels and screws count whole turns, both ways. */
static void turns_add_up(void** state) {
    (void)state;
    for (int i = 0; i < 4; i++) {
        const float sign = i % 2 ? -1.0f : 1.0f;
        dm_joint joint = {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, 1}};
        if (i >= 2) joint.type = DM_JOINT_SCREW, joint.pitch = 0.02f, joint.lower = -40, joint.upper = 40;
        const float rest[3] = {0.5f, 0, 0}, eye[3] = {0.2f, 0.3f, 3};
        float point[3];
        dmi_drag drag;
        dm_drag_state now;
        dmi_drag_begin(&drag, &joint, rest, 0, &immediate);
        for (int k = 0; k <= 180; k++) {
            point_at(&joint, sign * 6 * PI * (float)k / 180, rest, point);
            dm_ray ray = ray_through(eye, point);
            dmi_drag_update(&drag, &ray, FRAME, &now);
        }
        assert_near(now.value, sign * 6 * PI, 1e-3);
    }
}

static void still_pointer_halves_the_gap_in_the_smoothing_time(void** state) {
    (void)state;
    const float smoothing[] = {0, 0.05f, 0.3f}, half_lives[] = {0.02f, 0.05f, 0.3f};
    dm_joint joint = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = -1, .upper = 1};
    const float rest[3] = {0, 0, 0}, eye[3] = {0, 0, 3}, aim[3] = {0.8f, 0, 0};
    for (int i = 0; i < 3; i++) {
        dmi_drag drag;
        dm_drag_state now;
        const dm_drag_feel feel = {.smoothing_time = smoothing[i]};
        dmi_drag_begin(&drag, &joint, rest, 0, &feel);
        dm_ray ray = ray_through(eye, aim);
        dmi_drag_update(&drag, &ray, 0, &now);
        assert_near(now.target, 0.8f, 1e-6);
        assert_near(now.value, 0, 0); /* no time, no motion */
        dmi_drag_update(&drag, &ray, half_lives[i], &now);
        assert_near(now.value, 0.4f, 1e-6);
        assert_near(now.velocity, 0.4f / half_lives[i], 1e-4 / (double)half_lives[i]);
        dmi_drag_update(&drag, &ray, half_lives[i], &now);
        assert_near(now.value, 0.6f, 1e-6);
        dmi_drag_update(&drag, &ray, 100, &now);
        assert_near(now.value, 0.8f, 1e-6);
    }
}

/* Where the pointer is after `time` of a wavy stroke, which ends in full motion. */
static dm_ray stroke(const dm_joint* joint, const float rest[3], const float eye[3], float to, float time) {
    float point[3];
    point_at(joint, to * time, rest, point);
    point[0] += 0.05f * sinf(5 * time);
    return ray_through(eye, point);
}

static float drag_at_rate(const dm_joint* joint, const float rest[3], const float eye[3], float to, int updates) {
    dmi_drag drag;
    dm_drag_state now = {0};
    dmi_drag_begin(&drag, joint, rest, 0, &plain);
    for (int k = 0; k <= updates; k++) {
        dm_ray ray = stroke(joint, rest, eye, to, (float)k / (float)updates);
        dmi_drag_update(&drag, &ray, 0.7f / (float)updates, &now);
    }
    return now.value;
}

static void frame_rate_does_not_matter(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(5, 5);
    int compared = 0;
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, types[i % 4], 0.5f);
        float rest[3], eye[3];
        test_point(&random, 0.5f, rest);
        random_eye(&random, eye);
        float seen = 1;
        for (int k = 0; k <= 20; k++) seen = fminf(seen, visibility(&joint, joint.upper * (float)k / 20, rest, eye));
        if (seen < 0.3f || arm_length(&joint, rest) < 0.2f) continue;
        const float slow = drag_at_rate(&joint, rest, eye, joint.upper, 42);
        const float fast = drag_at_rate(&joint, rest, eye, joint.upper, 84);
        const float faster = drag_at_rate(&joint, rest, eye, joint.upper, 336);
        assert_near(slow, fast, 0.003 * (double)joint.upper);
        assert_near(slow, faster, 0.003 * (double)joint.upper);
        compared++;
    }
    assert_true(compared > 50);
}

static void host_axes_do_not_matter(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(6, 5);
    for (int i = 0; i < CASES; i++) {
        dmi_frame frame = {.size = 0.8};
        assert_true(dmi_axes_init(&frame.axes, i % 4, NULL, i % 3 ? 1 : 0.01f));
        for (int k = 0; k < 3; k++) frame.centre[k] = (double)test_range(&random, -1, 1);
        dm_joint inner = test_joint(&random, types[i / 4 % 4], 0.5f), host = dmi_frame_joint_out(&frame, &inner);
        float rest[3], eye[3], host_rest[3], host_eye[3], point[3], host_point[3];
        test_point(&random, 0.5f, rest);
        random_eye(&random, eye);
        dmi_frame_point_out(&frame, rest, host_rest);
        dmi_frame_point_out(&frame, eye, host_eye);
        float seen = 1;
        for (int k = 0; k <= 20; k++) seen = fminf(seen, visibility(&inner, inner.upper * (float)k / 20, rest, eye));
        if (seen < 0.15f || arm_length(&inner, rest) < 0.1f) continue;
        dmi_drag drag, host_drag;
        dm_drag_state now, host_now;
        dmi_drag_begin(&drag, &inner, rest, 0, &plain);
        dmi_drag_begin(&host_drag, &host, host_rest, 0, &plain);
        for (int k = 0; k < 20; k++) {
            point_at(&inner, inner.upper * (float)k / 15, rest, point); /* somewhat beyond the limit */
            dmi_frame_point_out(&frame, point, host_point);
            dm_ray ray = ray_through(eye, point), host_ray = ray_through(host_eye, host_point);
            dmi_drag_update(&drag, &ray, FRAME, &now);
            dmi_drag_update(&host_drag, &host_ray, FRAME, &host_now);
        }
        const float scale = inner.type == DM_JOINT_PRISMATIC ? dmi_frame_length_out(&frame) : 1;
        /* Measured: one unit in the last place of a ray moves a screw that is seen nearly from the end by 2.6e-4. */
        assert_near(host_now.value, now.value * scale, 5e-4 * (double)scale);
        assert_near(host_now.velocity, now.velocity * scale, 5e-3 * (double)scale);
        assert_int_equal(host_now.at_limit, now.at_limit);
    }
}

static void limits_stop_and_are_told(void** state) {
    (void)state;
    dm_joint joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}, .lower = -0.5f, .upper = 1.2f};
    const float rest[3] = {0.5f, 0, 0}, eye[3] = {0, 4, 0.1f}, values[] = {2, 1.2f, 0.6f, -0.5f, -2, 0};
    const int32_t ends[] = {1, 1, 0, -1, -1, 0};
    dmi_drag drag;
    dm_drag_state now;
    float point[3];
    dmi_drag_begin(&drag, &joint, rest, 0, &plain);
    for (int i = 0; i < 6; i++) {
        point_at(&joint, values[i], rest, point);
        dm_ray ray = ray_through(eye, point);
        for (int k = 0; k < 60; k++) dmi_drag_update(&drag, &ray, FRAME, &now);
        assert_near(now.value, fminf(fmaxf(values[i], -0.5f), 1.2f), 1e-4);
        assert_int_equal(now.at_limit, ends[i]);
        assert_near(now.velocity, 0, 1e-3);
    }
}

static void soft_ends_give_and_are_reached(void** state) {
    (void)state;
    dm_joint joint = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = 0, .upper = 1};
    const dm_drag_feel feel = {.smoothing_time = -1, .soft_limit = 0.2f};
    const float rest[3] = {0, 0, 0}, eye[3] = {0.5f, 0, 9};
    dmi_drag drag;
    dm_drag_state now;
    dmi_drag_begin(&drag, &joint, rest, 0, &feel);
    float last = 0;
    for (int k = -300; k <= 1300; k++) {
        const float aim[3] = {(float)k / 1000, 0, 0};
        dm_ray ray = ray_through(eye, aim);
        dmi_drag_update(&drag, &ray, FRAME, &now);
        if (k > -300) assert_true(now.value >= last - 1e-6f && now.value - last < 1.05e-3f);
        if (k <= -200) assert_near(now.value, 0, 1e-5);
        if (k >= 200 && k <= 800) assert_near(now.value, aim[0], 1e-5); /* between the soft ends, as ever */
        if (k == 1000) assert_near(now.value, 0.95f, 1e-5);
        if (k >= 1200) assert_near(now.value, 1, 1e-5);
        last = now.value;
    }
    assert_int_equal(now.at_limit, 1);
    const float starts[] = {0, 0.01f, 0.1f, 0.5f, 0.97f, 1};
    for (int i = 0; i < 6; i++) { /* grabbing a part that stands in the soft zone does not move it */
        const float grab[3] = {starts[i], 0, 0};
        dmi_drag_begin(&drag, &joint, grab, starts[i], &feel);
        dmi_drag_get_state(&drag, &now);
        assert_near(now.value, starts[i], 1e-6);
        assert_near3(drag.rest_point, rest, 1e-6);
    }
}

/* A part grabbed half open, or beyond its limits, starts from there. */
static void drags_start_where_the_part_is(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(7, 5);
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, types[i % 3], 0.5f);
        float rest[3], eye[3], grab[3];
        test_point(&random, 0.5f, rest);
        random_eye(&random, eye);
        const float start = test_range(&random, 1.2f * joint.lower, 1.2f * joint.upper);
        point_at(&joint, start, rest, grab);
        dmi_drag drag;
        dm_drag_state now;
        dmi_drag_begin(&drag, &joint, grab, start, &plain);
        assert_near3(drag.rest_point, rest, 2e-6);
        dm_ray ray = ray_through(eye, grab);
        dmi_drag_update(&drag, &ray, FRAME, &now);
        assert_near(now.value, fminf(fmaxf(start, joint.lower), joint.upper), 2e-3);
    }
}

/* A door that stands farther open than its limits say comes into them by its own hinge: points of the axis stay. */
static void a_part_outside_its_limits_comes_in_on_its_joint(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(8, 5);
    for (int i = 0; i < CASES; i++) {
        const dm_joint joint = test_joint(&random, DM_JOINT_REVOLUTE, 0.5f);
        float rest[3], eye[3], grab[3], actual[3];
        test_point(&random, 0.5f, rest);
        random_eye(&random, eye);
        const float start = joint.upper + test_range(&random, 0.2f, 1.5f);
        point_at(&joint, start, rest, grab);
        dmi_drag drag;
        dmi_drag_begin(&drag, &joint, grab, start, &plain);
        for (int k = 0; k < 45; k++) {
            const dm_ray ray = ray_through(eye, grab);
            dm_drag_state now;
            dmi_drag_update(&drag, &ray, FRAME, &now);
            dmi_pose_apply(&now.pose, dmi_xyz(joint.origin).v, actual);
            assert_near3(actual, dmi_xyz(joint.origin).v, 2e-5);
        }
    }
}

/* A drawer seen end on, or its line's own direction as the ray: nothing to learn, nothing moves. */
static void rays_along_a_slide_keep_it(void** state) {
    (void)state;
    dm_joint joint = {.type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}, .lower = -1, .upper = 1};
    const float rest[3] = {0, 0, 0}, eye[3] = {0, 0, 5}, aim[3] = {0.3f, 0.1f, 0};
    dmi_drag drag;
    dm_drag_state now;
    dmi_drag_begin(&drag, &joint, rest, 0.0f, &immediate);
    dm_ray end_on = ray_through(eye, rest), beside = ray_through(eye, aim);
    dmi_drag_update(&drag, &end_on, FRAME, &now);
    assert_near(now.target, 0, 0);
    dmi_drag_update(&drag, &beside, FRAME, &now);
    assert_near(now.target, 0, 0);
    dmi_drag_begin(&drag, &joint, rest, 0.25f, &immediate);
    for (int k = 0; k < 10; k++) { /* orthographic, along the slide */
        dm_ray ray = {{0.1f * (float)k, 0, 3}, {0, 0, -1}};
        dmi_drag_update(&drag, &ray, FRAME, &now);
        if (k > 0) assert_near(now.target, 0.25f, 1e-3);
    }
}

/* 15 pixels beside the point in a view of 960 that is 90 degrees high, which is wide, are 0.031 rad. */
static void a_hand_beside_the_point_in_a_wide_view_moves_nothing(void** state) {
    (void)state;
    const dm_joint slide = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = -1, .upper = 1};
    const float rest[3] = {0, 0, 0}, eye[3] = {0, 0, 2}, aim[3] = {2 * 0.03125f, 0, 0};
    const dm_drag_feel feel = {0};
    const dm_ray beside = ray_through(eye, aim);
    dmi_drag drag;
    dm_drag_state now = {0};
    dmi_drag_begin(&drag, &slide, rest, 0, &feel);
    for (int k = 0; k < 30; k++) {
        dmi_drag_update(&drag, &beside, FRAME, &now);
        assert_near(now.value, 0, 1e-6);
    }
}

/* Pushing a drawer in, the pointer crosses the horizon beside the drawer's vanishing point: it stays in. */
static void beyond_the_vanishing_point_the_end_holds(void** state) {
    (void)state;
    dm_joint joint = {.type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}, .lower = -0.5f, .upper = 0.5f};
    const float rest[3] = {0, -1, -2}, eye[3] = {0, 0, 0};
    for (int side = -2; side <= 2; side++) {
        dmi_drag drag;
        dm_drag_state now = {0};
        dmi_drag_begin(&drag, &joint, rest, 0, &immediate);
        float last = 0;
        for (int k = 0; k <= 100; k++) {
            const float aim[3] = {0.3f * (float)side * (float)k / 100, -1 + 1.5f * (float)k / 100, -2};
            dm_ray ray = ray_through(eye, aim);
            dmi_drag_update(&drag, &ray, FRAME, &now);
            assert_true(now.target <= last + 0.02f);
            last = now.target;
        }
        assert_near(now.target, -0.5f, 1e-5);
    }
}

/* A closed door stands half in profile: its handle first goes left on the screen, then right. A hand that pulls it
 * straight to where it is open goes right from the start. The door must open, without a jump. */
static void a_straight_pull_passes_the_turning_point(void** state) {
    (void)state;
    const dm_joint door = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}, .upper = 2.8f};
    const float rest[3] = {-0.8f, -0.6f, 0}, eye[3] = {0, -4, 2};
    float end[3], last = 0;
    point_at(&door, 2.7f, rest, end);
    dmi_drag drag;
    dm_drag_state now;
    dmi_drag_begin(&drag, &door, rest, 0, &immediate);
    for (int i = 0; i <= 150; i++) {
        const float share = fminf((float)i / 90, 1);
        float point[3];
        for (int k = 0; k < 3; k++) point[k] = rest[k] + share * (end[k] - rest[k]);
        const dm_ray ray = ray_through(eye, point);
        dmi_drag_update(&drag, &ray, FRAME, &now);
        assert_true(fabsf(now.value - last) < 0.3f);
        last = now.value;
    }
    assert_near(now.value, 2.7f, 0.1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_rays_recover_the_value),
        cmocka_unit_test(parallel_rays_recover_the_value),
        cmocka_unit_test(wild_rays_do_no_harm),
        cmocka_unit_test(nonsense_keeps_the_last_target),
        cmocka_unit_test(fixed_joints_stay),
        cmocka_unit_test(grabbing_the_axis_turns_nothing),
        cmocka_unit_test(crossing_the_hub_makes_no_jump),
        cmocka_unit_test(turns_add_up),
        cmocka_unit_test(a_hand_beside_the_point_in_a_wide_view_moves_nothing),
        cmocka_unit_test(still_pointer_halves_the_gap_in_the_smoothing_time),
        cmocka_unit_test(frame_rate_does_not_matter),
        cmocka_unit_test(host_axes_do_not_matter),
        cmocka_unit_test(limits_stop_and_are_told),
        cmocka_unit_test(soft_ends_give_and_are_reached),
        cmocka_unit_test(drags_start_where_the_part_is),
        cmocka_unit_test(a_part_outside_its_limits_comes_in_on_its_joint),
        cmocka_unit_test(rays_along_a_slide_keep_it),
        cmocka_unit_test(a_straight_pull_passes_the_turning_point),
        cmocka_unit_test(beyond_the_vanishing_point_the_end_holds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
