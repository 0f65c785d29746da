/* Trees that are stored as shapes: what is restored is what was built, to the bits, and no shape, whatever it says,
 * makes a tree that reads elsewhere, loops, or lacks a triangle. */
#include "test_env.h"

#include <math.h>

#include "base/random.h"
#include "pick/wide_tree.h"

enum { FACES = 700, VERTICES = 900, RAYS = 300, CHANGES = 4000 };

typedef struct soup {
    float positions[VERTICES + 2][3]; /* with padding */
    uint32_t corners[FACES][3];
    uint16_t narrow[FACES][3];
} soup;

static soup make_soup(dmi_random* random) {
    static soup s;
    memset(&s, 0, sizeof s);
    for (int v = 0; v < VERTICES; v++)
        for (int k = 0; k < 3; k++) s.positions[v][k] = dmi_random_unit(random) - 0.5f;
    for (uint32_t f = 0; f < FACES; f++) {
        const uint32_t first = f; /* no two are the same: which of them is hit would hang on the order */
        for (uint32_t i = 0; i < 3; i++) s.narrow[f][i] = (uint16_t)(s.corners[f][i] = first + i);
        /* small, but for some */
        for (int i = 1; i < 3 && f % 10 != 0; i++)
            for (int k = 0; k < 3; k++) {
                float* p = &s.positions[first + (uint32_t)i][k];
                *p = s.positions[first][k] + 0.1f * *p;
            }
    }
    return s;
}

static dmi_triangles triangles_of(const soup* s, uint32_t faces, bool narrow) {
    return (dmi_triangles){.positions = &s->positions[0][0],
                           .narrow = narrow ? &s->narrow[0][0] : NULL,
                           .wide = narrow ? NULL : &s->corners[0][0],
                           .vertex_count = VERTICES,
                           .face_count = faces};
}

/* A shape as a file has it. */
typedef struct stored {
    dmi_tree_shape shape;
    uint32_t child[FACES][DMI_WIDE], face[FACES][DMI_BLOCK];
} stored;

static void store(const dmi_wide_tree* tree, stored* out) {
    const dmi_tree_shape from = dmi_wide_tree_shape(tree);
    assert_in_range(from.node_count, 1, FACES);
    assert_in_range(from.block_count, 1, FACES);
    for (uint32_t n = 0; n < from.node_count; n++)
        memcpy(out->child[n], from.child + n * from.child_step, sizeof out->child[n]);
    for (uint32_t n = 0; n < from.block_count; n++)
        memcpy(out->face[n], from.face + n * from.face_step, sizeof out->face[n]);
    out->shape =
        (dmi_tree_shape){&out->child[0][0], &out->face[0][0], DMI_WIDE, DMI_BLOCK, from.node_count, from.block_count};
}

static void what_is_restored_is_what_was_built(void** state) {
    (void)state;
    static stored file;
    dmi_random random = dmi_random_make(3, 1);
    const soup s = make_soup(&random);
    for (uint32_t faces = 1; faces <= FACES; faces += 1 + faces / 2) {
        test_env t;
        dmi_wide_tree built, restored;
        test_env_open(&t, TEST_NEVER);
        const dmi_triangles wide = triangles_of(&s, faces, false), narrow = triangles_of(&s, faces, true);
        assert_int_equal(dmi_wide_tree_build(&t.env, &wide, &built), DM_OK);
        store(&built, &file);
        assert_int_equal(dmi_wide_tree_restore(&t.env, &narrow, &file.shape, &restored), DM_OK);
        assert_memory_equal(restored.nodes, built.nodes, built.node_count * sizeof *built.nodes);
        assert_memory_equal(restored.blocks, built.blocks, built.block_count * sizeof *built.blocks);
        dmi_wide_tree_release(&t.env, &restored);
        dmi_wide_tree_release(&t.env, &built);
        test_env_close(&t);
    }
}

/* ---- forged shapes ---- */

static dmi_part_ray random_ray(dmi_random* random) {
    dmi_part_ray ray = {.far = INFINITY};
    for (int k = 0; k < 3; k++) {
        ray.origin[k] = 3 * dmi_random_unit(random) - 1.5f;
        ray.direction[k] = dmi_random_unit(random) - 0.5f - ray.origin[k];
    }
    return ray;
}

/* A tree that was not refused has all triangles: it hits what the built one hits, at the same place. */
static void expect_same_hits(const dmi_wide_tree* forged, const dmi_wide_tree* built, int rays) {
    dmi_random random = dmi_random_make(5, 5);
    for (int i = 0; i < rays; i++) {
        const dmi_part_ray ray = random_ray(&random);
        dmi_part_hit wanted = {0}, found = {0};
        assert_int_equal(dmi_wide_trace_plain(forged, &ray, &found), dmi_wide_trace_plain(built, &ray, &wanted));
        assert_memory_equal(&found, &wanted, sizeof found);
    }
}

typedef struct forgery {
    test_env t;
    dmi_triangles triangles;
    dmi_wide_tree built;
    stored file;
    int refused, harmless;
} forgery;

static void open_forgery(forgery* f, const soup* s) {
    memset(f, 0, sizeof *f);
    test_env_open(&f->t, TEST_NEVER);
    f->triangles = triangles_of(s, FACES, true);
    assert_int_equal(dmi_wide_tree_build(&f->t.env, &f->triangles, &f->built), DM_OK);
    store(&f->built, &f->file);
}

static void try_forgery(forgery* f, int rays) {
    dmi_wide_tree tree;
    const dm_result result = dmi_wide_tree_restore(&f->t.env, &f->triangles, &f->file.shape, &tree);
    if (result == DM_ERROR_BAD_DATA) {
        f->refused++;
        return;
    }
    assert_int_equal(result, DM_OK);
    f->harmless++;
    expect_same_hits(&tree, &f->built, rays);
    dmi_wide_tree_release(&f->t.env, &tree);
}

static void close_forgery(forgery* f) {
    dmi_wide_tree_release(&f->t.env, &f->built);
    test_env_close(&f->t);
}

/* Every number of the shape, every bit of it, and the numbers that lie nearest to it or at the ends. */
static void every_flip_is_refused_or_harmless(void** state) {
    (void)state;
    static forgery f;
    dmi_random random = dmi_random_make(3, 2);
    const soup s = make_soup(&random);
    open_forgery(&f, &s);
    uint32_t* const arrays[] = {&f.file.child[0][0], &f.file.face[0][0], &f.file.shape.node_count,
                                &f.file.shape.block_count};
    const uint32_t counts[] = {f.file.shape.node_count * DMI_WIDE, f.file.shape.block_count * DMI_BLOCK, 1, 1};
    for (int a = 0; a < 4; a++) {
        for (uint32_t i = 0; i < counts[a]; i++) {
            uint32_t* at = arrays[a] + i;
            const uint32_t was = *at;
            const uint32_t others[] = {0,
                                       was - 1,
                                       was + 1,
                                       DMI_LEAF,
                                       UINT32_MAX,
                                       FACES,
                                       DMI_LEAF | FACES,
                                       was * 2u,
                                       was ^ (i & 0xffu),
                                       DMI_LEAF | (was + 1u),
                                       FACES - 1u,
                                       1};
            for (int bit = 0; bit < 32; bit++) *at = was ^ 1u << bit, try_forgery(&f, 1);
            for (size_t k = 0; k < sizeof others / sizeof *others; k++) *at = others[k], try_forgery(&f, 1);
            *at = was;
        }
    }
    try_forgery(&f, RAYS);
    assert_true(f.refused > 10000 && f.harmless > 10);
    close_forgery(&f);
}

/* Several numbers at once, also moved from place to place: what single changes can't reach. */
static void many_changes_are_refused_or_harmless(void** state) {
    (void)state;
    static forgery f;
    static stored whole;
    dmi_random random = dmi_random_make(3, 3);
    const soup s = make_soup(&random);
    open_forgery(&f, &s);
    whole = f.file;
    const uint32_t nodes = f.file.shape.node_count, blocks = f.file.shape.block_count;
    for (int i = 0; i < CHANGES; i++) {
        for (uint32_t n = dmi_random_u32(&random) % 4 + 1; n > 0; n--) {
            uint32_t *a = &f.file.child[dmi_random_u32(&random) % nodes][dmi_random_u32(&random) % DMI_WIDE],
                     *b = &f.file.child[dmi_random_u32(&random) % nodes][dmi_random_u32(&random) % DMI_WIDE];
            if (n % 2) a = &f.file.face[dmi_random_u32(&random) % blocks][dmi_random_u32(&random) % DMI_BLOCK];
            if (n % 2) b = &f.file.face[dmi_random_u32(&random) % blocks][dmi_random_u32(&random) % DMI_BLOCK];
            const uint32_t was = *a;
            *a = *b;
            if (i % 3 != 0) *b = was;
        }
        try_forgery(&f, 20);
        f.file = whole;
        f.file.shape.child = &f.file.child[0][0], f.file.shape.face = &f.file.face[0][0];
    }
    assert_true(f.refused > CHANGES / 4 && f.harmless > CHANGES / 50);
    close_forgery(&f);
}

/* A list of nodes as long as can be: no deeper than the stack of a ray. */
static void a_tree_too_deep_is_refused(void** state) {
    (void)state;
    static forgery f;
    dmi_random random = dmi_random_make(3, 4);
    const soup s = make_soup(&random);
    for (uint32_t levels = DMI_MOST_LEVELS - 2; levels < DMI_MOST_LEVELS + 3; levels++) {
        open_forgery(&f, &s);
        memset(f.file.child, 0, sizeof f.file.child);
        const uint32_t blocks = FACES / DMI_BLOCK;
        uint32_t next = 0;
        for (uint32_t n = 0; n < levels; n++) {
            const bool last = n + 1 == levels;
            const uint32_t left = blocks - next, most = last ? left : left > DMI_WIDE ? left - DMI_WIDE : 0;
            for (uint32_t i = 0; i < most && (last || i < DMI_WIDE / 2); i++) f.file.child[n][i] = DMI_LEAF | next++;
            if (!last) f.file.child[n][DMI_WIDE - 1] = n + 1;
        }
        for (uint32_t i = 0; i < FACES; i++) f.file.face[i / DMI_BLOCK][i % DMI_BLOCK] = i;
        f.file.shape.node_count = levels, f.file.shape.block_count = blocks;
        assert_int_equal(next, blocks);
        try_forgery(&f, RAYS);
        assert_int_equal(f.harmless, levels <= DMI_MOST_LEVELS);
        close_forgery(&f);
    }
}

static void any_allocation_may_fail(void** state) {
    (void)state;
    static stored file;
    dmi_random random = dmi_random_make(3, 5);
    const soup s = make_soup(&random);
    const dmi_triangles triangles = triangles_of(&s, FACES, true);
    dm_result result = DM_ERROR_OUT_OF_MEMORY;
    for (int64_t fail_at = 0; result == DM_ERROR_OUT_OF_MEMORY; fail_at++) {
        test_env t;
        dmi_wide_tree built, tree;
        test_env_open(&t, TEST_NEVER);
        assert_int_equal(dmi_wide_tree_build(&t.env, &triangles, &built), DM_OK);
        store(&built, &file);
        dmi_wide_tree_release(&t.env, &built);
        t.memory.calls = 0;
        t.memory.fail_at = fail_at;
        result = dmi_wide_tree_restore(&t.env, &triangles, &file.shape, &tree);
        if (result == DM_OK) dmi_wide_tree_release(&t.env, &tree);
        test_env_close(&t);
    }
    assert_int_equal(result, DM_OK);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_restored_is_what_was_built),
        cmocka_unit_test(every_flip_is_refused_or_harmless),
        cmocka_unit_test(many_changes_are_refused_or_harmless),
        cmocka_unit_test(a_tree_too_deep_is_refused),
        cmocka_unit_test(any_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
