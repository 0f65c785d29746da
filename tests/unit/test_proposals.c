/* Segmentation into sheets and smooth regions, repeated pieces, kinds of contact, proposals and their features. */
#include "test_env.h"

#include <math.h>
#include <string.h>

#include "segmentation/proposals.h"
#include "segmentation/region_contacts.h"
#include "segmentation/region_growing.h"
#include "test_perceptron.h"
#include "test_shapes.h"

typedef struct fixture {
    test_env t;
    dmi_arena arena;
    test_layers layers;
    dmi_perceptron uniform; /* log odds of 0 for every piece: the first neighbour is added */
    dmi_mesh* mesh;
    dmi_mesh_sheets sheets;
} fixture;

static test_shape shape;
static dmi_proposals proposals;

static void open_fixture(fixture* f) {
    dmi_axes axes;
    dm_mesh_desc desc = test_shape_desc(&shape);
    desc.part_ids = NULL;
    test_env_open(&f->t, TEST_NEVER);
    dmi_arena_init(&f->arena, &f->t.env, (size_t)1 << 20);
    test_layers_open(&f->layers, &f->t.env);
    f->uniform.layer_count = 1;
    f->uniform.layers[0] = test_layer(&f->layers, NULL, NULL, DMI_NEIGHBOUR_FEATURES, 1);
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    assert_int_equal(dmi_mesh_create_pieces(&f->t.env, &axes, &desc, NULL, &f->mesh), DM_OK);
    assert_int_equal(dmi_mesh_sheets_make(&f->arena, f->mesh, NULL, &f->sheets), DM_OK);
}

static void close_fixture(fixture* f) {
    dmi_arena_release(&f->arena);
    test_layers_close(&f->layers);
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
    assert_int_equal(dmi_proposals_make(&f->arena, &f->sheets, &grab, &f->uniform, DMI_ISA_SCALAR, NULL, &proposals),
                     DM_OK);
}

static const float outward[3] = {0, 0, 1}, no_drag[3] = {0, 0, 0};

static void test_a_sheet_is_cut_into_its_smooth_regions(void** state) {
    (void)state;
    fixture f;
    dmi_piece_level whole, cut;
    test_shape_cabinet(&shape);
    open_fixture(&f);
    assert_int_equal(f.sheets.count, 3);
    assert_int_equal(dmi_piece_level_make(&f.arena, &f.sheets, DMI_PIECE_NONE, NULL, &whole), DM_OK);
    assert_int_equal(whole.pieces.count, 3);
    assert_int_equal(whole.sheet_is_cut, 0);
    const uint32_t door = f.sheets.labels[face_of_part(1)];
    assert_int_equal(dmi_piece_level_make(&f.arena, &f.sheets, door, NULL, &cut), DM_OK);
    assert_int_equal(cut.pieces.count, 3 + 5);
    assert_int_equal(cut.sheet_is_cut, 1);
    uint32_t of_door = 0;
    for (uint32_t p = 0; p < cut.pieces.count; p++) of_door += cut.sheets[p] == door;
    assert_int_equal(of_door, 6);
    close_fixture(&f);
}

static void test_pieces_of_the_same_area_are_repeats(void** state) {
    (void)state;
    fixture f;
    dmi_piece_level level;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){4, 1, 1}, 0);
    test_shape_box(&shape, (const float[]){0, 0, 1.1f}, (const float[]){1, 1, 1.2f}, 1);
    test_shape_box(&shape, (const float[]){2, 0, 1.1f}, (const float[]){3, 1, 1.2f}, 2);
    open_fixture(&f);
    assert_int_equal(dmi_piece_level_make(&f.arena, &f.sheets, DMI_PIECE_NONE, NULL, &level), DM_OK);
    const uint32_t body = f.sheets.labels[face_of_part(0)], one = f.sheets.labels[face_of_part(1)];
    const uint32_t other = f.sheets.labels[face_of_part(2)];
    assert_int_equal(level.repeats[one][0], other);
    assert_int_equal(level.repeats[other][0], one);
    assert_int_equal(level.repeats[body][0], DMI_PIECE_NONE);
    close_fixture(&f);
}

/* Two samples at distance 1: each a point and a normal. */
static dmi_contact_kind classify(const float normal_a[3], const float b[3], const float normal_b[3]) {
    dmi_piece_sample samples[2] = {{.piece = 0}, {.piece = 1}};
    const dmi_pieces pieces = {.samples = samples, .contact_distance = 1};
    const dmi_piece_contact contact = {.sample = 1, .distance = 1};
    memcpy(samples[0].normal, normal_a, sizeof samples[0].normal);
    memcpy(samples[1].normal, normal_b, sizeof samples[1].normal);
    memcpy(samples[1].point, b, sizeof samples[1].point);
    return dmi_contact_classify(&pieces, &samples[0], &contact, outward);
}

static void test_contacts_are_classified_by_offset_and_normal(void** state) {
    (void)state;
    static const float up[3] = {0, 0, 1}, right[3] = {1, 0, 0}, left[3] = {-1, 0, 0};
    const float s = sqrtf(0.5f);
    /* A floor and, to its right, a wall whose normal points towards it or away from it. */
    dmi_contact_kind kind = classify(up, (const float[]){s, 0, s}, left);
    assert_true(kind.concave && !kind.convex && !kind.flush && !kind.stacked);
    kind = classify(up, (const float[]){s, 0, -s}, right);
    assert_true(kind.convex && !kind.concave && !kind.flush && !kind.stacked);
    kind = classify(up, (const float[]){1, 0, 0}, up);
    assert_true(kind.flush && !kind.stacked && !kind.convex && !kind.concave);
    kind = classify(up, (const float[]){0, 0, 1}, up);
    assert_true(kind.stacked && !kind.flush && kind.behind && !kind.ahead);
}

static void test_every_stage_is_proposed_alone_and_with_what_it_carries(void** state) {
    (void)state;
    fixture f;
    test_shape_cabinet(&shape);
    open_fixture(&f);
    propose(&f, 1, outward);
    const uint32_t body = f.sheets.labels[face_of_part(0)], door = f.sheets.labels[face_of_part(1)];
    const uint32_t handle = f.sheets.labels[face_of_part(2)];
    int alone = 0, carrying = 0;
    for (uint32_t i = 0; i < proposals.count; i++) {
        const dmi_proposal* item = &proposals.items[i];
        assert_int_equal(item->inside[item->seed], 1);
        if (item->level->sheet_is_cut) continue;
        alone += item->inside[door] == 1 && !item->inside[handle] && !item->inside[body];
        carrying += item->inside[door] == 1 && item->inside[handle] == DMI_PIECE_CARRIED && !item->inside[body];
    }
    assert_int_equal(alone, 1);
    assert_int_equal(carrying, 1);
    close_fixture(&f);
}

static void test_features_are_finite_and_zero_without_a_drag(void** state) {
    (void)state;
    fixture f;
    test_shape_cabinet(&shape);
    open_fixture(&f);
    for (int told = 0; told < 2; told++) {
        propose(&f, 1, told ? outward : no_drag);
        assert_true(proposals.count > 2);
        for (uint32_t i = 0; i < proposals.count; i++) {
            const float* features = proposals.items[i].features;
            for (int k = 0; k < DMI_PROPOSAL_FEATURES; k++) assert_true(isfinite(features[k]));
            assert_int_equal((int)features[DMI_PROPOSAL_HAS_DRAG], told);
            if (!told) assert_true(features[DMI_PROPOSAL_SLIDE_SPEED] == 0 && features[DMI_PROPOSAL_TURN_SPEED] == 0);
        }
    }
    close_fixture(&f);
}

/* Pulled off the body, a door moves along the contact normals; pushed along the body, it moves across them. */
static void test_contact_speeds_are_small_in_free_directions(void** state) {
    (void)state;
    static const float along[3] = {1, 0, 0};
    fixture f;
    test_shape_cabinet(&shape);
    open_fixture(&f);
    propose(&f, 1, outward);
    assert_true(proposals.items[0].features[DMI_PROPOSAL_SLIDE_SPEED] > 0.9f);
    propose(&f, 1, along);
    assert_true(proposals.items[0].features[DMI_PROPOSAL_SLIDE_SPEED] < 0.5f);
    for (uint32_t i = 0; i < proposals.count; i++)
        assert_true(proposals.items[i].features[DMI_PROPOSAL_TURN_SPEED] <=
                    proposals.items[i].features[DMI_PROPOSAL_SLIDE_SPEED] + 1e-3f);
    close_fixture(&f);
}

/* A symmetric tray with a small box inside it, on a table. */
static void test_features_of_enclosed_and_next_pieces(void** state) {
    (void)state;
    fixture f;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){-4, -1, -4}, (const float[]){4, 0, 4}, 0);
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){2, 0.6f, 1}, 1);
    test_shape_box(&shape, (const float[]){0.9f, 0.2f, 0.4f}, (const float[]){1.1f, 0.4f, 0.6f}, 2);
    open_fixture(&f);
    propose(&f, 1, no_drag);
    const dmi_proposal* tray = &proposals.items[0];
    const uint32_t table = f.sheets.labels[face_of_part(0)];
    assert_false(tray->inside[table]);
    for (int k = 0; k < 3; k++) assert_true(tray->features[DMI_PROPOSAL_SYMMETRY + k] > 0.7f);
    assert_int_equal(tray->next_piece, table);
    assert_true(tray->features[DMI_PROPOSAL_LOG_NEXT_AREA] > 1 && tray->features[DMI_PROPOSAL_NEXT_IN_BOX] < 0.2f);
    assert_true(tray->features[DMI_PROPOSAL_ENCLOSED_AREA] > 0 && tray->features[DMI_PROPOSAL_ENCLOSED_AREA] < 0.1f);
    assert_true(tray->features[DMI_PROPOSAL_GROWTH_AREA] <= 1);
    close_fixture(&f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_features_of_enclosed_and_next_pieces),
        cmocka_unit_test(test_a_sheet_is_cut_into_its_smooth_regions),
        cmocka_unit_test(test_pieces_of_the_same_area_are_repeats),
        cmocka_unit_test(test_contacts_are_classified_by_offset_and_normal),
        cmocka_unit_test(test_every_stage_is_proposed_alone_and_with_what_it_carries),
        cmocka_unit_test(test_features_are_finite_and_zero_without_a_drag),
        cmocka_unit_test(test_contact_speeds_are_small_in_free_directions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
