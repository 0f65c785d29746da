/* What a game brings along: memory that is counted, and job threads for work that no frame waits for. */
#ifndef SAMPLE_HOST_H
#define SAMPLE_HOST_H

#include <pthread.h>
#include <stdatomic.h>

#include "dragmesh/dragmesh.h"

enum { JOB_THREADS = 2, MOST_JOBS = 64 /* that wait, a power of two */ };

typedef struct job {
    void (*run)(void* data);
    void* data;
} job;

typedef struct host {
    atomic_size_t used, peak; /* bytes */
    pthread_t threads[JOB_THREADS];
    pthread_mutex_t lock;
    pthread_cond_t news, idle;
    job queue[MOST_JOBS];
    unsigned first, last; /* of the jobs that wait; they count on, modulo MOST_JOBS */
    int started, busy;    /* threads */
    int closed;
} host;

/* Returns 0 when no thread can be started. */
int host_open(host* host);
/* Waits for the jobs that were started. */
void host_close(host* host);
/* Gives a job to the first thread that is free. Returns 0 when too many wait. */
int host_start(host* host, void (*run)(void* data), void* data);
/* Waits until no job is left: behind a loading screen, never in a frame. */
void host_wait(host* host);
/* For dm_context_desc: safe on all threads, as the library calls it on the job threads too. */
dm_allocator host_allocator(host* host);

double wall_us(void);
/* Processor time of the calling thread: what else the machine does is not in it. */
double thread_us(void);

#endif
