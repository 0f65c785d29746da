/* A street of cabinets: one prepared object, hundreds of instances in one scene, a hand at each, what a frame costs. */
#include <time.h>

#include "../common/cabinet.h"
#include "../common/weights.h"

enum { ROWS = 16, COLUMNS = 16, COUNT = ROWS * COLUMNS, FRAMES = 120 };

static double now_us(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e6 * (double)t.tv_sec + 1e-3 * (double)t.tv_nsec;
}

/* A pose without a turn: dual = half the translation. */
static dm_pose placed(float x, float y, float z) {
    return (dm_pose){{0, 0, 0, 1}, {x / 2, y / 2, z / 2, 0}};
}

static dm_result place_all(dm_context* context, dm_scene scene, dm_object object, uint32_t instances[COUNT]) {
    dm_result result = DM_OK;
    for (int i = 0; i < COUNT && result == DM_OK; i++) {
        const int row = i / COLUMNS, column = i % COLUMNS;
        const dm_pose at = placed(0.8f * (float)column, 0, -1.5f * (float)row);
        result = dm_scene_add(context, scene, object, &at, &instances[i]);
    }
    return result == DM_OK ? dm_scene_commit(context, scene) : result;
}

static dm_result grab_all(dm_context* context, dm_object object, dm_drag drags[COUNT]) {
    dm_result result = DM_OK;
    for (int i = 0; i < COUNT && result == DM_OK; i++) {
        const int drawer = i % 2;
        const dm_drag_desc grab = {.struct_size = sizeof grab,
                                   .object = object,
                                   .part_id = drawer ? CABINET_DRAWER : CABINET_DOOR,
                                   .grab_point = {drawer ? 0.3f : 0.55f, drawer ? 0.88f : 0.45f, 0.45f}};
        result = dm_drag_begin(context, &grab, &drags[i]);
    }
    return result;
}

/* One frame: every hand moves its part, the scene learns of it, one ray is picked. Rays are in each object's frame. */
static dm_result play_frame(dm_context* context, dm_scene scene, const uint32_t instances[COUNT],
                            const dm_drag drags[COUNT], int frame) {
    dm_result result = DM_OK;
    dm_hit hit = {.struct_size = sizeof hit};
    const dm_ray look = {{3, 1.5f, 4}, {-0.2f, -0.3f, -1}};
    for (int i = 0; i < COUNT && result == DM_OK; i++) {
        const dm_ray hand = {{0.5f - 0.004f * (float)frame, 2.0f, 1.0f + 0.002f * (float)frame}, {0, -1.5f, -0.6f}};
        dm_drag_state state = {.struct_size = sizeof state};
        result = dm_drag_update(context, drags[i], &hand, 1.0f / 60, &state);
        if (result == DM_OK)
            result = dm_scene_move(context, scene, instances[i], i % 2 ? CABINET_DRAWER : CABINET_DOOR, &state.pose);
    }
    if (result == DM_OK) result = dm_scene_commit(context, scene);
    return result == DM_OK ? dm_scene_pick(context, scene, &look, &hit) : result;
}

int main(int argc, char** argv) {
    static cabinet shape;
    static uint32_t instances[COUNT];
    static dm_drag drags[COUNT];
    const dm_context_desc host = {.struct_size = sizeof host, .log = {NULL, print_message}};
    const dm_scene_desc empty = {.struct_size = sizeof empty};
    dm_context* context;
    dm_model model;
    dm_object object;
    dm_scene scene;
    if (dm_context_create(&host, &context) != DM_OK) return 1;
    if (load_weights(context, argc > 1 ? argv[1] : "sdk/models", &model) != DM_OK) return 1;
    const dm_mesh_desc mesh = cabinet_make(&shape);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = model};
    if (dm_object_prepare(context, &desc, &object) != DM_OK) return 1;
    if (dm_scene_create(context, &empty, &scene) != DM_OK) return 1;
    if (place_all(context, scene, object, instances) != DM_OK || grab_all(context, object, drags) != DM_OK) return 1;

    double worst = 0;
    const double start = now_us();
    for (int frame = 0; frame < FRAMES; frame++) {
        const double begun = now_us();
        if (play_frame(context, scene, instances, drags, frame) != DM_OK) return 1;
        worst = now_us() - begun > worst ? now_us() - begun : worst;
    }
    const double mean = (now_us() - start) / FRAMES;
    dm_memory_info memory = {.struct_size = sizeof memory};
    dm_context_get_memory(context, &memory);
    printf(
        "%d cabinets, each with a part in someone's hand: %.0f us a frame, worst %.0f; %.1f KiB + %.1f KiB to pick\n",
        COUNT, mean, worst, (double)memory.bytes / 1024, (double)memory.pick_bytes / 1024);
    dm_context_destroy(context);
    return 0;
}
