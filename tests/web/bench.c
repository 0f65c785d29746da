/* The native side of bench.mjs: bench MESH_FILE [FOLDER_OF_WEIGHTS]. Writes a cabinet of many triangles to MESH_FILE
 * for the other side to read, and prints "NAME MICROSECONDS" for the same calls. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "cabinet.h"
#include "weights.h"

enum { GRID = 16 }; /* squares along each side of a box's face */
enum { FACES = CABINET_BOXES * 6, VERTICES = FACES * (GRID + 1) * (GRID + 1), INDICES = FACES * GRID * GRID * 6 };
enum { PREPARES = 7, BATCHES = 30, BATCH = 1000 };
static float positions[VERTICES][3];
static uint32_t indices[INDICES];
static uint8_t parts[VERTICES];

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e6 + (double)t.tv_nsec * 1e-3;
}

static int by_value(const void* a, const void* b) {
    const double x = *(const double*)a, y = *(const double*)b;
    return (x > y) - (x < y);
}

static void print_median(const char* name, double* times, size_t count, double calls) {
    qsort(times, count, sizeof *times, by_value);
    printf("%s %.4f\n", name, times[count / 2] / calls);
}

static void must(dm_result result, const char* what) {
    if (result == DM_OK) return;
    fprintf(stderr, "bench: %s: %s\n", what, dm_result_string(result));
    exit(1);
}

/* Draws one face of a box as a grid: at its lower or upper end of `axis`. */
static void make_face(const float* box, int axis, int end, uint32_t face) {
    const int u = (axis + 1) % 3, w = (axis + 2) % 3;
    uint32_t vertex = face * (GRID + 1) * (GRID + 1), index = face * GRID * GRID * 6;
    for (uint32_t i = 0; i <= GRID; i++)
        for (uint32_t j = 0; j <= GRID; j++, vertex++) {
            positions[vertex][axis] = box[axis + 3 * end];
            positions[vertex][u] = box[u] + (box[u + 3] - box[u]) * (float)i / GRID;
            positions[vertex][w] = box[w] + (box[w + 3] - box[w]) * (float)j / GRID;
            parts[vertex] = box[6] == (float)CABINET_DOOR;
            if (i == GRID || j == GRID) continue;
            const uint32_t across = vertex + GRID + 1;
            const uint32_t square[6] = {vertex, across, across + 1, vertex, across + 1, vertex + 1};
            for (int k = 0; k < 6; k++) indices[index++] = square[end ? k : 5 - k];
        }
}

static void write_mesh(const char* path) {
    FILE* file = fopen(path, "wb");
    const uint32_t counts[2] = {VERTICES, INDICES};
    if (file == NULL || fwrite(counts, sizeof counts, 1, file) != 1 ||
        fwrite(positions, sizeof positions, 1, file) != 1 || fwrite(indices, sizeof indices, 1, file) != 1 ||
        fwrite(parts, sizeof parts, 1, file) != 1 || fclose(file) != 0) {
        fprintf(stderr, "bench: can't write %s\n", path);
        exit(1);
    }
}

static void time_drag(dm_context* context, dm_object object, uint32_t flags, const char* name) {
    static double times[BATCHES];
    dm_drag_desc desc = dm_drag_desc_default();
    dm_drag_state state = dm_drag_state_default();
    dm_drag drag;
    desc.object = object, desc.part_id = 1, desc.flags = flags, desc.grab_point = (dm_vec3){0.55f, 0.45f, 0.45f};
    must(dm_drag_begin(context, &desc, &drag), "begin");
    for (int b = 0; b < BATCHES; b++) {
        const double start = now();
        for (int i = 0; i < BATCH; i++) {
            const dm_ray ray = {{0.9f, 0.9f, 2.0f}, {-0.35f - 0.0005f * (float)i, -0.45f, -1.55f}};
            must(dm_drag_update(context, drag, &ray, 1.0f / 60, &state), "update");
        }
        times[b] = now() - start;
    }
    must(dm_drag_end(context, drag, NULL), "end");
    print_median(name, times, BATCHES, BATCH);
}

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    for (uint32_t face = 0; face < FACES; face++)
        make_face(cabinet_boxes[face / 6], (int)(face / 2 % 3), (int)(face % 2), face);
    write_mesh(argv[1]);
    dm_context* context;
    dm_model model;
    const dm_context_desc host = dm_context_desc_default();
    must(dm_context_create(&host, &context), "context");
    must(load_weights(context, argc > 2 ? argv[2] : "sdk/models", &model), "weights");
    const dm_mesh_desc mesh = {.struct_size = sizeof mesh,
                               .positions = positions,
                               .vertex_count = VERTICES,
                               .indices = indices,
                               .index_count = INDICES,
                               .part_ids = parts,
                               .part_id_bytes = sizeof parts,
                               .part_id_format = DM_UINT8};
    dm_object_desc desc = dm_object_desc_default();
    desc.mesh = &mesh, desc.model = model, desc.flags = DM_PREPARE_WITHOUT_PICKING;
    double times[PREPARES];
    dm_object object = 0;
    for (int i = 0; i < PREPARES; i++) {
        if (i > 0) must(dm_object_destroy(context, object), "destroy");
        const double start = now();
        must(dm_object_prepare(context, &desc, &object), "prepare");
        times[i] = now() - start;
    }
    print_median("prepare", times, PREPARES, 1);
    time_drag(context, object, DM_DRAG_KEEP_JOINT, "drag_update_joint_known");
    time_drag(context, object, 0, "drag_update_joint_open");
    dm_context_destroy(context);
    return 0;
}
