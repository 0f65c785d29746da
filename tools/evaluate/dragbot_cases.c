/* The scripted player on one object: every joint, from several places, with every hand. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dragbot_body.h"
#include "dragbot_score.h"

static bot_row* new_row(bot_score* score) {
    score->rows = cli_grow_list(score->rows, score->count, &score->room, sizeof *score->rows);
    bot_row* row = &score->rows[score->count++];
    memset(row, 0, sizeof *row);
    return row;
}

/* Returns the row of a case, which the run with the true joint shares with the run before it. */
static bot_row* find_row(bot_score* score, const char* id, bool given) {
    for (size_t r = score->count; given && r > 0; r--)
        if (strcmp(score->rows[r - 1].id, id) == 0) return &score->rows[r - 1];
    bot_row* row = new_row(score);
    snprintf(row->id, sizeof row->id, "%s", id);
    return row;
}

static void play_case(bot_object* s, const bot_case* played, bot_row* row, bot_score* score) {
    row->slides = played->truth->slides;
    row->x = played->pull->x, row->y = played->pull->y;
    row->asked = played->pull->asked, row->length = played->pull->length;
    bot_result* result = played->given ? &row->given : &row->found;
    if (bot_play(s->session, s->scene, played, &score->times, result) == DM_OK) return;
    fprintf(stderr, "dragmesh dragbot: %s: %s\n", row->id, s->session->error);
    score->failed++;
}

/* A joint to be played. */
typedef struct joint_setup {
    bot_object* object;
    int joint;
    bool given; /* the true joint is in force */
    bot_part part;
    bot_body* body;
} joint_setup;

/* Plays a case from the camera where it is. */
static void play_pull(const joint_setup* j, bot_run* run, int place, const bot_pull* pull, random_state* random) {
    bot_object* s = j->object;
    bot_plan plan = bot_plan_make(&run->options.hand, pull, random);
    char id[sizeof run->score.rows->id];
    snprintf(id, sizeof id, "%s/%d/%d", s->known.name, j->joint, place);
    bot_row* row = find_row(&run->score, id, j->given);
    row->camera = place;
    const bot_case played = {.id = row->id,
                             .given = j->given,
                             .view = &s->view,
                             .pull = pull,
                             .hand = &run->options.hand,
                             .plan = &plan,
                             .part = &j->part,
                             .truth = &s->known.joints[j->joint],
                             .up = s->up,
                             .body = j->body,
                             .poses = run->options.poses};
    play_case(s, &played, row, &run->score);
    free(plan.steps);
}

static void play_hand(const joint_setup* j, bot_run* run) {
    const bot_options* options = &run->options;
    const int places = bot_sight_places(options->sight),
              wanted = options->sight == BOT_END_ON ? places : options->cameras; /* to all sides */
    random_state random = {(uint64_t)j->joint + 1};
    int found = 0;
    for (int i = 0; i < places && found < wanted; i++) {
        bot_pull pull;
        int seen = bot_sight_choose(j->object, j->joint, &j->part, options->sight, i, &random, &pull);
        /* Independent, so that all hands grab the same points. */
        random_state hand_random = {random.state ^ 0x68616E64u};
        if (seen > 0 &&
            !bot_hand_draw(&options->hand, &j->object->view, &j->object->known.joints[j->joint], &hand_random, &pull))
            seen = -1;
        if (j->given) run->score.unseen += seen == 0, run->score.undrawable += seen < 0;
        if (seen <= 0) continue;
        play_pull(j, run, i, &pull, &hand_random);
        found++;
    }
}

/* Whether a run's hand knows the true way. */
static bool is_knowing(const bot_run* run) {
    return !run->options.hand.naive;
}

static void play_joint(bot_object* s, int joint, bool given, bot_run* runs, int run_count) {
    const joint_setup j = {s, joint, given, bot_object_part(s, joint), bot_body_new(s, joint)};
    if (given) {
        const dm_joint exact = bot_true_joint(&s->known.joints[joint]);
        dm_object_set_joint(s->session->context, s->session->object, j.part.id, &exact);
    }
    for (int i = 0; i < run_count; i++)
        if (is_knowing(&runs[i])) play_hand(&j, &runs[i]);
    bot_body_free(j.body);
}

static void fail_all(bot_run* runs, int run_count) {
    for (int i = 0; i < run_count; i++) runs[i].score.failed++;
}

static bool is_same_letter(char a, char b) {
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/* Whether a text has a word, in capitals or not. */
static bool contains(const char* text, const char* word) {
    for (; *text != 0; text++) {
        size_t same = 0;
        while (word[same] != 0 && is_same_letter(text[same], word[same])) same++;
        if (word[same] == 0) return true;
    }
    return false;
}

/* Whether an object's name or category has one of some words. No words: all have. */
static bool has_word(const known_object* object, const name_list* words) {
    for (unsigned i = 0; i < words->count; i++)
        if (contains(object->name, words->names[i]) || contains(object->category, words->names[i])) return true;
    return words->count == 0;
}

/* Plays the hands that know the true way, with the joints found and with the true ones. */
static dm_result play_knowing_hands(bot_object* s, bot_run* runs, int run_count) {
    dm_result result = bot_object_set_up(s);
    for (int given = runs[0].options.given_only; given < 2 && result == DM_OK; given++) {
        for (int i = 0; i < s->known.joint_count; i++)
            if (s->part_of_joint[i]) play_joint(s, i, given != 0, runs, run_count);
    }
    bot_object_take_down(s);
    return result;
}

static void play_read_object(bot_object* s, bot_run* runs, int run_count) {
    session* session = s->session;
    int knowing = 0;
    for (int i = 0; i < run_count; i++) knowing += is_knowing(&runs[i]);
    s->up = (vec){s->known.up == 'x', s->known.up == 'y', s->known.up == 'z'};
    s->hints = runs[0].options.hints;
    dm_result result = session_use_file(session, s->known.glb);
    if (result == DM_OK) dataset_enter_frame(&s->known, session->origin);
    s->view = bot_view_new();
    if (result == DM_OK && knowing < run_count && !runs[0].options.given_only)
        bot_naive_play_object(s, runs, run_count);
    if (result == DM_OK && knowing > 0) result = play_knowing_hands(s, runs, run_count);
    bot_view_free(&s->view);
    if (result == DM_OK) return;
    fprintf(stderr, "dragmesh dragbot: %s: %s\n", s->known.name, session->error);
    fail_all(runs, run_count);
}

void bot_play_object(session* session, const char* folder, const char* name, bot_run* runs, int run_count) {
    bot_object s = {.session = session};
    char error[512];
    if (dataset_read(folder, name, &s.known, error, sizeof error) != 0) {
        fprintf(stderr, "dragmesh dragbot: %s\n", error);
        fail_all(runs, run_count);
        return;
    }
    if (has_word(&s.known, &runs[0].options.only)) play_read_object(&s, runs, run_count);
    dataset_free(&s.known);
}
