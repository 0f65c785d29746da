/* Makes batches for the DQ-VAE: inputs by dmi_vae_features_make and dmi_vae_neighbours, targets as joint values. */
#include <math.h>
#include <string.h>

#include "lab_given.h"
#include "math/linear3.h"
#include "motion/dq_vae.h"
#include "pull.h"

#define STROKES 4      /* of every object: simulating one is much cheaper than making an object */
#define THREADED 0.12f /* share of turning joints */

/* Turns a revolute or continuous joint into a left- or right-handed screw, with the drag that such a screw would have:
 * few generated objects have a thread. The joint stays signed along the drag. */
static void thread(dmi_random* random, dmi_drag_hint* hint, dm_joint* joint) {
    const float pitch = 0.004f * powf(25.0f, dmi_random_unit(random)); /* of the object's size, a radian */
    const float axis[3] = {joint->axis.x, joint->axis.y, joint->axis.z};
    const float origin[3] = {joint->origin.x, joint->origin.y, joint->origin.z};
    joint->type = DM_JOINT_SCREW;
    joint->pitch = lab_random_bool(random, 0.5f) ? pitch : -pitch;
    joint->upper = lab_random_uniform(random, 0.5f, 12.0f);
    joint->lower = lab_random_bool(random, 0.5f) ? 0.0f : -lab_random_uniform(random, 0.0f, 6.0f);
    const float lead = joint->pitch / fmaxf(dmi_line_distance3(hint->point, axis, origin), pitch);
    dmi_madd3(hint->vector, lead * dmi_length3(hint->vector), axis, hint->vector);
}

/* Returns the joint with an error: 0.05 rad and a hundredth of the object's size (standard deviations). */
static dm_joint roughly(dmi_random* random, dm_joint joint) {
    float about[3], rotation[9], axis[3] = {joint.axis.x, joint.axis.y, joint.axis.z};
    lab_random_direction(random, about);
    lab_rotation(about, 0.05f * dmi_random_normal(random), rotation);
    lab_rotate(rotation, axis, axis);
    joint.axis = (dm_vec3){axis[0], axis[1], axis[2]};
    joint.origin.x += 0.01f * dmi_random_normal(random);
    joint.origin.y += 0.01f * dmi_random_normal(random);
    joint.origin.z += 0.01f * dmi_random_normal(random);
    return joint;
}

/* Writes the points that a prepared object would keep of the cloud. */
static void write_points(const dmi_cloud* cloud, dmi_vae_object* out_object) {
    dmi_part_points points;
    dmi_part_points_of_cloud(cloud, &points);
    dmi_vae_object_points(&points, out_object);
}

static void write_joint(const dm_joint* joint, const dm_lab_vae* out, size_t i) {
    memcpy(out->axis + 3 * i, &joint->axis, 3 * sizeof(float));
    memcpy(out->origin + 3 * i, &joint->origin, 3 * sizeof(float));
    out->pitch[i] = joint->type == DM_JOINT_SCREW ? joint->pitch : 0.0f;
    out->type[i] = joint->type - 1;
    out->limits[2 * i] = joint->type == DM_JOINT_CONTINUOUS ? -INFINITY : joint->lower;
    out->limits[2 * i + 1] = joint->type == DM_JOINT_CONTINUOUS ? INFINITY : joint->upper;
}

static void write_query(const dmi_vae_object* object, const dmi_vae_query* query, const lab_stroke* stroke,
                        const dm_lab_vae* out, size_t i) {
    dmi_vae_features features;
    dmi_vae_features_make(query, &features);
    memcpy(out->features + i * sizeof features / sizeof(float), &features, sizeof features);
    uint32_t nearest[DMI_VAE_NEIGHBOURS];
    const float origin[3] = {query->joint.origin.x, query->joint.origin.y, query->joint.origin.z};
    dmi_vae_neighbours(object, origin, nearest);
    memcpy(out->near_origin + i * DMI_VAE_NEIGHBOURS, nearest, sizeof nearest);
    dmi_vae_neighbours(object, query->drag_point, nearest);
    memcpy(out->near_drag + i * DMI_VAE_NEIGHBOURS, nearest, sizeof nearest);
    memcpy(out->xyz + i * DMI_VAE_POINTS * 3, object->xyz, sizeof object->xyz);
    memcpy(out->mask + i * DMI_VAE_POINTS, object->mask, sizeof object->mask);
    memcpy(out->drag_point + 3 * i, query->drag_point, sizeof query->drag_point);
    memcpy(out->drag_vector + 3 * i, query->drag_vector, sizeof query->drag_vector);
    write_joint(&query->joint, out, i);
    for (uint32_t f = 0; f < DM_MOTION_FRAMES; f++) {
        const float nearest_value = fminf(fmaxf(features.path[f][3], out->limits[2 * i]), out->limits[2 * i + 1]);
        out->closed_form[i * DM_MOTION_FRAMES + f] = nearest_value;
        out->values[i * DM_MOTION_FRAMES + f] = stroke->values[f];
    }
}

/* Writes one stroke that starts at the hint. joint: signed along the drag. */
static void write_stroke(lab_case* made, const dm_lab_options* options, const dmi_vae_object* object,
                         const dmi_drag_hint* hint, const dm_joint* joint, const dm_lab_vae* out, size_t i) {
    dmi_random* random = &made->random;
    const int steady = lab_random_bool(random, 0.25f);
    lab_stroke stroke;
    dmi_vae_query query = {.joint = *joint};
    /* The default path follows the joint that the network is given, right or not. */
    if (lab_random_bool(random, options->joint_noise)) query.joint = roughly(random, *joint);
    lab_stroke_make(random, steady ? &query.joint : joint, hint->point, steady,
                    !steady && lab_random_bool(random, options->hand_noise), &stroke);
    memcpy(query.drag_point, hint->point, sizeof query.drag_point);
    memcpy(query.drag_vector, hint->vector, sizeof query.drag_vector);
    memcpy(query.path, stroke.path, sizeof query.path);
    write_query(object, &query, &stroke, out, i);
    out->category[i] = (int32_t)made->category_id;
}

dm_result dm_lab_vae_batch(const dm_lab_options* options, const dm_lab_vae* out) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    lab_case* made = dmi_alloc(&env, sizeof *made, 64);
    dmi_vae_object* object = dmi_alloc(&env, sizeof *object, 64);
    dm_result result = made && object ? DM_OK : DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t i = 0; i < options->count && result == DM_OK;) {
        result = lab_case_make(&env, options, i, made);
        if (result != DM_OK) break;
        write_points(&made->cloud, object);
        for (uint32_t k = 0; k < STROKES && i < options->count; k++, i++) {
            dm_joint joint;
            dmi_drag_hint hint = lab_case_drag(made, DM_LAB_PULL_TANGENT, options->drag_noise_degrees, &joint);
            const int turns = joint.type == DM_JOINT_REVOLUTE || joint.type == DM_JOINT_CONTINUOUS;
            if (turns && options->split == DM_LAB_TRAIN && lab_random_bool(&made->random, THREADED))
                thread(&made->random, &hint, &joint);
            write_stroke(made, options, object, &hint, &joint, out, i);
        }
        lab_case_release(&env, made);
    }
    dmi_free(&env, object, sizeof *object);
    dmi_free(&env, made, sizeof *made);
    return result;
}

dm_result dm_lab_vae_given(const dm_lab_given* given, const dm_lab_options* options, const dm_lab_vae* out) {
    if (given->type != DM_JOINT_CONTINUOUS && given->lower >= given->upper) return DM_ERROR_NOT_FOUND;
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    lab_case* made = dmi_alloc(&env, sizeof *made, 64);
    dmi_vae_object* object = dmi_alloc(&env, sizeof *object, 64);
    dm_result result = made && object ? lab_case_given(&env, given, made) : DM_ERROR_OUT_OF_MEMORY;
    if (result == DM_OK) {
        made->random = dmi_random_make(options->seed, 0);
        write_points(&made->cloud, object);
        for (uint32_t i = 0; i < options->count; i++) {
            dm_joint joint;
            const dmi_drag_hint hint = lab_given_drag(made, given, options->drag_noise_degrees, &joint);
            write_stroke(made, options, object, &hint, &joint, out, i);
        }
        lab_case_release(&env, made);
    }
    dmi_free(&env, object, sizeof *object);
    dmi_free(&env, made, sizeof *made);
    return result;
}
