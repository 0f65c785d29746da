/* Words of a name in an asset: split at case, digits and signs, folded to lower case without accents. */
#ifndef DMI_HINTS_LABEL_WORDS_H
#define DMI_HINTS_LABEL_WORDS_H

#include <stdbool.h>
#include <stddef.h>

#define DMI_WORDS_MAX 16       /* most words of one name; further ones are not read; by hand */
#define DMI_WORD_LENGTH_MAX 48 /* most bytes of a word, with the terminating zero; the rest is cut; by hand */

typedef struct dmi_label_words {
    char words[DMI_WORDS_MAX][DMI_WORD_LENGTH_MAX]; /* UTF-8 */
    size_t count;
} dmi_label_words;

/* Splits the first `length` bytes of a name. Bytes that are not UTF-8 separate words. */
void dmi_split_label(const char* name, size_t length, dmi_label_words* out);

#endif
