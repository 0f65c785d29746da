/* Looks words up in the lexicon of kinds.def: exactly, in the plural, as an end or beginning, with one letter wrong. */
#include "kinematics/hints/part_kind.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "kinematics/hints/label_words.h"

#define LEAST_AFFIX 4        /* bytes of a word that may be the end or beginning of another; by hand */
#define LEAST_MISSPELT 5     /* bytes of a word that may have a wrong letter; by hand */
#define FIRST_IDEOGRAPH 0xE3 /* lead byte from which characters are ideographs or syllables, words without spaces */

enum { GROUP_OBJECT, GROUP_PART };

typedef struct entry {
    const char* name;
    const char* words;
    int group;
} entry;

static const entry lexicon[DMI_KIND_COUNT] = {
#define KIND(name, group, words) {#name, words, GROUP_##group},
#include "kinematics/hints/kinds.def"
#undef KIND
};

/* How a word of the lexicon is found in a word of a label, best first. */
typedef enum match { MATCH_EXACT, MATCH_PLURAL, MATCH_END, MATCH_BEGINNING, MATCH_MISSPELT, MATCH_NONE } match;

typedef struct finding {
    dmi_part_kind kind;
    match match;
    size_t length; /* length of the lexicon's word */
} finding;

static bool is_ideographic(const char* word) {
    return (unsigned char)*word >= FIRST_IDEOGRAPH;
}

/* Returns whether one letter added, left out, changed or swapped with the next makes one word of the other. */
static bool is_misspelt(const char* a, size_t a_length, const char* b, size_t b_length) {
    if (a_length < LEAST_MISSPELT || b_length < LEAST_MISSPELT || *a != *b) return false;
    size_t first = 0, last = 0;
    const size_t shorter = a_length < b_length ? a_length : b_length;
    while (first < shorter && a[first] == b[first]) first++;
    while (last < shorter - first && a[a_length - 1 - last] == b[b_length - 1 - last]) last++;
    const size_t a_left = a_length - first - last, b_left = b_length - first - last;
    if (a_left <= 1 && b_left <= 1) return true;
    return a_left == 2 && b_left == 2 && a[first] == b[first + 1] && a[first + 1] == b[first];
}

static match match_words(const char* label, size_t label_length, const char* word, size_t length) {
    const bool begins = length <= label_length && memcmp(label, word, length) == 0;
    if (begins && length == label_length) return MATCH_EXACT;
    if (begins && length + 1 == label_length && label[length] == 's') return MATCH_PLURAL;
    if (length < label_length && (length >= LEAST_AFFIX || is_ideographic(word))) {
        if (memcmp(label + label_length - length, word, length) == 0) return MATCH_END;
        if (begins) return MATCH_BEGINNING;
    }
    return is_misspelt(label, label_length, word, length) ? MATCH_MISSPELT : MATCH_NONE;
}

/* Finds the best match of a word among all kinds; of equally good ones, the longest. */
static finding find_word(const char* word) {
    finding best = {DMI_KIND_NOTHING, MATCH_NONE, 0};
    const size_t label_length = strlen(word);
    for (int kind = 0; kind < DMI_KIND_COUNT; kind++) {
        for (const char* at = lexicon[kind].words; *at != 0;) {
            const size_t length = strcspn(at, " ");
            const match how = match_words(word, label_length, at, length);
            if (how < best.match || (how == best.match && how != MATCH_NONE && length > best.length))
                best = (finding){(dmi_part_kind)kind, how, length};
            at += length + (at[length] == ' ');
        }
    }
    return best;
}

/* Finds the kind of two words written as one, such as "trap door". It takes exact matches alone. */
static dmi_part_kind find_pair(const char* first, const char* second) {
    char both[2 * DMI_WORD_LENGTH_MAX];
    snprintf(both, sizeof both, "%s%s", first, second);
    const finding found = find_word(both);
    return found.match <= MATCH_PLURAL ? found.kind : DMI_KIND_NOTHING;
}

/* Finds the noun behind a modifier in one word, such as "rolltor". */
static dmi_part_kind find_behind_modifier(const char* word) {
    const char* noun;
    if (dmi_modifiers_of_word(word, &noun) == 0 || noun == NULL) return DMI_KIND_NOTHING;
    const finding found = find_word(noun);
    return found.match <= MATCH_PLURAL ? found.kind : DMI_KIND_NOTHING;
}

/* Finds the kind of a word: that of the word itself or, where this is only similar to one of the lexicon, of the noun
 * behind a modifier. */
static dmi_part_kind kind_of_word(const char* word) {
    const finding found = find_word(word);
    if (found.match <= MATCH_PLURAL) return found.kind;
    const dmi_part_kind noun = find_behind_modifier(word);
    return noun != DMI_KIND_NOTHING ? noun : found.kind;
}

/* Finds the kind that one name tells. The last word counts, as the noun of a compound; a part's word goes before an
 * object's. */
static dmi_part_kind find_in_name(const char* name, size_t length, int group) {
    dmi_label_words split;
    dmi_split_label(name, length, &split);
    for (size_t i = split.count; i-- > 0;) {
        dmi_part_kind kind = i > 0 ? find_pair(split.words[i - 1], split.words[i]) : DMI_KIND_NOTHING;
        if (kind == DMI_KIND_NOTHING) kind = kind_of_word(split.words[i]);
        if (kind != DMI_KIND_NOTHING && lexicon[kind].group == group) return kind;
    }
    return DMI_KIND_NOTHING;
}

/* Finds the kind and how deep the name is that tells it. */
static dmi_label_kind find_in_label(const char* label) {
    for (int group = GROUP_PART; group >= GROUP_OBJECT; group--) {
        const char* end = label + strlen(label);
        for (uint32_t depth = 0;; depth++) {
            const char* name = end;
            while (name > label && name[-1] != '/') name--;
            const dmi_part_kind kind = find_in_name(name, (size_t)(end - name), group);
            if (kind != DMI_KIND_NOTHING) return (dmi_label_kind){.kind = kind, .depth = depth};
            if (name == label) break;
            end = name - 1;
        }
    }
    return (dmi_label_kind){.kind = DMI_KIND_NOTHING};
}

dmi_label_kind dmi_kind_of_label(const char* label) {
    if (label == NULL) return (dmi_label_kind){.kind = DMI_KIND_NOTHING};
    dmi_label_kind found = find_in_label(label);
    found.modifiers = dmi_modifiers_of_label(label);
    const uint32_t all = found.modifiers.own | found.modifiers.above;
    if (found.kind == DMI_KIND_DOOR && all >> DMI_MODIFIER_SLIDING & 1) found.kind = DMI_KIND_SLIDING_DOOR;
    if (found.kind == DMI_KIND_DOOR && found.modifiers.own >> DMI_MODIFIER_HATCH & 1) found.kind = DMI_KIND_TRAPDOOR;
    return found;
}

const char* dmi_kind_name(dmi_part_kind kind) {
    return kind >= 0 && kind < DMI_KIND_COUNT ? lexicon[kind].name : NULL;
}
