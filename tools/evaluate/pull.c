/* Pulls as people make them, from the true joint. */
#include "pull.h"

#include <string.h>

static const double half_open = 0.5;     /* share of the farther limit to which a chord leads; by hand */
static const double longest_turn = 1;    /* rad: of a chord at most; by hand */
static const double free_limit = 2;      /* rad: taken for the limit of a turn that has none; by hand */
static const double distance_step = 1e6; /* distances equal to 1 / this count as one, and the first vertex is taken */
static const double axis_length = 0.1; /* of an axis pull, in object sizes, as of stored drags; the direction counts */

pull_kind pull_kind_of(const char* name) {
    static const char* const names[PULL_KINDS] = {"exact", "chord", "axis"};
    int kind = 0;
    while (kind < PULL_KINDS && strcmp(names[kind], name) != 0) kind++;
    return (pull_kind)kind;
}

/* Returns the arm of a point: its way from the joint's axis. */
static vec arm_of(const known_joint* truth, vec point) {
    const vec from_origin = sub(point, truth->origin);
    return sub(from_origin, scale(truth->axis, dot(from_origin, truth->axis)));
}

static vec farthest(const known_joint* truth, const vec* part, size_t count) {
    size_t best = 0;
    double most = -1;
    for (size_t i = 0; i < count; i++) {
        const double distance = rint(length(arm_of(truth, part[i])) * distance_step);
        if (distance > most) best = i;
        most = fmax(most, distance);
    }
    return part[best];
}

/* Returns the turn to where the joint is half open, signed along the stored drag. */
static double half_turn(const known_joint* truth, const known_drag* stored) {
    const double lower = isnan(truth->lower) ? 0 : fabs(truth->lower);
    const double upper = isnan(truth->upper) ? 0 : fabs(truth->upper);
    const double limit = fmax(lower, upper) > 0 ? fmax(lower, upper) : free_limit;
    const double along = dot(cross(truth->axis, sub(stored->point, truth->origin)), stored->vector);
    return copysign(fmin(longest_turn, half_open * limit), along < 0 ? -1 : 1);
}

/* Returns the room's axis nearest to `way`, signed along it; of equally near ones the first. */
static vec nearest_axis(vec way) {
    const vec axes[] = {{way.x < 0 ? -1 : 1, 0, 0}, {0, way.y < 0 ? -1 : 1, 0}, {0, 0, way.z < 0 ? -1 : 1}};
    int nearest = 0;
    for (int i = 1; i < 3; i++)
        if (dot(axes[i], way) > dot(axes[nearest], way)) nearest = i;
    return axes[nearest];
}

known_drag pull_make(pull_kind kind, const known_joint* truth, const known_drag* stored, const vec* part, size_t count,
                     double size) {
    if (kind == PULL_EXACT) return *stored;
    known_drag pulled = *stored;
    vec tangent = stored->vector;
    if (!truth->slides) {
        const double angle = half_turn(truth, stored);
        pulled.point = farthest(truth, part, count);
        const vec arm = arm_of(truth, pulled.point);
        tangent = scale(cross(truth->axis, arm), angle < 0 ? -1 : 1);
        pulled.vector = sub(turn(arm, truth->axis, angle), arm);
    }
    if (kind == PULL_AXIS) pulled.vector = scale(nearest_axis(tangent), axis_length * size);
    return pulled;
}
