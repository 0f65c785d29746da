/* Names and pivots of a file's nodes. */
#include <math.h>

#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_glb.h"

static const float triangle[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/* A leaf in a turned group in a root; a node without a name in the root. */
static const char json[] =
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36}],"
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"nodes\":["
    "{\"name\":\"Cabinet\",\"translation\":[10,0,0],\"children\":[1,3]},"
    "{\"name\":\"T\xC3\xBCren\",\"rotation\":[0,0,0.70710678118654752,0.70710678118654752],\"children\":[2]},"
    "{\"name\":\"leaf\",\"mesh\":0,\"translation\":[2,0,0],\"scale\":[3,1,1]},"
    "{\"mesh\":0,\"translation\":[0,5,0]}]}";

typedef struct opened {
    test_env t;
    dm_gltf* gltf;
} opened;

static void open_json(opened* o, const char* text) {
    const test_glb glb = test_glb_pack(text, triangle, sizeof triangle);
    test_env_open(&o->t, TEST_NEVER);
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = glb.data,
                               .size = glb.size,
                               .allocator = test_allocator(&o->t.memory),
                               .log = test_log(&o->t.messages)};
    assert_int_equal(dm_gltf_open(&desc, &o->gltf), DM_OK);
    free(glb.data);
}

static void open_file(opened* o) {
    open_json(o, json);
}

static void close_file(opened* o) {
    dm_gltf_close(o->gltf);
    test_env_close(&o->t);
}

static void names_from_root_to_node(void** state) {
    (void)state;
    opened o;
    char label[64];
    open_file(&o);
    assert_int_equal(dm_gltf_get_hints(o.gltf, "leaf", label, sizeof label, NULL), DM_OK);
    assert_string_equal(label, "Cabinet/T\xC3\xBCren/leaf");
    assert_int_equal(dm_gltf_get_hints(o.gltf, "Cabinet", label, sizeof label, NULL), DM_OK);
    assert_string_equal(label, "Cabinet");
    assert_int_equal(dm_gltf_get_hints(o.gltf, "#3", label, sizeof label, NULL), DM_OK);
    assert_string_equal(label, "Cabinet");
    close_file(&o);
}

static void outer_names_give_way(void** state) {
    (void)state;
    opened o;
    char label[32];
    open_file(&o);
    assert_int_equal(dm_gltf_get_hints(o.gltf, "leaf", label, 12, NULL), DM_OK);
    assert_string_equal(label, "T\xC3\xBCren/leaf");
    assert_int_equal(dm_gltf_get_hints(o.gltf, "leaf", label, 5, NULL), DM_OK);
    assert_string_equal(label, "leaf");
    assert_int_equal(dm_gltf_get_hints(o.gltf, "leaf", label, 1, NULL), DM_OK);
    assert_string_equal(label, "");
    close_file(&o);
}

static void pivots_are_in_the_scene(void** state) {
    (void)state;
    opened o;
    dm_pivot pivot;
    open_file(&o);
    assert_int_equal(dm_gltf_get_hints(o.gltf, "leaf", NULL, 0, &pivot), DM_OK);
    const float origin[3] = {pivot.origin.x, pivot.origin.y, pivot.origin.z};
    const float want[3] = {10, 2, 0}, axes[9] = {0, 3, 0, -1, 0, 0, 0, 0, 1};
    for (int i = 0; i < 3; i++) assert_true(fabsf(origin[i] - want[i]) < 1e-5f);
    for (int i = 0; i < 9; i++) assert_true(fabsf(pivot.axes[i] - axes[i]) < 1e-5f);
    close_file(&o);
}

/* The triangle lies in the plane z = 0, where such a node leaves it. */
static void axes_that_no_float_holds_are_unknown(void** state) {
    (void)state;
    static const char huge[] =
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
        "\"nodes\":[{\"name\":\"a\",\"mesh\":0,\"scale\":[1,1,1e39]}]}";
    const dm_pivot none = {{0, 0, 0}, {0}};
    dm_pivot pivot;
    opened o;
    open_json(&o, huge);
    assert_int_equal(dm_gltf_get_hints(o.gltf, "a", NULL, 0, &pivot), DM_OK);
    assert_memory_equal(&pivot, &none, sizeof pivot);
    close_file(&o);
}

/* Nodes that all stand at one point have lost their pivots; those of `leaf` and the node without a name have not, nor
 * has a node alone. */
static void pivots_at_one_point_are_lost(void** state) {
    (void)state;
    static const char two_at_one_point[] =
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"nodes\":["
        "{\"translation\":[1,2,3],\"children\":[1,2]},{\"mesh\":0},{\"mesh\":0,\"rotation\":[0,1,0,0]}]}";
    static const char one[] =
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"nodes\":[{\"mesh\":0}]}";
    const char* const files[] = {json, two_at_one_point, one};
    static const int32_t lost[] = {0, 1, 0};
    for (int i = 0; i < 3; i++) {
        opened o;
        open_json(&o, files[i]);
        assert_int_equal(dm_gltf_pivots_are_lost(o.gltf), lost[i]);
        close_file(&o);
    }
    assert_int_equal(dm_gltf_pivots_are_lost(NULL), 0);
}

/* Opens a file of nodes that have one triangle, and returns the kind of one's pivot. */
static int32_t kind_of(const char* nodes, const char* name) {
    static const char before[] =
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"nodes\":[";
    char file[1024];
    int32_t kind = -1;
    opened o;
    snprintf(file, sizeof file, "%s%s]}", before, nodes);
    open_json(&o, file);
    assert_int_equal(dm_gltf_get_pivot_kind(o.gltf, name, &kind), DM_OK);
    close_file(&o);
    return kind;
}

/* Copies of one mesh stand at the same place of their boxes, whoever has put it there. */
static void copies_of_one_mesh_are_no_rule_and_one_point_is(void** state) {
    (void)state;
#define LEAF(name, x) "{\"name\":\"" name "\",\"mesh\":0,\"translation\":[" x ",0,0],\"scale\":[1,2,1]},"
    static const char apart[] = LEAF("a", "0") LEAF("b", "5") "{\"name\":\"group\",\"children\":[0,1]}";
    static const char there[] = LEAF("a", "5") LEAF("b", "5") "{\"name\":\"group\",\"children\":[0,1]}";
    static const char* const names[] = {"a", "b", "group"};
#undef LEAF
    for (int i = 0; i < 3; i++) {
        assert_int_equal(kind_of(apart, names[i]), DM_PIVOT_UNKNOWN);
        assert_int_equal(kind_of(there, names[i]), DM_PIVOT_DEFAULT);
    }
}

static void unknown_nodes_and_arguments(void** state) {
    (void)state;
    opened o;
    dm_pivot pivot;
    char label[8];
    open_file(&o);
    assert_int_equal(dm_gltf_get_hints(o.gltf, "drawer", label, sizeof label, &pivot), DM_ERROR_NOT_FOUND);
    assert_int_equal(dm_gltf_get_hints(o.gltf, "#4", label, sizeof label, &pivot), DM_ERROR_NOT_FOUND);
    assert_int_equal(dm_gltf_get_hints(o.gltf, "leaf", label, 0, &pivot), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_get_hints(o.gltf, NULL, NULL, 0, &pivot), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_get_hints(NULL, "leaf", NULL, 0, &pivot), DM_ERROR_INVALID_ARGUMENT);
    int32_t kind = 0;
    assert_int_equal(dm_gltf_get_pivot_kind(o.gltf, "drawer", &kind), DM_ERROR_NOT_FOUND);
    assert_int_equal(dm_gltf_get_pivot_kind(o.gltf, "leaf", NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_get_pivot_kind(NULL, "leaf", &kind), DM_ERROR_INVALID_ARGUMENT);
    close_file(&o);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_from_root_to_node),
        cmocka_unit_test(outer_names_give_way),
        cmocka_unit_test(pivots_are_in_the_scene),
        cmocka_unit_test(axes_that_no_float_holds_are_unknown),
        cmocka_unit_test(copies_of_one_mesh_are_no_rule_and_one_point_is),
        cmocka_unit_test(pivots_at_one_point_are_lost),
        cmocka_unit_test(unknown_nodes_and_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
