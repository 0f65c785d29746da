/* Declares words for parts, from the lexicon by which the library reads names. */
#ifndef DMG_ASSET_WORDS_H
#define DMG_ASSET_WORDS_H

#include <stddef.h>
#include <stdint.h>

/* Returns the row of the lexicon that has a word of the name, whose words are joined by '_'; the last word that is in a
 * row of parts counts. -1: none. */
int32_t dmg_word_row(const char* name);
/* Copies a word of the row, which stands for the same in some language: the one at `index`, modulo their number. */
void dmg_copy_word(int32_t row, uint32_t index, char* out, size_t size);
/* Returns a row of parts, by any number. */
int32_t dmg_part_row(uint32_t index);

#endif
