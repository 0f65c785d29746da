/* dragmesh bench DIR: what preparing the objects of a folder costs, first part and each further one. */
#ifndef CLI_BENCH_OBJECTS_H
#define CLI_BENCH_OBJECTS_H

#include "session.h"

/* Prints medians over the folder's objects (those of object.glb + joints.json). An exit status. */
int bench_objects(session* session, const char* folder, int as_json);

#endif
