/* What an asset says of a part: words of names, kinds, places of pivots, and how they weigh candidates. */
#include <string.h>

#include "test_analysis.h"

#include "kinematics/hints/hint_likelihood.h"
#include "kinematics/hints/label_words.h"
#include "math/linear3.h"

/* ---- words ---- */

static void assert_words(const char* name, const char* expected) {
    dmi_label_words split;
    char joined[1024] = "";
    dmi_split_label(name, strlen(name), &split);
    for (size_t i = 0; i < split.count; i++) {
        if (i > 0) strcat(joined, " ");
        strcat(joined, split.words[i]);
    }
    assert_string_equal(joined, expected);
}

static void names_are_split_into_folded_words(void** state) {
    (void)state;
    assert_words("", "");
    assert_words("door", "door");
    assert_words("Door_Left.001", "door left");
    assert_words("frontDoorFRWheel2x", "front door fr wheel x");
    assert_words("SM_CHEST-lid", "sm chest lid");
    assert_words("T\xC3\xBCr", "tur");  /* u with diaeresis, one character */
    assert_words("TU\xCC\x88R", "tur"); /* the same, accent apart */
    assert_words("\xC3\x89"
                 "cran",
                 "ecran"); /* upper-case E with acute */
    assert_words("\xD0\x94\xD0\x92\xD0\x95\xD0\xA0\xD0\xAC", "\xD0\xB4\xD0\xB2\xD0\xB5\xD1\x80\xD1\x8C"); /* Cyrillic */
    assert_words("\xE6\x89\x89"
                 "01",
                 "\xE6\x89\x89"); /* an ideograph */
}

static void bytes_that_are_no_utf8_separate_words(void** state) {
    (void)state;
    assert_words("lid\xFF\xFE"
                 "door",
                 "lid door");
    assert_words("lid\xC3", "lid");            /* cut off */
    assert_words("\xC0\x81lid", "lid");        /* longer than need be */
    assert_words("a\xF5\x80\x80\x80z", "a z"); /* beyond the last character */
}

static void long_names_are_cut(void** state) {
    (void)state;
    char name[4000];
    dmi_label_words split;
    memset(name, 'a', sizeof name);
    dmi_split_label(name, sizeof name, &split);
    assert_int_equal(split.count, 1);
    assert_int_equal(strlen(split.words[0]), DMI_WORD_LENGTH_MAX - 1);
    for (size_t i = 0; i < sizeof name; i += 2) name[i] = '_';
    dmi_split_label(name, sizeof name, &split);
    assert_int_equal(split.count, DMI_WORDS_MAX);
}

/* ---- kinds ---- */

static void assert_kind(const char* label, dmi_part_kind kind, uint32_t depth) {
    const dmi_label_kind found = dmi_kind_of_label(label);
    if (found.kind != kind || (kind != DMI_KIND_NOTHING && found.depth != depth))
        fail_msg("'%s' is kind %d at %u, not %d at %u", label != NULL ? label : "", found.kind, found.depth, kind,
                 depth);
}

static void labels_tell_kinds(void** state) {
    (void)state;
    assert_kind(NULL, DMI_KIND_NOTHING, 0);
    assert_kind("", DMI_KIND_NOTHING, 0);
    assert_kind("Scene/Cube.001", DMI_KIND_NOTHING, 0);
    assert_kind("Chest/Lid_01", DMI_KIND_LID, 0);
    assert_kind("lid/Bone", DMI_KIND_LID, 1);
    assert_kind("DOORS", DMI_KIND_DOOR, 0);
    assert_kind("trap door.002", DMI_KIND_TRAPDOOR, 0);
    assert_kind("Trapdoor", DMI_KIND_TRAPDOOR, 0);
    assert_kind("indoor", DMI_KIND_NOTHING, 0);
    assert_kind("level_2", DMI_KIND_NOTHING, 0);
}

static void the_last_noun_counts(void** state) {
    (void)state;
    assert_kind("door_handle", DMI_KIND_HANDLE, 0);
    assert_kind("doorknob", DMI_KIND_KNOB, 0);
    assert_kind("FrontLeftDoor", DMI_KIND_DOOR, 0);
    assert_kind("handle/door", DMI_KIND_DOOR, 0);
}

static void a_part_goes_before_what_carries_it(void** state) {
    (void)state;
    assert_kind("chest", DMI_KIND_CHEST, 0);
    assert_kind("lid/chest", DMI_KIND_LID, 1);
    assert_kind("tapa_cofre", DMI_KIND_LID, 0);
    assert_kind("safe/door/wheel", DMI_KIND_WHEEL, 0);
}

static void words_of_many_languages_and_misspelt_ones(void** state) {
    (void)state;
    assert_kind("Schublade_links", DMI_KIND_DRAWER, 0);
    assert_kind("Autot\xC3\xBCr", DMI_KIND_NOTHING, 0); /* three letters are no ending */
    assert_kind("T\xC3\xBCr", DMI_KIND_DOOR, 0);
    assert_kind("puerta_izquierda", DMI_KIND_DOOR, 0);
    assert_kind("couvercle", DMI_KIND_LID, 0);
    assert_kind("\xD0\x94\xD0\xB2\xD0\xB5\xD1\x80\xD1\x8C", DMI_KIND_DOOR, 0);
    assert_kind("\xE6\x9C\xA8\xE6\x89\x89", DMI_KIND_DOOR, 0); /* a wooden door: the noun comes last */
    assert_kind("whell_FR", DMI_KIND_WHEEL, 0);
    assert_kind("dwraer", DMI_KIND_NOTHING, 0); /* two letters are wrong */
}

/* ---- modifiers ---- */

#define BIT(name) (1u << DMI_MODIFIER_##name)

/* All modifiers that count of a label's kind. */
static uint32_t modifiers_of(const char* label) {
    const dmi_label_kind found = dmi_kind_of_label(label);
    const dmi_label_modifiers count = dmi_modifiers_that_count(found.kind, found.modifiers);
    return count.own | count.above;
}

static void modifiers_count_in_any_order(void** state) {
    (void)state;
    static const char* const sliding[] = {"sliding_door",     "Door_Sliding", "SM_Door_A_Sliding_01",
                                          "DoorSliding/Cube", "sliding/door", "Schiebet\xC3\xBCr"};
    for (size_t i = 0; i < sizeof sliding / sizeof *sliding; i++) {
        assert_int_equal(dmi_kind_of_label(sliding[i]).kind, DMI_KIND_SLIDING_DOOR);
        assert_true(modifiers_of(sliding[i]) & BIT(SLIDING));
    }
    assert_int_equal(modifiers_of("garage_door"), BIT(GARAGE));
    assert_int_equal(modifiers_of("Garage/Door.001"), BIT(GARAGE));
    assert_int_equal(modifiers_of("roller_door"), BIT(ROLLING));
    assert_int_equal(modifiers_of("elevator_door"), BIT(ELEVATOR));
    assert_int_equal(modifiers_of("barn_door"), BIT(BARN));
    assert_int_equal(modifiers_of("door_folding"), BIT(FOLDING));
    assert_int_equal(modifiers_of("Door"), 0);
    assert_int_equal(dmi_kind_of_label("HatchDoor").kind, DMI_KIND_TRAPDOOR);
}

static void a_noun_may_stand_behind_a_modifier_in_one_word(void** state) {
    (void)state;
    assert_kind("Garagentor", DMI_KIND_GATE, 0);
    assert_int_equal(modifiers_of("Garagentor"), BIT(GARAGE));
    assert_kind("rolltor", DMI_KIND_GATE, 0);
    assert_int_equal(modifiers_of("rolltor"), BIT(ROLLING));
    assert_kind("Faltt\xC3\xBCr", DMI_KIND_DOOR, 0);
    assert_int_equal(modifiers_of("Faltt\xC3\xBCr"), BIT(FOLDING));
}

static void modifiers_mean_something_of_leaves_alone(void** state) {
    (void)state;
    assert_int_equal(modifiers_of("roller"), 0);
    assert_int_equal(modifiers_of("garage_wheel_left"), 0);
    assert_int_equal(modifiers_of("sliding_knob"), 0);
    assert_int_equal(modifiers_of("garage/Cube"), 0);
    assert_int_equal(modifiers_of(NULL), 0);
}

static void sides_of_a_pair_count_once(void** state) {
    (void)state;
    assert_int_equal(modifiers_of("door_L"), BIT(LEFT));
    assert_int_equal(modifiers_of("FrontDoor_R"), BIT(RIGHT));
    assert_int_equal(modifiers_of("left/door_R"), BIT(RIGHT)); /* the nearer name */
    assert_int_equal(modifiers_of("door_left_right"), 0);
}

/* ---- pivots ---- */

static test_shape shape;
static test_analysis lid;
static dmi_candidate candidates[DMI_CANDIDATES_MAX];
static float probability[DMI_CANDIDATES_MAX];

/* A body of 0.8 x 0.4 x 0.5 with a plate on it. */
static int open_lid(void** state) {
    (void)state;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){0.8f, 0.4f, 0.5f}, 0);
    test_shape_box(&shape, (const float[]){0, 0.402f, 0}, (const float[]){0.8f, 0.45f, 0.5f}, 1);
    test_analysis_open(&lid, &shape, 3);
    return 0;
}

static int close_lid(void** state) {
    (void)state;
    test_analysis_close(&lid);
    return 0;
}

static dmi_asset_hints pivot_at(double x, double y, double z) {
    dmi_asset_hints hints = {.up = {0, 1, 0}, .has_pivot = true, .has_axes = true};
    for (int k = 0; k < 3; k++) hints.pivot_axes[k][k] = 1;
    dmi_frame_point_in(&lid.mesh->frame, (const double[3]){x, y, z}, hints.pivot);
    return hints;
}

static dmi_pivot_place place_of(dmi_asset_hints hints) {
    dmi_hint_frame frame;
    dmi_hint_frame_make(&hints, &lid.of_part, &frame);
    return frame.place;
}

static void places_of_pivots_in_a_plate(void** state) {
    (void)state;
    assert_int_equal(place_of(pivot_at(0.4, 0.425, 0.25)), DMI_PIVOT_MIDDLE);
    assert_int_equal(place_of(pivot_at(0.4, 0.402, 0.25)), DMI_PIVOT_MIDDLE); /* a plate's faces are its middle */
    assert_int_equal(place_of(pivot_at(0.4, 0.402, 0)), DMI_PIVOT_SIDE);
    assert_int_equal(place_of(pivot_at(0.1, 0.402, 0)), DMI_PIVOT_EDGE);
    assert_int_equal(place_of(pivot_at(0, 0.45, 0.5)), DMI_PIVOT_EDGE);
    assert_int_equal(place_of(pivot_at(0.2, 0.42, 0.15)), DMI_PIVOT_INSIDE);
    assert_int_equal(place_of(pivot_at(0.4, 0, 0.25)), DMI_PIVOT_OUTSIDE);
    dmi_asset_hints origin = pivot_at(0.4, 0, 0.25), corner = pivot_at(0, 0.45, 0.5);
    origin.is_default = corner.is_default = true;
    assert_int_equal(place_of(origin), DMI_PIVOT_DEFAULT);
    assert_int_equal(place_of(corner), DMI_PIVOT_EDGE);
}

static void pivot_features_tell_lines_through_it(void** state) {
    (void)state;
    const dmi_asset_hints hints = pivot_at(0.1, 0.402, 0);
    dmi_hint_frame frame;
    float f[DMI_PIVOT_FEATURES];
    dmi_hint_frame_make(&hints, &lid.of_part, &frame);
    const dmi_candidate hinge =
        test_candidate(lid.mesh, DM_JOINT_REVOLUTE, (const float[]){1, 0, 0}, (const double[]){0.4, 0.402, 0});
    dmi_pivot_features(&frame, &hinge, f);
    assert_float_equal(f[DMI_PIVOT_ON_ALIGNED], 1, 1e-3f);
    assert_float_equal(f[DMI_PIVOT_SLIDE], 0, 0);
    const dmi_candidate beside =
        test_candidate(lid.mesh, DM_JOINT_REVOLUTE, (const float[]){1, 0, 0}, (const double[]){0.4, 0.402, 0.05});
    dmi_pivot_features(&frame, &beside, f);
    assert_float_equal(f[DMI_PIVOT_ON], 0, 1e-3f);
    assert_true(f[DMI_PIVOT_NEAR] < 0.5f && f[DMI_PIVOT_NEAR] > 0);
    const dmi_candidate slide =
        test_candidate(lid.mesh, DM_JOINT_PRISMATIC, (const float[]){0, 1, 0}, (const double[]){0.4, 0.402, 0});
    dmi_pivot_features(&frame, &slide, f);
    assert_float_equal(f[DMI_PIVOT_SLIDE] + f[DMI_PIVOT_SLIDE_ALIGNED], 2, 0);
    assert_float_equal(f[DMI_PIVOT_NEAR], 0, 0);
}

static void pivot_features_tell_lines_through_the_middle_too(void** state) {
    (void)state;
    const dmi_asset_hints above = pivot_at(0.4, 0.9, 0.25);
    dmi_hint_frame frame;
    float f[DMI_PIVOT_FEATURES];
    dmi_hint_frame_make(&above, &lid.of_part, &frame);
    const dmi_candidate up =
        test_candidate(lid.mesh, DM_JOINT_PRISMATIC, (const float[]){0, 1, 0}, (const double[]){0, 0, 0});
    dmi_pivot_features(&frame, &up, f);
    assert_float_equal(f[DMI_PIVOT_SLIDE_THROUGH], 1, 1e-2f);
    const dmi_candidate aside =
        test_candidate(lid.mesh, DM_JOINT_PRISMATIC, (const float[]){1, 0, 0}, (const double[]){0, 0, 0});
    dmi_pivot_features(&frame, &aside, f);
    assert_float_equal(f[DMI_PIVOT_SLIDE_THROUGH], 0, 1e-2f);
    const dmi_candidate spin =
        test_candidate(lid.mesh, DM_JOINT_REVOLUTE, (const float[]){0, 1, 0}, (const double[]){0.4, 0, 0.25});
    dmi_pivot_features(&frame, &spin, f);
    assert_float_equal(f[DMI_PIVOT_ON_MIDDLE], 1, 1e-2f);
    const dmi_candidate high =
        test_candidate(lid.mesh, DM_JOINT_REVOLUTE, (const float[]){1, 0, 0}, (const double[]){0, 0.9, 0.25});
    dmi_pivot_features(&frame, &high, f);
    assert_float_equal(f[DMI_PIVOT_ON], 1, 1e-3f);
    assert_float_equal(f[DMI_PIVOT_ON_MIDDLE], 0, 1e-2f);
}

static void kind_features_tell_where_an_axis_runs(void** state) {
    (void)state;
    const dmi_asset_hints hints = {.up = {0, 1, 0}};
    dmi_hint_frame frame;
    dmi_hint_frame_make(&hints, &lid.of_part, &frame);
    const dmi_candidate hinge =
        test_candidate(lid.mesh, DM_JOINT_REVOLUTE, (const float[]){1, 0, 0}, (const double[]){0.4, 0.402, 0});
    assert_int_equal(dmi_kind_features(&frame, &hinge), 1u << DMI_KIND_TURN_LEVEL | 1u << DMI_KIND_TURN_LONG |
                                                            1u << DMI_KIND_TURN_EDGE | 1u << DMI_KIND_TURN_BOTTOM |
                                                            1u << DMI_KIND_TURN_BACK);
    const dmi_candidate slide =
        test_candidate(lid.mesh, DM_JOINT_PRISMATIC, (const float[]){0, 1, 0}, (const double[]){0, 0, 0});
    assert_int_equal(dmi_kind_features(&frame, &slide), 1u << DMI_KIND_SLIDE_UPRIGHT | 1u << DMI_KIND_SLIDE_SHORT);
    const dmi_candidate spin =
        test_candidate(lid.mesh, DM_JOINT_REVOLUTE, (const float[]){0, 1, 0}, (const double[]){0.4, 0, 0.25});
    assert_int_equal(dmi_kind_features(&frame, &spin),
                     1u << DMI_KIND_TURN_UPRIGHT | 1u << DMI_KIND_TURN_SHORT | 1u << DMI_KIND_TURN_CENTRE);
}

/* ---- weighing ---- */

static uint32_t make_even(const dmi_asset_hints* hints) {
    uint32_t count = dmi_candidates_make(&lid.of_part, NULL, NULL, candidates);
    count = dmi_hints_add_candidates(hints, &lid.of_part, NULL, candidates, count);
    for (uint32_t i = 0; i < count; i++) probability[i] = 1 / (float)count;
    return count;
}

/* The mean probability of turns through a point along x, over that of all candidates. */
static float gain_through(const dmi_asset_hints* hints, const float point[3]) {
    const uint32_t count = make_even(hints);
    float sum = 0, through = 0;
    uint32_t lines = 0;
    dmi_hints_weigh(hints, &lid.of_part, NULL, candidates, count, probability);
    for (uint32_t i = 0; i < count; i++) {
        sum += probability[i];
        if (candidates[i].type != DM_JOINT_REVOLUTE || fabsf(candidates[i].axis[0]) < 0.999f) continue;
        if (dmi_line_distance3(point, candidates[i].axis, candidates[i].origin) > 2e-3f) continue;
        through += probability[i];
        lines++;
    }
    assert_float_equal(sum, 1, 1e-4f);
    assert_true(lines > 0);
    return through / (float)lines * (float)count;
}

static void a_pivot_on_an_edge_counts_and_one_in_the_middle_hardly(void** state) {
    (void)state;
    const dmi_asset_hints edge = pivot_at(0.1, 0.402, 0), middle = pivot_at(0.4, 0.425, 0.25);
    assert_true(gain_through(&edge, edge.pivot) > 5);
    assert_true(gain_through(&middle, middle.pivot) < gain_through(&edge, edge.pivot) / 3);
}

/* A word that names the mechanism outweighs a pivot on an edge: what slides has its pivot anywhere. */
static void a_pivot_says_nothing_of_what_slides_by_name(void** state) {
    (void)state;
    dmi_asset_hints edge = pivot_at(0.1, 0.402, 0);
    edge.label = dmi_kind_of_label("gate");
    const float gate = gain_through(&edge, edge.pivot);
    edge.label = dmi_kind_of_label("sliding_gate/Cube");
    assert_true(gain_through(&edge, edge.pivot) < gate / 4);
    edge.label = dmi_kind_of_label("hinged_gate");
    assert_true(gain_through(&edge, edge.pivot) > gate / 4);
}

/* The probability of all slides after a name has weighed even candidates. */
static float slides_of(const char* label, const dmi_drag_hint* drag) {
    const dmi_asset_hints hints = {.up = {0, 1, 0}, .label = dmi_kind_of_label(label)};
    const uint32_t count = make_even(&hints);
    float sum = 0;
    dmi_hints_weigh(&hints, &lid.of_part, drag, candidates, count, probability);
    for (uint32_t i = 0; i < count; i++) sum += candidates[i].type == DM_JOINT_PRISMATIC ? probability[i] : 0;
    return sum;
}

static void a_name_tells_slides_from_turns_where_no_drag_does(void** state) {
    (void)state;
    const dmi_drag_hint drag = {.vector = {0, 1, 0}};
    assert_true(slides_of("scene/button", NULL) > 1.5f * slides_of("scene/button", &drag));
    assert_true(slides_of("scene/wheel", NULL) < slides_of("scene/wheel", &drag));
    assert_float_equal(slides_of("button/Cube", NULL), slides_of("button/Cube", &drag), 1e-6f); /* of what carries it */
}

/* The probability of all candidates of a type whose axis is upright or level, after a name has weighed even ones. */
static float share_of(const char* label, int32_t type, bool upright) {
    const dmi_asset_hints hints = {.up = {0, 0, 1}, .label = dmi_kind_of_label(label)}; /* the plate stands upright */
    const uint32_t count = make_even(&hints);
    float sum = 0;
    dmi_hints_weigh(&hints, &lid.of_part, NULL, candidates, count, probability);
    for (uint32_t i = 0; i < count; i++) {
        const float rise = fabsf(candidates[i].axis[2]);
        if (candidates[i].type == type && (upright ? rise > 0.95f : rise < 0.3f)) sum += probability[i];
    }
    return sum;
}

static void modifiers_tell_the_mechanism(void** state) {
    (void)state;
    static const char* const sliding[] = {"sliding_door", "barn_door", "elevator_door"};
    for (int i = 0; i < 3; i++)
        assert_true(share_of(sliding[i], DM_JOINT_PRISMATIC, false) > 2 * share_of("door", DM_JOINT_PRISMATIC, false));
    assert_true(share_of("roller_door", DM_JOINT_PRISMATIC, true) > 2 * share_of("door", DM_JOINT_PRISMATIC, true));
    assert_true(share_of("garage_door", DM_JOINT_REVOLUTE, true) < share_of("door", DM_JOINT_REVOLUTE, true) / 2);
    assert_true(share_of("garage/door", DM_JOINT_REVOLUTE, true) < share_of("door", DM_JOINT_REVOLUTE, true));
    assert_true(share_of("casement", DM_JOINT_REVOLUTE, true) > share_of("window", DM_JOINT_REVOLUTE, true));
    assert_true(share_of("window_sash", DM_JOINT_PRISMATIC, false) < share_of("window", DM_JOINT_PRISMATIC, false));
    assert_true(share_of("pane", DM_JOINT_PRISMATIC, false) < share_of("window", DM_JOINT_PRISMATIC, false));
    assert_true(share_of("door_L", DM_JOINT_REVOLUTE, true) > share_of("door", DM_JOINT_REVOLUTE, true));
}

static void candidates_through_a_pivot_are_added_once(void** state) {
    (void)state;
    const dmi_asset_hints hints = pivot_at(0.13, 0.431, 0.07); /* on no line of the shape */
    const uint32_t count = dmi_candidates_make(&lid.of_part, NULL, NULL, candidates);
    const uint32_t more = dmi_hints_add_candidates(&hints, &lid.of_part, NULL, candidates, count);
    assert_true(more >= count + 3 && more <= count + 12);
    for (uint32_t i = count; i < more; i++)
        if (candidates[i].type == DM_JOINT_REVOLUTE)
            assert_true(dmi_line_distance3(hints.pivot, candidates[i].axis, candidates[i].origin) < 1e-5f);
    assert_int_equal(dmi_hints_add_candidates(&hints, &lid.of_part, NULL, candidates, more), more);
}

static void impossible_candidates_stay_finite(void** state) {
    (void)state;
    const dmi_asset_hints hints = pivot_at(0.1, 0.402, 0);
    const uint32_t count = make_even(&hints);
    for (uint32_t i = 0; i < count; i++) probability[i] = i == 0 ? 1.0f : 0.0f;
    dmi_hints_weigh(&hints, &lid.of_part, NULL, candidates, count, probability);
    for (uint32_t i = 0; i < count; i++) assert_true(probability[i] >= 0 && probability[i] <= 1);
    assert_true(probability[0] > 0.99f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_are_split_into_folded_words),
        cmocka_unit_test(bytes_that_are_no_utf8_separate_words),
        cmocka_unit_test(long_names_are_cut),
        cmocka_unit_test(labels_tell_kinds),
        cmocka_unit_test(the_last_noun_counts),
        cmocka_unit_test(a_part_goes_before_what_carries_it),
        cmocka_unit_test(words_of_many_languages_and_misspelt_ones),
        cmocka_unit_test(modifiers_count_in_any_order),
        cmocka_unit_test(a_noun_may_stand_behind_a_modifier_in_one_word),
        cmocka_unit_test(modifiers_mean_something_of_leaves_alone),
        cmocka_unit_test(sides_of_a_pair_count_once),
        cmocka_unit_test(modifiers_tell_the_mechanism),
        cmocka_unit_test(places_of_pivots_in_a_plate),
        cmocka_unit_test(pivot_features_tell_lines_through_it),
        cmocka_unit_test(pivot_features_tell_lines_through_the_middle_too),
        cmocka_unit_test(kind_features_tell_where_an_axis_runs),
        cmocka_unit_test(a_pivot_on_an_edge_counts_and_one_in_the_middle_hardly),
        cmocka_unit_test(a_pivot_says_nothing_of_what_slides_by_name),
        cmocka_unit_test(a_name_tells_slides_from_turns_where_no_drag_does),
        cmocka_unit_test(candidates_through_a_pivot_are_added_once),
        cmocka_unit_test(impossible_candidates_stay_finite),
    };
    return cmocka_run_group_tests(tests, open_lid, close_lid);
}
