/* The generator's checks over many objects. */
#ifndef GENERATE_CHECK_ALL_H
#define GENERATE_CHECK_ALL_H

#include <stdint.h>

/* Prints, a category, which share of the parts runs into the body or comes off it on the way its joint says. */
int check_all(const uint32_t* categories, uint32_t count, uint32_t seeds, uint64_t first_seed, int verbose);

#endif
