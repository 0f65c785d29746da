/* dm_gltf_rig: what files of engines and simulators say of an asset whose masses, frames and joints are known. What
 * consumers make of them is the matter of tests/e2e/exports.sh. */
#include <locale.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "dragmesh/ext/gltf_rig.h"

enum { NODES = 4, PARTS = 3, SAID = 4096 };

/* A cube of side 1 whose least corner is at the origin, and two triangles of a square. */
static const float cube[8][3] = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1},
                                 {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}};
static const uint32_t sides[12][3] = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                                      {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
static const dm_mesh_desc cube_mesh = {
    .struct_size = sizeof cube_mesh, .positions = cube, .vertex_count = 8, .indices = sides, .index_count = 36};
static const dm_mesh_desc square_mesh = {
    .struct_size = sizeof square_mesh, .positions = cube, .vertex_count = 8, .indices = sides, .index_count = 6};

/* A body, a door on it, a drawer on the door, and a fixed knob on the drawer. */
typedef struct asset {
    dm_asset_node nodes[NODES];
    float transforms[NODES][16];
    dm_asset_part parts[PARTS];
    dm_joint joints[PARTS];
    uint32_t node_parts[NODES];
    char said[SAID];
    dm_gltf_rig_desc desc;
} asset;

static void DM_CALL listen(void* user, int32_t level, dm_result code, const char* text) {
    asset* a = user;
    (void)level, (void)code;
    snprintf(a->said + strlen(a->said), SAID - strlen(a->said), "%s\n", text);
}

static void place(asset* a, uint32_t node, float x, float y, float z) {
    const float m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
    memcpy(a->transforms[node], m, sizeof m);
}

static void make_asset(asset* a) {
    static const char* const names[NODES] = {"frame", "door \"1\"", "Schublade/ä", "knob"};
    static const uint32_t parents[PARTS] = {DM_ASSET_NO_PART, 0, 1};
    static const int32_t types[PARTS] = {DM_JOINT_REVOLUTE, DM_JOINT_PRISMATIC, DM_JOINT_FIXED};
    *a = (asset){.node_parts = {DM_ASSET_NO_PART, 0, 1, 2}};
    for (uint32_t i = 0; i < NODES; i++) {
        place(a, i, (float)(2 * i), 0, 0);
        a->nodes[i] = (dm_asset_node){.struct_size = sizeof *a->nodes,
                                      .parent = DM_ASSET_NO_NODE,
                                      .follows = DM_ASSET_NO_NODE,
                                      .name = names[i],
                                      .mesh = i == 3 ? &square_mesh : &cube_mesh,
                                      .transform = a->transforms[i]};
    }
    for (uint32_t i = 0; i < PARTS; i++) {
        a->parts[i] = (dm_asset_part){.struct_size = sizeof *a->parts,
                                      .parent = parents[i],
                                      .part_id = i + 1,
                                      .state = DM_ASSET_MOVES,
                                      .moves = 1};
        a->joints[i] = (dm_joint){.struct_size = sizeof *a->joints,
                                  .type = types[i],
                                  .axis = {0, 1, 0},
                                  .origin = {(float)(2 * i + 2), 0, 1},
                                  .upper = 1.5f};
    }
    a->desc = (dm_gltf_rig_desc){.struct_size = sizeof a->desc,
                                 .formats = DM_GLTF_RIG_URDF,
                                 .nodes = a->nodes,
                                 .parts = a->parts,
                                 .joints = a->joints,
                                 .node_parts = a->node_parts,
                                 .node_count = NODES,
                                 .part_count = PARTS,
                                 .log = {a, listen}};
}

/* The text of a file of the rig. */
static const char* text_of(const dm_gltf_rig* rig, const char* path) {
    for (uint32_t i = 0; i < dm_gltf_rig_file_count(rig); i++) {
        dm_gltf_rig_file file;
        assert_int_equal(dm_gltf_rig_get_file(rig, i, &file), DM_OK);
        if (strcmp(file.path, path) == 0) return file.data;
    }
    fail_msg("there is no %s", path);
    return NULL;
}

static dm_gltf_rig* make(asset* a) {
    dm_gltf_rig* rig = NULL;
    if (dm_gltf_rig_make(&a->desc, &rig) != DM_OK) fail_msg("%s", a->said);
    return rig;
}

/* Reads numbers of an attribute that comes after words of the text, one after the other. */
static void read_after(const char* text, const char* words, const char* attribute, int count, double* out) {
    char wanted[64];
    const char* at = strstr(text, words);
    snprintf(wanted, sizeof wanted, " %s=\"", attribute);
    at = at != NULL ? strstr(at, wanted) : NULL;
    if (at == NULL) fail_msg("%s has no %s in\n%s", words, attribute, text);
    at += strlen(wanted);
    for (int i = 0; i < count; i++) out[i] = strtod(at, (char**)&at);
}

static void assert_near(const double* found, const double* wanted, int count) {
    for (int i = 0; i < count; i++)
        if (fabs(found[i] - wanted[i]) > 1e-6) fail_msg("number %d is %g, not %g", i, found[i], wanted[i]);
}

/* A solid cube weighs its volume; all is Z up. */
static void test_masses(void** state) {
    (void)state;
    asset a;
    double mass, centre[3], moments[2];
    make_asset(&a);
    a.desc.density = 100;
    dm_gltf_rig* rig = make(&a);
    const char* door = strstr(text_of(rig, "rigged.urdf"), "<link name=\"part_1_door_1\">");
    assert_non_null(door);
    read_after(door, "<mass", "value", 1, &mass);
    read_after(door, "<origin", "xyz", 3, centre);
    read_after(door, "<inertia", "ixx", 1, &moments[0]);
    read_after(door, "<inertia", "ixy", 1, &moments[1]);
    assert_near(&mass, (double[]){100}, 1);
    assert_near(centre, (double[]){0.5, 0.5, 0.5}, 3); /* of (2.5, 0.5, 0.5), seen from (2, 0, 1), Y up */
    assert_true(fabs(moments[0] - 100.0 / 6) < 1e-3 && fabs(moments[1]) < 1e-9);
    dm_gltf_rig_destroy(rig);
}

/* The drawer's body has the fixed knob, whose square weighs its area by the thickness. */
static void test_fixed_parts_are_one_with_what_carries_them(void** state) {
    (void)state;
    asset a;
    double mass, place_in_door[3];
    make_asset(&a);
    a.desc.density = 1000;
    a.desc.thickness = 0.01f;
    dm_gltf_rig* rig = make(&a);
    const char* urdf = text_of(rig, "rigged.urdf");
    assert_null(strstr(urdf, "part_3"));
    read_after(strstr(urdf, "<link name=\"part_2_Schublade\">"), "<mass", "value", 1, &mass);
    assert_near(&mass, (double[]){1000 + 10}, 1);
    read_after(urdf, "<joint name=\"joint_2_Schublade\" type=\"prismatic\">", "xyz", 3, place_in_door);
    assert_near(place_in_door, (double[]){2, 0, 0}, 3);
    assert_non_null(strstr(urdf, "<parent link=\"part_1_door_1\"/>"));
    assert_non_null(strstr(urdf, "<dragmesh name=\"door &quot;1&quot;\"/>"));
    dm_gltf_rig_destroy(rig);
}

/* Three cubes are one file. */
static void test_meshes_are_shared(void** state) {
    (void)state;
    asset a;
    make_asset(&a);
    a.desc.formats = DM_GLTF_RIG_URDF | DM_GLTF_RIG_MJCF | DM_GLTF_RIG_SDF | DM_GLTF_RIG_USDA | DM_GLTF_RIG_TSCN;
    dm_gltf_rig* rig = make(&a);
    assert_int_equal(dm_gltf_rig_file_count(rig), 2 + 5);
    assert_non_null(strstr(text_of(rig, "meshes/mesh_1_frame.obj"), "\nf 1 2 4\n"));
    const char* mjcf = text_of(rig, "rigged.xml");
    int uses = 0;
    for (const char* at = mjcf; (at = strstr(at, "mesh=\"mesh_1_frame\"")) != NULL; at++) uses++;
    assert_int_equal(uses, 3);
    dm_gltf_rig_destroy(rig);
    make_asset(&a);
    a.desc.formats = DM_GLTF_RIG_USDA; /* has its meshes in itself */
    rig = make(&a);
    assert_int_equal(dm_gltf_rig_file_count(rig), 1);
    dm_gltf_rig_destroy(rig);
}

/* MuJoCo 3 refuses meshes without a volume. A corner of the square leaves its plane, by a millionth. */
static void test_flat_meshes_get_a_volume(void** state) {
    (void)state;
    asset a;
    make_asset(&a);
    dm_gltf_rig* rig = make(&a);
    double low = INFINITY, high = -INFINITY;
    for (const char* at = text_of(rig, "meshes/mesh_2_knob.obj"); (at = strstr(at, "\nv ")) != NULL; at += 3) {
        const double x = strtod(at + 3, NULL); /* the middle is that of all points, four of which are no corners */
        if (x > 0) continue;
        low = fmin(low, x);
        high = fmax(high, x);
    }
    assert_true(high - low > 1e-7 && high - low < 1e-5);
    dm_gltf_rig_destroy(rig);
}

/* Unreal's centimetres, left-handed and Z up. A positive angle turns left-handed there: the axis turns over. */
static void test_axes_and_units(void** state) {
    (void)state;
    asset a;
    double axis[3], at[3], range[1];
    make_asset(&a);
    a.desc.axes = DM_AXES_UNREAL;
    a.desc.unit_in_metres = 0.01f;
    a.joints[0].axis = (dm_vec3){0, 0, 1};
    a.joints[0].origin = (dm_vec3){100, 200, 300};
    dm_gltf_rig* rig = make(&a);
    const char* urdf = text_of(rig, "rigged.urdf");
    const char* joint = strstr(urdf, "<joint name=\"joint_1");
    read_after(joint, "<axis", "xyz", 3, axis);
    read_after(joint, "<origin", "xyz", 3, at);
    assert_near(axis, (double[]){0, 0, -1}, 3);
    assert_near(at, (double[]){1, -2, 3}, 3);
    read_after(strstr(urdf, "<joint name=\"joint_2"), "<limit", "upper", 1, range);
    assert_near(range, (double[]){0.015}, 1);
    dm_gltf_rig_destroy(rig);
}

static void test_what_formats_cannot_hold(void** state) {
    (void)state;
    asset a;
    double range[2];
    make_asset(&a);
    a.joints[0].type = DM_JOINT_SCREW;
    a.joints[0].pitch = 0.25f;
    a.joints[1].upper = 0;
    a.desc.formats = DM_GLTF_RIG_URDF | DM_GLTF_RIG_MJCF | DM_GLTF_RIG_SDF;
    dm_gltf_rig* rig = make(&a);
    assert_non_null(strstr(a.said, "joint_1_door_1: URDF has no screws"));
    assert_non_null(strstr(a.said, "joint_2_Schublade: it slides without limits"));
    assert_null(strstr(a.said, "MJCF"));
    assert_non_null(strstr(text_of(rig, "rigged.xml"), "polycoef=\"0 0.25 0 0 0\""));
    assert_non_null(strstr(text_of(rig, "rigged.sdf"), "<thread_pitch>-4</thread_pitch>"));
    read_after(strstr(text_of(rig, "rigged.urdf"), "joint_2_Schublade"), "<limit", "lower", 1, &range[0]);
    assert_near(range, (double[]){-7}, 1); /* the asset's size */
    dm_gltf_rig_destroy(rig);
}

/* A German host writes 0,5. */
static void test_a_locale_changes_nothing(void** state) {
    (void)state;
    asset a;
    if (system("mkdir -p build/locale && localedef -i de_DE -f UTF-8 build/locale/de_DE.UTF-8") != 0) skip();
    setenv("LOCPATH", "build/locale", 1);
    make_asset(&a);
    dm_gltf_rig* plain = make(&a);
    assert_non_null(setlocale(LC_ALL, "de_DE.UTF-8"));
    dm_gltf_rig* other = make(&a);
    setlocale(LC_ALL, "C");
    assert_string_equal(text_of(plain, "rigged.urdf"), text_of(other, "rigged.urdf"));
    dm_gltf_rig_destroy(plain);
    dm_gltf_rig_destroy(other);
}

/* ---- errors ---- */

static void refuse(asset* a, dm_result code) {
    dm_gltf_rig* rig = (dm_gltf_rig*)a;
    const dm_result result = dm_gltf_rig_make(&a->desc, &rig);
    if (result != code) fail_msg("result %d, not %d: %s", result, code, a->said);
    assert_null(rig);
    make_asset(a);
}

static void test_what_is_refused(void** state) {
    (void)state;
    asset a;
    make_asset(&a);
    dm_gltf_rig* rig;
    assert_int_equal(dm_gltf_rig_make(NULL, &rig), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_rig_make(&a.desc, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_rig_file_count(NULL), 0);
    dm_gltf_rig_destroy(NULL);
    a.desc.struct_size--, refuse(&a, DM_ERROR_STRUCT_SIZE);
    a.desc.formats = 0, refuse(&a, DM_ERROR_INVALID_ARGUMENT);
    a.desc.formats = 1u << 31, refuse(&a, DM_ERROR_INVALID_ARGUMENT);
    a.desc.formats = DM_GLTF_RIG_GLB, refuse(&a, DM_ERROR_INVALID_ARGUMENT); /* without a file */
    a.desc.nodes = NULL, refuse(&a, DM_ERROR_INVALID_ARGUMENT);
    a.desc.joints = NULL, refuse(&a, DM_ERROR_INVALID_ARGUMENT);
    a.desc.axes = DM_AXES_CUSTOM, refuse(&a, DM_ERROR_INVALID_ARGUMENT);
    a.desc.unit_in_metres = NAN, refuse(&a, DM_ERROR_INVALID_ARGUMENT);
    a.desc.density = INFINITY, refuse(&a, DM_ERROR_NOT_FINITE);
    a.desc.thickness = -1, refuse(&a, DM_ERROR_INVALID_ARGUMENT);
    a.desc.name = "\xff", refuse(&a, DM_ERROR_INVALID_ARGUMENT);
    a.nodes[1].name = "\xc3", refuse(&a, DM_ERROR_INVALID_ARGUMENT);
    a.nodes[1].struct_size = 8, refuse(&a, DM_ERROR_STRUCT_SIZE);
    a.transforms[2][3] = NAN, refuse(&a, DM_ERROR_NOT_FINITE);
    a.node_parts[1] = PARTS, refuse(&a, DM_ERROR_INDEX_OUT_OF_RANGE);
    a.parts[0].parent = PARTS, refuse(&a, DM_ERROR_INDEX_OUT_OF_RANGE);
    a.parts[0].parent = 2, refuse(&a, DM_ERROR_INVALID_ARGUMENT); /* a circle */
    a.joints[1].lower = NAN, refuse(&a, DM_ERROR_NOT_FINITE);
    for (int i = 0; i < NODES; i++) a.nodes[i].mesh = NULL;
    refuse(&a, DM_ERROR_DEGENERATE_MESH);
    const dm_mesh_desc broken = {.struct_size = sizeof broken, .vertex_count = 3};
    a.nodes[2].mesh = &broken, refuse(&a, DM_ERROR_INVALID_ARGUMENT);
    rig = make(&a);
    dm_gltf_rig_file file;
    assert_int_equal(dm_gltf_rig_get_file(rig, dm_gltf_rig_file_count(rig), &file), DM_ERROR_NOT_FOUND);
    assert_int_equal(dm_gltf_rig_get_file(rig, 0, NULL), DM_ERROR_INVALID_ARGUMENT);
    dm_gltf_rig_destroy(rig);
}

typedef struct counted {
    int64_t held, left; /* blocks that are out, allocations until one fails */
} counted;

static void* DM_CALL allocate(void* user, size_t size, size_t alignment) {
    counted* c = user;
    if (c->left-- == 0) return NULL;
    c->held++;
    return aligned_alloc(alignment < 16 ? 16 : alignment, (size + 63) / 64 * 64);
}

static void DM_CALL release(void* user, void* memory, size_t size) {
    (void)size;
    ((counted*)user)->held--;
    free(memory);
}

static void test_no_memory(void** state) {
    (void)state;
    asset a;
    dm_result result = DM_ERROR_OUT_OF_MEMORY;
    for (int64_t i = 0; result == DM_ERROR_OUT_OF_MEMORY; i++) {
        counted memory = {.left = i};
        dm_gltf_rig* rig = NULL;
        make_asset(&a);
        a.desc.formats = DM_GLTF_RIG_URDF | DM_GLTF_RIG_USDA;
        a.desc.allocator = (dm_allocator){&memory, allocate, release};
        result = dm_gltf_rig_make(&a.desc, &rig);
        if (result != DM_OK && a.said[0] == 0) fail_msg("allocation %d fails without a word", (int)i);
        dm_gltf_rig_destroy(rig);
        assert_int_equal(memory.held, 0);
        assert_true(i < 1000);
    }
    assert_int_equal(result, DM_OK);
}

/* ---- GLB ---- */

/* Gives the asset a file with its nodes. */
static dm_gltf* open_file(asset* a) {
    static float points[NODES][8][3];
    dm_gltf_part parts[NODES];
    void* data;
    size_t size;
    uint32_t count;
    dm_gltf* gltf;
    for (int n = 0; n < NODES; n++) {
        for (int i = 0; i < 8; i++)
            for (int k = 0; k < 3; k++) points[n][i][k] = cube[i][k] + a->transforms[n][12 + k];
        parts[n] = (dm_gltf_part){.name = a->nodes[n].name,
                                  .positions = &points[n][0][0],
                                  .indices = &sides[0][0],
                                  .vertex_count = 8,
                                  .index_count = 36,
                                  .colour = {1, 1, 1, 1}};
    }
    assert_int_equal(dm_gltf_write(parts, NODES, NULL, NULL, &data, &size), DM_OK);
    const dm_gltf_desc desc = {.struct_size = sizeof desc, .data = data, .size = size};
    assert_int_equal(dm_gltf_open(&desc, &gltf), DM_OK);
    assert_int_equal(dm_gltf_get_asset(gltf, 0, &a->desc.nodes, &count), DM_OK);
    assert_int_equal(count, NODES);
    a->desc.gltf = gltf;
    free(data);
    return gltf;
}

/* What the reader says of the joint of the part that was `name`; NULL: none. */
static const dm_joint* find_joint(dm_gltf* gltf, const char* name) {
    const dm_asset_node* nodes;
    uint32_t count;
    assert_int_equal(dm_gltf_get_asset(gltf, 0, &nodes, &count), DM_OK);
    for (uint32_t i = 0; i < count; i++)
        if (nodes[i].joint != NULL && strncmp(nodes[i].name, name, strlen(name)) == 0) return nodes[i].joint;
    return NULL;
}

static void assert_same_joint(const dm_joint* found, const dm_joint* wanted) {
    assert_non_null(found);
    assert_int_equal(found->type, wanted->type);
    const double a[8] = {(double)found->axis.x,   (double)found->axis.y,   (double)found->axis.z,
                         (double)found->origin.x, (double)found->origin.y, (double)found->origin.z,
                         (double)found->lower,    (double)found->upper};
    const double b[8] = {(double)wanted->axis.x,   (double)wanted->axis.y,   (double)wanted->axis.z,
                         (double)wanted->origin.x, (double)wanted->origin.y, (double)wanted->origin.z,
                         (double)wanted->lower,    (double)wanted->upper};
    assert_near(a, b, 8);
}

/* Our own reader gives the same joints, from `extras` and, where these are hidden from it, from the physics. */
static void test_the_glb_states_the_joints(void** state) {
    (void)state;
    static const char extras[] = "\"dragmesh\":{\"type\"";
    asset a;
    make_asset(&a);
    a.joints[0].axis = (dm_vec3){0.6f, 0, -0.8f};
    a.joints[0].lower = -0.25f;
    dm_gltf* gltf = open_file(&a);
    a.desc.formats = DM_GLTF_RIG_GLB;
    dm_gltf_rig* rig = make(&a);
    dm_gltf_rig_file file;
    assert_int_equal(dm_gltf_rig_file_count(rig), 1);
    dm_gltf_rig_get_file(rig, 0, &file);
    char* bytes = malloc(file.size);
    memcpy(bytes, file.data, file.size);
    for (int hidden = 0; hidden < 2; hidden++) {
        dm_gltf* again;
        const dm_gltf_desc desc = {.struct_size = sizeof desc, .data = bytes, .size = file.size};
        assert_int_equal(dm_gltf_open(&desc, &again), DM_OK);
        assert_same_joint(find_joint(again, "part_1"), &a.joints[0]);
        assert_same_joint(find_joint(again, "part_2"), &a.joints[1]);
        dm_gltf_close(again);
        int found = 0;
        for (size_t i = 0; i + sizeof extras <= file.size; i++)
            if (memcmp(bytes + i, extras, sizeof extras - 1) == 0) bytes[i + 1] = 'D', found++;
        assert_int_equal(found, hidden == 0 ? 2 : 0);
    }
    free(bytes);
    dm_gltf_rig_destroy(rig);
    dm_gltf_close(gltf);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_masses),
        cmocka_unit_test(test_fixed_parts_are_one_with_what_carries_them),
        cmocka_unit_test(test_meshes_are_shared),
        cmocka_unit_test(test_flat_meshes_get_a_volume),
        cmocka_unit_test(test_axes_and_units),
        cmocka_unit_test(test_what_formats_cannot_hold),
        cmocka_unit_test(test_a_locale_changes_nothing),
        cmocka_unit_test(test_what_is_refused),
        cmocka_unit_test(test_no_memory),
        cmocka_unit_test(test_the_glb_states_the_joints),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
