/* The matrix product of every instruction set of this machine against a plain one in double precision. */
#include "test_env.h"

#include <math.h>

#include "base/random.h"
#include "nn/kernels.h"

#define MAX_ROWS 40
#define MAX_DEPTH 100
#define MAX_COLUMNS 150
#define UNTOUCHED 12345.0f
#define TOLERANCE 1e-5

static float weights[MAX_COLUMNS * MAX_DEPTH], bias[MAX_COLUMNS + DMI_PANEL];
static float x[MAX_ROWS * (MAX_DEPTH + 5)], before[MAX_ROWS * (MAX_COLUMNS + 5)], y[MAX_ROWS * (MAX_COLUMNS + 5)];
static _Alignas(64) float panels[(MAX_COLUMNS + DMI_PANEL) * MAX_DEPTH];

static void fill(dmi_random* random, float* values, size_t count) {
    for (size_t i = 0; i < count; ++i) values[i] = 2.0f * dmi_random_unit(random) - 1.0f;
}

static double expected(const dmi_gemm* gemm, uint32_t row, uint32_t column) {
    double sum = gemm->bias ? gemm->bias[column] : 0.0;
    for (uint32_t k = 0; k < gemm->depth; ++k)
        sum += (double)gemm->x[row * gemm->x_stride + k] * weights[column * gemm->depth + k];
    if (gemm->flags & DMI_GEMM_RELU) sum = sum > 0 ? sum : 0;
    return gemm->flags & DMI_GEMM_ADD ? sum + before[row * gemm->y_stride + column] : sum;
}

/* Every number of y: the product where it belongs, nothing anywhere else. */
static void check(const dmi_kernels* kernels, const dmi_gemm* gemm) {
    const size_t size = sizeof y / sizeof y[0];
    memcpy(y, before, sizeof y);
    kernels->gemm(gemm);
    for (size_t i = 0; i < size; ++i) {
        const uint32_t row = (uint32_t)(i / gemm->y_stride), column = (uint32_t)(i % gemm->y_stride);
        const int inside = row < gemm->rows && column < gemm->columns;
        const double wanted = inside ? expected(gemm, row, column) : before[i];
        if (!(fabs(y[i] - wanted) <= (inside ? TOLERANCE : 0.0)))
            fail_msg("%u x %u x %u, flags %u, [%u][%u]: %g, expected %g", gemm->rows, gemm->depth, gemm->columns,
                     gemm->flags, row, column, (double)y[i], wanted);
    }
}

static void check_shape(const dmi_kernels* kernels, dmi_random* random, uint32_t rows, uint32_t depth,
                        uint32_t columns) {
    const uint32_t gap = dmi_random_u32(random) % 5;
    fill(random, weights, (size_t)columns * depth);
    fill(random, bias, dmi_padded_columns(columns)); /* the padding's bias too: it must not show */
    fill(random, x, sizeof x / sizeof x[0]);
    fill(random, before, sizeof before / sizeof before[0]);
    for (size_t i = 0; i < dmi_panels_size(columns, depth); ++i) panels[i] = UNTOUCHED;
    dmi_panels_pack(weights, depth, 1, columns, depth, panels);
    for (uint32_t flags = 0; flags < 4; ++flags)
        check(kernels, &(dmi_gemm){x, panels, flags & 1 || rows % 2 ? bias : NULL, y, depth + gap, columns + gap, rows,
                                   depth, columns, flags});
}

static void all_isas(void (*test)(const dmi_kernels* kernels)) {
    for (dmi_isa isa = DMI_ISA_SCALAR; isa <= DMI_ISA_NEON; ++isa)
        if (dmi_kernels_usable(isa)) test(dmi_kernels_for(isa));
}

static void check_rows_and_tails(const dmi_kernels* kernels) {
    dmi_random random = dmi_random_make(1, 0);
    for (uint32_t rows = 1; rows <= 20; ++rows)
        for (uint32_t columns = 1; columns <= 36; columns += rows < 3 ? 1 : 7)
            check_shape(kernels, &random, rows, 7, columns);
}

static void check_one_row(const dmi_kernels* kernels) {
    dmi_random random = dmi_random_make(2, 0);
    for (uint32_t columns = 1; columns <= MAX_COLUMNS; columns += 3) check_shape(kernels, &random, 1, 11, columns);
}

static void check_random_shapes(const dmi_kernels* kernels) {
    dmi_random random = dmi_random_make(3, 0);
    for (int i = 0; i < 25; ++i) {
        const uint32_t rows = 1 + dmi_random_u32(&random) % MAX_ROWS;
        const uint32_t depth = 1 + dmi_random_u32(&random) % MAX_DEPTH;
        check_shape(kernels, &random, rows, depth, 1 + dmi_random_u32(&random) % MAX_COLUMNS);
    }
}

static void check_nothing_to_do(const dmi_kernels* kernels) {
    dmi_random random = dmi_random_make(4, 0);
    check_shape(kernels, &random, 0, 5, 20);
    check_shape(kernels, &random, 3, 0, 20); /* a sum of nothing: the bias */
    check_shape(kernels, &random, 1, 0, 20);
}

static void rows_and_tails(void** state) {
    (void)state;
    all_isas(check_rows_and_tails);
}

static void one_row(void** state) {
    (void)state;
    all_isas(check_one_row);
}

static void random_shapes(void** state) {
    (void)state;
    all_isas(check_random_shapes);
}

static void nothing_to_do(void** state) {
    (void)state;
    all_isas(check_nothing_to_do);
}

static void packing_takes_strides(void** state) {
    (void)state;
    enum { COLUMNS = 18, DEPTH = 3 };
    _Alignas(64) float straight[2 * DMI_PANEL * DEPTH], across[2 * DMI_PANEL * DEPTH];
    float transposed[DEPTH * COLUMNS];
    dmi_random random = dmi_random_make(5, 0);
    fill(&random, weights, (size_t)COLUMNS * DEPTH);
    for (int j = 0; j < COLUMNS; ++j)
        for (int k = 0; k < DEPTH; ++k) transposed[k * COLUMNS + j] = weights[j * DEPTH + k];
    assert_int_equal(dmi_panels_size(COLUMNS, DEPTH), sizeof straight / sizeof straight[0]);
    dmi_panels_pack(weights, DEPTH, 1, COLUMNS, DEPTH, straight);
    dmi_panels_pack(transposed, 1, COLUMNS, COLUMNS, DEPTH, across);
    assert_memory_equal(straight, across, sizeof straight);
    assert_true(straight[DEPTH * DMI_PANEL + 1] == weights[(size_t)17 * DEPTH]); /* panel 1, k 0, output 17 */
    assert_true(straight[DEPTH * DMI_PANEL + 2] == 0.0f);                        /* padding */
}

static void unknown_sets_fall_back(void** state) {
    (void)state;
    assert_ptr_equal(dmi_kernels_for((dmi_isa)99), &dmi_kernels_scalar);
    assert_true(dmi_kernels_usable(DMI_ISA_SCALAR));
    assert_false(dmi_kernels_usable((dmi_isa)99));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_and_tails),        cmocka_unit_test(one_row),
        cmocka_unit_test(random_shapes),         cmocka_unit_test(nothing_to_do),
        cmocka_unit_test(packing_takes_strides), cmocka_unit_test(unknown_sets_fall_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
