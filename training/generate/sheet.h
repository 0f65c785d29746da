/* Contact sheets: many objects in one picture, at rest and open. */
#ifndef GENERATE_SHEET_H
#define GENERATE_SHEET_H

#include <stdint.h>

/* A row a category, `columns` seeds each, every object drawn twice: at rest and with its parts open. 0 on success. */
int sheet_write(const char* path, const uint32_t* categories, uint32_t count, uint32_t columns, uint64_t first_seed,
                uint32_t flags);

#endif
