/* How the scripted player's hand goes wrong: it pulls straight, wanders off the way, and trembles. */
#include <math.h>

#include "dragbot.h"

static void pull_straight(bot_pull* pull) {
    const double *end = pull->path[pull->frames - 1], start[2] = {pull->x, pull->y};
    const double way[2] = {end[0] - start[0], end[1] - start[1]};
    for (int i = 0; i < pull->frames; i++) {
        const double share = bot_pace((i + 1.0) / pull->frames);
        for (int k = 0; k < 2; k++) pull->path[i][k] = start[k] + share * way[k];
    }
}

/* Half a sine wave across the screen: right at both ends, farthest off half-way. */
static void wander(bot_pull* pull, double share, random_state* random) {
    double most[2];
    for (int k = 0; k < 2; k++) most[k] = share * pull->length * random_normal(random);
    for (int i = 0; i < pull->frames; i++) {
        const double swell = sin(CLI_PI * (i + 1.0) / pull->frames);
        for (int k = 0; k < 2; k++) pull->path[i][k] += swell * most[k];
    }
}

static void tremble(bot_pull* pull, double pixels, random_state* random) {
    for (int i = 0; i + 1 < pull->frames; i++)
        for (int k = 0; k < 2; k++) pull->path[i][k] += pixels * random_normal(random);
}

void bot_hand_draw(const bot_hand* hand, random_state* random, bot_pull* pull) {
    if (hand->straight) pull_straight(pull);
    if (hand->wander > 0) wander(pull, hand->wander, random);
    if (hand->tremor > 0) tremble(pull, hand->tremor, random);
}
