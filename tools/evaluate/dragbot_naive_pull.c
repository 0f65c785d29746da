/* The straight pull of the naive hand, on the screen or in space. */
#include <math.h>

#include "dragbot_naive.h"

/* All by hand. */
enum { REST = 4, MOVING = 30, FRAMES = REST + MOVING }; /* frames: still after the grab's; half a second */
static const double pixels = 160;      /* of a pull; in space as long as that is at the grabbed point's distance */
static const double least_seen = 0.25; /* of the point's first motion: it is seen from the camera */
static const double least_arm = 1e-3;  /* of the object's size: the point moves */
static const double first_step = 1e-3; /* of the object's size: of a point's first motion, to project it */

double bot_naive_progress(double at) {
    const double share = fmin(fmax((at + 1 - REST) / MOVING, 0), 1);
    return share * share * (3 - 2 * share);
}

/* Computes the unit direction on the screen in which the point moves first. Returns false when it is hardly seen. */
static bool first_direction(const bot_grab* grab, const bot_truth* truth, vec motion, double out[2]) {
    const vec way = unit(motion), sight = unit(sub(grab->point, grab->view.eye));
    double from[2], to[2];
    if (length(sub(way, scale(sight, dot(way, sight)))) < least_seen) return false;
    if (!bot_view_project(&grab->view, grab->point, &from[0], &from[1]) ||
        !bot_view_project(&grab->view, add(grab->point, scale(way, first_step * truth->size)), &to[0], &to[1]))
        return false;
    const double moved = hypot(to[0] - from[0], to[1] - from[1]);
    for (int k = 0; k < 2; k++) out[k] = (to[k] - from[k]) / moved;
    return moved > 0;
}

static void snap(double direction[2]) {
    const int along = fabs(direction[1]) > fabs(direction[0]);
    direction[along] = direction[along] < 0 ? -1 : 1;
    direction[!along] = 0;
}

static void turn_on_screen(double direction[2], double angle) {
    const double x = direction[0], y = direction[1];
    direction[0] = cos(angle) * x - sin(angle) * y;
    direction[1] = sin(angle) * x + cos(angle) * y;
}

/* Aims in space, as far as a pull of so many pixels across the view reaches there. */
static void aim_in_space(const bot_grab* grab, vec motion, double angle, bot_pull* pull) {
    const double depth = dot(sub(grab->point, grab->view.eye), grab->view.forward);
    pull->way = scale(turn(unit(motion), grab->across, angle), pixels * depth / grab->view.zoom);
}

bool bot_naive_draw(const bot_hand* hand, const bot_grab* grab, const bot_truth* truth, bot_pull* out_pull) {
    const vec motion = bot_truth_motion(truth, grab->point);
    const double angle = grab->turn * hand->degrees * PI / 180;
    double direction[2] = {0, 0};
    if (length(motion) < least_arm * (truth->joint->slides ? 1 : truth->size)) return false;
    if (!hand->point && !first_direction(grab, truth, motion, direction)) return false;
    *out_pull = (bot_pull){.x = grab->x,
                           .y = grab->y,
                           .point = grab->point,
                           .asked = bot_travel(truth->joint, truth->size),
                           .frames = FRAMES,
                           .length = pixels};
    if (hand->up) direction[0] = 0, direction[1] = -1;
    if (hand->snap)
        snap(direction);
    else
        turn_on_screen(direction, angle);
    for (int i = 0; i < FRAMES; i++)
        for (int k = 0; k < 2; k++)
            out_pull->path[i][k] = (k ? grab->y : grab->x) + pixels * bot_naive_progress(i) * direction[k];
    if (hand->point) aim_in_space(grab, motion, angle, out_pull);
    return true;
}
