/* UTF-8: what is well-formed, and a '?' for what is not. */
#include "base/utf8.h"

#include <stdint.h>
#include <string.h>

/* Well-formed sequences by their first byte (Unicode 15, table 3-7): the second byte has a range of its own, those
 * after it are 80..BF. */
typedef struct row {
    uint8_t first, last; /* range of the first byte */
    uint8_t low, high;   /* range of the second */
    uint8_t length;
} row;

static const row rows[] = {{0x00, 0x7F, 0x00, 0x00, 1}, {0xC2, 0xDF, 0x80, 0xBF, 2}, {0xE0, 0xE0, 0xA0, 0xBF, 3},
                           {0xE1, 0xEC, 0x80, 0xBF, 3}, {0xED, 0xED, 0x80, 0x9F, 3}, {0xEE, 0xEF, 0x80, 0xBF, 3},
                           {0xF0, 0xF0, 0x90, 0xBF, 4}, {0xF1, 0xF3, 0x80, 0xBF, 4}, {0xF4, 0xF4, 0x80, 0x8F, 4}};

static const row* row_of(uint8_t byte) {
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (byte >= rows[i].first && byte <= rows[i].last) return &rows[i];
    return NULL;
}

/* Returns the length of the piece that `text` begins with: a character, or the longest beginning of one that is not
 * complete, or a byte that begins none. */
static size_t piece(const char* text, size_t size, bool* out_whole) {
    const uint8_t* bytes = (const uint8_t*)text;
    const row* kind = row_of(bytes[0]);
    size_t length = 1;
    while (kind != NULL && length < kind->length && length < size) {
        const uint8_t low = length == 1 ? kind->low : 0x80, high = length == 1 ? kind->high : 0xBF;
        if (bytes[length] < low || bytes[length] > high) break;
        length++;
    }
    *out_whole = kind != NULL && length == kind->length;
    return length;
}

bool dmi_utf8_is_valid(const char* text, size_t size) {
    bool whole = true;
    for (size_t at = 0; at < size && whole;) {
        if ((uint8_t)text[at] < 0x80)
            at++;
        else
            at += piece(text + at, size - at, &whole);
    }
    return whole;
}

size_t dmi_utf8_mend(char* text) {
    const size_t size = strlen(text);
    size_t to = 0;
    for (size_t at = 0; at < size;) {
        bool whole;
        const size_t length = piece(text + at, size - at, &whole);
        if (whole)
            memmove(text + to, text + at, length);
        else
            text[to] = '?';
        to += whole ? length : 1;
        at += length;
    }
    text[to] = 0;
    return to;
}

int dmi_utf8_compare_mended(const char* text, const char* mended) {
    const size_t size = strlen(text);
    for (size_t at = 0; at < size;) {
        bool whole;
        const size_t length = piece(text + at, size - at, &whole), taken = whole ? length : 1;
        const int order = strncmp(whole ? text + at : "?", mended, taken);
        if (order != 0) return order;
        mended += taken;
        at += length;
    }
    return *mended == 0 ? 0 : -1;
}
