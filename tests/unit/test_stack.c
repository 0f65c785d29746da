/* How much stack tasks and calls take, by painted stacks; the header promises TASK_PROMISE and CALL_PROMISE. Release
 * builds for Linux alone: debuggers and sanitizers make frames larger. */
#if defined(__linux__) && defined(NDEBUG)
#include <sys/mman.h>
#include <ucontext.h>
#endif

#include "test_world.h"

#if defined(__linux__) && defined(NDEBUG)

enum { KB = 1024, TASK_PROMISE = 64 * KB, CALL_PROMISE = 128 * KB, GUARD = 64 * KB, ROOM = 1024 * KB, PAINT = 0xA5 };

/* A fibre: a stack of its own over a guard that no access survives. */
typedef struct fibre {
    unsigned char* stack;
    size_t most; /* bytes used so far, of all runs */
    ucontext_t caller, own;
    void (*run)(void* data);
    void* data;
} fibre;

static fibre* current; /* makecontext hands on nothing but ints */

static void enter(void) {
    current->run(current->data);
}

static void fibre_open(fibre* f) {
    unsigned char* memory =
        mmap(NULL, GUARD + ROOM, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    assert_true(memory != MAP_FAILED);
    assert_int_equal(mprotect(memory, GUARD, PROT_NONE), 0);
    *f = (fibre){.stack = memory + GUARD};
}

static void fibre_close(fibre* f) {
    munmap(f->stack - GUARD, GUARD + ROOM);
}

/* Runs on the fibre's stack of so many bytes. */
static void fibre_run(fibre* f, size_t size, void (*run)(void* data), void* data) {
    fibre* const before = current;
    unsigned char* bottom = f->stack + ROOM - size;
    memset(bottom, PAINT, size);
    mprotect(f->stack, ROOM - size, PROT_NONE);
    f->run = run, f->data = data, current = f;
    getcontext(&f->own);
    f->own.uc_stack.ss_sp = bottom, f->own.uc_stack.ss_size = size, f->own.uc_link = &f->caller;
    makecontext(&f->own, enter, 0);
    swapcontext(&f->caller, &f->own);
    current = before;
    mprotect(f->stack, ROOM - size, PROT_READ | PROT_WRITE);
    size_t untouched = 0;
    while (untouched < size && bottom[untouched] == PAINT) untouched++;
    if (size - untouched > f->most) f->most = size - untouched;
}

typedef struct one_task {
    dm_task task;
    void* data;
    uint32_t index;
} one_task;

static void run_task(void* data) {
    const one_task* one = data;
    one->task(one->data, one->index);
}

static int32_t DM_CALL on_fibres(void* user, uint32_t count, dm_task task, void* data) {
    for (uint32_t i = 0; i < count; i++) {
        one_task one = {task, data, i};
        fibre_run(user, TASK_PROMISE, run_task, &one);
    }
    return 1;
}

/* The cabinet with a door of GRID x GRID quads, the upper half of them a part of its own: two tasks. */
enum { GRID = 150, VERTICES = (GRID + 1) * (GRID + 1) + TEST_SHAPE_MAX, FACES = 2 * GRID * GRID + TEST_SHAPE_MAX };

typedef struct fine {
    float xyz[VERTICES][3];
    uint32_t corners[FACES][3];
    uint8_t part[FACES];
    uint32_t vertices, faces;
} fine;

static void make_fine(const test_shape* shape, fine* out) {
    const dm_mesh_desc coarse = test_shape_desc(shape);
    out->vertices = (uint32_t)coarse.vertex_count, out->faces = (uint32_t)(coarse.index_count / 3);
    memcpy(out->xyz, shape->xyz, out->vertices * sizeof out->xyz[0]);
    memcpy(out->corners, shape->corners, out->faces * sizeof out->corners[0]);
    memcpy(out->part, shape->part, out->faces);
    const uint32_t first = out->vertices;
    for (uint32_t y = 0; y <= GRID; y++)
        for (uint32_t x = 0; x <= GRID; x++) {
            const float at[3] = {(float)x / GRID, (float)y / GRID, 1.035f + 0.0001f * (float)((x * 7 + y * 13) % 11)};
            memcpy(out->xyz[out->vertices++], at, sizeof at);
        }
    for (uint32_t i = 0; i < GRID * GRID; i++) {
        const uint32_t at = first + i / GRID * (GRID + 1) + i % GRID;
        const uint32_t quad[2][3] = {{at, at + 1, at + GRID + 2}, {at, at + GRID + 2, at + GRID + 1}};
        memset(out->part + out->faces, i < GRID * GRID / 2 ? TEST_DOOR : TEST_HANDLE, 2);
        memcpy(out->corners[out->faces], quad, sizeof quad);
        out->faces += 2;
    }
}

/* What the calls work on; each call below uses what those before it have made. */
typedef struct stage {
    test_world world;
    fine mesh;
    dm_object object, loaded;
    dm_scene scene;
    uint32_t instance;
    dm_drag drag;
    dm_motion motion;
    uint8_t ids[FACES];
    uint8_t saved[4 << 20];
    dm_result result;
} stage;

static dm_mesh_desc mesh_of(const stage* s) {
    return (dm_mesh_desc){.struct_size = sizeof(dm_mesh_desc),
                          .positions = s->mesh.xyz,
                          .vertex_count = s->mesh.vertices,
                          .indices = s->mesh.corners,
                          .index_count = 3 * (uint64_t)s->mesh.faces,
                          .part_ids = s->mesh.part,
                          .part_id_bytes = s->mesh.faces,
                          .part_id_format = DM_UINT8,
                          .part_id_scope = DM_PER_FACE};
}

static void create(void* data) {
    stage* s = data;
    s->result = dm_context_create(&s->world.desc, &s->world.context);
}

static void prepare(void* data) {
    stage* s = data;
    const dm_mesh_desc mesh = mesh_of(s);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = s->world.model};
    s->result = dm_object_prepare(s->world.context, &desc, &s->object);
}

static void save_and_load(void* data) {
    stage* s = data;
    size_t size;
    s->result = dm_object_save(s->world.context, s->object, s->saved, sizeof s->saved, &size);
    if (s->result == DM_OK) s->result = dm_object_load(s->world.context, s->saved, size, s->world.model, &s->loaded);
}

static void add_and_commit(void* data) {
    stage* s = data;
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    s->result = dm_scene_create(s->world.context, &desc, &s->scene);
    if (s->result == DM_OK) s->result = dm_scene_add(s->world.context, s->scene, s->object, NULL, &s->instance);
    if (s->result == DM_OK) s->result = dm_scene_commit(s->world.context, s->scene);
}

static void pick(void* data) {
    stage* s = data;
    const dm_ray ray = {{0.3f, 0.4f, 5}, {0.001f, 0, -1}};
    dm_hit hit = {.struct_size = sizeof hit};
    s->result = dm_scene_pick(s->world.context, s->scene, &ray, &hit);
}

static void drag(void* data) {
    stage* s = data;
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .object = s->object, .part_id = TEST_DOOR, .grab_point = test_pull().point};
    dm_drag_state state = {.struct_size = sizeof state};
    s->result = dm_drag_begin(s->world.context, &desc, &s->drag);
    for (int frame = 0; frame < 60 && s->result == DM_OK; frame++) {
        const dm_ray ray = {{0.5f, 0.5f, 5}, {0.41f - 0.01f * (float)frame, 0, -4}};
        s->result = dm_drag_update(s->world.context, s->drag, &ray, 1.0f / 60, &state);
    }
    if (s->result == DM_OK) s->result = dm_drag_release(s->world.context, s->drag, NULL, NULL);
}

static void generate(void* data) {
    stage* s = data;
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR, .drag = test_pull()};
    s->result = dm_motion_generate(s->world.context, s->object, &desc, &s->motion);
}

static void refine(void* data) {
    stage* s = data;
    const dm_drag_hint hint = test_pull();
    s->result = dm_object_refine(s->world.context, s->object, TEST_DOOR, &hint);
}

static void find_part(void* data) {
    stage* s = data;
    const dm_drag_hint hint = test_pull();
    dm_mesh_desc mesh = mesh_of(s);
    mesh.part_ids = NULL, mesh.part_id_bytes = 0;
    s->result = dm_mesh_find_part(s->world.context, &mesh, &hint, s->ids, s->mesh.faces);
}

static void measure(stage* s, const char* name, void (*run)(void* data)) {
    fibre f;
    fibre_open(&f);
    fibre_run(&f, CALL_PROMISE, run, s);
    fibre_close(&f);
    print_message("%-28s %6.1f KB\n", name, (double)f.most / KB);
    assert_int_equal(s->result, DM_OK);
}

static void measure_all(int32_t picking) {
    static stage s;
    fibre tasks;
    memset(&s, 0, sizeof s);
    fibre_open(&tasks);
    test_world_init(&s.world);
    s.world.desc.jobs = (dm_jobs){&tasks, on_fibres};
    s.world.desc.picking = picking;
    make_fine(&s.world.shape, &s.mesh);
    measure(&s, "context_create", create);
    test_world_load_model(&s.world);
    measure(&s, "object_prepare", prepare);
    print_message("%-28s %6.1f KB\n", "its deepest task", (double)tasks.most / KB);
    measure(&s, "object_save, object_load", save_and_load);
    measure(&s, "scene_add, scene_commit", add_and_commit);
    measure(&s, "scene_pick", pick);
    measure(&s, "drags", drag);
    measure(&s, "motion_generate", generate);
    measure(&s, "object_refine", refine);
    measure(&s, "mesh_find_part", find_part);
    assert_true(tasks.most > 0 && tasks.most <= TASK_PROMISE);
    test_world_close(&s.world);
    fibre_close(&tasks);
}

static void test_with_code_of_our_own(void** state) {
    (void)state;
    measure_all(DM_PICK_PORTABLE);
}

static void test_with_what_picks_by_itself(void** state) {
    (void)state;
    measure_all(DM_PICK_AUTO);
}

#else

static void test_with_code_of_our_own(void** state) {
    (void)state;
    skip();
}

static void test_with_what_picks_by_itself(void** state) {
    (void)state;
    skip();
}

#endif

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_with_code_of_our_own),
        cmocka_unit_test(test_with_what_picks_by_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
