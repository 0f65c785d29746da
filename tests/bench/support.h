/* What the measuring programs share: a cabinet of as many doors and triangles as asked for, clocks, statistics. */
#ifndef DM_BENCH_SUPPORT_H
#define DM_BENCH_SUPPORT_H

#include <dragmesh/dragmesh.h>
#include <stddef.h>
#include <stdint.h>

/* Host buffers of a cabinet: part 0 is the body, 1 … parts the doors, each with a bar for a handle. */
typedef struct bench_mesh {
    float* positions;
    uint32_t *indices, *part_ids;
    uint32_t vertex_count, face_count, parts;
} bench_mesh;

/* At least `triangles`, in squares as even as can be. Exits where there is no memory. */
bench_mesh bench_mesh_new(uint32_t triangles, uint32_t parts);
void bench_mesh_free(bench_mesh* mesh);
/* part_ids one a face. */
dm_mesh_desc bench_mesh_desc(const bench_mesh* mesh);
/* A pull at the handle of a door. */
dm_drag_hint bench_mesh_drag(uint32_t part);

/* Time that this thread has run, so that other programs on the machine cost little of the truth. */
double bench_now_ns(void);
/* Median of what `call` takes over rounds that last `ms` together (3 at least); the least goes to *out_least unless
 * NULL. */
double bench_median_ns(void (*call)(void* user), void* user, double ms, double* out_least);
/* A whole file; exits where it can't be read. */
void* bench_read(const char* path, size_t* out_size);
void* bench_alloc(size_t size);

#endif
