/* The feature table, and features.json, which training reads, say the same.
 *
 *     build/release/tests/test_feature_table --print > sdk/kinematics/features/features.json   after a change of the
 * table */
#include "test_env.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kinematics/features/feature_table.h"
#include "test_world.h"

#define JSON "sdk/kinematics/features/features.json"

static const char* const passes[DMI_PASS_COUNT] = {"cheap", "full"};
static const char* const sources[DMI_SOURCE_COUNT] = {"geometry", "drag", "network"};

static void lower(const char* name, char out[64]) {
    size_t n = 0;
    for (; name[n] != 0 && n < 63; n++) out[n] = (char)tolower((unsigned char)name[n]);
    out[n] = 0;
}

/* Writes the table as JSON, a column a line. Returns the number of bytes, as snprintf does. */
static size_t write_json(char* out, size_t size) {
    size_t at = (size_t)snprintf(out, size, "[\n");
    for (int k = 0; k < DMI_FEATURE_COUNT; k++) {
        const dmi_feature* f = &dmi_features[k];
        char name[64], group[64];
        lower(f->name, name);
        lower(f->group_name, group);
        at += (size_t)snprintf(out + (at < size ? at : size), at < size ? size - at : 0,
                               "{\"column\": %d, \"name\": \"%s\", \"group\": \"%s\", \"pass\": \"%s\", \"source\": "
                               "\"%s\", \"unit\": \"%s\", \"meaning\": \"%s\"}%s\n",
                               k, name, group, passes[f->pass], sources[f->source], f->unit, f->meaning,
                               k + 1 < DMI_FEATURE_COUNT ? "," : "");
    }
    at += (size_t)snprintf(out + (at < size ? at : size), at < size ? size - at : 0, "]\n");
    return at;
}

static char* table_as_json(void) {
    const size_t size = write_json(NULL, 0) + 1;
    char* text = malloc(size);
    assert_non_null(text);
    write_json(text, size);
    return text;
}

static void the_file_is_the_table(void** state) {
    (void)state;
    size_t size;
    char *text = table_as_json(), *file = test_read_file(JSON, &size);
    if (size != strlen(text) || memcmp(file, text, size) != 0)
        fail_msg("%s is not the table: see the head of %s", JSON, __FILE__);
    free(file);
    free(text);
}

static void names_are_unique_and_groups_lie_together(void** state) {
    (void)state;
    for (int k = 1; k < DMI_FEATURE_COUNT; k++) {
        const int step = (int)dmi_features[k].group - (int)dmi_features[k - 1].group;
        assert_true(step == 0 || step == 1);
        for (int i = 0; i < k; i++) assert_string_not_equal(dmi_features[k].name, dmi_features[i].name);
    }
    assert_int_equal(dmi_features[0].group, 0);
    assert_int_equal(dmi_features[DMI_FEATURE_COUNT - 1].group, DMI_GROUP_COUNT - 1);
}

static void lists_hold_the_columns_they_name(void** state) {
    (void)state;
    int cheap = 0, network = 0;
    for (int k = 0; k < DMI_FEATURE_COUNT; k++) {
        if (dmi_features[k].pass == DMI_PASS_CHEAP) assert_int_equal(dmi_cheap_columns[cheap++], k);
        if (dmi_features[k].source == DMI_SOURCE_NETWORK) assert_int_equal(dmi_network_columns[network++], k);
    }
    assert_int_equal(cheap, DMI_CHEAP_COLUMNS);
    assert_int_equal(network, DMI_NETWORK_COLUMNS);
}

int main(int argc, char** argv) {
    if (argc == 2 && strcmp(argv[1], "--print") == 0) {
        char* text = table_as_json();
        fputs(text, stdout);
        free(text);
        return 0;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_file_is_the_table),
        cmocka_unit_test(names_are_unique_and_groups_lie_together),
        cmocka_unit_test(lists_hold_the_columns_they_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
