/* Kinds of props: files that become prepared objects and go again. */
#ifndef SAMPLE_KINDS_H
#define SAMPLE_KINDS_H

#include "stream.h"

/* Starts a job that brings a kind in, unless it is here, or too many are under way. */
void kind_request(kind* k);
/* Counts those that have come since. */
void kinds_notice(stream* s);
/* Destroys the object of one kind that no prop needs. */
void kinds_drop_one(stream* s);

#endif
