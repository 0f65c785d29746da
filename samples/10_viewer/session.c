/* What a player did, frame by frame, as text: recorded, read back, played again. */
#include "session.h"

#include <stdlib.h>
#include <string.h>

#include "../common/platform.h"
#include "files.h"

enum { KINDS = 7, LINE = 4096 }; /* kinds of events, bytes of a line */
static const char* const kinds[KINDS] = {"camera", "move", "press", "release", "wheel", "key", "end"};
static const int number_counts[KINDS] = {6, 2, 0, 0, 1, 0, 0};
static const char* const buttons[4] = {"", "left", "middle", "right"};

static int find(const char* const* names, int count, const char* name) {
    for (int i = 0; i < count; i++)
        if (strcmp(names[i], name) == 0) return i;
    return -1;
}

/* The words after the kind. */
static int read_arguments(event* event, char* rest) {
    for (int i = 0; i < number_counts[event->kind]; i++) {
        char* end = rest;
        event->numbers[i] = strtof(rest, &end);
        if (end == rest || !isfinite(event->numbers[i])) return -1;
        rest = end;
    }
    char word[16] = "", extra[16] = "";
    const int words = sscanf(rest, "%15s %15s", word, extra);
    event->shift = strcmp(words == 2 ? extra : word, "shift") == 0;
    if (event->kind == EVENT_KEY) {
        memcpy(event->key, word, sizeof word);
        return words >= 1 ? 0 : -1;
    }
    if (event->kind != EVENT_PRESS && event->kind != EVENT_RELEASE) return 0;
    event->button = find(buttons, 4, word);
    return event->button > 0 ? 0 : -1;
}

static int read_event(session* session, char* line) {
    event event;
    memset(&event, 0, sizeof event);
    char kind[16], *rest = line;
    int used = 0;
    const unsigned long frame = strtoul(line, &rest, 10);
    if (rest == line || frame > 1000000 || sscanf(rest, "%15s%n", kind, &used) != 1) return -1;
    event.frame = (uint32_t)frame;
    event.kind = find(kinds, KINDS, kind);
    if (event.kind < 0 || read_arguments(&event, rest + used) != 0) return -1;
    if (session->event_count > 0 && event.frame < session->events[session->event_count - 1].frame) return -1;
    if (session->event_count % 256 == 0) {
        void* grown = realloc(session->events, (session->event_count + 256) * sizeof event);
        if (grown == NULL) return -1;
        session->events = grown;
    }
    session->events[session->event_count++] = event;
    session->end = event.frame;
    return 0;
}

static int read_size(session* session, const char* text) {
    char* rest;
    const long width = strtol(text, &rest, 10), height = strtol(rest, NULL, 10);
    session->width = (int)width, session->height = (int)height;
    return width > 0 && width <= 8192 && height > 0 && height <= 8192 ? 0 : -1;
}

static int read_line(session* session, char* line) {
    line[strcspn(line, "\r\n")] = 0;
    if (line[0] == 0 || line[0] == '#') return 0;
    if (strncmp(line, "size ", 5) == 0) return read_size(session, line + 5);
    if (strncmp(line, "up ", 3) == 0) {
        session->z_up = line[3] == 'z';
        return 0;
    }
    if (strncmp(line, "scene ", 6) == 0)
        return snprintf(session->scene, sizeof session->scene, "%s", line + 6) < (int)sizeof session->scene ? 0 : -1;
    if (strncmp(line, "part ", 5) == 0 && session->part_count < WORLD_MAX_PARTS) {
        const size_t size = strlen(line + 5) + 1;
        char* name = take(size, 1);
        memcpy(name, line + 5, size);
        session->parts[session->part_count++] = name;
        return 0;
    }
    return read_event(session, line);
}

int session_read(session* session, const char* path) {
    memset(session, 0, sizeof *session);
    session->width = 960;
    session->height = 600;
    FILE* file = platform_open_regular(path);
    char* line = take(LINE, 1);
    int status = file != NULL && fgets(line, LINE, file) != NULL && strcmp(line, "dragmesh-session 1\n") == 0 ? 0 : -1;
    if (status != 0) fprintf(stderr, "viewer: '%s' is no session (its first line is \"dragmesh-session 1\")\n", path);
    for (int number = 2; status == 0 && fgets(line, LINE, file) != NULL; number++) {
        status = read_line(session, line);
        if (status != 0) fprintf(stderr, "viewer: %s, line %d: can't be read\n", path, number);
    }
    free(line);
    if (file != NULL) fclose(file);
    if (status != 0) session_free(session);
    return status;
}

void session_free(session* session) {
    for (uint32_t i = 0; i < session->part_count; i++) free(session->parts[i]);
    free(session->events);
    memset(session, 0, sizeof *session);
}

void session_write_head(output_file* file, const camera* camera, const world_options* options) {
    output_print(file, "dragmesh-session 1\nsize %d %d\nup %c\n", camera->width, camera->height,
                 camera->z_up ? 'z' : 'y');
    if (options->scene != NULL) output_print(file, "scene %s\n", options->scene);
    for (uint32_t i = 0; i < options->part_count; i++) output_print(file, "part %s\n", options->parts[i]);
    const event start = {.kind = EVENT_CAMERA,
                         .numbers = {camera->yaw, camera->pitch, camera->distance, camera->target.x, camera->target.y,
                                     camera->target.z}};
    session_write_event(file, &start);
}

void session_write_event(output_file* file, const event* event) {
    output_print(file, "%u %s", event->frame, kinds[event->kind]);
    for (int i = 0; i < number_counts[event->kind]; i++) output_print(file, " %.9g", (double)event->numbers[i]);
    if (event->kind == EVENT_KEY) output_print(file, " %s", event->key);
    if (event->kind == EVENT_PRESS || event->kind == EVENT_RELEASE) output_print(file, " %s", buttons[event->button]);
    output_print(file, "%s\n", event->shift ? " shift" : "");
}
