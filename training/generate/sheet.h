/* Declares contact sheets: many objects in one picture, at rest and open. */
#ifndef GENERATE_SHEET_H
#define GENERATE_SHEET_H

#include <stdint.h>

/* Writes a picture with a row per category and `columns` seeds each; every object is drawn at rest and with its parts
 * open. assets: not as dmg_make makes it but as an asset, its nodes in different shades. Returns 0 on success. */
int sheet_write(const char* path, const uint32_t* categories, uint32_t count, uint32_t columns, uint64_t first_seed,
                uint32_t flags, int assets);

#endif
