/* Prints URDF: links, and joints whose frames are those of the child links. It has no screws. */
#include "export/rig_formats.h"

static void put_inertial(const dmi_rig_body* body, dmi_text* out) {
    const double(*m)[3] = body->inertia;
    dmi_text_put(out, "    <inertial>\n      <origin xyz=\"%s\" rpy=\"0 0 0\"/>\n      <mass value=\"%s\"/>\n",
                 dmi_digits3(body->centre, " ").text, dmi_digits(body->mass).text);
    dmi_text_put(
        out, "      <inertia ixx=\"%s\" ixy=\"%s\" ixz=\"%s\" iyy=\"%s\" iyz=\"%s\" izz=\"%s\"/>\n    </inertial>\n",
        dmi_digits(m[0][0]).text, dmi_digits(m[0][1]).text, dmi_digits(m[0][2]).text, dmi_digits(m[1][1]).text,
        dmi_digits(m[1][2]).text, dmi_digits(m[2][2]).text);
}

static void put_shape(const dmi_rig_model* model, uint32_t index, dmi_text* out) {
    const dmi_rig_shape* shape = &model->shapes[index];
    const float* c = shape->colour;
    dmi_text_put(
        out,
        "    <visual>\n      <origin xyz=\"%s\" rpy=\"0 0 0\"/>\n      <geometry><mesh filename=\"" DMI_RIG_MESHES
        "%s.obj\"/></geometry>\n",
        dmi_digits3(shape->place, " ").text, model->meshes[shape->mesh].name);
    dmi_text_put(out, "      <material name=\"colour_%u\"><color rgba=\"%s %s %s %s\"/></material>\n    </visual>\n",
                 index + 1, dmi_digits_of_float(c[0]).text, dmi_digits_of_float(c[1]).text,
                 dmi_digits_of_float(c[2]).text, dmi_digits_of_float(c[3]).text);
}

static void put_box(const dmi_rig_box* box, dmi_text* out) {
    const double sides[3] = {2 * box->half[0], 2 * box->half[1], 2 * box->half[2]};
    dmi_text_put(
        out,
        "    <collision>\n      <origin xyz=\"%s\" rpy=\"0 0 0\"/>\n      <geometry><box size=\"%s\"/></geometry>\n"
        "    </collision>\n",
        dmi_digits3(box->centre, " ").text, dmi_digits3(sides, " ").text);
}

static void put_link(const dmi_rig_model* model, const dmi_rig_body* body, dmi_text* out) {
    dmi_text_put(out, "  <link name=\"%s\">\n", body->name);
    put_inertial(body, out);
    for (uint32_t i = 0; i < body->shape_count; i++) put_shape(model, body->first_shape + i, out);
    for (uint32_t i = 0; i < body->box_count; i++) put_box(&model->boxes[body->first_box + i], out);
    dmi_text_put(out, "  </link>\n");
}

static const char* type_of(const dmi_rig_body* body) {
    if (body->kind == DMI_RIG_FREE) return "floating";
    if (body->kind == DMI_RIG_SLIDE) return "prismatic";
    return body->limited ? "revolute" : "continuous";
}

static void put_joint(const dmi_rig_model* model, const dmi_rig_body* body, dmi_text* out) {
    dmi_text_put(out, "  <joint name=\"%s\" type=\"%s\">\n", body->joint_name, type_of(body));
    if (body->original[0]) {
        dmi_text_put(out, "    <dragmesh name=\"");
        dmi_text_put_xml(out, body->original);
        dmi_text_put(out, "\"/>\n");
    }
    dmi_text_put(out, "    <parent link=\"%s\"/>\n    <child link=\"%s\"/>\n    <origin xyz=\"%s\" rpy=\"0 0 0\"/>\n",
                 model->bodies[body->parent].name, body->name, dmi_digits3(body->place, " ").text);
    if (body->kind != DMI_RIG_FREE) {
        dmi_text_put(out, "    <axis xyz=\"%s\"/>\n    <limit", dmi_digits3(body->axis, " ").text);
        if (body->limited)
            dmi_text_put(out, " lower=\"%s\" upper=\"%s\"", dmi_digits(body->lower).text, dmi_digits(body->upper).text);
        dmi_text_put(out, " effort=\"%s\" velocity=\"%s\"/>\n    <dynamics damping=\"%s\" friction=\"%s\"/>\n",
                     dmi_digits(DMI_RIG_EFFORT).text, dmi_digits(DMI_RIG_VELOCITY).text, dmi_digits(body->damping).text,
                     dmi_digits(body->friction).text);
    }
    dmi_text_put(out, "  </joint>\n");
}

/* The words to MuJoCo stand where it looks for them. Others skip them. */
void dmi_rig_print_urdf(const dmi_rig_model* model, dmi_text* out) {
    dmi_text_put(out,
                 "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<robot name=\"%s\">\n"
                 "  <mujoco><compiler meshdir=\"" DMI_RIG_MESHES
                 "\" strippath=\"true\" discardvisual=\"false\"/></mujoco>\n",
                 model->name);
    for (uint32_t b = 0; b < model->body_count; b++) put_link(model, &model->bodies[b], out);
    for (uint32_t b = 1; b < model->body_count; b++) put_joint(model, &model->bodies[b], out);
    dmi_text_put(out, "</robot>\n");
}
