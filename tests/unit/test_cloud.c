/* Surface samples: every block where it belongs, even, seeded, in random order, whatever the mesh. */
#include "test_env.h"

#include <float.h>
#include <math.h>

#include "base/random.h"
#include "mesh/cloud.h"
#include "test_shapes.h"

enum { NEAR = DMI_CLOUD_PART, BODY = DMI_CLOUD_PART + DMI_CLOUD_NEAR };

static test_shape shape;
static dmi_cloud cloud, other;

static dmi_mesh* create(test_env* t, const dm_part_desc* parts, uint32_t count) {
    dmi_axes axes;
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    dm_mesh_desc desc = test_shape_desc(&shape);
    dmi_mesh* mesh = NULL;
    dm_result result = dmi_mesh_create(&t->env, &axes, &desc, parts, count, NULL, &mesh);
    if (result != DM_OK) print_error("%s\n", t->messages.text);
    assert_int_equal(result, DM_OK);
    return mesh;
}

static void sample(test_env* t, const dmi_mesh* mesh, uint32_t part, uint64_t seed, dmi_cloud* out) {
    memset(out, 0xff, sizeof *out); /* NaN: a point that is left out shows */
    assert_int_equal(dmi_cloud_sample(&t->env, mesh, part, seed, out), DM_OK);
}

/* On the surface of the box (of a part that is one). */
static int on_box(const dmi_part* box, const float p[3]) {
    float nearest = FLT_MAX;
    for (int k = 0; k < 3; k++) {
        if (p[k] < box->box_min[k] - 1e-6f || p[k] > box->box_max[k] + 1e-6f) return 0;
        nearest = fminf(nearest, fminf(fabsf(p[k] - box->box_min[k]), fabsf(p[k] - box->box_max[k])));
    }
    return nearest < 1e-6f;
}

static int in_box(const float low[3], const float high[3], float growth, const float p[3]) {
    for (int k = 0; k < 3; k++) {
        if (!(p[k] >= low[k] - growth - 1e-6f && p[k] <= high[k] + growth + 1e-6f)) return 0;
    }
    return 1;
}

static float near_growth(const float low[3], const float high[3]) {
    float square = 0;
    for (int k = 0; k < 3; k++) square += (high[k] - low[k]) * (high[k] - low[k]);
    return fmaxf(0.2f * sqrtf(square), 0.02f);
}

static void every_block_lies_where_it_belongs(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    test_shape_cabinet(&shape);
    dmi_mesh* mesh = create(&t, NULL, 0);
    const dmi_part *body = &mesh->parts[0], *door = &mesh->parts[1], *handle = &mesh->parts[2];
    sample(&t, mesh, 2, 1, &cloud); /* the thin handle: half of the points all the same */
    float growth = near_growth(handle->box_min, handle->box_max);
    for (int i = 0; i < DMI_CLOUD_POINTS; i++) {
        const float *p = cloud.xyz[i], *n = cloud.normal[i];
        assert_float_equal(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5);
        if (i < NEAR)
            assert_true(on_box(handle, p));
        else
            assert_true(on_box(body, p) || on_box(door, p));
        if (i >= NEAR && i < BODY) assert_true(in_box(handle->box_min, handle->box_max, growth, p));
    }
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

static void carried_parts_move_along(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    test_shape_cabinet(&shape);
    const dm_part_desc parts[] = {{.id = 1}, {.id = 2, .parent = 1}};
    dmi_mesh* mesh = create(&t, parts, 2);
    sample(&t, mesh, 1, 1, &cloud);
    int on_handle = 0;
    for (int i = 0; i < DMI_CLOUD_POINTS; i++) {
        int moving = on_box(&mesh->parts[1], cloud.xyz[i]) || on_box(&mesh->parts[2], cloud.xyz[i]);
        assert_int_equal(moving, i < NEAR);
        on_handle += moving && cloud.xyz[i][2] > mesh->parts[1].box_max[2] + 1e-6f;
    }
    float base = 0.02f * 0.2f / 4; /* of the handle, on the door */
    float share = (mesh->parts[2].area - base) / (mesh->parts[1].area + mesh->parts[2].area);
    assert_in_range(on_handle, (int)(share * DMI_CLOUD_PART) - 6, (int)(share * DMI_CLOUD_PART) + 7);
    sample(&t, mesh, 2, 1, &cloud); /* alone, it moves against the door too */
    for (int i = 0; i < NEAR; i++) assert_true(on_box(&mesh->parts[2], cloud.xyz[i]));
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

static void the_seed_decides_every_bit(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    test_shape_cabinet(&shape);
    dmi_mesh* mesh = create(&t, NULL, 0);
    sample(&t, mesh, 1, 42, &cloud);
    sample(&t, mesh, 1, 42, &other);
    assert_memory_equal(&cloud, &other, sizeof cloud);
    sample(&t, mesh, 1, 43, &other);
    int same = 0;
    for (int i = 0; i < DMI_CLOUD_POINTS; i++) same += memcmp(cloud.xyz[i], other.xyz[i], sizeof cloud.xyz[i]) == 0;
    assert_int_equal(same, 0);
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

/* Each face of a box gets its share to within a few points; inside a face the points are even: a chi-square over 4 x 4
 * cells. */
static void samples_are_even_over_a_box(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){1, 1, 1}, 0);
    test_shape_box(&shape, (const float[]){2, 0, 0}, (const float[]){6, 2, 1}, 1); /* areas 2, 4 and 8 */
    dmi_mesh* mesh = create(&t, NULL, 0);
    const dmi_part* box = &mesh->parts[1];
    int side_counts[3][2] = {{0}}, cells[16] = {0};
    enum { ROUNDS = 16 };
    for (uint64_t seed = 0; seed < ROUNDS; seed++) {
        sample(&t, mesh, 1, seed, &cloud);
        for (int i = 0; i < DMI_CLOUD_PART; i++) {
            const float* p = cloud.xyz[i];
            for (int k = 0; k < 3; k++) {
                if (fabsf(cloud.normal[i][k]) > 0.5f) side_counts[k][cloud.normal[i][k] > 0]++;
            }
            if (cloud.normal[i][2] < 0.5f) continue;
            float x = (p[0] - box->box_min[0]) / (box->box_max[0] - box->box_min[0]);
            float y = (p[1] - box->box_min[1]) / (box->box_max[1] - box->box_min[1]);
            cells[(int)fminf(4 * x, 3) + 4 * (int)fminf(4 * y, 3)]++;
        }
    }
    const int areas[3] = {2, 4, 8};
    for (int k = 0; k < 3; k++) {
        for (int side = 0; side < 2; side++) {
            int expected = ROUNDS * DMI_CLOUD_PART * areas[k] / 28;
            assert_in_range(side_counts[k][side], expected - 4 * ROUNDS, expected + 4 * ROUNDS);
        }
    }
    double chi = 0, expected = side_counts[2][1] / 16.0;
    for (int i = 0; i < 16; i++) chi += (cells[i] - expected) * (cells[i] - expected) / expected;
    assert_true(chi < 37.7); /* 15 degrees of freedom, p = 0.001 */
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

/* Any prefix of a block is a fair sample, as the networks take: not the faces one after the other. */
static void blocks_are_in_random_order(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    test_shape_cabinet(&shape);
    dmi_mesh* mesh = create(&t, NULL, 0);
    sample(&t, mesh, 1, 5, &cloud);
    static const int starts[] = {0, NEAR, BODY, DMI_CLOUD_POINTS};
    for (int block = 0; block < 3; block++) {
        double whole = 0, prefix = 0, spread = 0;
        int count = starts[block + 1] - starts[block], head = count / 4;
        for (int i = 0; i < count; i++) {
            double x = (double)cloud.xyz[starts[block] + i][0];
            whole += x / count;
            spread += x * x / count;
            if (i < head) prefix += x / head;
        }
        spread = sqrt(spread - whole * whole);
        assert_true(fabs(prefix - whole) < 4 * spread / sqrt(head));
        int longest = 0, run = 0; /* of one normal */
        for (int i = 1; i < count; i++) {
            const float *a = cloud.normal[starts[block] + i - 1], *b = cloud.normal[starts[block] + i];
            run = memcmp(a, b, sizeof cloud.normal[0]) == 0 ? run + 1 : 0;
            longest = run > longest ? run : longest;
        }
        assert_true(longest < 40);
    }
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

/* A small part in the middle of one huge quad: what is near is cut out of the quad exactly and filled evenly. */
static void near_samples_of_a_huge_face_fill_the_box(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){-1, -1, -0.1f}, (const float[]){1, 1, 0}, 0);
    test_shape_box(&shape, (const float[]){-0.02f, -0.02f, 0.001f}, (const float[]){0.02f, 0.02f, 0.021f}, 1);
    dmi_mesh* mesh = create(&t, NULL, 0);
    sample(&t, mesh, 1, 3, &cloud);
    const dmi_part* part = &mesh->parts[1];
    float growth = near_growth(part->box_min, part->box_max), half = 0.01f + growth;
    double mean[2] = {0}, square[2] = {0};
    for (int i = NEAR; i < BODY; i++) {
        const float* p = cloud.xyz[i];
        assert_true(in_box(part->box_min, part->box_max, growth, p));
        assert_float_equal(p[2], mesh->parts[0].box_max[2], 1e-6);
        for (int k = 0; k < 2; k++) {
            mean[k] += (double)p[k] / DMI_CLOUD_NEAR;
            square[k] += (double)p[k] * (double)p[k] / DMI_CLOUD_NEAR;
        }
    }
    for (int k = 0; k < 2; k++) { /* of a uniform distribution: mean 0, variance half^2 / 3 */
        assert_true(fabs(mean[k]) < 4 * (double)half / sqrt(3.0 * DMI_CLOUD_NEAR));
        assert_true(fabs(square[k] * 3 / (double)(half * half) - 1) < 0.15);
    }
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

static void a_part_far_from_the_rest_gets_its_nearest_samples(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){10, 1, 1}, 0);
    test_shape_box(&shape, (const float[]){-6, 0, 0}, (const float[]){-5, 1, 1}, 1);
    dmi_mesh* mesh = create(&t, NULL, 0);
    sample(&t, mesh, 1, 3, &cloud);
    float left = mesh->parts[0].box_min[0], length = mesh->parts[0].box_max[0] - left;
    int distinct = 0;
    for (int i = NEAR; i < BODY; i++) {
        assert_true(on_box(&mesh->parts[0], cloud.xyz[i]));
        assert_true(cloud.xyz[i][0] < left + 0.3f * length); /* a quarter of the surface lies left of 0.24 */
        distinct += i > NEAR && cloud.xyz[i][0] != cloud.xyz[i - 1][0];
    }
    assert_true(distinct > 700);
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

/* Triangles of all sizes, slivers among them, in random places and parts. */
static void random_mesh(uint64_t seed) {
    dmi_random random = dmi_random_make(seed, 1);
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){0.1f, 0.1f, 0.1f}, 0);
    test_shape_box(&shape, (const float[]){0.11f, 0, 0}, (const float[]){0.16f, 0.1f, 0.1f}, 1);
    uint32_t faces = dmi_random_u32(&random) % 60;
    for (uint32_t f = 0; f < faces; f++) {
        float size = powf(10, -6 * dmi_random_unit(&random)), at[3];
        for (int k = 0; k < 3; k++) at[k] = dmi_random_unit(&random);
        uint32_t first = shape.vertex_count;
        for (int i = 0; i < 3; i++) {
            float thin = dmi_random_unit(&random) < 0.2f ? 1e-7f : 1;
            test_shape_vertex(&shape, at[0] + size * dmi_random_unit(&random),
                              at[1] + size * thin * dmi_random_unit(&random), at[2] + size * dmi_random_unit(&random));
        }
        test_shape_face(&shape, first, first + 1, first + 2, dmi_random_u32(&random) % 2);
    }
}

static void any_mesh_gives_sound_points(void** state) {
    (void)state;
    for (uint64_t seed = 0; seed < 60; seed++) {
        test_env t;
        test_env_open(&t, TEST_NEVER);
        random_mesh(seed);
        dmi_mesh* mesh = create(&t, NULL, 0);
        sample(&t, mesh, 1, seed, &cloud);
        const dmi_part* part = &mesh->parts[1];
        float growth = near_growth(part->box_min, part->box_max);
        for (int i = 0; i < DMI_CLOUD_POINTS; i++) {
            const float *p = cloud.xyz[i], *n = cloud.normal[i];
            for (int k = 0; k < 3; k++) assert_true(fabsf(p[k]) <= 0.500001f);
            assert_float_equal(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-4);
            if (i >= NEAR && i < BODY) assert_true(in_box(part->box_min, part->box_max, growth, p));
        }
        dmi_mesh_destroy(&t.env, mesh);
        test_env_close(&t);
    }
}

/* Writes the faces of the shape otherwise: the last side first, and each cut along its other diagonal. */
static void cut_shape_otherwise(void) {
    static test_shape before;
    before = shape;
    for (uint32_t f = 0; f + 1 < shape.face_count; f += 2) { /* a b c and a c d become b c d and b d a */
        const uint32_t *one = before.corners[f], *two = before.corners[f + 1];
        assert_int_equal(one[0], two[0]);
        assert_int_equal(one[2], two[1]);
        const uint32_t cut[2][3] = {{one[1], one[2], two[2]}, {one[1], two[2], one[0]}}, to = shape.face_count - 2 - f;
        memcpy(shape.corners[to], cut, sizeof cut);
        shape.part[to] = shape.part[to + 1] = before.part[f];
    }
}

static void how_triangles_cut_the_surface_does_not_count(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    test_shape_cabinet(&shape);
    dmi_mesh* mesh = create(&t, NULL, 0);
    sample(&t, mesh, 1, 3, &cloud);
    dmi_mesh_destroy(&t.env, mesh);
    cut_shape_otherwise();
    mesh = create(&t, NULL, 0);
    sample(&t, mesh, 1, 3, &other);
    for (int i = 0; i < DMI_CLOUD_POINTS; i++)
        for (int k = 0; k < 3; k++) assert_float_equal(cloud.xyz[i][k], other.xyz[i][k], 1e-5);
    dmi_mesh_destroy(&t.env, mesh);
    test_env_close(&t);
}

static void every_refused_allocation_is_reported(void** state) {
    (void)state;
    for (int far = 0; far < 2; far++) { /* far: with the candidates of the nearest samples */
        test_env t;
        test_env_open(&t, TEST_NEVER);
        shape.vertex_count = shape.face_count = 0;
        float gap = far ? 50 : 0.1f;
        test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){1, 1, 1}, 0);
        test_shape_box(&shape, (const float[]){1 + gap, 0, 0}, (const float[]){2 + gap, 1, 1}, 1);
        dmi_mesh* mesh = create(&t, NULL, 0);
        int64_t before = t.memory.calls;
        int failures = 0;
        for (int64_t n = before;; n++) {
            t.memory.calls = before;
            t.memory.fail_at = n;
            dm_result result = dmi_cloud_sample(&t.env, mesh, 1, 0, &cloud);
            if (result == DM_OK) break;
            assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
            failures++;
        }
        assert_int_equal(failures, far ? 5 : 4);
        assert_int_equal(t.messages.count, failures);
        dmi_mesh_destroy(&t.env, mesh);
        test_env_close(&t);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_block_lies_where_it_belongs),
        cmocka_unit_test(carried_parts_move_along),
        cmocka_unit_test(the_seed_decides_every_bit),
        cmocka_unit_test(samples_are_even_over_a_box),
        cmocka_unit_test(blocks_are_in_random_order),
        cmocka_unit_test(near_samples_of_a_huge_face_fill_the_box),
        cmocka_unit_test(a_part_far_from_the_rest_gets_its_nearest_samples),
        cmocka_unit_test(any_mesh_gives_sound_points),
        cmocka_unit_test(how_triangles_cut_the_surface_does_not_count),
        cmocka_unit_test(every_refused_allocation_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
