/* Animations of a glTF file as clips: what moves a node against the one above it, whatever keys and frames say it. */
#include <math.h>
#include <stdio.h>

#include "assets/body_hints.h"
#include "test_gltf_nodes.h"

#define QUARTER 0.70710678f

/* Keys. A cubic key has the tangent into it, itself, the tangent out of it. */
typedef struct bin {
    float triangle[3][3], times[2], turn[2][4], way[2][3], spline[6][3], growth[2][3], falling[2];
} bin;

static const bin usual = {.triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                          .times = {0.5f, 2},
                          .turn = {{0, 0, 0, 1}, {0, QUARTER, 0, QUARTER}},
                          .way = {{2, 0, 0}, {2, 0, 0.5f}},
                          .spline = {{0, 0, 0}, {2, 0, 0}, {0, 0, 3}, {0, 0, 0}, {2, 0, 0}, {0, 0, 0}},
                          .growth = {{1, 1, 1}, {1, 2, 1}},
                          .falling = {1, 0}};

#define VIEW(offset, bytes) ",{\"buffer\":0,\"byteOffset\":" #offset ",\"byteLength\":" #bytes "}"
#define ACCESSOR(view, count, type)                                                                                    \
    ",{\"bufferView\":" #view ",\"componentType\":5126,\"count\":" #count ",\"type\":\"" type "\"}"
enum { TRIANGLE, TIMES, TURN, WAY, SPLINE, GROWTH, FALLING };
#define HEAD                                                                                                           \
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":204}],\"bufferViews\":[{\"buffer\":0,"              \
    "\"byteLength\":36}" VIEW(36, 8) VIEW(44, 32) VIEW(76, 24) VIEW(100, 72) VIEW(172, 24)                             \
        VIEW(196, 8) "],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":"                 \
                     "\"VEC3\"}" ACCESSOR(1, 2, "SCALAR") ACCESSOR(2, 2, "VEC4") ACCESSOR(3, 2, "VEC3")                \
                         ACCESSOR(4, 6, "VEC3") ACCESSOR(5, 2, "VEC3") ACCESSOR(                                       \
                             6, 2, "SCALAR") "],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
#define CHANNEL(node, path) "{\"sampler\":0,\"target\":{\"node\":" #node ",\"path\":\"" path "\"}}"
#define ANIMATION(channels, input, output, rest)                                                                       \
    "{\"name\":\"open\",\"channels\":[" channels "],\"samplers\":[{\"input\":" #input ",\"output\":" #output rest "}]" \
    "}"

static void open_file(test_gltf_nodes* o, const char* json, const bin* from) {
    test_gltf_nodes_open(o, json, from, sizeof *from);
}

static const dm_asset_node* node_of(const test_gltf_nodes* o, const char* name) {
    return &o->nodes[test_gltf_nodes_find(o, name)];
}

static void expect_near(float got, double want, const char* what) {
    if (!(fabs((double)got - want) < 1e-4)) fail_msg("%s: %g, not %g", what, (double)got, want);
}

/* Expects the joint of a node's clips. origin NULL: any. */
static void expect_joint(const dm_asset_node* node, int32_t type, const double axis[3], const double origin[3],
                         double upper) {
    const float centre[3] = {node->pivot->origin.x, node->pivot->origin.y, node->pivot->origin.z};
    const dmi_clip_joint found = dmi_clip_find_joint(node->clips, node->clip_count, centre, 2);
    assert_true(found.is_found);
    assert_int_equal(found.left_out, 0);
    assert_int_equal(found.joint.type, type);
    expect_near(found.joint.axis.x, axis[0], "axis x");
    expect_near(found.joint.axis.y, axis[1], "axis y");
    expect_near(found.joint.axis.z, axis[2], "axis z");
    expect_near(found.joint.lower, 0, "lower");
    expect_near(found.joint.upper, upper, "upper");
    expect_near(found.duration, 1.5, "duration");
    if (!origin) return;
    expect_near(found.joint.origin.x, origin[0], "origin x");
    expect_near(found.joint.origin.y, origin[1], "origin y");
    expect_near(found.joint.origin.z, origin[2], "origin z");
}

static void keys_of_each_kind(void** state) {
    (void)state;
    static const struct {
        const char* animation;
        int32_t type;
        double axis[3], upper;
    } cases[] = {
        {ANIMATION(CHANNEL(1, "rotation"), 1, 2, ""), DM_JOINT_REVOLUTE, {0, 1, 0}, 1.5707963},
        {ANIMATION(CHANNEL(1, "translation"), 1, 3, ""), DM_JOINT_PRISMATIC, {0, 0, 1}, 0.5},
        {ANIMATION(CHANNEL(1, "translation"), 1, 3, ",\"interpolation\":\"STEP\""), DM_JOINT_PRISMATIC, {0, 0, 1}, 0.5},
        {ANIMATION(CHANNEL(1, "rotation"), 1, 2, ",\"interpolation\":\"LINEAR\""),
         DM_JOINT_REVOLUTE,
         {0, 1, 0},
         1.5707963},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char json[4096];
        test_gltf_nodes o;
        snprintf(json, sizeof json,
                 HEAD "\"animations\":[%s],\"nodes\":[{\"name\":\"body\",\"mesh\":0},{\"name\":\"door\",\"mesh\":0,"
                      "\"translation\":[2,0,0]}]}",
                 cases[i].animation);
        open_file(&o, json, &usual);
        const dm_asset_node* door = node_of(&o, "door");
        assert_int_equal(door->clip_count, 1);
        assert_string_equal(door->clips->name, "open");
        assert_int_equal(door->clips->key_count, 2);
        assert_int_equal(node_of(&o, "body")->clip_count, 0);
        const double at[3] = {2, 0, 0};
        expect_joint(door, cases[i].type, cases[i].axis, at, cases[i].upper);
        test_gltf_nodes_close(&o);
    }
}

/* A spline that leaves its place and comes back between two keys: t (1 - t)^2 of 3 x 1.5 s, at most at 1/3. */
static void splines_bend_between_keys(void** state) {
    (void)state;
    test_gltf_nodes o;
    open_file(
        &o,
        HEAD "\"animations\":[" ANIMATION(CHANNEL(0, "translation"), 1, 4,
                                          ",\"interpolation\":\"CUBICSPLINE\"") "],\"nodes\":[{\"name\":\"door\","
                                                                                "\"mesh\":0,\"translation\":[2,0,0]}]}",
        &usual);
    const dm_asset_clip* clip = node_of(&o, "door")->clips;
    assert_int_equal(clip->key_count, 9);
    for (uint32_t k = 0; k < 9; k++) {
        const double t = k / 8.0;
        expect_near(clip->times[k], 0.5 + 1.5 * t, "time");
        expect_near(2 * clip->poses[k].dual[2], 4.5 * t * (1 - t) * (1 - t), "way");
    }
    test_gltf_nodes_close(&o);
}

/* Frames above: turned, scaled, mirrored, moved far; a node given as a matrix. */
static void frames_above_carry_the_joint(void** state) {
    (void)state;
    static const struct {
        const char *above, *own;
        double axis[3], origin[3], upper;
    } cases[] = {
        {"\"rotation\":[0.70710678,0,0,0.70710678]", "\"translation\":[2,0,0]", {0, 0, 1}, {2, 0, 0}, 1.5707963},
        {"\"scale\":[100,100,100]", "\"translation\":[0.02,0,0]", {0, 1, 0}, {2, 0, 0}, 1.5707963},
        {"\"scale\":[-1,1,1]", "\"translation\":[2,0,0]", {0, -1, 0}, {-2, 0, 0}, 1.5707963},
        {"\"translation\":[0,3,1]", "\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,2,0,0,1]", {0, 1, 0}, {2, 3, 1}, 1.5707963},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char json[4096];
        test_gltf_nodes o;
        snprintf(json, sizeof json,
                 HEAD "\"animations\":[" ANIMATION(
                     CHANNEL(1, "rotation"), 1, 2,
                     "") "],\"nodes\":[{\"children\":[1],%s},{\"name\":\"door\",\"mesh\":0,%s}]}",
                 cases[i].above, cases[i].own);
        open_file(&o, json, &usual);
        const dm_asset_node* door = node_of(&o, "door");
        assert_int_equal(door->clips->flags, 0);
        expect_joint(door, DM_JOINT_REVOLUTE, cases[i].axis, cases[i].origin, cases[i].upper);
        test_gltf_nodes_close(&o);
    }
}

static void far_files_have_their_own_origin(void** state) {
    (void)state;
    test_gltf_nodes o;
    double origin[3];
    open_file(&o,
              HEAD "\"animations\":[" ANIMATION(
                  CHANNEL(1, "rotation"), 1, 2,
                  "") "],\"nodes\":[{\"children\":[1],\"translation\":[90000,0,0]},{\"name\":\"door\",\"mesh\":0}]}",
              &usual);
    dm_gltf_get_origin(o.gltf, origin);
    assert_true(origin[0] > 80000);
    const double at[3] = {90000 - origin[0], 0 - origin[1], 0 - origin[2]}, axis[3] = {0, 1, 0};
    expect_joint(node_of(&o, "door"), DM_JOINT_REVOLUTE, axis, at, 1.5707963);
    test_gltf_nodes_close(&o);
}

/* A drawer in a door that turns: it slides along the door's own z, and the handle on it says nothing. */
static void what_is_carried_moves_against_its_carrier(void** state) {
    (void)state;
    test_gltf_nodes o;
    open_file(&o,
              HEAD "\"animations\":[" ANIMATION(CHANNEL(0, "rotation"), 1, 2, "") "," ANIMATION(
                  CHANNEL(1, "translation"), 1, 3,
                  "") "],\"nodes\":["
                      "{\"name\":\"door\",\"children\":[1]},{\"name\":\"drawer\",\"mesh\":0,\"children\":[2],"
                      "\"translation\":[2,0,0]},{\"name\":\"handle\",\"mesh\":0}]}",
              &usual);
    const double up[3] = {0, 1, 0}, out[3] = {0, 0, 1}, zero[3] = {0, 0, 0};
    expect_joint(node_of(&o, "door"), DM_JOINT_REVOLUTE, up, zero, 1.5707963);
    expect_joint(node_of(&o, "drawer"), DM_JOINT_PRISMATIC, out, NULL, 0.5);
    assert_int_equal(node_of(&o, "handle")->clip_count, 0);
    test_gltf_nodes_close(&o);
}

/* A bone has the triangles of its skin, which move as it does. */
static void bones_have_clips_too(void** state) {
    (void)state;
    struct {
        bin keys;
        float weights[3][4];
        uint8_t joints[3][4];
    } skinned = {.keys = usual, .weights = {{1}, {1}, {1}}, .joints = {{0}}};
    const test_glb glb = test_glb_pack(
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":264}],\"bufferViews\":[{\"buffer\":0,"
        "\"byteLength\":36}" VIEW(36, 8) VIEW(44, 32) VIEW(204, 48)
            VIEW(252, 12) "],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":"
                          "\"VEC3\"}" ACCESSOR(1, 2, "SCALAR") ACCESSOR(2, 2, "VEC4")
                              ACCESSOR(3, 3, "VEC4") ",{\"bufferView\":4,\"componentType\":5121,\"count\":3,\"type\":"
                                                     "\"VEC4\"}],\"meshes\":[{\"primitives\":[{"
                                                     "\"attributes\":{\"POSITION\":0,\"WEIGHTS_0\":3,\"JOINTS_0\":4}}]}"
                                                     "],\"skins\":[{\"joints\":[1]}],"
                                                     "\"animations\":[" ANIMATION(
                                                         CHANNEL(1, "rotation"), 1, 2,
                                                         "") "],\"nodes\":[{\"mesh\":0,\"skin\":0},"
                                                             "{\"name\":\"bone\",\"translation\":[2,0,0]}]}",
        &skinned, sizeof skinned);
    test_gltf_nodes o = {.count = 0};
    test_env_open(&o.t, TEST_NEVER);
    o.gltf = test_gltf_open(&o.t, glb.data, glb.size);
    free(glb.data);
    assert_int_equal(dm_gltf_get_asset(o.gltf, 0, &o.nodes, &o.count), DM_OK);
    const double up[3] = {0, 1, 0}, at[3] = {2, 0, 0};
    expect_joint(node_of(&o, "bone"), DM_JOINT_REVOLUTE, up, at, 1.5707963);
    assert_non_null(node_of(&o, "bone")->mesh);
    test_gltf_nodes_close(&o);
}

static void what_grows_is_not_rigid(void** state) {
    (void)state;
    test_gltf_nodes o;
    open_file(&o,
              HEAD "\"animations\":[" ANIMATION(CHANNEL(0, "scale"), 1, 5,
                                                "") "],\"nodes\":[{\"name\":\"door\",\"mesh\":0}]}",
              &usual);
    assert_int_equal(node_of(&o, "door")->clip_count, 1);
    assert_int_equal(node_of(&o, "door")->clips->flags, DM_CLIP_NOT_RIGID);
    test_gltf_nodes_close(&o);
}

static void what_can_not_be_read_is_left_out(void** state) {
    (void)state;
    static const struct {
        const char *animation, *says;
    } cases[] = {
        {ANIMATION(CHANNEL(0, "rotation"), 1, 3, ""), "2 keys have 2 values of 3 numbers"},
        {ANIMATION(CHANNEL(0, "translation"), 6, 3, ""), "animation 0 'open': its times do not rise"},
        {ANIMATION(CHANNEL(0, "translation"), 1, 4, ""), "2 keys have 6 values of 3 numbers"},
        {ANIMATION(CHANNEL(0, "translation"), 1, 9, ""), "accessor 9 does not exist"},
        {ANIMATION(CHANNEL(9, "translation"), 1, 3, ""), NULL},
        {ANIMATION(CHANNEL(0, "weights"), 1, 1, ""), NULL},
        {ANIMATION("7", 1, 1, ""), NULL},
        {"{\"channels\":[" CHANNEL(0, "rotation") "]}", "sampler 0 does not exist"},
        {"7", NULL},
        {ANIMATION(CHANNEL(0, "rotation"), 1, 2, ""), ""}, /* says what it says */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char json[4096];
        test_gltf_nodes o;
        snprintf(json, sizeof json, HEAD "\"animations\":[%s],\"nodes\":[{\"name\":\"door\",\"mesh\":0}]}",
                 cases[i].animation);
        open_file(&o, json, &usual);
        assert_int_equal(node_of(&o, "door")->clip_count, cases[i].says && !cases[i].says[0]);
        if (cases[i].says && !strstr(o.t.messages.text, cases[i].says))
            fail_msg("'%s' lacks '%s'", o.t.messages.text, cases[i].says);
        test_gltf_nodes_close(&o);
    }
}

static void several_animations_are_several_clips(void** state) {
    (void)state;
    test_gltf_nodes o;
    open_file(&o,
              HEAD "\"animations\":[" ANIMATION(CHANNEL(0, "rotation"), 1, 2, "") "," ANIMATION(
                  CHANNEL(0, "translation"), 1, 3,
                  "") "," ANIMATION(CHANNEL(0, "rotation"), 1, 2,
                                    "") "],\"nodes\":[{\"name\":\"door\",\"mesh\":0,\"translation\":[2,0,0]}]}",
              &usual);
    const dm_asset_node* door = node_of(&o, "door");
    assert_int_equal(door->clip_count, 3);
    assert_memory_equal(door->clips[0].poses, door->clips[2].poses, 2 * sizeof(dm_pose));
    test_gltf_nodes_close(&o);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(keys_of_each_kind),
        cmocka_unit_test(splines_bend_between_keys),
        cmocka_unit_test(frames_above_carry_the_joint),
        cmocka_unit_test(far_files_have_their_own_origin),
        cmocka_unit_test(what_is_carried_moves_against_its_carrier),
        cmocka_unit_test(bones_have_clips_too),
        cmocka_unit_test(what_grows_is_not_rigid),
        cmocka_unit_test(what_can_not_be_read_is_left_out),
        cmocka_unit_test(several_animations_are_several_clips),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
