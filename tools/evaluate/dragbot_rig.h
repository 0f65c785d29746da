/* First touch on whole assets. */
#ifndef CLI_DRAGBOT_RIG_H
#define CLI_DRAGBOT_RIG_H

#include "dragbot_score.h"

/* Sums of shares: of a part's, or a node's, grabs. */
typedef struct bot_rig_score {
    int assets, failed; /* failed: without an answer */
    int parts, unseen;  /* true parts that were grabbed; those of which no point is seen, or moves as it is seen */
    double follow;      /* the right faces follow */
    double right;       /* the same, and the joint is right after the pull */
    int static_nodes;
    double stay;
} bot_rig_score;

/* Grabs true parts and static nodes of a folder's assets by the naive hand. Returns an exit status. */
int bot_rig_play(session* session, const char* folder, const bot_options* options, bool as_json);

#endif
