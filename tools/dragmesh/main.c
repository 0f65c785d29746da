/* dragmesh, the product: says how parts move, and shows and prepares it. */
#include "runs.h"

static command_run* const runs[COMMANDS] = {
    [COMMAND_RIG] = rig_run,         [COMMAND_INFER] = infer_run, [COMMAND_ANIMATE] = animate_run,
    [COMMAND_FILM] = film_run,       [COMMAND_NODES] = nodes_run, [COMMAND_PICK] = pick_run,
    [COMMAND_PREPARE] = prepare_run, [COMMAND_SHOW] = show_run,   [COMMAND_DEMO] = demo_run,
};

int main(int argc, char** argv) {
    return program_main(PROGRAM_DRAGMESH, runs, argc, argv);
}
