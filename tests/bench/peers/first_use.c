/* What a host pays before the first frame, and what an object holds: first_use LIBRARY MODELS. Each call for the first
 * time in this process, and once more; bare Embree with the same triangles. One JSON object a line; built by run. */
#include <stdio.h>
#include <stdlib.h>

#include "../bare_embree.h"
#include "../support.h"
#include "dragmesh/dragmesh_loader.h"

#define TRIANGLES 100000 /* of the object that is weighed */
#define PROP 5000        /* of the one that is loaded and prepared */
#define TWICE 2

static const dm_core_1* dm;

static void must(dm_result result, const char* what) {
    if (result == DM_OK) return;
    fprintf(stderr, "first_use: %s: %s\n", what, dm->result_string(result));
    exit(1);
}

/* One line: the first time, and the second; ns. */
static void show(const char* who, const char* what, const double times[TWICE]) {
    printf("{\"who\": \"%s\", \"first\": \"%s\", \"first_ns\": %.0f, \"again_ns\": %.0f}\n", who, what, times[0],
           times[1]);
}

static double since(double start) {
    return bench_now_ns() - start;
}

/* ---- opening ---- */

static dm_context* open_context(int32_t picking) {
    dm_context_desc desc = dm_context_desc_default();
    dm_context* context;
    desc.picking = picking;
    must(dm->context_create(&desc, &context), "context_create");
    return context;
}

/* Leaves the library open. */
static void time_opening(dm_library* library, const char* path) {
    double opening[TWICE], contexts[TWICE];
    for (int i = 0; i < TWICE; i++) {
        double start = bench_now_ns();
        dm = dm_library_open(library, path);
        opening[i] = since(start);
        if (dm == NULL) {
            fprintf(stderr, "first_use: %s\n", library->error);
            exit(1);
        }
        start = bench_now_ns();
        dm_context* context = open_context(DM_PICK_PORTABLE);
        contexts[i] = since(start);
        dm->context_destroy(context);
        if (i + 1 < TWICE) dm_library_close(library);
    }
    show("dragmesh", "open the library", opening);
    show("dragmesh", "make a context", contexts);
}

static dm_model time_model(dm_context* context, const char* folder) {
    static const char* const names[3] = {"kpp_net", "dq_vae", "ranker"};
    void* data[3];
    size_t size[3];
    double times[TWICE];
    dm_model model = 0;
    for (int i = 0; i < 3; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s.safetensors", folder, names[i]);
        data[i] = bench_read(path, &size[i]);
    }
    dm_model_desc desc = dm_model_desc_default();
    desc.kinematics = data[0], desc.kinematics_size = size[0];
    desc.motion = data[1], desc.motion_size = size[1];
    desc.ranker = data[2], desc.ranker_size = size[2];
    for (int i = 0; i < TWICE; i++) {
        if (model != 0) must(dm->model_unload(context, model), "model_unload");
        const double start = bench_now_ns();
        must(dm->model_load(context, &desc, &model), "model_load");
        times[i] = since(start);
    }
    for (int i = 0; i < 3; i++) free(data[i]);
    show("dragmesh", "load the weights", times);
    return model;
}

/* ---- an object ---- */

static dm_object time_preparing(dm_context* context, dm_model model, const bench_mesh* mesh) {
    const dm_mesh_desc shape = bench_mesh_desc(mesh);
    dm_object_desc desc = dm_object_desc_default();
    double times[TWICE];
    dm_object object = 0;
    desc.mesh = &shape, desc.model = model, desc.seed = 1;
    for (int i = 0; i < TWICE; i++) {
        if (object != 0) must(dm->object_destroy(context, object), "object_destroy");
        const double start = bench_now_ns();
        must(dm->object_prepare(context, &desc, &object), "object_prepare");
        times[i] = since(start);
    }
    show("dragmesh", "prepare an object of 5,000 triangles", times);
    return object;
}

/* Takes the object from a file once more, as a game does. */
static dm_object time_loading(dm_context* context, dm_object object) {
    size_t size = 0;
    double times[TWICE];
    must(dm->object_save(context, object, NULL, 0, &size), "object_save");
    void* file = bench_alloc(size);
    must(dm->object_save(context, object, file, size, &size), "object_save");
    for (int i = 0; i < TWICE; i++) {
        must(dm->object_destroy(context, object), "object_destroy");
        const double start = bench_now_ns();
        must(dm->object_load(context, file, size, 0, &object), "object_load");
        times[i] = since(start);
    }
    free(file);
    show("dragmesh", "load it from a .dmo", times);
    return object;
}

static void time_a_frame(dm_context* context, dm_object object) {
    const dm_scene_desc scene_desc = dm_scene_desc_default();
    const dm_ray ray = {{0.25f, 0.4f, 2}, {0.01f, 0.02f, -1}};
    dm_drag_desc drag_desc = dm_drag_desc_default();
    double pick[TWICE], update[TWICE];
    uint32_t instance;
    dm_scene scene;
    dm_drag drag;
    must(dm->scene_create(context, &scene_desc, &scene), "scene_create");
    must(dm->scene_add(context, scene, object, NULL, &instance), "scene_add");
    must(dm->scene_commit(context, scene), "scene_commit");
    drag_desc.object = object, drag_desc.part_id = 1, drag_desc.grab_point = bench_mesh_drag(1).point;
    must(dm->drag_begin(context, &drag_desc, &drag), "drag_begin");
    for (int i = 0; i < TWICE; i++) {
        dm_hit hit = dm_hit_default();
        dm_drag_state state = dm_drag_state_default();
        double start = bench_now_ns();
        must(dm->scene_pick(context, scene, &ray, &hit), "scene_pick");
        pick[i] = since(start);
        start = bench_now_ns();
        must(dm->drag_update(context, drag, &ray, 1.0f / 60, &state), "drag_update");
        update[i] = since(start);
    }
    show("dragmesh", "pick a ray", pick);
    show("dragmesh", "update a drag", update);
}

/* ---- memory ---- */

/* Without what the context keeps for later calls, and without the model. */
static uint64_t held_by(dm_context* context) {
    dm_memory_info now = dm_memory_info_default();
    must(dm->context_get_memory(context, &now), "context_get_memory");
    return now.bytes + now.pick_bytes - now.kept_bytes;
}

static void weigh(const char* what, int32_t picking, const bench_mesh* mesh) {
    const dm_mesh_desc shape = bench_mesh_desc(mesh);
    dm_context* context = open_context(picking);
    dm_object_desc desc = dm_object_desc_default();
    dm_object object;
    desc.mesh = &shape;
    const uint64_t before = held_by(context);
    must(dm->object_prepare(context, &desc, &object), "object_prepare");
    printf("{\"who\": \"dragmesh\", \"memory\": \"%s\", \"bytes_a_triangle\": %.1f}\n", what,
           (double)(held_by(context) - before) / mesh->face_count);
    dm->context_destroy(context);
}

static bool count_bytes(void* user, ssize_t bytes, bool post) {
    (void)post;
    *(long long*)user += bytes;
    return true;
}

/* Embree's own copy of the triangles is in it, as ours is in ours. */
static void weigh_and_time_embree(const bench_mesh* mesh, const bench_mesh* prop) {
    static const float origin[3] = {0.25f, 0.4f, 2}, direction[3] = {0.01f, 0.02f, -1};
    double device_times[TWICE], build[TWICE], pick[TWICE];
    long long bytes = 0;
    for (int i = 0; i < TWICE; i++) {
        double start = bench_now_ns();
        RTCDevice device = rtcNewDevice("threads=1");
        device_times[i] = since(start);
        start = bench_now_ns();
        RTCScene scene = bare_embree_instances(device, prop, 1, NULL, RTC_SCENE_FLAG_ROBUST);
        build[i] = since(start);
        start = bench_now_ns();
        bare_embree_hits(scene, origin, direction);
        pick[i] = since(start);
        rtcReleaseScene(scene);
        if (i + 1 == TWICE) {
            rtcSetDeviceMemoryMonitorFunction(device, count_bytes, &bytes);
            scene = bare_embree_instances(device, mesh, 1, NULL, RTC_SCENE_FLAG_ROBUST);
            printf("{\"who\": \"embree\", \"memory\": \"bare\", \"bytes_a_triangle\": %.1f}\n",
                   (double)bytes / mesh->face_count);
            rtcReleaseScene(scene);
        }
        rtcReleaseDevice(device);
    }
    show("embree", "make a device", device_times);
    show("embree", "build the trees of 5,000 triangles", build);
    show("embree", "pick a ray", pick);
}

int main(int argc, char** argv) {
    dm_library library;
    if (argc < 3) return 2;
    time_opening(&library, argv[1]);
    dm_context* context = open_context(DM_PICK_PORTABLE);
    const dm_model model = time_model(context, argv[2]);
    bench_mesh mesh = bench_mesh_new(TRIANGLES, 1), prop = bench_mesh_new(PROP, 1);
    const dm_object prepared = time_preparing(context, model, &prop);
    time_a_frame(context, time_loading(context, prepared));
    dm->context_destroy(context);
    weigh("portable trees", DM_PICK_PORTABLE, &mesh);
    weigh("Embree's trees", DM_PICK_EMBREE, &mesh);
    weigh_and_time_embree(&mesh, &prop);
    dm_library_close(&library);
    bench_mesh_free(&mesh);
    bench_mesh_free(&prop);
    return 0;
}
