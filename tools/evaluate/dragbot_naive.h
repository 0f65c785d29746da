/* The scripted player's naive hand: it does not know how the part moves. It grabs any visible point and pulls straight,
 * roughly the way in which the true joint moves that point first. */
#ifndef CLI_DRAGBOT_NAIVE_H
#define CLI_DRAGBOT_NAIVE_H

#include "dragbot_object.h"

/* ---- the true joint ---- */

typedef struct bot_truth {
    const known_joint* joint;
    double side;   /* 1 or -1: of the joint's value, the way that people pull */
    vec low, high; /* the object's box */
    vec part_low, part_high;
    vec centre, at; /* of the part's box; the point of the axis that is nearest to it */
    double size;    /* of the object */
} bot_truth;

/* What is wrong with a joint. */
enum bot_wrong { BOT_RIGHT, BOT_WRONG_TYPE, BOT_WRONG_AXIS, BOT_WRONG_LINE };

/* Measures the only part of an object. */
dm_result bot_truth_make(const bot_object* object, int joint, bot_truth* out_truth);
enum bot_wrong bot_truth_compare(const bot_truth* truth, const dm_joint* joint);
bool bot_joint_turns(const dm_joint* joint);
/* Returns the first motion of a point: unit for slides, for turns as long as the point is from the axis. */
vec bot_truth_motion(const bot_truth* truth, vec point);
/* Returns the horizontal direction of the file's frame from which a person would open the part. */
vec bot_truth_front(const bot_truth* truth, vec up);

/* ---- grabs ---- */

enum { BOT_NAIVE_CAMERAS = 4, BOT_NAIVE_GRABS = 4, BOT_NAIVE_MOST = BOT_NAIVE_CAMERAS * BOT_NAIVE_GRABS };

/* A visible point of the part, and what chance says of the pull. */
typedef struct bot_grab {
    bot_view view; /* the camera alone, without what it sees */
    int camera, index;
    int x, y;
    vec point;
    double turn; /* of the pull's direction, -1 to 1 of the hand's degrees */
    vec across;  /* unit, round which a pull in space turns; at a right angle to the point's first motion */
} bot_grab;

/* Looks at the only part from up to `cameras` places. Returns the count of grabs; *out_hidden: of places from which no
 * point was found. */
int bot_naive_find_grabs(bot_object* object, const bot_truth* truth, int cameras, bot_grab out_grabs[BOT_NAIVE_MOST],
                         int* out_hidden);

/* ---- the pull ---- */

enum { BOT_NAIVE_HOLD = 10 }; /* frames still after the pull */

/* Returns how much of a pull is done at a place on its path, 0 to 1. */
double bot_naive_progress(double at);
/* Draws the path. Returns false where the true first motion is hardly seen, or where there is none. */
bool bot_naive_draw(const bot_hand* hand, const bot_grab* grab, const bot_truth* truth, bot_pull* out_pull);

#endif
