/* The second door: the library opened at run time through dragmesh_loader.h, as a plugin or a binding does. */
#include <libgen.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "dragmesh/dragmesh_loader.h"

/* build/<config>/libdragmesh.so, beside the folder of this program. */
static void library_path(char* out, size_t size) {
    char self[512];
    ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    assert_true(length > 0);
    self[length] = 0;
    snprintf(out, size, "%s/../libdragmesh.so", dirname(self));
}

static void test_a_whole_life_through_the_table(void** state) {
    (void)state;
    char path[600];
    library_path(path, sizeof path);
    dm_library library;
    const dm_core_1* dm = dm_library_open(&library, path);
    if (!dm) fail_msg("%s: %s", path, library.error);
    assert_null(library.error);
    assert_int_equal(dm->version(), DM_VERSION);
    assert_true(DM_HAS(dm, result_string) && DM_HAS(dm, scene_pick));
    dm_context* context = NULL;
    assert_int_equal(dm->context_create(NULL, &context), DM_OK);
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    dm_scene scene = 0;
    assert_int_equal(dm->scene_create(context, &desc, &scene), DM_OK);
    assert_int_equal(dm->scene_destroy(context, scene), DM_OK);
    assert_int_equal(dm->scene_destroy(context, scene), DM_ERROR_STALE_HANDLE);
    dm->context_destroy(context);
    dm_library_close(&library);
    dm_library_close(&library); /* twice is no error */
}

static void test_what_is_not_the_library(void** state) {
    (void)state;
    dm_library library;
    assert_null(dm_library_open(&library, "./no/such/library.so"));
    assert_non_null(library.error);
    assert_null(library.handle);
    assert_null(dm_library_open(&library, "libm.so.6"));
    assert_string_equal(library.error, "it has no function dm_get_interface");
    assert_null(library.handle);
}

static void test_an_older_table_is_shorter(void** state) {
    (void)state;
    dm_core_1 older = *(const dm_core_1*)dm_get_interface("dm.core/1");
    older.struct_size = offsetof(dm_core_1, scene_pick);
    assert_false(DM_HAS(&older, scene_pick));
    assert_true(DM_HAS(&older, scene_commit));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_whole_life_through_the_table),
        cmocka_unit_test(test_what_is_not_the_library),
        cmocka_unit_test(test_an_older_table_is_shorter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
