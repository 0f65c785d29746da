/* The comments of a header, and which declaration each belongs to. */
#ifndef DESCRIBE_COMMENTS_H
#define DESCRIBE_COMMENTS_H

#include <clang-c/Index.h>

typedef struct comments comments;

/* Collects the comments of one file. Banners, which begin with "/" "* ----", are left out. */
comments* comments_read(CXTranslationUnit unit, CXFile file);
void comments_free(comments* all);

/* Returns the text of the comment that ends on the line above a declaration, or begins on its last line behind it. One
 * text without comment signs, line breaks as spaces; NULL: there is none. Lives as long as `all`. */
const char* comments_of(const comments* all, CXCursor declaration);

#endif
