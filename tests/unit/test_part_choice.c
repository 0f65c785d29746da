/* What the part finder chooses from: sheets and their regions, twins, kinds of touch, stages of growth, and what tells
 * one from the other. */
#include "test_env.h"

#include <math.h>
#include <string.h>

#include "segmentation/part_choice.h"
#include "test_shapes.h"

/* A network that finds every piece equally likely: the first that touches joins. */
static const float zeros[DMI_GROWTH_FEATURES];
static const dmi_part_net indifferent = {DMI_GROWTH_FEATURES, 1, zeros, zeros, zeros, 0};

typedef struct fixture {
    test_env t;
    dmi_arena arena;
    dmi_mesh* mesh;
    dmi_part_sheets sheets;
} fixture;

static test_shape shape;
static dmi_proposals proposals;

static void open_fixture(fixture* f) {
    dmi_axes axes;
    dm_mesh_desc desc = test_shape_desc(&shape);
    desc.part_ids = NULL;
    test_env_open(&f->t, TEST_NEVER);
    dmi_arena_init(&f->arena, &f->t.env, (size_t)1 << 20);
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    assert_int_equal(dmi_mesh_create_pieces(&f->t.env, &axes, &desc, &f->mesh), DM_OK);
    assert_int_equal(dmi_part_sheets_make(&f->arena, f->mesh, &f->sheets), DM_OK);
}

static void close_fixture(fixture* f) {
    dmi_arena_release(&f->arena);
    dmi_mesh_destroy(&f->t.env, f->mesh);
    test_env_close(&f->t);
}

static uint32_t face_of_part(uint32_t part) {
    uint32_t f = 0;
    while (shape.part[f] != part) f++;
    return f;
}

static void propose(fixture* f, uint32_t part, const float drag[3]) {
    dmi_grab grab = {.face = face_of_part(part), .drag = {drag[0], drag[1], drag[2]}};
    for (int k = 0; k < 3; k++) grab.point[k] = f->mesh->positions[f->mesh->indices[grab.face * 3] * 3 + (uint32_t)k];
    assert_int_equal(dmi_proposals_make(&f->arena, &f->sheets, &grab, &indifferent, &proposals), DM_OK);
}

static const float outwards[3] = {0, 0, 1}, nowhere[3] = {0, 0, 0};

static void test_a_sheet_is_cut_into_its_smooth_regions(void** state) {
    (void)state;
    fixture f;
    dmi_part_level whole, cut;
    test_shape_cabinet(&shape);
    open_fixture(&f);
    assert_int_equal(f.sheets.count, 3);
    assert_int_equal(dmi_part_level_make(&f.arena, &f.sheets, DMI_PART_NONE, &whole), DM_OK);
    assert_int_equal(whole.pieces.count, 3);
    assert_int_equal(whole.fine, 0);
    const uint32_t door = f.sheets.labels[face_of_part(1)];
    assert_int_equal(dmi_part_level_make(&f.arena, &f.sheets, door, &cut), DM_OK);
    assert_int_equal(cut.pieces.count, 3 + 5);
    assert_int_equal(cut.fine, 1);
    uint32_t of_door = 0;
    for (uint32_t p = 0; p < cut.pieces.count; p++) of_door += cut.sheets[p] == door;
    assert_int_equal(of_door, 6);
    close_fixture(&f);
}

static void test_pieces_of_one_size_are_twins(void** state) {
    (void)state;
    fixture f;
    dmi_part_level level;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){4, 1, 1}, 0);
    test_shape_box(&shape, (const float[]){0, 0, 1.1f}, (const float[]){1, 1, 1.2f}, 1);
    test_shape_box(&shape, (const float[]){2, 0, 1.1f}, (const float[]){3, 1, 1.2f}, 2);
    open_fixture(&f);
    assert_int_equal(dmi_part_level_make(&f.arena, &f.sheets, DMI_PART_NONE, &level), DM_OK);
    const uint32_t body = f.sheets.labels[face_of_part(0)], one = f.sheets.labels[face_of_part(1)];
    const uint32_t other = f.sheets.labels[face_of_part(2)];
    assert_int_equal(level.twins[one][0], other);
    assert_int_equal(level.twins[other][0], one);
    assert_int_equal(level.twins[body][0], DMI_PART_NONE);
    close_fixture(&f);
}

/* Two samples at distance 1: each a point and a normal. */
static dmi_touch_kind classify(const float normal_a[3], const float b[3], const float normal_b[3]) {
    dmi_piece_sample samples[2] = {{.piece = 0}, {.piece = 1}};
    const dmi_pieces pieces = {.samples = samples, .reach = 1};
    const dmi_piece_touch touch = {.sample = 1, .distance = 1};
    memcpy(samples[0].normal, normal_a, sizeof samples[0].normal);
    memcpy(samples[1].normal, normal_b, sizeof samples[1].normal);
    memcpy(samples[1].point, b, sizeof samples[1].point);
    return dmi_touch_classify(&pieces, &samples[0], &touch, outwards);
}

static void test_touches_tell_inward_from_outward_bends(void** state) {
    (void)state;
    static const float up[3] = {0, 0, 1}, right[3] = {1, 0, 0}, left[3] = {-1, 0, 0};
    const float s = sqrtf(0.5f);
    /* A floor seen from above and, to its right, a wall that faces it or looks away. */
    dmi_touch_kind kind = classify(up, (const float[]){s, 0, s}, left);
    assert_true(kind.concave && !kind.convex && !kind.flush && !kind.stacked);
    kind = classify(up, (const float[]){s, 0, -s}, right);
    assert_true(kind.convex && !kind.concave && !kind.flush && !kind.stacked);
    kind = classify(up, (const float[]){1, 0, 0}, up);
    assert_true(kind.flush && !kind.stacked && !kind.convex && !kind.concave);
    kind = classify(up, (const float[]){0, 0, 1}, up);
    assert_true(kind.stacked && !kind.flush && kind.ahead < -0.9f);
}

static void test_every_stage_is_proposed_alone_and_with_what_it_carries(void** state) {
    (void)state;
    fixture f;
    test_shape_cabinet(&shape);
    open_fixture(&f);
    propose(&f, 1, outwards);
    const uint32_t body = f.sheets.labels[face_of_part(0)], door = f.sheets.labels[face_of_part(1)];
    const uint32_t handle = f.sheets.labels[face_of_part(2)];
    int alone = 0, carrying = 0;
    for (uint32_t i = 0; i < proposals.count; i++) {
        const dmi_proposal* item = &proposals.items[i];
        assert_int_equal(item->inside[item->seed], 1);
        if (item->level->fine) continue;
        alone += item->inside[door] == 1 && !item->inside[handle] && !item->inside[body];
        carrying += item->inside[door] == 1 && item->inside[handle] == 2 && !item->inside[body];
    }
    assert_int_equal(alone, 1);
    assert_int_equal(carrying, 1);
    close_fixture(&f);
}

static void test_features_are_finite_and_forget_the_drag(void** state) {
    (void)state;
    fixture f;
    test_shape_cabinet(&shape);
    open_fixture(&f);
    for (int told = 0; told < 2; told++) {
        propose(&f, 1, told ? outwards : nowhere);
        assert_true(proposals.count > 2);
        for (uint32_t i = 0; i < proposals.count; i++) {
            const float* features = proposals.items[i].features;
            for (int k = 0; k < DMI_CHOICE_FEATURES; k++) assert_true(isfinite(features[k]));
            assert_int_equal((int)features[20], told);
            if (!told) assert_true(features[21] == 0 && features[22] == 0);
        }
    }
    close_fixture(&f);
}

/* A door's back slides along nothing when it is pulled off the body; pushed along the body it slides freely. */
static void test_contact_tells_in_which_direction_a_part_is_free(void** state) {
    (void)state;
    static const float along[3] = {1, 0, 0};
    fixture f;
    test_shape_cabinet(&shape);
    open_fixture(&f);
    propose(&f, 1, outwards);
    assert_true(proposals.items[0].features[21] > 0.9f);
    propose(&f, 1, along);
    assert_true(proposals.items[0].features[21] < 0.5f);
    for (uint32_t i = 0; i < proposals.count; i++)
        assert_true(proposals.items[i].features[22] <= proposals.items[i].features[21] + 1e-3f);
    close_fixture(&f);
}

/* A tray with a ball bearing in it, on a table: the tray alone holds the bearing, and its mirror image is itself. */
static void test_a_part_knows_what_it_holds_and_what_would_join_next(void** state) {
    (void)state;
    enum { SYMMETRY = 42, NEXT = 45, IN_ITS_BOX = NEXT, AREA_OF_NEXT = NEXT + 2, HOLDS = NEXT + 5, SHARE = NEXT + 7 };
    fixture f;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){-4, -1, -4}, (const float[]){4, 0, 4}, 0);
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){2, 0.6f, 1}, 1);
    test_shape_box(&shape, (const float[]){0.9f, 0.2f, 0.4f}, (const float[]){1.1f, 0.4f, 0.6f}, 2);
    open_fixture(&f);
    propose(&f, 1, nowhere);
    const dmi_proposal* tray = &proposals.items[0];
    const uint32_t table = f.sheets.labels[face_of_part(0)];
    assert_false(tray->inside[table]);
    for (int k = 0; k < 3; k++) assert_true(tray->features[SYMMETRY + k] > 0.7f);
    assert_int_equal(tray->next_piece, table);
    assert_true(tray->features[AREA_OF_NEXT] > 1 && tray->features[IN_ITS_BOX] < 0.2f);
    assert_true(tray->features[HOLDS] > 0 && tray->features[HOLDS] < 0.1f);
    assert_true(tray->features[SHARE] <= 1);
    close_fixture(&f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_part_knows_what_it_holds_and_what_would_join_next),
        cmocka_unit_test(test_a_sheet_is_cut_into_its_smooth_regions),
        cmocka_unit_test(test_pieces_of_one_size_are_twins),
        cmocka_unit_test(test_touches_tell_inward_from_outward_bends),
        cmocka_unit_test(test_every_stage_is_proposed_alone_and_with_what_it_carries),
        cmocka_unit_test(test_features_are_finite_and_forget_the_drag),
        cmocka_unit_test(test_contact_tells_in_which_direction_a_part_is_free),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
