/* Whether a part of an object goes through what does not move with it. */
#include "dragbot_body.h"

#include <stdlib.h>

#include "dragbot_grid.h"

/* All by hand; lengths as shares of the object's size. */
enum { POINTS = 256 };
enum { OUTLIERS = 3 };    /* the depth is that of the third deepest point: one per cent of the part is in the body */
enum { MAX_OPEN = 8 };    /* triangles that a point is beyond at once */
enum { TRUE_STEPS = 44 }; /* of the true motion, a tenth beyond what is asked */
static const double true_beyond = 1.1;
static const double excused = 0.002;      /* depth in the true motion that takes a point out of the count */
static const double contact = 0.002;      /* distance from rest within which the part touches the body */
static const double sideways = 0.1;       /* cosine up to which the true motion goes along a touched surface */
static const double step = 0.001;         /* least motion between two looks */
enum { INSIDE_RAYS = 7, INSIDE_ODD = 6 }; /* so many of the ways out cross the body an odd number of times */

/* A triangle that a point has crossed. */
typedef struct crossing {
    uint32_t triangle;
    vec normal; /* the way it was crossed */
} crossing;

enum verdict { UNKNOWN = 0, COUNTS, SILENT };

typedef struct trace {
    vec rest, at;
    vec leaves; /* unit, the true motion's first direction */
    crossing open[MAX_OPEN];
    int open_count;
    enum verdict verdict;
} trace;

struct bot_body {
    bot_grid grid;
    const known_joint* truth;
    double lower, upper; /* of the true joint, what is asked and a little more included */
    vec centre;          /* of the part */
    double size;         /* of the object */
    trace traces[POINTS];
};

/* ---- the true way ---- */

/* Sets how far the true joint may take the part. */
static void set_range(bot_body* body, double asked_value) {
    const known_joint* truth = body->truth;
    const double most = true_beyond * asked_value;
    const bool limited = isfinite(truth->lower) && isfinite(truth->upper);
    body->lower = fmin(fmin(most, 0), limited ? truth->lower : 0);
    body->upper = fmax(fmax(most, 0), limited ? truth->upper : 0);
    if (!limited && !truth->slides) body->lower = -PI, body->upper = PI;
}

/* Returns the distance of a place from those to which the true joint can take the point. */
static double off_true_way(const bot_body* body, const trace* point, vec place) {
    const known_joint* truth = body->truth;
    double value = dot(sub(place, point->rest), truth->axis);
    if (!truth->slides) {
        const vec from = sub(point->rest, truth->origin), to = sub(place, truth->origin);
        const double along = dot(from, truth->axis) * dot(to, truth->axis);
        value = atan2(dot(cross(from, to), truth->axis), dot(from, to) - along);
        const double middle = 0.5 * (body->lower + body->upper);
        value += TWO_PI * round((middle - value) / TWO_PI);
    }
    value = fmin(fmax(value, body->lower), body->upper);
    return length(sub(place, bot_true_move(truth, point->rest, value)));
}

/* ---- one way of one point ---- */

typedef struct asked {
    bot_body* body;
    trace* point;
    vec way;
} asked;

/* Whether a surface that the part touches at rest lies against the part's way out. */
static bool is_pushed_into(const bot_body* body, const trace* point, vec normal) {
    const double along = dot(normal, point->leaves);
    if (along > sideways || along < -sideways) return along < 0;
    return dot(normal, sub(body->centre, point->rest)) < 0; /* the part is on the other side */
}

static void open_crossing(void* user, uint32_t triangle, double share) {
    const asked* a = user;
    trace* point = a->point;
    vec normal = a->body->grid.triangles[triangle].normal;
    if (dot(normal, a->way) < 0) normal = scale(normal, -1);
    for (int i = 0; i < point->open_count; i++)
        if (point->open[i].triangle == triangle) return;
    const vec hit = add(point->at, scale(a->way, share));
    const double from_rest = length(sub(hit, point->rest));
    if (from_rest < contact * a->body->size && !is_pushed_into(a->body, point, normal)) return;
    if (point->open_count < MAX_OPEN) point->open[point->open_count++] = (crossing){triangle, normal};
}

/* Moves a point and returns how deep it is then, in units of length. */
static double move_point(bot_body* body, trace* point, vec to) {
    asked a = {body, point, sub(to, point->at)};
    bot_grid_cross(&body->grid, point->at, to, open_crossing, &a);
    point->at = to;
    double depth = 0;
    for (int i = 0; i < point->open_count; i++) {
        const crossing* c = &point->open[i];
        const double beyond = dot(sub(to, body->grid.triangles[c->triangle].corner), c->normal);
        if (beyond < 0)
            point->open[i--] = point->open[--point->open_count];
        else
            depth = fmax(depth, beyond);
    }
    return depth;
}

static void go_to_rest(bot_body* body) {
    for (int i = 0; i < POINTS; i++) body->traces[i].at = body->traces[i].rest, body->traces[i].open_count = 0;
}

/* ---- which points count ---- */

static void count_crossing(void* user, uint32_t triangle, double share) {
    (void)triangle, (void)share;
    ++*(int*)user;
}

/* Whether a point lies in a closed part of the body: nearly every way out crosses it an odd number of times. */
static bool is_inside(bot_body* body, vec point) {
    random_state random = {1};
    int odd = 0;
    for (int i = 0; i < INSIDE_RAYS; i++) {
        const vec way = unit((vec){random_normal(&random), random_normal(&random), random_normal(&random)});
        int count = 0;
        bot_grid_cross(&body->grid, point, add(point, scale(way, 2 * body->size)), count_crossing, &count);
        odd += count % 2;
    }
    return odd >= INSIDE_ODD;
}

static bool counts(bot_body* body, trace* point) {
    if (point->verdict == UNKNOWN) point->verdict = is_inside(body, point->rest) ? SILENT : COUNTS;
    return point->verdict == COUNTS;
}

static void follow_truth(bot_body* body, const known_joint* truth, double asked_value) {
    go_to_rest(body);
    for (int k = 1; k <= TRUE_STEPS; k++) {
        const double value = true_beyond * asked_value * k / TRUE_STEPS;
        for (int i = 0; i < POINTS; i++) {
            trace* point = &body->traces[i];
            const double depth = move_point(body, point, bot_true_move(truth, point->rest, value));
            if (depth > excused * body->size) point->verdict = SILENT;
        }
    }
}

/* ---- the body ---- */

static bot_grid make_grid(const bot_object* object, const bool moves[BOT_MAX_PARTS + 1]) {
    const uint64_t faces = object->session->mesh.index_count / 3;
    const uint32_t* indices = object->session->mesh.indices;
    const float* positions = object->session->mesh.positions;
    bot_triangle* triangles = cli_alloc((faces + 1) * sizeof *triangles);
    uint32_t count = 0;
    for (uint64_t i = 0; i < faces; i++) {
        if (moves[object->face_parts[i]]) continue;
        const vec a = vec_at(positions + 3 * (size_t)indices[3 * i]);
        const vec b = sub(vec_at(positions + 3 * (size_t)indices[3 * i + 1]), a),
                  c = sub(vec_at(positions + 3 * (size_t)indices[3 * i + 2]), a);
        const vec normal = unit(cross(b, c));
        if (length(normal) > 0) triangles[count++] = (bot_triangle){a, {b, c}, normal};
    }
    return bot_grid_new(triangles, count);
}

bot_body* bot_body_new(const bot_object* object, int joint) {
    const known_joint* truth = &object->known.joints[joint];
    const double value = bot_travel(truth, object->size);
    bot_body* body = cli_alloc_zeroed(sizeof *body);
    bool moves[BOT_MAX_PARTS + 1];
    vec points[POINTS], sum = {0, 0, 0};
    random_state random = {(uint64_t)joint + 1};
    bot_object_moving(object, joint, moves);
    bot_object_sample(object, moves, &random, points, POINTS);
    body->grid = make_grid(object, moves);
    body->size = object->size;
    body->truth = truth;
    set_range(body, value);
    for (int i = 0; i < POINTS; i++) {
        body->traces[i] = (trace){.rest = points[i], .leaves = bot_true_direction(truth, points[i], value)};
        sum = add(sum, points[i]);
    }
    body->centre = scale(sum, 1.0 / POINTS);
    follow_truth(body, truth, value);
    return body;
}

void bot_body_free(bot_body* body) {
    if (body == NULL) return;
    bot_grid_free(&body->grid);
    free(body);
}

/* ---- a drag ---- */

/* Returns the depth of the pose's OUTLIERS-th deepest point, in units of length. */
static double take_pose(bot_body* body, const dm_pose* pose) {
    double deepest[OUTLIERS] = {0};
    for (int i = 0; i < POINTS; i++) {
        trace* point = &body->traces[i];
        if (point->verdict == SILENT) continue;
        double depth = move_point(body, point, bot_moved(pose, point->rest));
        if (depth <= deepest[OUTLIERS - 1] || !counts(body, point)) continue;
        depth = fmin(depth, off_true_way(body, point, point->at));
        for (int k = 0; k < OUTLIERS; k++) {
            if (depth <= deepest[k]) continue;
            const double pushed = deepest[k];
            deepest[k] = depth, depth = pushed;
        }
    }
    return deepest[OUTLIERS - 1];
}

double bot_body_depth(bot_body* body, const bot_part* part, const bot_frame* frames, int count) {
    dm_pose last = {.real = {0, 0, 0, 1}};
    double depth = 0;
    go_to_rest(body);
    for (int i = 0; i < count; i++) {
        if (i + 1 < count && bot_apart(part, &last, &frames[i].pose) < step) continue;
        last = frames[i].pose;
        depth = fmax(depth, take_pose(body, &last));
    }
    return depth / body->size;
}
