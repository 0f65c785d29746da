/* The same shape gives the same joint in whatever order its faces come and wherever each begins. Which diagonal cuts a
 * flat quad may change an answer that is nearly a tie. */
#include <math.h>
#include <string.h>

#include "test_world.h"

#include "generator.h"

enum { OBJECTS = 16, MOST_TIES = 1, FIRST_SEED = 40, CORNERS = 3 };

#define SAME_COSINE 0.99999f /* of axes: 4.5 mrad apart */
#define FLAT 0.999999f       /* cosine between the normals of two faces of one flat quad */

typedef void rewriting(dmg_object* object);

static void swap_faces(dmg_object* o, uint32_t a, uint32_t b) {
    for (uint32_t k = 0; k < CORNERS; k++) {
        const uint32_t corner = o->indices[CORNERS * a + k];
        o->indices[CORNERS * a + k] = o->indices[CORNERS * b + k];
        o->indices[CORNERS * b + k] = corner;
    }
    const uint32_t part = o->face_part[a];
    o->face_part[a] = o->face_part[b], o->face_part[b] = part;
}

static void reverse(dmg_object* o) {
    for (uint32_t f = 0; f < o->face_count / 2; f++) swap_faces(o, f, o->face_count - 1 - f);
}

static void shuffle(dmg_object* o) {
    uint32_t random = 12345;
    for (uint32_t f = o->face_count - 1; f > 0; f--) {
        random = random * 1664525u + 1013904223u;
        swap_faces(o, f, (random >> 8) % (f + 1));
    }
}

static void turn_faces(dmg_object* o) {
    for (uint32_t f = 0; f < o->face_count; f++) {
        uint32_t* corner = o->indices + (size_t)CORNERS * f;
        const uint32_t first = corner[0];
        corner[0] = corner[1], corner[1] = corner[2], corner[2] = first;
    }
}

static void normal_of(const dmg_object* o, const uint32_t corner[3], float out[3]) {
    const float *a = o->positions + 3 * (size_t)corner[0], *b = o->positions + 3 * (size_t)corner[1],
                *c = o->positions + 3 * (size_t)corner[2];
    const float u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const float n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const float length = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int k = 0; k < 3; k++) out[k] = length > 0 ? n[k] / length : 0;
}

static float cosine(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Cuts a quad of two faces that follow each other, a b c and a c d, along its other diagonal if it is flat and convex.
 */
static void cut_quad(dmg_object* o, uint32_t f) {
    uint32_t *one = o->indices + (size_t)CORNERS * f, *two = one + CORNERS;
    if (o->face_part[f] != o->face_part[f + 1] || one[0] != two[0] || one[2] != two[1]) return;
    const uint32_t a = one[0], b = one[1], c = one[2], d = two[2];
    const uint32_t first[3] = {a, b, d}, second[3] = {b, c, d};
    float now[2][3], then[2][3];
    normal_of(o, one, now[0]), normal_of(o, two, now[1]), normal_of(o, first, then[0]), normal_of(o, second, then[1]);
    for (int i = 0; i < 2; i++)
        if (cosine(now[0], then[i]) < FLAT || cosine(now[0], now[1]) < FLAT) return;
    memcpy(one, first, sizeof first);
    memcpy(two, second, sizeof second);
}

static void cut_otherwise(dmg_object* o) {
    for (uint32_t f = 0; f + 1 < o->face_count; f++) cut_quad(o, f);
}

static dm_joint joint_of(const test_world* w, const dmg_object* o) {
    const dm_mesh_desc mesh = {.struct_size = sizeof mesh,
                               .positions = o->positions,
                               .vertex_count = o->vertex_count,
                               .indices = o->indices,
                               .index_count = (uint64_t)CORNERS * o->face_count,
                               .part_ids = o->face_part,
                               .part_id_bytes = o->face_count * sizeof *o->face_part,
                               .part_id_format = DM_UINT32,
                               .part_id_scope = DM_PER_FACE};
    const dm_part_desc part = {.struct_size = sizeof part, .id = 1};
    const dm_object_desc desc = {
        .struct_size = sizeof desc, .mesh = &mesh, .parts = &part, .part_count = 1, .model = w->model};
    dm_object object = 0;
    dm_joint joint = {.struct_size = sizeof joint};
    assert_int_equal(dm_object_prepare(w->context, &desc, &object), DM_OK);
    assert_int_equal(dm_object_get_joint(w->context, object, 1, &joint), DM_OK);
    dm_object_destroy(w->context, object);
    return joint;
}

static int same_joint(const dm_joint* a, const dm_joint* b) {
    const float dot = a->axis.x * b->axis.x + a->axis.y * b->axis.y + a->axis.z * b->axis.z;
    return a->type == b->type && fabsf(dot) > SAME_COSINE;
}

/* Counts the objects whose first part keeps its joint. */
static int count_same(rewriting* rewrite) {
    test_world w;
    test_world_init(&w);
    w.desc.picking = DM_PICK_NONE;
    test_world_open(&w);
    test_world_load_model(&w);
    int same = 0;
    for (uint32_t i = 0; i < OBJECTS; i++) {
        dmg_object object;
        const uint32_t category = i * dmg_category_count() / OBJECTS;
        assert_int_equal(dmg_make(category, FIRST_SEED + i, 0, &object), 0);
        const dm_joint before = joint_of(&w, &object);
        rewrite(&object);
        const dm_joint after = joint_of(&w, &object);
        same += same_joint(&before, &after);
        dmg_object_release(&object);
    }
    test_world_close(&w);
    return same;
}

static void the_order_of_faces_does_not_count(void** state) {
    (void)state;
    assert_true(count_same(reverse) >= OBJECTS - MOST_TIES);
    assert_true(count_same(shuffle) >= OBJECTS - MOST_TIES);
}

static void the_first_corner_of_a_face_does_not_count(void** state) {
    (void)state;
    assert_true(count_same(turn_faces) >= OBJECTS - MOST_TIES);
}

static void the_diagonal_of_a_flat_quad_does_not_count(void** state) {
    (void)state;
    assert_true(count_same(cut_otherwise) >= OBJECTS - MOST_TIES);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_order_of_faces_does_not_count),
        cmocka_unit_test(the_first_corner_of_a_face_does_not_count),
        cmocka_unit_test(the_diagonal_of_a_flat_quad_does_not_count),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
