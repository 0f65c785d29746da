/* A folder of assets, each rigged by a process of its own: one that breaks leaves the others alone. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "json.h"
#include "rig_output.h"

enum { MOST_ARGUMENTS = 20 };

typedef struct asset {
    char *name, *file, *folder; /* its name, what is rigged, and where the files go */
} asset;

typedef struct run {
    const char *folder, *models, *options_text;
    const rig_output* output;
    const rig_options* options;
    asset* assets;
    int count;
    int finished, failed, skipped; /* so far */
    double start;                  /* ms */
} run;

/* ---- the assets ---- */

static bool ends_with(const char* name, const char* suffix) {
    const size_t length = strlen(name), end = strlen(suffix);
    return length > end && strcmp(name + length - end, suffix) == 0;
}

static void add_asset(run* run, const char* name, char* file) {
    run->assets = cli_grow(run->assets, (size_t)(run->count + 1) * sizeof *run->assets);
    run->assets[run->count++] =
        (asset){.name = cli_copy_text(name), .file = file, .folder = path_join(run->output->path, name)};
}

static void find_asset(void* user, const char* name) {
    run* run = user;
    if (name[0] == '.') return;
    char *file = path_join(run->folder, name), *inside = path_join(file, "object.glb");
    const enum platform_kind kind = platform_kind_of(file);
    if (kind == PLATFORM_FILE && (ends_with(name, ".glb") || ends_with(name, ".gltf"))) {
        char stem[256];
        part_hints_file_stem(name, stem, sizeof stem);
        add_asset(run, stem, file);
        free(inside);
    } else if (kind == PLATFORM_FOLDER && platform_kind_of(inside) == PLATFORM_FILE) {
        add_asset(run, name, inside);
        free(file);
    } else {
        free(inside);
        free(file);
    }
}

static int by_name(const void* a, const void* b) {
    return strcmp(((const asset*)a)->name, ((const asset*)b)->name);
}

static void free_assets(run* run) {
    for (int i = 0; i < run->count; i++) {
        free(run->assets[i].name);
        free(run->assets[i].file);
        free(run->assets[i].folder);
    }
    free(run->assets);
}

/* ---- what is done ---- */

/* Whether an asset has an answer to what is asked that is no older than its file. */
static bool is_done(const run* run, const asset* asset) {
    char* path = path_join(asset->folder, RIG_ANSWER);
    size_t size;
    char* text = platform_modified(path) >= platform_modified(asset->file) ? file_read(path, &size) : NULL;
    cJSON* answer = text != NULL ? cJSON_ParseWithLength(text, size) : NULL;
    const char* options = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(answer, "options"));
    const bool done = options != NULL && strcmp(options, run->options_text) == 0;
    cJSON_Delete(answer);
    free(text);
    free(path);
    return done;
}

/* Returns what the worker of an asset has left; NULL: nothing, it broke. To be freed. */
static char* take_word(const asset* asset) {
    char* path = path_join(asset->folder, RIG_WORD);
    size_t size;
    char* word = file_read(path, &size);
    platform_remove(path);
    free(path);
    return word;
}

static void print_json(const asset* asset, bool done, const char* word) {
    char* path = path_join(asset->folder, RIG_ANSWER);
    size_t size = 0;
    char* text = done ? file_read(path, &size) : NULL;
    cJSON* answer = text != NULL ? cJSON_ParseWithLength(text, size) : cJSON_CreateObject();
    cJSON_AddStringToObject(answer, "asset", asset->name);
    if (!done) cJSON_AddStringToObject(answer, "error", word);
    json_print_line(answer);
    free(text);
    free(path);
}

/* Prints one line about an asset: how many are through, how long the others take, and how it went. */
static void report(run* run, const asset* asset, bool done, const char* word) {
    const int worked = run->finished - run->skipped, left = run->count - run->finished;
    const double seconds = worked > 0 ? (cli_now_ms() - run->start) / 1e3 / worked * left : 0;
    if (run->output->as_json)
        print_json(asset, done, word);
    else
        printf("[%d/%d, %.0f s left] %s: %s%s\n", run->finished, run->count, seconds, asset->name,
               done ? "" : "failed: ", word);
    fflush(stdout);
}

static void finish(run* run, const asset* asset, int status) {
    char* word = take_word(asset);
    const bool done = status == CLI_OK && word != NULL;
    run->finished++;
    run->failed += !done;
    report(run, asset, done, word != NULL ? word : "its worker broke");
    free(word);
}

/* ---- workers ---- */

static bool start_worker(const run* run, const asset* asset, platform_child* out_child) {
    char moves[32], formats[RIG_FORMATS_TEXT];
    const char* arguments[MOST_ARGUMENTS] = {
        "dragmesh", "rig", "--worker", "-o", asset->folder, "--up", (const char[]){run->options->up, 0}};
    int count = 7;
    snprintf(moves, sizeof moves, "%.17g", run->options->min_moves);
    rig_format_names(run->options->formats, formats, sizeof formats);
    arguments[count++] = "--formats", arguments[count++] = formats;
    arguments[count++] = "--min-moves", arguments[count++] = moves;
    arguments[count++] = "--names", arguments[count++] = run->options->without_names ? "off" : "on";
    if (run->options->without_clips) arguments[count++] = "--no-clips";
    if (run->models != NULL) arguments[count++] = "--models", arguments[count++] = run->models;
    arguments[count++] = "--", arguments[count++] = asset->file;
    if (platform_make_folder(asset->folder) != 0 && errno != EEXIST) return false;
    free(take_word(asset));
    return platform_start_child((char* const*)(void*)arguments, out_child);
}

static void skip(run* run, const asset* asset) {
    run->finished++;
    run->skipped++;
    report(run, asset, true, "done already");
}

/* Keeps `workers` processes at work until all assets are through. */
static void work(run* run, int workers) {
    platform_child* children = cli_alloc((size_t)workers * sizeof *children);
    const asset** busy = cli_alloc((size_t)workers * sizeof *busy);
    int running = 0, next = 0;
    while (next < run->count || running > 0) {
        while (next < run->count && running < workers) {
            const asset* asset = &run->assets[next++];
            if (is_done(run, asset)) {
                skip(run, asset);
            } else if (start_worker(run, asset, &children[running])) {
                busy[running++] = asset;
            } else {
                run->finished++;
                run->failed++;
                report(run, asset, false, strerror(errno));
            }
        }
        if (running == 0) continue;
        int status;
        const int ended = platform_wait_child(children, running, &status);
        const asset* asset = busy[ended];
        running--;
        children[ended] = children[running];
        busy[ended] = busy[running];
        finish(run, asset, status);
    }
    free(children);
    free((void*)busy);
}

int rig_folder(const char* folder, const char* models, const rig_output* output, const rig_options* options,
               int workers) {
    char text[RIG_OPTIONS_TEXT];
    run run = {.folder = folder,
               .models = models,
               .options_text = rig_options_text(options, text, sizeof text),
               .output = output,
               .options = options,
               .start = cli_now_ms()};
    if (platform_make_folder(output->path) != 0 && errno != EEXIST) {
        fprintf(stderr, "dragmesh: can't make the folder '%s': %s\n", output->path, strerror(errno));
        return CLI_FAILED;
    }
    if (!platform_list(folder, find_asset, &run) || run.count == 0) {
        fprintf(stderr, "dragmesh: there is no asset in '%s'\n", folder);
        return CLI_FAILED;
    }
    qsort(run.assets, (size_t)run.count, sizeof *run.assets, by_name);
    work(&run, workers);
    if (!output->as_json)
        printf("%d assets: %d rigged, %d done already, %d failed, %.1f s\n", run.count,
               run.finished - run.failed - run.skipped, run.skipped, run.failed, (cli_now_ms() - run.start) / 1e3);
    const int status = run.failed == 0 ? CLI_OK : CLI_FAILED;
    free_assets(&run);
    return status;
}
