/* Prints SDF 1.7, which Gazebo 11 and all later ones read. Poses are relative to the link that carries. A free part has
 * no joint. */
#include "export/rig_formats.h"

static void put_inertial(const dmi_rig_body* body, dmi_text* out) {
    static const char* const names[3][3] = {{"ixx", "ixy", "ixz"}, {NULL, "iyy", "iyz"}, {NULL, NULL, "izz"}};
    dmi_text_put(out, "      <inertial>\n        <pose>%s 0 0 0</pose>\n        <mass>%s</mass>\n        <inertia>",
                 dmi_digits3(body->centre, " ").text, dmi_digits(body->mass).text);
    for (int i = 0; i < 3; i++)
        for (int j = i; j < 3; j++)
            dmi_text_put(out, "<%s>%s</%s>", names[i][j], dmi_digits(body->inertia[i][j]).text, names[i][j]);
    dmi_text_put(out, "</inertia>\n      </inertial>\n");
}

static void put_shape(const dmi_rig_model* model, uint32_t index, dmi_text* out) {
    const dmi_rig_shape* shape = &model->shapes[index];
    const float* c = shape->colour;
    dmi_text_put(out,
                 "      <visual name=\"visual_%u\">\n        <pose>%s 0 0 0</pose>\n"
                 "        <geometry><mesh><uri>" DMI_RIG_MESHES "%s.obj</uri></mesh></geometry>\n",
                 index + 1, dmi_digits3(shape->place, " ").text, model->meshes[shape->mesh].name);
    for (int i = 0; i < 2; i++)
        dmi_text_put(out, "        %s%s %s %s %s%s", i == 0 ? "<material><ambient>" : "<diffuse>",
                     dmi_digits_of_float(c[0]).text, dmi_digits_of_float(c[1]).text, dmi_digits_of_float(c[2]).text,
                     dmi_digits_of_float(c[3]).text, i == 0 ? "</ambient>\n" : "</diffuse></material>\n");
    dmi_text_put(out, "      </visual>\n");
}

static void put_box(const dmi_rig_model* model, uint32_t index, dmi_text* out) {
    const dmi_rig_box* box = &model->boxes[index];
    const double sides[3] = {2 * box->half[0], 2 * box->half[1], 2 * box->half[2]};
    dmi_text_put(out,
                 "      <collision name=\"collision_%u\">\n        <pose>%s 0 0 0</pose>\n"
                 "        <geometry><box><size>%s</size></box></geometry>\n      </collision>\n",
                 index + 1, dmi_digits3(box->centre, " ").text, dmi_digits3(sides, " ").text);
}

static void put_link(const dmi_rig_model* model, const dmi_rig_body* body, dmi_text* out) {
    dmi_text_put(out, "    <link name=\"%s\">\n", body->name);
    if (body->kind != DMI_RIG_ROOT)
        dmi_text_put(out, "      <pose relative_to=\"%s\">%s 0 0 0</pose>\n", model->bodies[body->parent].name,
                     dmi_digits3(body->place, " ").text);
    if (body->original[0]) {
        dmi_text_put(out, "      <dragmesh:name>");
        dmi_text_put_xml(out, body->original);
        dmi_text_put(out, "</dragmesh:name>\n");
    }
    put_inertial(body, out);
    for (uint32_t i = 0; i < body->shape_count; i++) put_shape(model, body->first_shape + i, out);
    for (uint32_t i = 0; i < body->box_count; i++) put_box(model, body->first_box + i, out);
    dmi_text_put(out, "    </link>\n");
}

static const char* type_of(const dmi_rig_body* body) {
    if (body->kind == DMI_RIG_SLIDE) return "prismatic";
    if (body->kind == DMI_RIG_SCREW) return "screw";
    return body->limited ? "revolute" : "continuous";
}

/* Prints a joint. A thread's pitch is in radians a metre here, positive where it is left-handed. */
static void put_joint(const dmi_rig_model* model, const dmi_rig_body* body, dmi_text* out) {
    dmi_text_put(out, "    <joint name=\"%s\" type=\"%s\">\n      <parent>%s</parent>\n      <child>%s</child>\n",
                 body->joint_name, type_of(body), model->bodies[body->parent].name, body->name);
    if (body->kind == DMI_RIG_SCREW && body->pitch != 0)
        dmi_text_put(out, "      <thread_pitch>%s</thread_pitch>\n", dmi_digits(-1 / body->pitch).text);
    dmi_text_put(out, "      <axis>\n        <xyz>%s</xyz>\n        <limit>", dmi_digits3(body->axis, " ").text);
    if (body->limited)
        dmi_text_put(out, "<lower>%s</lower><upper>%s</upper>", dmi_digits(body->lower).text,
                     dmi_digits(body->upper).text);
    dmi_text_put(
        out,
        "<effort>%s</effort><velocity>%s</velocity></limit>\n"
        "        <dynamics><damping>%s</damping><friction>%s</friction></dynamics>\n      </axis>\n    </joint>\n",
        dmi_digits(DMI_RIG_EFFORT).text, dmi_digits(DMI_RIG_VELOCITY).text, dmi_digits(body->damping).text,
        dmi_digits(body->friction).text);
}

void dmi_rig_print_sdf(const dmi_rig_model* model, dmi_text* out) {
    dmi_text_put(
        out,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<sdf version=\"1.7\" xmlns:dragmesh=\"https://github.com/dragmesh/dragmesh\">\n  <model name=\"%s\">\n",
        model->name);
    for (uint32_t b = 0; b < model->body_count; b++) put_link(model, &model->bodies[b], out);
    dmi_text_put(
        out,
        "    <joint name=\"joint_world\" type=\"fixed\">\n      <parent>world</parent>\n      <child>%s</child>\n"
        "    </joint>\n",
        model->bodies[0].name);
    for (uint32_t b = 1; b < model->body_count; b++)
        if (model->bodies[b].kind != DMI_RIG_FREE) put_joint(model, &model->bodies[b], out);
    dmi_text_put(out, "  </model>\n</sdf>\n");
}
