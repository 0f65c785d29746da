/* The cabinet, the clock, the median. */
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define DOOR 0.5f /* metres wide */
#define MOST_ROUNDS 100000

typedef struct box {
    float low[3], high[3];
    uint32_t part;
} box;

void* bench_alloc(size_t size) {
    void* memory = aligned_alloc(64, (size + 63) / 64 * 64);
    if (memory != NULL) return memory;
    fprintf(stderr, "bench: no memory for %zu bytes\n", size);
    exit(1);
}

/* Five panels of the body, then a door and its handle a part. */
static uint32_t make_boxes(uint32_t parts, box* out) {
    const float w = DOOR * (float)(parts ? parts : 1);
    const box body[] = {{{0, 0, -0.4f}, {w, 0.02f, 0}, 0},
                        {{0, 0.78f, -0.4f}, {w, 0.8f, 0}, 0},
                        {{0, 0.02f, -0.4f}, {0.02f, 0.78f, 0}, 0},
                        {{w - 0.02f, 0.02f, -0.4f}, {w, 0.78f, 0}, 0},
                        {{0.02f, 0.02f, -0.4f}, {w - 0.02f, 0.78f, -0.38f}, 0}};
    uint32_t count = 0;
    for (; count < sizeof body / sizeof *body; count++) out[count] = body[count];
    for (uint32_t p = 0; p < parts; p++) {
        const float x = DOOR * (float)p;
        out[count++] = (box){{x + 0.001f, 0, 0.002f}, {x + DOOR - 0.001f, 0.8f, 0.022f}, p + 1};
        out[count++] = (box){{x + 0.45f, 0.3f, 0.03f}, {x + 0.465f, 0.5f, 0.045f}, p + 1};
    }
    return count;
}

static void add_side(const box* from, int axis, int far, uint32_t grid, bench_mesh* mesh) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const uint32_t base = mesh->vertex_count, row = grid + 1;
    for (uint32_t j = 0; j < row; j++) {
        for (uint32_t i = 0; i < row; i++) {
            float* p = mesh->positions + 3 * (size_t)mesh->vertex_count++;
            p[axis] = far ? from->high[axis] : from->low[axis];
            p[u] = from->low[u] + (from->high[u] - from->low[u]) * (float)i / (float)grid;
            p[v] = from->low[v] + (from->high[v] - from->low[v]) * (float)j / (float)grid;
        }
    }
    for (uint32_t n = 0; n < grid * grid; n++) {
        const uint32_t a = base + n / grid * row + n % grid, b = a + 1, c = a + row, d = c + 1;
        const uint32_t corners[2][6] = {{a, c, b, b, c, d}, {a, b, c, c, b, d}};
        for (size_t k = 0; k < 6; k++) mesh->indices[3 * (size_t)mesh->face_count + k] = corners[far][k];
        mesh->part_ids[mesh->face_count++] = from->part;
        mesh->part_ids[mesh->face_count++] = from->part;
    }
}

bench_mesh bench_mesh_new(uint32_t triangles, uint32_t parts) {
    box* boxes = bench_alloc((5 + 2 * (size_t)parts) * sizeof *boxes);
    const uint32_t count = make_boxes(parts, boxes);
    const uint32_t grid = (uint32_t)ceil(sqrt((double)triangles / (12.0 * count)));
    const size_t row = (size_t)grid + 1, faces = (size_t)grid * grid * 12 * count;
    bench_mesh mesh = {.positions = bench_alloc(row * row * 6 * count * 3 * sizeof(float)),
                       .indices = bench_alloc(faces * 3 * sizeof(uint32_t)),
                       .part_ids = bench_alloc(faces * sizeof(uint32_t)),
                       .parts = parts};
    for (uint32_t i = 0; i < count; i++)
        for (int side = 0; side < 6; side++) add_side(&boxes[i], side / 2, side % 2, grid, &mesh);
    free(boxes);
    return mesh;
}

void bench_mesh_free(bench_mesh* mesh) {
    free(mesh->positions);
    free(mesh->indices);
    free(mesh->part_ids);
}

dm_mesh_desc bench_mesh_desc(const bench_mesh* mesh) {
    return (dm_mesh_desc){.struct_size = sizeof(dm_mesh_desc),
                          .positions = mesh->positions,
                          .vertex_count = mesh->vertex_count,
                          .indices = mesh->indices,
                          .index_count = 3 * (uint64_t)mesh->face_count,
                          .part_ids = mesh->part_ids,
                          .part_id_bytes = mesh->face_count * sizeof *mesh->part_ids,
                          .part_id_format = DM_UINT32,
                          .part_id_scope = DM_PER_FACE};
}

dm_drag_hint bench_mesh_drag(uint32_t part) {
    return (dm_drag_hint){{DOOR * (float)(part - 1) + 0.458f, 0.4f, 0.045f}, {0, 0, 0.1f}};
}

double bench_now_ns(void) {
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

static int by_value(const void* a, const void* b) {
    const double left = *(const double*)a, right = *(const double*)b;
    return left < right ? -1 : left > right;
}

/* Calls to a round, so that the clock's own cost (a microsecond) does not show; the second of two tries counts, since
 * the first finds cold caches. */
static uint32_t calls_a_round(void (*call)(void* user), void* user) {
    for (uint32_t calls = 1;; calls *= 4) {
        double taken = 0;
        for (int attempt = 0; attempt < 2; attempt++) {
            const double start = bench_now_ns();
            for (uint32_t i = 0; i < calls; i++) call(user);
            taken = bench_now_ns() - start;
        }
        if (taken > 100e3 || calls >= 1u << 20) return calls;
    }
}

double bench_median_ns(void (*call)(void* user), void* user, double ms, double* out_least) {
    const uint32_t calls = calls_a_round(call, user);
    double* rounds = bench_alloc(MOST_ROUNDS * sizeof *rounds);
    size_t count = 0;
    for (const double end = bench_now_ns() + 1e6 * ms; count < MOST_ROUNDS && (count < 3 || bench_now_ns() < end);) {
        const double start = bench_now_ns();
        for (uint32_t i = 0; i < calls; i++) call(user);
        rounds[count++] = (bench_now_ns() - start) / calls;
    }
    qsort(rounds, count, sizeof *rounds, by_value);
    const double median = rounds[count / 2];
    if (out_least != NULL) *out_least = rounds[0];
    free(rounds);
    return median;
}

void* bench_read(const char* path, size_t* out_size) {
    FILE* stream = fopen(path, "rb");
    long size = -1;
    if (stream != NULL && fseek(stream, 0, SEEK_END) == 0) size = ftell(stream);
    void* data = size >= 0 ? bench_alloc((size_t)size) : NULL;
    if (data == NULL || fseek(stream, 0, SEEK_SET) != 0 || fread(data, 1, (size_t)size, stream) != (size_t)size) {
        fprintf(stderr, "bench: can't read %s\n", path);
        exit(1);
    }
    fclose(stream);
    *out_size = (size_t)size;
    return data;
}
