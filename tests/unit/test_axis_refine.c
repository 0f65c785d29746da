/* The pull corrects the axis line of a turn that geometry has a little beside the true one, and only if it is clear. */
#include "test_math.h"

#include <string.h>

#include "motion/drag.h"

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
            assert_near(fit.gradient[i], slope, 0.1 * fabs(slope) + 1e-5);
        }
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
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
