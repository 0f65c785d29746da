/* A pool of threads over one queue. An engine has its own; any of that kind will do. */
#include "host.h"

#include <time.h>

#include "../common/platform.h"

static void* DM_CALL take(void* user, size_t size, size_t alignment) {
    host* h = user;
    void* memory = platform_allocate(size, alignment);
    if (memory == NULL) return NULL;
    const size_t used = atomic_fetch_add(&h->used, size) + size;
    size_t peak = atomic_load(&h->peak);
    while (used > peak && !atomic_compare_exchange_weak(&h->peak, &peak, used)) {
    }
    return memory;
}

static void DM_CALL give(void* user, void* memory, size_t size) {
    atomic_fetch_sub(&((host*)user)->used, size);
    platform_release(memory);
}

dm_allocator host_allocator(host* h) {
    return (dm_allocator){h, take, give};
}

/* Runs the next job; returns 0 when there will be none. */
static int run_next(host* h) {
    pthread_mutex_lock(&h->lock);
    while (h->first == h->last && !h->closed) pthread_cond_wait(&h->news, &h->lock);
    const int found = h->first != h->last;
    const job next = h->queue[h->first % MOST_JOBS];
    if (found) h->first++, h->busy++;
    pthread_mutex_unlock(&h->lock);
    if (!found) return 0;
    next.run(next.data);
    pthread_mutex_lock(&h->lock);
    h->busy--;
    pthread_cond_broadcast(&h->idle);
    pthread_mutex_unlock(&h->lock);
    return 1;
}

static void* work(void* argument) {
    while (run_next(argument)) {
    }
    return NULL;
}

int host_open(host* h) {
    pthread_mutex_init(&h->lock, NULL);
    pthread_cond_init(&h->news, NULL);
    pthread_cond_init(&h->idle, NULL);
    while (h->started < JOB_THREADS && pthread_create(&h->threads[h->started], NULL, work, h) == 0) h->started++;
    return h->started > 0;
}

void host_close(host* h) {
    pthread_mutex_lock(&h->lock);
    h->closed = 1;
    pthread_cond_broadcast(&h->news);
    pthread_mutex_unlock(&h->lock);
    for (int i = 0; i < h->started; i++) pthread_join(h->threads[i], NULL);
    pthread_cond_destroy(&h->news);
    pthread_cond_destroy(&h->idle);
    pthread_mutex_destroy(&h->lock);
}

int host_start(host* h, void (*run)(void* data), void* data) {
    pthread_mutex_lock(&h->lock);
    const int room = h->last - h->first < MOST_JOBS;
    if (room) h->queue[h->last++ % MOST_JOBS] = (job){run, data};
    pthread_cond_signal(&h->news);
    pthread_mutex_unlock(&h->lock);
    return room;
}

void host_wait(host* h) {
    pthread_mutex_lock(&h->lock);
    while (h->first != h->last || h->busy > 0) pthread_cond_wait(&h->idle, &h->lock);
    pthread_mutex_unlock(&h->lock);
}

static double us_of(clockid_t clock) {
    struct timespec t;
    clock_gettime(clock, &t);
    return 1e6 * (double)t.tv_sec + 1e-3 * (double)t.tv_nsec;
}

double wall_us(void) {
    return us_of(CLOCK_MONOTONIC);
}

double thread_us(void) {
    return us_of(CLOCK_THREAD_CPUTIME_ID);
}
