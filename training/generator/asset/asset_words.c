/* Finds words in the lexicon of the library's hints. */
#include "asset/asset_words.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

typedef struct row {
    const char* words; /* separated by spaces */
    bool is_part;
} row;

enum group { PART = 1, OBJECT = 0 };
#define KIND(name, group, words) {words, group == PART},
static const row rows[] = {
#include "kinematics/hints/kinds.def"
};
#undef KIND

enum { ROWS = sizeof rows / sizeof *rows };

static bool has_word(const char* words, const char* word, size_t length) {
    for (const char* at = words; *at;) {
        const size_t own = strcspn(at, " ");
        if (own == length && memcmp(at, word, length) == 0) return true;
        at += own;
        at += strspn(at, " ");
    }
    return false;
}

int32_t dmg_word_row(const char* name) {
    int32_t found = -1;
    for (const char* at = name; *at;) {
        const size_t length = strcspn(at, "_0123456789");
        for (int32_t i = 0; i < ROWS && length > 0; ++i)
            if (rows[i].is_part && has_word(rows[i].words, at, length)) found = i;
        at += length;
        at += strspn(at, "_0123456789");
    }
    return found;
}

void dmg_copy_word(int32_t row, uint32_t index, char* out, size_t size) {
    const char* at = rows[row].words;
    uint32_t count = 1;
    for (const char* c = at; *c; ++c) count += *c == ' ';
    for (index %= count; index > 0; --index) at = strchr(at, ' ') + 1;
    snprintf(out, size, "%.*s", (int)strcspn(at, " "), at);
}

int32_t dmg_part_row(uint32_t index) {
    int32_t at = (int32_t)(index % ROWS);
    while (!rows[at].is_part) at = (at + 1) % ROWS;
    return at;
}
