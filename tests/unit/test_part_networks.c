/* The part finder's networks: the embedded weights are the shipped file, and any number of rows at a time gives the
 * same answers. */
#include "test_env.h"

#include <math.h>
#include <string.h>

#include "segmentation/part_networks.h"
#include "segmentation/proposals.h"
#include "segmentation/region_growing.h"
#include "test_world.h"

enum { ROWS = 100 };

static void read_growth(dmi_loader* loader, void* network) {
    dmi_part_growth_read(loader, network);
}

static void read_choice(dmi_loader* loader, void* network) {
    dmi_part_choice_read(loader, network);
}

static void test_the_embedded_weights_are_the_shipped_file(void** state) {
    (void)state;
    size_t size;
    void* file = test_read_file("sdk/models/part_finder.safetensors", &size);
    assert_int_equal(size, dmi_part_finder_weights_size);
    assert_memory_equal(file, dmi_part_finder_weights, size);
    assert_int_equal((uintptr_t)dmi_part_finder_weights % 64, 0);
    free(file);
}

/* Loads a network and compares rows one by one with all of them at once. */
static void check_rows(dmi_read_network* read, uint32_t inputs) {
    test_env t;
    dmi_arena keep;
    dmi_perceptron network;
    float rows[ROWS * DMI_PROPOSAL_FEATURES], together[ROWS], alone;
    test_env_open(&t, TEST_NEVER);
    dmi_arena_init(&keep, &t.env, 65536);
    assert_int_equal(dmi_load_network(&t.env, dmi_part_finder_weights, dmi_part_finder_weights_size,
                                      DMI_PART_FINDER_ARCHITECTURE, read, &network, &keep),
                     DM_OK);
    assert_int_equal(network.layers[0].inputs, inputs);
    for (uint32_t i = 0; i < ROWS * inputs; i++) rows[i] = sinf((float)i);
    dmi_part_network_apply(&network, DMI_ISA_SCALAR, rows, ROWS, together);
    for (uint32_t r = 0; r < ROWS; r++) {
        dmi_part_network_apply(&network, DMI_ISA_SCALAR, rows + r * inputs, 1, &alone);
        assert_float_equal(alone, together[r], 1e-4f);
    }
    assert_true(fabsf(together[0] - together[1]) > 1e-3f);
    dmi_arena_release(&keep);
    test_env_close(&t);
}

static void test_rows_are_rated_alike_in_any_number(void** state) {
    (void)state;
    check_rows(read_growth, DMI_NEIGHBOUR_FEATURES);
    check_rows(read_choice, DMI_PROPOSAL_FEATURES);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_embedded_weights_are_the_shipped_file),
        cmocka_unit_test(test_rows_are_rated_alike_in_any_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
