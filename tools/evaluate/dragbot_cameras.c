/* Where the scripted player looks at a part from. */
#include <math.h>

#include "dragbot_object.h"

/* All by hand. */
enum { DIRECTIONS = 32, DIRECTIONS_BEHIND = 128 }; /* tried */
enum { END_ON_TRIES = 8, SIDES = 4 };              /* places on a part; pulls from each */
static const double part_fill = 0.35;              /* least share of the view's radius that the part fills */
static const double view_margin = 1.05;            /* radius of the view over that of the part's ball */
static const double camera_distance = 2.5;         /* from the centre, in radii of the whole */
static const double min_elevation = -0.2, max_elevation = 0.95; /* sine of the camera's elevation */
static const double above_elevation = 0.985;                    /* the same from above: 80 degrees */
static const double behind_cosine = -0.5;                       /* at most, between the camera and the opening */
static const double end_on_pixels = 80;                         /* length of a pull */
static const double end_on_near = 0.01; /* of the object's size: the point meant is the point seen */
static const double end_on_arm = 0.3;   /* of the largest distance to the axis: nobody grabs at the hinge */
static const double along_up = 0.99;

static vec spread(const bot_object* s, int index, double height) {
    const double turned = 2.399963229728653 * index; /* the golden angle, rad */
    const vec side = fabs(s->up.z) > 0.5 ? (vec){1, 0, 0} : (vec){0, 0, 1};
    return add(scale(s->up, height), scale(turn(side, s->up, turned), sqrt(1 - height * height)));
}

/* Returns a camera direction: elevations spread evenly in golden-ratio order, azimuths by the golden angle. */
static vec direction(const bot_object* s, enum bot_sight sight, int index) {
    if (sight == BOT_ABOVE) return spread(s, index, above_elevation);
    const double share = fmod(0.618033988749895 * (index + 1), 1); /* golden ratio - 1 */
    return spread(s, index, min_elevation + (max_elevation - min_elevation) * share);
}

/* ---- a camera on a direction ---- */

/* Looks along -from at `centre`. */
static void aim(bot_object* s, const bot_part* part, vec from, vec centre) {
    const double radius = part->swept_radius;
    const double whole = fmax(s->radius + length(sub(part->swept_centre, s->centre)), radius);
    const double wanted = fmin(fmax(radius / part_fill, radius * view_margin), whole);
    const vec other = fabs(s->up.x) > 0.5 ? (vec){0, 1, 0} : (vec){1, 0, 0};
    const vec up = fabs(dot(from, s->up)) > along_up ? other : s->up;
    bot_view_aim(&s->view, from, up, centre, fmax(wanted, view_margin * radius), camera_distance * whole);
    bot_view_draw(&s->view, &s->session->mesh, s->face_parts);
}

/* Looks at the part's whole pull from a direction. From behind, only where the opening leads away from the camera. */
static int choose_from(bot_object* s, int joint, const bot_part* part, enum bot_sight sight, int place,
                       random_state* random, bot_pull* out_pull) {
    const known_joint* truth = &s->known.joints[joint];
    const vec from = direction(s, sight, place), centre = part->swept_centre;
    const vec opening = bot_true_direction(truth, centre, bot_travel(truth, s->size));
    if (sight == BOT_BEHIND && dot(from, opening) > behind_cosine) return 0;
    aim(s, part, from, centre);
    return bot_choose_pull(&s->view, part->id, truth, s->size, random, out_pull);
}

/* ---- end-on ---- */

static double arm_of(const known_joint* truth, vec point) {
    return truth->slides ? 1 : length(cross(truth->axis, sub(point, truth->origin)));
}

/* Looks at points of the part from where they would go, until one is seen. All sides get the same point. */
static int choose_end_on(bot_object* s, int joint, const bot_part* part, int side, bot_pull* out_pull) {
    const known_joint* truth = &s->known.joints[joint];
    random_state random = {(uint64_t)joint + 1};
    vec points[END_ON_TRIES];
    double most = 0;
    bool own[BOT_MAX_PARTS + 1] = {false};
    own[part->id] = true;
    bot_object_sample(s, own, &random, points, END_ON_TRIES);
    for (int i = 0; i < END_ON_TRIES; i++) most = fmax(most, arm_of(truth, points[i]));
    for (int i = 0; i < END_ON_TRIES; i++) {
        if (arm_of(truth, points[i]) < end_on_arm * most) continue;
        out_pull->asked = bot_travel(truth, s->size);
        aim(s, part, bot_true_direction(truth, points[i], out_pull->asked), points[i]);
        if (bot_pull_aside(&s->view, part->id, points[i], end_on_near * s->size, side, end_on_pixels, out_pull))
            return 1;
    }
    return 0;
}

int bot_sight_places(enum bot_sight sight) {
    return sight == BOT_END_ON ? SIDES : sight == BOT_BEHIND ? DIRECTIONS_BEHIND : DIRECTIONS;
}

int bot_sight_choose(bot_object* s, int joint, const bot_part* part, enum bot_sight sight, int place,
                     random_state* random, bot_pull* out_pull) {
    if (sight == BOT_END_ON) return choose_end_on(s, joint, part, place, out_pull);
    return choose_from(s, joint, part, sight, place, random, out_pull);
}
