/* Part analysis, the distance grid, and candidates. */
#include "test_analysis.h"

#include <math.h>

#include "base/random.h"
#include "kinematics/analysis/analysis_steps.h"
#include "kinematics/analysis/batched_transform.h"
#include "kinematics/candidates/candidates.h"
#include "kinematics/features/candidate_features.h"
#include "kinematics/features/cheap_features.h"
#include "kinematics/ranking/ranker.h"
#include "math/linear3.h"

static test_shape shape;
static test_analysis lid;
static dmi_candidate candidates[DMI_CANDIDATES_MAX];
static float features[DMI_CANDIDATES_MAX][DMI_FEATURE_COUNT];

/* Analyses a body with a lid, whose hinge lies along its back lower edge. */
static void open_lid(void) {
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){0.8f, 0.4f, 0.5f}, 0);
    test_shape_box(&shape, (const float[]){0, 0.402f, 0}, (const float[]){0.8f, 0.45f, 0.5f}, 1);
    test_analysis_open(&lid, &shape, 3);
}

static void eigenvectors_of_a_known_matrix(void** state) {
    (void)state;
    const double m[3][3] = {{2, 1, 0}, {1, 2, 0}, {0, 0, 5}};
    double values[3];
    float vectors[3][3];
    dmi_eigen3(m, values, vectors);
    assert_float_equal(values[0], 5, 1e-6);
    assert_float_equal(values[1], 3, 1e-6);
    assert_float_equal(values[2], 1, 1e-6);
    assert_float_equal(fabsf(vectors[0][2]), 1, 1e-6f);
    assert_float_equal(fabsf(vectors[1][0] + vectors[1][1]), sqrtf(2), 1e-6f);
}

/* The box of least volume of a rotated box is that box. */
static void min_volume_box_of_a_rotated_box(void** state) {
    (void)state;
    const float axis[3] = {0.48f, 0.6f, 0.64f}, zero[3] = {0, 0, 0};
    float points[8][3], rotated_axes[3][3];
    for (int i = 0; i < 8; i++) {
        const float p[3] = {i & 1 ? 1.5f : -1.5f, i & 2 ? 0.5f : -0.5f, i & 4 ? 0.2f : -0.2f};
        dmi_turn3(axis, zero, cosf(0.7f), sinf(0.7f), p, points[i]);
    }
    for (int i = 0; i < 3; i++) {
        float unit[3] = {0, 0, 0};
        unit[i] = 1;
        dmi_turn3(axis, zero, cosf(0.7f), sinf(0.7f), unit, rotated_axes[i]);
    }
    dmi_box box;
    dmi_min_volume_box((const float(*)[3])points, 8, (const float(*)[3])rotated_axes, 3, &box);
    const float sides[3] = {3, 1, 0.4f};
    for (int i = 0; i < 3; i++) {
        assert_float_equal(box.high[i] - box.low[i], sides[i], 1e-5f);
        assert_float_equal(fabsf(dmi_dot3(box.axes[i], rotated_axes[i])), 1, 1e-5f);
    }
}

/* A cylinder slips along itself by rotations about its axis and translations along it. */
static void slippage_of_a_cylinder(void** state) {
    (void)state;
    enum { N = 400 };
    float points[N][3], normals[N][3];
    dmi_random random = dmi_random_make(4, 4);
    for (int i = 0; i < N; i++) {
        float a = 6.2831853f * dmi_random_unit(&random);
        const float n[3] = {cosf(a), 0, sinf(a)}, p[3] = {2 + 0.1f * n[0], dmi_random_unit(&random), 3 + 0.1f * n[2]};
        dmi_copy3(p, points[i]), dmi_copy3(n, normals[i]);
    }
    dmi_slippage s;
    dmi_slippage_compute((const float(*)[3])points, (const float(*)[3])normals, NULL, N, &s);
    assert_float_equal(fabsf(s.turn_axis[0][1]), 1, 1e-3f);
    assert_float_equal(s.turn_point[0][0], 2, 1e-3f);
    assert_float_equal(s.turn_point[0][2], 3, 1e-3f);
    assert_true(s.turn_residual[0] < 1e-2f && s.turn_residual[1] > 0.1f);
    assert_float_equal(fabsf(s.slide[0][1]), 1, 1e-3f);
    assert_true(s.slide_residual[0] < 1e-2f && s.slide_residual[1] > 0.3f);
}

/* Distances and nearest samples equal brute force to within the grid's resolution. */
static void distance_grid_agrees_with_brute_force(void** state) {
    (void)state;
    enum { N = 300 };
    static float samples[N][3];
    test_env t;
    dmi_arena arena;
    test_env_open(&t, TEST_NEVER);
    dmi_arena_init(&arena, &t.env, 1 << 16);
    dmi_random random = dmi_random_make(8, 8);
    for (int i = 0; i < N; i++)
        for (int k = 0; k < 3; k++) samples[i][k] = 0.2f + 0.6f * dmi_random_unit(&random);
    dmi_distance_grid grid;
    const float low[3] = {0, 0, 0}, high[3] = {1, 1, 0.9f};
    assert_int_equal(
        dmi_distance_grid_make(&arena, (const float(*)[3])samples, N, low, high, DMI_DISTANCE_GRID_CELLS, &grid),
        DM_OK);
    for (int q = 0; q < 500; q++) {
        float point[3], least = INFINITY, found;
        for (int k = 0; k < 3; k++) point[k] = 0.95f * dmi_random_unit(&random);
        point[2] *= 0.9f;
        for (int i = 0; i < N; i++) least = fminf(least, dmi_distance3(point, samples[i]));
        assert_float_equal(dmi_distance_grid_distance(&grid, point), least, 1.8f * grid.cell);
        assert_true(dmi_distance_grid_nearest(&grid, point, &found) < N);
        assert_true(found >= least - 1e-6f && found < least + 2.1f * grid.cell);
        if (least < 0.5f * grid.cell) assert_float_equal(found, least, 1e-6f);
    }
    const float outside[3] = {1.5f, 0.5f, 0.5f};
    assert_true(dmi_distance_grid_distance(&grid, outside) > 0.5f);
    dmi_arena_release(&arena);
    test_env_close(&t);
}

/* Returns the squared distance in cells from a cell to the nearest one that holds a sample. */
static int32_t brute_square(const dmi_distance_grid* grid, const int32_t at[3]) {
    int32_t least = INT32_MAX;
    for (int32_t c = 0; c < grid->size[0] * grid->size[1] * grid->size[2]; c++) {
        if (grid->start[c + 1] == grid->start[c]) continue;
        const int32_t x = c % grid->size[0] - at[0], y = c / grid->size[0] % grid->size[1] - at[1];
        const int32_t z = c / grid->size[0] / grid->size[1] - at[2];
        least = x * x + y * y + z * z < least ? x * x + y * y + z * z : least;
    }
    return least;
}

/* The grid's squares are exact, with few samples and many: also where lines hold none. */
static void distance_transform_is_exact(void** state) {
    (void)state;
    static float samples[400][3];
    test_env t;
    dmi_arena arena;
    test_env_open(&t, TEST_NEVER);
    dmi_arena_init(&arena, &t.env, 1 << 16);
    dmi_random random = dmi_random_make(9, 9);
    for (uint32_t count = 1; count <= 400; count *= 20) {
        for (uint32_t i = 0; i < count; i++)
            for (int k = 0; k < 3; k++) samples[i][k] = dmi_random_unit(&random) * dmi_random_unit(&random);
        dmi_distance_grid grid;
        const float low[3] = {0, 0, 0}, high[3] = {1, 0.5f, 0.7f};
        assert_int_equal(dmi_distance_grid_make(&arena, (const float(*)[3])samples, count, low, high, 41, &grid),
                         DM_OK);
        for (int q = 0; q < 200 && grid.count > 0; q++) {
            int32_t at[3];
            for (int k = 0; k < 3; k++) at[k] = (int32_t)(dmi_random_u32(&random) % (uint32_t)grid.size[k]);
            const int32_t cell = (at[2] * grid.size[1] + at[1]) * grid.size[0] + at[0];
            assert_int_equal(grid.square[cell], brute_square(&grid, at));
        }
    }
    dmi_arena_release(&arena);
    test_env_close(&t);
}

/* A moved point meets a cell that holds a sample exactly where its distance is zero, with vectors and without. */
static void points_meet_samples_where_their_distance_is_zero(void** state) {
    (void)state;
    open_lid();
    const dmi_part_analysis* a = &lid.of_part;
    int met = 0;
    for (int turn = 0; turn < 63; turn++) {
        float axis[3] = {1, 0.1f * (float)(turn % 7), 0}, distance[DMI_POINT_BATCH];
        const float cosine = cosf(0.1f * (float)turn), sine = sinf(0.1f * (float)turn);
        int32_t meets[DMI_POINT_BATCH], meets_slowly[DMI_POINT_BATCH];
        dmi_batched_transform moved;
        dmi_normalize3(axis);
        dmi_batched_transform_revolute(axis, a->centre, (const float(*)[3])a->points, DMI_POINT_BATCH, &moved);
        dmi_batched_transform_distances(&moved, cosine, sine, 0.01f, &a->body_grid, distance);
        dmi_batched_transform_meetings(&moved, cosine, sine, 0.01f, &a->body_grid, meets);
        moved.count = DMI_POINT_BATCH - 1; /* not a whole number of vectors */
        dmi_batched_transform_meetings(&moved, cosine, sine, 0.01f, &a->body_grid, meets_slowly);
        for (uint32_t i = 0; i < moved.count; i++) {
            assert_int_equal(meets[i], distance[i] == 0);
            assert_int_equal(meets[i], meets_slowly[i]);
            met += meets[i];
        }
    }
    assert_true(met > 20 && met < 63 * DMI_POINT_BATCH);
    test_analysis_close(&lid);
}

static float nearest_line(uint32_t count, const float axis[3], const float point[3]) {
    float best = INFINITY;
    for (uint32_t i = 0; i < count; i++) {
        const dmi_candidate* c = &candidates[i];
        if (c->type != DM_JOINT_REVOLUTE || fabsf(dmi_dot3(c->axis, axis)) < 0.9999f) continue;
        best = fminf(best, dmi_line_distance3(point, c->axis, c->origin));
    }
    return best;
}

/* The true hinge of a lid is among the candidates, with a drag and without, and all features are finite. */
/* Nothing near the part: the distance is finite, and no more than a few of its diagonals. */
static void an_empty_neighbourhood_is_a_few_diagonals_away(void** state) {
    (void)state;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){20, 1, 1}, 0);
    test_shape_box(&shape, (const float[]){0, 9, 0}, (const float[]){0.5f, 9.5f, 0.5f}, 1);
    test_analysis_open(&lid, &shape, 3);
    assert_int_equal(lid.of_part.body_grid.count, 0);
    const float distance = dmi_distance_grid_distance(&lid.of_part.body_grid, lid.of_part.centre);
    assert_true(distance > lid.of_part.diagonal && distance < 10 * lid.of_part.diagonal);
    const uint32_t count = dmi_candidates_make(&lid.of_part, NULL, NULL, candidates);
    dmi_candidate_features_make(&lid.of_part, NULL, NULL, NULL, candidates, count, features);
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < DMI_FEATURE_COUNT; k++) assert_true(fabsf(features[i][k]) < 100);
    test_analysis_close(&lid);
}

static void the_hinge_of_a_lid_is_a_candidate(void** state) {
    (void)state;
    open_lid();
    const float axis[3] = {1, 0, 0};
    float hinge[3];
    dmi_frame_point_in(&lid.mesh->frame, (const double[]){0.4, 0.402, 0}, hinge);
    dmi_drag_hint hint = {{0, 0, 0}, {0, 1, 0.15f}};
    dmi_frame_point_in(&lid.mesh->frame, (const double[]){0.4, 0.43, 0.5}, hint.point);
    for (int with = 0; with < 2; with++) {
        uint32_t count = dmi_candidates_make(&lid.of_part, with ? &hint : NULL, NULL, candidates);
        assert_in_range(count, 20, DMI_CANDIDATES_MAX);
        assert_true(nearest_line(count, axis, hinge) < 0.005f);
        dmi_candidate_features_make(&lid.of_part, with ? &hint : NULL, NULL, NULL, candidates, count, features);
        float sum = 0, probability[DMI_CANDIDATES_MAX];
        for (uint32_t i = 0; i < count; i++) {
            for (int k = 0; k < DMI_FEATURE_COUNT; k++) assert_true(isfinite(features[i][k]));
            float arm[3], velocity[3];
            dmi_sub3(hint.point, candidates[i].origin, arm);
            dmi_cross3(candidates[i].axis, arm, velocity);
            if (with && candidates[i].type == DM_JOINT_REVOLUTE) assert_true(dmi_dot3(velocity, hint.vector) > 0);
        }
        dmi_ranker_probabilities(NULL, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])features, count, probability);
        for (uint32_t i = 0; i < count; i++) sum += probability[i];
        assert_float_equal(sum, 1, 1e-4f);
    }
    test_analysis_close(&lid);
}

/* The network's prediction is among the candidates unchanged. */
static void the_networks_joint_is_a_candidate(void** state) {
    (void)state;
    open_lid();
    dmi_prediction prediction = {.type = {1, 0, 0, 0},
                                 .turn_axis = {0.6f, 0.48f, 0.64f},
                                 .slide_axis = {0, 0.6f, 0.8f},
                                 .origin = {0.1f, 0.2f, 0.05f}};
    uint32_t count = dmi_candidates_make(&lid.of_part, NULL, &prediction, candidates);
    assert_true(nearest_line(count, prediction.turn_axis, prediction.origin) < 1e-5f);
    int slides = 0;
    for (uint32_t i = 0; i < count; i++)
        slides += candidates[i].type == DM_JOINT_PRISMATIC &&
                  fabsf(dmi_dot3(candidates[i].axis, prediction.slide_axis)) > 0.99999f;
    assert_int_equal(slides, 1);
    test_analysis_close(&lid);
}

/* Features of the candidate-scoring head: probabilities sum to 1, the best candidate has relative probability 1, low
 * scores are clamped; without scores the features are 0. */
static void candidate_scores_become_probabilities(void** state) {
    (void)state;
    open_lid();
    uint32_t count = dmi_candidates_make(&lid.of_part, NULL, NULL, candidates), best = count / 2;
    float* scores = calloc(count, sizeof *scores);
    for (uint32_t i = 0; i < count; i++) scores[i] = i == best ? 2.0f : i == 0 ? -1e30f : -0.01f * (float)i;
    dmi_candidate_features_make(&lid.of_part, NULL, NULL, scores, candidates, count, features);
    float sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        const float* row = features[i];
        const float below_best = row[DMI_FEATURE_SCORE_BELOW_BEST];
        const float below_type_best = row[DMI_FEATURE_SCORE_BELOW_TYPE_BEST];
        sum += expf(4 * row[DMI_FEATURE_SCORE_LOG_SHARE]);
        assert_int_equal(below_best == 0, i == best);
        assert_true(below_type_best >= below_best && below_best >= -3 && below_type_best >= -3);
        assert_true(row[DMI_FEATURE_SCORE_TYPE_LIKENESS] >= row[DMI_FEATURE_SCORE_LIKENESS]);
        assert_true((row[DMI_FEATURE_SCORE_TYPE_LEAD] > 0) == (candidates[i].type == candidates[best].type));
    }
    assert_float_equal(sum, 1, 1e-3f);
    assert_float_equal(features[best][DMI_FEATURE_SCORE_LIKENESS], 1, 1e-6f);
    dmi_candidate_features_make(&lid.of_part, NULL, NULL, NULL, candidates, count, features);
    for (uint32_t i = 0; i < count; i++)
        for (int k = DMI_FEATURE_SCORE_BELOW_BEST; k <= DMI_FEATURE_SCORE_LOG_SHARE; k++)
            assert_true(features[i][k] == 0);
    free(scores);
    test_analysis_close(&lid);
}

/* A drag keeps candidates that move its point within 60 degrees of it: people pull straight, along an axis of the room
 * or the screen. Those within 37 degrees come first. */
static void a_drag_keeps_what_moves_its_point_along_it(void** state) {
    (void)state;
    open_lid();
    dmi_drag_hint hint = {{0, 0, 0}, {0, 1, 0.3f}};
    dmi_frame_point_in(&lid.mesh->frame, (const double[]){0.4, 0.43, 0.5}, hint.point);
    const uint32_t count = dmi_candidates_make(&lid.of_part, &hint, NULL, candidates);
    float least = 1;
    uint32_t near = 0, far = 0;
    for (uint32_t i = 0; i < count; i++) {
        float velocity[3];
        dmi_candidate_velocity(&candidates[i], hint.point, velocity);
        const float cosine = dmi_dot3(velocity, hint.vector) / (dmi_length3(velocity) * dmi_length3(hint.vector));
        least = fminf(least, cosine);
        if (cosine >= 0.8f + 1e-5f) assert_int_equal(far, 0);
        near += cosine >= 0.8f + 1e-5f, far += cosine < 0.8f - 1e-5f;
    }
    assert_true(near > 0 && far > 0);
    assert_true(least >= 0.5f - 1e-5f && least < 0.6f);
    test_analysis_close(&lid);
}

static const float front[3] = {0, 0, 0.5f}; /* a point of the lid */

/* Returns a candidate's features for a drag of the lid; they stand until the next call. */
static const float* features_of_drag(const float point[3], const float vector[3], const dmi_candidate* candidate) {
    static float row[DMI_FEATURE_COUNT];
    dmi_drag_hint hint;
    dmi_cheap_features cheap;
    dmi_copy3(point, hint.point);
    dmi_copy3(vector, hint.vector);
    dmi_cheap_features_begin(&lid.of_part, &hint, NULL, &cheap);
    dmi_cheap_features_row(&cheap, candidate, row);
    return row;
}

/* A hinge along x, one unit from the grabbed point: a chord lies in its plane and leads inward, half as far as the
 * turn; a pull tilted along the hinge leaves the plane. They end beside the turn's circle. */
static void pulls_are_told_by_plane_and_side(void** state) {
    (void)state;
    open_lid();
    const dmi_candidate hinge = {.type = DM_JOINT_REVOLUTE, .axis = {1, 0, 0}, .origin = {0, 0, -0.5f}};
    const dmi_candidate slide = {.type = DM_JOINT_PRISMATIC, .axis = {0, -1, 0}};
    static const struct {
        float vector[3], out_of_plane, inward, of_slide;
    } rows[] = {{{0, -1, 0}, 0, 0, 0},
                {{0, -0.35867805f, -0.15164665f}, 0, 0.4f, 0.4f},
                {{0.5f, -0.8660254f, 0}, 0.5235988f, 0, 0.5235988f}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const float* row = features_of_drag(front, rows[i].vector, &hinge);
        assert_float_equal(row[DMI_FEATURE_PULL_OUT_OF_PLANE], rows[i].out_of_plane, 1e-4f);
        assert_float_equal(row[DMI_FEATURE_PULL_INWARD], rows[i].inward, 1e-4f);
        row = features_of_drag(front, rows[i].vector, &slide);
        assert_float_equal(row[DMI_FEATURE_PULL_OUT_OF_PLANE], rows[i].of_slide, 1e-3f);
        assert_float_equal(row[DMI_FEATURE_PULL_INWARD], 0, 0);
    }
    test_analysis_close(&lid);
}

/* A drag exactly along an axis of the room stands for every turn whose way it is nearest to; other drags for none. */
static void a_drag_along_the_room_is_the_nearest_axis(void** state) {
    (void)state;
    open_lid();
    const dmi_candidate hinge = {.type = DM_JOINT_REVOLUTE, .axis = {1, 0, 0}};
    const dmi_candidate slide = {.type = DM_JOINT_PRISMATIC, .axis = {0, -0.8574929f, 0.5144958f}};
    static const struct {
        float point[3], vector[3], angle, of_slide;
    } rows[] = {{{0, 0.3f, 0.5f}, {0, -1, 0}, 0, 0.5404195f},                   /* goes along {0, -0.5, 0.3} */
                {{0, 0.3f, 0.5f}, {0, -1, 0.0349208f}, 0.5055129f, 0.5055129f}, /* 2 degrees off the axis */
                {{0, 0.5f, 0.3f}, {0, -1, 0}, 1.0303768f, 0.5404195f},          /* goes along {0, -0.3, 0.5} */
                {{0, 0.3f, 0.5f}, {0, 1, 0}, 2.6011732f, 2.6011732f}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const float* row = features_of_drag(rows[i].point, rows[i].vector, &hinge);
        assert_float_equal(row[DMI_FEATURE_DRAG_ANGLE], rows[i].angle, 1e-3f);
        if (i == 0) assert_float_equal(row[DMI_FEATURE_PULL_INWARD], 0, 0);
        row = features_of_drag(rows[i].point, rows[i].vector, &slide);
        assert_float_equal(row[DMI_FEATURE_DRAG_ANGLE], rows[i].of_slide, 1e-3f);
    }
    test_analysis_close(&lid);
}

/* A hinge along x, one unit from the grabbed point. A pull that ends on the turn's circle stands for the turn; one of
 * the same direction that ends elsewhere, or leaves the turn's plane, does not. */
static void a_pull_to_a_point_of_the_circle_is_a_turn(void** state) {
    (void)state;
    open_lid();
    const dmi_candidate hinge = {.type = DM_JOINT_REVOLUTE, .axis = {1, 0, 0}, .origin = {0, 0, -0.5f}};
    static const struct {
        float vector[3], angle, inward;
    } rows[] = {{{0, -0.7173561f, -0.3032933f}, 0, 0},         /* 0.8 rad of the circle */
                {{0, -0.35867805f, -0.15164665f}, 0.4f, 0.4f}, /* half as far */
                {{0, -0.7173561f, 0.3032933f}, 0.4f, -0.4f},   /* outward */
                {{0.2f, -0.7173561f, -0.3032933f}, 0.46896f, 0.4f}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const float* row = features_of_drag(front, rows[i].vector, &hinge);
        assert_float_equal(row[DMI_FEATURE_DRAG_ANGLE], rows[i].angle, 1e-3f);
        assert_float_equal(row[DMI_FEATURE_PULL_INWARD], rows[i].inward, 1e-3f);
    }
    test_analysis_close(&lid);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eigenvectors_of_a_known_matrix),
        cmocka_unit_test(min_volume_box_of_a_rotated_box),
        cmocka_unit_test(slippage_of_a_cylinder),
        cmocka_unit_test(distance_grid_agrees_with_brute_force),
        cmocka_unit_test(distance_transform_is_exact),
        cmocka_unit_test(points_meet_samples_where_their_distance_is_zero),
        cmocka_unit_test(an_empty_neighbourhood_is_a_few_diagonals_away),
        cmocka_unit_test(the_hinge_of_a_lid_is_a_candidate),
        cmocka_unit_test(the_networks_joint_is_a_candidate),
        cmocka_unit_test(candidate_scores_become_probabilities),
        cmocka_unit_test(a_drag_keeps_what_moves_its_point_along_it),
        cmocka_unit_test(pulls_are_told_by_plane_and_side),
        cmocka_unit_test(a_drag_along_the_room_is_the_nearest_axis),
        cmocka_unit_test(a_pull_to_a_point_of_the_circle_is_a_turn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
