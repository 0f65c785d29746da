/* Prints Godot 4's scenes as text. Meshes are the OBJ files beside it. All bodies stand side by side below a node that
 * turns Z up into Godot's Y up, since physics moves them in the world. Godot has no screws. */
#include "export/rig_formats.h"

static void put_transform(const double place[3], dmi_text* out) {
    dmi_text_put(out, "transform = Transform3D(1, 0, 0, 0, 1, 0, 0, 0, 1, %s)\n", dmi_digits3(place, ", ").text);
}

/* Prints the meshes, a material a shape and a box a box. */
static void put_resources(const dmi_rig_model* model, dmi_text* out) {
    for (uint32_t m = 0; m < model->mesh_count; m++)
        dmi_text_put(out, "[ext_resource type=\"ArrayMesh\" path=\"" DMI_RIG_MESHES "%s.obj\" id=\"mesh_%u\"]\n",
                     model->meshes[m].name, m + 1);
    for (uint32_t i = 0; i < model->shape_count; i++) {
        const float* c = model->shapes[i].colour;
        dmi_text_put(
            out,
            "\n[sub_resource type=\"StandardMaterial3D\" id=\"material_%u\"]\n%salbedo_color = Color(%s, %s, %s, %s)\n",
            i + 1, c[3] < 1 ? "transparency = 1\n" : "", dmi_digits_of_float(c[0]).text, dmi_digits_of_float(c[1]).text,
            dmi_digits_of_float(c[2]).text, dmi_digits_of_float(c[3]).text);
    }
    for (uint32_t i = 0; i < model->box_count; i++) {
        const double* half = model->boxes[i].half;
        const double sides[3] = {2 * half[0], 2 * half[1], 2 * half[2]};
        dmi_text_put(out, "\n[sub_resource type=\"BoxShape3D\" id=\"box_%u\"]\nsize = Vector3(%s)\n", i + 1,
                     dmi_digits3(sides, ", ").text);
    }
}

/* Prints a body. Its moments of inertia are about its own axes, because Godot takes no others. */
static void put_body(const dmi_rig_model* model, const dmi_rig_body* body, dmi_text* out) {
    const bool stays = body->kind == DMI_RIG_ROOT;
    const double moments[3] = {body->inertia[0][0], body->inertia[1][1], body->inertia[2][2]};
    dmi_text_put(out, "\n[node name=\"%s\" type=\"%s\" parent=\".\"]\n", body->name,
                 stays ? "StaticBody3D" : "RigidBody3D");
    put_transform(body->origin, out);
    if (!stays)
        dmi_text_put(out, "mass = %s\ncenter_of_mass_mode = 1\ncenter_of_mass = Vector3(%s)\ninertia = Vector3(%s)\n",
                     dmi_digits(body->mass).text, dmi_digits3(body->centre, ", ").text,
                     dmi_digits3(moments, ", ").text);
    if (body->original[0]) {
        dmi_text_put(out, "metadata/dragmesh_name = \"");
        dmi_text_put_quoted(out, body->original);
        dmi_text_put(out, "\"\n");
    }
    for (uint32_t i = body->first_shape; i < body->first_shape + body->shape_count; i++) {
        dmi_text_put(out, "\n[node name=\"visual_%u\" type=\"MeshInstance3D\" parent=\"%s\"]\n", i + 1, body->name);
        put_transform(model->shapes[i].place, out);
        dmi_text_put(out,
                     "mesh = ExtResource(\"mesh_%u\")\nsurface_material_override/0 = SubResource(\"material_%u\")\n",
                     model->shapes[i].mesh + 1, i + 1);
    }
    for (uint32_t i = body->first_box; i < body->first_box + body->box_count; i++) {
        dmi_text_put(out, "\n[node name=\"collision_%u\" type=\"CollisionShape3D\" parent=\"%s\"]\n", i + 1,
                     body->name);
        put_transform(model->boxes[i].centre, out);
        dmi_text_put(out, "shape = SubResource(\"box_%u\")\n", i + 1);
    }
}

/* Prints a joint. Godot's hinges turn about z of their node, its sliders slide along x. It counts a hinge's angle as
 * that of node_a seen from node_b, and a slider's way as that of node_b seen from node_a. */
static void put_joint(const dmi_rig_model* model, const dmi_rig_body* body, dmi_text* out) {
    const bool slides = body->kind == DMI_RIG_SLIDE;
    const char* carrier = model->bodies[body->parent].name;
    double frame[3][3];
    dmi_rig_joint_frame(body->axis, slides ? 0 : 2, frame);
    dmi_text_put(out, "\n[node name=\"%s\" type=\"%s\" parent=\".\"]\ntransform = Transform3D(", body->joint_name,
                 slides ? "SliderJoint3D" : "HingeJoint3D");
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++) dmi_text_put(out, "%s, ", dmi_digits(frame[column][row]).text);
    dmi_text_put(out, "%s)\nnode_a = NodePath(\"../%s\")\nnode_b = NodePath(\"../%s\")\n",
                 dmi_digits3(body->origin, ", ").text, slides ? carrier : body->name, slides ? body->name : carrier);
    if (slides)
        dmi_text_put(out, "linear_limit/upper_distance = %s\nlinear_limit/lower_distance = %s\n",
                     dmi_digits(body->upper).text, dmi_digits(body->lower).text);
    else if (body->limited)
        dmi_text_put(out, "angular_limit/enable = true\nangular_limit/upper = %s\nangular_limit/lower = %s\n",
                     dmi_digits(body->upper).text, dmi_digits(body->lower).text);
    dmi_text_put(out, "metadata/dragmesh_axis = Vector3(%s)\n", dmi_digits3(body->axis, ", ").text);
    if (body->kind == DMI_RIG_SCREW) dmi_text_put(out, "metadata/dragmesh_pitch = %s\n", dmi_digits(body->pitch).text);
}

void dmi_rig_print_tscn(const dmi_rig_model* model, dmi_text* out) {
    dmi_text_put(out, "[gd_scene load_steps=%u format=3]\n\n",
                 model->mesh_count + model->shape_count + model->box_count + 1);
    put_resources(model, out);
    dmi_text_put(out,
                 "\n[node name=\"%s\" type=\"Node3D\"]\ntransform = Transform3D(1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0)\n",
                 model->name);
    for (uint32_t b = 0; b < model->body_count; b++) put_body(model, &model->bodies[b], out);
    for (uint32_t b = 1; b < model->body_count; b++)
        if (model->bodies[b].kind != DMI_RIG_FREE) put_joint(model, &model->bodies[b], out);
}
