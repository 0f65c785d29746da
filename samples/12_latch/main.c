/* Plays the scripted hands of a scene and tells what a game hears: the events, as they come.
 *
 *     sample_latch                         all scenes
 *     sample_latch house_door [HZ]         one scene, at a frame rate
 *     sample_latch house_door --glb FILE   its object as a .glb */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../common/cabinet.h"
#include "../common/output_file.h"
#include "../common/shown.h"
#include "game.h"

typedef struct listener {
    const scene* scene;
    float time; /* s */
} listener;

static void hear(void* user, uint32_t part_id, const dm_drag_state* now) {
    const listener* ear = user;
    for (uint32_t event = 1; event <= now->events; event <<= 1) {
        const char* words = game_sound(now->events & event);
        if (words == NULL) continue;
        printf("%6.2f s  %s %s", (double)ear->time, ear->scene->parts[part_id - 1].name, words);
        if (event == DM_EVENT_DETENT && now->detents > 1) printf(" %u times", now->detents);
        if (event & (DM_EVENT_LIMIT_LOWER | DM_EVENT_LIMIT_UPPER | DM_EVENT_BLOCKED))
            printf(", %.2f a second", (double)now->impact);
        printf("\n");
    }
}

static int run(dm_context* context, const scene* scene, float hz) {
    static scene_mesh mesh;
    scene_mesh_make(scene, &mesh);
    const dm_mesh_desc desc = scene_mesh_desc(&mesh);
    dm_object object;
    game game;
    script script;
    listener ear = {scene, 0};
    if (scene_prepare(scene, context, &desc, &object) != DM_OK) return 1;
    game_open(&game, scene, context, object);
    game.heard = hear, game.user = &ear;
    script_open(&script);
    printf("%s\n", scene->name);
    while (script_step(&script, &game, 1 / hz)) ear.time = script.time + 1 / hz;
    printf("  ends with");
    for (uint32_t i = 0; i < scene->part_count; i++)
        printf("%s %s %.3f", i ? "," : "", scene->parts[i].name, shown((double)game.values[i], 3));
    printf("\n");
    return dm_object_destroy(context, object) == DM_OK ? 0 : 1;
}

static int write_glb(const scene* scene, const char* path) {
    size_t size = 0;
    void* bytes = scene_glb(scene, &size);
    const int status = bytes != NULL && output_write(path, bytes, size) == 0 ? 0 : 1;
    if (status != 0) fprintf(stderr, "can't write %s: %s\n", path, strerror(errno));
    free(bytes);
    return status;
}

int main(int argc, char** argv) {
    const scene* one = argc > 1 ? scene_find(argv[1]) : NULL;
    if (argc > 1 && one == NULL) {
        fprintf(stderr, "no scene has the name '%s'\n", argv[1]);
        return 2;
    }
    if (argc > 3 && strcmp(argv[2], "--glb") == 0) return write_glb(one, argv[3]);
    const float hz = argc > 2 ? strtof(argv[2], NULL) : 60;
    if (!(hz >= 1 && hz <= 1000)) return 2;
    dm_context_desc host = dm_context_desc_default();
    host.log.message = print_message;
    dm_context* context;
    if (dm_context_create(&host, &context) != DM_OK) return 1;
    int status = one != NULL ? run(context, one, hz) : 0;
    for (uint32_t i = 0; one == NULL && scene_at(i) != NULL; i++) status |= run(context, scene_at(i), hz);
    dm_context_destroy(context);
    return status;
}
