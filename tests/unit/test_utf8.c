/* Any bytes become valid UTF-8, and what is valid stays. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "base/random.h"
#include "base/utf8.h"

static void mends_what_is_no_character(void** state) {
    (void)state;
    static const char* const cases[][2] = {
        {"", ""},
        {"door", "door"},
        {"T\xC3\xBCr \xE3\x83\x89\xE3\x82\xA2 \xF0\x9F\x9A\xAA",
         "T\xC3\xBCr \xE3\x83\x89\xE3\x82\xA2 \xF0\x9F\x9A\xAA"},
        {"T\xFCr", "T?r"},                         /* Latin-1 */
        {"\xE3\x83", "?"},                         /* cut off after two bytes of three */
        {"a\xF0\x9F\x9A'b", "a?'b"},               /* after three of four */
        {"\xC0\xAF", "??"},                        /* an overlong '/' */
        {"\xED\xA0\x80", "???"},                   /* a surrogate */
        {"\xF4\x90\x80\x80", "????"},              /* beyond U+10FFFF */
        {"\x80\xBF\xFE\xFF", "????"},              /* nothing begins with them */
        {"\xE2\x82\xE2\x82\xAC", "?\xE2\x82\xAC"}, /* cut off, then whole */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[64];
        snprintf(text, sizeof text, "%s", cases[i][0]);
        assert_int_equal(dmi_utf8_is_valid(text, strlen(text)), strcmp(cases[i][0], cases[i][1]) == 0);
        assert_int_equal(dmi_utf8_mend(text), strlen(cases[i][1]));
        assert_string_equal(text, cases[i][1]);
    }
}

/* Decodes as RFC 3629 says, by arithmetic. Returns whether all is well-formed. */
static int decodes(const uint8_t* at) {
    static const uint32_t least[5] = {0, 0, 0x80, 0x800, 0x10000};
    while (*at) {
        const int length = *at < 0x80 ? 1 : *at >> 5 == 6 ? 2 : *at >> 4 == 14 ? 3 : *at >> 3 == 30 ? 4 : 0;
        uint32_t code = length == 1 ? *at : length ? *at & (0x7Fu >> length) : 0;
        if (length == 0) return 0;
        for (int i = 1; i < length; i++) {
            if (at[i] >> 6 != 2) return 0;
            code = code << 6 | (at[i] & 0x3F);
        }
        if (code < least[length] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return 0;
        at += length;
    }
    return 1;
}

static void any_bytes_become_valid(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 1);
    for (int round = 0; round < 200000; round++) {
        char text[9];
        for (int i = 0; i < 8; i++) {
            const uint32_t bits = dmi_random_u32(&random);
            static const uint8_t often[] = {0xC3, 0xE0, 0xED, 0xF0, 0xF4, 0x80, 0x9F, 0xBF};
            text[i] = (char)(bits & 0x100 ? often[bits & 7] : bits & 0xFF);
        }
        text[8] = 0;
        const int valid = decodes((const uint8_t*)text);
        assert_int_equal(dmi_utf8_is_valid(text, strlen(text)), valid);
        char before[9];
        memcpy(before, text, sizeof text);
        const size_t length = dmi_utf8_mend(text);
        assert_int_equal(length, strlen(text));
        assert_true(decodes((const uint8_t*)text));
        if (valid) assert_string_equal(text, before);
        assert_int_equal(dmi_utf8_compare_mended(before, text), 0);
        if (length > 0) text[length - 1] ^= 1;
        if (length > 0) assert_int_not_equal(dmi_utf8_compare_mended(before, text), 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(mends_what_is_no_character),
                                       cmocka_unit_test(any_bytes_become_valid)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
