/* Text that grows, for files that are written. It is the same on every machine and in every locale. */
#ifndef DMI_EXPORT_RIG_TEXT_H
#define DMI_EXPORT_RIG_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/env.h"

typedef struct dmi_text {
    dmi_env* env;
    char* data; /* `size` bytes, and a zero behind them */
    size_t size, capacity;
    bool failed; /* there was no memory, and what is added afterwards is left out */
} dmi_text;

void dmi_text_free(dmi_text* text);
/* Adds text as printf makes it. Numbers with a point go through dmi_digits. */
void dmi_text_put(dmi_text* text, const char* format, ...) DMI_PRINTF(2, 3);
void dmi_text_add(dmi_text* text, const char* added, size_t size);

/* Numbers as text, by value: dmi_text_put(t, "%s", dmi_digits(x).text). */
typedef struct dmi_digits_text {
    char text[32];
} dmi_digits_text;
typedef struct dmi_digits3_text {
    char text[3 * sizeof(dmi_digits_text) + 6];
} dmi_digits3_text;
dmi_digits_text dmi_digits(double x);         /* returns 12 digits */
dmi_digits_text dmi_digits_of_float(float x); /* returns 9 digits, which give the float back */
/* Returns three numbers as text, with `between` after the first two; it has 2 bytes at most. */
dmi_digits3_text dmi_digits3(const double v[3], const char* between);

/* Adds any text as the content of an attribute in quotes or of an element. Characters that XML cannot hold become
 * '?'. */
void dmi_text_put_xml(dmi_text* text, const char* words);
/* Adds any text within "…" of USD and Godot, whose escapes are C's. A backslash becomes '?' too, because tinyusdz takes
 * one before the closing quote for an escape of that, whatever stands before it. */
void dmi_text_put_quoted(dmi_text* text, const char* words);

/* Writes a name that every format takes: START, '_' and letters, digits and single '_' of `words`. size: bytes of
 * `out`. */
void dmi_legal_name(const char* start, const char* words, char* out, size_t size);

#endif
