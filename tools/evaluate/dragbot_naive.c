/* The naive hand on one object: every joint's part is prepared alone and pulled from every grab. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dragbot_score.h"

enum { POINTS = 200 };                 /* of the part, whose motion is measured; by hand */
static const double least_goes = 2e-3; /* of the object's size: the true joint goes along with the pull; by hand */

/* A pull of one hand from one grab. */
typedef struct naive_pull {
    const bot_grab* grab;
    bot_pull pull;
    bool goes;         /* drawn, and the true joint goes along */
    dm_pose true_pose; /* to which the true joint takes the part */
} naive_pull;

/* A joint whose part is prepared. */
typedef struct naive_joint {
    bot_object* object;
    int joint;
    bot_truth truth;
    bot_part part;
    vec points[POINTS];
    bot_grab grabs[BOT_NAIVE_MOST];
    int grab_count;
} naive_joint;

/* ---- one pull ---- */

static bool play_pull(naive_joint* j, bot_run* run, const naive_pull* pull, uint32_t flags, const dm_part_state* state,
                      bot_result* out_result) {
    bot_object* s = j->object;
    bot_hand hand = run->options.hand;
    hand.regrab = 0;
    random_state random = {0};
    bot_plan plan = bot_plan_make(&hand, &pull->pull, &random);
    const bot_case played = {.id = s->known.name,
                             .flags = flags,
                             .state = state,
                             .view = &pull->grab->view,
                             .pull = &pull->pull,
                             .hand = &hand,
                             .plan = &plan,
                             .part = &j->part,
                             .truth = j->truth.joint,
                             .up = s->up};
    const dm_result result = bot_play(s->session, s->scene, &played, &run->score.times, out_result);
    free(plan.steps);
    if (result == DM_OK) return out_result->picked;
    fprintf(stderr, "dragmesh dragbot: %s/%d: %s\n", s->known.name, j->joint, s->session->error);
    run->score.failed++;
    return false;
}

/* Pulls with the true joint. */
static void find_true_pose(naive_joint* j, bot_run* run, naive_pull* pull) {
    bot_result result;
    double square = 0;
    pull->goes = pull->goes && play_pull(j, run, pull, 0, NULL, &result);
    if (!pull->goes) return;
    pull->true_pose = result.pose;
    for (int i = 0; i < POINTS; i++) {
        const vec moved = sub(bot_moved(&pull->true_pose, j->points[i]), j->points[i]);
        square += dot(moved, moved);
    }
    pull->goes = sqrt(square / POINTS) >= least_goes * j->truth.size;
}

static bot_naive_end judge(const naive_joint* j, const naive_pull* pull, const bot_result* result) {
    const dm_joint* joint = &result->end.joint;
    double along = 0, square = 0;
    for (int i = 0; i < POINTS; i++) {
        const vec moved = sub(bot_moved(&result->pose, j->points[i]), j->points[i]);
        const vec truly = sub(bot_moved(&pull->true_pose, j->points[i]), j->points[i]);
        along += dot(moved, truly), square += dot(truly, truly);
    }
    return (bot_naive_end){.wrong = bot_truth_compare(&j->truth, joint),
                           .slides = joint->type == DM_JOINT_PRISMATIC,
                           .confidence = (double)joint->joint_confidence,
                           .share = along / square,
                           .changes = result->changes,
                           .jumps = result->jumps};
}

/* ---- series of pulls ---- */

/* Orders the pulls so that the next one is from another camera, where there is one. Returns how many go. */
static int order_pulls(const naive_joint* j, const naive_pull* pulls, const naive_pull** out_order) {
    int count = 0;
    for (int index = 0; index < BOT_NAIVE_GRABS; index++)
        for (int i = 0; i < j->grab_count; i++)
            if (pulls[i].goes && pulls[i].grab->index == index) out_order[count++] = &pulls[i];
    return count;
}

/* Pulls one after the other, each time from rest with all else that the pull before has left of the part's state. */
static bool play_series(naive_joint* j, bot_run* run, const naive_pull** pulls, int count, uint32_t flags,
                        bot_naive_end* out_first, bot_naive_end* out_last) {
    bot_result result;
    dm_part_state state;
    for (int i = 0; i < count; i++) {
        if (!play_pull(j, run, pulls[i], flags, i > 0 ? &state : NULL, &result)) return false;
        *out_last = judge(j, pulls[i], &result);
        if (i == 0) *out_first = *out_last;
        state = result.end;
        state.value = 0;
        state.velocity = 0;
        memset(&state.pose, 0, sizeof state.pose);
    }
    return true;
}

static bot_naive_row* new_row(bot_score* score) {
    score->pulls = cli_grow_list(score->pulls, score->pull_count, &score->pull_room, sizeof *score->pulls);
    bot_naive_row* row = &score->pulls[score->pull_count];
    memset(row, 0, sizeof *row);
    return row;
}

/* Begins a series with every pull. A joint with too few pulls for a series has none. */
static void play_found(naive_joint* j, bot_run* run, const naive_pull* pulls, const dm_joint* found) {
    const naive_pull* order[2 * BOT_NAIVE_MOST];
    const int count = order_pulls(j, pulls, order),
              length = run->options.hand.regrab > 1 ? run->options.hand.regrab : 1;
    const size_t first_row = run->score.pull_count;
    for (int i = 0; i < count; i++) order[count + i] = order[i];
    for (int i = 0; i < count && length <= count; i++) {
        bot_naive_row* row = new_row(&run->score);
        bot_naive_end ignored;
        snprintf(row->id, sizeof row->id, "%s/%d", j->object->known.name, j->joint);
        row->before = bot_truth_compare(&j->truth, found);
        row->confidence_before = (double)found->joint_confidence;
        row->turns = !j->truth.joint->slides;
        row->camera = order[i]->grab->camera, row->grab = order[i]->grab->index;
        if (play_series(j, run, &order[i], length, 0, &row->ends[BOT_NAIVE_FIRST], &row->ends[BOT_NAIVE_LAST]) &&
            play_series(j, run, &order[i], length, DM_DRAG_KEEP_JOINT, &ignored, &row->ends[BOT_NAIVE_KEPT]))
            run->score.pull_count++;
    }
    const double rows = (double)(run->score.pull_count - first_row);
    for (size_t i = first_row; i < run->score.pull_count; i++)
        run->score.pulls[i].weight = j->truth.joint->weight / rows;
}

/* ---- one joint ---- */

static void draw_and_find_true_poses(naive_joint* j, bot_run* run, naive_pull* pulls) {
    for (int i = 0; i < j->grab_count; i++) {
        pulls[i].grab = &j->grabs[i];
        pulls[i].goes = bot_naive_draw(&run->options.hand, &j->grabs[i], &j->truth, &pulls[i].pull);
        find_true_pose(j, run, &pulls[i]);
        run->score.undrawable += !pulls[i].goes;
    }
}

/* Plays every naive hand: with the true joint first, then with the one found. */
static void play_joint(naive_joint* j, bot_run* runs, int run_count) {
    bot_object* s = j->object;
    dm_context* context = s->session->context;
    const dm_joint exact = bot_true_joint(j->truth.joint);
    dm_joint found = {.struct_size = sizeof found};
    dm_object_get_joint(context, s->session->object, j->part.id, &found);
    for (int i = 0; i < run_count; i++) {
        if (!runs[i].options.hand.naive) continue;
        naive_pull* pulls = cli_alloc_zeroed(BOT_NAIVE_MOST * sizeof *pulls);
        dm_object_set_joint(context, s->session->object, j->part.id, &exact);
        draw_and_find_true_poses(j, &runs[i], pulls);
        dm_object_reset_joint(context, s->session->object, j->part.id);
        play_found(j, &runs[i], pulls, &found);
        free(pulls);
    }
}

static dm_result set_up(naive_joint* j) {
    bot_object* s = j->object;
    random_state random = {(uint64_t)j->joint + 1};
    bool moves[BOT_MAX_PARTS + 1] = {false};
    dm_result result = bot_object_set_up_alone(s, j->joint);
    if (result == DM_OK) result = bot_truth_make(s, j->joint, &j->truth);
    if (result != DM_OK || !s->part_of_joint[j->joint]) return result;
    j->part = bot_object_part(s, j->joint);
    moves[j->part.id] = true;
    bot_object_sample(s, moves, &random, j->points, POINTS);
    return DM_OK;
}

static void set_up_and_play(bot_object* s, int joint, bot_run* runs, int run_count) {
    naive_joint* j = cli_alloc_zeroed(sizeof *j);
    j->object = s, j->joint = joint;
    int hidden = 0;
    const dm_result result = set_up(j);
    if (result != DM_OK) fprintf(stderr, "dragmesh dragbot: %s/%d: %s\n", s->known.name, joint, s->session->error);
    if (result == DM_OK && s->part_of_joint[joint]) {
        j->grab_count = bot_naive_find_grabs(s, &j->truth, runs[0].options.cameras, j->grabs, &hidden);
        play_joint(j, runs, run_count);
    }
    for (int i = 0; i < run_count; i++) {
        if (!runs[i].options.hand.naive) continue;
        runs[i].score.unseen += hidden;
        runs[i].score.failed += result != DM_OK;
    }
    bot_object_take_down(s);
    free(j);
}

void bot_naive_play_object(const bot_object* object, bot_run* runs, int run_count) {
    for (int i = 0; i < object->known.joint_count; i++) {
        bot_object alone = *object;
        alone.told_up = object->up;
        set_up_and_play(&alone, i, runs, run_count);
    }
}
