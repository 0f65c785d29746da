/* dragmesh bench DIR: times the preparation of the objects of a folder, first part and each further one. */
#ifndef CLI_BENCH_OBJECTS_H
#define CLI_BENCH_OBJECTS_H

#include "session.h"

/* Prints quantiles over the folder's objects (object.glb + joints.json). Returns an exit status. */
int bench_objects(session* session, const char* folder, int as_json);

#endif
