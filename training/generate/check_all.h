/* Declares the generator's checks over many objects. */
#ifndef GENERATE_CHECK_ALL_H
#define GENERATE_CHECK_ALL_H

#include <stdint.h>

/* Prints per category the share of parts that run into the body or come off it over their joint's range. */
int check_all(const uint32_t* categories, uint32_t count, uint32_t seeds, uint64_t first_seed, int verbose);

#endif
