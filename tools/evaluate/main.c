/* dragmesh-evaluate, the laboratory: measures the library. */
#include "runs.h"

static command_run* const runs[COMMANDS] = {
    [COMMAND_EVAL] = eval_run,
    [COMMAND_DRAGBOT] = dragbot_run,
    [COMMAND_BENCH] = bench_run,
};

int main(int argc, char** argv) {
    return program_main(PROGRAM_EVALUATE, runs, argc, argv);
}
