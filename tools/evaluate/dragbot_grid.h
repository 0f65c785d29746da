/* Triangles in a grid of cubes: which of them a short way crosses. */
#ifndef CLI_DRAGBOT_GRID_H
#define CLI_DRAGBOT_GRID_H

#include <stdbool.h>
#include <stdint.h>

#include "vec.h"

typedef struct bot_triangle {
    vec corner, side[2]; /* from the first corner to the others */
    vec normal;          /* unit */
} bot_triangle;

typedef struct bot_grid {
    bot_triangle* triangles;
    uint32_t count;
    vec low;
    double cell;
    int size[3];
    uint32_t* first;       /* of each cell, in `members`; one more than cells */
    uint32_t* members;     /* triangles */
    uint32_t *seen, round; /* the last way that each triangle was compared with */
} bot_grid;

/* Takes the triangles, which must come from cli_alloc. To be freed. */
bot_grid bot_grid_new(bot_triangle* triangles, uint32_t count);
void bot_grid_free(bot_grid* grid);
/* Called with a triangle that the way crosses and the share of the way at which it does. */
typedef void (*bot_crossing)(void* user, uint32_t triangle, double share);
/* Reports every triangle that the way between two points crosses, once. */
void bot_grid_cross(bot_grid* grid, vec from, vec to, bot_crossing report, void* user);

#endif
