/* Prints USD as text, with UsdPhysics. Meshes are prims of their own, which bodies refer to. It has no screws, and
 * joints have neither friction nor damping of their own except by a drive. */
#include <math.h>

#include "export/rig_formats.h"
#include "math/elementary.h"

static const double degrees = 57.29577951308232; /* a radian */

static void put_extent(const dmi_rig_mesh* mesh, dmi_text* out) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = 0; i < mesh->point_count; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = dmi_fmin(low[k], (double)mesh->points[i][k]);
            high[k] = dmi_fmax(high[k], (double)mesh->points[i][k]);
        }
    dmi_text_put(out, "        float3[] extent = [(%s), (%s)]\n", dmi_digits3(low, ", ").text,
                 dmi_digits3(high, ", ").text);
}

static void put_mesh(const dmi_rig_mesh* mesh, dmi_text* out) {
    dmi_text_put(out, "    def Mesh \"%s\"\n    {\n        uniform token subdivisionScheme = \"none\"\n", mesh->name);
    put_extent(mesh, out);
    dmi_text_put(out, "        point3f[] points = [");
    for (uint32_t i = 0; i < mesh->point_count; i++)
        dmi_text_put(out, "%s(%s, %s, %s)", i > 0 ? ", " : "", dmi_digits_of_float(mesh->points[i][0]).text,
                     dmi_digits_of_float(mesh->points[i][1]).text, dmi_digits_of_float(mesh->points[i][2]).text);
    dmi_text_put(out, "]\n        int[] faceVertexCounts = [");
    for (uint32_t f = 0; f < mesh->face_count; f++) dmi_text_put(out, "%s3", f > 0 ? ", " : "");
    dmi_text_put(out, "]\n        int[] faceVertexIndices = [");
    for (uint32_t f = 0; f < mesh->face_count; f++)
        dmi_text_put(out, "%s%u, %u, %u", f > 0 ? ", " : "", mesh->faces[f][0], mesh->faces[f][1], mesh->faces[f][2]);
    dmi_text_put(out, "]\n    }\n");
}

static void put_place(const double place[3], const char* indent, dmi_text* out) {
    dmi_text_put(out, "%sdouble3 xformOp:translate = (%s)\n%suniform token[] xformOpOrder = [\"xformOp:translate\"]\n",
                 indent, dmi_digits3(place, ", ").text, indent);
}

static void put_shape(const dmi_rig_model* model, uint32_t index, dmi_text* out) {
    const dmi_rig_shape* shape = &model->shapes[index];
    const float* c = shape->colour;
    dmi_text_put(
        out,
        "        def Mesh \"visual_%u\" (\n            prepend references = </%s/Meshes/%s>\n        )\n        {\n",
        index + 1, model->name, model->meshes[shape->mesh].name);
    dmi_text_put(out,
                 "            color3f[] primvars:displayColor = [(%s, %s, %s)]\n            float[] "
                 "primvars:displayOpacity = [%s]\n",
                 dmi_digits_of_float(c[0]).text, dmi_digits_of_float(c[1]).text, dmi_digits_of_float(c[2]).text,
                 dmi_digits_of_float(c[3]).text);
    put_place(shape->place, "            ", out);
    dmi_text_put(out, "        }\n");
}

/* Prints a cube of side 2, scaled. */
static void put_box(const dmi_rig_model* model, uint32_t index, dmi_text* out) {
    const dmi_rig_box* box = &model->boxes[index];
    dmi_text_put(
        out,
        "        def Cube \"collision_%u\" (\n            prepend apiSchemas = [\"PhysicsCollisionAPI\"]\n        )\n"
        "        {\n            double size = 2\n            uniform token purpose = \"guide\"\n"
        "            double3 xformOp:translate = (%s)\n            double3 xformOp:scale = (%s)\n"
        "            uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:scale\"]\n        }\n",
        index + 1, dmi_digits3(box->centre, ", ").text, dmi_digits3(box->half, ", ").text);
}

/* Prints the inertia as three moments about axes that a quaternion, w first, turns to. */
static void put_mass(const dmi_rig_body* body, dmi_text* out) {
    double moments[3], turn[4];
    dmi_rig_principal(body, moments, turn);
    dmi_text_put(out, "        float physics:mass = %s\n        point3f physics:centerOfMass = (%s)\n",
                 dmi_digits(body->mass).text, dmi_digits3(body->centre, ", ").text);
    dmi_text_put(out, "        float3 physics:diagonalInertia = (%s)\n        quatf physics:principalAxes = (%s, %s)\n",
                 dmi_digits3(moments, ", ").text, dmi_digits(turn[3]).text, dmi_digits3(turn, ", ").text);
}

static void put_body(const dmi_rig_model* model, const dmi_rig_body* body, dmi_text* out) {
    dmi_text_put(out,
                 "    def Xform \"%s\" (\n        prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]\n",
                 body->name);
    if (body->original[0]) {
        dmi_text_put(out, "        customData = {\n            string dragmesh_name = \"");
        dmi_text_put_quoted(out, body->original);
        dmi_text_put(out, "\"\n        }\n");
    }
    dmi_text_put(out, "    )\n    {\n");
    put_mass(body, out);
    put_place(body->origin, "        ", out);
    for (uint32_t i = 0; i < body->shape_count; i++) put_shape(model, body->first_shape + i, out);
    for (uint32_t i = 0; i < body->box_count; i++) put_box(model, body->first_box + i, out);
    dmi_text_put(out, "    }\n");
}

/* Prints a joint. Its x axis is that of the line: the turn that takes x there, on both sides, since the axes of all
 * bodies are the same at rest. */
static void put_joint(const dmi_rig_model* model, const dmi_rig_body* body, dmi_text* out) {
    static const double here[3] = {0, 0, 0};
    double turn[4];
    const bool slides = body->kind == DMI_RIG_SLIDE;
    const char *type = slides ? "Prismatic" : "Revolute", *drive = slides ? "linear" : "angular";
    const double unit = slides ? 1 : degrees;
    dmi_rig_turn_to_axis(body->axis, turn);
    dmi_text_put(
        out, "    def Physics%sJoint \"%s\" (\n        prepend apiSchemas = [\"PhysicsDriveAPI:%s\"]\n    )\n    {\n",
        type, body->joint_name, drive);
    dmi_text_put(out,
                 "        rel physics:body0 = </%s/%s>\n        rel physics:body1 = </%s/%s>\n        uniform token "
                 "physics:axis = \"X\"\n",
                 model->name, model->bodies[body->parent].name, model->name, body->name);
    dmi_text_put(out, "        point3f physics:localPos0 = (%s)\n        point3f physics:localPos1 = (%s)\n",
                 dmi_digits3(body->place, ", ").text, dmi_digits3(here, ", ").text);
    for (int side = 0; side < 2; side++)
        dmi_text_put(out, "        quatf physics:localRot%d = (%s, %s)\n", side, dmi_digits(turn[3]).text,
                     dmi_digits3(turn, ", ").text);
    if (body->limited)
        dmi_text_put(out, "        float physics:lowerLimit = %s\n        float physics:upperLimit = %s\n",
                     dmi_digits(unit * body->lower).text, dmi_digits(unit * body->upper).text);
    dmi_text_put(out,
                 "        float drive:%s:physics:damping = %s\n        float drive:%s:physics:maxForce = %s\n    }\n",
                 drive, dmi_digits(body->damping / unit).text, drive, dmi_digits(DMI_RIG_EFFORT).text);
}

void dmi_rig_print_usda(const dmi_rig_model* model, dmi_text* out) {
    dmi_text_put(out,
                 "#usda 1.0\n(\n    defaultPrim = \"%s\"\n    upAxis = \"Z\"\n    metersPerUnit = 1\n    "
                 "kilogramsPerUnit = 1\n)\n\n"
                 "def Xform \"%s\" (\n    prepend apiSchemas = [\"PhysicsArticulationRootAPI\"]\n    kind = "
                 "\"component\"\n)\n{\n",
                 model->name, model->name);
    dmi_text_put(out, "    class \"Meshes\"\n    {\n");
    for (uint32_t m = 0; m < model->mesh_count; m++) put_mesh(&model->meshes[m], out);
    dmi_text_put(out, "    }\n");
    for (uint32_t b = 0; b < model->body_count; b++) put_body(model, &model->bodies[b], out);
    dmi_text_put(out, "    def PhysicsFixedJoint \"joint_world\"\n    {\n        rel physics:body1 = </%s/%s>\n    }\n",
                 model->name, model->bodies[0].name);
    for (uint32_t b = 1; b < model->body_count; b++)
        if (model->bodies[b].kind != DMI_RIG_FREE) put_joint(model, &model->bodies[b], out);
    dmi_text_put(out, "}\n");
}
