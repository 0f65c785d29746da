/* Pictures of wrong answers: what to look at to learn why. */
#ifndef CLI_MISTAKES_H
#define CLI_MISTAKES_H

#include <stdio.h>

#include "metrics.h"
#include "picture.h"

/* A folder that gets a strip of pictures a mistake (at rest, open as the truth has it, open as answered; the true axis
 * blue, the answered one red, the drag green), sheets of many strips, and index.txt with a line a strip. */
typedef struct mistake_book {
    const char* folder;
    FILE* index;
    int count;     /* strips so far */
    picture sheet; /* of the last strips; rgb NULL: none begun */
} mistake_book;

/* Makes the folder. 0, or -1 with a line on standard error. */
int mistakes_open(mistake_book* book, const char* folder);
/* The session holds the object just answered; row says how wrong it is. up: 'x', 'y' or 'z'. */
dm_result mistakes_add(mistake_book* book, session* session, const metric_case* known, const answer* answer,
                       const metric_row* row, char up);
/* 0, or -1 when something could not be written. */
int mistakes_close(mistake_book* book);

#endif
