/* Safetensors: right files are read, wrong ones named, whatever is wrong with them. */
#include "test_env.h"

#include <errno.h>
#include <math.h>

#include <cjson/cJSON.h>

#include "nn/weights.h"
#include "test_safetensors.h"

#define META "\"__metadata__\":{\"architecture\":\"net\",\"version\":\"1\",\"commit\":\"abc\"}"
#define MATRIX "\"m\":{\"dtype\":\"F32\",\"shape\":[2,3],\"data_offsets\":[0,24]}"
#define VECTOR "\"v\":{\"dtype\":\"F32\",\"shape\":[4],\"data_offsets\":[24,40]}"
#define NUMBERS 10 /* of MATRIX and VECTOR */

static dm_result open_file(test_file file) {
    test_env t;
    dmi_weights* weights = NULL;
    test_env_open(&t, TEST_NEVER);
    const dm_result result = dmi_weights_open(&t.env, file.data, file.size, "net", 2, &weights);
    assert_int_equal(weights != NULL, result == DM_OK);
    assert_int_equal(t.messages.count > 0, result != DM_OK);
    dmi_weights_close(weights);
    test_env_close(&t);
    return result;
}

static dm_result open_header(const char* header, size_t numbers) {
    test_file file = test_file_of(header, numbers);
    const dm_result result = open_file(file);
    free(file.data);
    return result;
}

static void tensors_are_found_by_name_and_shape(void** state) {
    (void)state;
    test_env t;
    dmi_weights* weights = NULL;
    test_file file = test_file_of("{" VECTOR "," META "," MATRIX "}  ", NUMBERS);
    test_env_open(&t, TEST_NEVER);
    assert_int_equal(dmi_weights_open(&t.env, file.data, file.size, "net", 1, &weights), DM_OK);
    float m[6], v[4];
    bool finite = false;
    assert_true(dmi_weights_read(weights, "m", 2, 3, m, &finite));
    assert_true(finite);
    assert_true(m[0] == 0.0f && m[5] == 5.0f);
    assert_true(dmi_weights_read(weights, "v", 4, 0, v, NULL));
    assert_true(v[0] == 6.0f && v[3] == 9.0f);
    assert_int_equal(t.messages.count, 0);
    assert_false(dmi_weights_read(weights, "m", 3, 2, m, NULL));
    assert_false(dmi_weights_read(weights, "m", 6, 0, m, NULL));
    assert_false(dmi_weights_read(weights, "v", 4, 1, v, NULL));
    assert_false(dmi_weights_read(weights, "w", 4, 0, v, NULL));
    assert_int_equal(t.messages.count, 4);
    assert_string_equal(dmi_weights_metadata(weights, "commit"), "abc");
    assert_null(dmi_weights_metadata(weights, "author"));
    dmi_weights_close(weights);
    test_env_close(&t);
    free(file.data);
}

static void halves_are_widened_exactly(void** state) {
    (void)state;
    static const struct {
        uint16_t half;
        float value;
    } cases[] = {{0x0000, 0.0f},        {0x8000, -0.0f},     {0x3c00, 1.0f},     {0xc000, -2.0f},
                 {0x3555, 0x1.554p-2f}, {0x7bff, 65504.0f},  {0x0400, 0x1p-14f}, {0x03ff, 0x1.ff8p-15f},
                 {0x0001, 0x1p-24f},    {0x8001, -0x1p-24f}, {0x7c00, INFINITY}, {0xfc00, -INFINITY}};
    enum { CASES = sizeof cases / sizeof *cases };
    test_env t;
    dmi_weights* weights = NULL;
    char header[256];
    snprintf(header, sizeof header, "{%s,\"h\":{\"dtype\":\"F16\",\"shape\":[%d],\"data_offsets\":[0,%d]}}", META,
             CASES, 2 * CASES);
    test_file file = test_file_of(header, CASES / 2);
    for (size_t i = 0; i < CASES; ++i) memcpy(file.data + file.size - 2 * (CASES - i), &cases[i].half, 2);
    test_env_open(&t, TEST_NEVER);
    assert_int_equal(dmi_weights_open(&t.env, file.data, file.size, "net", 1, &weights), DM_OK);
    float values[CASES];
    assert_true(dmi_weights_read(weights, "h", CASES, 0, values, NULL));
    for (size_t i = 0; i < CASES; ++i)
        if (memcmp(&values[i], &cases[i].value, sizeof(float)) != 0)
            fail_msg("%04x became %a", cases[i].half, (double)values[i]);
    dmi_weights_close(weights);
    test_env_close(&t);
    free(file.data);
}

static void any_address_will_do(void** state) {
    (void)state;
    test_file file = test_file_of("{" META "," MATRIX "," VECTOR "}", NUMBERS);
    unsigned char* moved = malloc(file.size + 8);
    for (size_t shift = 0; shift < 8; ++shift) {
        memcpy(moved + shift, file.data, file.size);
        assert_int_equal(open_file((test_file){moved + shift, file.size}), DM_OK);
    }
    free(moved);
    free(file.data);
}

static void every_truncation_is_an_error(void** state) {
    (void)state;
    test_file file = test_file_of("{" META "," MATRIX "," VECTOR "}", NUMBERS);
    for (size_t size = 0; size < file.size; ++size) {
        unsigned char* cut = malloc(size + 1); /* an own block: a read past its end is seen */
        memcpy(cut, file.data, size);
        assert_int_equal(open_file((test_file){cut, size}), DM_ERROR_BAD_DATA);
        free(cut);
    }
    assert_int_equal(open_file(file), DM_OK);
    free(file.data);
}

static void header_lengths_are_checked(void** state) {
    (void)state;
    test_file file = test_file_of("{" META "}", 0);
    static const unsigned char lengths[][8] = {
        {0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff},
        {0, 0, 0, 0, 0, 0, 0, 0x80},
        {0xf8, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff},
        {0, 0, 0, 0, 0, 0, 0, 0},
    };
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; ++i) {
        memcpy(file.data, lengths[i], 8);
        assert_int_equal(open_file(file), DM_ERROR_BAD_DATA);
    }
    free(file.data);
}

static void a_header_of_megabytes_is_refused(void** state) {
    (void)state;
    const size_t size = (size_t)3 << 20;
    char* header = malloc(size + 1);
    memset(header, ' ', size);
    header[0] = '{';
    memcpy(header + 1, META, strlen(META));
    header[size - 1] = '}';
    header[size] = 0;
    assert_int_equal(open_header(header, 0), DM_ERROR_BAD_DATA);
    free(header);
}

static void wrong_headers_are_errors(void** state) {
    (void)state;
    static const char* const headers[] = {
        "",
        "[]",
        "{" META,
        "{" META "} x",
        "{" META "}{}",
        "null",
        "{" META "," META "}",
        "{\"__metadata__\":[]}",
        "{" META ",\"m\":1}",
        "{" META ",\"m\":{}}",
        "{" META ",\"m\":{\"dtype\":\"F16\",\"shape\":[1],\"data_offsets\":[0,4]}}",
        "{" META ",\"m\":{\"dtype\":\"BF16\",\"shape\":[2],\"data_offsets\":[0,4]}}",
        "{" META ",\"m\":{\"dtype\":1,\"shape\":[1],\"data_offsets\":[0,4]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"data_offsets\":[0,4]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[\"1\"],\"data_offsets\":[0,4]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[-1],\"data_offsets\":[0,4]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1.5],\"data_offsets\":[0,4]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1e300],\"data_offsets\":[0,4]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[4294967295,4294967295,4294967295],\"data_offsets\":[0,4]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1,1,1,1,1,1,1,1,1],\"data_offsets\":[0,4]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[0]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[0,4,8]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[4,0]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[-4,0]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[0.5,4.5]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[2],\"data_offsets\":[0,4]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[2],\"data_offsets\":[0,8]}}",
        "{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[1e18,1e18]}}",
    };
    for (size_t i = 0; i < sizeof headers / sizeof headers[0]; ++i)
        if (open_header(headers[i], 1) != DM_ERROR_BAD_DATA) fail_msg("accepted: %s", headers[i]);
    assert_int_equal(open_header("{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[0,4]}}", 1),
                     DM_OK);
}

static void tensors_must_tile_the_file(void** state) {
    (void)state;
    const char* overlap = "\"v\":{\"dtype\":\"F32\",\"shape\":[4],\"data_offsets\":[20,36]}";
    const char* hole = "\"v\":{\"dtype\":\"F32\",\"shape\":[4],\"data_offsets\":[28,44]}";
    const char* same_name = "\"m\":{\"dtype\":\"F32\",\"shape\":[4],\"data_offsets\":[24,40]}";
    char header[512];
    snprintf(header, sizeof header, "{%s,%s,%s}", META, MATRIX, overlap);
    assert_int_equal(open_header(header, 9), DM_ERROR_BAD_DATA);
    snprintf(header, sizeof header, "{%s,%s,%s}", META, MATRIX, hole);
    assert_int_equal(open_header(header, 11), DM_ERROR_BAD_DATA);
    snprintf(header, sizeof header, "{%s,%s,%s}", META, MATRIX, same_name);
    assert_int_equal(open_header(header, NUMBERS), DM_ERROR_BAD_DATA);
    snprintf(header, sizeof header, "{%s,%s,%s}", META, MATRIX, VECTOR);
    assert_int_equal(open_header(header, NUMBERS + 1), DM_ERROR_BAD_DATA); /* bytes that no tensor owns */
    assert_int_equal(open_header(header, NUMBERS), DM_OK);
}

static void architecture_and_version_decide(void** state) {
    (void)state;
    static const struct {
        const char* metadata;
        dm_result result;
    } cases[] = {
        {"{\"architecture\":\"net\",\"version\":\"2\"}", DM_OK},
        {"{\"architecture\":\"net\",\"version\":\"3\"}", DM_ERROR_VERSION},
        {"{\"architecture\":\"net\",\"version\":\"99999999999999999999\"}", DM_ERROR_VERSION},
        {"{\"architecture\":\"net\",\"version\":\"0\"}", DM_ERROR_BAD_DATA},
        {"{\"architecture\":\"net\",\"version\":\"1x\"}", DM_ERROR_BAD_DATA},
        {"{\"architecture\":\"net\",\"version\":\"\"}", DM_ERROR_BAD_DATA},
        {"{\"architecture\":\"net\",\"version\":1}", DM_ERROR_BAD_DATA},
        {"{\"architecture\":\"net\"}", DM_ERROR_BAD_DATA},
        {"{\"architecture\":\"other\",\"version\":\"1\"}", DM_ERROR_WRONG_MODEL},
        {"{\"architecture\":7,\"version\":\"1\"}", DM_ERROR_WRONG_MODEL},
        {"{}", DM_ERROR_WRONG_MODEL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        char header[256];
        snprintf(header, sizeof header, "{\"__metadata__\":%s}", cases[i].metadata);
        if (open_header(header, 0) != cases[i].result) fail_msg("wrong result: %s", header);
    }
    assert_int_equal(open_header("{}", 0), DM_ERROR_WRONG_MODEL);
    assert_int_equal(open_header("{} {}", 0), DM_ERROR_BAD_DATA);
    assert_int_equal(open_header("[1]", 0), DM_ERROR_BAD_DATA);
}

static void any_allocation_may_fail(void** state) {
    (void)state;
    test_file file = test_file_of("{" META "," MATRIX "," VECTOR "}", NUMBERS);
    dm_result result = DM_ERROR_OUT_OF_MEMORY;
    int64_t fail_at = 0;
    for (; result != DM_OK; ++fail_at) {
        test_env t;
        dmi_weights* weights = NULL;
        test_env_open(&t, fail_at);
        result = dmi_weights_open(&t.env, file.data, file.size, "net", 1, &weights);
        assert_true(result == DM_OK || result == DM_ERROR_OUT_OF_MEMORY);
        dmi_weights_close(weights);
        test_env_close(&t);
    }
    assert_true(fail_at > 2);
    free(file.data);
}

static int calls, fail_at;

static void* failing_malloc(size_t size) {
    if (calls++ != fail_at) return malloc(size);
    errno = ENOMEM;
    return NULL;
}

/* The parser has its memory from malloc. Wherever that fails, the error says so, and nothing is lost. */
static void no_memory_for_the_header_is_no_bad_file(void** state) {
    (void)state;
    test_file file = test_file_of("{" META "," MATRIX "," VECTOR "}", NUMBERS);
    dm_result result = DM_ERROR_OUT_OF_MEMORY;
    for (fail_at = 0; result != DM_OK; fail_at++) {
        cJSON_InitHooks(&(cJSON_Hooks){failing_malloc, free});
        calls = 0;
        result = open_file(file);
        cJSON_InitHooks(NULL);
        assert_int_equal(result, calls > fail_at ? DM_ERROR_OUT_OF_MEMORY : DM_OK);
    }
    assert_true(fail_at > 20);
    errno = ENOMEM; /* of a call before: a bad text is one all the same */
    assert_int_equal(open_header("{", 0), DM_ERROR_BAD_DATA);
    free(file.data);
}

/* The largest header and number of tensors and sides, and one more of each. */
static void limits_are_the_last_that_fit(void** state) {
    (void)state;
    enum { MOST_HEADER = 1 << 20, MOST_TENSORS = 4096 };
    for (int more = 0; more < 2; more++) {
        char* header = malloc(MOST_HEADER + 2);
        memset(header, ' ', MOST_HEADER + 1);
        memcpy(header, "{" META "}", strlen("{" META "}"));
        header[MOST_HEADER + more] = 0;
        assert_int_equal(open_header(header, 0), more ? DM_ERROR_BAD_DATA : DM_OK);
        size_t length = (size_t)sprintf(header, "{" META);
        for (int i = 0; i < MOST_TENSORS - 1 + more; i++) /* metadata counts as one */
            length +=
                (size_t)sprintf(header + length, ",\"t%d\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[%d,%d]}",
                                i, 4 * i, 4 * i + 4);
        sprintf(header + length, "}");
        assert_int_equal(open_header(header, MOST_TENSORS - 1 + (size_t)more), more ? DM_ERROR_BAD_DATA : DM_OK);
        free(header);
    }
    assert_int_equal(
        open_header("{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1,1,1,1,1,1,1,1],\"data_offsets\":[0,4]}}", 1),
        DM_OK);
    assert_int_equal(open_header("{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[],\"data_offsets\":[0,4]}}", 1), DM_OK);
    /* Tensors without numbers lie between others, or at the end. */
    assert_int_equal(open_header("{" META ",\"a\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[0,4]},"
                                 "\"b\":{\"dtype\":\"F32\",\"shape\":[0,9],\"data_offsets\":[4,4]},"
                                 "\"c\":{\"dtype\":\"F16\",\"shape\":[0],\"data_offsets\":[0,0]}}",
                                 1),
                     DM_OK);
}

/* Messages say which rule a file breaks, and of which tensor. */
static void errors_are_named(void** state) {
    (void)state;
    static const struct {
        const char *header, *says;
        dm_result result;
    } cases[] = {
        {"[]", "not one JSON object", DM_ERROR_BAD_DATA},
        {"{" META "} x", "not one JSON object", DM_ERROR_BAD_DATA},
        {"{" META "," META "}", "__metadata__ is not one object", DM_ERROR_BAD_DATA},
        {"{\"__metadata__\":7}", "__metadata__ is not one object", DM_ERROR_BAD_DATA},
        {"{\"__metadata__\":{\"architecture\":\"nets\"}}", "architecture 'nets', expected 'net'", DM_ERROR_WRONG_MODEL},
        {"{\"__metadata__\":{\"architecture\":\"net\",\"version\":\"3\"}}", "version 3, this library reads up to 2",
         DM_ERROR_VERSION},
        {"{\"__metadata__\":{\"architecture\":\"net\",\"version\":\"-1\"}}", "version '-1' is no number",
         DM_ERROR_BAD_DATA},
        {"{" META ",\"m\":{\"dtype\":\"F64\",\"shape\":[1],\"data_offsets\":[0,4]}}", "tensor 'm' is of neither dtype",
         DM_ERROR_BAD_DATA},
        {"{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":1,\"data_offsets\":[0,4]}}", "'m' has no usable shape",
         DM_ERROR_BAD_DATA},
        {"{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[2],\"data_offsets\":[0,4]}}", "'m' has no usable shape",
         DM_ERROR_BAD_DATA},
        {"{" META ",\"m\":{\"dtype\":\"F16\",\"shape\":[1],\"data_offsets\":[0,4]}}", "'m' has wrong data_offsets",
         DM_ERROR_BAD_DATA},
        {"{" META ",\"m\":{\"dtype\":\"F32\",\"shape\":[1],\"data_offsets\":[1,5]}}", "'m' has wrong data_offsets",
         DM_ERROR_BAD_DATA},
        {"{" META ",\"m\":{\"dtype\":\"F16\",\"shape\":[1],\"data_offsets\":[1,3]}}",
         "'m' overlaps another or leaves a hole", DM_ERROR_BAD_DATA},
        {"{" META ",\"m\":{\"dtype\":\"F16\",\"shape\":[1],\"data_offsets\":[0,2]}}", "tensors take 2 of 4 bytes",
         DM_ERROR_BAD_DATA},
        {"{" META ",\"m\":{\"dtype\":\"F16\",\"shape\":[1],\"data_offsets\":[0,2]},"
         "\"m\":{\"dtype\":\"F16\",\"shape\":[1],\"data_offsets\":[2,4]}}",
         "two tensors named 'm'", DM_ERROR_BAD_DATA},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        test_env t;
        dmi_weights* weights = NULL;
        test_file file = test_file_of(cases[i].header, strstr(cases[i].header, "shape") ? 1 : 0);
        test_env_open(&t, TEST_NEVER);
        const dm_result result = dmi_weights_open(&t.env, file.data, file.size, "net", 2, &weights);
        if (result != cases[i].result || !strstr(t.messages.text, cases[i].says))
            fail_msg("%s: %d '%s'", cases[i].header, result, t.messages.text);
        free(file.data);
        test_env_close(&t);
    }
}

/* Every half of 16 bits is the float of the same value (IEEE 754). */
static void all_halves_are_widened(void** state) {
    (void)state;
    enum { HALVES = 1 << 16 };
    test_env t;
    dmi_weights* weights = NULL;
    char header[256];
    snprintf(header, sizeof header, "{%s,\"h\":{\"dtype\":\"F16\",\"shape\":[%d],\"data_offsets\":[0,%d]}}", META,
             HALVES, 2 * HALVES);
    test_file file = test_file_of(header, HALVES / 2);
    float* values = malloc(HALVES * sizeof *values);
    for (uint32_t i = 0; i < HALVES; i++) {
        file.data[file.size - 2 * (HALVES - i)] = (unsigned char)i;
        file.data[file.size - 2 * (HALVES - i) + 1] = (unsigned char)(i >> 8);
    }
    test_env_open(&t, TEST_NEVER);
    assert_int_equal(dmi_weights_open(&t.env, file.data, file.size, "net", 1, &weights), DM_OK);
    bool finite = true;
    assert_true(dmi_weights_read(weights, "h", HALVES, 0, values, &finite));
    assert_false(finite);
    for (uint32_t i = 0; i < HALVES; i++) {
        const int exponent = (int)(i >> 10 & 31), fraction = (int)(i & 1023);
        const double size = exponent == 0    ? ldexp(fraction, -24)
                            : exponent == 31 ? (fraction ? (double)NAN : (double)INFINITY)
                                             : ldexp(1024 + fraction, exponent - 25);
        assert_int_equal(signbit(values[i]) != 0, i >> 15);
        assert_true(isnan(size) ? isnan(values[i]) : fabsf(values[i]) == (float)size);
    }
    dmi_weights_close(weights);
    test_env_close(&t);
    free(values);
    free(file.data);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tensors_are_found_by_name_and_shape),
        cmocka_unit_test(halves_are_widened_exactly),
        cmocka_unit_test(any_address_will_do),
        cmocka_unit_test(every_truncation_is_an_error),
        cmocka_unit_test(header_lengths_are_checked),
        cmocka_unit_test(a_header_of_megabytes_is_refused),
        cmocka_unit_test(wrong_headers_are_errors),
        cmocka_unit_test(tensors_must_tile_the_file),
        cmocka_unit_test(architecture_and_version_decide),
        cmocka_unit_test(any_allocation_may_fail),
        cmocka_unit_test(no_memory_for_the_header_is_no_bad_file),
        cmocka_unit_test(limits_are_the_last_that_fit),
        cmocka_unit_test(errors_are_named),
        cmocka_unit_test(all_halves_are_widened),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
