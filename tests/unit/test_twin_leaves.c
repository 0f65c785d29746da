/* Two leaves that touch only each other: when they are taken for twins, and where they are hung. */
#include "test_analysis.h"

#include <math.h>

#include "kinematics/inference/joint_inference.h"
#include "kinematics/ranking/twin_leaves.h"
#include "test_world.h"

static test_shape shape;
static test_analysis a;

#define WIDE 0.8f
#define HIGH 1.5f
#define THICK 0.06f

/* Part 1 from x = 0 to WIDE, its twin beside it. */
static void make_leaves(void) {
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){WIDE, HIGH, THICK}, 1);
    test_shape_box(&shape, (const float[]){WIDE + 0.005f, 0, 0}, (const float[]){2 * WIDE, HIGH, THICK}, 0);
}

static void a_mirror_image_beside_a_part_is_its_twin(void** state) {
    (void)state;
    make_leaves();
    test_analysis_open(&a, &shape, 3);
    assert_true(a.of_part.has_twin);
    assert_true(a.of_part.twin_way[0] > 0.99f);
    test_analysis_close(&a);
}

static void free_each_way(dmi_part_analysis* part) {
    for (int k = 0; k < 3; k++) part->clearance[k][0] = part->clearance[k][1] = DMI_MOST_CLEARANCE;
}

static void a_frame_is_no_twin(void** state) {
    (void)state;
    make_leaves();
    test_shape_box(&shape, (const float[]){-0.1f, 0, -0.05f}, (const float[]){-0.01f, HIGH, 0.1f}, 0);
    test_shape_box(&shape, (const float[]){2 * WIDE + 0.01f, 0, -0.05f}, (const float[]){2 * WIDE + 0.1f, HIGH, 0.1f},
                   0);
    test_analysis_open(&a, &shape, 3);
    assert_false(a.of_part.has_twin);
    test_analysis_close(&a);
}

/* A frame round both leaves, or round a single leaf and a panel of another shape beside it. */
static void make_window(float panel_high, float panel_thick) {
    shape.vertex_count = shape.face_count = 0;
    const float end = 2 * WIDE;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){WIDE, HIGH, THICK}, 1);
    test_shape_box(&shape, (const float[]){WIDE + 0.005f, 0, 0}, (const float[]){end, panel_high, panel_thick}, 0);
    test_shape_box(&shape, (const float[]){-0.1f, -0.1f, -0.05f}, (const float[]){-0.01f, HIGH + 0.1f, 0.1f}, 0);
    test_shape_box(&shape, (const float[]){end + 0.01f, -0.1f, -0.05f}, (const float[]){end + 0.1f, HIGH + 0.1f, 0.1f},
                   0);
    test_shape_box(&shape, (const float[]){-0.01f, -0.1f, -0.05f}, (const float[]){end + 0.01f, -0.01f, 0.1f}, 0);
    test_shape_box(&shape, (const float[]){-0.01f, HIGH + 0.01f, -0.05f},
                   (const float[]){end + 0.01f, HIGH + 0.1f, 0.1f}, 0);
}

static void a_leaf_in_the_same_frame_is_found(void** state) {
    (void)state;
    make_window(HIGH, THICK);
    test_analysis_open(&a, &shape, 3);
    assert_false(a.of_part.has_twin);
    assert_float_equal(a.of_part.leaf_side[0], 0, 0); /* the longest side stands upright */
    assert_float_equal(a.of_part.leaf_side[1] * a.of_part.box.axes[1][0], 1, 1e-3f);
    test_analysis_close(&a);
    make_window(HIGH / 2, 8 * THICK);
    test_analysis_open(&a, &shape, 3);
    assert_float_equal(a.of_part.leaf_side[1], 0, 0);
    test_analysis_close(&a);
    make_leaves(); /* without a frame */
    test_analysis_open(&a, &shape, 3);
    assert_float_equal(a.of_part.leaf_side[1], 0, 0);
    test_analysis_close(&a);
}

static void a_turn_at_the_seam_of_a_frame_is_less_likely(void** state) {
    (void)state;
    make_window(HIGH, THICK);
    test_analysis_open(&a, &shape, 3);
    float probability[3] = {1, 1, 1};
    dmi_candidate turns[3] = {{.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}},
                              {.type = DM_JOINT_REVOLUTE, .axis = {0, -1, 0}},
                              {.type = DM_JOINT_REVOLUTE, .axis = {1, 0, 0}}};
    dmi_frame_point_in(&a.mesh->frame, (const double[]){WIDE, 0, 0}, turns[0].origin); /* at the seam */
    dmi_frame_point_in(&a.mesh->frame, (const double[]){0, 0, 0}, turns[1].origin);
    dmi_frame_point_in(&a.mesh->frame, (const double[]){WIDE, 0, 0}, turns[2].origin); /* across it */
    dmi_leaves_weigh(&a.of_part, turns, 3, probability);
    assert_float_equal(logf(probability[0] / probability[1]), -1, 1e-4f);
    assert_float_equal(probability[1], probability[2], 1e-6f);
    test_analysis_close(&a);
}

static void a_wall_behind_or_a_wider_neighbour_is_no_twin(void** state) {
    (void)state;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){WIDE, HIGH, THICK}, 1);
    test_shape_box(&shape, (const float[]){-1, -1, -0.1f}, (const float[]){2, 2, -0.01f}, 0);
    test_analysis_open(&a, &shape, 3);
    assert_false(a.of_part.has_twin);
    test_analysis_close(&a);
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){WIDE, HIGH, THICK}, 1);
    test_shape_box(&shape, (const float[]){WIDE, 0, 0}, (const float[]){2 * WIDE, HIGH, 8 * THICK}, 0);
    test_analysis_open(&a, &shape, 3);
    assert_false(a.of_part.has_twin);
    test_analysis_close(&a);
}

/* The turns that are added lie on the far side, and each is there once. */
static void far_edges_are_candidates(void** state) {
    (void)state;
    dmi_candidate candidates[16];
    make_leaves();
    test_analysis_open(&a, &shape, 3);
    const uint32_t count = dmi_twin_add_candidates(&a.of_part, NULL, candidates, 0);
    uint32_t turns = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (candidates[i].type != DM_JOINT_REVOLUTE) continue;
        const double foot[3] = {0, 0, 0.5 * THICK};
        float on_side[3];
        dmi_frame_point_in(&a.mesh->frame, foot, on_side);
        assert_true(fabsf(candidates[i].axis[1]) > 0.999f);
        assert_float_equal(candidates[i].origin[0], on_side[0], 1e-3f);
        turns++;
    }
    assert_int_equal(turns, 3);
    assert_int_equal(dmi_twin_add_candidates(&a.of_part, NULL, candidates, count), count);
    test_analysis_close(&a);
}

/* Whichever side of the box leads to the twin: turns about the edges and the middle line of the side away from it, of
 * its longer direction, and one slide along them; with a drag, what it allows of these. */
static void each_side_has_three_lines(void** state) {
    (void)state;
    for (int i = 0; i < 6; i++) {
        const int across = i / 2, along = across == 0 ? 1 : 0, thin = 3 - across - along;
        const float sign = i % 2 ? -1.0f : 1.0f;
        dmi_part_analysis* part = &a.of_part;
        dmi_candidate candidates[8];
        memset(part, 0, sizeof *part);
        part->has_twin = true;
        part->twin_way[across] = sign, part->twin_way[along] = 0.3f, part->twin_way[thin] = -0.2f;
        for (int k = 0; k < 3; k++) {
            part->box.axes[k][k] = 1;
            part->box.low[k] = -0.1f * (float)(k + 1), part->box.high[k] = 0.5f + 0.1f * (float)k;
        }
        const uint32_t count = dmi_twin_add_candidates(part, NULL, candidates, 0);
        uint32_t depths = 0, slides = 0;
        for (uint32_t c = 0; c < count; c++) {
            assert_float_equal(fabsf(candidates[c].axis[along]), 1, 0);
            slides += candidates[c].type == DM_JOINT_PRISMATIC;
            if (candidates[c].type == DM_JOINT_PRISMATIC) continue;
            assert_float_equal(candidates[c].origin[across], sign > 0 ? part->box.low[across] : part->box.high[across],
                               1e-6f);
            const float deep =
                (candidates[c].origin[thin] - part->box.low[thin]) / (part->box.high[thin] - part->box.low[thin]);
            assert_float_equal(2 * deep, roundf(2 * deep), 1e-5f);
            depths |= 1u << (int)roundf(2 * deep);
        }
        assert_int_equal(count, 4);
        assert_int_equal(slides, 1);
        assert_int_equal(depths, 7);
        /* A pull along the lines moves none of the turns; one across them does not slide. */
        dmi_drag_hint hint = {.point = {0.2f, 0.2f, 0.2f}};
        hint.vector[along] = 1;
        const uint32_t slid = dmi_twin_add_candidates(part, &hint, candidates, 0);
        for (uint32_t c = 0; c < slid; c++) assert_int_equal(candidates[c].type, DM_JOINT_PRISMATIC);
        assert_int_equal(slid, 1);
        hint.vector[along] = 0, hint.vector[thin] = 1;
        const uint32_t turned = dmi_twin_add_candidates(part, &hint, candidates, 0);
        for (uint32_t c = 0; c < turned; c++) assert_int_equal(candidates[c].type, DM_JOINT_REVOLUTE);
        assert_true(turned > 0);
        part->has_twin = false;
        assert_int_equal(dmi_twin_add_candidates(part, NULL, candidates, 3), 3);
    }
}

/* Equal turns at the seam and at the far side: the far one gains, and all still share a probability of 1. */
static void the_far_side_is_likelier_than_the_seam(void** state) {
    (void)state;
    make_leaves();
    for (int with_twin = 0; with_twin < 2; with_twin++) {
        test_analysis_open(&a, &shape, 3);
        a.of_part.has_twin = with_twin;
        const float up[3] = {0, 1, 0}, along[3] = {1, 0, 0};
        const dmi_candidate candidates[] = {
            test_candidate(a.mesh, DM_JOINT_REVOLUTE, up, (const double[]){0, 0, 0}),
            test_candidate(a.mesh, DM_JOINT_REVOLUTE, up, (const double[]){WIDE, 0, 0}),
            test_candidate(a.mesh, DM_JOINT_PRISMATIC, along, (const double[]){0, 0, 0}),
        };
        float probability[] = {0.01f, 0.89f, 0.1f};
        dmi_leaves_weigh(&a.of_part, candidates, 3, probability);
        assert_float_equal(probability[0] + probability[1] + probability[2], 1, 1e-5f);
        if (with_twin)
            assert_true(probability[0] > 0.8f && probability[1] < 0.02f);
        else
            assert_float_equal(probability[1], 0.89f, 0);
        test_analysis_close(&a);
    }
}

/* How much likelier than a slide a turn becomes, about an axis along side `along` of the box at `place` of side
 * `across`, -1 and 1 at its ends. */
static float gain(dmi_part_analysis* part, int along, int across, float place) {
    const dmi_box* box = &part->box;
    const float middle = 0.5f * (box->low[across] + box->high[across]), half = box->high[across] - middle;
    dmi_candidate candidates[2] = {{.type = DM_JOINT_REVOLUTE}, {.type = DM_JOINT_PRISMATIC}};
    float probability[2] = {0.5f, 0.5f};
    for (int k = 0; k < 3; k++) {
        candidates[0].axis[k] = box->axes[along][k];
        candidates[0].origin[k] = (middle + place * half) * box->axes[across][k];
        candidates[1].axis[k] = box->axes[along][k];
    }
    dmi_leaves_weigh(part, candidates, 2, probability);
    return probability[0] / probability[1];
}

/* Along the seam, an axis gains at the side away from it, loses at the seam, and stays in between; across it, one gains
 * at the ends. Wherever the leaf lies, however large it is, and on whichever side its twin. */
static void where_an_axis_passes_decides(void** state) {
    (void)state;
    static const float lows[] = {-0.5f, 0.3f, -7};
    static const float places[] = {-1, -0.62f, -0.58f, 0, 0.58f, 0.62f, 1};
    for (int across = 0; across < 3; across++) {
        const int along = across == 0 ? 1 : 0, thin = across == 2 ? 1 : 2;
        for (int i = 0; i < 6; i++) {
            const float sign = i % 2 ? -1.0f : 1.0f;
            dmi_part_analysis* part = &a.of_part;
            memset(part, 0, sizeof *part);
            part->has_twin = true;
            part->twin_way[across] = sign;
            free_each_way(part);
            for (int k = 0; k < 3; k++) {
                part->box.axes[k][k] = 1;
                part->box.low[k] = lows[i / 2] + 0.1f * (float)k, part->box.high[k] = part->box.low[k] + 0.8f;
            }
            for (size_t p = 0; p < sizeof places / sizeof *places; p++) {
                const float outside = gain(part, along, across, -sign * places[p]);
                if (places[p] > 0.6f)
                    assert_float_equal(logf(outside), 5, 1e-4f);
                else if (places[p] < -0.6f)
                    assert_float_equal(logf(outside), -4, 1e-4f);
                else
                    assert_float_equal(outside, 1, 1e-5f);
                const float end = gain(part, across, along, places[p]);
                assert_float_equal(logf(end), fabsf(places[p]) > 0.6f ? 3 : 0, 1e-4f);
                assert_float_equal(gain(part, thin, across, places[p]), 1, 1e-5f);
            }
        }
    }
}

/* Axes count as along a side up to a cosine of 0.9; many candidates share 1, by their likelihoods. */
static void slanted_axes_and_many_candidates(void** state) {
    (void)state;
    enum { CANDIDATES = 40 };
    dmi_part_analysis* part = &a.of_part;
    dmi_candidate candidates[CANDIDATES] = {{0}};
    float probability[CANDIDATES], likelihood[CANDIDATES], sum = 0, all = 0;
    memset(part, 0, sizeof *part);
    part->has_twin = true;
    part->twin_way[2] = 1;
    free_each_way(part);
    for (int k = 0; k < 3; k++) part->box.axes[k][k] = 1, part->box.low[k] = -1, part->box.high[k] = 1;
    for (int i = 0; i < CANDIDATES; i++) {
        const float cosine = i % 2 ? 0.905f : 0.895f, sine = sqrtf(1 - cosine * cosine);
        const int side = i / 2 % 2 ? 2 : 0; /* 0: along the seam; 2: across it */
        dmi_candidate* c = &candidates[i];
        c->type = i % 5 == 0 ? DM_JOINT_PRISMATIC : DM_JOINT_REVOLUTE;
        c->axis[side] = i % 3 ? cosine : -cosine, c->axis[1] = sine;
        c->origin[2 - side] = i / 4 % 2 ? 0.9f : -0.9f;
        probability[i] = 0.001f * (float)(1 + i);
        const float says = side == 2 ? 3 : c->origin[2] < 0 ? 5 : -4;
        likelihood[i] = probability[i] * (c->type == DM_JOINT_PRISMATIC || i % 2 == 0 ? 1 : expf(says));
        sum += likelihood[i];
    }
    dmi_leaves_weigh(part, candidates, CANDIDATES, probability);
    for (int i = 0; i < CANDIDATES; i++) {
        assert_float_equal(probability[i], likelihood[i] / sum, 1e-5f);
        all += probability[i];
    }
    assert_float_equal(all, 1, 1e-5f);
}

/* A slide with the body in its way on both sides is unlikely. One free way is enough, and turns are as likely as
 * before. */
static void a_blocked_slide_is_unlikely(void** state) {
    (void)state;
    dmi_part_analysis* part = &a.of_part;
    memset(part, 0, sizeof *part);
    for (int k = 0; k < 3; k++) part->box.axes[k][k] = 1, part->box.low[k] = -1, part->box.high[k] = 1;
    for (int blocked = 0; blocked < 3; blocked++) {
        for (int ways = 1; ways <= 2; ways++) {
            free_each_way(part);
            for (int way = 0; way < ways; way++) part->clearance[blocked][way] = 0.07f;
            for (int axis = 0; axis < 3; axis++) {
                dmi_candidate candidates[2] = {{.type = DM_JOINT_PRISMATIC}, {.type = DM_JOINT_REVOLUTE}};
                float probability[2] = {0.5f, 0.5f};
                candidates[0].axis[axis] = candidates[1].axis[axis] = 1;
                dmi_leaves_weigh(part, candidates, 2, probability);
                const float want = ways == 2 && axis == blocked ? -1.5f : 0;
                assert_float_equal(logf(probability[0] / probability[1]), want, 1e-4f);
            }
        }
    }
}

/* With the ranker that ships: pulled at the seam, the leaf turns about its far side. */
static void a_leaf_without_a_frame_hangs_outside(void** state) {
    (void)state;
    size_t size;
    void* bytes = test_read_file("sdk/models/ranker.safetensors", &size);
    dmi_joint_models* joints = NULL;
    make_leaves();
    test_analysis_open(&a, &shape, 3);
    assert_int_equal(dmi_joint_models_load(&a.t.env, bytes, size, &joints), DM_OK);
    dmi_drag_hint hint;
    dmi_frame_point_in(&a.mesh->frame, (const double[]){0.95 * WIDE, 0.5 * HIGH, THICK}, hint.point);
    dmi_frame_vector_in(&a.mesh->frame, (const float[]){0, 0, 0.1f}, hint.vector);
    const dmi_inference_query query = {
        .mesh = a.mesh, .cloud = &a.cloud, .hint = &hint, .part = 1, .models.joints = joints};
    dmi_hypotheses found;
    assert_int_equal(dmi_joint_inference_run(&a.t.env, &query, &found, NULL), DM_OK);
    const dm_joint* joint = &found.joints[0];
    float middle[3];
    dmi_frame_point_in(&a.mesh->frame, (const double[]){0.5 * WIDE, 0, 0}, middle);
    assert_int_equal(joint->type, DM_JOINT_REVOLUTE);
    assert_true(fabsf(joint->axis.y) > 0.99f);
    assert_true(joint->origin.x < middle[0] - 0.4f * WIDE / (2 * WIDE));
    dmi_joint_models_destroy(joints);
    free(bytes);
    test_analysis_close(&a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mirror_image_beside_a_part_is_its_twin),
        cmocka_unit_test(a_frame_is_no_twin),
        cmocka_unit_test(a_leaf_in_the_same_frame_is_found),
        cmocka_unit_test(a_turn_at_the_seam_of_a_frame_is_less_likely),
        cmocka_unit_test(a_wall_behind_or_a_wider_neighbour_is_no_twin),
        cmocka_unit_test(far_edges_are_candidates),
        cmocka_unit_test(each_side_has_three_lines),
        cmocka_unit_test(a_blocked_slide_is_unlikely),
        cmocka_unit_test(slanted_axes_and_many_candidates),
        cmocka_unit_test(the_far_side_is_likelier_than_the_seam),
        cmocka_unit_test(where_an_axis_passes_decides),
        cmocka_unit_test(a_leaf_without_a_frame_hangs_outside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
