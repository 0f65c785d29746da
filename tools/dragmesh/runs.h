/* What runs the commands of the product. */
#ifndef DRAGMESH_RUNS_H
#define DRAGMESH_RUNS_H

#include "program.h"

command_run rig_run, infer_run, animate_run, film_run, nodes_run, pick_run, prepare_run, show_run, demo_run;

#endif
