/* What lies between matrix products, on every instruction set of this machine, against plain double precision. */
#include "test_env.h"

#include <math.h>

#include "base/random.h"
#include "nn/layers.h"
#include "platform.h"
#include "test_safetensors.h"

#define MAX_COLUMNS 40
#define ROWS ((size_t)5)
#define COUNT (ROWS * MAX_COLUMNS)

static void fill(dmi_random* random, float* values, size_t count) {
    for (size_t i = 0; i < count; ++i) values[i] = 4.0f * dmi_random_unit(random) - 2.0f;
}

static void assert_near(double found, double wanted, double tolerance) {
    if (!(fabs(found - wanted) <= tolerance)) fail_msg("%.9g, expected %.9g", found, wanted);
}

static void all_isas(void (*test)(const dmi_kernels* kernels)) {
    for (dmi_isa isa = DMI_ISA_SCALAR; isa <= DMI_ISA_NEON; ++isa)
        if (dmi_kernels_usable(isa)) test(dmi_kernels_for(isa));
}

/* ---- kernels ------------------------------------------------------------------------------------------------ */

static void normalize_row(const float* x, uint32_t columns, const float* weight, const float* bias, double* out) {
    double mean = 0, variance = 0;
    for (uint32_t c = 0; c < columns; ++c) mean += x[c] / (double)columns;
    for (uint32_t c = 0; c < columns; ++c) variance += (x[c] - mean) * (x[c] - mean) / columns;
    for (uint32_t c = 0; c < columns; ++c) out[c] = (x[c] - mean) / sqrt(variance + 1e-5) * weight[c] + bias[c];
}

static void check_layer_norm(const dmi_kernels* kernels) {
    dmi_random random = dmi_random_make(1, 0);
    for (uint32_t columns = 1; columns <= MAX_COLUMNS; ++columns) {
        float x[COUNT], y[COUNT], weight[MAX_COLUMNS], bias[MAX_COLUMNS];
        double wanted[MAX_COLUMNS];
        fill(&random, x, COUNT);
        fill(&random, weight, columns);
        fill(&random, bias, columns);
        for (uint32_t c = 0; c < columns; ++c) x[c] = 3.0f; /* a row without variance */
        kernels->layer_norm(x, ROWS, columns, weight, bias, y);
        for (size_t r = 0; r < ROWS; ++r) {
            normalize_row(x + r * columns, columns, weight, bias, wanted);
            for (uint32_t c = 0; c < columns; ++c) assert_near(y[r * columns + c], wanted[c], 1e-5);
        }
    }
}

static void check_softmax(const dmi_kernels* kernels) {
    dmi_random random = dmi_random_make(2, 0);
    for (uint32_t columns = 1; columns <= MAX_COLUMNS; ++columns) {
        float x[COUNT + 1], y[COUNT + 1];
        fill(&random, x, COUNT);
        x[0] = 3e38f; /* neither overflows nor gives NaN */
        for (uint32_t c = 1; c < columns; ++c) x[c] = -3e38f;
        y[ROWS * columns] = 7.0f;
        memcpy(y, x, ROWS * columns * sizeof(float));
        kernels->softmax(y, ROWS, columns);
        assert_true(y[ROWS * columns] == 7.0f); /* nothing past the end */
        for (size_t r = 0; r < ROWS; ++r) {
            const float* row = x + r * columns;
            double top = row[0], sum = 0;
            for (uint32_t c = 0; c < columns; ++c) top = fmax(top, row[c]);
            for (uint32_t c = 0; c < columns; ++c) sum += exp(row[c] - top);
            for (uint32_t c = 0; c < columns; ++c) assert_near(y[r * columns + c], exp(row[c] - top) / sum, 1e-6);
        }
    }
}

/* The gate is 1 / (1 + e^-x): to the last digits, over the whole range. */
static void check_gate(const dmi_kernels* kernels) {
    enum { STEPS = 4001 };
    static float x[STEPS], y[STEPS];
    for (int i = 0; i < STEPS; ++i) {
        x[i] = 0.02f * (float)i - 40.0f;
        y[i] = 2.0f;
    }
    kernels->gate(x, STEPS, y);
    for (int i = 0; i < STEPS; ++i) {
        const double wanted = 2 / (1 + exp(-(double)x[i]));
        assert_near(y[i] / wanted, 1.0, 4e-7);
    }
    float extreme[3] = {-1e30f, 1e30f, 0.0f}, gated[3] = {1.0f, 1.0f, 1.0f};
    kernels->gate(extreme, 3, gated);
    assert_near(gated[0], 0.0, 1e-37);
    assert_near(gated[1], 1.0, 0.0);
    assert_near(gated[2], 0.5, 0.0);
}

static void check_columns(const dmi_kernels* kernels) {
    dmi_random random = dmi_random_make(3, 0);
    for (uint32_t columns = 1; columns <= MAX_COLUMNS; ++columns) {
        float x[COUNT], y[COUNT], scale[MAX_COLUMNS], shift[MAX_COLUMNS], most[MAX_COLUMNS], mean[MAX_COLUMNS];
        fill(&random, x, COUNT);
        fill(&random, scale, columns);
        fill(&random, shift, columns);
        memcpy(y, x, sizeof x);
        kernels->modulate(y, ROWS, columns, scale, shift);
        kernels->max_rows(x, ROWS, columns, most);
        kernels->mean_rows(x, ROWS, columns, mean);
        for (uint32_t c = 0; c < columns; ++c) {
            double wanted_most = -1e9, wanted_mean = 0;
            for (uint32_t r = 0; r < ROWS; ++r) {
                const double value = x[r * columns + c];
                assert_near(y[r * columns + c], value * scale[c] + shift[c], 1e-6);
                wanted_most = fmax(wanted_most, value);
                wanted_mean += value / ROWS;
            }
            assert_near(most[c], wanted_most, 0.0);
            assert_near(mean[c], wanted_mean, 1e-6);
        }
        assert_memory_equal(y + ROWS * columns, x + ROWS * columns, (COUNT - ROWS * columns) * sizeof(float));
    }
}

/* ---- transformer layer -------------------------------------------------------------------------------------- */

#define WIDTH 12
#define HEADS 3
#define HIDDEN 20
#define MAX_TOKENS 33

static const struct {
    const char* name;
    uint32_t rows, cols;
} parameters[] = {
    {"a.norm1.weight", WIDTH, 0},      {"a.norm1.bias", WIDTH, 0},          {"a.attn.qkv.weight", 3 * WIDTH, WIDTH},
    {"a.attn.qkv.bias", 3 * WIDTH, 0}, {"a.attn.out.weight", WIDTH, WIDTH}, {"a.attn.out.bias", WIDTH, 0},
    {"a.norm2.weight", WIDTH, 0},      {"a.norm2.bias", WIDTH, 0},          {"a.ff1.weight", HIDDEN, WIDTH},
    {"a.ff1.bias", HIDDEN, 0},         {"a.ff2.weight", WIDTH, HIDDEN},     {"a.ff2.bias", WIDTH, 0},
};
enum { PARAMETERS = sizeof parameters / sizeof parameters[0] };

/* A file of one layer "a" with random numbers; `missing` < PARAMETERS leaves one tensor out. */
static test_file layer_file(int missing) {
    char header[4096] = "{\"__metadata__\":{\"architecture\":\"layer\",\"version\":\"1\"}";
    size_t length = strlen(header), numbers = 0;
    for (int i = 0; i < PARAMETERS; ++i) {
        const uint32_t rows = parameters[i].rows, cols = parameters[i].cols;
        const size_t end = numbers + (size_t)rows * (cols ? cols : 1);
        char shape[32];
        if (i == missing) continue;
        snprintf(shape, sizeof shape, cols ? "%u,%u" : "%u", rows, cols);
        length += (size_t)snprintf(header + length, sizeof header - length,
                                   ",\"%s\":{\"dtype\":\"F32\",\"shape\":[%s],\"data_offsets\":[%zu,%zu]}",
                                   parameters[i].name, shape, 4 * numbers, 4 * end);
        numbers = end;
    }
    snprintf(header + length, sizeof header - length, "}");
    test_file file = test_file_of(header, numbers);
    dmi_random random = dmi_random_make(4, 0);
    for (size_t i = 0; i < numbers; ++i) {
        const float number = 1.4f * dmi_random_unit(&random) - 0.7f;
        memcpy(file.data + file.size - 4 * (numbers - i), &number, sizeof number);
    }
    return file;
}

static void read_layer(dmi_loader* loader, void* network) {
    dmi_load_transformer(loader, "a", WIDTH, HEADS, HIDDEN, network);
}

static double parameter(const dmi_weights* weights, int index, uint32_t row, uint32_t col) {
    float tensor[4 * WIDTH * WIDTH]; /* the largest */
    const uint32_t rows = parameters[index].rows, cols = parameters[index].cols;
    assert_true(rows * (cols ? cols : 1) <= sizeof tensor / sizeof *tensor);
    assert_true(dmi_weights_read(weights, parameters[index].name, rows, cols, tensor, NULL));
    return tensor[row * (cols ? cols : 1) + col];
}

/* y = W x + b with the tensors `index` and `index` + 1. */
static void plain_linear(const dmi_weights* weights, int index, const double* x, double* y) {
    for (uint32_t o = 0; o < parameters[index].rows; ++o) {
        y[o] = parameter(weights, index + 1, o, 0);
        for (uint32_t i = 0; i < parameters[index].cols; ++i) y[o] += parameter(weights, index, o, i) * x[i];
    }
}

static void plain_norm(const dmi_weights* weights, int index, const double* x, double* y) {
    float row[WIDTH], weight[WIDTH], bias[WIDTH];
    for (uint32_t c = 0; c < WIDTH; ++c) {
        row[c] = (float)x[c];
        weight[c] = (float)parameter(weights, index, c, 0);
        bias[c] = (float)parameter(weights, index + 1, c, 0);
    }
    normalize_row(row, WIDTH, weight, bias, y);
}

/* mixed = softmax(q k / sqrt(d)) v for one head of one token. */
static void plain_attention(double (*qkv)[3 * WIDTH], uint32_t tokens, uint32_t token, uint32_t head, double* mixed) {
    const uint32_t size = WIDTH / HEADS, first = head * size;
    double scores[MAX_TOKENS], sum = 0;
    for (uint32_t t = 0; t < tokens; ++t) {
        scores[t] = 0;
        for (uint32_t i = 0; i < size; ++i) scores[t] += qkv[token][first + i] * qkv[t][WIDTH + first + i];
        scores[t] = exp(scores[t] / sqrt(size));
        sum += scores[t];
    }
    for (uint32_t i = 0; i < size; ++i) mixed[first + i] = 0;
    for (uint32_t t = 0; t < tokens; ++t)
        for (uint32_t i = 0; i < size; ++i) mixed[first + i] += scores[t] / sum * qkv[t][2 * WIDTH + first + i];
}

static void plain_layer(const dmi_weights* weights, uint32_t tokens, double (*x)[WIDTH]) {
    static double qkv[MAX_TOKENS][3 * WIDTH];
    double normal[WIDTH], mixed[WIDTH], step[WIDTH], hidden[HIDDEN];
    for (uint32_t t = 0; t < tokens; ++t) {
        plain_norm(weights, 0, x[t], normal);
        plain_linear(weights, 2, normal, qkv[t]);
    }
    for (uint32_t t = 0; t < tokens; ++t) {
        for (uint32_t h = 0; h < HEADS; ++h) plain_attention(qkv, tokens, t, h, mixed);
        plain_linear(weights, 4, mixed, step);
        for (uint32_t c = 0; c < WIDTH; ++c) x[t][c] += step[c];
        plain_norm(weights, 6, x[t], normal);
        plain_linear(weights, 8, normal, hidden);
        for (uint32_t i = 0; i < HIDDEN; ++i) hidden[i] = fmax(hidden[i], 0);
        plain_linear(weights, 10, hidden, step);
        for (uint32_t c = 0; c < WIDTH; ++c) x[t][c] += step[c];
    }
}

static void check_tokens(const dmi_kernels* kernels, const dmi_transformer* layer, const dmi_weights* weights,
                         uint32_t tokens) {
    static double wanted[MAX_TOKENS][WIDTH];
    float found[MAX_TOKENS * WIDTH];
    dmi_random random = dmi_random_make(tokens, 0);
    fill(&random, found, sizeof found / sizeof found[0]);
    for (uint32_t i = 0; i < tokens * WIDTH; ++i) wanted[i / WIDTH][i % WIDTH] = found[i];
    const size_t size = dmi_transformer_scratch(tokens, WIDTH, HEADS, HIDDEN) * sizeof(float);
    float* scratch = platform_allocate(size, 64);
    memset(scratch, 0xff, size); /* NaN */
    dmi_transformer_apply(layer, kernels, tokens, found, scratch);
    plain_layer(weights, tokens, wanted);
    for (uint32_t i = 0; i < tokens * WIDTH; ++i) assert_near(found[i], wanted[i / WIDTH][i % WIDTH], 2e-5);
    platform_release(scratch);
}

static void transformer_layer(void** state) {
    (void)state;
    test_env t;
    dmi_arena arena;
    dmi_transformer layer;
    dmi_weights* weights = NULL;
    test_file file = layer_file(PARAMETERS);
    test_env_open(&t, TEST_NEVER);
    dmi_arena_init(&arena, &t.env, 1024);
    assert_int_equal(dmi_load_network(&t.env, file.data, file.size, "layer", read_layer, &layer, &arena), DM_OK);
    assert_int_equal(dmi_weights_open(&t.env, file.data, file.size, "layer", 1, &weights), DM_OK);
    for (dmi_isa isa = DMI_ISA_SCALAR; isa <= DMI_ISA_NEON; ++isa)
        for (uint32_t tokens = 1; dmi_kernels_usable(isa) && tokens <= MAX_TOKENS; tokens += 8)
            check_tokens(dmi_kernels_for(isa), &layer, weights, tokens);
    dmi_weights_close(weights);
    dmi_arena_release(&arena);
    test_env_close(&t);
    free(file.data);
}

/* ---- loading ------------------------------------------------------------------------------------------------ */

static dm_result load_layer(test_file file, int64_t fail_at) {
    test_env t;
    dmi_arena arena;
    dmi_transformer layer;
    test_env_open(&t, fail_at);
    dmi_arena_init(&arena, &t.env, 1024);
    const dm_result result = dmi_load_network(&t.env, file.data, file.size, "layer", read_layer, &layer, &arena);
    if (result == DM_OK) dmi_arena_release(&arena);
    if (result != DM_OK) assert_true(t.messages.count > 0);
    test_env_close(&t);
    return result;
}

static void a_missing_tensor_is_an_error(void** state) {
    (void)state;
    for (int missing = 0; missing < PARAMETERS; ++missing) {
        test_file file = layer_file(missing);
        assert_int_equal(load_layer(file, TEST_NEVER), DM_ERROR_BAD_DATA);
        free(file.data);
    }
}

static void a_number_that_is_none_is_an_error(void** state) {
    (void)state;
    const float nan_number = NAN;
    test_file file = layer_file(PARAMETERS);
    memcpy(file.data + file.size - sizeof nan_number, &nan_number, sizeof nan_number);
    assert_int_equal(load_layer(file, TEST_NEVER), DM_ERROR_BAD_DATA);
    free(file.data);
}

static void any_allocation_may_fail(void** state) {
    (void)state;
    test_file file = layer_file(PARAMETERS);
    int64_t fail_at = 0;
    while (load_layer(file, fail_at) == DM_ERROR_OUT_OF_MEMORY) fail_at++;
    assert_int_equal(load_layer(file, fail_at), DM_OK);
    assert_true(fail_at > 5);
    free(file.data);
}

static void layer_norm(void** state) {
    (void)state;
    all_isas(check_layer_norm);
}

static void softmax(void** state) {
    (void)state;
    all_isas(check_softmax);
}

static void gate(void** state) {
    (void)state;
    all_isas(check_gate);
}

static void column_by_column(void** state) {
    (void)state;
    all_isas(check_columns);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layer_norm),
        cmocka_unit_test(softmax),
        cmocka_unit_test(gate),
        cmocka_unit_test(column_by_column),
        cmocka_unit_test(transformer_layer),
        cmocka_unit_test(a_missing_tensor_is_an_error),
        cmocka_unit_test(a_number_that_is_none_is_an_error),
        cmocka_unit_test(any_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
