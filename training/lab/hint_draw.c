/* Draws labels and pivots. The shares of pivots are those counted on 192 movable nodes of 37 public kits and games;
 * where nothing was counted they are set by hand. */
#include "hint_draw.h"

#include <stdio.h>
#include <string.h>

#include "math/linear3.h"

#define MAX_LABEL 160

/* Shares of labels; by hand, after the counts: half of the nodes name their part, with file and parents 86 %. */
#define OWN_NAME 0.5f
#define FILE_NAME 0.72f

/* Where a pivot is. */
typedef enum spot { SPOT_AXIS, SPOT_CENTRE, SPOT_BOTTOM, SPOT_ORIGIN, SPOT_FACE, SPOT_ELSEWHERE, SPOTS } spot;

static const float hinge_spots[SPOTS] = {0.66f, 0.09f, 0.05f, 0.14f, 0, 0.06f};
static const float alone_spots[SPOTS] = {0.50f, 0.04f, 0.39f, 0.07f, 0, 0};
static const float wheel_spots[SPOTS] = {0.73f, 0, 0, 0.24f, 0, 0.03f};
static const float slide_spots[SPOTS] = {0, 0.40f, 0.15f, 0.25f, 0.15f, 0.05f}; /* by hand */
#define ALONE 0.2f         /* share of turning parts that are counted as a leaf alone in its file; by hand */
#define AXES_TURNED 0.05f  /* share of pivots with axes of any direction; by hand, 93 to 99 % are within 1 degree */
#define WRONG_TURNED 0.15f /* the same of pivots that are not on the axis; by hand */
#define ALIGNED 0.9998f    /* cosine from which an axis of the object is the joint's */
#define OWN_AXES 0.95f     /* share of right pivots with an axis along the joint's where the object has none; by hand */
#define OWN_AXES_WRONG 0.5f /* of the others; by hand */
#define AXIS_NOISE 0.001f   /* object sizes that a right pivot is off; by hand, 99 % are within 0.002 */

/* Where a right pivot is along the axis: shares, by hand. */
#define LOW_END 0.25f
#define HIGH_END 0.1f
#define HALF_WAY 0.35f
#define ANYWHERE 0.2f

/* Names that tell nothing, and names of lies. */
static const char* const plain_names[] = {"Bone",   "Cube.001", "Left", "Object_12",
                                          "Group3", "mesh_0",   "Node", "polySurface7"};
static const char* const lie_names[] = {"Lid",    "Drawer", "Door", "Wheel", "Lever",
                                        "Button", "Hatch",  "Knob", "Flap",  "Propeller"};
#define COUNT(list) (uint32_t)(sizeof(list) / sizeof *(list))

static const char* pick(dmi_random* random, const char* const* list, uint32_t count) {
    return list[dmi_random_u32(random) % count];
}

/* Draws a path of names such as assets have: the file's and the node's. */
static void draw_label(dmi_random* random, const lab_case* made, const dm_lab_hint_options* options,
                       char out[MAX_LABEL]) {
    const int lies = lab_random_bool(random, options->lies), own = lab_random_bool(random, OWN_NAME);
    const int file = lab_random_bool(random, FILE_NAME);
    const char* node = own ? made->object.joints[made->part - 1].name : pick(random, plain_names, COUNT(plain_names));
    const char* scene = file ? made->object.category : "Scene";
    if (lies) node = pick(random, lie_names, COUNT(lie_names));
    snprintf(out, MAX_LABEL, "%s/%s", scene, node);
}

static spot draw_spot(dmi_random* random, const dm_joint* joint) {
    const float* shares = hinge_spots;
    if (joint->type == DM_JOINT_PRISMATIC)
        shares = slide_spots;
    else if (joint->type == DM_JOINT_CONTINUOUS)
        shares = wheel_spots;
    else if (lab_random_bool(random, ALONE))
        shares = alone_spots;
    float at = lab_random_uniform(random, 0, 1);
    for (int i = 0; i < SPOTS; i++) {
        if (at < shares[i]) return (spot)i;
        at -= shares[i];
    }
    return SPOT_ELSEWHERE;
}

/* Draws a point of the joint's axis: an end of the part along it, the middle, anywhere between, or the joint's own. */
static void draw_on_axis(dmi_random* random, const lab_case* made, float out[3]) {
    const dm_joint* joint = &made->joint;
    const dmi_float3 axis = dmi_xyz(joint->axis), origin = dmi_xyz(joint->origin);
    float low = INFINITY, high = -INFINITY;
    for (int i = 0; i < DMI_CLOUD_POINTS / 2; i++) {
        float arm[3];
        dmi_sub3(made->cloud.xyz[i], origin.v, arm);
        const float t = dmi_dot3(arm, axis.v);
        low = dmi_min(low, t), high = dmi_max(high, t);
    }
    const float where = lab_random_uniform(random, 0, 1);
    float t = 0; /* the joint's own origin, in the other cases */
    if (where < LOW_END)
        t = low;
    else if (where < LOW_END + HIGH_END)
        t = high;
    else if (where < LOW_END + HIGH_END + HALF_WAY)
        t = (low + high) / 2;
    else if (where < LOW_END + HIGH_END + HALF_WAY + ANYWHERE)
        t = lab_random_uniform(random, low, high);
    dmi_madd3(origin.v, t, axis.v, out);
    for (int k = 0; k < 3; k++) out[k] += AXIS_NOISE * dmi_random_normal(random) / 3;
}

static void object_box(const dmi_mesh* mesh, float low[3], float high[3]) {
    for (int k = 0; k < 3; k++) {
        low[k] = INFINITY, high[k] = -INFINITY;
        for (uint32_t i = 0; i < mesh->part_count; i++) {
            low[k] = dmi_min(low[k], mesh->parts[i].box_min[k]);
            high[k] = dmi_max(high[k], mesh->parts[i].box_max[k]);
        }
    }
}

static void draw_place(dmi_random* random, const lab_case* made, const dmi_part* part, spot where,
                       dmi_asset_hints* out) {
    static const double file_origin[3] = {0, 0, 0};
    float low[3], high[3];
    if (where == SPOT_AXIS) {
        draw_on_axis(random, made, out->pivot);
        return;
    }
    object_box(made->mesh, low, high);
    const uint32_t face = dmi_random_u32(random) % 3, side = dmi_random_u32(random) % 2;
    const int corner = lab_random_bool(random, 0.5f);
    for (uint32_t k = 0; k < 3; k++) {
        out->pivot[k] = (part->box_min[k] + part->box_max[k]) / 2;
        if (where == SPOT_BOTTOM && k == 1) out->pivot[k] = part->box_min[k];
        if (where == SPOT_FACE && (k == face || corner)) out->pivot[k] = side ? part->box_max[k] : part->box_min[k];
        if (where == SPOT_ELSEWHERE) out->pivot[k] = lab_random_uniform(random, low[k], high[k]);
    }
    if (where == SPOT_ORIGIN) dmi_frame_point_in(&made->mesh->frame, file_origin, out->pivot);
    out->is_default = where == SPOT_ORIGIN;
}

static void any_axes(dmi_random* random, float out[3][3]) {
    lab_random_direction(random, out[0]);
    dmi_perpendicular3(out[0], out[1], out[2]);
}

/* Sets the node's axes: those of the object where one is the joint's, else the joint's and two across it. */
static void draw_axes(dmi_random* random, const lab_case* made, int right, dmi_asset_hints* out) {
    static const float canonical[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const dmi_float3 axis = dmi_xyz(made->joint.axis);
    float most = 0;
    out->has_axes = true;
    memcpy(out->pivot_axes, canonical, sizeof canonical);
    for (int k = 0; k < 3; k++) most = dmi_max(most, fabsf(axis.v[k]));
    if (lab_random_bool(random, right ? AXES_TURNED : WRONG_TURNED)) {
        any_axes(random, out->pivot_axes);
    } else if (most < ALIGNED && lab_random_bool(random, right ? OWN_AXES : OWN_AXES_WRONG)) {
        memcpy(out->pivot_axes[0], axis.v, sizeof axis.v);
        dmi_perpendicular3(axis.v, out->pivot_axes[1], out->pivot_axes[2]);
    }
}

static void draw_pivot(dmi_random* random, const lab_case* made, const dmi_part* part,
                       const dm_lab_hint_options* options, dmi_asset_hints* out) {
    const int lies = lab_random_bool(random, options->lies);
    const spot where = lies ? SPOT_ELSEWHERE : draw_spot(random, &made->joint);
    out->has_pivot = true;
    draw_place(random, made, part, where, out);
    draw_axes(random, made, where == SPOT_AXIS || (!lies && made->joint.type == DM_JOINT_PRISMATIC), out);
    if (lies) any_axes(random, out->pivot_axes);
}

dmi_asset_hints lab_draw_hints(dmi_random* random, const lab_case* made, uint32_t part,
                               const dm_lab_hint_options* options) {
    dmi_asset_hints hints = {.up = {0, 1, 0}};
    char label[MAX_LABEL];
    draw_label(random, made, options, label);
    if (lab_random_bool(random, options->wrong_up)) {
        const uint32_t which = dmi_random_u32(random) % 3;
        hints.up[1] = which == 1 ? -1.0f : 0.0f;
        if (which != 1) hints.up[which] = 1;
    }
    if (lab_random_bool(random, options->labels)) hints.label = dmi_kind_of_label(label);
    if (lab_random_bool(random, options->pivots)) draw_pivot(random, made, &made->mesh->parts[part], options, &hints);
    return hints;
}
