/* Prints MJCF, in nested bodies. A screw is a hinge and a slide that an equality couples. A free part is a body of the
 * world. */
#include "export/rig_formats.h"

static void put_heading(const dmi_rig_model* model, dmi_text* out) {
    dmi_text_put(
        out,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<mujoco model=\"%s\">\n"
        "  <compiler angle=\"radian\" meshdir=\"" DMI_RIG_MESHES "\"/>\n"
        "  <default>\n    <!-- bodies of the asset meet others, and not each other -->\n"
        "    <default class=\"collision\"><geom type=\"box\" contype=\"1\" conaffinity=\"0\" group=\"3\"/></default>\n"
        "    <default class=\"visual\"><geom type=\"mesh\" contype=\"0\" conaffinity=\"0\" group=\"1\"/></default>\n"
        "  </default>\n  <asset>\n",
        model->name);
    for (uint32_t i = 0; i < model->mesh_count; i++)
        dmi_text_put(out, "    <mesh name=\"%s\" file=\"%s.obj\"/>\n", model->meshes[i].name, model->meshes[i].name);
    dmi_text_put(out, "  </asset>\n");
}

static void put_original_names(const dmi_rig_model* model, dmi_text* out) {
    bool any = false;
    for (uint32_t b = 1; b < model->body_count; b++) {
        if (!model->bodies[b].original[0]) continue;
        dmi_text_put(out, "%s    <text name=\"%s\" data=\"", any ? "" : "  <custom>\n", model->bodies[b].name);
        dmi_text_put_xml(out, model->bodies[b].original);
        dmi_text_put(out, "\"/>\n");
        any = true;
    }
    if (any) dmi_text_put(out, "  </custom>\n");
}

static void put_joint_as(const dmi_rig_body* body, const char* suffix, bool slides, bool limited, dmi_text* out) {
    dmi_text_put(out, "      <joint name=\"%s%s\" type=\"%s\" axis=\"%s\" limited=\"%s\"", body->joint_name, suffix,
                 slides ? "slide" : "hinge", dmi_digits3(body->axis, " ").text, limited ? "true" : "false");
    if (limited) dmi_text_put(out, " range=\"%s %s\"", dmi_digits(body->lower).text, dmi_digits(body->upper).text);
    dmi_text_put(out, " damping=\"%s\" frictionloss=\"%s\"/>\n", dmi_digits(body->damping).text,
                 dmi_digits(body->friction).text);
}

static void put_joint(const dmi_rig_body* body, dmi_text* out) {
    if (body->kind == DMI_RIG_FREE) dmi_text_put(out, "      <freejoint name=\"%s\"/>\n", body->joint_name);
    if (body->kind == DMI_RIG_SLIDE || dmi_rig_turns(body))
        put_joint_as(body, "", body->kind == DMI_RIG_SLIDE, body->limited, out);
    if (body->kind == DMI_RIG_SCREW) put_joint_as(body, "_way", true, false, out);
}

static void put_content(const dmi_rig_model* model, const dmi_rig_body* body, dmi_text* out) {
    const double(*m)[3] = body->inertia;
    dmi_text_put(out, "      <inertial pos=\"%s\" mass=\"%s\" fullinertia=\"%s %s %s %s %s %s\"/>\n",
                 dmi_digits3(body->centre, " ").text, dmi_digits(body->mass).text, dmi_digits(m[0][0]).text,
                 dmi_digits(m[1][1]).text, dmi_digits(m[2][2]).text, dmi_digits(m[0][1]).text, dmi_digits(m[0][2]).text,
                 dmi_digits(m[1][2]).text);
    put_joint(body, out);
    for (uint32_t i = 0; i < body->shape_count; i++) {
        const dmi_rig_shape* shape = &model->shapes[body->first_shape + i];
        const float* c = shape->colour;
        dmi_text_put(out, "      <geom class=\"visual\" mesh=\"%s\" pos=\"%s\" rgba=\"%s %s %s %s\"/>\n",
                     model->meshes[shape->mesh].name, dmi_digits3(shape->place, " ").text,
                     dmi_digits_of_float(c[0]).text, dmi_digits_of_float(c[1]).text, dmi_digits_of_float(c[2]).text,
                     dmi_digits_of_float(c[3]).text);
    }
    for (uint32_t i = 0; i < body->box_count; i++) {
        const dmi_rig_box* box = &model->boxes[body->first_box + i];
        dmi_text_put(out, "      <geom class=\"collision\" pos=\"%s\" size=\"%s\"/>\n",
                     dmi_digits3(box->centre, " ").text, dmi_digits3(box->half, " ").text);
    }
}

/* Prints a body with all that it carries, except what is free. */
static void put_body(const dmi_rig_model* model, uint32_t index, dmi_text* out) {
    const dmi_rig_body* body = &model->bodies[index];
    const double* place = body->kind == DMI_RIG_FREE ? body->origin : body->place;
    dmi_text_put(out, "    <body name=\"%s\" pos=\"%s\">\n", body->name, dmi_digits3(place, " ").text);
    put_content(model, body, out);
    for (uint32_t b = index + 1; b < model->body_count; b++)
        if (model->bodies[b].parent == index && model->bodies[b].kind != DMI_RIG_FREE) put_body(model, b, out);
    dmi_text_put(out, "    </body>\n");
}

static void put_screws(const dmi_rig_model* model, dmi_text* out) {
    bool any = false;
    for (uint32_t b = 0; b < model->body_count; b++) {
        const dmi_rig_body* body = &model->bodies[b];
        if (body->kind != DMI_RIG_SCREW) continue;
        dmi_text_put(out, "%s    <joint joint1=\"%s_way\" joint2=\"%s\" polycoef=\"0 %s 0 0 0\"/>\n",
                     any ? "" : "  <equality>\n", body->joint_name, body->joint_name, dmi_digits(body->pitch).text);
        any = true;
    }
    if (any) dmi_text_put(out, "  </equality>\n");
}

void dmi_rig_print_mjcf(const dmi_rig_model* model, dmi_text* out) {
    put_heading(model, out);
    put_original_names(model, out);
    dmi_text_put(out, "  <worldbody>\n");
    for (uint32_t b = 0; b < model->body_count; b++)
        if (b == 0 || model->bodies[b].kind == DMI_RIG_FREE) put_body(model, b, out);
    dmi_text_put(out, "  </worldbody>\n");
    put_screws(model, out);
    dmi_text_put(out, "</mujoco>\n");
}
