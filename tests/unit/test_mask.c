/* Masks: .npy files as NumPy writes them, JSON arrays, hostile bytes, and the way to part ids. */
#include "test_env.h"

#include "mesh/mask.h"

typedef struct bytes {
    uint8_t data[4096];
    size_t size;
} bytes;

static void append(bytes* b, const void* data, size_t size) {
    assert_true(b->size + size <= sizeof b->data);
    memcpy(b->data + b->size, data, size);
    b->size += size;
}

/* A file of the given format version with this header text and these values. */
static bytes npy(int version, const char* header, const void* values, size_t size) {
    bytes b = {.size = 0};
    append(&b, "\x93NUMPY", 6);
    append(&b, (const uint8_t[]){(uint8_t)version, 0}, 2);
    size_t length = strlen(header);
    append(&b, (const uint8_t[]){(uint8_t)length, (uint8_t)(length >> 8), 0, 0}, version == 1 ? 2 : 4);
    append(&b, header, length);
    append(&b, values, size);
    return b;
}

static void expect_values(const void* data, size_t size, const int64_t* expected, size_t expected_count) {
    test_env t;
    test_env_open(&t, TEST_NEVER);
    int64_t* values = NULL;
    size_t count = 0;
    dm_result result = dmi_mask_parse(&t.env, data, size, &values, &count);
    if (result != DM_OK) print_error("%s\n", t.messages.text);
    assert_int_equal(result, DM_OK);
    assert_int_equal(count, expected_count);
    for (size_t i = 0; i < count; i++) assert_true(values[i] == expected[i]);
    dmi_free(&t.env, values, count * sizeof *values);
    test_env_close(&t);
}

static void expect_error(const void* data, size_t size, dm_result code, const char* words) {
    test_env t;
    test_env_open(&t, TEST_NEVER);
    int64_t* values = (int64_t*)&t;
    size_t count = 77;
    assert_int_equal(dmi_mask_parse(&t.env, data, size, &values, &count), code);
    assert_ptr_equal(values, &t);
    assert_int_equal(count, 77);
    if (strstr(t.messages.text, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", t.messages.text, words);
    test_env_close(&t);
}

static void every_integer_type_of_numpy(void** state) {
    (void)state;
    static const struct {
        const char* descr;
        uint8_t raw[16];
        size_t size;
        int64_t values[2];
    } rows[] = {
        {"|b1", {0, 1}, 2, {0, 1}},
        {"|u1", {0, 255}, 2, {0, 255}},
        {"|i1", {127, 255}, 2, {127, -1}},
        {"<u2", {1, 2, 255, 255}, 4, {513, 65535}},
        {"<i2", {1, 2, 254, 255}, 4, {513, -2}},
        {"<u4", {4, 3, 2, 1, 255, 255, 255, 255}, 8, {0x01020304, 0xffffffff}},
        {"<i4", {4, 3, 2, 1, 0, 0, 0, 128}, 8, {0x01020304, INT32_MIN}},
        {"<u8", {5, 0, 0, 0, 1, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 127}, 16, {0x100000005, INT64_MAX}},
        {"<i8", {5, 0, 0, 0, 1, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255}, 16, {0x100000005, -1}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char header[128];
        snprintf(header, sizeof header, "{'descr': '%s', 'fortran_order': False, 'shape': (2,), }      \n",
                 rows[i].descr);
        for (int version = 1; version <= 3; version++) {
            bytes b = npy(version, header, rows[i].raw, rows[i].size);
            expect_values(b.data, b.size, rows[i].values, 2);
        }
    }
}

static void headers_in_other_spellings(void** state) {
    (void)state;
    static const char* const headers[] = {
        "{\"shape\":(3,),\"fortran_order\":True,\"descr\":\"|u1\"}",
        "{ 'shape' : ( 3 , ) , 'descr' : '|u1' , 'fortran_order' : False }",
        "{'descr': '|u1', 'fortran_order': False, 'shape': (3L,), }\n",
    };
    const int64_t expected[] = {7, 0, 9};
    for (size_t i = 0; i < sizeof headers / sizeof headers[0]; i++) {
        bytes b = npy(1, headers[i], (const uint8_t[]){7, 0, 9}, 3);
        expect_values(b.data, b.size, expected, 3);
    }
}

static void broken_npy_files_are_refused(void** state) {
    (void)state;
    static const struct {
        const char *header, *words;
    } rows[] = {
        {"", "no dictionary"},
        {"{", "no dictionary"},
        {"{}", "no 'descr'"},
        {"{'descr': '|u1', 'fortran_order': False}", "no 'descr', 'fortran_order' or 'shape'"},
        {"{'descr': '<f4', 'fortran_order': False, 'shape': (3,)}", "type '<f4'"},
        {"{'descr': '>i4', 'fortran_order': False, 'shape': (3,)}", "type '>i4'"},
        {"{'descr': [('x', '|u1')], 'fortran_order': False, 'shape': (3,)}", "plain type"},
        {"{'descr': '|O', 'fortran_order': False, 'shape': (3,)}", "type '|O'"},
        {"{'descr': '|u1', 'fortran_order': 0, 'shape': (3,)}", "'fortran_order'"},
        {"{'descr': '|u1', 'fortran_order': False, 'shape': (3, 1)}", "one dimension"},
        {"{'descr': '|u1', 'fortran_order': False, 'shape': ()}", "one dimension"},
        {"{'descr': '|u1', 'fortran_order': False, 'shape': (-3,)}", "one dimension"},
        {"{'descr': '|u1', 'fortran_order': False, 'shape': (99999999999999999999999,)}", "one dimension"},
        {"{'descr': '|u1', 'fortran_order': False, 'shape': (18446744073709551615,)}", "announced"},
        {"{'descr': '<i8', 'fortran_order': False, 'shape': (2305843009213693953,)}", "announced"},
        {"{'descr': '|u1', 'fortran_order': False, 'shape': (2,)}", "2 values of 1 bytes announced, 3 bytes follow"},
        {"{'descr': '|u1', 'fortran_order': False, 'shape': (4,)}", "announced"},
        {"{'descr': '<u2', 'fortran_order': False, 'shape': (1,)}", "announced"},
        {"{'descr': '|u1', 'fortran_order': False, 'shape': (0,)}", "no values"},
        {"{'descr': '|u1', 'fortran_order': False, 'shape': (3,)} x", "more behind"},
        {"{'descr': '|u1', 'fortran_order': False, 'shape': (3,)", "no dictionary"},
        {"{'descr: 3", "no dictionary"},
        {"{'nonsense': 3}", "'nonsense'"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        bytes b = npy(1, rows[i].header, (const uint8_t[]){1, 2, 3}, 3);
        expect_error(b.data, b.size, DM_ERROR_BAD_DATA, rows[i].words);
    }
    const char* good = "{'descr': '|u1', 'fortran_order': False, 'shape': (3,)}";
    bytes b = npy(4, good, "abc", 3);
    expect_error(b.data, b.size, DM_ERROR_BAD_DATA, "version 4");
    b = npy(0, good, "abc", 3);
    expect_error(b.data, b.size, DM_ERROR_BAD_DATA, "version 0");
    for (int version = 1; version <= 2; version++) { /* every truncation, from a block of exactly that size */
        b = npy(version, good, "abc", 3);
        for (size_t size = 0; size < b.size; size++) {
            uint8_t* cut = malloc(size > 0 ? size : 1);
            memcpy(cut, b.data, size);
            expect_error(cut, size, DM_ERROR_BAD_DATA, "mask");
            free(cut);
        }
    }
    memset(b.data + 8, 0xff, 4); /* a header of 4 GB */
    expect_error(b.data, b.size, DM_ERROR_BAD_DATA, "a header of 4294967295 bytes");
}

static void json_arrays(void** state) {
    (void)state;
    static const struct {
        const char* text;
        size_t count;
        int64_t values[4];
    } rows[] = {
        {"[1]", 1, {1}},
        {"[0,1,-2]", 3, {0, 1, -2}},
        {" \n[ 12 ,\t7 ]\r\n", 2, {12, 7}},
        {"[true,false, true]", 3, {1, 0, 1}},
        {"[1.0, 0.000]", 2, {1, 0}},
        {"[9223372036854775807,-9223372036854775807]", 2, {INT64_MAX, -INT64_MAX}},
        {"[9007199254740993]", 1, {9007199254740993}}, /* no double between */
        {"\xEF\xBB\xBF[3]", 1, {3}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        expect_values(rows[i].text, strlen(rows[i].text), rows[i].values, rows[i].count);
    }
}

static void other_json_is_refused(void** state) {
    (void)state;
    static const char* const rows[] = {
        "",        " ",     "[",           "]",      "[]",     "[,]",
        "[1,]",    "[,1]",  "[1",          "1",      "[1 2]",  "[1]]",
        "[[1]]",   "[1]x",  "{\"a\":[1]}", "null",   "[null]", "[\"1\"]",
        "[+1]",    "[- 1]", "[1.5]",       "[1.05]", "[1e3]",  "[.5]",
        "[1.]",    "[0x1]", "[truest]",    "[tru",   "[-]",    "[9223372036854775808]",
        "[1],[2]",
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        size_t size = strlen(rows[i]);
        char* exact = malloc(size > 0 ? size : 1); /* no terminator to lean on */
        memcpy(exact, rows[i], size);
        expect_error(exact, size, DM_ERROR_BAD_DATA, "mask");
        free(exact);
    }
    expect_error(NULL, 0, DM_ERROR_BAD_DATA, "no bytes");
}

static void a_refused_allocation_is_reported(void** state) {
    (void)state;
    bytes b = npy(1, "{'descr': '|u1', 'fortran_order': False, 'shape': (3,)}", "abc", 3);
    const struct {
        const void* data;
        size_t size;
    } inputs[] = {{b.data, b.size}, {"[1,2,3]", 7}};
    for (int i = 0; i < 2; i++) {
        test_env t;
        test_env_open(&t, 0);
        int64_t* values = NULL;
        size_t count = 0;
        assert_int_equal(dmi_mask_parse(&t.env, inputs[i].data, inputs[i].size, &values, &count),
                         DM_ERROR_OUT_OF_MEMORY);
        assert_null(values);
        assert_int_equal(t.messages.code, DM_ERROR_OUT_OF_MEMORY);
        test_env_close(&t);
    }
}

static void length_tells_the_scope(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    const int64_t values[] = {0, -1, 3, 7};
    uint8_t ids[4];
    int32_t scope = -1;
    int ambiguous = -1;
    assert_int_equal(dmi_mask_to_part_ids(&t.env, values, 4, NULL, 4, 9, ids, &scope, &ambiguous), DM_OK);
    assert_int_equal(scope, DM_PER_VERTEX);
    assert_int_equal(ambiguous, 0);
    assert_memory_equal(ids, ((uint8_t[]){0, 1, 1, 1}), 4);
    const int64_t three = 3, zero = 0;
    assert_int_equal(dmi_mask_to_part_ids(&t.env, values, 4, &three, 9, 4, ids, &scope, &ambiguous), DM_OK);
    assert_int_equal(scope, DM_PER_FACE);
    assert_int_equal(ambiguous, 0);
    assert_memory_equal(ids, ((uint8_t[]){0, 0, 1, 0}), 4);
    assert_int_equal(dmi_mask_to_part_ids(&t.env, values, 4, &zero, 4, 4, ids, &scope, &ambiguous), DM_OK);
    assert_int_equal(scope, DM_PER_VERTEX);
    assert_int_equal(ambiguous, 1);
    assert_memory_equal(ids, ((uint8_t[]){1, 0, 0, 0}), 4);
    assert_int_equal(dmi_mask_to_part_ids(&t.env, values, 4, NULL, 5, 3, ids, &scope, &ambiguous),
                     DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(t.messages.text, "4 values for 5 vertices and 3 triangles"));
    test_env_close(&t);
}

/* The smallest and largest values of each type of NumPy's. */
static void types_hold_their_extremes(void** state) {
    (void)state;
    static const struct {
        const char* descr;
        size_t size;
        int64_t low, high; /* of all bits but the top one, and of that alone, as the type reads them */
    } types[] = {{"|u1", 1, 127, 128},
                 {"|i1", 1, 127, -128},
                 {"<u2", 2, 32767, 32768},
                 {"<i2", 2, 32767, -32768},
                 {"<u4", 4, INT32_MAX, (int64_t)INT32_MAX + 1},
                 {"<i4", 4, INT32_MAX, INT32_MIN},
                 {"<i8", 8, INT64_MAX, INT64_MIN},
                 {"<u8", 8, INT64_MAX, INT64_MIN}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++) {
        uint8_t raw[16];
        char header[96];
        const size_t size = types[i].size;
        memset(raw, 0xff, size), memset(raw + size, 0, size);
        raw[size - 1] = 0x7f, raw[2 * size - 1] = 0x80;
        snprintf(header, sizeof header, "{'descr': '%s', 'fortran_order': False, 'shape': (2,)}", types[i].descr);
        bytes b = npy(1, header, raw, 2 * size);
        expect_values(b.data, b.size, (const int64_t[]){types[i].low, types[i].high}, 2);
    }
}

/* A header of 65,536 bytes is read, a longer one is not. */
static void a_header_has_an_end(void** state) {
    (void)state;
    enum { MOST = 65536 };
    const char* text = "{'descr': '|u1', 'fortran_order': False, 'shape': (1,)}";
    for (size_t length = MOST - 1; length <= MOST + 1; length++) {
        uint8_t* file = malloc(12 + length + 1);
        memset(file, ' ', 12 + length);
        memcpy(file, "\x93NUMPY\x02\x00", 8);
        for (int i = 0; i < 4; i++) file[8 + i] = (uint8_t)(length >> (8 * i));
        memcpy(file + 12, text, strlen(text));
        file[12 + length] = 5;
        if (length <= MOST)
            expect_values(file, 12 + length + 1, (const int64_t[]){5}, 1);
        else
            expect_error(file, 12 + length + 1, DM_ERROR_BAD_DATA, "a header of 65537 bytes in a file of 65550");
        free(file);
    }
}

/* What a message quotes of a file ends after 32 bytes. */
static void messages_quote_little(void** state) {
    (void)state;
    char header[256], says[64];
    for (int length = 31; length <= 33; length++) {
        char word[40] = {0};
        memset(word, 'k', (size_t)length);
        snprintf(header, sizeof header, "{'%s': 1}", word);
        snprintf(says, sizeof says, "header entry '%.32s' can't be read", word);
        bytes b = npy(1, header, "", 0);
        expect_error(b.data, b.size, DM_ERROR_BAD_DATA, says);
        snprintf(header, sizeof header, "{'descr': '%s'}", word);
        snprintf(says, sizeof says, "values of type '%.32s', must be", word);
        b = npy(1, header, "", 0);
        expect_error(b.data, b.size, DM_ERROR_BAD_DATA, says);
    }
}

/* JSON errors say at which byte and after how many values. */
static void json_errors_have_a_place(void** state) {
    (void)state;
    static const struct {
        const char *text, *says;
    } rows[] = {{"[1,2,x]", "(at byte 5, after 2 values)"}, {"[1 2]", "(at byte 3, after 1 values)"},
                {"[x]", "(at byte 1, after 0 values)"},     {"[1,2]]", "(at byte 5, after 2 values)"},
                {"{}", "neither .npy nor a JSON array"},    {" x", "neither .npy nor a JSON array"}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        expect_error(rows[i].text, strlen(rows[i].text), DM_ERROR_BAD_DATA, rows[i].says);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_integer_type_of_numpy),  cmocka_unit_test(headers_in_other_spellings),
        cmocka_unit_test(broken_npy_files_are_refused), cmocka_unit_test(json_arrays),
        cmocka_unit_test(other_json_is_refused),        cmocka_unit_test(a_refused_allocation_is_reported),
        cmocka_unit_test(length_tells_the_scope),       cmocka_unit_test(types_hold_their_extremes),
        cmocka_unit_test(a_header_has_an_end),          cmocka_unit_test(messages_quote_little),
        cmocka_unit_test(json_errors_have_a_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
