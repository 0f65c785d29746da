/* Input features of the DQ-VAE from a drag and a joint (docs/networks.md, "Features of a query"). */
#include "motion/dq_vae.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "math/elementary.h"
#include "math/joint.h"
#include "math/linear3.h"

#define SCALAR_LIMIT 4.0f /* bound of the joint's scalars, as trained (docs/networks.md) */
#define MIN_TORQUE 1e-8f  /* length of the product lever x drag below which the direction is 0, as trained */
#define CHORD_STEP 5      /* path points between two chords, as trained */

static float clamp_scalar(float value) {
    return dmi_fminf(dmi_fmaxf(value, -SCALAR_LIMIT), SCALAR_LIMIT);
}

/* Cylindrical coordinates of a point about the joint's axis: the height along the axis, and the lever arm. */
typedef struct arm {
    float height, length;
    float across[3];
} arm;

static arm arm_of(const float point[3], const float axis[3], const float origin[3]) {
    arm result;
    float offset[3];
    dmi_sub3(point, origin, offset);
    result.height = dmi_dot3(offset, axis);
    for (int i = 0; i < 3; i++) result.across[i] = offset[i] - result.height * axis[i];
    result.length = sqrtf(dmi_dot3(result.across, result.across));
    return result;
}

/* Returns the angle about the axis from one arm to the other. Of the angles that are whole turns apart, it is the one
 * nearest to `near`. For a point on the axis it is `near` itself. */
static float angle_between(const arm* from, const arm* to, const float axis[3], float near) {
    float normal[3];
    dmi_cross3(from->across, to->across, normal);
    const float sine = dmi_dot3(normal, axis), cosine = dmi_dot3(from->across, to->across);
    if (sine == 0.0f && cosine == 0.0f) return near;
    const float angle = dmi_atan2f(sine, cosine);
    return angle + DMI_TWO_PI_F * roundf((near - angle) / DMI_TWO_PI_F);
}

/* Writes the path's features: path[i] = P_i - p, the joint value that brings p nearest to P_i, and the residual
 * distance. A turn keeps the arm's length, and its height except for a screw's advance, so the residual comes from the
 * differences of both. */
static void make_path(const dmi_vae_query* query, const float axis[3], const float origin[3],
                      float out_path[DMI_VAE_PATH][5]) {
    const bool turns = dmi_joint_turns(query->joint.type), slides = query->joint.type == DM_JOINT_PRISMATIC;
    const float pitch = query->joint.type == DM_JOINT_SCREW ? query->joint.pitch : 0.0f;
    const arm start = arm_of(query->drag_point, axis, origin);
    float value = 0.0f;
    for (int i = 0; i < DMI_VAE_PATH; i++) {
        float step[3];
        const arm end = arm_of(query->path[i], axis, origin);
        dmi_sub3(query->path[i], query->drag_point, step);
        float residual = sqrtf(dmi_dot3(step, step));
        if (turns) {
            value = angle_between(&start, &end, axis, value);
            residual = dmi_length2(end.length - start.length, end.height - start.height - pitch * value);
        } else if (slides) {
            value = dmi_dot3(step, axis);
            float rest[3];
            for (int c = 0; c < 3; c++) rest[c] = step[c] - value * axis[c];
            residual = sqrtf(dmi_dot3(rest, rest));
        }
        memcpy(out_path[i], step, sizeof step);
        out_path[i][3] = value;
        out_path[i][4] = residual;
    }
}

static void make_scalars(const dm_joint* joint, float out[3]) {
    const bool endless = joint->type == DM_JOINT_CONTINUOUS;
    out[0] = endless ? 0.0f : clamp_scalar(joint->pitch);
    out[1] = endless ? 0.0f : clamp_scalar(joint->lower);
    out[2] = endless ? 0.0f : clamp_scalar(joint->upper);
}

static void make_direction(const dmi_vae_query* query, const float origin[3], float out[3]) {
    float lever[3];
    dmi_sub3(query->drag_point, origin, lever);
    dmi_cross3(lever, query->drag_vector, out);
    const float length = sqrtf(dmi_dot3(out, out));
    for (int i = 0; i < 3; i++) out[i] = length < MIN_TORQUE ? 0.0f : out[i] / length;
}

static float path_length(const float path[DMI_VAE_PATH][3]) {
    float length = 0.0f, step[3];
    for (int i = 1; i < DMI_VAE_PATH; i++) {
        dmi_sub3(path[i], path[i - 1], step);
        length += sqrtf(dmi_dot3(step, step));
    }
    return length;
}

void dmi_vae_features_make(const dmi_vae_query* query, dmi_vae_features* out_features) {
    const dmi_float3 axis = dmi_xyz(query->joint.axis), origin = dmi_xyz(query->joint.origin);
    const float points_over_steps = (float)DMI_VAE_PATH / (DMI_VAE_PATH - 1);
    make_scalars(&query->joint, out_features->joint_scalars);
    make_direction(query, origin.v, out_features->rotation_direction);
    dmi_sub3(query->path[DMI_VAE_PATH - 1], query->path[0], out_features->mean_velocity);
    for (int i = 0; i < 3; i++) out_features->mean_velocity[i] *= points_over_steps;
    for (size_t i = 0; i < 3; i++)
        dmi_sub3(query->path[CHORD_STEP * (i + 1)], query->path[0], &out_features->chords[3 * i]);
    make_path(query, axis.v, origin.v, out_features->path);
    out_features->amplitude[0] = out_features->path[DMI_VAE_PATH - 1][3];
    out_features->amplitude[1] = path_length(query->path);
}

void dmi_vae_object_points(const dmi_part_points* points, dmi_vae_object* out_object) {
    dmi_part_points_place(points, out_object->xyz);
    for (size_t i = 0; i < DMI_VAE_POINTS; i++) out_object->mask[i] = i < DMI_VAE_PART_POINTS ? 1.0f : 0.0f;
}

/* Returns a key that sorts by distance, then by index: the bits of non-negative floats have the order of their values.
 */
static uint64_t sort_key(float squared_distance, uint32_t index) {
    uint32_t bits;
    memcpy(&bits, &squared_distance, sizeof bits);
    return (uint64_t)bits << 32 | index;
}

void dmi_vae_neighbours(const dmi_vae_object* object, const float centre[3], uint32_t out_indices[DMI_VAE_NEIGHBOURS]) {
    uint64_t nearest[DMI_VAE_NEIGHBOURS]; /* ascending */
    uint32_t count = 0;
    for (uint32_t i = 0; i < DMI_VAE_POINTS; i++) {
        float offset[3];
        dmi_sub3(object->xyz[i], centre, offset);
        const uint64_t key = sort_key(dmi_dot3(offset, offset), i);
        if (count == DMI_VAE_NEIGHBOURS && key >= nearest[count - 1]) continue;
        uint32_t place = count < DMI_VAE_NEIGHBOURS ? count++ : count - 1;
        for (; place > 0 && nearest[place - 1] > key; place--) nearest[place] = nearest[place - 1];
        nearest[place] = key;
    }
    for (uint32_t i = 0; i < DMI_VAE_NEIGHBOURS; i++) out_indices[i] = (uint32_t)nearest[i];
}
