/* Where the naive hand looks from, and what it grabs. */
#include <math.h>
#include <stdlib.h>

#include "dragbot_naive.h"

/* All by hand. Lengths are pixels of a screen that is 720 pixels high and shows 50 degrees; the player's own is higher,
 * and shows more in the same scale. */
static const double half_screen = 360, half_view = 25 * PI / 180;
static const double object_wide = 0.9 * 1280, object_high = 0.6 * 720; /* the object as it is looked at */
static const double least_part = 80;                /* a part that looks smaller is looked at from nearer */
enum { HALVINGS = 50 };                             /* in search of a distance */
static const double nearest = 1e-4, farthest = 1e4; /* distances, in sizes of what is looked at */
enum { TRIES = 80 };                                /* pixels of the part */
static const struct {
    double round, high; /* degrees: round the object, to the player's right; up */
} places[BOT_NAIVE_CAMERAS] = {{-40, 22}, {40, 22}, {0, 8}, {12, 42}};

/* ---- camera ---- */

/* A box to be looked at from a direction. */
typedef struct sight {
    vec low, high, target, from, up;
} sight;

static vec corner_of(const sight* s, int which) {
    return (vec){which & 1 ? s->high.x : s->low.x, which & 2 ? s->high.y : s->low.y, which & 4 ? s->high.z : s->low.z};
}

static void look_from(bot_view* view, const sight* s, double distance) {
    const double fov = 2 * atan(0.5 * BOT_HEIGHT * tan(half_view) / half_screen);
    bot_view_look(view, add(s->target, scale(s->from, distance)), scale(s->from, -1), s->up, fov);
}

/* Measures how large the box looks, px; infinite where it is beside the eye. */
static void measure_sight(const bot_view* view, const sight* s, double* out_wide, double* out_high) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    *out_wide = *out_high = INFINITY;
    for (int i = 0; i < 8; i++) {
        double at[2];
        if (!bot_view_project(view, corner_of(s, i), &at[0], &at[1])) return;
        for (int k = 0; k < 2; k++) low[k] = fmin(low[k], at[k]), high[k] = fmax(high[k], at[k]);
    }
    *out_wide = high[0] - low[0], *out_high = high[1] - low[1];
}

/* Looks from the nearest place from which the box looks no larger. */
static void look_at_box(bot_view* view, const sight* s, double wide, double high) {
    const vec side = sub(s->high, s->low);
    const double size = fmax(fmax(side.x, side.y), side.z);
    double close = nearest, distant = farthest;
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = sqrt(close * distant);
        double is_wide, is_high;
        look_from(view, s, middle * size);
        measure_sight(view, s, &is_wide, &is_high);
        if (is_wide <= wide && is_high <= high)
            distant = middle;
        else
            close = middle;
    }
    look_from(view, s, distant * size);
}

/* Looks at the object, or at the part where that is small. */
static void look(bot_object* s, const bot_truth* truth, int place) {
    const double high = places[place].high * PI / 180;
    const vec side = turn(bot_truth_front(truth, s->up), s->up, places[place].round * PI / 180);
    const vec from = add(scale(side, cos(high)), scale(s->up, sin(high)));
    const sight whole = {truth->low, truth->high, scale(add(truth->low, truth->high), 0.5), from, s->up};
    const sight part = {truth->part_low, truth->part_high, truth->centre, from, s->up};
    double part_wide, part_high;
    look_at_box(&s->view, &whole, object_wide, object_high);
    measure_sight(&s->view, &part, &part_wide, &part_high);
    if (fmax(part_wide, part_high) < least_part) look_at_box(&s->view, &part, least_part, least_part);
    bot_view_draw(&s->view, &s->session->mesh, s->face_parts);
}

/* ---- points ---- */

/* Lists where the part is seen, as row * BOT_COLUMNS + column. To be freed. */
static int* find_part(const bot_object* s, int* out_count) {
    int* found = cli_alloc((size_t)BOT_COLUMNS * BOT_ROWS * sizeof *found);
    *out_count = 0;
    for (int at = 0; at < BOT_COLUMNS * BOT_ROWS; at++)
        if (s->view.part[at] == 1) found[(*out_count)++] = at;
    return found;
}

/* Takes the point that the library picks at a pixel. Returns false when it is not the part's. */
static bool grab(const bot_object* s, int x, int y, bot_grab* out_grab) {
    dm_ray ray;
    dm_hit hit = dm_hit_default();
    dm_context* context = s->session->context;
    if (dm_camera_ray(context, &s->view.camera, (float)x, (float)y, &ray) != DM_OK) return false;
    if (dm_scene_pick(context, s->scene, &ray, &hit) != DM_OK || hit.part_id != 1) return false;
    *out_grab = (bot_grab){.view = s->view, .x = x, .y = y, .point = vec_of(hit.object_point)};
    out_grab->view.depth = NULL;
    out_grab->view.part = NULL;
    return true;
}

/* Draws what chance has a say in. */
static void draw_chance(const bot_truth* truth, random_state* random, bot_grab* grab) {
    const vec motion = unit(bot_truth_motion(truth, grab->point));
    grab->turn = 2 * random_unit(random) - 1;
    const double x = random_normal(random), y = random_normal(random), z = random_normal(random);
    grab->across = unit(cross(motion, (vec){x, y, z}));
}

/* Grabs points that are seen from one place. */
static int find_from_place(const bot_object* s, const bot_truth* truth, random_state* random, bot_grab* out_grabs) {
    int seen, count = 0;
    int* at = find_part(s, &seen);
    for (int i = 0; i < TRIES && seen > 0 && count < BOT_NAIVE_GRABS; i++) {
        const int pixel = at[random_u64(random) % (uint64_t)seen];
        bot_grab* next = &out_grabs[count];
        if (!grab(s, pixel % BOT_COLUMNS * BOT_STEP, pixel / BOT_COLUMNS * BOT_STEP, next)) continue;
        draw_chance(truth, random, next);
        next->index = count++;
    }
    free(at);
    return count;
}

/* Returns a number of the object's name (FNV-1a), so that chance differs between objects. */
static uint64_t hash_name(const char* name) {
    uint64_t hash = 0xCBF29CE484222325u;
    for (; *name != 0; name++) hash = (hash ^ (unsigned char)*name) * 0x100000001B3u;
    return hash;
}

int bot_naive_find_grabs(bot_object* s, const bot_truth* truth, int cameras, bot_grab out_grabs[BOT_NAIVE_MOST],
                         int* out_hidden) {
    const uint64_t joint = (uint64_t)(truth->joint - s->known.joints);
    int count = 0;
    *out_hidden = 0;
    for (int place = 0; place < cameras && place < BOT_NAIVE_CAMERAS; place++) {
        random_state random = {hash_name(s->known.name) + joint * BOT_NAIVE_CAMERAS + (uint64_t)place};
        look(s, truth, place);
        const int found = find_from_place(s, truth, &random, &out_grabs[count]);
        for (int i = 0; i < found; i++) out_grabs[count + i].camera = place;
        count += found;
        *out_hidden += found == 0;
    }
    return count;
}
