/* Picking: hierarchies and scenes of moved instances against brute force, in every host frame; no thread, no allocation
 * in a frame, nothing left behind. */
#include "test_env.h"

#include <dirent.h>
#include <float.h>
#include <math.h>
#include <pthread.h>
#include <unistd.h>

#include "base/random.h"
#include "math/linear3.h"
#include "mesh/mesh.h"
#include "pick/pick.h"
#include "test_bvh.h"
#include "test_shapes.h"

static test_shape shape;
static int32_t choice; /* DM_PICK_*: every test runs once with each backend of the build */

typedef struct fixture {
    test_env t;
    dmi_picker* picker;
    dmi_axes axes;
} fixture;

static void open_fixture(fixture* f, int32_t preset, float unit) {
    test_env_open(&f->t, TEST_NEVER);
    assert_true(dmi_axes_init(&f->axes, preset, NULL, unit));
    assert_int_equal(dmi_picker_create(&f->t.env, choice, &f->picker), DM_OK);
}

static void close_fixture(fixture* f) {
    dmi_picker_destroy(f->picker);
    assert_int_equal(f->t.env.pick_bytes, 0);
    assert_int_equal(f->t.messages.count, 0);
    test_env_close(&f->t);
}

static dmi_mesh* create_mesh(fixture* f) {
    dm_mesh_desc desc = test_shape_desc(&shape);
    dmi_mesh* mesh = NULL;
    dm_result result = dmi_mesh_create(&f->t.env, &f->axes, &desc, NULL, 0, NULL, &mesh);
    if (result != DM_OK) print_error("%s\n", f->t.messages.text);
    assert_int_equal(result, DM_OK);
    return mesh;
}

static dmi_bvh* create_bvh(fixture* f, const dmi_mesh* mesh) {
    dmi_bvh* bvh = NULL;
    assert_int_equal(test_bvh_create(f->picker, mesh, NULL, &bvh), DM_OK);
    return bvh;
}

static dmi_scene* create_scene(fixture* f) {
    dmi_scene* scene = NULL;
    assert_int_equal(dmi_scene_create(f->picker, &scene), DM_OK);
    return scene;
}

static int thread_count(void) {
    int count = 0;
    DIR* folder = opendir("/proc/self/task");
    assert_non_null(folder);
    for (struct dirent* entry; (entry = readdir(folder)) != NULL;) count += entry->d_name[0] != '.';
    closedir(folder);
    return count;
}

/* Waits for threads that were joined: their entries stay for a moment. */
static void expect_threads(int most) {
    const useconds_t moment = 1000;
    for (int i = 0; i < 1000 && thread_count() > most; i++) usleep(moment);
    assert_true(thread_count() <= most);
}

/* ---- brute force --------------------------------------------------------------------------------------------------
 */

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int k = 0; k < 3; k++) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Möller and Trumbore, in doubles; the distance in lengths of the direction, or infinity. */
static double intersect(double c[3][3], const double origin[3], const double direction[3], double* u, double* v) {
    double e1[3], e2[3], s[3], p[3], q[3];
    for (int k = 0; k < 3; k++) {
        e1[k] = c[1][k] - c[0][k];
        e2[k] = c[2][k] - c[0][k];
        s[k] = origin[k] - c[0][k];
    }
    cross(direction, e2, p);
    double determinant = dot(e1, p);
    if (determinant == 0) return INFINITY;
    cross(s, e1, q);
    *u = dot(s, p) / determinant;
    *v = dot(direction, q) / determinant;
    double t = dot(e2, q) / determinant;
    return *u >= 0 && *v >= 0 && *u + *v <= 1 && t >= 0 ? t : INFINITY;
}

/* Random triangles of three parts (ids 0, 5 and 9) in a box. */
static void random_shape(dmi_random* random, uint32_t faces, float extent) {
    static const uint32_t ids[] = {0, 5, 9};
    shape.vertex_count = shape.face_count = 0;
    for (uint32_t f = 0; f < faces; f++) {
        float at[3];
        for (int k = 0; k < 3; k++) at[k] = extent * dmi_random_unit(random);
        uint32_t first = shape.vertex_count;
        for (int i = 0; i < 3; i++) {
            float p[3];
            for (int k = 0; k < 3; k++) p[k] = at[k] + 0.3f * extent * (dmi_random_unit(random) - 0.5f);
            test_shape_vertex(&shape, p[0], p[1], p[2]);
        }
        test_shape_face(&shape, first, first + 1, first + 2, f < 3 ? ids[f] : ids[dmi_random_u32(random) % 3]);
    }
}

static void random_direction(dmi_random* random, double out[3]) {
    double length;
    do {
        for (int k = 0; k < 3; k++) out[k] = (double)dmi_random_unit(random) * 2 - 1;
        length = sqrt(dot(out, out));
    } while (length > 1 || length < 0.1);
    for (int k = 0; k < 3; k++) out[k] /= length;
}

/* ---- scenes ---------------------------------------------------------------------------------------------------------
 */

static dm_pose random_pose(dmi_random* random, float reach) {
    double axis[3];
    random_direction(random, axis);
    const float a[3] = {(float)axis[0], (float)axis[1], (float)axis[2]}, origin[3] = {0, 0, 0};
    dm_pose turn = dmi_pose_from_screw(a, origin, 6 * dmi_random_unit(random), 0);
    const float shift[3] = {reach * (dmi_random_unit(random) - 0.5f), reach * (dmi_random_unit(random) - 0.5f),
                            reach * (dmi_random_unit(random) - 0.5f)};
    return dmi_pose_from_rotation_translation(turn.real, shift);
}

enum { INSTANCES = 3, PARTS = 3 };

typedef struct world {
    dm_pose placement[INSTANCES], part[INSTANCES][PARTS]; /* [0] = the identity */
    uint32_t id[INSTANCES];
} world;

static uint32_t part_index(uint32_t id) {
    return id == 0 ? 0 : id == 5 ? 1 : 2;
}

static void host_point(const world* w, int instance, uint32_t face, int corner, double out[3]) {
    const float* p = shape.xyz[shape.corners[face][corner]];
    float moved[3], placed[3];
    dmi_pose_apply(&w->part[instance][part_index(shape.part[face])], p, moved);
    dmi_pose_apply(&w->placement[instance], moved, placed);
    for (int k = 0; k < 3; k++) out[k] = (double)placed[k];
}

/* The nearest hit in the host's own coordinates, `hit->instance` as an index in the world; 0 when it is a close call.
 */
static int brute_pick(const world* w, const double origin[3], const double direction[3], dm_hit* hit) {
    double best = INFINITY, second = INFINITY, corners[3][3] = {{0}};
    *hit = (dm_hit){0};
    for (int i = 0; i < INSTANCES; i++) {
        for (uint32_t f = 0; f < shape.face_count; f++) {
            double c[3][3], u = 0, v = 0;
            for (int k = 0; k < 3; k++) host_point(w, i, f, k, c[k]);
            double t = intersect(c, origin, direction, &u, &v);
            if (t >= best) {
                second = fmin(t, second);
                continue;
            }
            second = best;
            best = t;
            *hit = (dm_hit){.object = 100 + (dm_object)i,
                            .instance = w->id[i],
                            .part_id = shape.part[f],
                            .triangle = f,
                            .distance = (float)t,
                            .u = (float)u,
                            .v = (float)v};
            memcpy(corners, c, sizeof corners);
        }
    }
    if (best == INFINITY) return 1;
    double e1[3], e2[3], n[3];
    for (int k = 0; k < 3; k++) {
        e1[k] = corners[1][k] - corners[0][k];
        e2[k] = corners[2][k] - corners[0][k];
    }
    cross(e1, e2, n); /* the host's own formula, whatever its handedness */
    double length = sqrt(dot(n, n)), grazing = fabs(dot(n, direction)) / length;
    hit->normal = (dm_vec3){(float)(n[0] / length), (float)(n[1] / length), (float)(n[2] / length)};
    double margin = fmin(fmin((double)hit->u, (double)hit->v), 1 - (double)hit->u - (double)hit->v);
    return second - best > 1e-3 * best && margin > 1e-3 && grazing > 0.05 && length > 1e-3;
}

static void expect_near(dm_vec3 a, dm_vec3 b, float tolerance) {
    assert_float_equal(a.x, b.x, tolerance);
    assert_float_equal(a.y, b.y, tolerance);
    assert_float_equal(a.z, b.z, tolerance);
}

/* From anywhere, mostly at a face. */
static void random_ray(const world* w, dmi_random* random, float extent, double origin[3], double direction[3]) {
    double corners[3][3];
    uint32_t face = dmi_random_u32(random) % shape.face_count;
    int instance = (int)(dmi_random_u32(random) % INSTANCES);
    for (int i = 0; i < 3; i++) host_point(w, instance, face, i, corners[i]);
    for (int k = 0; k < 3; k++) origin[k] = (double)(float)(4 * extent * (dmi_random_unit(random) - 0.5f));
    random_direction(random, direction);
    if (dmi_random_unit(random) < 0.2f) return;
    for (int k = 0; k < 3; k++) direction[k] = (corners[0][k] + corners[1][k] + corners[2][k]) / 3 - origin[k];
    double length = sqrt(dot(direction, direction));
    for (int k = 0; k < 3; k++) direction[k] /= length;
}

static void check_pick(const dmi_scene* scene, const world* w, dmi_random* random, float extent, int* hits) {
    double origin[3], direction[3], length = 1e-3 + 1e3 * (double)dmi_random_unit(random);
    random_ray(w, random, extent, origin, direction);
    const dm_ray ray = {
        {(float)origin[0], (float)origin[1], (float)origin[2]},
        {(float)(direction[0] * length), (float)(direction[1] * length), (float)(direction[2] * length)}};
    dm_hit expected, hit;
    if (!brute_pick(w, origin, direction, &expected)) return;
    memset(&hit, 0xff, sizeof hit);
    dmi_scene_pick(scene, &ray, &hit);
    if (expected.object == 0 || hit.object == 0) {
        /* Brute force has no answer for rays past an edge by a hair: they are few. */
        assert_true(hit.object == expected.object);
        return;
    }
    ++*hits;
    assert_true(hit.object == expected.object);
    assert_int_equal(hit.instance, expected.instance);
    assert_int_equal(hit.part_id, expected.part_id);
    assert_int_equal(hit.triangle, expected.triangle);
    float tolerance = 1e-4f * extent;
    assert_float_equal(hit.distance, expected.distance, tolerance);
    assert_float_equal(hit.u, expected.u, 1e-2);
    assert_float_equal(hit.v, expected.v, 1e-2);
    expect_near(hit.normal, expected.normal, 2e-3f);
    const dm_vec3 point = {(float)(origin[0] + direction[0] * (double)hit.distance),
                           (float)(origin[1] + direction[1] * (double)hit.distance),
                           (float)(origin[2] + direction[2] * (double)hit.distance)};
    expect_near(hit.point, point, tolerance);
    int i = (int)(hit.object - 100); /* object_point, placed, is the point */
    float placed[3];
    dmi_pose_apply(&w->placement[i], dmi_xyz(hit.object_point).v, placed);
    expect_near(dmi_vec3(placed), hit.point, tolerance);
}

static void move_everything(dmi_scene* scene, world* w, dmi_random* random, float extent) {
    static const uint32_t ids[] = {0, 5, 9};
    for (int i = 0; i < INSTANCES; i++) {
        for (int p = 0; p < PARTS; p++) {
            if (dmi_random_unit(random) < 0.3f) continue;
            dm_pose pose = random_pose(random, p == 0 ? extent : 0.5f * extent);
            *(p == 0 ? &w->placement[i] : &w->part[i][p]) = pose;
            assert_int_equal(dmi_scene_move(scene, w->id[i], ids[p], &pose), DM_OK);
        }
    }
    dmi_scene_commit(scene);
}

/* The same in glTF, Unity, Unreal (centimetres) and Blender frames. */
static void picks_of_moved_instances_match_brute_force(void** state) {
    (void)state;
    static const float units[] = {1, 1, 0.01f, 1};
    int hits = 0;
    for (int32_t preset = DM_AXES_GLTF; preset <= DM_AXES_BLENDER; preset++) {
        fixture f;
        open_fixture(&f, preset, units[preset]);
        dmi_random random = dmi_random_make(77, (uint64_t)preset);
        float extent = 2 / units[preset];
        random_shape(&random, 40, extent);
        dmi_mesh* mesh = create_mesh(&f);
        dmi_bvh* bvh = create_bvh(&f, mesh);
        dmi_scene* scene = create_scene(&f);
        world w;
        for (int i = 0; i < INSTANCES; i++) {
            w.placement[i] = random_pose(&random, extent);
            for (int p = 0; p < PARTS; p++) w.part[i][p] = dmi_pose_identity();
            assert_int_equal(dmi_scene_add(scene, bvh, &mesh->frame, 100 + (dm_object)i, &w.placement[i], &w.id[i]),
                             DM_OK);
        }
        dmi_scene_commit(scene);
        for (int round = 0; round < 5; round++) {
            for (int i = 0; i < 100; i++) check_pick(scene, &w, &random, extent, &hits);
            move_everything(scene, &w, &random, extent);
        }
        dmi_scene_destroy(scene);
        test_bvh_destroy(bvh);
        dmi_mesh_destroy(&f.t.env, mesh);
        close_fixture(&f);
    }
    assert_true(hits > 500);
}

typedef struct stage {
    fixture f;
    dmi_mesh* mesh;
    dmi_bvh* bvh;
    dmi_scene* scene;
} stage;

static void open_stage_of_shape(stage* s) {
    open_fixture(&s->f, DM_AXES_GLTF, 1);
    s->mesh = create_mesh(&s->f);
    s->bvh = create_bvh(&s->f, s->mesh);
    s->scene = create_scene(&s->f);
}

static void open_stage(stage* s) {
    test_shape_cabinet(&shape);
    open_stage_of_shape(s);
}

static void close_stage(stage* s) {
    dmi_scene_destroy(s->scene);
    test_bvh_destroy(s->bvh);
    dmi_mesh_destroy(&s->f.t.env, s->mesh);
    close_fixture(&s->f);
}

static uint32_t add(stage* s, dm_object object, float x) {
    const float rotation[4] = {0, 0, 0, 1}, shift[3] = {x, 0, 0};
    dm_pose placement = dmi_pose_from_rotation_translation(rotation, shift);
    uint32_t instance = UINT32_MAX;
    assert_int_equal(dmi_scene_add(s->scene, s->bvh, &s->mesh->frame, object, &placement, &instance), DM_OK);
    return instance;
}

static dm_hit pick(const stage* s, dm_vec3 origin, dm_vec3 direction) {
    const dm_ray ray = {origin, direction};
    dm_hit hit;
    dmi_scene_pick(s->scene, &ray, &hit);
    return hit;
}

static void axis_parallel_rays_at_flat_parts(void** state) {
    (void)state;
    stage s;
    shape.vertex_count = shape.face_count = 0;
    for (uint32_t i = 0; i < 3; i++) { /* three squares, one behind the other, without thickness */
        float z = (float)i;
        uint32_t v = test_shape_vertex(&shape, 0, 0, z);
        test_shape_vertex(&shape, 2, 0, z);
        test_shape_vertex(&shape, 2, 2, z);
        test_shape_vertex(&shape, 0, 2, z);
        test_shape_face(&shape, v, v + 1, v + 2, i);
        test_shape_face(&shape, v, v + 2, v + 3, i);
    }
    open_stage_of_shape(&s);
    add(&s, 1, 0);
    dmi_scene_commit(s.scene);
    dm_hit hit = pick(&s, (dm_vec3){1.1f, 1.2f, 5}, (dm_vec3){0, 0, -1});
    assert_int_equal(hit.part_id, 2);
    assert_float_equal(hit.distance, 3, 1e-6);
    expect_near(hit.normal, (dm_vec3){0, 0, 1}, 1e-6f);
    hit = pick(&s, (dm_vec3){1.1f, 1.2f, -5}, (dm_vec3){0, 0, 1});
    assert_int_equal(hit.part_id, 0);
    assert_true(pick(&s, (dm_vec3){1.1f, 1.2f, 5}, (dm_vec3){0, 0, 1}).object == 0);
    assert_true(pick(&s, (dm_vec3){1, 1, 5}, (dm_vec3){0, 0, -1}).object == 1); /* at the diagonal: no crack */
    close_stage(&s);
}

/* What a ray from the front, down the -z axis, finds at (x, 0.5). */
static dm_hit look(const stage* s, float x) {
    return pick(s, (dm_vec3){x, 0.5f, 9}, (dm_vec3){0, 0, -1});
}

static void changes_show_at_the_commit(void** state) {
    (void)state;
    stage s;
    open_stage(&s);
    assert_int_equal(look(&s, 0.5f).object, 0); /* an empty scene */
    uint32_t first = add(&s, 7, 0);
    assert_int_equal(look(&s, 0.5f).object, 0); /* not yet */
    dmi_scene_commit(s.scene);
    dm_hit hit = look(&s, 0.5f);
    assert_int_equal(hit.object, 7);
    assert_int_equal(hit.part_id, 1);
    assert_float_equal(hit.distance, 9 - 1.05f, 1e-5);
    assert_float_equal(hit.normal.z, 1, 1e-6);
    assert_int_equal(look(&s, 1.5f).part_id, 0);
    assert_int_equal(look(&s, 0.91f).part_id, 2);
    const float y[3] = {0, 1, 0}, hinge[3] = {0, 0, 1}; /* the door by 90 degrees: the body lies open */
    dm_pose open = dmi_pose_from_screw(y, hinge, -1.5707963f, 0);
    assert_int_equal(dmi_scene_move(s.scene, first, 1, &open), DM_OK);
    assert_int_equal(look(&s, 0.5f).part_id, 1);
    dmi_scene_commit(s.scene);
    hit = look(&s, 0.5f);
    assert_int_equal(hit.part_id, 0);
    assert_float_equal(hit.point.z, 1, 1e-6);
    dmi_scene_commit(s.scene); /* nothing new: fine */
    const dm_ray side = {{-5, 0.5f, 1.5f}, {2, 0, 0}};
    dmi_scene_pick(s.scene, &side, &hit);
    assert_int_equal(hit.part_id, 1);
    assert_float_equal(hit.distance, 5 - 0.05f, 1e-5);
    close_stage(&s);
}

static void removed_instances_are_gone_at_once(void** state) {
    (void)state;
    stage s;
    open_stage(&s);
    uint32_t a = add(&s, 1, 0), b = add(&s, 2, 10), c = add(&s, 3, 20);
    dmi_scene_commit(s.scene);
    dm_pose away = dmi_pose_identity();
    assert_int_equal(dmi_scene_move(s.scene, b, 0, &away), DM_OK); /* dirty when it goes */
    assert_int_equal(dmi_scene_move(s.scene, c, 0, &away), DM_OK);
    assert_int_equal(dmi_scene_remove(s.scene, b), DM_OK);
    assert_int_equal(look(&s, 10.5f).object, 0);
    assert_int_equal(look(&s, 20.5f).object, 3); /* its move still waits for the commit */
    dmi_scene_commit(s.scene);
    assert_int_equal(look(&s, 20.5f).object, 0);
    assert_int_equal(dmi_scene_remove(s.scene, c), DM_OK);
    assert_int_equal(look(&s, 0.5f).object, 1);
    assert_int_equal(dmi_scene_remove(s.scene, a), DM_OK);
    assert_int_equal(look(&s, 0.5f).object, 0);
    uint32_t pending = add(&s, 4, 0); /* removed before it ever showed */
    assert_int_equal(dmi_scene_remove(s.scene, pending), DM_OK);
    dmi_scene_commit(s.scene);
    assert_int_equal(look(&s, 0.5f).object, 0);
    close_stage(&s);
}

static void scenes_grow_and_reuse_ids(void** state) {
    (void)state;
    stage s;
    open_stage(&s);
    enum { COUNT = 70 };
    for (uint32_t i = 0; i < COUNT; i++) assert_int_equal(add(&s, i + 1, 3 * (float)i), i);
    dmi_scene_commit(s.scene);
    for (uint32_t i = 0; i < COUNT; i++) assert_int_equal(look(&s, 3 * (float)i + 0.5f).object, i + 1);
    for (uint32_t i = 0; i < COUNT; i += 2) assert_int_equal(dmi_scene_remove(s.scene, i), DM_OK);
    for (uint32_t i = 0; i < COUNT; i++) assert_int_equal(look(&s, 3 * (float)i + 0.5f).object, i % 2 == 0 ? 0 : i + 1);
    assert_int_equal(add(&s, 1000, 0), COUNT - 2); /* the last that was removed */
    assert_int_equal(add(&s, 1001, 6), COUNT - 4);
    dmi_scene_commit(s.scene);
    assert_int_equal(look(&s, 6.5f).object, 1001);
    assert_int_equal(look(&s, 6.5f).instance, COUNT - 4);
    for (uint32_t i = 2; i < COUNT / 2; i++) assert_true(add(&s, 2000, 0) < COUNT);
    assert_int_equal(add(&s, 3000, 0), COUNT); /* none is free any more */
    close_stage(&s);
}

/* Fills a scene with rows of instances that a commit follows each `batch` of. */
static void fill_rows(dmi_scene* scene, const dmi_bvh* bvh, const dmi_frame* frame, uint32_t count, uint32_t batch) {
    for (uint32_t i = 0; i < count; i++) {
        const float x = 2 * (float)(i % 25), z = 2 * (float)(i / 25);
        const dm_pose place = {{0, 0, 0, 1}, {0.5f * x, 0, 0.5f * z, 0}};
        uint32_t instance;
        assert_int_equal(dmi_scene_add(scene, bvh, frame, 1 + i, &place, &instance), DM_OK);
        if (i % batch == batch - 1) dmi_scene_commit(scene);
    }
    dmi_scene_commit(scene);
}

/* At once, in batches or one by one: the tree differs, no hit does. */
static void how_instances_come_changes_no_hit(void** state) {
    (void)state;
    enum { COUNT = 600, RAYS = 2000 };
    static const uint32_t batches[] = {COUNT, 50, 7, 1};
    static dm_hit first[RAYS];
    stage s;
    open_stage(&s);
    for (int kind = 0; kind < 4; kind++) {
        dmi_random random = dmi_random_make(4, 4);
        dmi_scene* scene = create_scene(&s.f);
        fill_rows(scene, s.bvh, &s.mesh->frame, COUNT, batches[kind]);
        int hits = 0;
        for (int r = 0; r < RAYS; r++) {
            double direction[3];
            random_direction(&random, direction);
            const dm_ray ray = {
                {50 * dmi_random_unit(&random), 3 * dmi_random_unit(&random) - 1, 50 * dmi_random_unit(&random)},
                {(float)direction[0], 0.1f * (float)direction[1], (float)direction[2]}};
            dm_hit hit = {.struct_size = sizeof hit};
            dmi_scene_pick(scene, &ray, &hit);
            hits += hit.object != 0;
            if (kind == 0) first[r] = hit;
            assert_memory_equal(&hit, &first[r], sizeof hit);
        }
        assert_true(hits > RAYS / 4);
        dmi_scene_destroy(scene);
    }
    close_stage(&s);
}

static void wrong_ids_are_not_found(void** state) {
    (void)state;
    stage s;
    open_stage(&s);
    uint32_t instance = add(&s, 1, 0);
    dm_pose pose = dmi_pose_identity();
    test_messages* messages = &s.f.t.messages;
    assert_int_equal(dmi_scene_move(s.scene, instance + 1, 0, &pose), DM_ERROR_NOT_FOUND);
    assert_int_equal(dmi_scene_move(s.scene, UINT32_MAX, 0, &pose), DM_ERROR_NOT_FOUND);
    assert_int_equal(dmi_scene_move(s.scene, instance, 3, &pose), DM_ERROR_NOT_FOUND);
    assert_int_equal(messages->count, 0); /* a frame call */
    assert_int_equal(dmi_scene_remove(s.scene, instance), DM_OK);
    assert_int_equal(dmi_scene_remove(s.scene, instance), DM_ERROR_NOT_FOUND);
    assert_non_null(strstr(messages->text, "no instance 0"));
    assert_int_equal(messages->count, 1);
    messages->count = 0;
    close_stage(&s);
}

static void unusable_rays_hit_nothing(void** state) {
    (void)state;
    stage s;
    open_stage(&s);
    add(&s, 1, 0);
    dmi_scene_commit(s.scene);
    const dm_vec3 good = {0.5f, 0.5f, 9}, down = {0, 0, -1};
    const dm_vec3 bad[] = {{NAN, 0, 0}, {0, 0, -INFINITY}, {0, NAN, -1}};
    dm_hit hit;
    for (int i = 0; i < 3; i++) {
        dmi_scene_pick(s.scene, &(dm_ray){good, bad[i]}, &hit);
        assert_int_equal(hit.object, 0);
        dmi_scene_pick(s.scene, &(dm_ray){bad[i], down}, &hit);
        assert_int_equal(hit.object, 0);
    }
    dmi_scene_pick(s.scene, &(dm_ray){good, {0, 0, 0}}, &hit);
    assert_int_equal(hit.object, 0);
    dmi_scene_pick(s.scene, &(dm_ray){good, {0, 0, -1e-38f}}, &hit);
    assert_int_equal(hit.object, 1);
    dmi_scene_pick(s.scene, &(dm_ray){good, {0, 0, -FLT_MAX}}, &hit);
    assert_int_equal(hit.object, 1);
    assert_float_equal(hit.distance, 9 - 1.05f, 1e-5);
    close_stage(&s);
}

static void places_out_of_reach_are_refused(void** state) {
    (void)state;
    stage s;
    open_stage(&s);
    uint32_t instance = add(&s, 1, 0), untouched = 77;
    test_messages* messages = &s.f.t.messages;
    const float rotation[4] = {0, 0, 0, 1}, far[3] = {0, -2e10f, 0};
    dm_pose away = dmi_pose_from_rotation_translation(rotation, far), identity = dmi_pose_identity();
    assert_int_equal(dmi_scene_move(s.scene, instance, 0, &away), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dmi_scene_move(s.scene, instance, 1, &away), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(messages->count, 0); /* frame calls */
    assert_int_equal(dmi_scene_add(s.scene, s.bvh, &s.mesh->frame, 2, &away, &untouched), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(messages->text, "-2e+10"));
    dmi_frame tiny = s.mesh->frame, huge = s.mesh->frame;
    tiny.size = 1e-9;
    huge.size = 1e15;
    assert_int_equal(dmi_scene_add(s.scene, s.bvh, &tiny, 2, &identity, &untouched), DM_ERROR_UNSUPPORTED);
    assert_int_equal(dmi_scene_add(s.scene, s.bvh, &huge, 2, &identity, &untouched), DM_ERROR_UNSUPPORTED);
    assert_int_equal(untouched, 77);
    assert_int_equal(messages->count, 3);
    messages->count = 0;
    dmi_scene_commit(s.scene);
    assert_int_equal(look(&s, 0.5f).object, 1); /* still where it was */
    dm_hit hit;
    dmi_scene_pick(s.scene, &(dm_ray){{0.5f, 0.5f, 9e9f}, {0, 0, -1}}, &hit);
    assert_int_equal(hit.object, 1);
    dmi_scene_pick(s.scene, &(dm_ray){{0.5f, 0.5f, FLT_MAX}, {0, 0, -1}}, &hit);
    assert_int_equal(hit.object, 0);
    close_stage(&s);
}

/* Extremes that the limits let through: the smallest object and the largest shifts. */
static void objects_at_the_limits_can_be_picked(void** state) {
    (void)state;
    stage s;
    open_stage(&s);
    const float rotation[4] = {0, 0, 0, 1}, shift[3] = {9e9f, 9e9f, 9e9f};
    dm_pose far = dmi_pose_from_rotation_translation(rotation, shift), identity = dmi_pose_identity();
    const double sizes[] = {1.1e-6, 1, 0.9e12};
    for (int i = 0; i < 3; i++) {
        dmi_frame frame = s.mesh->frame;
        frame.size = sizes[i];
        uint32_t instance;
        assert_int_equal(dmi_scene_add(s.scene, s.bvh, &frame, 1, &identity, &instance), DM_OK);
        for (int moved = 0; moved < 3; moved++) {
            if (moved > 0) assert_int_equal(dmi_scene_move(s.scene, instance, moved == 1 ? 0 : 1, &far), DM_OK);
            dmi_scene_commit(s.scene);
            for (int k = 0; k < 8; k++) { /* whatever they hit: Embree must bear them */
                dm_ray ray = {{k & 1 ? 9e9f : -9e9f, k & 2 ? 9e9f : 0, k & 4 ? 9e9f : 1}, {0, 0, -1}};
                dm_hit hit;
                dmi_scene_pick(s.scene, &ray, &hit);
                ray.direction = (dm_vec3){9e9f * (float)moved - ray.origin.x, -ray.origin.y, -ray.origin.z};
                dmi_scene_pick(s.scene, &ray, &hit);
            }
        }
        assert_int_equal(dmi_scene_remove(s.scene, instance), DM_OK);
    }
    close_stage(&s);
}

/* Slivers, points and the same triangle a thousand times over: Debian's Embree asserts on what it dislikes. */
static void degenerate_triangles_build(void** state) {
    (void)state;
    stage s;
    test_shape_cabinet(&shape);
    uint32_t line = test_shape_vertex(&shape, 0, 0, 0);
    test_shape_vertex(&shape, 1, 0.5f, 0.5f);
    test_shape_vertex(&shape, 2, 1, 1);
    for (uint32_t i = 0; i < 3000; i++) {
        if (i % 3 == 0) test_shape_face(&shape, line, line, line, i % 2);
        if (i % 3 == 1) test_shape_face(&shape, line, line + 1, line + 2, i % 2);
        if (i % 3 == 2) test_shape_face(&shape, 0, 1, 2, i % 2);
    }
    open_stage_of_shape(&s);
    add(&s, 1, 0);
    dmi_scene_commit(s.scene);
    const dm_hit hit = pick(&s, (dm_vec3){0.5f, 0.6f, -3}, (dm_vec3){0, 0, 1}); /* the body's back */
    assert_true(hit.object == 1);
    assert_float_equal(hit.distance, 3, 1e-5);
    close_stage(&s);
}

/* ---- what a frame costs ---------------------------------------------------------------------------------------------
 */

static void a_frame_allocates_nothing(void** state) {
    (void)state;
    stage s;
    open_stage(&s);
    uint32_t instances[4];
    for (uint32_t i = 0; i < 4; i++) instances[i] = add(&s, i + 1, 3 * (float)i);
    int64_t calls = s.f.t.memory.calls;
    dmi_scene_commit(s.scene);
    const float y[3] = {0, 1, 0}, hinge[3] = {0, 0, 1};
    for (int frame = 0; frame < 50; frame++) {
        for (uint32_t i = 0; i < 4; i++) {
            dm_pose pose = dmi_pose_from_screw(y, hinge, -0.03f * (float)frame, 0);
            assert_int_equal(dmi_scene_move(s.scene, instances[i], 1, &pose), DM_OK);
            assert_int_equal(dmi_scene_move(s.scene, instances[i], 0, &pose), DM_OK);
        }
        dmi_scene_commit(s.scene);
        look(&s, 0.5f);
    }
    assert_true(s.f.t.memory.calls == calls);
    close_stage(&s);
}

/* Embree's is reported by itself, that of our own trees comes from the host. */
static void memory_of_the_trees_is_counted(void** state) {
    (void)state;
    stage s;
    open_stage(&s);
    const _Atomic uint64_t* bytes = choice == DM_PICK_EMBREE ? &s.f.t.env.pick_bytes : &s.f.t.env.bytes;
    dmi_random random = dmi_random_make(1, 1);
    random_shape(&random, 1000, 1);
    dmi_mesh* mesh = create_mesh(&s.f);
    const uint64_t before = *bytes;
    dmi_bvh* bvh = create_bvh(&s.f, mesh);
    const uint64_t with = *bytes;
    assert_true(with > before + 1000 * 16 && with < before + 10000000);
    if (choice == DM_PICK_PORTABLE) assert_true(s.f.t.env.pick_bytes == 0);
    test_bvh_destroy(bvh);
    assert_true(*bytes <= before);
    dmi_mesh_destroy(&s.f.t.env, mesh);
    close_stage(&s);
}

/* ---- threads --------------------------------------------------------------------------------------------------------
 */

typedef struct builder {
    dmi_picker* picker;
    const dmi_mesh* mesh;
    int failures;
} builder;

static void* build_and_pick(void* data) {
    builder* b = data;
    for (int i = 0; i < 12; i++) {
        dmi_bvh* bvh = NULL;
        dmi_scene* scene = NULL;
        uint32_t instance;
        dm_pose identity = dmi_pose_identity();
        dm_hit hit = {0};
        int good = test_bvh_create(b->picker, b->mesh, NULL, &bvh) == DM_OK &&
                   dmi_scene_create(b->picker, &scene) == DM_OK &&
                   dmi_scene_add(scene, bvh, &b->mesh->frame, 1, &identity, &instance) == DM_OK;
        if (good) {
            dmi_scene_commit(scene);
            const dm_ray ray = {{0.5f, 0.5f, 9}, {0, 0, -1}};
            dmi_scene_pick(scene, &ray, &hit);
        }
        b->failures += hit.object != 1;
        dmi_scene_destroy(scene);
        test_bvh_destroy(bvh);
    }
    return NULL;
}

static void* do_nothing(void* data) {
    return data;
}

/* More builders than processors, on one device, and never a thread that is not ours; not when the device goes either.
 */
static void the_library_starts_no_thread(void** state) {
    (void)state;
    enum { BUILDERS = 8 };
    pthread_t first; /* ThreadSanitizer starts one of its own with the first */
    assert_int_equal(pthread_create(&first, NULL, do_nothing, NULL), 0);
    assert_int_equal(pthread_join(first, NULL), 0);
    int before = thread_count();
    fixture f;
    open_fixture(&f, DM_AXES_GLTF, 1);
    test_shape_cabinet(&shape);
    dmi_random random = dmi_random_make(3, 3);
    while (shape.face_count < 1200) { /* enough triangles to be worth splitting up */
        float low[3], high[3];
        for (int k = 0; k < 3; k++) {
            low[k] = 0.9f * dmi_random_unit(&random);
            high[k] = low[k] + 0.05f;
        }
        test_shape_box(&shape, low, high, 0);
    }
    dmi_mesh* mesh = create_mesh(&f);
    builder alone = {f.picker, mesh, 0};
    build_and_pick(&alone);
    assert_int_equal(alone.failures, 0);
    expect_threads(before);
    pthread_t threads[BUILDERS];
    builder builders[BUILDERS];
    for (int i = 0; i < BUILDERS; i++) {
        builders[i] = alone;
        assert_int_equal(pthread_create(&threads[i], NULL, build_and_pick, &builders[i]), 0);
    }
    for (int i = 0; i < BUILDERS; i++) {
        assert_int_equal(pthread_join(threads[i], NULL), 0);
        assert_int_equal(builders[i].failures, 0);
    }
    expect_threads(before);
    dmi_mesh_destroy(&f.t.env, mesh);
    close_fixture(&f);
    expect_threads(before);
}

/* ---- memory runs out ------------------------------------------------------------------------------------------------
 */

static void every_refused_allocation_is_reported(void** state) {
    (void)state;
    fixture f;
    open_fixture(&f, DM_AXES_GLTF, 1);
    test_shape_cabinet(&shape);
    dmi_mesh* mesh = create_mesh(&f);
    dm_pose identity = dmi_pose_identity();
    int failures = 0;
    for (int64_t n = 0;; n++) {
        f.t.memory.calls = 0;
        f.t.memory.fail_at = n;
        dmi_picker* picker = NULL;
        dmi_bvh* bvh = NULL;
        dmi_scene* scene = NULL;
        uint32_t instance = 77;
        dm_result result = dmi_picker_create(&f.t.env, choice, &picker);
        if (result == DM_OK) result = test_bvh_create(picker, mesh, NULL, &bvh);
        if (result == DM_OK) result = dmi_scene_create(picker, &scene);
        if (result == DM_OK) result = dmi_scene_add(scene, bvh, &mesh->frame, 1, &identity, &instance);
        if (result != DM_OK) assert_int_equal(instance, 77);
        dmi_scene_destroy(scene);
        test_bvh_destroy(bvh);
        dmi_picker_destroy(picker);
        if (result == DM_OK && f.t.memory.calls <= n) break;
        if (result == DM_OK) continue; /* memory to copy a tree to its size, which can stay as large as it is */
        assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
        failures++;
    }
    assert_true(failures >= 16); /* bvh 5 and more for each part, scene 1, instances 2, an instance 1, its tree 3 */
    assert_int_equal(f.t.messages.count, failures);
    f.t.messages.count = 0;
    dmi_mesh_destroy(&f.t.env, mesh);
    close_fixture(&f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_library_starts_no_thread),
        cmocka_unit_test(axis_parallel_rays_at_flat_parts),
        cmocka_unit_test(picks_of_moved_instances_match_brute_force),
        cmocka_unit_test(changes_show_at_the_commit),
        cmocka_unit_test(removed_instances_are_gone_at_once),
        cmocka_unit_test(scenes_grow_and_reuse_ids),
        cmocka_unit_test(how_instances_come_changes_no_hit),
        cmocka_unit_test(wrong_ids_are_not_found),
        cmocka_unit_test(unusable_rays_hit_nothing),
        cmocka_unit_test(places_out_of_reach_are_refused),
        cmocka_unit_test(objects_at_the_limits_can_be_picked),
        cmocka_unit_test(degenerate_triangles_build),
        cmocka_unit_test(a_frame_allocates_nothing),
        cmocka_unit_test(memory_of_the_trees_is_counted),
        cmocka_unit_test(every_refused_allocation_is_reported),
    };
    int failed = 0;
    (void)tests; /* in a build that picks nothing */
#if !defined(DMI_NO_EMBREE)
    choice = DM_PICK_EMBREE;
    failed += cmocka_run_group_tests_name("embree", tests, NULL, NULL);
#endif
#if !defined(DMI_NO_PORTABLE)
    choice = DM_PICK_PORTABLE;
    failed += cmocka_run_group_tests_name("portable", tests, NULL, NULL);
#endif
    return failed;
}
