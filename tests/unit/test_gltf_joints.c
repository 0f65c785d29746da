/* Joints that a glTF file states: in extras, and by KHR_physics_rigid_bodies. */
#include <math.h>
#include <stdio.h>

#include "test_gltf_nodes.h"

static const float triangle[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

#define HEAD                                                                                                           \
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36}],\"bufferViews\":[{\"buffer\":0,"               \
    "\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"     \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"

static void open_file(test_gltf_nodes* o, const char* json) {
    test_gltf_nodes_open(o, json, triangle, sizeof triangle);
}

static const dm_joint* joint_of(const test_gltf_nodes* o, const char* name) {
    return o->nodes[test_gltf_nodes_find(o, name)].joint;
}

/* What is expected of a joint. */
typedef struct wanted {
    int32_t type;
    float axis[3], origin[3], lower, upper, pitch;
} wanted;

static void expect_near(float got, float want, const char* what) {
    if (!(fabsf(got - want) < 1e-5f)) fail_msg("%s: %g, not %g", what, (double)got, (double)want);
}

static void expect_joint(const dm_joint* got, const wanted* want) {
    assert_non_null(got);
    assert_int_equal(got->struct_size, sizeof *got);
    assert_int_equal(got->type, want->type);
    assert_int_equal(got->source, DM_JOINT_FROM_HOST);
    assert_true(got->type_confidence == 1 && got->joint_confidence == 1);
    expect_near(got->axis.x, want->axis[0], "axis x");
    expect_near(got->axis.y, want->axis[1], "axis y");
    expect_near(got->axis.z, want->axis[2], "axis z");
    expect_near(got->origin.x, want->origin[0], "origin x");
    expect_near(got->origin.y, want->origin[1], "origin y");
    expect_near(got->origin.z, want->origin[2], "origin z");
    expect_near(got->lower, want->lower, "lower");
    expect_near(got->upper, want->upper, "upper");
    expect_near(got->pitch, want->pitch, "pitch");
}

/* ---- extras ---- */

#define AXIS "\"axis\":[0,2,0]"
#define LIMITS "\"lower\":-0.5,\"upper\":2"

static void extras_are_in_the_nodes_frame(void** state) {
    (void)state;
    static const struct {
        const char *node, *extras;
        wanted want;
    } cases[] = {
        {"\"translation\":[3,0,0]",
         "\"dragmesh_joint\":{\"type\":\"revolute\"," AXIS ",\"origin\":[1,0,0]," LIMITS "}",
         {DM_JOINT_REVOLUTE, {0, 1, 0}, {4, 0, 0}, -0.5f, 2, 0}},
        {"\"translation\":[3,0,0]",
         "\"dragmesh_joint\":{\"type\":\"continuous\"," AXIS "}",
         {DM_JOINT_CONTINUOUS, {0, 1, 0}, {3, 0, 0}, 0, 0, 0}},
        {"\"rotation\":[0.70710678,0,0,0.70710678]",
         "\"dragmesh_joint\":{\"type\":\"revolute\"," AXIS "," LIMITS "}",
         {DM_JOINT_REVOLUTE, {0, 0, 1}, {0, 0, 0}, -0.5f, 2, 0}},
        {"\"scale\":[1,10,1]",
         "\"dragmesh_joint\":{\"type\":\"prismatic\"," AXIS "," LIMITS "}",
         {DM_JOINT_PRISMATIC, {0, 1, 0}, {0, 0, 0}, -5, 20, 0}},
        {"\"scale\":[1,10,1]",
         "\"dragmesh_joint\":{\"type\":\"screw\"," AXIS "," LIMITS ",\"pitch\":0.1}",
         {DM_JOINT_SCREW, {0, 1, 0}, {0, 0, 0}, -0.5f, 2, 1}},
        {"\"scale\":[-1,1,1]",
         "\"dragmesh_joint\":{\"type\":\"screw\"," AXIS "," LIMITS ",\"pitch\":0.1}",
         {DM_JOINT_SCREW, {0, -1, 0}, {0, 0, 0}, -0.5f, 2, -0.1f}},
        {"\"scale\":[-1,1,1]",
         "\"dragmesh_joint\":{\"type\":\"prismatic\",\"axis\":[1,0,0]," LIMITS "}",
         {DM_JOINT_PRISMATIC, {-1, 0, 0}, {0, 0, 0}, -0.5f, 2, 0}},
        {"\"translation\":[3,0,0]",
         "\"dragmesh_joint\":{\"type\":\"fixed\"}",
         {DM_JOINT_FIXED, {1, 0, 0}, {3, 0, 0}, 0, 0, 0}},
        /* as the web page writes it: in the frame of the scene */
        {"\"translation\":[3,0,0]",
         "\"dragmesh\":{\"type\":\"revolute\"," AXIS ",\"origin\":[1,0,0]," LIMITS "}",
         {DM_JOINT_REVOLUTE, {0, 1, 0}, {1, 0, 0}, -0.5f, 2, 0}},
        /* as the add-on for Blender does: in Blender's frame, z up */
        {"\"translation\":[3,0,0]",
         "\"dragmesh_type\":\"revolute\",\"dragmesh_axis\":[0,0,1],\"dragmesh_origin\":[1,2,3],\"dragmesh_lower\":-0.5,"
         "\"dragmesh_upper\":2",
         {DM_JOINT_REVOLUTE, {0, 1, 0}, {1, 3, -2}, -0.5f, 2, 0}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char json[2048];
        test_gltf_nodes o;
        snprintf(json, sizeof json, HEAD "\"nodes\":[{\"mesh\":0},{\"name\":\"door\",\"mesh\":0,%s,\"extras\":{%s}}]}",
                 cases[i].node, cases[i].extras);
        open_file(&o, json);
        assert_null(o.nodes[0].joint);
        expect_joint(joint_of(&o, "door"), &cases[i].want);
        assert_int_equal(o.t.messages.count, 0);
        test_gltf_nodes_close(&o);
    }
}

static void extras_that_can_not_be_read_are_said(void** state) {
    (void)state;
    static const char* const extras[] = {"{\"dragmesh_joint\":{\"type\":\"hinge\"," AXIS "}}",
                                         "{\"dragmesh_joint\":{\"type\":\"revolute\"}}",
                                         "{\"dragmesh_joint\":{\"type\":\"revolute\",\"axis\":[0,0,0]}}",
                                         "{\"dragmesh_joint\":{\"type\":\"revolute\",\"axis\":[0,1]}}",
                                         "{\"dragmesh_joint\":{\"type\":\"revolute\"," AXIS ",\"lower\":1}}",
                                         "{\"dragmesh_joint\":{\"type\":\"revolute\"," AXIS ",\"upper\":1e300}}"};
    static const char* const others[] = {"{\"dragmesh_joint\":7}", "[]", "\"dragmesh\"", "{\"type\":\"revolute\"}"};
    char json[2048];
    test_gltf_nodes o;
    for (size_t i = 0; i < sizeof extras / sizeof *extras; i++) {
        snprintf(json, sizeof json, HEAD "\"nodes\":[{\"name\":\"door\",\"mesh\":0,\"extras\":%s}]}", extras[i]);
        open_file(&o, json);
        assert_null(joint_of(&o, "door"));
        assert_non_null(strstr(o.t.messages.text, "glTF node 0 'door': the joint of its extras can't be read"));
        test_gltf_nodes_close(&o);
    }
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        snprintf(json, sizeof json, HEAD "\"nodes\":[{\"name\":\"door\",\"mesh\":0,\"extras\":%s}]}", others[i]);
        open_file(&o, json);
        assert_null(joint_of(&o, "door"));
        assert_int_equal(o.t.messages.count, 0);
        test_gltf_nodes_close(&o);
    }
}

/* ---- KHR_physics_rigid_bodies ---- */

#define LOCK_PLACE "{\"linearAxes\":[0,1,2],\"min\":0,\"max\":0}"
#define LOCK_TURN "{\"angularAxes\":[0,1,2],\"min\":0,\"max\":0}"
/* A cabinet, a door with a motion that hangs at x = 2, the frame of its hinge, and that of the hinge on the cabinet. */
#define PHYSICS(limits, cabinet, of_door, of_cabinet)                                                                  \
    HEAD "\"extensions\":{\"KHR_physics_rigid_bodies\":{\"physicsJoints\":[{\"limits\":[" limits "]}]}},\"nodes\":["   \
         "{\"name\":\"cabinet\",\"mesh\":0,\"children\":[3]" cabinet                                                   \
         "},{\"name\":\"door\",\"mesh\":0,\"children\":[2],"                                                           \
         "\"translation\":[2,0,0],\"extensions\":{\"KHR_physics_rigid_bodies\":{\"motion\":{}}}},{\"name\":"           \
         "\"hinge\"" of_door "},{\"translation\":[2,0,0]" of_cabinet "}]}"
#define JOINT(connected)                                                                                               \
    ",\"extensions\":{\"KHR_physics_rigid_bodies\":{\"joint\":{\"joint\":0,\"connectedNode\":" #connected "}}}"
#define TURN LOCK_PLACE ",{\"angularAxes\":[0,2],\"min\":0,\"max\":0}"

static void physics_joints_of_one_axis(void** state) {
    (void)state;
    static const struct {
        const char* json;
        wanted want;
    } cases[] = {
        /* the door's frame holds the joint: it goes the other way than the cabinet in its frame */
        {PHYSICS(TURN ",{\"angularAxes\":[1],\"min\":-0.5,\"max\":2}", "", JOINT(3), ""),
         {DM_JOINT_REVOLUTE, {0, -1, 0}, {2, 0, 0}, -0.5f, 2, 0}},
        /* the cabinet's does */
        {PHYSICS(TURN ",{\"angularAxes\":[1],\"min\":-0.5,\"max\":2}", "", "", JOINT(2)),
         {DM_JOINT_REVOLUTE, {0, 1, 0}, {2, 0, 0}, -0.5f, 2, 0}},
        {PHYSICS(TURN, "", "", JOINT(2)), {DM_JOINT_CONTINUOUS, {0, 1, 0}, {2, 0, 0}, 0, 0, 0}},
        {PHYSICS(LOCK_TURN ",{\"linearAxes\":[0,1],\"min\":0,\"max\":0},{\"linearAxes\":[2],\"min\":0,\"max\":0.4}", "",
                 "", JOINT(2)),
         {DM_JOINT_PRISMATIC, {0, 0, 1}, {2, 0, 0}, 0, 0.4f, 0}},
        /* a door that stands open by 0.5 rad in the file */
        {PHYSICS(TURN ",{\"angularAxes\":[1],\"min\":0,\"max\":2}", "", ",\"rotation\":[0,0.24740396,0,0.96891242]",
                 JOINT(2)),
         {DM_JOINT_REVOLUTE, {0, 1, 0}, {2, 0, 0}, -0.5f, 1.5f, 0}},
        {PHYSICS(LOCK_TURN ",{\"linearAxes\":[0],\"min\":0.25,\"max\":0.75},{\"linearAxes\":[1,2],\"max\":0}", "",
                 ",\"translation\":[0.5,0,0]", JOINT(2)),
         {DM_JOINT_PRISMATIC, {1, 0, 0}, {2, 0, 0}, -0.25f, 0.25f, 0}},
        {PHYSICS(LOCK_PLACE "," LOCK_TURN, "", "", JOINT(2)), {DM_JOINT_FIXED, {1, 0, 0}, {2, 0, 0}, 0, 0, 0}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        test_gltf_nodes o;
        open_file(&o, cases[i].json);
        if (o.t.messages.count > 0) fail_msg("case %zu: %s", i, o.t.messages.text);
        expect_joint(joint_of(&o, "door"), &cases[i].want);
        assert_null(joint_of(&o, "cabinet"));
        test_gltf_nodes_close(&o);
    }
}

static void other_physics_joints_are_said(void** state) {
    (void)state;
    static const char* const cases[] = {
        PHYSICS(LOCK_PLACE, "", "", JOINT(2)),                                                  /* a ball */
        PHYSICS("", "", "", JOINT(2)),                                                          /* free */
        PHYSICS(TURN ",{\"angularAxes\":[1],\"min\":2,\"max\":1}", "", "", JOINT(2)),           /* no range */
        PHYSICS(TURN ",{\"angularAxes\":[3],\"min\":0,\"max\":1}", "", "", JOINT(2)),           /* no axis */
        PHYSICS("{\"linearAxes\":[0,1,2],\"min\":0,\"max\":0.1}," LOCK_TURN, "", "", JOINT(2)), /* a rope */
        PHYSICS(TURN, "", "", JOINT(9)),                                                        /* to nothing */
        PHYSICS(TURN, "", "", JOINT(0)),                                                        /* of one body */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        test_gltf_nodes o;
        open_file(&o, cases[i]);
        if (joint_of(&o, "door")) fail_msg("case %zu has a joint", i);
        if (!strstr(o.t.messages.text, "its physics joint has not one axis alone; left out"))
            fail_msg("case %zu: '%s'", i, o.t.messages.text);
        test_gltf_nodes_close(&o);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(extras_are_in_the_nodes_frame),
        cmocka_unit_test(extras_that_can_not_be_read_are_said),
        cmocka_unit_test(physics_joints_of_one_axis),
        cmocka_unit_test(other_physics_joints_are_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
