/* What engines do to a process: floating-point environments of their own, locales, small stacks, many contexts.
 * Everything that the library does is done once for each (live), and gives the same bits. */
#include <fenv.h>
#include <locale.h>
#include <math.h>

#include "test_hash.h"
#include "test_world.h"

#if defined(__SSE__)
#include <immintrin.h>
#endif

typedef struct life {
    test_world* world;
    uint64_t hash; /* of all answers */
} life;

static void hash(life* l, const void* data, size_t size) {
    l->hash = test_hash_bytes(l->hash, data, size);
}

static dm_object prepare(test_world* w, dm_context* context) {
    const dm_mesh_desc mesh = test_shape_desc(&w->shape);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = w->model};
    dm_object object = 0;
    assert_int_equal(dm_object_prepare(context, &desc, &object), DM_OK);
    return object;
}

static void pick_and_drag(life* l, dm_context* context, dm_object object) {
    const dm_scene_desc scene_desc = {.struct_size = sizeof scene_desc};
    const dm_drag_desc drag_desc = {
        .struct_size = sizeof drag_desc, .object = object, .part_id = TEST_DOOR, .grab_point = test_pull().point};
    dm_scene scene;
    dm_drag drag;
    uint32_t instance;
    dm_hit hit = {.struct_size = sizeof hit};
    const dm_ray at = {{0.31f, 0.42f, 5}, {0.001f, 0, -1}};
    assert_int_equal(dm_scene_create(context, &scene_desc, &scene), DM_OK);
    assert_int_equal(dm_scene_add(context, scene, object, NULL, &instance), DM_OK);
    assert_int_equal(dm_scene_commit(context, scene), DM_OK);
    assert_int_equal(dm_scene_pick(context, scene, &at, &hit), DM_OK);
    hash(l, &hit.point, sizeof hit.point);
    assert_int_equal(dm_drag_begin(context, &drag_desc, &drag), DM_OK);
    for (int frame = 0; frame < 40; frame++) {
        dm_drag_state state = {.struct_size = sizeof state};
        /* Exact in every rounding. */
        const dm_ray ray = {{0.5f, 0.5f, 5}, {0.40625f - (float)frame / 64, (float)frame / 256, -4}};
        assert_int_equal(dm_drag_update(context, drag, &ray, 1.0f / 60, &state), DM_OK);
        hash(l, &state.pose, sizeof state.pose);
    }
    assert_int_equal(dm_drag_end(context, drag, NULL), DM_OK);
    assert_int_equal(dm_scene_destroy(context, scene), DM_OK);
}

static void save_and_load(life* l, dm_context* context, dm_object object) {
    size_t size = 0;
    assert_int_equal(dm_object_save(context, object, NULL, 0, &size), DM_OK);
    void* bytes = malloc(size);
    assert_int_equal(dm_object_save(context, object, bytes, size, &size), DM_OK);
    hash(l, bytes, size);
    dm_object loaded = 0;
    assert_int_equal(dm_object_load(context, bytes, size, l->world->model, &loaded), DM_OK);
    assert_int_equal(dm_object_destroy(context, loaded), DM_OK);
    free(bytes);
}

static void generate(life* l, dm_context* context, dm_object object) {
    const dm_drag_hint pull = test_pull();
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR, .drag = pull};
    dm_motion motion;
    dm_pose pose;
    float value;
    assert_int_equal(dm_motion_generate(context, object, &desc, &motion), DM_OK);
    assert_int_equal(dm_motion_sample(context, motion, 0.7f, &pose, &value), DM_OK);
    hash(l, &pose, sizeof pose);
    assert_int_equal(dm_object_refine(context, object, TEST_DOOR, &pull), DM_OK);
    dm_joint joint = {.struct_size = sizeof joint};
    assert_int_equal(dm_object_get_joint(context, object, TEST_DOOR, &joint), DM_OK);
    hash(l, &joint, sizeof joint);
}

static void find_part(life* l, dm_context* context) {
    static uint8_t ids[sizeof l->world->shape.part];
    const dm_drag_hint pull = test_pull();
    dm_mesh_desc mesh = test_shape_desc(&l->world->shape);
    const uint64_t faces = mesh.index_count / 3;
    mesh.part_ids = NULL, mesh.part_id_bytes = 0;
    assert_int_equal(dm_mesh_find_part(context, &mesh, &pull, ids, faces), DM_OK);
    hash(l, ids, faces);
}

static void live(life* l) {
    test_world* w = l->world;
    l->hash = TEST_HASH_START;
    test_world_open(w);
    w->model = test_load_model(w->context);
    const dm_object object = prepare(w, w->context);
    save_and_load(l, w->context, object);
    pick_and_drag(l, w->context, object);
    generate(l, w->context, object);
    find_part(l, w->context);
    test_world_close(w);
}

static uint64_t usual_life(test_world* w) {
    life l = {.world = w};
    test_world_init(w);
    live(&l);
    return l.hash;
}

#if defined(__SSE__)

enum { FLUSH_TO_ZERO = 0x8000, DENORMALS_ARE_ZERO = 0x0040, STATUS = 0x3f };

static void lives_alike_with(uint32_t control) {
    test_world w;
    const uint64_t usual = usual_life(&w);
    life l = {.world = &w};
    const uint32_t before = _mm_getcsr();
    _mm_setcsr(control);
    live(&l);
    const uint32_t after = _mm_getcsr();
    _mm_setcsr(before);
    assert_true(l.hash == usual);
    assert_int_equal(after & ~STATUS, control & ~STATUS);
}

static void test_flushed_denormals(void** state) {
    (void)state;
    lives_alike_with(_mm_getcsr() | FLUSH_TO_ZERO | DENORMALS_ARE_ZERO);
}

static void test_other_roundings(void** state) {
    (void)state;
    static const uint32_t modes[] = {_MM_ROUND_DOWN, _MM_ROUND_UP, _MM_ROUND_TOWARD_ZERO};
    for (int i = 0; i < 3; i++) lives_alike_with((_mm_getcsr() & ~(uint32_t)_MM_ROUND_MASK) | modes[i]);
}

/* Each traps at once: SIGFPE would end this program. */
static void test_trapped_exceptions(void** state) {
    (void)state;
    const uint32_t trapped =
        _MM_MASK_INVALID | _MM_MASK_DIV_ZERO | _MM_MASK_OVERFLOW | _MM_MASK_UNDERFLOW | _MM_MASK_DENORM;
    lives_alike_with(_mm_getcsr() & ~trapped & ~(uint32_t)STATUS);
}

#endif

static int32_t DM_CALL on_workers_that_trap(void* user, uint32_t count, dm_task task, void* data) {
    (void)user;
#if defined(__SSE__)
    const uint32_t before = _mm_getcsr();
    _mm_setcsr((before | _MM_ROUND_UP) & ~(uint32_t)(_MM_MASK_INVALID | _MM_MASK_DIV_ZERO | STATUS));
#endif
    for (uint32_t i = 0; i < count; i++) task(data, i);
#if defined(__SSE__)
    _mm_setcsr(before);
#endif
    return 1;
}

static void test_workers(void** state) {
    (void)state;
    test_world w;
    const uint64_t usual = usual_life(&w);
    life l = {.world = &w};
    w.desc.jobs.parallel_for = on_workers_that_trap;
    live(&l);
    assert_true(l.hash == usual);
}

#if defined(__linux__)
/* Weights and .dmo files are read by their bytes; numbers in messages and JSON have a point everywhere. */
static void test_decimal_comma(void** state) {
    (void)state;
    test_world w;
    const uint64_t usual = usual_life(&w);
    life l = {.world = &w};
    /* Most machines have no such locale made; Debian's package "locales" has what it is made of. */
    if (system("mkdir -p build/locale && localedef -i de_DE -f UTF-8 build/locale/de_DE.UTF-8") != 0) skip();
    setenv("LOCPATH", "build/locale", 1);
    assert_non_null(setlocale(LC_ALL, "de_DE.UTF-8"));
    assert_string_equal(localeconv()->decimal_point, ",");
    live(&l);
    setlocale(LC_ALL, "C");
    assert_true(l.hash == usual);
}

#endif

enum { MANY_CONTEXTS = 1100 }; /* more than glibc has thread-specific keys, of which Embree takes one a device */

static void test_more_contexts_than_keys(void** state) {
    (void)state;
    static dm_context* contexts[MANY_CONTEXTS];
    test_world w;
    test_world_init(&w);
    for (int i = 0; i < MANY_CONTEXTS; i++) assert_int_equal(dm_context_create(&w.desc, &contexts[i]), DM_OK);
    life l = {.world = &w, .hash = TEST_HASH_START};
    for (int i = 0; i < MANY_CONTEXTS; i += MANY_CONTEXTS / 8) {
        const dm_object object = prepare(&w, contexts[i]);
        pick_and_drag(&l, contexts[i], object);
    }
    for (int i = 0; i < MANY_CONTEXTS; i++) dm_context_destroy(contexts[i]);
    assert_int_equal(w.memory.live_bytes, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_more_contexts_than_keys), /* first: TBB takes keys when it first builds */
#if defined(__SSE__)
        cmocka_unit_test(test_flushed_denormals),
        cmocka_unit_test(test_other_roundings),
        cmocka_unit_test(test_trapped_exceptions),
#endif
        cmocka_unit_test(test_workers),
#if defined(__linux__)
        cmocka_unit_test(test_decimal_comma),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
