/* What the part finder is fitted on: labels of both kinds, sound features, the same bits for the same seed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../training/lab/lab_growth.h"
#include "segmentation/proposals.h"
#include "segmentation/region_growing.h"
#include "test_lab.h"
#include "test_world.h"

enum { CASES = 12, ROWS = 16000 };

static dm_result (*growth_batch)(const dm_lab_options*, const dm_lab_growth*);
static dm_result (*choice_batch)(const dm_lab_options*, const void*, size_t, const dm_lab_choice*);
static uint32_t (*growth_columns)(void), (*choice_columns)(void), (*choice_most)(void);

static struct {
    float features[ROWS][DMI_NEIGHBOUR_FEATURES], belongs[ROWS], weight[ROWS];
    int32_t category[ROWS];
    uint32_t count;
} growth, growth_again;

static struct {
    float features[CASES][DMI_MAX_PROPOSALS][DMI_PROPOSAL_FEATURES], overlap[CASES][DMI_MAX_PROPOSALS];
    int32_t used[CASES], category[CASES];
} choice, choice_again;

static uint8_t weights[512];

static dm_lab_options options_of(uint64_t seed) {
    return (dm_lab_options){.seed = seed,
                            .count = CASES,
                            .categories = weights,
                            .messy = 0.5f,
                            .rotated = 1,
                            .with_drag = 1,
                            .drag_noise_degrees = 8};
}

static void test_pieces_repeat_and_are_of_both_kinds(void** state) {
    (void)state;
    __typeof__(growth)* both[2] = {&growth, &growth_again};
    for (int i = 0; i < 2; i++) {
        const dm_lab_options options = options_of(3);
        const dm_lab_growth out = {
            ROWS, &both[i]->features[0][0], both[i]->belongs, both[i]->weight, both[i]->category, &both[i]->count};
        assert_int_equal(growth_batch(&options, &out), DM_OK);
    }
    assert_int_equal(growth_columns(), DMI_NEIGHBOUR_FEATURES);
    assert_memory_equal(&growth, &growth_again, sizeof growth);
    uint32_t belong = 0;
    assert_true(growth.count > 50);
    for (uint32_t r = 0; r < growth.count; r++) {
        belong += growth.belongs[r] > 0.5f;
        for (int k = 0; k < DMI_NEIGHBOUR_FEATURES; k++) assert_true(isfinite(growth.features[r][k]));
    }
    assert_true(belong > 0 && belong < growth.count);
}

static void test_proposals_repeat_and_some_are_the_part(void** state) {
    (void)state;
    size_t size;
    void* networks = test_read_file("sdk/models/part_finder.safetensors", &size);
    __typeof__(choice)* both[2] = {&choice, &choice_again};
    for (int i = 0; i < 2; i++) {
        const dm_lab_options options = options_of(5);
        const dm_lab_choice out = {&both[i]->features[0][0][0], &both[i]->overlap[0][0], both[i]->used,
                                   both[i]->category};
        assert_int_equal(choice_batch(&options, networks, size, &out), DM_OK);
    }
    free(networks);
    assert_int_equal(choice_columns(), DMI_PROPOSAL_FEATURES);
    assert_int_equal(choice_most(), DMI_MAX_PROPOSALS);
    assert_memory_equal(&choice, &choice_again, sizeof choice);
    int found = 0;
    for (int c = 0; c < CASES; c++) {
        for (int i = 0; i < choice.used[c]; i++) {
            assert_true(choice.overlap[c][i] >= 0 && choice.overlap[c][i] <= 1.0001f);
            found += choice.overlap[c][i] > 0.8f;
            for (int k = 0; k < DMI_PROPOSAL_FEATURES; k++) assert_true(isfinite(choice.features[c][i][k]));
        }
    }
    assert_true(found > 0);
}

static void test_weights_of_another_architecture_are_refused(void** state) {
    (void)state;
    const dm_lab_options options = options_of(5);
    const dm_lab_choice out = {NULL, NULL, NULL, NULL};
    size_t size;
    void* other = test_read_file("sdk/models/kpp_net.safetensors", &size);
    assert_int_equal(choice_batch(&options, other, size, &out), DM_ERROR_WRONG_MODEL);
    free(other);
}

static int load_lab(void** state) {
    (void)state;
    void* lab = test_open_lab();
    if (lab == NULL) return -1;
    *(void**)&growth_batch = dlsym(lab, "dm_lab_growth_batch");
    *(void**)&choice_batch = dlsym(lab, "dm_lab_choice_batch");
    *(void**)&growth_columns = dlsym(lab, "dm_lab_growth_columns");
    *(void**)&choice_columns = dlsym(lab, "dm_lab_choice_columns");
    *(void**)&choice_most = dlsym(lab, "dm_lab_choice_most");
    if (!test_every_category(lab, weights, sizeof weights)) return -1;
    return growth_batch && choice_batch && growth_columns && choice_columns && choice_most ? 0 : -1;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pieces_repeat_and_are_of_both_kinds),
        cmocka_unit_test(test_proposals_repeat_and_some_are_the_part),
        cmocka_unit_test(test_weights_of_another_architecture_are_refused),
    };
    return cmocka_run_group_tests(tests, load_lab, NULL);
}
