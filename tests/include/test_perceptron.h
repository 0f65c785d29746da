/* Perceptrons with chosen weights, for tests of what is made of a network's answer. */
#ifndef DM_TEST_PERCEPTRON_H
#define DM_TEST_PERCEPTRON_H

#include <stdlib.h>

#include "nn/layers.h"
#include "test_env.h"

/* Where the layers live. */
typedef struct test_layers {
    dmi_arena keep, spare;
    dmi_loader loader;
} test_layers;

static inline void test_layers_open(test_layers* layers, dmi_env* env) {
    dmi_arena_init(&layers->keep, env, 65536);
    dmi_arena_init(&layers->spare, env, 65536);
    layers->loader = (dmi_loader){env, NULL, &layers->keep, &layers->spare, DM_OK};
}

static inline void test_layers_close(test_layers* layers) {
    dmi_arena_release(&layers->keep);
    dmi_arena_release(&layers->spare);
}

/* One layer y = W x + b. weight NULL: zeros. */
static inline dmi_linear test_layer(test_layers* layers, const float* weight, const float* bias, uint32_t inputs,
                                    uint32_t outputs) {
    dmi_linear out;
    float* zeros = calloc((size_t)inputs * outputs, sizeof *zeros);
    assert_non_null(zeros);
    dmi_pack_linear(&layers->loader, weight != NULL ? weight : zeros, inputs, bias, inputs, outputs, &out);
    assert_int_equal(layers->loader.result, DM_OK);
    free(zeros);
    return out;
}

#endif
