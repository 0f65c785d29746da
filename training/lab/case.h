/* One training case: a generated object, disturbed, and one of its joints, as the library itself sees them. */
#ifndef DM_LAB_CASE_H
#define DM_LAB_CASE_H

#include "base/random.h"
#include "dragmesh_lab.h"
#include "generator.h"
#include "kinematics/kpp_input.h"
#include "math/joint.h"

typedef struct lab_case {
    dmi_random random;
    dmg_object object;
    dmi_mesh* mesh;
    uint32_t* welded; /* the mesh's vertices, for studies of the part; NULL in a case of the caller's */
    dmi_cloud cloud;
    dm_joint joint; /* object-normalised, positive opens, origin nearest the part's centre */
    uint32_t category_id;
    uint32_t part; /* the generator's id */
} lab_case;

/* The `index`-th case of the options' stream. Release after success. */
dm_result lab_case_make(dmi_env* env, const dm_lab_options* options, uint64_t index, lab_case* out_case);
void lab_case_release(dmi_env* env, lab_case* made);

/* A case from a mesh and joint of the caller's, which it borrows. Release after success. */
struct dm_lab_given;
dm_result lab_case_given(dmi_env* env, const struct dm_lab_given* given, lab_case* out_case);

/* A hand's drag on the case's part, in the object-normalised frame: mostly opening, sometimes closing where the joint
 * has room for that. The joint comes back signed so that positive follows the drag. */
dmi_drag_hint lab_case_drag(lab_case* made, float noise_degrees, dm_joint* out_joint);

/* The drag of a case given, turned about any direction by a random angle, and the joint signed along it. */
dmi_drag_hint lab_given_drag(lab_case* made, const struct dm_lab_given* given, float noise_degrees,
                             dm_joint* out_joint);

/* [low, high) */
float lab_random_uniform(dmi_random* random, float low, float high);
int lab_random_bool(dmi_random* random, float probability);
/* Uniform on the sphere. */
void lab_random_direction(dmi_random* random, float out[3]);
/* Row-major rotation about a unit axis. */
void lab_rotation(const float axis[3], float angle, float out[9]);
void lab_rotate(const float rotation[9], const float v[3], float out[3]);

/* Turns the whole object, labels too, by a random rotation. */
void lab_rotate_object(dmi_random* random, dmg_object* object);
/* Patches of the part's mask get lost, or leak onto what is near: at most a seventh of its area each. */
void lab_augment_mask(dmi_random* random, dmg_object* object, uint32_t part);

/* A joint value for each of the 16 frames, and where a hand that means them draws the drag point. */
typedef struct lab_stroke {
    float values[DM_MOTION_FRAMES]; /* inside the limits */
    float path[DM_MOTION_FRAMES][3];
} lab_stroke;
/* joint: positive follows the drag. steady: the stroke the library assumes when the host draws none. */
void lab_stroke_make(dmi_random* random, const dm_joint* joint, const float drag_point[3], int steady, int noisy,
                     lab_stroke* out_stroke);

#endif
