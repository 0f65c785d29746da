/* Looks the words of a label up in modifiers.def. The label is a bag of words: their order says nothing. */
#include "kinematics/hints/label_modifiers.h"

#include <string.h>

#include "kinematics/hints/label_words.h"

#define LEAST_BEGINNING 4 /* bytes of a modifier that may begin a longer word; by hand */

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
