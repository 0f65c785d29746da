/* Growing text, numbers and names of files that are written. */
#include "export/rig_text.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "export/rig_model.h"

enum { FIRST_CAPACITY = 1 << 12, ALIGNMENT = 16 };
enum { DIGITS = 12, FLOAT_DIGITS = 9 }; /* digits that the header states */

void dmi_text_free(dmi_text* text) {
    dmi_free(text->env, text->data, text->capacity);
    *text = (dmi_text){.env = text->env};
}

/* Makes room for `more` bytes and a zero. */
static bool make_room(dmi_text* text, size_t more) {
    text->failed = text->failed || more > SIZE_MAX / 2 - text->size - 1;
    if (text->failed) return false;
    const size_t needed = text->size + more + 1;
    if (needed <= text->capacity) return true;
    size_t capacity = text->capacity > 0 ? text->capacity : FIRST_CAPACITY;
    while (capacity < needed) capacity *= 2;
    char* data = dmi_alloc(text->env, capacity, ALIGNMENT);
    text->failed = data == NULL;
    if (text->failed) return false;
    if (text->size > 0) memcpy(data, text->data, text->size);
    dmi_free(text->env, text->data, text->capacity);
    text->data = data;
    text->capacity = capacity;
    return true;
}

void dmi_text_add(dmi_text* text, const char* added, size_t size) {
    if (!make_room(text, size)) return;
    memcpy(text->data + text->size, added, size);
    text->size += size;
    text->data[text->size] = 0;
}

void dmi_text_put(dmi_text* text, const char* format, ...) {
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int size = vsnprintf(NULL, 0, format, arguments);
    if (size >= 0 && make_room(text, (size_t)size)) {
        vsnprintf(text->data + text->size, (size_t)size + 1, format, again);
        text->size += (size_t)size;
    }
    va_end(again);
    va_end(arguments);
}

/* ---- numbers ---- */

/* Returns a number as text. A locale's sign between integer and fraction, of one byte or more, becomes a point, and
 * minus zero is zero. */
static dmi_digits_text print_number(int digits, double x) {
    dmi_digits_text out;
    snprintf(out.text, sizeof out.text, "%.*g", digits, x == 0 ? 0.0 : x);
    const size_t start = strspn(out.text, "-0123456789e"), length = strlen(out.text + start);
    const size_t sign = strcspn(out.text + start, "0123456789");
    if (length == 0) return out;
    out.text[start] = '.';
    memmove(out.text + start + 1, out.text + start + sign, length - sign + 1);
    return out;
}

dmi_digits_text dmi_digits(double x) {
    return print_number(DIGITS, x);
}

dmi_digits_text dmi_digits_of_float(float x) {
    return print_number(FLOAT_DIGITS, (double)x);
}

dmi_digits3_text dmi_digits3(const double v[3], const char* between) {
    dmi_digits3_text out;
    snprintf(out.text, sizeof out.text, "%s%.2s%s%.2s%s", dmi_digits(v[0]).text, between, dmi_digits(v[1]).text,
             between, dmi_digits(v[2]).text);
    return out;
}

/* ---- words ---- */

/* Returns whether U+FFFE or U+FFFF begins here. */
static bool is_no_character(const char* words) {
    return strncmp(words, "\xef\xbf\xbe", 3) == 0 || strncmp(words, "\xef\xbf\xbf", 3) == 0;
}

void dmi_text_put_xml(dmi_text* text, const char* words) {
    for (; *words; words++) {
        if (is_no_character(words)) {
            dmi_text_add(text, "?", 1);
            words += 2;
            continue;
        }
        switch (*words) {
        case '&':
            dmi_text_add(text, "&amp;", 5);
            break;
        case '<':
            dmi_text_add(text, "&lt;", 4);
            break;
        case '>':
            dmi_text_add(text, "&gt;", 4);
            break;
        case '"':
            dmi_text_add(text, "&quot;", 6);
            break;
        default:
            dmi_text_add(text, (unsigned char)*words < ' ' ? "?" : words, 1);
        }
    }
}

void dmi_text_put_quoted(dmi_text* text, const char* words) {
    for (; *words; words++) {
        if (*words == '"') dmi_text_add(text, "\\", 1);
        dmi_text_add(text, (unsigned char)*words < ' ' || *words == '\\' ? "?" : words, 1);
    }
}

static bool is_legal(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

void dmi_legal_name(const char* start, const char* words, char* out, size_t size) {
    size_t length = (size_t)snprintf(out, size, "%s", start), most = length + DMI_RIG_WORDS;
    if (most > size - 1) most = size - 1;
    for (bool gap = true; *words && length + 1 < most; words++) {
        if (!is_legal(*words)) {
            gap = true;
            continue;
        }
        if (gap) out[length++] = '_';
        gap = false;
        out[length++] = *words;
    }
    out[length] = 0;
}
