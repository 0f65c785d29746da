/* Rows of props on both sides of a street that runs along -z. */
#include "level.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define QUARTER_TURN 1.57079633f /* rad */
#define SCATTER 0.12f            /* of the pitch: how far a prop is from its place in the grid, at most */

/* A number that looks random, the same on every run. */
static uint32_t scramble(uint32_t x) {
    x ^= x >> 16, x *= 0x7feb352dU, x ^= x >> 15, x *= 0x846ca68bU;
    return x ^ x >> 16;
}

static float scatter(uint32_t seed) {
    return SCATTER * PITCH * ((float)(scramble(seed) & 0xffff) / 32768.0f - 1);
}

dm_pose level_place(const prop* p, float bottom) {
    const float half = p->x < 0 ? 0.5f * QUARTER_TURN : -0.5f * QUARTER_TURN; /* objects face +z */
    const float rotation[4] = {0, sinf(half), 0, cosf(half)};
    dm_pose place = {{0, 0, 0, 1}, {0, 0, 0, 0}};
    dm_pose_from_rotation(rotation, (dm_vec3){p->x, -bottom, p->z}, &place);
    return place;
}

static prop make_prop(uint32_t index, uint32_t kinds) {
    const uint32_t row = index / COLUMNS, column = index % COLUMNS, district = row / DISTRICT_ROWS;
    const uint32_t choice = scramble(index) % DISTRICT_KINDS;
    const uint32_t from_street = column / 2;
    const float side = column % 2 ? 1.0f : -1.0f;
    return (prop){.kind = (district * (DISTRICT_KINDS - 2) + choice) % kinds,
                  .x = side * (STREET + PITCH * (float)from_street) + scatter(2 * index),
                  .z = -PITCH * (float)row + scatter(2 * index + 1)};
}

bool level_make(level* l, uint32_t props, uint32_t kinds) {
    *l = (level){.props = calloc(props, sizeof(prop)),
                 .kept = calloc(MOST_KEPT, sizeof(kept_part)),
                 .prop_count = props,
                 .row_count = (props + COLUMNS - 1) / COLUMNS,
                 .kind_count = kinds};
    if (l->props == NULL || l->kept == NULL) return false;
    for (uint32_t i = 0; i < props; i++) l->props[i] = make_prop(i, kinds);
    return true;
}

void level_free(level* l) {
    free(l->props);
    free(l->kept);
}

float level_length(const level* l) {
    return PITCH * (float)(l->row_count - 1);
}

const kept_part* level_kept(const level* l, uint32_t prop, uint32_t part) {
    for (uint32_t i = 0; i < l->kept_count; i++)
        if (l->kept[i].prop == prop && l->kept[i].part == part) return &l->kept[i];
    return NULL;
}

void level_keep(level* l, uint32_t prop, uint32_t part, const dm_part_state* state) {
    const kept_part* before = level_kept(l, prop, part);
    if (before == NULL && l->kept_count == MOST_KEPT) return;
    const uint32_t at = before != NULL ? (uint32_t)(before - l->kept) : l->kept_count++;
    l->kept[at] = (kept_part){prop, part, *state};
}
