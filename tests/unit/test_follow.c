/* The joint value nearest to a ray or to a hand in space, against a search in small steps and in doubles. */
#include "test_math.h"

#include "drag/follow.h"

enum { CASES = 600 };

static const int32_t turning[] = {DM_JOINT_REVOLUTE, DM_JOINT_SCREW, DM_JOINT_CONTINUOUS};

/* ---- in doubles ---- */

/* Turns the part of a vector that lies across the axis (Rodrigues), and goes along it. */
static void place_of(const dm_joint* joint, const float rest[3], double value, double out[3]) {
    const double a[3] = {(double)joint->axis.x, (double)joint->axis.y, (double)joint->axis.z};
    const double o[3] = {(double)joint->origin.x, (double)joint->origin.y, (double)joint->origin.z};
    const bool slides = joint->type == DM_JOINT_PRISMATIC;
    const double angle = slides ? 0 : value, way = slides                          ? value
                                                   : joint->type == DM_JOINT_SCREW ? (double)joint->pitch * value
                                                                                   : 0;
    double u[3], along = 0;
    for (int i = 0; i < 3; i++) u[i] = (double)rest[i] - o[i], along += u[i] * a[i];
    const double cross[3] = {a[1] * u[2] - a[2] * u[1], a[2] * u[0] - a[0] * u[2], a[0] * u[1] - a[1] * u[0]};
    for (int i = 0; i < 3; i++)
        out[i] = o[i] + u[i] * cos(angle) + cross[i] * sin(angle) + a[i] * along * (1 - cos(angle)) + way * a[i];
}

/* How far the point is from the ray: the distance, or the angle in perspective. */
static double miss(const dm_joint* joint, const float rest[3], const dm_ray* ray, dmi_projection projection,
                   double value) {
    double p[3], along = 0, square = 0;
    const double eye[3] = {(double)ray->origin.x, (double)ray->origin.y, (double)ray->origin.z};
    const double d[3] = {(double)ray->direction.x, (double)ray->direction.y, (double)ray->direction.z};
    place_of(joint, rest, value, p);
    for (int i = 0; i < 3; i++) p[i] -= eye[i], along += p[i] * d[i];
    for (int i = 0; i < 3; i++) square += (p[i] - along * d[i]) * (p[i] - along * d[i]);
    return projection == DMI_PARALLEL ? sqrt(square) : atan2(sqrt(square), along);
}

static double miss_of_hand(const dm_joint* joint, const float rest[3], const float hand[3], double value) {
    double p[3], square = 0;
    place_of(joint, rest, value, p);
    for (int i = 0; i < 3; i++) square += (p[i] - (double)hand[i]) * (p[i] - (double)hand[i]);
    return sqrt(square);
}

typedef struct search {
    const dm_joint* joint;
    const float* rest;
    const dm_ray* ray; /* NULL: a hand in space */
    dmi_projection projection;
    const float* hand;
} search;

static double miss_at(const search* s, double value) {
    return s->ray != NULL ? miss(s->joint, s->rest, s->ray, s->projection, value)
                          : miss_of_hand(s->joint, s->rest, s->hand, value);
}

/* Downhill from `start` in ever smaller steps, to the bottom or a limit. */
static double downhill(const search* s, double start, double lower, double upper) {
    double value = start, here = miss_at(s, value);
    for (double step = 0.01; step > 1e-9; step *= 0.5) {
        for (int sign = -1; sign <= 1; sign += 2) {
            double next = fmin(fmax(value + sign * step, lower), upper), there = miss_at(s, next);
            while (there < here) {
                value = next, here = there;
                next = fmin(fmax(value + sign * step, lower), upper), there = miss_at(s, next);
            }
        }
    }
    return value;
}

static dm_ray ray_to(const float eye[3], const double aim[3]) {
    float way[3];
    for (int i = 0; i < 3; i++) way[i] = (float)(aim[i] - (double)eye[i]);
    const float length = sqrtf(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    return (dm_ray){dmi_vec3(eye), {way[0] / length, way[1] / length, way[2] / length}};
}

/* ---- rays ---- */

/* The pointer is off the circle by up to a fifth of the part, a little ahead of the point. */
static void turns_go_downhill_to_the_nearest_place(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 7);
    int compared = 0, at_limits = 0;
    for (int i = 0; i < CASES; i++) {
        const dm_joint joint = test_joint(&random, turning[i % 3], 0.5f);
        float rest[3], eye[3];
        double aim[3];
        test_point(&random, 0.5f, rest);
        test_direction(&random, eye);
        for (int k = 0; k < 3; k++) eye[k] *= 3;
        const float start = test_range(&random, joint.lower, joint.upper);
        const float from = start - test_range(&random, 0.05f, 0.6f), to = start + test_range(&random, 0.05f, 0.6f);
        place_of(&joint, rest, (double)(start + test_range(&random, -0.4f, 0.4f)), aim);
        for (int k = 0; k < 3; k++) aim[k] += (double)test_range(&random, -0.1f, 0.1f);
        const dm_ray ray = ray_to(eye, aim);
        for (int parallel = 0; parallel < 2; parallel++) {
            const dmi_projection projection = parallel ? DMI_PARALLEL : DMI_PERSPECTIVE;
            const search s = {&joint, rest, &ray, projection, NULL};
            const double wanted = downhill(&s, (double)start, (double)from, (double)to), h = 1e-3;
            const double curved = miss_at(&s, wanted + h) + miss_at(&s, wanted - h) - 2 * miss_at(&s, wanted);
            const bool limit = wanted == (double)from || wanted == (double)to;
            if (!limit && curved < 0.02 * h * h) continue; /* flat: anywhere near is as good */
            const float coarse = dmi_follow_ray_coarse(&joint, rest, &ray, projection, start, from, to);
            const float fine = dmi_follow_ray(&joint, rest, &ray, projection, start, from, to);
            if (fabs((double)coarse - wanted) > 0.05) { /* another valley: not a worse one than any near the start */
                assert_true(miss_at(&s, (double)coarse) < miss_at(&s, (double)start) + 1e-6);
                continue;
            }
            assert_near(coarse, wanted, 1e-3);
            if (limit) assert_near(coarse, wanted, 0);
            if (fabs((double)fine - wanted) < 0.01)
                assert_near(fine, wanted, 5e-5);
            else
                assert_true(miss_at(&s, (double)fine) < miss_at(&s, wanted)); /* passed a fold */
            compared++, at_limits += limit;
        }
    }
    assert_true(compared > CASES && at_limits > CASES / 6);
}

/* The whole line is searched: no place on it is nearer. */
static void slides_find_the_nearest_place_of_all(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(2, 7);
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, DM_JOINT_PRISMATIC, 0.5f);
        float rest[3], eye[3];
        double aim[3];
        test_point(&random, 0.5f, rest);
        test_direction(&random, eye);
        for (int k = 0; k < 3; k++) eye[k] *= 3;
        place_of(&joint, rest, (double)test_range(&random, -0.5f, 0.5f), aim);
        for (int k = 0; k < 3; k++) aim[k] += (double)test_range(&random, -0.3f, 0.3f);
        const dm_ray ray = ray_to(eye, aim);
        const float lower = i % 2 ? -INFINITY : -0.3f, upper = i % 2 ? INFINITY : 0.3f;
        for (int parallel = 0; parallel < 2; parallel++) {
            const dmi_projection projection = parallel ? DMI_PARALLEL : DMI_PERSPECTIVE;
            const float found = dmi_follow_ray(&joint, rest, &ray, projection, 0.1f, lower, upper);
            const double here = miss(&joint, rest, &ray, projection, (double)found);
            assert_true(found >= lower && found <= upper);
            for (int k = -300; k <= 300; k++) {
                const double other = i % 2 ? (double)found + 0.01 * k : 0.001 * k;
                assert_true(miss(&joint, rest, &ray, projection, other) > here - 1e-6);
            }
        }
    }
}

/* A pointer beyond the vanishing point of a slide's line asks for the limit that lies that way; without one, and along
 * the line itself, for nothing. */
static void slides_seen_end_on_stay_or_go_to_the_limit(void** state) {
    (void)state;
    for (int sign = -1; sign <= 1; sign += 2) {
        const float s = (float)sign, rest[3] = {0, 0, 0};
        const dm_joint slide = {.type = DM_JOINT_PRISMATIC, .axis = {s, 0, 0}};
        const dm_ray beyond = {{0, 0, 2}, {0.8f, 0, 0.6f}}, along = {{-2, 0, 0}, {1, 0, 0}},
                     across = {{0, 0, 2}, {0, 0, 1}};
        const dmi_projection seen = DMI_PERSPECTIVE;
        assert_near(dmi_follow_ray(&slide, rest, &beyond, seen, 0.1f, -0.5f, 0.7f), sign > 0 ? 0.7f : -0.5f, 0);
        assert_near(dmi_follow_ray(&slide, rest, &beyond, seen, 0.1f, -INFINITY, 0.7f), sign > 0 ? 0.7f : 0.1f, 0);
        assert_near(dmi_follow_ray(&slide, rest, &beyond, seen, 0.1f, -0.5f, INFINITY), sign > 0 ? 0.1f : -0.5f, 0);
        assert_near(dmi_follow_ray(&slide, rest, &across, seen, 0.1f, -0.5f, 0.7f), 0.1f, 0);
        assert_near(dmi_follow_ray(&slide, rest, &along, seen, 0.1f, -0.5f, 0.7f), 0.1f, 0);
        assert_near(dmi_follow_ray(&slide, rest, &along, DMI_PARALLEL, 0.1f, -0.5f, 0.7f), 0.1f, 0);
        assert_near(dmi_follow_ray(&slide, rest, &along, DMI_PARALLEL, 0.9f, -0.5f, 0.7f), 0.7f, 0);
    }
}

/* A pointer that has left the point by a fifth of its arm, with a place elsewhere in the range right under it, has
 * that place or one as near; where there is none, the point stays on its side. */
static void a_place_at_the_pointer_is_found_in_the_whole_range(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(3, 7);
    int found = 0, stayed = 0;
    for (int i = 0; i < 6 * CASES; i++) {
        dm_joint joint = test_joint(&random, i % 2 ? DM_JOINT_REVOLUTE : DM_JOINT_CONTINUOUS, 0.3f);
        float rest[3], eye[3], velocity[3], none[3] = {0, 0, 0};
        double aim[3];
        test_point(&random, 0.5f, rest);
        test_direction(&random, eye);
        for (int k = 0; k < 3; k++) eye[k] *= 3;
        dmi_joint_velocity(&joint, 0, rest, velocity);
        const double arm = test_distance(velocity, none);
        const float start = test_range(&random, -0.5f, 0.5f), from = start - test_range(&random, 1, 3.1f),
                    to = start + test_range(&random, 1, 3.1f);
        place_of(&joint, rest, (double)test_range(&random, from, to), aim);
        for (int k = 0; k < 3; k++) aim[k] += i % 4 ? 0 : (double)test_range(&random, -0.2f, 0.2f);
        const dm_ray ray = ray_to(eye, aim);
        const search s = {&joint, rest, &ray, DMI_PARALLEL, NULL};
        const double coarse = (double)dmi_follow_ray_coarse(&joint, rest, &ray, DMI_PARALLEL, start, from, to);
        const double value = (double)dmi_follow_ray(&joint, rest, &ray, DMI_PARALLEL, start, from, to);
        const double near = miss_at(&s, coarse);
        double least = INFINITY;
        for (int k = 0; k <= 400; k++)
            least = fmin(least, miss_at(&s, (double)from + 0.0025 * k * (double)(to - from)));
        assert_true(miss_at(&s, value) <= near + 1e-4);
        if (near > 0.21 * arm && least < 0.02 * arm) assert_true(miss_at(&s, value) < 0.4 * near + 1e-4), found++;
        const bool jumped = fabs(value - coarse) > 1.3; /* farther than past a fold */
        assert_true(!jumped || (near > 0.19 * arm && miss_at(&s, value) < 0.41 * near));
        stayed += near > 0.21 * arm && least > 0.42 * near;
    }
    assert_true(found > 100 && stayed > 20);
}

/* A wheel of radius 1/2 seen at a slant: its near and far branch meet in folds. The part passes a fold with a pointer
 * that has come round it on the other branch, but not to more than 1.2 rad away, nor where the wheel is seen less
 * slanted than by a sine of 0.8, nor for a hair's miss. */
static void a_pointer_that_comes_back_on_the_other_branch_is_followed(void** state) {
    (void)state;
    const dm_joint wheel = {.type = DM_JOINT_CONTINUOUS, .axis = {1, 0, 0}, .origin = {1, 0.5f, 0}};
    const float slants[] = {0.78f, 0.82f, 0.97f, 0.99f, 0.999f};
    int passed = 0, kept = 0;
    for (size_t i = 0; i < 5; i++) {
        const float sine = slants[i], flat = sqrtf(1 - sine * sine);
        for (int turn = 0; turn < 8; turn++) { /* of the sight about the axis; the folds turn along */
            const float at = 0.7f * (float)turn, fold = at + 1.57079633f;
            const float sight[3] = {flat, sine * cosf(at), sine * sinf(at)}, rest[3] = {1.2f, 1, 0};
            for (int k = 1; k <= 14; k++) {
                for (int side = -1; side <= 1; side += 2) {
                    const float off = 0.05f * (float)k, start = fold - (float)side * off,
                                truth = fold + (float)side * off;
                    double aim[3];
                    float from[3];
                    place_of(&wheel, rest, (double)truth, aim);
                    for (int n = 0; n < 3; n++) from[n] = (float)aim[n] - 3 * sight[n];
                    const dm_ray ray = {dmi_vec3(from), dmi_vec3(sight)};
                    const search s = {&wheel, rest, &ray, DMI_PARALLEL, NULL};
                    const double near = downhill(&s, (double)start, (double)start - 3, (double)start + 3);
                    const float fine = dmi_follow_ray(&wheel, rest, &ray, DMI_PARALLEL, start, start - 3, start + 3);
                    const double here = miss_at(&s, near), gap = 2 * fabs((double)fold - near);
                    const bool is_mirrored = (near - (double)fold) * side < -0.01;
                    if (!is_mirrored || here > 0.19 * 0.5) continue;
                    if (sine > 0.8f && gap < 1.18 && here > 0.011 * 0.5)
                        assert_near(fine, truth, 2e-3), passed++;
                    else if (sine < 0.8f || gap > 1.22 || here < 0.009 * 0.5)
                        assert_near(fine, near, 2e-3), kept++;
                }
            }
        }
    }
    assert_true(passed > 100 && kept > 20);
}

static void a_turn_goes_at_most_half_way_round(void** state) {
    (void)state;
    const dm_joint wheel = {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, 1}};
    const float rest[3] = {1, 0, 0};
    for (int k = -15; k <= 15; k++) {
        const float angle = 0.2f * (float)k, start = 20;
        const dm_ray ray = {{cosf(start + angle), sinf(start + angle), 5}, {0, 0, -1}};
        assert_near(dmi_follow_ray(&wheel, rest, &ray, DMI_PARALLEL, start, -INFINITY, INFINITY), start + angle, 2e-5);
    }
}

static void a_line_of_sight_goes_to_the_point(void** state) {
    (void)state;
    const float point[3] = {1, 2, 3};
    const dm_ray ray = {{1, 2, 0}, {0.6f, 0.8f, 0}};
    float sight[3], distance;
    dmi_line_of_sight(point, &ray, DMI_PERSPECTIVE, sight, &distance);
    assert_near3(sight, ((float[3]){0, 0, 1}), 1e-7);
    assert_near(distance, 3, 1e-6);
    dmi_line_of_sight(point, &ray, DMI_PARALLEL, sight, &distance);
    assert_near3(sight, dmi_xyz(ray.direction).v, 0);
    assert_true(distance == INFINITY);
}

/* Below a sine of 0.15 between its motion and the sight; what doesn't move is not seen end on. */
static void a_motion_along_the_sight_is_seen_end_on(void** state) {
    (void)state;
    const dm_joint slide = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}},
                   door = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}}, fixed = {.type = DM_JOINT_FIXED};
    const float rest[3] = {0, -2, 0}, on_axis[3] = {0, 0, 1};
    for (int sign = -1; sign <= 1; sign += 2) {
        for (int far = 0; far < 2; far++) {
            const float sine = far ? 0.151f : 0.149f;
            const float sight[3] = {(float)sign * sqrtf(1 - sine * sine), 0.6f * sine, -0.8f * sine};
            assert_int_equal(dmi_is_seen_end_on(&slide, rest, sight), !far);
            assert_int_equal(dmi_is_seen_end_on(&door, rest, sight), !far);
            assert_false(dmi_is_seen_end_on(&door, on_axis, sight));
            assert_false(dmi_is_seen_end_on(&fixed, rest, sight));
        }
    }
}

/* ---- hands in space ---- */

static void a_hand_is_met_where_the_point_is_nearest(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(4, 7);
    const int32_t types[] = {DM_JOINT_REVOLUTE, DM_JOINT_SCREW, DM_JOINT_SCREW, DM_JOINT_PRISMATIC,
                             DM_JOINT_CONTINUOUS};
    int compared = 0;
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, types[i % 5], 0.5f);
        if (joint.type == DM_JOINT_SCREW) joint.pitch *= 2;
        float rest[3], hand[3], velocity[3], none[3] = {0, 0, 0};
        double aim[3];
        test_point(&random, 0.5f, rest);
        const bool slides = joint.type == DM_JOINT_PRISMATIC;
        const float start = slides ? 0 : test_range(&random, -9, 9);
        place_of(&joint, rest, (double)(start + test_range(&random, -1.2f, 1.2f)), aim);
        for (int k = 0; k < 3; k++) hand[k] = (float)aim[k] + test_range(&random, -0.3f, 0.3f);
        const search s = {&joint, rest, NULL, DMI_PARALLEL, hand};
        const double wanted = downhill(&s, (double)start, -100, 100);
        dmi_joint_velocity(&joint, 0, rest, velocity);
        const double h = 1e-3, curved = pow(miss_at(&s, wanted + h), 2) + pow(miss_at(&s, wanted - h), 2) -
                                        2 * pow(miss_at(&s, wanted), 2);
        if (test_distance(velocity, none) < 0.05 || curved < 0.05 * h * h) continue; /* hardly anything to tell by */
        const float found = dmi_follow_point(&joint, rest, hand, start, -100, 100);
        if (fabs((double)found - wanted) > 2) continue; /* from the far side: either way round */
        assert_near(found, wanted, 2e-5);
        assert_near(dmi_follow_point(&joint, rest, hand, start, -100, found - 0.1f), found - 0.1f, 0);
        assert_near(dmi_follow_point(&joint, rest, hand, start, found + 0.1f, 100), found + 0.1f, 0);
        compared++;
    }
    assert_true(compared > CASES / 2);
}

static void a_hand_on_the_axis_asks_for_nothing(void** state) {
    (void)state;
    const dm_joint door = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}}, fixed = {.type = DM_JOINT_FIXED};
    const float rest[3] = {1, 0, 0}, on_axis[3] = {0, 0, 0.5f}, beside[3] = {0, 0.5f, 0}, wild[3] = {NAN, 0, 0};
    assert_near(dmi_follow_point(&door, rest, on_axis, 0.3f, -1, 2), 0.3f, 0);
    assert_near(dmi_follow_point(&door, on_axis, rest, 0.3f, -1, 2), 0.3f, 0);
    assert_near(dmi_follow_point(&door, rest, wild, 0.3f, -1, 2), 0.3f, 0);
    assert_near(dmi_follow_point(&fixed, rest, beside, 0.3f, -1, 2), 0.3f, 0);
    assert_near(dmi_follow_point(&door, rest, beside, 0.3f, -1, 2), 1.57079633, 1e-6);
    assert_near(dmi_follow_point(&door, rest, beside, 12.3f, 0, 20), 1.57079633 + 2 * 6.28318531, 3e-6);
    assert_near(dmi_follow_point(&door, rest, beside, -5, -20, 0), 1.57079633 - 6.28318531, 3e-6);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(turns_go_downhill_to_the_nearest_place),
        cmocka_unit_test(slides_find_the_nearest_place_of_all),
        cmocka_unit_test(slides_seen_end_on_stay_or_go_to_the_limit),
        cmocka_unit_test(a_place_at_the_pointer_is_found_in_the_whole_range),
        cmocka_unit_test(a_pointer_that_comes_back_on_the_other_branch_is_followed),
        cmocka_unit_test(a_turn_goes_at_most_half_way_round),
        cmocka_unit_test(a_line_of_sight_goes_to_the_point),
        cmocka_unit_test(a_motion_along_the_sight_is_seen_end_on),
        cmocka_unit_test(a_hand_is_met_where_the_point_is_nearest),
        cmocka_unit_test(a_hand_on_the_axis_asks_for_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
