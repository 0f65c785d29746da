#include "comments.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "text.h"

typedef struct comment {
    unsigned first, last; /* lines */
    bool trails;          /* code stands before it on its first line */
    char* text;
} comment;

struct comments {
    comment* list;
    unsigned count;
};

static unsigned line_of(CXSourceLocation location) {
    unsigned line = 0;
    clang_getFileLocation(location, NULL, &line, NULL, NULL);
    return line;
}

/* Copies a comment without its signs; stars that begin a line and runs of white space become one space. */
static char* plain(const char* raw) {
    const size_t length = strlen(raw);
    char* out = text_alloc(length + 1);
    size_t n = 0;
    bool line_begins = true;
    for (size_t i = 2; i + 2 < length; i++) {
        const char c = raw[i];
        if (c == '\n') line_begins = true;
        if (isspace((unsigned char)c) || (line_begins && c == '*')) {
            if (n > 0 && out[n - 1] != ' ') out[n++] = ' ';
            continue;
        }
        line_begins = false;
        out[n++] = c;
    }
    if (n > 0 && out[n - 1] == ' ') n--;
    out[n] = 0;
    return out;
}

static void add(comments* all, CXTranslationUnit unit, CXToken token, unsigned line_before) {
    const CXString spelling = clang_getTokenSpelling(unit, token);
    const char* raw = clang_getCString(spelling);
    if (strncmp(raw, "/* ----", 7) != 0) {
        const CXSourceRange range = clang_getTokenExtent(unit, token);
        comment* c = &all->list[all->count++];
        c->first = line_of(clang_getRangeStart(range)), c->last = line_of(clang_getRangeEnd(range));
        c->trails = c->first == line_before;
        c->text = plain(raw);
    }
    clang_disposeString(spelling);
}

comments* comments_read(CXTranslationUnit unit, CXFile file) {
    size_t size = 0;
    clang_getFileContents(unit, file, &size);
    const CXSourceRange whole = clang_getRange(clang_getLocationForOffset(unit, file, 0),
                                               clang_getLocationForOffset(unit, file, (unsigned)size));
    CXToken* tokens = NULL;
    unsigned count = 0, line_before = 0;
    clang_tokenize(unit, whole, &tokens, &count);
    comments* all = text_alloc(sizeof *all);
    *all = (comments){.list = text_alloc((count + 1) * sizeof *all->list)};
    for (unsigned i = 0; i < count; i++) {
        if (clang_getTokenKind(tokens[i]) == CXToken_Comment)
            add(all, unit, tokens[i], line_before);
        else
            line_before = line_of(clang_getRangeEnd(clang_getTokenExtent(unit, tokens[i])));
    }
    clang_disposeTokens(unit, tokens, count);
    return all;
}

void comments_free(comments* all) {
    for (unsigned i = 0; i < all->count; i++) free(all->list[i].text);
    free(all->list);
    free(all);
}

const char* comments_of(const comments* all, CXCursor declaration) {
    const CXSourceRange range = clang_getCursorExtent(declaration);
    const unsigned first = line_of(clang_getRangeStart(range)), last = line_of(clang_getRangeEnd(range));
    for (unsigned i = 0; i < all->count; i++) {
        const comment* c = &all->list[i];
        if (c->trails ? c->first == last : c->last + 1 == first) return c->text;
    }
    return NULL;
}
