/* Chooses where the scripted player grabs, and the path of its mouse: the projection of the true motion. */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "dragbot.h"

/* All by hand. */
enum { MIN_SAMPLES = 12 };            /* samples of a part, with neighbours of the same part */
enum { TRIES = 24 };                  /* places on a part */
static const double least_arm = 0.3;  /* share of the largest visible distance to the axis: nobody grabs at the hinge */
static const double least_path = 10;  /* px */
static const double hand_speed = 600; /* px a second, at most; and two seconds at least */
/* Two places look the same when they are nearer than a share of the screen's height and of the path's length; they are
 * far apart when their values differ by a share of the asked value. */
static const double alike_share = 0.02, alike_way = 0.1, far_share = 0.25;

/* ---- path ---- */

double bot_minimum_jerk(double s) {
    return s * s * s * (10 - 15 * s + 6 * s * s);
}

/* Projects the true motion; returns the longest step of a frame, pixels; infinite when it leaves the screen. */
static double project_path(const bot_view* view, const known_joint* truth, int frames, bot_pull* pull) {
    double longest = 0;
    pull->length = 0;
    pull->frames = frames;
    for (int i = 0; i < frames; i++) {
        const double value = pull->asked * bot_minimum_jerk((i + 1.0) / frames);
        double* at = pull->path[i];
        if (!bot_view_project(view, bot_true_move(truth, pull->point, value), &at[0], &at[1])) return INFINITY;
        if (!bot_view_on_screen(at[0], at[1])) return INFINITY;
        const double x = i ? pull->path[i - 1][0] : pull->x, y = i ? pull->path[i - 1][1] : pull->y;
        const double step = hypot(at[0] - x, at[1] - y);
        pull->length += step;
        longest = fmax(longest, step);
    }
    return longest;
}

/* Whether two values far apart look the same: the circle of a hinge seen edge on goes out and back over itself, where
 * the pointer is ambiguous. */
static bool is_folded(const known_joint* truth, const bot_pull* pull) {
    const double alike = fmin(alike_share * BOT_HEIGHT, alike_way * pull->length), far = fabs(far_share * pull->asked);
    for (int i = 0; i < pull->frames; i++) {
        for (int k = 0; k < i; k++) {
            const double apart = fabs(pull->asked) * (bot_minimum_jerk((i + 1.0) / pull->frames) -
                                                      bot_minimum_jerk((k + 1.0) / pull->frames));
            if (apart < far || (!truth->slides && apart > PI)) continue;
            const double *a = pull->path[i], *b = pull->path[k];
            if (hypot(a[0] - b[0], a[1] - b[1]) < alike) return true;
        }
    }
    return false;
}

static bool make_path(const bot_view* view, const known_joint* truth, bot_pull* pull) {
    const double longest = project_path(view, truth, BOT_FRAMES, pull),
                 frames = BOT_FRAMES * longest * 60 /* Hz */ / hand_speed;
    if (!(frames <= BOT_MAX_FRAMES)) return false;
    if (frames > BOT_FRAMES) project_path(view, truth, (int)frames, pull);
    return pull->length >= least_path && !is_folded(truth, pull);
}

/* ---- grab point ---- */

static bool is_inside(const bot_view* view, int column, int row, uint32_t part) {
    for (int y = row - 1; y <= row + 1; y++) {
        for (int x = column - 1; x <= column + 1; x++) {
            if (x < 0 || y < 0 || x >= BOT_COLUMNS || y >= BOT_ROWS) return false;
            if (view->part[(size_t)y * BOT_COLUMNS + (size_t)x] != part) return false;
        }
    }
    return true;
}

static double arm_of(const known_joint* truth, vec point) {
    return truth->slides ? 1 : length(cross(truth->axis, sub(point, truth->origin)));
}

/* Finds samples well inside the visible part, as row * BOT_COLUMNS + column, but those near the hinge. */
static int* find_places(const bot_view* view, uint32_t part, const known_joint* truth, int* out_count) {
    int* places = cli_alloc((size_t)BOT_COLUMNS * BOT_ROWS * sizeof *places);
    int count = 0, kept = 0;
    double most = 0;
    for (int at = 0; at < BOT_COLUMNS * BOT_ROWS; at++) {
        if (!is_inside(view, at % BOT_COLUMNS, at / BOT_COLUMNS, part)) continue;
        most = fmax(most, arm_of(truth, bot_view_point(view, at % BOT_COLUMNS, at / BOT_COLUMNS)));
        places[count++] = at;
    }
    for (int i = 0; i < count; i++) {
        const vec point = bot_view_point(view, places[i] % BOT_COLUMNS, places[i] / BOT_COLUMNS);
        if (arm_of(truth, point) >= least_arm * most) places[kept++] = places[i];
    }
    *out_count = count < MIN_SAMPLES ? 0 : kept;
    return places;
}

int bot_choose_pull(const bot_view* view, uint32_t part, const known_joint* truth, double size, random_state* random,
                    bot_pull* out_pull) {
    int count;
    int* places = find_places(view, part, truth, &count);
    int found = count > 0 ? -1 : 0;
    for (int i = 0; i < TRIES && found < 0; i++) {
        const int at = places[random_u64(random) % (uint64_t)count];
        *out_pull = (bot_pull){.x = at % BOT_COLUMNS * BOT_STEP,
                               .y = at / BOT_COLUMNS * BOT_STEP,
                               .point = bot_view_point(view, at % BOT_COLUMNS, at / BOT_COLUMNS),
                               .asked = bot_travel(truth, size)};
        if (make_path(view, truth, out_pull)) found = 1;
    }
    free(places);
    return found;
}

bool bot_pull_aside(const bot_view* view, uint32_t part, vec point, double tolerance, int side, double pixels,
                    bot_pull* out_pull) {
    static const double ways[4][2] = {{0, -1}, {0, 1}, {-1, 0}, {1, 0}};
    const int column = BOT_COLUMNS / 2, row = BOT_ROWS / 2;
    if (!is_inside(view, column, row, part)) return false;
    out_pull->point = bot_view_point(view, column, row);
    if (length(sub(out_pull->point, point)) > tolerance) return false;
    out_pull->x = column * BOT_STEP, out_pull->y = row * BOT_STEP;
    out_pull->frames = BOT_FRAMES;
    out_pull->length = pixels;
    for (int i = 0; i < BOT_FRAMES; i++) {
        const double gone = pixels * bot_minimum_jerk((i + 1.0) / BOT_FRAMES);
        out_pull->path[i][0] = out_pull->x + gone * ways[side][0];
        out_pull->path[i][1] = out_pull->y + gone * ways[side][1];
    }
    return true;
}
