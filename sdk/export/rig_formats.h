/* Formats of rigged assets, each of which prints the model, and what several of them ask for: meshes, axes, clips. */
#ifndef DMI_EXPORT_RIG_FORMATS_H
#define DMI_EXPORT_RIG_FORMATS_H

#include "export/rig_model.h"
#include "export/rig_text.h"

typedef void dmi_rig_print(const dmi_rig_model* model, dmi_text* out);

dmi_rig_print dmi_rig_print_urdf, dmi_rig_print_mjcf, dmi_rig_print_sdf, dmi_rig_print_usda, dmi_rig_print_tscn;
/* Prints one mesh as Wavefront's OBJ, in metres. */
void dmi_rig_print_obj(const dmi_rig_mesh* mesh, dmi_text* out);
/* Lifts a corner of a mesh that lies in one plane by a millionth of its size, or by what a volume of 2e-14 m³ takes,
 * but not by more than `most`. MuJoCo 3 refuses meshes without a volume, also those that nothing collides with. */
void dmi_rig_lift_corner(dmi_rig_mesh* mesh, double most);

/* Writes the shortest turn from x to a unit axis: a quaternion x, y, z, w. */
void dmi_rig_turn_to_axis(const double axis[3], double out_turn[4]);
/* Writes a right-handed frame, three unit vectors, of which number `which` is the axis. */
void dmi_rig_joint_frame(const double axis[3], int which, double out_frame[3][3]);
/* Writes the principal moments of inertia and the turn from their axes to those of the body, x, y, z, w. */
void dmi_rig_principal(const dmi_rig_body* body, double out_moments[3], double out_turn[4]);

#define DMI_RIG_MESHES "meshes/" /* the folder of the OBJ files */

/* What the files of all formats state of a joint without limits of its own, and of how it is driven; by hand. */
#define DMI_RIG_EFFORT 1000.0  /* N, N m; the most that drives it */
#define DMI_RIG_VELOCITY 100.0 /* m/s, rad/s; the fastest that it moves */

/* ---- the animation that opens and closes the parts ---- */

/* Returns whether a clip of the file itself moves a body, or what carries it: another animation would move it twice. */
bool dmi_rig_is_left_to_clip(const dmi_rig_model* model, uint32_t body);
/* Makes a track for each body but the root and those left to clips, in their order, in memory of the model. The nodes
 * are those of the model's file. */
dm_result dmi_rig_make_tracks(dmi_rig_model* model, dm_gltf_track** out_tracks, uint32_t* out_count);
/* Writes the file of the model's nodes with an animation, joints, masses and collision boxes, into memory of the host.
 * The root is not the only body. */
dm_result dmi_rig_write_glb(dmi_rig_model* model, void** out_data, size_t* out_size);

#endif
