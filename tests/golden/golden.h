/* Files of expected answers (tests/golden/make_golden.py) and the comparison with them. */
#ifndef DM_GOLDEN_H
#define DM_GOLDEN_H

#include <math.h>
#include <stdio.h>

#include "nn/kernels.h"
#include "nn/weights.h"
#include "test_env.h"

#define GOLDEN_TOLERANCE 1e-4f

typedef struct golden_file {
    void* data;
    size_t size;
} golden_file;

/* Programs run with the repository's root as working directory. */
static inline golden_file golden_read(const char* path) {
    golden_file file = {NULL, 0};
    FILE* stream = fopen(path, "rb");
    if (!stream) fail_msg("can't open %s", path);
    fseek(stream, 0, SEEK_END);
    file.size = (size_t)ftell(stream);
    rewind(stream);
    file.data = malloc(file.size);
    assert_non_null(file.data);
    assert_int_equal(fread(file.data, 1, file.size, stream), file.size);
    fclose(stream);
    return file;
}

static inline void golden_copy(const dmi_weights* golden, const char* name, uint32_t rows, uint32_t cols, void* out) {
    const float* values = dmi_weights_find(golden, name, rows, cols);
    if (!values) fail_msg("no tensor %s of %u x %u", name, rows, cols);
    memcpy(out, (const void*)values, (size_t)rows * (cols ? cols : 1) * sizeof(float));
}

/* Largest difference of `found` from the golden tensor; fails when above the tolerance. */
static inline void golden_compare(const dmi_weights* golden, const char* name, uint32_t rows, uint32_t cols,
                                  const float* found, float tolerance, const char* where) {
    const uint32_t count = rows * (cols ? cols : 1);
    float expected[DM_MOTION_FRAMES * 16], worst = 0.0f;
    assert_true(count <= sizeof expected / sizeof expected[0]);
    golden_copy(golden, name, rows, cols, expected);
    for (uint32_t i = 0; i < count; ++i) {
        const float difference = fabsf(found[i] - expected[i]);
        if (!(difference <= tolerance))
            fail_msg("%s: %s[%u] is %g, expected %g", where, name, i, (double)found[i], (double)expected[i]);
        worst = fmaxf(worst, difference);
    }
    print_message("%s: %s differs by %.2g at most\n", where, name, (double)worst);
}

#endif
