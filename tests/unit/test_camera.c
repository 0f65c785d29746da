/* Camera rays: corners and middle of the picture, both projections, right- and left-handed hosts, bad cameras. */
#include "test_env.h"

#include <float.h>
#include <math.h>

#include "pick/pick.h"

static dm_camera camera(void) {
    return (dm_camera){.struct_size = sizeof(dm_camera),
                       .fov_y = 1.57079632679f, /* the picture is 2 high at distance 1 */
                       .eye = {1, 2, 3},
                       .forward = {0, 0, -5},
                       .up = {0, 0.5f, 0},
                       .viewport_width = 400,
                       .viewport_height = 200,
                       .ortho_height = 3};
}

static void expect_vec(dm_vec3 v, float x, float y, float z) {
    assert_float_equal(v.x, x, 1e-6);
    assert_float_equal(v.y, y, 1e-6);
    assert_float_equal(v.z, z, 1e-6);
}

static void expect_direction(dm_vec3 v, float x, float y, float z) {
    float length = sqrtf(x * x + y * y + z * z);
    expect_vec(v, x / length, y / length, z / length);
}

static void perspective_rays_leave_the_eye(void** state) {
    (void)state;
    dm_camera c = camera();
    dm_ray ray;
    assert_true(dmi_camera_ray(&c, 1, 200, 100, &ray));
    expect_vec(ray.origin, 1, 2, 3);
    expect_direction(ray.direction, 0, 0, -1);
    assert_true(dmi_camera_ray(&c, 1, 0, 0, &ray)); /* top left */
    expect_vec(ray.origin, 1, 2, 3);
    expect_direction(ray.direction, -2, 1, -1);
    assert_true(dmi_camera_ray(&c, 1, 400, 200, &ray)); /* bottom right */
    expect_direction(ray.direction, 2, -1, -1);
    assert_true(dmi_camera_ray(&c, 1, 500, 100, &ray)); /* beside the picture: still a ray */
    expect_direction(ray.direction, 3, 0, -1);
}

static void orthographic_rays_are_parallel(void** state) {
    (void)state;
    dm_camera c = camera();
    c.fov_y = 0;
    dm_ray ray;
    assert_true(dmi_camera_ray(&c, 1, 0, 0, &ray));
    expect_vec(ray.origin, 1 - 3, 2 + 1.5f, 3);
    expect_direction(ray.direction, 0, 0, -1);
    assert_true(dmi_camera_ray(&c, 1, 300, 150, &ray));
    expect_vec(ray.origin, 1 + 1.5f, 2 - 0.75f, 3);
    expect_direction(ray.direction, 0, 0, -1);
}

/* What is right of the middle lies to the right for the player, whatever the handedness of the frame. */
static void right_is_right_in_every_host(void** state) {
    (void)state;
    static const struct {
        float handedness;
        dm_vec3 forward, up, right;
    } hosts[] = {
        {1, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}}, /* glTF */
        {-1, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, /* Unity */
        {-1, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, /* Unreal */
        {1, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}},  /* Blender */
    };
    for (int i = 0; i < 4; i++) {
        dm_camera c = camera();
        c.forward = hosts[i].forward;
        c.up = hosts[i].up;
        dm_ray ray;
        assert_true(dmi_camera_ray(&c, hosts[i].handedness, 300, 50, &ray)); /* 1 to the right, 1/2 up, 1 ahead */
        const dm_vec3 f = hosts[i].forward, u = hosts[i].up, r = hosts[i].right;
        expect_direction(ray.direction, f.x + r.x + 0.5f * u.x, f.y + r.y + 0.5f * u.y, f.z + r.z + 0.5f * u.z);
    }
}

static void up_need_not_be_square_to_forward(void** state) {
    (void)state;
    dm_camera straight = camera(), leaning = camera();
    leaning.up = (dm_vec3){0, 3, -40};
    dm_ray a, b;
    for (float x = 0; x <= 400; x += 100) {
        assert_true(dmi_camera_ray(&straight, 1, x, 30, &a));
        assert_true(dmi_camera_ray(&leaning, 1, x, 30, &b));
        expect_vec(b.direction, a.direction.x, a.direction.y, a.direction.z);
        const dm_vec3 d = b.direction;
        assert_float_equal(d.x * d.x + d.y * d.y + d.z * d.z, 1, 1e-6);
    }
}

static void expect_no_ray(dm_camera c) {
    dm_ray ray = {{7, 7, 7}, {7, 7, 7}};
    assert_false(dmi_camera_ray(&c, 1, 10, 10, &ray));
    expect_vec(ray.origin, 7, 7, 7);
    expect_vec(ray.direction, 7, 7, 7);
}

static void cameras_without_a_picture_give_no_ray(void** state) {
    (void)state;
    const float bad_sizes[] = {0, -1, NAN, INFINITY};
    for (int i = 0; i < 4; i++) {
        dm_camera c = camera();
        c.viewport_width = bad_sizes[i];
        expect_no_ray(c);
        c = camera();
        c.viewport_height = bad_sizes[i];
        expect_no_ray(c);
        c = camera();
        c.fov_y = 0;
        c.ortho_height = bad_sizes[i];
        expect_no_ray(c);
    }
    const float bad_angles[] = {-1, 3.1416f, NAN, INFINITY};
    for (int i = 0; i < 4; i++) {
        dm_camera c = camera();
        c.fov_y = bad_angles[i];
        expect_no_ray(c);
    }
    const dm_vec3 bad_vectors[] = {{0, 0, 0}, {NAN, 0, 1}, {0, INFINITY, 0}};
    for (int i = 0; i < 3; i++) {
        dm_camera c = camera();
        c.forward = bad_vectors[i];
        expect_no_ray(c);
        c = camera();
        c.up = bad_vectors[i];
        expect_no_ray(c);
        c = camera();
        if (i > 0)
            c.eye = bad_vectors[i];
        else
            c.up = (dm_vec3){0, 0, 9}; /* parallel to forward */
        expect_no_ray(c);
    }
    dm_camera c = camera();
    dm_ray ray;
    assert_false(dmi_camera_ray(&c, 1, NAN, 0, &ray));
    assert_false(dmi_camera_ray(&c, 1, 0, INFINITY, &ray));
}

static void tiny_and_huge_vectors_are_fine(void** state) {
    (void)state;
    dm_camera c = camera();
    c.forward = (dm_vec3){0, 0, -1e-30f};
    c.up = (dm_vec3){0, FLT_MAX, 0};
    dm_ray ray;
    assert_true(dmi_camera_ray(&c, 1, 0, 0, &ray));
    expect_direction(ray.direction, -2, 1, -1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(perspective_rays_leave_the_eye),        cmocka_unit_test(orthographic_rays_are_parallel),
        cmocka_unit_test(right_is_right_in_every_host),          cmocka_unit_test(up_need_not_be_square_to_forward),
        cmocka_unit_test(cameras_without_a_picture_give_no_ray), cmocka_unit_test(tiny_and_huge_vectors_are_fine),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
