/* What of the level is in memory: the kinds of props near the camera, as prepared objects, and the props themselves, as
 * instances of a scene. */
#ifndef SAMPLE_STREAM_H
#define SAMPLE_STREAM_H

#include "host.h"
#include "level.h"

enum { MOST_KINDS = 256, MOST_PARTS = 32, MOST_COMING = 2 * JOB_THREADS /* kinds that jobs fetch at once */ };

enum { KIND_OUT, KIND_COMING, KIND_HERE, KIND_FAILED };

typedef struct stream stream;

typedef struct kind {
    stream* owner;
    const char* path; /* of its .dmo; NULL: none yet, it is prepared when it is first needed */
    void* bytes;      /* what was prepared then, as a .dmo */
    size_t byte_count;
    atomic_int state; /* KIND_*: COMING is the job's, all others the game thread's */
    dm_object object;
    dm_object_info info;
    dm_part_info parts[MOST_PARTS];
    uint32_t part_count;
    uint32_t placed;      /* props */
    bool counted;         /* the game thread has seen it come; read and written by that thread alone */
    uint64_t wanted_when; /* the last frame in which a prop of it was near */
} kind;

typedef struct stream_counts {
    uint64_t placed, removed, loaded, prepared, unloaded,
        restored;  /* restored: parts that stood as they had been left */
    uint64_t late; /* props that were half-way to the camera before they were there, a frame each */
} stream_counts;

struct stream {
    dm_context* context;
    dm_model model; /* for the kinds that are prepared */
    dm_scene scene;
    host* host;
    level* level;
    float reach; /* m */
    kind kinds[MOST_KINDS];
    uint32_t kind_count, coming, here, failed;
    uint32_t* placed;                /* indices of props, in no order */
    uint32_t placed_count, *prop_of; /* prop_of: by instance */
    uint64_t frame;
    stream_counts counts;
    void (*leaves)(void* user, uint32_t prop); /* told before a prop goes */
    void* user;
};

/* The context, the scene, the level and reach are set. Returns false when there is no memory. */
bool stream_open(stream* s, const char* const* files, uint32_t file_count);
void stream_close(stream* s);
/* One frame: takes out what is far, and brings in what is near, nearest first, until wall_us() is `deadline`; one prop
 * at least. Returns how many props within reach are not there yet. */
uint32_t stream_step(stream* s, float x, float z, double deadline);
/* Moves a part and those that it carries. */
dm_result stream_move(stream* s, uint32_t prop, uint32_t part, const dm_pose* pose);

#endif
