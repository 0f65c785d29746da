/* Text that comes from elsewhere (files, hosts, command lines) and may not be UTF-8. */
#ifndef DMI_BASE_UTF8_H
#define DMI_BASE_UTF8_H

#include <stdbool.h>
#include <stddef.h>

/* Whether `size` bytes are well-formed UTF-8 (Unicode 15, table 3-7): no surrogates, nothing overlong. */
bool dmi_utf8_is_valid(const char* text, size_t size);
/* Makes any text valid UTF-8, in place: a '?' takes the place of each piece that is no character, also of one that was
 * cut off. Valid text stays as it is. Returns the new length, never a longer one. */
size_t dmi_utf8_mend(char* text);
/* Compares what dmi_utf8_mend would make of `text` with `mended`, as strcmp does. */
int dmi_utf8_compare_mended(const char* text, const char* mended);

#endif
