/* What the training of the limits sees: joints signed as the library signs them, ranges that hold the rest. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>

#include "../../training/lab/lab_limits.h"
#include "kinematics/limits/limits.h"
#include "test_lab.h"
#include "test_world.h"

enum { COUNT = 120, MOST_CATEGORIES = 1024 };

static dm_result (*limits_batch)(const dm_lab_options*, const void*, size_t, const void*, size_t, const dm_lab_limits*);
static uint8_t every[MOST_CATEGORIES];

static struct {
    float features[COUNT][DMI_LIMIT_FEATURES], candidate[COUNT][DMI_FEATURE_COUNT];
    float lower[COUNT], upper[COUNT], pose[COUNT];
    int32_t free[COUNT], category[COUNT], has_drag[COUNT];
} made;

static int load_lab(void** state) {
    (void)state;
    void* lab = test_open_lab();
    if (lab == NULL) return -1;
    *(void**)&limits_batch = dlsym(lab, "dm_lab_limits_batch");
    if (!test_every_category(lab, every, sizeof every)) return -1;
    uint32_t (*columns)(void), (*candidate_columns)(void);
    *(void**)&columns = dlsym(lab, "dm_lab_limits_columns");
    *(void**)&candidate_columns = dlsym(lab, "dm_lab_limits_candidate_columns");
    return columns() != DMI_LIMIT_FEATURES || candidate_columns() != DMI_FEATURE_COUNT;
}

static void make_cases(float with_drag) {
    const dm_lab_options options = {.seed = 21,
                                    .count = COUNT,
                                    .categories = every,
                                    .messy = 0.5f,
                                    .rotated = 1,
                                    .with_drag = with_drag,
                                    .drag_noise_degrees = 8};
    const dm_lab_limits out = {made.features[0], made.candidate[0], made.lower, made.upper,
                               made.free,        made.category,     made.pose,  made.has_drag};
    size_t size;
    void* kinematics = test_read_file("sdk/models/kpp_net.safetensors", &size);
    assert_int_equal(limits_batch(&options, kinematics, size, NULL, 0, &out), DM_OK);
    free(kinematics);
}

static void ranges_hold_the_rest(void** state) {
    (void)state;
    make_cases(0.5f);
    int near = 0;
    for (int i = 0; i < COUNT; i++) {
        const int holds = made.lower[i] <= 1e-4f && made.upper[i] >= -1e-4f && made.lower[i] < made.upper[i];
        assert_true(holds || made.free[i]);
        assert_true((made.candidate[i][DMI_FEATURE_PRISMATIC] > 0.5f) == (made.features[i][0] > 0.5f));
        assert_true((made.features[i][1] > 0.5f) == (made.has_drag[i] != 0));
        near += made.pose[i] < 0.02f;
    }
    assert_true(near > 9 * COUNT / 10);
}

/* Where no drag signs a joint, the side with more room is positive, and not the one that truly opens: the library does
 * not know that one. */
static void without_a_drag_room_signs_the_joint(void** state) {
    (void)state;
    make_cases(0);
    int more_room = 0;
    for (int i = 0; i < COUNT; i++) {
        const float* reach = made.features[i] + 2; /* up and down, at two thresholds each */
        more_room += reach[0] + reach[1] + reach[2] + reach[3] >= -1e-3f;
    }
    assert_true(more_room > 9 * COUNT / 10);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ranges_hold_the_rest),
        cmocka_unit_test(without_a_drag_room_signs_the_joint),
    };
    return cmocka_run_group_tests(tests, load_lab, NULL);
}
