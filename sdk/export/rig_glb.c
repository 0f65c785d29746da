/* A scene with clips, as dm_gltf_export writes it, and what else is known of it: the joints in `extras`, and in
 * KHR_physics_rigid_bodies, whose boxes are KHR_implicit_shapes. What moves is selectable. Y up, units of the file.
 *
 *   <track of a part>      motion: mass and inertia
 *   ├ …                    what it carries
 *   ├ <part>_box_N         collider, a shape
 *   └ <joint>              joint: where the part is held, x against its axis; connected with
 *   <carrier>              the track of the part that carries it, or a node that stays
 *   └ <joint>_seat         the same place on the carrier
 *
 * What a clip of the file moves, with all that it carries, is left to that clip: its node gets the joint in `extras`,
 * and no body. The limits tell how the seat stands in the frame of the joint's node, which moves: the other way round.
 */
#include "export/rig_formats.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gltf/gltf_asset.h"
#include "gltf/gltf_edit.h"
#include "gltf/gltf_matrix.h"

#define PHYSICS "KHR_physics_rigid_bodies"
#define SHAPES "KHR_implicit_shapes"
#define SELECTABLE "KHR_node_selectability"

typedef struct writer {
    const dmi_rig_model* model;
    dm_gltf* scene;
    dmi_edit edit;
    dmi_edit_item* tracks; /* per body: its node; the root's is one that is added */
    cJSON *shapes, *joints;
    double origin[3]; /* origin of the asset frame in the scene */
} writer;

/* Turns Z up and metres into Y up and units of the file. */
static void put_y_up(const double z_up[3], double unit, double out[3]) {
    out[0] = z_up[0] / unit;
    out[1] = z_up[2] / unit;
    out[2] = -z_up[1] / unit;
}

/* Adds the turn from Z up to Y up, a quarter backwards about x, to a quaternion. */
static void turn_y_up(const double q[4], double out[4]) {
    static const double half = 0.70710678118654752; /* sine and cosine of an eighth of a turn */
    out[0] = half * (q[0] - q[3]);
    out[1] = half * (q[1] + q[2]);
    out[2] = half * (q[2] - q[1]);
    out[3] = half * (q[3] + q[0]);
}

static double unit_of(const writer* w) {
    return (double)w->model->axes.unit;
}

/* ---- nodes ---- */

/* Finds the node of a part that its file's clip moves. For one that goes along with such a part, it finds its first
 * node. */
static int32_t find_clip_node(const writer* w, uint32_t part) {
    const dm_gltf_rig_desc* desc = w->model->desc;
    uint32_t found = DM_ASSET_NO_NODE, number = 0;
    for (uint32_t n = desc->node_count; n-- > 0;) {
        if (desc->node_parts[n] != part) continue;
        if (found == DM_ASSET_NO_NODE || desc->nodes[n].clip_count > 0 || desc->nodes[found].clip_count == 0) found = n;
    }
    if (found == DM_ASSET_NO_NODE || dm_gltf_get_asset_node(desc->gltf, found, &number) != DM_OK) return -1;
    return (int32_t)number;
}

/* Finds the node of a body's track: the last one of its name, since tracks come behind all others. */
static int32_t find_track(const writer* w, const dmi_rig_body* body) {
    for (uint32_t i = w->scene->document.counts[DMI_GLTF_NODES]; i-- > 0;)
        if (strcmp(w->scene->tree[i].name, body->name) == 0) return (int32_t)i;
    return -1;
}

/* Adds a node below that of a body. place: in the body's frame, Z up, m. The track's own pivot need not be there. */
static dmi_edit_item add_node(writer* w, uint32_t body, const double place[3], const char* name) {
    const dmi_rig_body* b = &w->model->bodies[body];
    const dmi_edit_item node = dmi_edit_add(&w->edit, DMI_GLTF_NODES, NULL);
    double z_up[3], at[3];
    for (int k = 0; k < 3; k++) z_up[k] = b->origin[k] + place[k];
    put_y_up(z_up, unit_of(w), at);
    for (int k = 0; k < 3; k++) {
        at[k] += w->origin[k];
        if (b->kind != DMI_RIG_ROOT) at[k] -= w->scene->tree[w->tracks[body].index].world[DMI_GLTF_ORIGIN + k];
    }
    dmi_edit_text(&w->edit, node.json, "name", name);
    dmi_edit_numbers(&w->edit, node.json, "translation", at, 3);
    dmi_edit_append_number(&w->edit, dmi_edit_list(&w->edit, w->tracks[body].json, "children"), node.index);
    return node;
}

static cJSON* physics_of(writer* w, cJSON* object) {
    return dmi_edit_object(&w->edit, dmi_edit_object(&w->edit, object, "extensions"), PHYSICS);
}

/* ---- bodies ---- */

static void add_motion(writer* w, const dmi_rig_body* body, dmi_edit_item track) {
    dmi_edit* e = &w->edit;
    cJSON* motion = dmi_edit_object(e, physics_of(w, track.json), "motion");
    double moments[3], turn[4], centre[3], y_turn[4];
    const double unit = unit_of(w), squared = unit * unit;
    dmi_rig_principal(body, moments, turn);
    turn_y_up(turn, y_turn);
    for (int k = 0; k < 3; k++) moments[k] /= squared;
    double z_up[3];
    for (int k = 0; k < 3; k++) z_up[k] = body->origin[k] + body->centre[k];
    put_y_up(z_up, unit, centre);
    for (int k = 0; k < 3; k++) centre[k] += w->origin[k] - w->scene->tree[track.index].world[DMI_GLTF_ORIGIN + k];
    dmi_edit_number(e, motion, "mass", body->mass);
    dmi_edit_numbers(e, motion, "centerOfMass", centre, 3);
    dmi_edit_numbers(e, motion, "inertiaDiagonal", moments, 3);
    dmi_edit_numbers(e, motion, "inertiaOrientation", y_turn, 4); /* literal: a quaternion */
    cJSON* selectable = dmi_edit_object(e, dmi_edit_object(e, track.json, "extensions"), SELECTABLE);
    dmi_edit_set(e, selectable, "selectable", cJSON_CreateTrue());
}

static void add_box(writer* w, uint32_t body, uint32_t index) {
    dmi_edit* e = &w->edit;
    const dmi_rig_box* box = &w->model->boxes[w->model->bodies[body].first_box + index];
    char name[2 * DMI_RIG_NAME];
    const double unit = unit_of(w);
    const double sides[3] = {2 * box->half[0] / unit, 2 * box->half[2] / unit, 2 * box->half[1] / unit};
    snprintf(name, sizeof name, "%s_box_%u", w->model->bodies[body].name, index + 1);
    cJSON* shape = dmi_edit_new(e, cJSON_CreateObject());
    dmi_edit_text(e, shape, "type", "box");
    dmi_edit_numbers(e, dmi_edit_object(e, shape, "box"), "size", sides, 3);
    const int32_t number = cJSON_GetArraySize(w->shapes);
    dmi_edit_append(e, w->shapes, shape);
    const dmi_edit_item node = add_node(w, body, box->centre, name);
    cJSON* collider = dmi_edit_object(e, physics_of(w, node.json), "collider");
    dmi_edit_number(e, dmi_edit_object(e, collider, "geometry"), "shape", number);
    dmi_edit_number(e, collider, "collisionFilter", 0);
}

/* ---- joints ---- */

static cJSON* add_limit(writer* w, cJSON* limits, const char* axes, int first, int count) {
    cJSON* limit = dmi_edit_new(&w->edit, cJSON_CreateObject());
    cJSON* list = dmi_edit_list(&w->edit, limit, axes);
    for (int i = 0; i < count; i++) dmi_edit_append_number(&w->edit, list, first + i);
    dmi_edit_append(&w->edit, limits, limit);
    return limit;
}

static void set_bounds(writer* w, cJSON* limit, double lower, double upper) {
    dmi_edit_number(&w->edit, limit, "min", lower);
    dmi_edit_number(&w->edit, limit, "max", upper);
}

/* Adds the description of a joint. What the joint leaves free is its x axis: a way along it, or a turn about it. */
static int32_t add_description(writer* w, const dmi_rig_body* body) {
    dmi_edit* e = &w->edit;
    const bool slides = body->kind == DMI_RIG_SLIDE, limited = body->limited && !body->is_range_made;
    const char *free_axes = slides ? "linearAxes" : "angularAxes", *locked = slides ? "angularAxes" : "linearAxes";
    const double unit = slides ? unit_of(w) : 1, squared = unit_of(w) * unit_of(w);
    cJSON *joint = dmi_edit_new(e, cJSON_CreateObject()), *limits = dmi_edit_list(e, joint, "limits");
    set_bounds(w, add_limit(w, limits, locked, 0, 3), 0, 0);
    set_bounds(w, add_limit(w, limits, free_axes, 1, 2), 0, 0);
    if (limited) set_bounds(w, add_limit(w, limits, free_axes, 0, 1), body->lower / unit, body->upper / unit);
    if (body->damping > 0) {
        cJSON* drive = dmi_edit_new(e, cJSON_CreateObject());
        dmi_edit_text(e, drive, "type", slides ? "linear" : "angular");
        dmi_edit_text(e, drive, "mode", "force");
        dmi_edit_number(e, drive, "axis", 0);
        dmi_edit_number(e, drive, "velocityTarget", 0);
        dmi_edit_number(e, drive, "damping", slides ? body->damping : body->damping / squared);
        dmi_edit_append(e, dmi_edit_list(e, joint, "drives"), drive);
    }
    const int32_t number = cJSON_GetArraySize(w->joints);
    dmi_edit_append(e, w->joints, joint);
    return number;
}

static void add_joint(writer* w, uint32_t index) {
    const dmi_rig_body* body = &w->model->bodies[index];
    dmi_edit* e = &w->edit;
    static const double here[3] = {0, 0, 0};
    char name[2 * DMI_RIG_NAME];
    double axis[3], turn[4];
    put_y_up(body->axis, -1, axis);
    dmi_rig_turn_to_axis(axis, turn);
    snprintf(name, sizeof name, "%s_seat", body->joint_name);
    const dmi_edit_item held = add_node(w, index, here, body->joint_name);
    const dmi_edit_item seat = add_node(w, body->parent, body->place, name);
    dmi_edit_numbers(e, held.json, "rotation", turn, 4); /* literal: a quaternion */
    dmi_edit_numbers(e, seat.json, "rotation", turn, 4); /* literal: a quaternion */
    cJSON* joint = dmi_edit_object(e, physics_of(w, held.json), "joint");
    dmi_edit_number(e, joint, "connectedNode", seat.index);
    dmi_edit_number(e, joint, "joint", add_description(w, body));
    dmi_edit_set(e, joint, "enableCollision", cJSON_CreateFalse());
}

/* ---- extras ---- */

static void add_digits(dmi_edit* e, cJSON* object, const char* name, dmi_digits_text digits) {
    dmi_edit_set(e, object, name, cJSON_CreateRaw(digits.text));
}

static void add_vector(dmi_edit* e, cJSON* object, const char* name, dm_vec3 v, const double origin[3]) {
    const float numbers[3] = {v.x, v.y, v.z};
    cJSON* list = dmi_edit_set(e, object, name, cJSON_CreateArray());
    for (int k = 0; k < 3; k++) {
        const double number = (double)numbers[k] + origin[k];
        const dmi_digits_text digits = origin[k] == 0 ? dmi_digits_of_float(numbers[k]) : dmi_digits(number);
        dmi_edit_append(e, list, dmi_edit_new(e, cJSON_CreateRaw(digits.text)));
    }
}

/* Adds the joint in the scene's frame, as dm_gltf_get_asset reads it. */
static void add_extras(writer* w, const dmi_rig_body* body, cJSON* node) {
    static const double none[3] = {0, 0, 0};
    dmi_edit* e = &w->edit;
    const dm_joint* joint = &w->model->desc->joints[body->part];
    cJSON* extras = dmi_edit_set(e, dmi_edit_object(e, node, "extras"), "dragmesh", cJSON_CreateObject());
    dmi_edit_text(e, extras, "type", dmi_gltf_joint_name(joint->type));
    add_digits(e, extras, "type_confidence", dmi_digits_of_float(joint->type_confidence));
    add_digits(e, extras, "confidence", dmi_digits_of_float(joint->joint_confidence));
    add_vector(e, extras, "axis", joint->axis, none);
    add_vector(e, extras, "origin", joint->origin, w->origin);
    if (joint->type != DM_JOINT_CONTINUOUS) {
        add_digits(e, extras, "lower", dmi_digits_of_float(joint->lower));
        add_digits(e, extras, "upper", dmi_digits_of_float(joint->upper));
    }
    if (joint->type == DM_JOINT_SCREW) add_digits(e, extras, "pitch", dmi_digits_of_float(joint->pitch));
    add_digits(e, extras, "moves", dmi_digits_of_float(w->model->desc->parts[body->part].moves));
    if (body->original[0]) dmi_edit_text(e, extras, "name", body->original);
}

/* ---- the whole ---- */

static void use_extension(dmi_edit* e, const char* name) {
    cJSON *list = dmi_edit_list(e, e->document.root, "extensionsUsed"), *item;
    cJSON_ArrayForEach(item, list) {
        if (cJSON_IsString(item) && strcmp(item->valuestring, name) == 0) return;
    }
    dmi_edit_append(e, list, dmi_edit_new(e, cJSON_CreateString(name)));
}

/* Adds the node that stays and holds the seats and boxes of the body, in the scene's frame. */
static dmi_edit_item add_root(writer* w) {
    dmi_edit* e = &w->edit;
    const double number = dmi_json_number(w->scene->document.root, "scene", 0);
    const dmi_edit_item node = dmi_edit_add(e, DMI_GLTF_NODES, NULL);
    dmi_edit_text(e, node.json, "name", "dragmesh_body");
    if (e->problem.code == DM_OK)
        dmi_edit_append_number(e, dmi_edit_list(e, e->document.items[DMI_GLTF_SCENES][(uint32_t)number], "nodes"),
                               node.index);
    return node;
}

/* Adds the filter that all boxes share: boxes of the asset meet others, and not each other. */
static void add_filter(writer* w, cJSON* physics) {
    dmi_edit* e = &w->edit;
    cJSON* filter = dmi_edit_new(e, cJSON_CreateObject());
    static const char* const members[] = {"collisionSystems", "notCollideWithSystems"};
    for (int i = 0; i < 2; i++)
        dmi_edit_append(e, dmi_edit_list(e, filter, members[i]), dmi_edit_new(e, cJSON_CreateString(w->model->name)));
    dmi_edit_append(e, dmi_edit_list(e, physics, "collisionFilters"), filter);
}

static void edit_scene(writer* w) {
    dmi_edit* e = &w->edit;
    const dmi_rig_model* model = w->model;
    cJSON* extensions = dmi_edit_object(e, e->document.root, "extensions");
    /* What the file itself says in this extension is about bodies that are others now. */
    cJSON* physics = dmi_edit_set(e, extensions, PHYSICS, cJSON_CreateObject());
    w->joints = dmi_edit_list(e, physics, "physicsJoints");
    w->shapes = dmi_edit_list(e, dmi_edit_set(e, extensions, SHAPES, cJSON_CreateObject()), "shapes");
    add_filter(w, physics);
    w->tracks[0] = add_root(w);
    for (uint32_t b = 0; b < model->body_count; b++) {
        const dmi_rig_body* body = &model->bodies[b];
        const bool moves_by_clip = dmi_rig_is_left_to_clip(model, b);
        if (b > 0 && !moves_by_clip) add_motion(w, body, w->tracks[b]);
        if (b > 0) add_extras(w, body, w->tracks[b].json);
        if (moves_by_clip) continue;
        for (uint32_t i = 0; i < body->box_count; i++) add_box(w, b, i);
        if (b > 0 && body->kind != DMI_RIG_FREE) add_joint(w, b);
    }
    use_extension(e, PHYSICS);
    use_extension(e, SHAPES);
    use_extension(e, SELECTABLE);
}

/* Removes what the file has of these extensions on its own nodes. */
static void forget_physics(writer* w) {
    for (uint32_t i = 0; w->edit.problem.code == DM_OK && i < w->scene->document.counts[DMI_GLTF_NODES]; i++) {
        cJSON* extensions = cJSON_GetObjectItemCaseSensitive(w->edit.document.items[DMI_GLTF_NODES][i], "extensions");
        if (extensions != NULL) cJSON_DeleteItemFromObjectCaseSensitive(extensions, PHYSICS);
        if (extensions != NULL && extensions->child == NULL)
            cJSON_DeleteItemFromObjectCaseSensitive(w->edit.document.items[DMI_GLTF_NODES][i], "extensions");
    }
}

static dm_result find_tracks(writer* w) {
    for (uint32_t b = 1; b < w->model->body_count; b++) {
        const dmi_rig_body* body = &w->model->bodies[b];
        const int32_t node = dmi_rig_is_left_to_clip(w->model, b) ? find_clip_node(w, body->part) : find_track(w, body);
        if (node < 0)
            return dmi_fail(w->model->env, DM_ERROR_NOT_FOUND, "dm_gltf_rig_make: the GLB has lost %s", body->name);
        if (w->edit.problem.code == DM_OK)
            w->tracks[b] = (dmi_edit_item){w->edit.document.items[DMI_GLTF_NODES][node], node};
    }
    return DM_OK;
}

static dm_result write_scene(writer* w, const void* scene, size_t size, void** out_data, size_t* out_size) {
    dmi_rig_model* model = (dmi_rig_model*)w->model;
    const dm_allocator* allocator = &model->desc->allocator;
    const dm_gltf_desc from = {.struct_size = sizeof from, .data = scene, .size = size, .allocator = *allocator};
    w->tracks = dmi_rig_push(model, model->body_count, sizeof *w->tracks);
    if (w->tracks == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(w->tracks, 0, model->body_count * sizeof *w->tracks);
    dm_result result = dm_gltf_open(&from, &w->scene);
    if (result != DM_OK) return dmi_fail(model->env, result, "dm_gltf_rig_make: the GLB can't be read back");
    dmi_edit_open(&w->edit, model->env, w->scene);
    result = find_tracks(w);
    if (result == DM_OK) {
        forget_physics(w);
        edit_scene(w);
        result = dmi_edit_write(&w->edit, out_data, out_size);
    }
    dmi_edit_close(&w->edit);
    dm_gltf_close(w->scene);
    return result;
}

dm_result dmi_rig_write_glb(dmi_rig_model* model, void** out_data, size_t* out_size) {
    writer w = {.model = model};
    dm_gltf_track* tracks;
    void* scene = NULL;
    size_t size = 0;
    dm_gltf* gltf = model->desc->gltf;
    dm_gltf_get_origin(gltf, w.origin);
    uint32_t track_count;
    dm_result result = dmi_rig_make_tracks(model, &tracks, &track_count);
    if (result == DM_OK) result = dm_gltf_export(gltf, tracks, track_count, &scene, &size);
    if (result == DM_OK) result = write_scene(&w, scene, size, out_data, out_size);
    dm_gltf_release_bytes(gltf, scene, size);
    return result;
}
