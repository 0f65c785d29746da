/* A host's job system that leaves tasks out, runs them twice or makes some up: an error that names it, nothing lost. */
#include "test_world.h"

enum {
    RUN_ALL,
    RUN_NONE,
    RUN_TWICE,
    RUN_ALL_BUT_THE_LAST,
    RUN_ALL_BUT_THE_FIRST,
    RUN_ONE_FOR_ANOTHER, /* as many tasks as were given, with the same sum of indices where there are four */
    RUN_ONE_TOO_MANY,
    RUN_HALF_AND_REFUSE,
    REFUSE,
    WAYS
};

typedef struct job_host {
    int way;
    int broken_call; /* from which call on it goes wrong; 0: at once */
    int calls;
} job_host;

static int32_t DM_CALL run(void* user, uint32_t count, dm_task task, void* data) {
    job_host* host = user;
    const int way = host->calls++ < host->broken_call ? RUN_ALL : host->way;
    const uint32_t first = way == RUN_ALL_BUT_THE_FIRST, last = way == RUN_ALL_BUT_THE_LAST ? count - 1 : count;
    switch (way) {
    case RUN_NONE:
        return 1;
    case REFUSE:
        return 0;
    case RUN_HALF_AND_REFUSE:
        for (uint32_t i = 0; i < count / 2; i++) task(data, i);
        return 0;
    case RUN_ONE_FOR_ANOTHER:
        for (uint32_t i = 0; i < count; i++) task(data, i < 2 ? 0 : count - 1);
        return 1;
    default:
        break;
    }
    for (uint32_t i = first; i < last; i++) task(data, i);
    for (uint32_t i = 0; way == RUN_TWICE && i < count; i++) task(data, i);
    if (way == RUN_ONE_TOO_MANY) task(data, count);
    return 1;
}

static const char* const says[WAYS] = {
    [RUN_NONE] = "task 0 of 2 was not run",
    [RUN_TWICE] = "was run twice",
    [RUN_ALL_BUT_THE_LAST] = "task 1 of 2 was not run",
    [RUN_ALL_BUT_THE_FIRST] = "task 0 of 2 was not run",
    [RUN_ONE_FOR_ANOTHER] = "was run twice",
    [RUN_ONE_TOO_MANY] = "task 2 was run but not given, of 2 tasks",
    [RUN_HALF_AND_REFUSE] = "answered 0 after it had run task 0 of 2",
};

/* broken_call: 0: while parts are inferred; 1: while they are encoded for the motion network. */
static void prepare_with(int way, int broken_call) {
    job_host host = {.way = way, .broken_call = broken_call};
    test_world w;
    dm_object object = 77;
    test_world_init(&w);
    w.desc.jobs = (dm_jobs){&host, run};
    test_world_open(&w);
    if (broken_call > 0) test_world_load_model(&w);
    const dm_result result = test_world_prepare(&w, 0, &object);
    if (says[way] == NULL) {
        assert_int_equal(result, DM_OK);
    } else {
        if (result != DM_ERROR_INVALID_ARGUMENT || object != 77 || !strstr(w.messages.text, says[way]))
            fail_msg("way %d, call %d: %s: %s", way, broken_call, dm_result_string(result), w.messages.text);
        host.way = RUN_ALL;
        assert_int_equal(test_world_prepare(&w, 0, &object), DM_OK);
    }
    dm_joint joint = dm_joint_default();
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &joint), DM_OK);
    assert_true(joint.axis.x != 0 || joint.axis.y != 0 || joint.axis.z != 0);
    test_world_close(&w);
}

static void parts_that_are_not_inferred_once_are_noticed(void** state) {
    (void)state;
    for (int way = 0; way < WAYS; way++) prepare_with(way, 0);
}

static void parts_that_are_not_encoded_once_are_noticed(void** state) {
    (void)state;
    for (int way = 0; way < WAYS; way++) prepare_with(way, 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_that_are_not_inferred_once_are_noticed),
        cmocka_unit_test(parts_that_are_not_encoded_once_are_noticed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
