/* Splits names into words, and looks words up in modifiers.def. A letter is an ASCII letter or any character beyond
 * ASCII. For modifiers, a label is a bag of words: their order says nothing. */
#include "kinematics/hints/label_words.h"

#include <string.h>

#define LEAST_BEGINNING 4 /* bytes of a modifier that may begin a longer word; by hand */

/* Unicode blocks whose letters are folded. */
enum {
    FIRST_CONTINUATION = 0x80,
    FIRST_LATIN = 0xC0,      /* first and last of Latin-1's letters */
    LAST_LATIN = 0x17F,      /* last letter of Latin Extended-A */
    FIRST_COMBINING = 0x300, /* accents that follow their letter */
    LAST_COMBINING = 0x36F,
    CYRILLIC_UPPER = 0x410,
    CYRILLIC_LOWER = 0x430,
    CYRILLIC_COUNT = 0x20,
    LAST_CHARACTER = 0x10FFFF
};

/* Base letters of U+00C0 to U+017F, without accents; '*' is no letter. */
static const char latin[] = "aaaaaaaceeeeiiiidnooooo*ouuuuytsaaaaaaaceeeeiiiidnooooo*ouuuuyty"
                            "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll"
                            "lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";

/* Lead bytes of characters of two, three and four bytes, and the least character that needs so many. */
typedef struct utf8_form {
    uint8_t mask, lead;
    uint32_t least;
} utf8_form;

static const utf8_form utf8_forms[] = {{0xE0, 0xC0, 0x80}, {0xF0, 0xE0, 0x800}, {0xF8, 0xF0, 0x10000}};

typedef struct splitter {
    dmi_label_words* out;
    size_t length; /* length of the word in progress */
} splitter;

static bool is_upper(char c) {
    return c >= 'A' && c <= 'Z';
}

static bool is_lower(char c) {
    return c >= 'a' && c <= 'z';
}

static void end_word(splitter* s) {
    if (s->length > 0) s->out->count++;
    s->length = 0;
}

/* Appends the bytes of one character; a character that does not fit is left out. */
static void append_bytes(splitter* s, const char* bytes, size_t count) {
    if (s->out->count == DMI_WORDS_MAX || s->length + count >= DMI_WORD_LENGTH_MAX) return;
    char* word = s->out->words[s->out->count];
    memcpy(word + s->length, bytes, count);
    s->length += count;
    word[s->length] = 0;
}

/* Decodes the character at `at`. Returns how many bytes it has, or 0 where there is no valid UTF-8. */
static size_t decode_character(const char* at, const char* end, uint32_t* out_character) {
    static const uint8_t tail_mask = 0xC0, tail_bits = 6, payload = 0x3F;
    for (size_t form = 0; form < sizeof utf8_forms / sizeof *utf8_forms; form++) {
        const uint8_t first = (uint8_t)*at;
        const size_t bytes = form + 2;
        if ((first & utf8_forms[form].mask) != utf8_forms[form].lead || (size_t)(end - at) < bytes) continue;
        uint32_t character = first & (uint8_t)~utf8_forms[form].mask;
        for (size_t i = 1; i < bytes; i++) {
            const uint8_t tail = (uint8_t)at[i];
            if ((tail & tail_mask) != FIRST_CONTINUATION) return 0;
            character = character << tail_bits | (tail & payload);
        }
        *out_character = character;
        return character >= utf8_forms[form].least && character <= LAST_CHARACTER ? bytes : 0;
    }
    return 0;
}

/* Appends a character beyond ASCII, folded. */
static void append_wide(splitter* s, const char* bytes, size_t count, uint32_t character) {
    if (character >= FIRST_COMBINING && character <= LAST_COMBINING) return;
    if (character >= FIRST_LATIN && character <= LAST_LATIN) {
        const char* letter = &latin[character - FIRST_LATIN];
        if (*letter == '*')
            end_word(s);
        else
            append_bytes(s, letter, 1);
    } else if (character >= CYRILLIC_UPPER && character < CYRILLIC_UPPER + CYRILLIC_COUNT) {
        static const uint8_t lead = 0xC0, tail = 0x80, tail_bits = 6, payload = 0x3F;
        const uint32_t lower = character - CYRILLIC_UPPER + CYRILLIC_LOWER;
        const char folded[2] = {(char)(lead | lower >> tail_bits), (char)(tail | (lower & payload))};
        append_bytes(s, folded, sizeof folded);
    } else {
        append_bytes(s, bytes, count);
    }
}

/* Returns whether a word begins at an upper-case letter: after a lower-case one, or before one after others. */
static bool begins_word(const char* name, const char* at, const char* end) {
    if (!is_upper(*at) || at == name) return false;
    return is_lower(at[-1]) || (is_upper(at[-1]) && at + 1 < end && is_lower(at[1]));
}

void dmi_split_label(const char* name, size_t length, dmi_label_words* out) {
    splitter s = {.out = out};
    out->count = 0;
    const char* end = name + length;
    for (const char* at = name; at < end && out->count < DMI_WORDS_MAX;) {
        size_t bytes = 1;
        if (is_upper(*at) || is_lower(*at)) {
            const char letter = is_upper(*at) ? (char)(*at - 'A' + 'a') : *at;
            if (begins_word(name, at, end)) end_word(&s);
            append_bytes(&s, &letter, 1);
        } else {
            uint32_t character = 0;
            const size_t wide = (uint8_t)*at >= FIRST_CONTINUATION ? decode_character(at, end, &character) : 0;
            if (wide > 0)
                append_wide(&s, at, wide, character);
            else
                end_word(&s);
            if (wide > 0) bytes = wide;
        }
        at += bytes;
    }
    end_word(&s);
}

/* ---- modifiers ---- */

static const char* const words_of[DMI_MODIFIER_COUNT] = {
#define MODIFIER(name, words) words,
#include "kinematics/hints/modifiers.def"
#undef MODIFIER
};

uint32_t dmi_modifiers_of_word(const char* word, const char** out_rest) {
    const size_t length = strlen(word);
    size_t longest = 0;
    uint32_t exact = 0, begun = 0;
    for (int i = 0; i < DMI_MODIFIER_COUNT; i++) {
        for (const char* at = words_of[i]; *at != 0;) {
            const size_t own = strcspn(at, " ");
            if (own <= length && memcmp(word, at, own) == 0) {
                if (own == length) exact |= 1u << i;
                if (own < length && own >= LEAST_BEGINNING && own >= longest) {
                    begun = own > longest ? 1u << i : begun | 1u << i;
                    longest = own;
                }
            }
            at += own + (at[own] == ' ');
        }
    }
    *out_rest = exact == 0 && longest > 0 ? word + longest : NULL;
    return exact != 0 ? exact : begun;
}

dmi_label_modifiers dmi_modifiers_of_label(const char* label) {
    dmi_label_modifiers found = {0, 0};
    for (const char* name = label; name != NULL;) {
        dmi_label_words split;
        const size_t length = strcspn(name, "/");
        dmi_split_label(name, length, &split);
        found.above |= found.own;
        found.own = 0;
        for (size_t i = 0; i < split.count; i++) {
            const char* rest;
            found.own |= dmi_modifiers_of_word(split.words[i], &rest);
        }
        name = name[length] == '/' ? name + length + 1 : NULL;
    }
    return found;
}
