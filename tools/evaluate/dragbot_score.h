/* All cases of the scripted player, and the report about them. */
#ifndef CLI_DRAGBOT_SCORE_H
#define CLI_DRAGBOT_SCORE_H

#include "dragbot_naive.h"

typedef struct bot_options {
    int cameras, given_only, worst;
    bot_hand hand;
    enum bot_sight sight;
    output_file* poses; /* NULL: none are written */
    name_list only;     /* words, one of which an object's name or category has; none: all objects */
    int hints;          /* HINTS_*: what the library is told of the datasets' names and pivots */
    int rig, no_clips;  /* whole assets: dragbot_rig.h */
} bot_options;

typedef struct bot_row {
    bot_result found, given; /* with the library's joint; with the true one */
    bool slides;
    int x, y; /* of the grab */
    double asked, length;
    int camera;
    char id[200];
} bot_row;

/* How a pull of the naive hand has ended. */
typedef struct bot_naive_end {
    enum bot_wrong wrong; /* of the joint */
    bool slides;          /* by the joint */
    double confidence;    /* stated of the joint */
    double share;         /* moved, of what the true joint would have moved in its direction */
    int changes, jumps;   /* of the joint in this pull; frames */
} bot_naive_end;

enum { BOT_NAIVE_LAST, BOT_NAIVE_KEPT, BOT_NAIVE_FIRST, BOT_NAIVE_ENDS };

/* A pull of the naive hand, or a series of pulls. */
typedef struct bot_naive_row {
    bot_naive_end ends[BOT_NAIVE_ENDS]; /* of the last pull, the same with DM_DRAG_KEEP_JOINT, of the first pull */
    enum bot_wrong before;              /* of the joint that was prepared */
    double confidence_before;
    bool turns;
    double weight; /* of the joint, divided by its pulls */
    int camera, grab;
    char id[200]; /* of the joint */
} bot_naive_row;

typedef struct bot_score {
    bot_row* rows;
    size_t count, room;
    bot_naive_row* pulls;
    size_t pull_count, pull_room;
    /* Joint and camera: the part is hidden; a mouse can't draw its path. Of the naive hand: grabs whose motion is not
     * seen, or along which the true joint does not go. */
    int unseen, undrawable;
    int failed; /* objects and joints without an answer */
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
/* Plays all joints with the naive hands among the runs. object: what it knows and is told; nothing is prepared. */
void bot_naive_play_object(const bot_object* object, bot_run* runs, int run_count);

/* Print the figures of a run, and its worst cases. The run's times must be sorted. */
void bot_report_json(const bot_run* run);
void bot_report_text(const bot_run* run);
void bot_report_failures(const bot_run* run, FILE* out);
/* Print a row for every run. */
void bot_report_table(const bot_run* runs, int count, bool as_json);

#endif
