/* The merged mesh of a file whose tree is read, in which gltf_instance.c places the shapes. Those with a skin stand
 * where its bones put them (gltf_skin.c). */
#ifndef DMI_GLTF_MERGE_H
#define DMI_GLTF_MERGE_H

#include "gltf/gltf_file.h"
#include "gltf/gltf_shape.h"

/* Fills nodes, pieces, positions, indices and what belongs to them. */
dm_result dmi_gltf_merge(dm_gltf* gltf, dmi_gltf_problem* problem);

/* Appends the triangles of a node to the merged mesh, whose arrays have room for them. */
dm_result dmi_gltf_add_rigid(dm_gltf* gltf, const dmi_gltf_shape* shape, uint32_t node, dmi_gltf_problem* problem);
/* Does the same for a node with a skin, bone by bone. A skin that cannot be used is left out with a warning. */
dm_result dmi_gltf_add_skinned(dm_gltf* gltf, const dmi_gltf_shape* shape, uint32_t node, dmi_gltf_problem* problem);

/* ---- skins: which bone has a vertex, and where the bones put it ---- */

typedef struct dmi_gltf_joint {
    uint32_t node;     /* node of the file */
    double matrix[16]; /* matrix from the mesh to the scene, as the nodes stand */
} dmi_gltf_joint;

typedef struct dmi_gltf_skin {
    dmi_gltf_joint* joints;
    uint32_t joint_count;
} dmi_gltf_skin;

/* Marks the nodes that are joints of some skin. */
void dmi_gltf_mark_joints(dm_gltf* gltf);
/* Reads the skin of a node. Answers BAD_DATA and the like when it cannot be used, with the reason. */
dm_result dmi_gltf_open_skin(dm_gltf* gltf, double index, const char* place, dmi_gltf_problem* problem,
                             dmi_gltf_skin* out);
void dmi_gltf_close_skin(dmi_env* env, dmi_gltf_skin* skin);

/* Writes for each vertex of the shape its heaviest joint and its place in the scene. Returns how many vertices have
 * another joint of some weight, or -1 when one has no joint at all. */
int64_t dmi_gltf_skin_vertices(const dmi_gltf_skin* skin, const dmi_gltf_shape* shape, uint32_t* out_joints,
                               double (*out_positions)[3]);

#endif
