/* Every feature of a few candidates of a generated part, and what ranker and rules make of them, beside the numbers in
 * tests/golden/data/features.txt: a wrong sign or a swapped column is a failing test, not a silently worse answer.
 *
 *     build/release/tests/test_golden_features --print > tests/golden/data/features.txt   after a change on purpose */
#include "test_env.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "generator.h"
#include "golden.h"
#include "kinematics/features/candidate_features.h"
#include "kinematics/inference/joint_models.h"
#include "math/joint.h"
#include "math/linear3.h"

#define DATA "tests/golden/data/features.txt"
#define TOLERANCE 1e-3f /* absolute for numbers below 1, relative above */

enum { MOST_ROWS = 1 + DMI_DIRECTION_FAMILIES + DMI_ORIGIN_FAMILIES, PROBABILITY = DMI_FEATURE_COUNT, LINES };

static dmi_cloud cloud;
static dmi_part_analysis analysis;
static dmi_candidate candidates[DMI_CANDIDATES_MAX];
static float features[DMI_CANDIDATES_MAX][DMI_FEATURE_COUNT], scores[DMI_CANDIDATES_MAX];
static float by_ranker[DMI_CANDIDATES_MAX], by_rules[DMI_CANDIDATES_MAX];

/* The rows that are compared: a slide, then the first turn of each family of directions and of lines. */
typedef struct sample {
    uint32_t count, rows[MOST_ROWS];
    char names[MOST_ROWS][24];
} sample;

static sample sampled;

static void add(uint32_t count, const char* kind, int bit, int slide, int origin) {
    for (uint32_t i = 0; i < count; i++) {
        const dmi_candidate* c = &candidates[i];
        if ((c->type == DM_JOINT_PRISMATIC) != slide) continue;
        if (!slide && ((origin ? c->origin_families : c->direction_families) >> bit & 1) == 0) continue;
        snprintf(sampled.names[sampled.count], sizeof sampled.names[0], "%s_%d", kind, bit);
        sampled.rows[sampled.count++] = i;
        return;
    }
}

static void choose_rows(uint32_t count) {
    sampled.count = 0;
    add(count, "slide", 0, 1, 0);
    for (int k = 0; k < DMI_DIRECTION_FAMILIES; k++) add(count, "direction", k, 0, 0);
    for (int k = 0; k < DMI_ORIGIN_FAMILIES; k++) add(count, "origin", k, 0, 1);
}

static dmi_mesh* make_mesh(dmi_env* env, const dmg_object* object) {
    dmi_axes axes;
    dmi_mesh* mesh = NULL;
    const dm_mesh_desc desc = {.struct_size = sizeof desc,
                               .positions = object->positions,
                               .vertex_count = object->vertex_count,
                               .indices = object->indices,
                               .index_count = 3 * (uint64_t)object->face_count,
                               .part_ids = object->face_part,
                               .part_id_format = DM_UINT32,
                               .part_id_scope = DM_PER_FACE};
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    assert_int_equal(dmi_mesh_create(env, &axes, &desc, NULL, 0, NULL, &mesh), DM_OK);
    return mesh;
}

/* A drag near the true one, in the mesh's frame. */
static dmi_drag_hint make_hint(const dmi_mesh* mesh, const dmg_object* object, uint32_t part) {
    float point[3], vector[3];
    double at[3];
    dmi_drag_hint hint;
    dmg_drag(object, part, 5, 11, point, vector);
    for (int k = 0; k < 3; k++) at[k] = point[k];
    dmi_frame_point_in(&mesh->frame, at, hint.point);
    dmi_frame_vector_in(&mesh->frame, vector, hint.vector);
    return hint;
}

/* Measures all candidates of part 1 with a drag and made-up answers of KPP-Net. */
static uint32_t measure(test_env* t, const dmi_mesh* mesh, const dmi_drag_hint* hint) {
    const dmi_prediction prediction = {.type = {0.6f, 0.25f, 0.1f, 0.05f},
                                       .turn_axis = {0.1f, 0.994f, 0.03f},
                                       .slide_axis = {0.2f, 0.1f, 0.974f},
                                       .origin = {-0.2f, 0.1f, 0.2f}};
    dmi_arena arena;
    dmi_arena_init(&arena, &t->env, (size_t)1 << 20);
    assert_int_equal(dmi_cloud_sample(&t->env, mesh, 1, 3, &cloud), DM_OK);
    assert_int_equal(dmi_part_analysis_make(&arena, mesh, &cloud, 1, NULL, NULL, &analysis), DM_OK);
    const uint32_t count = dmi_candidates_make(&analysis, hint, &prediction, candidates);
    for (uint32_t i = 0; i < count; i++) scores[i] = -0.37f * (float)(i * 7 % 23);
    dmi_candidate_features_make(&analysis, hint, &prediction, scores, candidates, count, features);
    dmi_arena_release(&arena);
    return count;
}

static void rank(test_env* t, uint32_t count) {
    golden_file file = golden_read("sdk/models/ranker.safetensors");
    dmi_joint_models* models = NULL;
    assert_int_equal(dmi_joint_models_load(&t->env, file.data, file.size, &models), DM_OK);
    dmi_ranker_probabilities(&models->ranker, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])features, count,
                             by_ranker);
    dmi_ranker_probabilities(NULL, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])features, count, by_rules);
    dmi_joint_models_destroy(models);
    free(file.data);
}

/* A number of the table: a feature, or the logarithm of a probability. */
static float value_at(int line, uint32_t column) {
    const uint32_t row = sampled.rows[column];
    if (line < DMI_FEATURE_COUNT) return features[row][line];
    return logf((line == PROBABILITY ? by_ranker : by_rules)[row]);
}

static const char* name_of(int line) {
    return line < DMI_FEATURE_COUNT ? dmi_features[line].name
           : line == PROBABILITY    ? "LOG_PROBABILITY_BY_RANKER"
                                    : "LOG_PROBABILITY_BY_RULES";
}

static void print(uint32_t candidate_count) {
    printf("%u candidates\ncolumn", candidate_count);
    for (uint32_t i = 0; i < sampled.count; i++) printf(" %s", sampled.names[i]);
    for (int line = 0; line <= LINES; line++) {
        printf("\n%s", name_of(line));
        for (uint32_t i = 0; i < sampled.count; i++) printf(" %.5g", (double)value_at(line, i));
    }
    printf("\n");
}

static uint32_t prepare(test_env* t) {
    dmg_object object;
    assert_int_equal(dmg_make((uint32_t)dmg_category_find("kitchen_cabinet"), 7, 0, &object), 0);
    dmi_mesh* mesh = make_mesh(&t->env, &object);
    const dmi_drag_hint hint = make_hint(mesh, &object, 1);
    const uint32_t count = measure(t, mesh, &hint);
    rank(t, count);
    choose_rows(count);
    dmi_mesh_destroy(&t->env, mesh);
    dmg_object_release(&object);
    return count;
}

static char* next_word(char** rest) {
    char* word = strtok(*rest, " \n");
    *rest = NULL;
    assert_non_null(word);
    return word;
}

static void test_rows_are_as_they_were(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    const uint32_t count = prepare(&t);
    golden_file file = golden_read(DATA);
    char* text = malloc(file.size + 1);
    assert_non_null(text);
    memcpy(text, file.data, file.size);
    text[file.size] = 0;
    char* rest = text;
    assert_int_equal(atoi(next_word(&rest)), (int)count);
    assert_string_equal(next_word(&rest), "candidates");
    assert_string_equal(next_word(&rest), "column");
    for (uint32_t i = 0; i < sampled.count; i++) assert_string_equal(next_word(&rest), sampled.names[i]);
    for (int line = 0; line <= LINES; line++) {
        assert_string_equal(next_word(&rest), name_of(line));
        for (uint32_t i = 0; i < sampled.count; i++) {
            const float wanted = strtof(next_word(&rest), NULL), got = value_at(line, i);
            if (fabsf(got - wanted) > TOLERANCE * fmaxf(1, fabsf(wanted)))
                fail_msg("%s of %s is %g, was %g", name_of(line), sampled.names[i], (double)got, (double)wanted);
        }
    }
    free(text);
    free(file.data);
    test_env_close(&t);
}

/* The part has a grip and hardware, and most families suggest something: the rows say something of every group. */
static void test_the_part_has_something_of_everything(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    prepare(&t);
    assert_true(sampled.count >= 20);
    for (int group = 0; group < DMI_GROUP_COUNT; group++) {
        float most = 0;
        for (int k = 0; k < DMI_FEATURE_COUNT; k++)
            for (uint32_t i = 0; i < sampled.count; i++)
                if (dmi_features[k].group == (dmi_feature_group)group) most = fmaxf(most, fabsf(value_at(k, i)));
        if (most == 0) fail_msg("group %d is zero in all rows", group);
    }
    test_env_close(&t);
}

int main(int argc, char** argv) {
    if (argc == 2 && strcmp(argv[1], "--print") == 0) {
        test_env t;
        test_env_open(&t, TEST_NEVER);
        print(prepare(&t));
        test_env_close(&t);
        return 0;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rows_are_as_they_were),
        cmocka_unit_test(test_the_part_has_something_of_everything),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
