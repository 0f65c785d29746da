/* Farthest-point sampling equals brute force on random points, on lattices with many ties, on coincident points. */
#include "test_env.h"

#include <math.h>

#include "base/random.h"
#include "kinematics/kpp/kpp_input.h"

#define GROUPS 40

static float xyz[3][DMI_KPP_POINTS];

static float square_distance(uint32_t a, uint32_t b) {
    const float x = xyz[0][b] - xyz[0][a], y = xyz[1][b] - xyz[1][a], z = xyz[2][b] - xyz[2][a];
    return x * x + y * y + z * z;
}

/* Checks that the m-th member has exactly m points before it in the order by distance, then index. */
static void check_members(uint32_t centre, uint32_t count, const uint32_t members[DMI_KPP_GROUP]) {
    assert_int_equal(members[0], centre);
    for (uint32_t m = 1; m < DMI_KPP_GROUP; m++) {
        const float own = square_distance(centre, members[m]);
        uint32_t before = 1;
        for (uint32_t i = 0; i < count; i++) {
            const float d = square_distance(centre, i);
            before += i != centre && (d < own || (d == own && i < members[m]));
        }
        assert_int_equal(before, m);
    }
}

static uint32_t farthest_from(const uint32_t* centres, uint32_t centre_count, uint32_t count) {
    uint32_t best = 0;
    float most = -1;
    for (uint32_t i = 0; i < count; i++) {
        float least = INFINITY;
        for (uint32_t c = 0; c < centre_count; c++) least = fminf(least, square_distance(centres[c], i));
        if (least > most) most = least, best = i;
    }
    return best;
}

static void groups_equal_brute_force(void** state) {
    (void)state;
    static const uint32_t counts[4] = {DMI_FPS_POINT_STEP, 96, 512, DMI_KPP_POINTS};
    dmi_random random = dmi_random_make(4, 1);
    for (int kind = 0; kind < 3; kind++)
        for (int n = 0; n < 4; n++) {
            for (int k = 0; k < 3; k++)
                for (uint32_t i = 0; i < counts[n]; i++) {
                    const float x = dmi_random_unit(&random);
                    xyz[k][i] = kind == 0 ? x : kind == 1 ? floorf(6 * x) : 0.25f;
                }
            dmi_fps sampling;
            dmi_fps_begin(xyz[0], xyz[1], xyz[2], counts[n], &sampling);
            uint32_t centres[GROUPS + 1] = {0};
            for (uint32_t g = 0; g < GROUPS; g++) {
                uint32_t members[DMI_KPP_GROUP];
                centres[g + 1] = dmi_fps_next(&sampling, centres[g], members);
                check_members(centres[g], counts[n], members);
                assert_int_equal(centres[g + 1], farthest_from(centres, g + 1, counts[n]));
            }
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(groups_equal_brute_force)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
