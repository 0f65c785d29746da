/* The path that the scripted player's hand draws: pulling straight, along an axis, slow deviation, tremor. */
#include <math.h>

#include "dragbot.h"

static const double least_path = 10; /* px; by hand, as of the true path */

static void pull_straight(bot_pull* pull) {
    const double *end = pull->path[pull->frames - 1], start[2] = {pull->x, pull->y};
    const double way[2] = {end[0] - start[0], end[1] - start[1]};
    for (int i = 0; i < pull->frames; i++) {
        const double share = bot_minimum_jerk((i + 1.0) / pull->frames);
        for (int k = 0; k < 2; k++) pull->path[i][k] = start[k] + share * way[k];
    }
}

/* Returns the part of `way` along the axis of the file that is nearest to `direction`. */
static vec along_axis(vec direction, vec way) {
    const double x = fabs(direction.x), y = fabs(direction.y), z = fabs(direction.z);
    if (x >= y && x >= z) return (vec){way.x, 0, 0};
    return y >= z ? (vec){0, way.y, 0} : (vec){0, 0, way.z};
}

/* Pulls as far along the axis as the true motion's end lies along it. */
static bool pull_along_axis(const bot_view* view, const known_joint* truth, bot_pull* pull) {
    const vec end = bot_true_move(truth, pull->point, pull->asked);
    const vec way = along_axis(bot_true_direction(truth, pull->point, pull->asked), sub(end, pull->point));
    pull->length = 0;
    for (int i = 0; i < pull->frames; i++) {
        const double share = bot_minimum_jerk((i + 1.0) / pull->frames);
        double* at = pull->path[i];
        if (!bot_view_project(view, add(pull->point, scale(way, share)), &at[0], &at[1])) return false;
        if (!bot_view_on_screen(at[0], at[1])) return false;
        const double x = i ? pull->path[i - 1][0] : pull->x, y = i ? pull->path[i - 1][1] : pull->y;
        pull->length += hypot(at[0] - x, at[1] - y);
    }
    return pull->length >= least_path;
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

bool bot_hand_draw(const bot_hand* hand, const bot_view* view, const known_joint* truth, random_state* random,
                   bot_pull* pull) {
    if (hand->axis && !pull_along_axis(view, truth, pull)) return false;
    if (hand->straight) pull_straight(pull);
    if (hand->wander > 0) add_deviation(pull, hand->wander, random);
    if (hand->tremor > 0) add_tremor(pull, hand->tremor, random);
    return true;
}
