/* Errors of the scripted player's hand: pulling straight, slow deviation, tremor. */
#include <math.h>

#include "dragbot.h"

static void pull_straight(bot_pull* pull) {
    const double *end = pull->path[pull->frames - 1], start[2] = {pull->x, pull->y};
    const double way[2] = {end[0] - start[0], end[1] - start[1]};
    for (int i = 0; i < pull->frames; i++) {
        const double share = bot_minimum_jerk((i + 1.0) / pull->frames);
        for (int k = 0; k < 2; k++) pull->path[i][k] = start[k] + share * way[k];
    }
}

/* Adds half a sine wave: no deviation at both ends, the largest half-way. */
static void add_deviation(bot_pull* pull, double share, random_state* random) {
    double most[2];
    for (int k = 0; k < 2; k++) most[k] = share * pull->length * random_normal(random);
    for (int i = 0; i < pull->frames; i++) {
        const double envelope = sin(PI * (i + 1.0) / pull->frames);
        for (int k = 0; k < 2; k++) pull->path[i][k] += envelope * most[k];
    }
}

static void add_tremor(bot_pull* pull, double pixels, random_state* random) {
    for (int i = 0; i + 1 < pull->frames; i++)
        for (int k = 0; k < 2; k++) pull->path[i][k] += pixels * random_normal(random);
}

void bot_hand_draw(const bot_hand* hand, random_state* random, bot_pull* pull) {
    if (hand->straight) pull_straight(pull);
    if (hand->wander > 0) add_deviation(pull, hand->wander, random);
    if (hand->tremor > 0) add_tremor(pull, hand->tremor, random);
}
