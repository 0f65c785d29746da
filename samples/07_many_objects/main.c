/* A level of thousands of props that is streamed while a camera walks through it:
 *   sample_many_objects [OPTIONS] [-o DIR] [FILE.dmo…]
 * Kinds of props are the files, and one that is prepared while the frames go on. Writes level.png, frames.png and
 * report.txt to DIR. An option that it does not know makes it list them. */
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>
#include <time.h>

#include "../common/cabinet.h"
#include "../common/output_file.h"
#include "../common/vectors.h"
#include "../common/weights.h"
#include "draw.h"
#include "kinds.h"

enum {
    MOST_FILES = MOST_KINDS - 1,
    MOST_PROPS = 1000000,
    MOST_FRAMES = 1000000,
    MOST_WIDTH = 8192,
    FILL_FRAMES = 20000 /* most behind a loading screen */
};
#define MOST_REACH 1000.0f /* m */

typedef struct options {
    uint32_t props, frames, width; /* width: of level.png, pixels */
    float reach, budget, fps;      /* m, ms, frames a second. fps 0: no budget, and each frame waits for the jobs */
    const char *models, *folder;
    const char* files[MOST_FILES];
    uint32_t file_count;
} options;

typedef struct game {
    host host;
    level level;
    stream stream;
    hands hands;
    frame_note* notes;
    uint32_t walked, over;                        /* frames; over: beyond the budget */
    float worst, sum;                             /* ms */
    uint32_t fill_frames, settle_frames, missing; /* before and after the walk; props that are missing then */
    uint32_t most_here, most_placed;
    uint64_t most_bytes;
} game;

/* ---- a frame ---- */

/* To the end of the level, and most of the way back. */
static float walk_z(const game* g, uint32_t frame, uint32_t frames) {
    const float t = (float)frame / (float)frames, back = 0.75f, turn = 1 / (1 + back);
    return -level_length(&g->level) * (t < turn ? t / turn : 1 - (t - turn) / turn);
}

static dm_camera camera_at(float z, bool back) {
    return (dm_camera){.struct_size = sizeof(dm_camera),
                       .fov_y = 1.0f,
                       .eye = {0, 1.7f, z},
                       .forward = {0, -0.12f, back ? 1.0f : -1.0f},
                       .up = {0, 1, 0},
                       .viewport_width = 960,
                       .viewport_height = 540};
}

/* Drags and streaming change the scene, one commit shows it, and picks see it. */
static dm_result play_frame(game* g, const dm_camera* camera, const options* o, frame_note* out) {
    stream* s = &g->stream;
    const double deadline = o->fps > 0 ? wall_us() + 1e3 * (double)o->budget : INFINITY, start = thread_us();
    dm_result result = hands_pull(&g->hands);
    const double streaming = thread_us();
    out->missing = stream_step(s, camera->eye.x, camera->eye.z, deadline);
    const double streamed = thread_us();
    if (result == DM_OK) result = dm_scene_commit(s->context, s->scene);
    if (result == DM_OK) result = hands_look(&g->hands, camera, s->frame);
    out->stream_ms = (float)(1e-3 * (streamed - streaming));
    out->rest_ms = (float)(1e-3 * (thread_us() - streamed + streaming - start));
    out->placed = s->placed_count;
    return result;
}

static void note_frame(game* g, const frame_note* note, const options* o) {
    const float ms = note->stream_ms + note->rest_ms;
    dm_memory_info memory = {.struct_size = sizeof memory};
    dm_context_get_memory(g->stream.context, &memory);
    if (memory.bytes - memory.kept_bytes > g->most_bytes) g->most_bytes = memory.bytes - memory.kept_bytes;
    if (g->stream.here > g->most_here) g->most_here = g->stream.here;
    if (note->placed > g->most_placed) g->most_placed = note->placed;
    g->worst = ms > g->worst ? ms : g->worst;
    g->sum += ms;
    g->over += ms > o->budget;
    g->notes[g->walked++] = *note;
}

/* Leaves the processor to the job threads. */
static void rest_until(double when_us) {
    const double left = when_us - wall_us();
    if (!(left > 0)) return;
    const struct timespec time = {(time_t)(left / 1e6), (long)(1e3 * (left - 1e6 * (double)(time_t)(left / 1e6)))};
    nanosleep(&time, NULL);
}

/* Plays frames until all that is within reach is there, as behind a loading screen. */
static dm_result fill(game* g, const dm_camera* camera, const options* o, uint32_t* out_frames) {
    frame_note note = {.missing = 1};
    dm_result result = DM_OK;
    for (*out_frames = 0; note.missing > 0 && *out_frames < FILL_FRAMES && result == DM_OK; ++*out_frames) {
        result = play_frame(g, camera, o, &note);
        host_wait(&g->host);
    }
    g->missing = note.missing;
    return result;
}

static dm_result walk(game* g, const options* o) {
    dm_result result = DM_OK;
    g->stream.counts.late = 0; /* those of the loading screen */
    for (uint32_t i = 0; i < o->frames && result == DM_OK; i++) {
        const float z = walk_z(g, i, o->frames);
        const dm_camera camera = camera_at(z, walk_z(g, i + 1, o->frames) > z);
        const double start = wall_us();
        frame_note note = {0};
        result = play_frame(g, &camera, o, &note);
        note_frame(g, &note, o);
        if (o->fps > 0)
            rest_until(start + 1e6 / (double)o->fps);
        else
            host_wait(&g->host);
    }
    return result;
}

/* ---- what is left of it ---- */

static int write_report(const game* g, const options* o, char* text, size_t size) {
    const stream_counts* c = &g->stream.counts;
    return snprintf(
        text, size,
        "level: %u props of %u kinds, %.0f m long; reach %.0f m\n"
        "frames: %u, after %u of a loading screen; %u more until all was there, %u props missing\n"
        "frame: %.3f ms on average, %.3f ms the worst, %u beyond the budget of %g ms\n"
        "props: %" PRIu64 " came, %" PRIu64 " went, %u at once at most, late %" PRIu64 " times a frame each\n"
        "kinds: %" PRIu64 " loaded, %" PRIu64 " prepared, %" PRIu64 " given back, %u at once at most\n"
        "hands: %" PRIu64 " picks, %" PRIu64 " hits, %" PRIu64 " drags, %" PRIu64 " updates; %u parts kept, %" PRIu64
        " put back\n"
        "memory: %.2f MB in use at most; the host gave %.2f MB at most, scratch included\n",
        o->props, g->stream.kind_count, (double)level_length(&g->level), (double)o->reach, g->walked, g->fill_frames,
        g->settle_frames, g->missing, (double)(g->sum / (float)g->walked), (double)g->worst, g->over, (double)o->budget,
        c->placed, c->removed, g->most_placed, c->late, c->loaded, c->prepared, c->unloaded, g->most_here,
        g->hands.picks, g->hands.hits, g->hands.drags, g->hands.updates, g->level.kept_count, c->restored,
        (double)g->most_bytes / 1048576, (double)atomic_load(&g->host.peak) / 1048576);
}

static int complain(const char* path) {
    fprintf(stderr, "can't write %s: %s\n", path, strerror(errno));
    return 1;
}

static int write_picture(canvas picture, const char* folder, const char* name) {
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    const int status = canvas_write(&picture, path) != 0 ? complain(path) : 0;
    canvas_free(&picture);
    return status;
}

static int write_all(const game* g, const options* o, const dm_camera* camera) {
    char text[2048], path[1024];
    const int size = write_report(g, o, text, sizeof text);
    fputs(text, stdout);
    if (o->folder == NULL) return 0;
    snprintf(path, sizeof path, "%s/report.txt", o->folder);
    if (output_write(path, text, (size_t)size) != 0) return complain(path);
    dm_camera high = *camera; /* the walker's view, from farther up */
    high.eye.y = 4.5f, high.forward.y = -0.3f;
    return write_picture(draw_level(&g->hands, &high, (int)o->width, (int)(o->width * 9 + 15) / 16), o->folder,
                         "level.png") ||
           write_picture(draw_frames(g->notes, g->walked, o->budget), o->folder, "frames.png");
}

/* ---- the program ---- */

/* Takes the value of an option, and moves past it. Returns false when it is another option, or has no value. */
static bool take(const char* name, int argc, char** argv, int* inout_at, const char** out_value) {
    if (strcmp(argv[*inout_at], name) != 0 || *inout_at + 1 >= argc) return false;
    *out_value = argv[++*inout_at];
    return true;
}

static bool read_options(int argc, char** argv, options* out) {
    *out = (options){
        .props = 5000, .frames = 3600, .width = 960, .reach = 30, .budget = 0.5f, .fps = 60, .models = "sdk/models"};
    for (int i = 1; i < argc; i++) {
        const char* value = NULL;
        if (take("--props", argc, argv, &i, &value))
            out->props = (uint32_t)strtoul(value, NULL, 10);
        else if (take("--frames", argc, argv, &i, &value))
            out->frames = (uint32_t)strtoul(value, NULL, 10);
        else if (take("--width", argc, argv, &i, &value))
            out->width = (uint32_t)strtoul(value, NULL, 10);
        else if (take("--reach", argc, argv, &i, &value))
            out->reach = strtof(value, NULL);
        else if (take("--budget", argc, argv, &i, &value))
            out->budget = strtof(value, NULL);
        else if (take("--fps", argc, argv, &i, &value))
            out->fps = strtof(value, NULL);
        else if (take("--models", argc, argv, &i, &value))
            out->models = value;
        else if (take("-o", argc, argv, &i, &value))
            out->folder = value;
        else if (argv[i][0] != '-' && out->file_count < MOST_FILES)
            out->files[out->file_count++] = argv[i];
        else
            return false;
    }
    return out->props > 0 && out->props <= MOST_PROPS && out->frames > 0 && out->frames <= MOST_FRAMES &&
           out->width > 0 && out->width <= MOST_WIDTH && out->reach > 0 && out->reach <= MOST_REACH &&
           out->budget > 0 && out->fps >= 0;
}

/* The context, the scene and the level. */
static bool open_game(game* g, const options* o) {
    stream* s = &g->stream;
    const dm_context_desc desc = {
        .struct_size = sizeof desc, .allocator = host_allocator(&g->host), .log = {NULL, print_message}};
    const dm_scene_desc scene = {.struct_size = sizeof scene};
    *s = (stream){.host = &g->host, .level = &g->level, .reach = o->reach, .leaves = hands_leave, .user = &g->hands};
    g->hands.stream = s;
    g->notes = calloc(o->frames, sizeof *g->notes);
    return g->notes != NULL && host_open(&g->host) && dm_context_create(&desc, &s->context) == DM_OK &&
           load_weights(s->context, o->models, &s->model) == DM_OK &&
           dm_scene_create(s->context, &scene, &s->scene) == DM_OK &&
           level_make(&g->level, o->props, o->file_count + 1) && stream_open(s, o->files, o->file_count);
}

/* Jobs end before what they work on goes. */
static void close_game(game* g) {
    hands_rest(&g->hands);
    host_close(&g->host);
    dm_context_destroy(g->stream.context);
    stream_close(&g->stream);
    level_free(&g->level);
    free(g->notes);
}

int main(int argc, char** argv) {
    static game g;
    static options o;
    platform_start(&argc, &argv);
    if (!read_options(argc, argv, &o)) {
        fprintf(stderr,
                "%s [--props N] [--frames N] [--reach M] [--budget MS] [--fps N] [--width N] [--models DIR] [-o DIR] "
                "[FILE.dmo...]\n",
                argv[0]);
        return 2;
    }
    if (!open_game(&g, &o)) {
        fprintf(stderr, "can't start: no memory, no threads, or no weights in %s\n", o.models);
        return 1;
    }
    const dm_camera first = camera_at(0, false), last = camera_at(walk_z(&g, o.frames, o.frames), true);
    dm_result result = fill(&g, &first, &o, &g.fill_frames);
    if (result == DM_OK) result = walk(&g, &o);
    if (result == DM_OK) result = fill(&g, &last, &o, &g.settle_frames);
    if (result != DM_OK) fprintf(stderr, "%s\n", dm_result_string(result));
    const int status = write_all(&g, &o, &last) != 0 || result != DM_OK || g.stream.failed > 0;
    close_game(&g);
    if (atomic_load(&g.host.used) != 0) fprintf(stderr, "%zu bytes are left\n", atomic_load(&g.host.used));
    return status || atomic_load(&g.host.used) != 0;
}
