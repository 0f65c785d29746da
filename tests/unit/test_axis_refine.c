/* The pull corrects the axis line of a turn that geometry has a little beside the true one, and only if it is clear. */
#include "test_math.h"

#include <string.h>

#include "drag/drag.h"
#include "drag/joint_hypothesis.h"

#define FRAME (1.0f / 60)

/* A door on the left edge of a panel of size 1, with its range; and the hand. */
static const dm_joint door = {
    .type = DM_JOINT_REVOLUTE, .joint_confidence = 0.6f, .axis = {0, -1, 0}, .origin = {-0.5f, 0, 0}, .upper = 1.57f};
static const float handle[3] = {0.3f, 0.3f, 0.02f}, eye[3] = {1.2f, 1.4f, 3};

static dm_ray ray_to(const float point[3]) {
    return (dm_ray){dmi_vec3(eye), {point[0] - eye[0], point[1] - eye[1], point[2] - eye[2]}};
}

static void point_on(const dm_joint* joint, float value, float out[3]) {
    const dm_pose pose = dmi_joint_pose(joint, value);
    dmi_pose_apply(&pose, handle, out);
}

static dm_joint moved(const dm_joint* joint, float x, float z) {
    dm_joint out = *joint;
    out.origin.x += x, out.origin.z += z;
    return out;
}

/* How far the handle went in one frame, at most. `wander`: of the hand, half-way. */
static float pull(dmi_drag* drag, const dm_joint* assumed, const dm_joint* truth, float to, float wander,
                  dm_drag_state* now) {
    const dm_drag_feel feel = {0};
    float last[3], point[3], longest = 0;
    dmi_drag_begin(drag, assumed, handle, 0, &feel);
    dmi_drag_track_hypotheses(drag, assumed, NULL, 1, 1, (dmi_limit_give){.length = 4});
    memcpy(last, handle, sizeof last);
    for (int k = 0; k <= 160; k++) {
        const float share = fminf((float)k / 120, 1);
        point_on(truth, to * share, point);
        point[1] += wander * sinf(3.14159265f * share);
        const dm_ray ray = ray_to(point);
        dmi_drag_update(drag, &ray, FRAME, now);
        longest = fmaxf(longest, (float)test_distance(last, dmi_xyz(now->grab_point).v));
        memcpy(last, dmi_xyz(now->grab_point).v, sizeof last);
    }
    return longest;
}

/* At least half the way there: what is left of the misses is within what hands do. */
static void a_line_comes_to_where_the_pull_has_it(void** state) {
    (void)state;
    static const float beside[4][2] = {{0.2f, 0}, {0, 0.2f}, {0, -0.2f}, {0.12f, -0.12f}};
    for (int i = 0; i < 4; i++) {
        const dm_joint assumed = moved(&door, beside[i][0], beside[i][1]);
        dmi_drag drag;
        dm_drag_state now = {0};
        const float longest = pull(&drag, &assumed, &door, 1.4f, 0, &now);
        const float x = drag.joint.origin.x - door.origin.x, z = drag.joint.origin.z - door.origin.z;
        assert_true(hypotf(x, z) < 0.5f * hypotf(beside[i][0], beside[i][1]));
        assert_near3(dmi_xyz(drag.joint.axis).v, dmi_xyz(door.axis).v, 0);
        assert_true(now.changes > 0 && longest < 0.05f);
    }
}

/* Neither for a hand that goes the right way nor for one that is off by half a per cent; one that bends its way by a
 * whole one may shift the line a little. */
static void a_right_line_stays(void** state) {
    (void)state;
    static const float wander[] = {0, 0.003f, -0.003f, 0.005f, -0.005f, 0.01f, -0.01f};
    for (size_t i = 0; i < sizeof wander / sizeof *wander; i++) {
        dmi_drag drag;
        dm_drag_state now = {0};
        pull(&drag, &door, &door, 1.4f, wander[i], &now);
        const float most = fabsf(wander[i]) > 0.007f ? 0.05f : 0;
        assert_true(most > 0 || now.changes == 0);
        assert_near3(dmi_xyz(drag.joint.origin).v, dmi_xyz(door.origin).v, (double)most);
    }
}

static void a_slide_has_no_line(void** state) {
    (void)state;
    static const dm_joint slide = {.type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}};
    float outward[3], forward[3];
    assert_false(dmi_pull_fit_shift_directions(&slide, handle, outward, forward));
    assert_true(dmi_pull_fit_shift_directions(&door, handle, outward, forward));
    assert_near3(outward, ((float[3]){0.8f / hypotf(0.8f, 0.02f), 0, 0.02f / hypotf(0.8f, 0.02f)}), 1e-6);
}

/* A circle, round and round, is remembered once, evenly, whatever its size. */
static void a_pull_is_remembered_evenly(void** state) {
    (void)state;
    static const float radii[] = {0.02f, 0.3f, 2.0f};
    for (int i = 0; i < 3; i++) {
        dmi_pull memory;
        dmi_pull_begin(&memory, handle, 0.006f);
        memory.projection = DMI_PARALLEL;
        uint32_t after_one = 0, thinned = 0;
        for (int k = 0; k <= 2000; k++) {
            const float angle = 6.28318531f * (float)k / 500, r = radii[i];
            const float point[3] = {handle[0] + r * (1 - cosf(angle)), handle[1] + r * sinf(angle), handle[2]};
            const dm_ray ray = {{point[0], point[1], 5}, {0, 0, -1}};
            dmi_pull_add(&memory, &ray);
            if (k == 500) after_one = memory.count, thinned = memory.thinned;
        }
        assert_true(memory.count == after_one && memory.thinned == thinned);
        assert_in_range(memory.count, DMI_PULL_RAYS / 2, DMI_PULL_RAYS);
        assert_near(memory.length, 2 * radii[i], 1e-3 * (double)radii[i]);
        for (uint32_t a = 0; a < memory.count; a++)
            for (uint32_t b = 0; b < a; b++)
                assert_true(test_distance(memory.places[a], memory.places[b]) > 0.5 * (double)memory.spacing);
    }
}

static int cuts_corner(const float place[3]) {
    dmi_pull memory;
    dmi_pull_begin(&memory, handle, 0.006f);
    memory.projection = DMI_PARALLEL;
    const dm_ray ray = {{place[0] - 0.3f, place[1] + 5, place[2]}, {0.06f / 1.0017984f, -1 / 1.0017984f, 0}};
    dmi_pull_add(&memory, &ray);
    return dmi_pull_is_on_chord(&memory, &door);
}

/* Some share of the straight way to a place on the circle, to either side; not of a longer way, not outwards. */
static void a_corner_is_cut_within_the_circle(void** state) {
    (void)state;
    for (float value = -2.3f; value < 2.4f; value += 0.4f) {
        float there[3];
        point_on(&door, value, there);
        for (float share = 0.2f; share < 1.5f; share += 0.32f) {
            float place[3], outside[3];
            for (int i = 0; i < 3; i++) place[i] = handle[i] + share * (there[i] - handle[i]);
            for (int i = 0; i < 3; i++) outside[i] = 2 * handle[i] - place[i];
            assert_int_equal(cuts_corner(place), share < 1.1f);
            assert_false(cuts_corner(outside));
        }
        point_on(&door, copysignf(2.6f, value), there); /* nobody goes so far round in a straight line */
        assert_false(cuts_corner(there));
    }
}

/* The way to a place on the circle is straight on the screen, however much nearer to the eye its end is. */
static void a_corner_is_cut_in_perspective_too(void** state) {
    (void)state;
    for (float value = 0.4f; value < 2; value += 0.4f) {
        float there[3], aim[3];
        dmi_pull memory;
        point_on(&door, value, there);
        dmi_pull_begin(&memory, handle, 0.006f);
        memory.projection = DMI_PERSPECTIVE;
        for (int k = 1; k <= 20; k++) {
            for (int i = 0; i < 3; i++) aim[i] = handle[i] + 0.05f * (float)k * (there[i] - handle[i]);
            const dm_ray ray = ray_to(aim);
            dmi_pull_add(&memory, &ray);
            assert_true(dmi_pull_is_on_chord(&memory, &door));
        }
        assert_true(memory.bend < 1e-3f * memory.length);
    }
}

/* Half the squared misses, by the line's place. */
static double half_squares(const dmi_pull* memory, dm_joint joint, const float outward[3], const float forward[3],
                           double a, double b, dmi_pull_fit* out) {
    joint.origin.x += (float)(a * (double)outward[0] + b * (double)forward[0]);
    joint.origin.y += (float)(a * (double)outward[1] + b * (double)forward[1]);
    joint.origin.z += (float)(a * (double)outward[2] + b * (double)forward[2]);
    double sum = 0;
    *out = (dmi_pull_fit){.joint = joint, .lower = -INFINITY, .upper = INFINITY, .size = 1};
    memcpy(out->outward, outward, sizeof out->outward);
    memcpy(out->forward, forward, sizeof out->forward);
    for (uint32_t i = 0; i < memory->count; i++) {
        const float before = out->max_residual;
        out->max_residual = 0;
        dmi_pull_fit_step(out, memory);
        sum += 0.5 * (double)out->max_residual * (double)out->max_residual;
        out->max_residual = fmaxf(out->max_residual, before);
    }
    return sum;
}

/* The miss of each ray, by the line's place. */
static void misses_of(const dmi_pull* memory, dm_joint joint, const float outward[3], const float forward[3], double a,
                      double b, double out[DMI_PULL_RAYS]) {
    dmi_pull_fit fit;
    half_squares(memory, joint, outward, forward, a, b, &fit);
    fit.count = 0, fit.pointer_value = 0;
    for (uint32_t i = 0; i < memory->count; i++) {
        fit.max_residual = 0;
        dmi_pull_fit_step(&fit, memory);
        out[i] = (double)fit.max_residual;
    }
}

/* In perspective, they leave out that the depth of the point changes with the line. */
static void slopes_are_those_of_the_misses(void** state) {
    (void)state;
    for (int parallel = 0; parallel < 2; parallel++) {
        const dm_joint assumed = moved(&door, 0.1f, -0.1f);
        dmi_pull memory;
        dmi_pull_begin(&memory, handle, 0.006f);
        memory.projection = parallel ? DMI_PARALLEL : DMI_PERSPECTIVE;
        for (int k = 0; k <= 100; k++) {
            float point[3];
            point_on(&door, 0.012f * (float)k, point);
            dm_ray ray = ray_to(point);
            const float length = (float)test_distance(point, eye);
            ray.direction = (dm_vec3){ray.direction.x / length, ray.direction.y / length, ray.direction.z / length};
            if (parallel) ray = (dm_ray){{point[0] + 1.8f, point[1] + 2.4f, point[2] + 4}, {-0.36f, -0.48f, -0.8f}};
            dmi_pull_add(&memory, &ray);
        }
        float outward[3], forward[3];
        dmi_pull_fit fit, other;
        dmi_pull_fit_shift_directions(&assumed, handle, outward, forward);
        const double step = 0.01, here = half_squares(&memory, assumed, outward, forward, 0, 0, &fit);
        assert_true(here > 1e-6 && fit.max_residual > 0.005f);
        for (int i = 0; i < 2; i++) {
            const double a = i == 0 ? step : 0, b = step - a;
            const double slope = (half_squares(&memory, assumed, outward, forward, a, b, &other) -
                                  half_squares(&memory, assumed, outward, forward, -a, -b, &other)) /
                                 (2 * step);
            assert_near(fit.gradient[i], slope, (parallel ? 0.01 : 0.05) * fabs(slope) + 1e-5);
        }
        double slopes[DMI_PULL_RAYS][2], curves[3] = {0};
        for (int i = 0; i < 2; i++) {
            const double a = i == 0 ? step : 0, b = step - a;
            double ahead[DMI_PULL_RAYS], behind[DMI_PULL_RAYS];
            misses_of(&memory, assumed, outward, forward, a, b, ahead);
            misses_of(&memory, assumed, outward, forward, -a, -b, behind);
            for (uint32_t k = 0; k < memory.count; k++) slopes[k][i] = (ahead[k] - behind[k]) / (2 * step);
        }
        for (uint32_t k = 0; k < memory.count; k++) { /* signs of misses cancel out */
            curves[0] += slopes[k][0] * slopes[k][0];
            curves[1] += slopes[k][0] * slopes[k][1];
            curves[2] += slopes[k][1] * slopes[k][1];
        }
        for (int i = 0; i < 3; i++)
            assert_near(fit.hessian[i], curves[i], (parallel ? 0.01 : 0.2) * sqrt(curves[0] * curves[2]));
    }
}

/* As far as it is seen: across the ray, and in perspective at the depth of the grabbed point. */
static void a_miss_is_measured_at_the_depth_of_the_grabbed_point(void** state) {
    (void)state;
    const float grab[3] = {0, 0, 0}, near[3] = {0.3f, 0.4f, 1}, behind[3] = {0.3f, 0.4f, 3},
                at_eye[3] = {0.3f, 0.4f, 2};
    const dm_ray ray = {{0, 0, 2}, {0, 0, -1}};
    dmi_pull memory;
    dmi_pull_begin(&memory, grab, 0.006f);
    memory.projection = DMI_PARALLEL;
    assert_near(dmi_pull_residual(&memory, &ray, near), 0.5, 1e-6);
    assert_near(dmi_pull_residual(&memory, &ray, behind), 0.5, 1e-6);
    memory.projection = DMI_PERSPECTIVE;
    assert_near(dmi_pull_residual(&memory, &ray, near), 1, 1e-6); /* half as far off: it looks twice as large */
    assert_near(dmi_pull_residual(&memory, &ray, behind), 2, 1e-6);
    assert_near(dmi_pull_residual(&memory, &ray, at_eye), 2, 1e-6);
    dmi_random random = dmi_random_make(3, 8);
    for (int i = 0; i < 200; i++) {
        float origin[3], way[3], point[3], gap[3], rest[3];
        test_point(&random, 0.5f, memory.grab);
        test_point(&random, 0.5f, point);
        test_direction(&random, way);
        for (int k = 0; k < 3; k++) origin[k] = -3 * way[k] + test_range(&random, -0.2f, 0.2f);
        const dm_ray any = {dmi_vec3(origin), dmi_vec3(way)};
        double depth = 0, grab_depth = 0, square = 0;
        for (int k = 0; k < 3; k++) {
            gap[k] = point[k] - origin[k], rest[k] = memory.grab[k] - origin[k];
            depth += (double)(gap[k] * way[k]), grab_depth += (double)(rest[k] * way[k]);
        }
        for (int k = 0; k < 3; k++) square += pow((double)gap[k] - depth * (double)way[k], 2);
        for (int parallel = 0; parallel < 2; parallel++) {
            memory.projection = parallel ? DMI_PARALLEL : DMI_PERSPECTIVE;
            assert_near(dmi_pull_residual(&memory, &any, point), sqrt(square) * (parallel ? 1 : grab_depth / depth),
                        1e-5);
        }
    }
}

/* The pull's length is its farthest; its bend the farthest of the recorded places from the straight way to the last. */
static void a_pull_bends_as_far_as_it_leaves_the_straight_way(void** state) {
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        const float grab[3] = {0, 0, 0}, places[4][2] = {{0.1f, 0.02f}, {0.2f, 0.05f}, {0.3f, 0.01f}, {0.4f, 0}};
        dmi_pull memory;
        dmi_pull_begin(&memory, grab, 0.05f);
        memory.projection = DMI_PARALLEL;
        for (int k = 0; k < 4; k++) {
            const dm_ray ray = {{places[k][0], (float)side * places[k][1], 5}, {0, 0, -1}};
            dmi_pull_add(&memory, &ray);
        }
        assert_int_equal(memory.count, 4);
        assert_near(memory.bend, 0.05, 1e-6);
        assert_near(memory.length, 0.4, 1e-6);
        const dm_ray back = {{0.22f, (float)side * 0.05f, 5}, {0, 0, -1}}; /* near a place: only seen */
        dmi_pull_add(&memory, &back);
        assert_int_equal(memory.count, 4);
        assert_near(memory.length, 0.4, 1e-6);
        assert_near3(memory.pointer.way, ((float[3]){0.22f, (float)side * 0.05f, 0}), 1e-6);
        const dm_ray short_one = {{-0.049f, 0, 5}, {0, 0, -1}}, just = {{-0.051f, 0, 5}, {0, 0, -1}};
        dmi_pull_add(&memory, &short_one);
        assert_int_equal(memory.count, 4);
        dmi_pull_add(&memory, &just);
        assert_int_equal(memory.count, 5);
    }
}

/* Full: every second place goes, the last one stays, and the least distance doubles. */
static void a_full_pull_is_thinned(void** state) {
    (void)state;
    const float grab[3] = {0, 0, 0};
    dmi_pull memory;
    dmi_pull_begin(&memory, grab, 0.1f);
    memory.projection = DMI_PARALLEL;
    for (int k = 1; k <= DMI_PULL_RAYS + 1; k++) {
        const dm_ray ray = {{0.11f * (float)k, 0, 5}, {0, 0, -1}};
        dmi_pull_add(&memory, &ray);
        if (k <= DMI_PULL_RAYS) assert_true(memory.count == (uint32_t)k && memory.thinned == 0);
    }
    assert_true(memory.thinned == 1 && memory.count == DMI_PULL_RAYS / 2 + 1);
    assert_near(memory.spacing, 0.2, 1e-7);
    for (uint32_t k = 0; k < memory.count; k++) {
        const float place = 0.11f * (k < DMI_PULL_RAYS / 2 ? 2 * (float)k + 2 : DMI_PULL_RAYS + 1);
        assert_near3(memory.places[k], ((float[3]){place, 0, 0}), 1e-6);
        assert_near(memory.rays[k].origin.x, place, 0);
    }
}

/* A joint that fits follows a pull from rest on without a miss, a slide and a screw too. */
static void a_joint_that_fits_misses_nothing(void** state) {
    (void)state;
    static const dm_joint joints[3] = {
        {.type = DM_JOINT_PRISMATIC, .axis = {0.6f, 0, 0.8f}},
        {.type = DM_JOINT_SCREW, .axis = {0, -1, 0}, .origin = {-0.5f, 0, 0}, .pitch = 0.2f},
        {.type = DM_JOINT_REVOLUTE, .axis = {0, -1, 0}, .origin = {-0.5f, 0, 0}, .pitch = 0.2f}};
    for (int i = 0; i < 3; i++) {
        dmi_pull memory;
        dmi_pull_begin(&memory, handle, 0.02f);
        memory.projection = DMI_PERSPECTIVE;
        float value = 0, last = 0;
        for (int k = 1; k <= 60; k++) {
            float point[3];
            value = 0.01f * (float)k;
            point_on(&joints[i], value, point);
            dm_ray ray = ray_to(point);
            const float length = (float)test_distance(point, eye);
            ray.direction = (dm_vec3){ray.direction.x / length, ray.direction.y / length, ray.direction.z / length};
            const uint32_t count = memory.count, thinned = memory.thinned;
            dmi_pull_add(&memory, &ray);
            if (memory.count != count || memory.thinned != thinned) last = value;
        }
        dmi_pull_fit fit = {.joint = joints[i], .lower = -INFINITY, .upper = INFINITY, .size = 1};
        dmi_pull_fit_shift_directions(&joints[i], handle, fit.outward, fit.forward);
        while (fit.count < memory.count) dmi_pull_fit_step(&fit, &memory);
        assert_near(fit.max_residual, 0, 1e-4);
        assert_near(fit.pointer_value, last, 2e-3);
        if (i == 0) assert_true(fit.hessian[0] == 0 && fit.hessian[2] == 0);
        if (i > 0) assert_true(fit.hessian[0] > 0 && fit.hessian[2] > 0);
        assert_near(fit.gradient[0], 0, 1e-4);
    }
}

/* Where a line is shifted is where misses and prior together have their least: no place around has less. */
static void shift_from(float size, const float before[2]) {
    const dm_joint assumed = moved(&door, 0.06f, -0.05f);
    dmi_grasp grasp = {.size = size, .limit_give = {.length = 4}};
    dmi_pull_begin(&grasp.pull, handle, 0.006f);
    grasp.pull.projection = DMI_PERSPECTIVE;
    for (int k = 1; k <= 120; k++) {
        float point[3];
        point_on(&door, 0.01f * (float)k, point);
        dm_ray ray = ray_to(point);
        const float length = (float)test_distance(point, eye);
        ray.direction = (dm_vec3){ray.direction.x / length, ray.direction.y / length, ray.direction.z / length};
        dmi_grasp_add(&grasp, &ray);
    }
    dmi_joint_hypothesis hypothesis =
        dmi_joint_hypothesis_make(&grasp, &assumed, dmi_joint_log_odds(&assumed), false, dmi_unbounded_range());
    dmi_axis_refiner refiner;
    dmi_axis_refiner_init(&refiner);
    dmi_axis_refiner_add(&refiner, 0, &hypothesis);
    float outward[3], forward[3];
    dmi_pull_fit fit;
    dmi_pull_fit_shift_directions(&assumed, handle, outward, forward);
    float along[3];
    for (int k = 0; k < 3; k++)
        along[k] = dmi_xyz(assumed.origin).v[k] + size * (before[0] * outward[k] + before[1] * forward[k]);
    hypothesis.joint.origin = dmi_vec3(along);
    hypothesis.shift[0] = before[0], hypothesis.shift[1] = before[1];
    const dm_joint begun = hypothesis.joint;
    uint32_t moved_one = DMI_NO_HYPOTHESIS;
    uint32_t steps = 0;
    for (; steps < 100 && moved_one == DMI_NO_HYPOTHESIS; steps++)
        moved_one = dmi_axis_refiner_step(&refiner, &grasp, &hypothesis, 1, 0);
    assert_int_equal(moved_one, 0);
    assert_int_equal(steps, 2 * grasp.pull.count); /* a ray a step, in two passes */
    /* The linear equations of one step: (H + r I) s = -g, r from both deviations. */
    half_squares(&grasp.pull, begun, outward, forward, 0, 0, &fit);
    const double unit = (double)size, expected = 0.01 * (double)grasp.pull.length + 0.0015 * unit,
                 ridge = expected * expected / 0.01;
    const double a = unit * unit * (double)fit.hessian[0] + ridge, b = unit * unit * (double)fit.hessian[1],
                 c = unit * unit * (double)fit.hessian[2] + ridge;
    const double s = (double)hypothesis.shift[0], t = (double)hypothesis.shift[1];
    const double ds = s - (double)before[0], dt = t - (double)before[1];
    assert_near(a * ds + b * dt, -unit * (double)fit.gradient[0] - ridge * (double)before[0], 1e-5);
    assert_near(b * ds + c * dt, -unit * (double)fit.gradient[1] - ridge * (double)before[1], 1e-5);
    assert_true(hypot(s, t) > 0.02);
    for (int k = 0; k < 3; k++) {
        const float origin =
            dmi_xyz(assumed.origin).v[k] + size * (hypothesis.shift[0] * outward[k] + hypothesis.shift[1] * forward[k]);
        assert_near(dmi_xyz(hypothesis.joint.origin).v[k], origin, 1e-6);
    }
    /* Its cost: a normal law of deviation 0.1, odds of an exact line (1.6 and those of the joint), levers. */
    const double odds = 0.85 * log(0.6 / 0.4), cost = 1.6 + odds + (s * s + t * t) / (2 * 0.01) +
                                                      (double)dmi_lever_arm_log_prior(&grasp, &assumed) -
                                                      (double)dmi_lever_arm_log_prior(&grasp, &hypothesis.joint);
    assert_near(hypothesis.shift_cost, cost, 1e-4);
    const double likelihood = (double)dmi_joint_hypothesis_log_likelihood(&grasp, &hypothesis, hypothesis.max_residual);
    assert_near(hypothesis.log_posterior, (double)hypothesis.log_prior + likelihood - cost, 1e-3);
}

static void a_shift_is_the_least_of_misses_and_prior(void** state) {
    (void)state;
    shift_from(1, (float[2]){0, 0});
    shift_from(1.3f, (float[2]){0, 0});
    shift_from(0.9f, (float[2]){0.02f, 0.01f});
}

/* Each third time the active one, if it turns; else the likeliest turn that waits, by its last posterior and 0.05 for
 * each that came before. With too few rays no line is shifted. */
static void lines_are_refined_in_turn(void** state) {
    (void)state;
    enum { MANY = 6, SLIDE = 3 };
    dmi_random random = dmi_random_make(7, 8);
    for (uint32_t best = 2; best <= SLIDE; best++) {
        dmi_grasp grasp = {.size = 1, .limit_give = {.length = 4}};
        dmi_joint_hypothesis list[MANY];
        dmi_axis_refiner refiner;
        float wanted[MANY];
        dmi_pull_begin(&grasp.pull, handle, 0.006f);
        dmi_axis_refiner_init(&refiner);
        for (int k = 1; k <= 3; k++) {
            const dm_ray ray = {{handle[0] + 0.1f * (float)k, handle[1], 5}, {0, 0, -1}};
            dmi_grasp_add(&grasp, &ray);
        }
        assert_int_equal(grasp.pull.count, 3);
        for (uint32_t i = 0; i < MANY; i++) {
            const dm_joint slide = {.type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}};
            const dm_joint joint = i == SLIDE ? slide : moved(&door, 0.1f * (float)i, 0);
            list[i] =
                dmi_joint_hypothesis_make(&grasp, &joint, test_range(&random, -2, 0), false, dmi_unbounded_range());
            list[i].log_posterior = list[i].log_prior - test_range(&random, 0, 0.5f);
            dmi_axis_refiner_add(&refiner, i, &list[i]);
            wanted[i] = i == SLIDE ? -INFINITY : list[i].log_prior;
            if (i != SLIDE) assert_near(refiner.priority[i], wanted[i], 0);
        }
        for (uint32_t round = 0; round < 40; round++) {
            uint32_t next = DMI_NO_HYPOTHESIS;
            for (uint32_t i = 0; i < MANY; i++)
                if (i != best && i != SLIDE && (next == DMI_NO_HYPOTHESIS || wanted[i] > wanted[next])) next = i;
            if (round % 3 == 0 && best != SLIDE) next = best;
            for (uint32_t step = 0; step < grasp.pull.count; step++)
                assert_int_equal(dmi_axis_refiner_step(&refiner, &grasp, list, MANY, best), DMI_NO_HYPOTHESIS);
            wanted[next] = list[next].log_posterior - 0.05f * (float)(round + 1);
            for (uint32_t i = 0; i < MANY; i++)
                if (i != SLIDE) assert_near(refiner.priority[i], wanted[i], 1e-5);
        }
        for (uint32_t i = 0; i < MANY; i++) assert_true(list[i].shift[0] == 0 && list[i].shift_cost == 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_comes_to_where_the_pull_has_it),
        cmocka_unit_test(a_right_line_stays),
        cmocka_unit_test(a_slide_has_no_line),
        cmocka_unit_test(a_pull_is_remembered_evenly),
        cmocka_unit_test(a_corner_is_cut_within_the_circle),
        cmocka_unit_test(a_corner_is_cut_in_perspective_too),
        cmocka_unit_test(slopes_are_those_of_the_misses),
        cmocka_unit_test(a_miss_is_measured_at_the_depth_of_the_grabbed_point),
        cmocka_unit_test(a_pull_bends_as_far_as_it_leaves_the_straight_way),
        cmocka_unit_test(a_full_pull_is_thinned),
        cmocka_unit_test(a_joint_that_fits_misses_nothing),
        cmocka_unit_test(a_shift_is_the_least_of_misses_and_prior),
        cmocka_unit_test(lines_are_refined_in_turn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
