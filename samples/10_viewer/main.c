/* A viewer: opens a .glb, shows what can move, lets the player drag it. Also plays recorded sessions off screen. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../common/output_file.h"
#include "apng.h"
#include "app.h"
#include "canvas.h"
#include "draw.h"
#include "files.h"
#include "overlay.h"
#include "poses.h"
#include "render.h"
#include "window.h"

static const char* const usage =
    "viewer FILE.glb [options]\n"
    "  --scene NAME            a scene of samples/12_latch in place of a file: house_door, double_door, safe, "
    "drawers,\n"
    "                          hatch, gears, blocked_door, two_hands; E: its own hands play it\n"
    "  --part NODE[,NODE...]   nodes that move as one; repeat it; without it the library says what moves\n"
    "  --dmo FILE.dmo          use this prepared object; --save FILE.dmo: where S saves (beside the .glb)\n"
    "  --models DIR|none       folder with the weights; without it DRAGMESH_MODELS, then beside the program\n"
    "  --up y|z                the file's up axis (y, as glTF says)\n"
    "  --size WxH              of the window (960x600)\n"
    "  --record FILE           write down what the player does\n"
    "  --replay FILE           do what was written down, off screen\n"
    "    --frames N            pictures to take, evenly spaced, the last at the end (1)\n"
    "    --png DIR             where they go, as frame_000.png ... ; without it nothing is drawn\n"
    "    --apng FILE           ... or as one looping animation, 15 pictures a second\n"
    "    --poses FILE          every pose, in hexadecimal floats; their hash is printed in any case\n";

typedef struct options {
    world_options world;
    const char *save, *record, *replay, *png, *apng, *poses;
    int width, height, frames, z_up;
} options;

typedef struct graphics {
    canvas canvas;
    render render;
    textures textures;
    surface surface;
    draw draw;
    apng animation;
} graphics;

/* ---- options ---- */

/* WxH */
static int read_size(options* options, const char* text) {
    char* rest;
    const long width = strtol(text, &rest, 10), height = *rest == 'x' ? strtol(rest + 1, NULL, 10) : 0;
    options->width = (int)width, options->height = (int)height;
    return width >= 64 && width <= 8192 && height >= 64 && height <= 8192 ? 0 : -1;
}

static int read_option(options* options, const char* name, const char* value) {
    const struct {
        const char* name;
        const char** value;
    } texts[] = {
        {"--dmo", &options->world.dmo}, {"--models", &options->world.models}, {"--save", &options->save},
        {"--record", &options->record}, {"--replay", &options->replay},       {"--png", &options->png},
        {"--poses", &options->poses},   {"--apng", &options->apng},           {"--scene", &options->world.scene}};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        if (strcmp(texts[i].name, name) != 0) continue;
        *texts[i].value = value;
        return 0;
    }
    if (strcmp(name, "--part") == 0 && options->world.part_count < WORLD_MAX_PARTS) {
        options->world.parts[options->world.part_count++] = value;
        return 0;
    }
    if (strcmp(name, "--up") == 0) {
        options->z_up = strcmp(value, "z") == 0;
        return 0;
    }
    if (strcmp(name, "--frames") == 0) {
        options->frames = (int)strtol(value, NULL, 10);
        return options->frames > 0 && options->frames <= 10000 ? 0 : -1;
    }
    if (strcmp(name, "--size") == 0) return read_size(options, value);
    return -1;
}

static int read_options(options* options, int argc, char** argv) {
    memset(options, 0, sizeof *options);
    options->width = 960, options->height = 600, options->frames = 1;
    for (int i = 1; i < argc; i++) {
        if (argv[i][0] != '-') {
            options->world.file = argv[i];
        } else if (i + 1 == argc || read_option(options, argv[i], argv[i + 1]) != 0) {
            fprintf(stderr, "viewer: '%s' can't be used\n", argv[i]);
            return -1;
        } else {
            i++;
        }
    }
    return options->world.file != NULL || options->world.scene != NULL || options->replay != NULL ? 0 : -1;
}

/* ---- files ---- */

static int fail_to_write(const char* path) {
    fprintf(stderr, "viewer: can't write '%s': %s\n", path, strerror(errno));
    return -1;
}

static int open_output(output_file* file, const char* path) {
    return output_open(file, path) == 0 ? 0 : fail_to_write(path);
}

static int close_output(output_file* file, const char* path) {
    return output_close(file) == 0 ? 0 : fail_to_write(path);
}

/* ---- drawing ---- */

static int graphics_open(graphics* graphics, int width, int height) {
    memset(graphics, 0, sizeof *graphics);
    if (canvas_open(&graphics->canvas, width, height) != 0) return -1;
    return render_open(&graphics->render) == 0 && draw_open(&graphics->draw) == 0 ? 0 : -1;
}

static void graphics_close(graphics* graphics) {
    surface_free(&graphics->surface);
    textures_close(&graphics->textures);
    draw_close(&graphics->draw);
    render_close(&graphics->render);
    canvas_close(&graphics->canvas);
}

static void draw_frame(graphics* graphics, app* app) {
    static look looks[WORLD_MAX_PARTS + 1];
    if (graphics->textures.count == 0) textures_open(&graphics->textures, app->world);
    if (app->repaint || !graphics->surface.array) surface_make(&graphics->surface, app->world, &graphics->textures);
    app->repaint = 0;
    canvas_begin(&graphics->canvas);
    overlay_looks(app, looks);
    render_scene(&graphics->render, &graphics->surface, &app->camera, looks, app->world->part_count);
    overlay_ghosts(app, &graphics->render, &graphics->surface);
    overlay_draw(app, &graphics->draw);
}

/* ---- a player at the window ---- */

static void resize(graphics* graphics, app* app, SDL_Window* window) {
    canvas_close(&graphics->canvas);
    SDL_GetWindowSize(window, &app->camera.width, &app->camera.height);
    if (canvas_open(&graphics->canvas, app->camera.width, app->camera.height) != 0) app->quit = 1;
}

enum { MOST_BEHIND = 15 }; /* frames: after a longer stop the world doesn't catch up */

/* Steps of a sixtieth of a second, however fast the screen is, so that a recording plays back the same. */
static void run(app* app, graphics* graphics, SDL_Window* window, output_file* record) {
    const Uint64 start = SDL_GetPerformanceCounter();
    uint32_t frame = 0, skipped = 0;
    event event;
    while (!app->quit) {
        int resized = 0;
        while (window_next(&event, &resized)) {
            event.frame = frame;
            app_event(app, &event);
            if (record != NULL) session_write_event(record, &event);
        }
        if (resized) resize(graphics, app, window);
        const Uint64 passed = SDL_GetPerformanceCounter() - start;
        const uint32_t due = (uint32_t)(passed * 60 / SDL_GetPerformanceFrequency()) - skipped;
        if (due > frame + MOST_BEHIND) skipped += due - frame - MOST_BEHIND;
        for (const uint32_t end = SDL_min(due, frame + MOST_BEHIND); frame < end; frame++) app_tick(app);
        draw_frame(graphics, app);
        canvas_to_window(&graphics->canvas);
        SDL_GL_SwapWindow(window);
    }
    if (record != NULL) output_print(record, "%u end\n", (unsigned)frame);
}

static int play_live(const options* options, world* world) {
    app app;
    window window;
    graphics graphics;
    int status = window_open(&window, options->width, options->height, 0);
    if (status != 0) return status;
    app_open(&app, world, options->width, options->height, options->z_up);
    app.save_path = options->save;
    output_file record = {.stream = NULL};
    if (options->record != NULL) status = open_output(&record, options->record);
    if (record.stream != NULL) session_write_head(&record, &app.camera, &options->world);
    if (status == 0) status = graphics_open(&graphics, options->width, options->height);
    if (status == 0) {
        run(&app, &graphics, window.handle, record.stream != NULL ? &record : NULL);
        graphics_close(&graphics);
        if (options->record != NULL) status = close_output(&record, options->record);
    }
    output_discard(&record);
    window_close(&window);
    return status;
}

/* ---- a recorded session ---- */

/* Frame after which picture i of n is taken. */
static uint32_t picture_frame(const session* session, int i, int count) {
    return (uint32_t)((uint64_t)session->end * (uint64_t)(i + 1) / (uint64_t)count);
}

static int take_picture(graphics* graphics, const char* folder, int number) {
    char name[32];
    snprintf(name, sizeof name, "frame_%03d.png", number);
    char* path = path_join(folder, name);
    const int status = canvas_to_png(&graphics->canvas, path) == 0 ? 0 : fail_to_write(path);
    free(path);
    return status;
}

/* The last picture stands for a while before the animation begins anew. */
static void take_animated(const options* options, graphics* graphics, int number) {
    uint8_t* pixels = canvas_pixels(&graphics->canvas);
    apng_frame(&graphics->animation, pixels, number + 1 == options->frames ? 1200 : 66);
    free(pixels);
}

static int play_events(const options* options, const session* session, app* app, graphics* graphics, poses* poses) {
    uint32_t next = 0;
    int picture = 0, status = 0;
    for (uint32_t frame = 0; frame <= session->end && status == 0; frame++) {
        for (; next < session->event_count && session->events[next].frame == frame; next++)
            app_event(app, &session->events[next]);
        app_tick(app);
        poses_frame(poses, app->world, frame);
        for (;
             graphics != NULL && picture < options->frames && picture_frame(session, picture, options->frames) == frame;
             picture++) {
            draw_frame(graphics, app);
            if (options->png != NULL) status |= take_picture(graphics, options->png, picture);
            if (options->apng != NULL) take_animated(options, graphics, picture);
        }
    }
    return status;
}

static int play_drawn(const options* options, const session* session, app* app, poses* poses) {
    window window;
    graphics graphics;
    if (window_open(&window, session->width, session->height, 1) != 0) return 3;
    int status = graphics_open(&graphics, session->width, session->height);
    if (status == 0 && options->apng != NULL &&
        apng_open(&graphics.animation, options->apng, session->width, session->height, (uint32_t)options->frames) != 0)
        status = fail_to_write(options->apng);
    if (status == 0) status = play_events(options, session, app, &graphics, poses);
    if (graphics.animation.file.stream != NULL && apng_close(&graphics.animation) != 0)
        status = fail_to_write(options->apng);
    graphics_close(&graphics);
    window_close(&window);
    return status;
}

static int replay(const options* options, const session* session, world* world) {
    app app;
    poses poses;
    output_file file = {.stream = NULL};
    if (options->poses != NULL && open_output(&file, options->poses) != 0) return -1;
    poses_open(&poses, file.stream != NULL ? &file : NULL);
    app_open(&app, world, session->width, session->height, session->z_up);
    app.save_path = options->save;
    app.hide_times = 1;
    int status = options->png != NULL || options->apng != NULL ? play_drawn(options, session, &app, &poses)
                                                               : play_events(options, session, &app, NULL, &poses);
    if (status == 0 && options->poses != NULL) status = close_output(&file, options->poses);
    output_discard(&file);
    if (status == 0) printf("poses %016llx over %u frames\n", (unsigned long long)poses.hash, session->end + 1);
    for (uint32_t id = 1; id <= world->part_count && status == 0; id++)
        printf("part %u '%s': %.6g\n", (unsigned)id, world->parts[id].name,
               (double)world->parts[id].state.value + 0.0); /* no -0 */
    return status;
}

int main(int argc, char** argv) {
    static world world;
    options options;
    session session = {0};
    if (argc == 2 && (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)) {
        fputs(usage, stdout);
        return 0;
    }
    if (read_options(&options, argc, argv) != 0) {
        fputs(usage, stderr);
        return 2;
    }
    if (options.replay != NULL && session_read(&session, options.replay) != 0) return 2;
    if (options.world.scene == NULL && options.world.file == NULL && session.scene[0])
        options.world.scene = session.scene;
    if (options.world.file == NULL) options.world.file = options.world.scene; /* its name, for what is saved */
    if (options.world.file == NULL) {
        fputs(usage, stderr);
        session_free(&session);
        return 2;
    }
    for (uint32_t i = 0; i < session.part_count && !options.world.part_count; i++)
        options.world.parts[i] = session.parts[i];
    if (!options.world.part_count) options.world.part_count = session.part_count;
    char* save = path_with_ending(options.world.file, ".dmo");
    if (options.save == NULL) options.save = save;
    int status = world_open(&world, &options.world);
    if (status != 0)
        fprintf(stderr, "viewer: %s\n", world.message);
    else
        status = options.replay != NULL ? replay(&options, &session, &world) : play_live(&options, &world);
    if (status == 0 && world.message[0]) fprintf(stderr, "viewer: %s\n", world.message);
    world_close(&world);
    session_free(&session);
    free(save);
    return status < 0 ? 1 : status;
}
