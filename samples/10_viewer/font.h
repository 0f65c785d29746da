/* A stroke font: letters as lines, readable at any size. Capitals are 1 high. */
#ifndef VIEWER_FONT_H
#define VIEWER_FONT_H

enum { FONT_STROKES = 64 }; /* most line segments of a glyph */

typedef struct font_stroke {
    float x0, y0, x1, y1; /* from the left end of the base line, y up */
} font_stroke;

float font_advance(char letter);
int font_glyph(char letter, font_stroke out_strokes[FONT_STROKES]); /* how many */

#endif
