/* The scripted player's hand in time: rests, jostles, pulls, stops, grabs again. Times are in ticks of 1/60 s. */
#include <math.h>
#include <stdlib.h>

#include "dragbot_naive.h"

/* Ticks, by hand. */
enum {
    REST = 20,        /* beside the grabbed point, before the pull */
    JOSTLE_OUT = 6,   /* the wrong way */
    JOSTLE_BACK = 10, /* back, during the pull */
    PAUSE = 45,
    REGRAB = 12, /* still round a new grab, for which the part has come to the pointer */
    REGRAB_AT = 10,
    HITCH = 15
};
static const double first_way = 2;      /* px after which the path has a direction; by hand */
static const double first_share = 0.02; /* and the share of its length; by hand */

enum { MAX_STAGES = 2 * BOT_MAX_REGRABS + 8 };

/* A stretch of time in which the hand does one thing. */
typedef struct stage {
    double ticks;
    double from;  /* place on the path at its beginning */
    bool pulls;   /* goes on along the path, a place a tick */
    bool jostles; /* goes off the path */
    bool resting; /* before the pull */
    bool on_way;
    bool regrabs;
} stage;

typedef struct timeline {
    stage stages[MAX_STAGES];
    int count;
    double ticks;
} timeline;

static void put(timeline* line, stage added) {
    if (added.ticks <= 0) return;
    line->stages[line->count++] = added;
    line->ticks += added.ticks;
}

/* Pulls from place `from` on the path to place `to`, and then stops. */
static void put_pull(timeline* line, double from, double to) {
    put(line, (stage){.ticks = to - from, .from = from, .pulls = true, .on_way = true});
}

static timeline make_timeline(const bot_hand* hand, const bot_pull* pull) {
    timeline line = {.count = 0};
    double from = -1;
    if (hand->offset > 0) put(&line, (stage){.ticks = REST, .from = from, .resting = true});
    if (hand->jostle > 0) put(&line, (stage){.ticks = JOSTLE_OUT, .from = from, .jostles = true});
    const int stops = hand->regrab + 1;
    for (int i = 1; i <= stops; i++) {
        const double to = floor((double)pull->frames * i / stops) - 1, half = floor(0.5 * pull->frames) - 1;
        if (hand->pause && from < half && half <= to) {
            put_pull(&line, from, half);
            put(&line, (stage){.ticks = PAUSE, .from = half});
            from = half;
        }
        put_pull(&line, from, to);
        from = to;
        if (i < stops) put(&line, (stage){.ticks = REGRAB, .from = to, .on_way = true, .regrabs = true});
    }
    put(&line, (stage){.ticks = hand->naive ? BOT_NAIVE_HOLD : BOT_HOLD, .from = from, .on_way = true});
    return line;
}

/* The step at a time from the grab on. */
static bot_step step_at(const timeline* line, const bot_hand* hand, double tick) {
    double began = 0;
    int i = 0;
    while (i + 1 < line->count && tick > began + line->stages[i].ticks) began += line->stages[i++].ticks;
    const stage* s = &line->stages[i];
    const double since = fmin(tick - began, s->ticks);
    bot_step step = {.at = s->from + (s->pulls ? since : 0), .resting = s->resting, .on_way = s->on_way};
    if (hand->jostle > 0) step.beside = s->jostles ? since / JOSTLE_OUT : fmax(0, 1 - (step.at + 1) / JOSTLE_BACK);
    if (s->resting) step.beside = 0;
    if (step.beside > 0) step.on_way = false;
    if (hand->moving_camera || hand->moving_instance) step.moved = bot_minimum_jerk(fmin(1, tick / line->ticks));
    return step;
}

/* Whether a new grab lies between two times. */
static bool regrabs_between(const timeline* line, double after, double until) {
    double began = 0;
    for (int i = 0; i < line->count; i++) {
        const double at = began + REGRAB_AT;
        if (line->stages[i].regrabs && at > after && at <= until) return true;
        began += line->stages[i].ticks;
    }
    return false;
}

/* ---- pixels ---- */

/* Sets the way of a jostle: against the first direction of the path. */
static void jostle_way(const bot_pull* pull, double pixels, double out[2]) {
    const double far = fmax(first_way, first_share * pull->length);
    for (int i = 0; i < pull->frames; i++) {
        const double way[2] = {pull->path[i][0] - pull->x, pull->path[i][1] - pull->y}, gone = hypot(way[0], way[1]);
        if (gone < far) continue;
        for (int k = 0; k < 2; k++) out[k] = -pixels * way[k] / gone;
        return;
    }
}

bot_plan bot_plan_make(const bot_hand* hand, const bot_pull* pull, random_state* random) {
    const timeline line = make_timeline(hand, pull);
    const double tick = 60.0 / (hand->hz ? hand->hz : 60);
    bot_plan plan = {.steps = cli_alloc((size_t)(line.ticks / tick + 3) * sizeof *plan.steps)};
    if (hand->jostle > 0) jostle_way(pull, hand->jostle, plan.jostle);
    if (hand->offset > 0) {
        const double angle = TWO_PI * random_unit(random);
        plan.offset[0] = hand->offset * cos(angle), plan.offset[1] = hand->offset * sin(angle);
    }
    const double hitch = hand->hitch ? floor(0.5 * line.ticks) : line.ticks;
    double last = -tick;
    for (int i = 0; i * tick <= line.ticks + 1e-9; i++) { /* the first ray is the one that grabs */
        const double now = i * tick;
        if (now > hitch && now < hitch + HITCH) continue;
        bot_step* step = &plan.steps[plan.count++];
        *step = step_at(&line, hand, now);
        step->dt = (now - last) / 60;
        step->regrabs = regrabs_between(&line, last, now);
        last = now;
    }
    return plan;
}

void bot_plan_pointer(const bot_plan* plan, const bot_pull* pull, const bot_step* step, double out_pointer[2]) {
    const double start[2] = {pull->x, pull->y}, whole = floor(step->at), share = step->at - whole;
    const int i = (int)whole;
    const double* from = i < 0 ? start : pull->path[i];
    const double* to = i + 1 < pull->frames ? pull->path[i + 1] : from;
    for (int k = 0; k < 2; k++) {
        out_pointer[k] = share > 0 ? from[k] + share * (to[k] - from[k]) : from[k];
        out_pointer[k] += plan->offset[k] + step->beside * plan->jostle[k];
    }
}
