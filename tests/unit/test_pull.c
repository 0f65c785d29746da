/* The pulls of training cases (training/lab/pull.c): each kind pulls the way it says, from the part's surface, and the
 * joint is signed along it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "../../training/lab/augment_case.c" /* NOLINT: without the lab's library round them */
#include "../../training/lab/case.c"         /* NOLINT */
#include "../../training/lab/pull.c"         /* NOLINT */
#include "../../training/lab/random.c"       /* NOLINT */

enum { CASES = 150 };

static dmi_env env;
static uint8_t everything[512];

static int set_up(void** state) {
    (void)state;
    dmi_env_init(&env, NULL, NULL, NULL);
    for (uint32_t row = 0; row < dmg_category_count(); row++) everything[dmg_category_id(row)] = 1;
    return 0;
}

typedef struct pulled {
    dm_joint joint;
    dmi_drag_hint hint;
    float tangent[3], way[3]; /* unit: in which the grabbed point starts to move, and of the pull */
    float cosine;             /* between them */
    float reach;              /* of the grabbed point, over the part's farthest distance from the axis; 1 for a slide */
} pulled;

/* Makes the case and pulls it. Its rotation and the rest stay in `made`, which is to be released. */
static pulled pull_case(uint32_t index, int32_t kind, float noise, lab_case* made) {
    const dm_lab_options options = {.seed = 5, .count = 1, .categories = everything, .messy = 0.3f, .rotated = 0.7f};
    pulled p;
    float farthest[3];
    assert_int_equal(lab_case_make(&env, &options, index, made), DM_OK);
    p.hint = lab_case_drag(made, kind, noise, &p.joint);
    dmi_joint_velocity(&p.joint, 0, p.hint.point, p.tangent);
    dmi_normalize3(p.tangent);
    dmi_copy3(p.hint.vector, p.way);
    dmi_normalize3(p.way);
    p.cosine = dmi_dot3(p.way, p.tangent);
    p.reach = turns(&p.joint) ? reach(&p.joint, p.hint.point) /
                                    far_end(made, (uint32_t)dmi_mesh_find_part(made->mesh, made->part), farthest)
                              : 1;
    return p;
}

static void each_case(int32_t kind, float noise, void (*check)(const pulled*, const lab_case*)) {
    for (uint32_t i = 0; i < CASES; i++) {
        lab_case made;
        const pulled p = pull_case(i, kind, noise, &made);
        if (!(p.cosine > 0)) fail_msg("case %u, kind %d: against the joint's way", i, (int)kind);
        check(&p, &made);
        lab_case_release(&env, &made);
    }
}

static void is_tangential(const pulled* p, const lab_case* made) {
    (void)made;
    assert_true(p->cosine > 0.9999f);
}

/* From the rim of the circle straight to another point of it. A screw's way leaves the circle. */
static void is_chord(const pulled* p, const lab_case* made) {
    (void)made;
    if (!turns(&p->joint)) {
        assert_true(p->cosine > 0.9999f);
        return;
    }
    if (p->joint.type == DM_JOINT_SCREW) return;
    const float axis[3] = {p->joint.axis.x, p->joint.axis.y, p->joint.axis.z};
    const float origin[3] = {p->joint.origin.x, p->joint.origin.y, p->joint.origin.z};
    float arm[3];
    dmi_sub3(p->hint.point, origin, arm);
    assert_true(fabsf(dmi_dot3(p->way, axis)) < 1e-3f);
    assert_true(dmi_dot3(p->way, arm) < 1e-4f);
    assert_true(p->cosine > cosf(LONGEST_CHORD / 2) - 1e-3f);
}

static void is_along_the_room(const pulled* p, const lab_case* made) {
    float along = 0, most = 0;
    for (int k = 0; k < 3; k++) {
        const float axis[3] = {made->rotation[k], made->rotation[3 + k], made->rotation[6 + k]};
        along = fmaxf(along, fabsf(dmi_dot3(axis, p->way)));
        most = fmaxf(most, fabsf(dmi_dot3(axis, p->tangent)));
    }
    assert_true(along > 0.9999f);
    assert_float_equal(p->cosine, most, 1e-4f);
}

/* Of three perpendicular axes one is within 55 degrees. */
static void is_along_a_screen(const pulled* p, const lab_case* made) {
    (void)made;
    assert_true(p->cosine > 0.577f);
}

static void test_kinds(void** state) {
    (void)state;
    each_case(DM_LAB_PULL_EXACT, 12, is_tangential);
    each_case(DM_LAB_PULL_TANGENT, 0, is_tangential);
    each_case(DM_LAB_PULL_CHORD, 0, is_chord);
    each_case(DM_LAB_PULL_ROOM, 0, is_along_the_room);
    each_case(DM_LAB_PULL_SCREEN, 0, is_along_a_screen);
}

/* Pulls of a mixture: about as many follow the tangent as the table says, some are far off it, all grab away from the
 * axis, many at the far end. */
static void test_mixture(void** state) {
    (void)state;
    int exact = 0, far_off = 0, at_far_end = 0, turning = 0;
    for (uint32_t i = 0; i < CASES; i++) {
        lab_case made;
        const pulled p = pull_case(i, DM_LAB_PULL_MIXED, 10, &made);
        exact += p.cosine > 0.9999f;
        if (turns(&p.joint)) {
            turning++;
            far_off += p.cosine < 0.95f;
            at_far_end += p.reach > 0.999f;
        }
        lab_case_release(&env, &made);
    }
    assert_in_range(exact, 0.25f * CASES, 0.6f * CASES);
    assert_in_range(far_off, 0.1f * (float)turning, 0.5f * (float)turning);
    assert_in_range(at_far_end, 0.2f * (float)turning, 0.6f * (float)turning);
}

static void test_shares_are_of_one(void** state) {
    (void)state;
    float sum = 0;
    for (int32_t kind = 0; kind < DM_LAB_PULL_MIXED; kind++) {
        sum += mixture[kind].share;
        assert_true(mixture[kind].far_end + mixture[kind].handle <= 1);
    }
    assert_float_equal(sum, 1, 1e-6f);
}

/* The same case gives the same bits, and an error of the hand tilts a straight pull in about every other case. */
static void test_repeats_and_shakes(void** state) {
    (void)state;
    int shaken = 0;
    for (uint32_t i = 0; i < CASES; i++) {
        lab_case made;
        const pulled p = pull_case(i, DM_LAB_PULL_ROOM, 10, &made);
        lab_case_release(&env, &made);
        const pulled again = pull_case(i, DM_LAB_PULL_ROOM, 10, &made);
        assert_memory_equal(&p.hint, &again.hint, sizeof p.hint);
        float along = 0;
        for (int k = 0; k < 3; k++) {
            const float axis[3] = {made.rotation[k], made.rotation[3 + k], made.rotation[6 + k]};
            along = fmaxf(along, fabsf(dmi_dot3(axis, p.way)));
        }
        shaken += along < 0.99999f;
        lab_case_release(&env, &made);
    }
    assert_in_range(shaken, CASES / 3, 2 * CASES / 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_kinds),
        cmocka_unit_test(test_mixture),
        cmocka_unit_test(test_shares_are_of_one),
        cmocka_unit_test(test_repeats_and_shakes),
    };
    return cmocka_run_group_tests_name("pull", tests, set_up, NULL);
}
