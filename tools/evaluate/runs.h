/* What runs the commands of the laboratory. */
#ifndef EVALUATE_RUNS_H
#define EVALUATE_RUNS_H

#include "program.h"

command_run eval_run, dragbot_run, bench_run;

#endif
