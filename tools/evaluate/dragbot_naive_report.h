/* What the naive hand found, for the scripted player's reports. */
#ifndef CLI_DRAGBOT_NAIVE_REPORT_H
#define CLI_DRAGBOT_NAIVE_REPORT_H

#include "dragbot_score.h"
#include "json.h"

/* Adds the figures after the last pull; those of a kept joint as an object "keep"; those after the first pull of a
 * series as an object "first". */
void bot_naive_add_figures(const bot_run* run, cJSON* out);
void bot_naive_print_text(const bot_run* run);
/* Prints a line for every naive hand among the runs. */
void bot_naive_print_table(const bot_run* runs, int count);
/* Prints the pulls that lost a right joint, the surest joints first. */
void bot_naive_print_worst(const bot_run* run, FILE* out);

#endif
