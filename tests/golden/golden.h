/* Files of expected answers (tests/golden/make_golden.py) and the comparison with them. */
#ifndef DM_GOLDEN_H
#define DM_GOLDEN_H

#include <math.h>
#include <stdio.h>

#include "nn/kernels.h"
#include "nn/weights.h"
#include "test_env.h"
#include "test_hash.h"

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

/* Opens a file of answers, which must be of these weights. */
static inline dmi_weights* golden_open(dmi_env* env, golden_file answers, const char* architecture,
                                       golden_file weights) {
    dmi_weights* golden = NULL;
    const uint64_t hash = test_hash_bytes(TEST_HASH_START, weights.data, weights.size);
    char mark[17];
    snprintf(mark, sizeof mark, "%016llx", (unsigned long long)hash);
    assert_int_equal(dmi_weights_open(env, answers.data, answers.size, architecture, 1, &golden), DM_OK);
    const char* made_with = dmi_weights_metadata(golden, "weights");
    if (!made_with || strcmp(made_with, mark) != 0)
        fail_msg("answers of other weights: run tests/golden/make_golden.py");
    return golden;
}

static inline void golden_copy(const dmi_weights* golden, const char* name, uint32_t rows, uint32_t cols, void* out) {
    memset(out, 0, (size_t)rows * (cols ? cols : 1) * sizeof(float));
    if (!dmi_weights_read(golden, name, rows, cols, out, NULL)) fail_msg("no tensor %s of %u x %u", name, rows, cols);
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

/* Loads and destroys a network. */
typedef dm_result golden_loader(dmi_env* env, const void* data, size_t size);

static inline dm_result golden_load(golden_loader* loader, golden_file file, int64_t fail_at) {
    test_env t;
    test_env_open(&t, fail_at);
    const dm_result result = loader(&t.env, file.data, file.size);
    assert_int_equal(t.messages.count > 0, result != DM_OK);
    test_env_close(&t);
    return result;
}

/* Loading fails by name, leaking nothing: without memory, without one of its layers, with another network's file. */
static inline void golden_check_loading(golden_loader* loader, const char* own, const char* other, const char* layer) {
    golden_file file = golden_read(own), foreign = golden_read(other);
    int64_t fail_at = 0;
    while (golden_load(loader, file, fail_at) == DM_ERROR_OUT_OF_MEMORY) fail_at++;
    assert_int_equal(golden_load(loader, file, fail_at), DM_OK);
    assert_int_equal(golden_load(loader, foreign, TEST_NEVER), DM_ERROR_WRONG_MODEL);
    char* name = memmem(file.data, file.size, layer, strlen(layer));
    assert_non_null(name);
    *name = '?';
    assert_int_equal(golden_load(loader, file, TEST_NEVER), DM_ERROR_BAD_DATA);
    free(file.data);
    free(foreign.data);
}

#endif
