/* Words of a name in an asset: split at case, digits and signs, folded to lower case without accents. Some words
 * are modifiers: beside the noun they say how a leaf moves or where it hangs, as in sliding, garage, left. */
#ifndef DMI_HINTS_LABEL_WORDS_H
#define DMI_HINTS_LABEL_WORDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define DMI_WORDS_MAX 16       /* most words of one name; further ones are not read; by hand */
#define DMI_WORD_LENGTH_MAX 48 /* most bytes of a word, with the terminating zero; the rest is cut; by hand */

typedef struct dmi_label_words {
    char words[DMI_WORDS_MAX][DMI_WORD_LENGTH_MAX]; /* UTF-8 */
    size_t count;
} dmi_label_words;

/* Splits the first `length` bytes of a name. Bytes that are not UTF-8 separate words. */
void dmi_split_label(const char* name, size_t length, dmi_label_words* out);

typedef enum dmi_modifier {
#define MODIFIER(name, words) DMI_MODIFIER_##name,
#include "kinematics/hints/modifiers.def"
#undef MODIFIER
    DMI_MODIFIER_COUNT
} dmi_modifier;

/* Returns the modifiers that one folded word tells, a bit each. out_rest: what follows the longest modifier that begins
 * a longer word, such as "tor" in "rolltor"; else NULL. */
uint32_t dmi_modifiers_of_word(const char* word, const char** out_rest);
/* Modifiers that a label tells, a bit each: those of its last name, and those of the names above it. */
typedef struct dmi_label_modifiers {
    uint32_t own, above;
} dmi_label_modifiers;
/* Returns the modifiers that all names of a label tell. label NULL: none. */
dmi_label_modifiers dmi_modifiers_of_label(const char* label);

#endif
