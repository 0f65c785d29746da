/* All cases of the scripted player, and the report about them. */
#ifndef CLI_DRAGBOT_SCORE_H
#define CLI_DRAGBOT_SCORE_H

#include "dragbot_object.h"

typedef struct bot_options {
    int cameras, given_only, worst;
    bot_hand hand;
    enum bot_sight sight;
    FILE* poses;
} bot_options;

typedef struct bot_row {
    bot_result found, given; /* with the library's joint; with the true one */
    bool slides;
    int x, y; /* of the grab */
    double asked, length;
    int camera;
    char id[200];
} bot_row;

typedef struct bot_score {
    bot_row* rows;
    size_t count, room;
    int unseen, undrawable; /* joint and camera: the part is hidden; a mouse can't draw its path */
    int failed;             /* objects and joints without an answer */
    bot_times times;
} bot_score;

/* One hand, and how it fared. */
typedef struct bot_run {
    const char* name;
    bot_options options;
    bot_score score;
} bot_run;

/* Plays all joints of an object with every hand. */
void bot_play_object(session* session, const char* folder, const char* name, bot_run* runs, int run_count);

/* Print the figures of a run, and its worst cases. The run's times must be sorted. */
void bot_report_json(const bot_run* run);
void bot_report_text(const bot_run* run);
void bot_report_failures(const bot_run* run, FILE* out);
/* Print a row for every run. */
void bot_report_table(const bot_run* runs, int count, bool as_json);

#endif
