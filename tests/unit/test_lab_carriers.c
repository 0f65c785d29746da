/* What the carriers of an asset's bodies are fitted on: one right answer a body, sound features, the same bits for the
 * same seed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "../../training/lab/lab_carriers.h"
#include "assets/asset_models.h"
#include "assets/carrier_features.h"
#include "test_lab.h"
#include "test_world.h"

enum { ASSETS = 12, ROWS = 8000, BODIES = 1000 };

static dm_result (*carriers)(const dm_lab_options*, const void*, size_t, dm_lab_carrier_rows*);
static uint32_t (*columns)(void);

typedef struct batch {
    float features[ROWS][DMI_CARRIER_FEATURES], target[ROWS];
    uint32_t first[BODIES + 1], carried[BODIES], asset[BODIES];
    dm_lab_carrier_rows rows;
} batch;

static batch one, again;
static uint8_t weights[512];

static void make(batch* out, const void* models, size_t size) {
    const dm_lab_options options = {.seed = 5, .count = ASSETS, .categories = weights, .messy = 0.3f};
    memset(out, 0, sizeof *out);
    out->rows = (dm_lab_carrier_rows){
        ROWS, BODIES, &out->features[0][0], out->target, out->first, out->carried, out->asset, 0, 0};
    assert_int_equal(carriers(&options, models, size, &out->rows), DM_OK);
}

/* The trainer takes the last row of a body for what stays. */
static void check(const batch* b) {
    assert_true(b->rows.case_count > ASSETS);
    for (uint32_t i = 0; i < b->rows.case_count; i++) {
        const uint32_t begin = b->first[i], end = b->first[i + 1];
        float right = 0;
        assert_true(begin < end);
        for (uint32_t r = begin; r < end; r++) {
            right += b->target[r];
            for (int k = 0; k < DMI_CARRIER_FEATURES; k++)
                assert_true(fabsf(b->features[r][k]) < 60000); /* fits float16 */
        }
        assert_true(right == 1);
        if (b->carried[i] == DM_LAB_CARRIED_BY_BODY) assert_true(b->target[end - 1] == 1);
    }
}

static void true_bodies_have_one_carrier_each(void** state) {
    (void)state;
    assert_int_equal(columns(), DMI_CARRIER_FEATURES);
    make(&one, NULL, 0);
    check(&one);
    for (uint32_t i = 0; i < one.rows.case_count; i++)
        assert_int_not_equal(one.carried[i], DM_LAB_CARRIED_BY_OTHERS); /* all true bodies are there */
}

static void found_bodies_have_one_carrier_each(void** state) {
    (void)state;
    make(&one, dmi_asset_weights, dmi_asset_weights_size);
    check(&one);
}

static void rows_repeat(void** state) {
    (void)state;
    make(&one, NULL, 0);
    make(&again, NULL, 0);
    assert_int_equal(one.rows.case_count, again.rows.case_count);
    assert_memory_equal(one.features, again.features, sizeof one.features);
    assert_memory_equal(one.target, again.target, sizeof one.target);
}

static int load_lab(void** state) {
    (void)state;
    void* lab = test_open_lab();
    if (lab == NULL) return -1;
    *(void**)&carriers = dlsym(lab, "dm_lab_carriers");
    *(void**)&columns = dlsym(lab, "dm_lab_carrier_columns");
    if (!test_every_category(lab, weights, sizeof weights)) return -1;
    return carriers && columns ? 0 : -1;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(true_bodies_have_one_carrier_each),
        cmocka_unit_test(found_bodies_have_one_carrier_each),
        cmocka_unit_test(rows_repeat),
    };
    return cmocka_run_group_tests(tests, load_lab, NULL);
}
