/* A game's worth of library to measure: a context that counts, the shipped weights, a cabinet, through the public
 * header alone. Whatever fails ends the program. */
#ifndef DM_BENCH_WORLD_H
#define DM_BENCH_WORLD_H

#include "support.h"

typedef struct bench_world {
    dm_context* context;
    dm_model model;
    bench_mesh mesh;
    dm_object object;
    _Atomic uint64_t allocations; /* of the context so far */
} bench_world;

/* Checks a call's answer. */
void bench_check(dm_result result, const char* what);
/* A context and the weights of a folder. `jobs` may be NULL. */
void bench_world_open(bench_world* world, const char* models, const dm_jobs* jobs);
/* Prepares a cabinet of so many triangles and doors; flags DM_PREPARE_*. */
dm_object bench_world_prepare(bench_world* world, const bench_mesh* mesh, uint32_t flags);
/* Gives a door the hinge that it should have, so that what is measured does not hang on what was found. */
void bench_world_hinge(bench_world* world, dm_object object, uint32_t part, int32_t type);
void bench_world_close(bench_world* world);

#endif
