/* Declares a training case: a generated object, augmented, and one of its joints, as the library itself sees them. */
#ifndef DM_LAB_CASE_H
#define DM_LAB_CASE_H

#include "base/random.h"
#include "dragmesh_lab.h"
#include "generator.h"
#include "kinematics/kpp/kpp_input.h"
#include "math/joint.h"

typedef struct lab_case {
    dmi_random random;
    dmg_object object;
    dmi_mesh* mesh;
    uint32_t* welded; /* of the mesh's vertices, for the part's analysis; NULL in a case given by the caller */
    dmi_cloud cloud;
    dm_joint joint;       /* object-normalised, positive opens, origin nearest the part's centre */
    uint32_t category_id; /* dmg_category_id */
    uint32_t part;        /* the generator's id */
    float rotation[9];    /* columns: axes of the room that the object was modelled in; of a generated case */
} lab_case;

/* Makes the `index`-th case of the options' stream. Release after success. */
dm_result lab_case_make(dmi_env* env, const dm_lab_options* options, uint64_t index, lab_case* out_case);
void lab_case_release(dmi_env* env, lab_case* made);

/* Makes a case from a mesh and joint of the caller, which it borrows. Release after success. */
struct dm_lab_given;
dm_result lab_case_given(dmi_env* env, const struct dm_lab_given* given, lab_case* out_case);

/* Rotates the given drag about a random direction by a random angle, and signs the joint along it. */
dmi_drag_hint lab_given_drag(lab_case* made, const struct dm_lab_given* given, float noise_degrees,
                             dm_joint* out_joint);

/* Draws uniformly from [low, high). */
float lab_random_uniform(dmi_random* random, float low, float high);
/* Returns 1 with this probability. */
int lab_random_bool(dmi_random* random, float probability);
/* Draws a direction uniformly from the unit sphere. */
void lab_random_direction(dmi_random* random, float out[3]);
/* Computes the row-major rotation about a unit axis. angle: rad. */
void lab_rotation(const float axis[3], float angle, float out[9]);
void lab_rotate(const float rotation[9], const float v[3], float out[3]);

/* Rotates the whole object, labels too, by a random rotation, which is written. */
void lab_rotate_object(dmi_random* random, dmg_object* object, float out_rotation[9]);
/* Removes patches from the part's mask or extends it by patches of the body: one to three, each at most a seventh of
 * the part's area. */
void lab_augment_mask(dmi_random* random, dmg_object* object, uint32_t part);

/* A simulated drag: the joint value meant in each of the 16 frames, and the dragged point's path. */
typedef struct lab_stroke {
    float values[DM_MOTION_FRAMES]; /* inside the limits */
    float path[DM_MOTION_FRAMES][3];
} lab_stroke;
/* Simulates a stroke. joint: positive follows the drag. steady: the stroke that the library assumes when the host gives
 * none. noisy: adds a player's direction error, lag and tremor. */
void lab_stroke_make(dmi_random* random, const dm_joint* joint, const float drag_point[3], int steady, int noisy,
                     lab_stroke* out_stroke);

#endif
