/* Joints of `extras`, as this library's tool, page and add-on for Blender write them, and of KHR_physics_rigid_bodies.
 */
#include "gltf/gltf_asset.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "gltf/gltf_matrix.h"
#include "math/elementary.h"

enum { COLUMN = DMI_GLTF_COLUMN, ORIGIN = DMI_GLTF_ORIGIN };
#define PHYSICS_NAME "KHR_physics_rigid_bodies"

static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/* ---- a joint in some frame ---- */

typedef struct stated_joint {
    int32_t type;
    double axis[3], origin[3], lower, upper, pitch;
} stated_joint;

static bool fits_float(double x) {
    return fabs(x) <= FLT_MAX;
}

/* Writes the joint in the frame of the merged mesh. frame: takes it to the scene. A frame that mirrors turns the other
 * way. The lengths of a slide, and of a screw's pitch, are units of the frame along the axis. Returns false where
 * floats cannot hold it, or the axis has no length. */
static bool write_joint(const dm_gltf* gltf, const stated_joint* from, const double frame[16], dm_joint* out) {
    double axis[3], origin[3];
    const bool slides = from->type == DM_JOINT_PRISMATIC;
    dmi_gltf_turn(frame, from->axis, axis);
    dmi_gltf_turn(frame, from->origin, origin);
    const double length = dmi_gltf_length(axis), own = dmi_gltf_length(from->axis);
    if (!(length > 0 && own > 0)) return false;
    const double scale = length / own, sign = !slides && dmi_gltf_determinant(frame) < 0 ? -1 : 1;
    const double unit = slides ? scale : 1;
    for (int k = 0; k < 3; k++) {
        axis[k] *= sign / length;
        origin[k] += frame[ORIGIN + k] - gltf->origin[k];
        if (!fits_float(axis[k]) || !fits_float(origin[k])) return false;
    }
    if (!fits_float(from->lower * unit) || !fits_float(from->upper * unit) || !fits_float(from->pitch * scale))
        return false;
    *out = (dm_joint){.struct_size = sizeof *out,
                      .type = from->type,
                      .type_confidence = 1,
                      .joint_confidence = 1,
                      .pitch = from->type == DM_JOINT_SCREW ? (float)(sign * from->pitch * scale) : 0,
                      .axis = {(float)axis[0], (float)axis[1], (float)axis[2]},
                      .origin = {(float)origin[0], (float)origin[1], (float)origin[2]},
                      .lower = (float)(from->lower * unit),
                      .upper = (float)(from->upper * unit),
                      .source = DM_JOINT_FROM_HOST};
    return true;
}

/* Gives the node the joint, in memory of the asset. */
static dm_result set_joint(dm_gltf* gltf, dmi_gltf_asset* asset, uint32_t index, const dm_joint* joint,
                           dmi_gltf_problem* problem) {
    dm_joint* kept = dmi_gltf_push(gltf, &asset->arena, 1, sizeof *kept, problem);
    if (!kept) return problem->code;
    *kept = *joint;
    asset->nodes[index].joint = kept;
    return DM_OK;
}

/* ---- extras ---- */

static const char* const type_names[] = {[DM_JOINT_REVOLUTE] = "revolute",
                                         [DM_JOINT_PRISMATIC] = "prismatic",
                                         [DM_JOINT_SCREW] = "screw",
                                         [DM_JOINT_CONTINUOUS] = "continuous",
                                         [DM_JOINT_FIXED] = "fixed"};

const char* dmi_gltf_joint_name(int32_t type) {
    return type >= DM_JOINT_UNKNOWN && type <= DM_JOINT_FIXED ? type_names[type] : NULL;
}

static int32_t find_type(const char* name) {
    for (int32_t type = DM_JOINT_REVOLUTE; name && type <= DM_JOINT_FIXED; type++)
        if (strcmp(name, type_names[type]) == 0) return type;
    return DM_JOINT_UNKNOWN;
}

/* Where the members of a joint are, and in which frame it is. */
typedef struct extras_form {
    const char* object; /* a member of `extras` that holds the others; NULL: `extras` itself */
    const char *type, *axis, *origin, *lower, *upper, *pitch;
    bool of_node; /* it is in the node's frame; else in the scene's */
    bool z_up;    /* it has Blender's axes, y backwards */
} extras_form;

static const extras_form forms[] = {
    {"dragmesh_joint", "type", "axis", "origin", "lower", "upper", "pitch", .of_node = true},
    {"dragmesh", "type", "axis", "origin", "lower", "upper", "pitch", .of_node = false},
    {NULL, "dragmesh_type", "dragmesh_axis", "dragmesh_origin", "dragmesh_lower", "dragmesh_upper", "dragmesh_pitch",
     .z_up = true},
};

static void turn_up(double v[3]) {
    const double y = v[1];
    v[1] = v[2];
    v[2] = -y;
}

/* Reads a joint of one form. Returns whether there is one; `out->type` is UNKNOWN where it cannot be read. */
static bool read_form(const cJSON* extras, const extras_form* form, stated_joint* out) {
    const cJSON* from = form->object ? dmi_json_get(extras, form->object) : extras;
    if (!dmi_json_get(from, form->type)) return false;
    *out = (stated_joint){.type = find_type(dmi_json_text(from, form->type)),
                          .axis = {1, 0, 0},
                          .lower = dmi_json_number(from, form->lower, 0),
                          .upper = dmi_json_number(from, form->upper, 0),
                          .pitch = dmi_json_number(from, form->pitch, 0)};
    dmi_json_numbers(from, form->origin, 3, out->origin);
    if (!dmi_json_numbers(from, form->axis, 3, out->axis) && out->type != DM_JOINT_FIXED) out->type = DM_JOINT_UNKNOWN;
    if (!(out->lower <= out->upper)) out->type = DM_JOINT_UNKNOWN;
    if (form->z_up) {
        turn_up(out->axis);
        turn_up(out->origin);
    }
    return true;
}

static dm_result read_extras(dm_gltf* gltf, dmi_gltf_asset* asset, uint32_t index, dmi_gltf_problem* problem) {
    const dmi_gltf_tree_node* node = &gltf->tree[asset->file_nodes[index]];
    const cJSON* extras = dmi_json_get(node->json, "extras");
    stated_joint stated;
    dm_joint joint;
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
        if (!read_form(extras, &forms[i], &stated)) continue;
        if (stated.type != DM_JOINT_UNKNOWN &&
            write_joint(gltf, &stated, forms[i].of_node ? node->world : identity, &joint))
            return set_joint(gltf, asset, index, &joint, problem);
        dmi_gltf_warn(&gltf->warnings, "glTF node %u '%.80s': the joint of its extras can't be read; left out",
                      asset->file_nodes[index], node->name);
        return DM_OK;
    }
    return DM_OK;
}

/* ---- KHR_physics_rigid_bodies ---- */

/* What a joint leaves free: the three ways along its axes and the three turns about them, in this order. */
enum { ANGULAR = 3, FREEDOMS = 6 };
typedef struct freedom {
    bool locked, limited;
    double lower, upper; /* limits of a freedom that is limited */
} freedom;

typedef struct physics_joint {
    uint32_t node, connected; /* nodes of the file */
    freedom freedoms[FREEDOMS];
} physics_joint;

static const cJSON* physics_of(const dm_gltf* gltf, int64_t node) {
    return dmi_json_get(dmi_json_get(gltf->tree[node].json, "extensions"), PHYSICS_NAME);
}

static const cJSON* item_at(const cJSON* list, double index) {
    return index >= 0 && index <= INT32_MAX && index == floor(index) ? cJSON_GetArrayItem(list, (int)index) : NULL;
}

/* Limits one axis. Returns false for a limit that holds for several axes together, such as the range of a ball
 * joint. */
static bool limit_axis(freedom* out, double lower, double upper, int axes) {
    if (lower > upper) return false;
    if (lower == upper) {
        out->locked = true;
        return lower == 0 || axes == 1;
    }
    if (axes > 1) return false;
    out->limited = true;
    out->lower = lower;
    out->upper = upper;
    return true;
}

static bool read_axes(const cJSON* limit, const char* name, freedom* freedoms) {
    const cJSON *axes = dmi_json_get(limit, name), *axis;
    const double lower = dmi_json_number(limit, "min", -INFINITY), upper = dmi_json_number(limit, "max", INFINITY);
    const int count = cJSON_GetArraySize(axes);
    cJSON_ArrayForEach(axis, axes) {
        const double index = cJSON_IsNumber(axis) ? axis->valuedouble : DMI_GLTF_NO_INDEX;
        if (index != 0 && index != 1 && index != 2) return false;
        /* A distance is 0 at least. */
        const double least = count > 1 && lower < 0 ? 0 : lower;
        if (!limit_axis(&freedoms[(int)index], least, upper, count)) return false;
    }
    return true;
}

/* Reads limits. Returns false where they do not leave a joint of one axis. */
static bool read_limits(const cJSON* limits, freedom freedoms[FREEDOMS]) {
    const cJSON* limit;
    cJSON_ArrayForEach(limit, limits) {
        if (!read_axes(limit, "linearAxes", freedoms) || !read_axes(limit, "angularAxes", freedoms + ANGULAR))
            return false;
    }
    return true;
}

/* Returns the node at or above that has a motion of its own, or -1 when there is none. */
static int64_t find_body(const dm_gltf* gltf, int64_t node) {
    while (node >= 0 && !dmi_json_get(physics_of(gltf, node), "motion")) node = gltf->tree[node].parent;
    return node;
}

static bool is_below(const dm_gltf* gltf, int64_t node, int64_t above) {
    while (node >= 0 && node != above) node = gltf->tree[node].parent;
    return node >= 0;
}

/* Writes the axes of a node's frame, each of unit length. Returns false where one has none. */
static bool read_frame(const double world[16], double axes[3][3]) {
    for (int column = 0; column < 3; column++) {
        const double length = dmi_gltf_length(world + (size_t)COLUMN * (size_t)column);
        if (!(length > 0 && isfinite(length))) return false;
        for (int k = 0; k < 3; k++) axes[column][k] = world[COLUMN * column + k] / length;
    }
    return true;
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Returns how far the connected node's frame is off the joint's at rest, along axis i or about it. */
static double offset_of(const dm_gltf* gltf, const physics_joint* joint, int which) {
    const double *a = gltf->tree[joint->node].world, *b = gltf->tree[joint->connected].world;
    const int i = which % 3, j = (i + 1) % 3, k = (i + 2) % 3;
    double from[3][3], to[3][3];
    if (!read_frame(a, from) || !read_frame(b, to)) return 0;
    const double between[3] = {b[ORIGIN] - a[ORIGIN], b[ORIGIN + 1] - a[ORIGIN + 1], b[ORIGIN + 2] - a[ORIGIN + 2]};
    if (which < ANGULAR) return dot(between, from[i]);
    return dmi_atan2(dot(to[j], from[k]), dot(to[j], from[j]));
}

/* Writes the joint of the one way that is left free. The limits tell how the connected node may stand in the frame of
 * the joint's node; where the latter moves, it goes the other way. Returns false where more than one way is left. */
static bool find_stated(const dm_gltf* gltf, const physics_joint* from, bool connected_moves, stated_joint* out) {
    int free_one = -1;
    for (int i = 0; i < FREEDOMS; i++) {
        if (from->freedoms[i].locked) continue;
        if (free_one >= 0) return false;
        free_one = i;
    }
    const double* world = gltf->tree[from->node].world;
    double axes[3][3];
    *out = (stated_joint){.type = DM_JOINT_FIXED, .axis = {1, 0, 0}};
    if (!read_frame(world, axes)) return false;
    memcpy(out->origin, world + ORIGIN, sizeof out->origin);
    if (free_one < 0) return true;
    const freedom* f = &from->freedoms[free_one];
    const bool both = f->limited && isfinite(f->lower) && isfinite(f->upper);
    const bool turns = free_one >= ANGULAR;
    out->type = !turns ? DM_JOINT_PRISMATIC : both ? DM_JOINT_REVOLUTE : DM_JOINT_CONTINUOUS;
    for (int k = 0; k < 3; k++) out->axis[k] = (connected_moves ? 1 : -1) * axes[free_one % 3][k];
    if (!both) return true;
    const double offset = offset_of(gltf, from, free_one);
    out->lower = f->lower - offset;
    out->upper = f->upper - offset;
    return true;
}

static dm_result read_physics(dm_gltf* gltf, dmi_gltf_asset* asset, uint32_t node, dmi_gltf_problem* problem) {
    const cJSON* json = dmi_json_get(physics_of(gltf, node), "joint");
    const cJSON* joints =
        dmi_json_get(dmi_json_get(dmi_json_get(gltf->document.root, "extensions"), PHYSICS_NAME), "physicsJoints");
    const cJSON* limits = dmi_json_get(item_at(joints, dmi_json_number(json, "joint", DMI_GLTF_NO_INDEX)), "limits");
    const int64_t connected =
        dmi_gltf_position(&gltf->document, DMI_GLTF_NODES, dmi_json_number(json, "connectedNode", DMI_GLTF_NO_INDEX));
    physics_joint joint = {.node = node};
    stated_joint stated;
    dm_joint made;
    if (!json) return DM_OK;
    const int64_t own = find_body(gltf, node), other = connected >= 0 ? find_body(gltf, connected) : -1;
    const int64_t body = own < 0 || is_below(gltf, other, own) ? other : own;
    const uint32_t index = body >= 0 ? asset->places[body] : DM_ASSET_NO_NODE;
    joint.connected = connected >= 0 ? (uint32_t)connected : node;
    if (body >= 0 && index == DM_ASSET_NO_NODE) return DM_OK; /* the body has no triangles */
    if (connected < 0 || body < 0 || own == other || !gltf->tree[connected].placed ||
        !read_limits(limits, joint.freedoms) || !find_stated(gltf, &joint, body == other, &stated) ||
        !write_joint(gltf, &stated, identity, &made)) {
        dmi_gltf_warn(&gltf->warnings, "glTF node %u '%.80s': its physics joint has not one axis alone; left out", node,
                      gltf->tree[node].name);
        return DM_OK;
    }
    return asset->nodes[index].joint ? DM_OK : set_joint(gltf, asset, index, &made, problem);
}

dm_result dmi_gltf_read_joints(dm_gltf* gltf, dmi_gltf_asset* asset, dmi_gltf_problem* problem) {
    dm_result result = DM_OK;
    for (uint32_t i = 0; i < asset->count && result == DM_OK; i++)
        if (!asset->nodes[i].joint && !(asset->nodes[i].flags & DM_ASSET_NODE_FOLLOWS))
            result = read_extras(gltf, asset, i, problem);
    for (uint32_t at = 0; at < gltf->order_count && result == DM_OK; at++)
        if (gltf->tree[gltf->order[at]].in_scene) result = read_physics(gltf, asset, gltf->order[at], problem);
    return result;
}
