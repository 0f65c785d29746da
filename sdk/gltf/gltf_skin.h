/* Skins: which bone has a vertex, and where the bones put it. */
#ifndef DMI_GLTF_SKIN_H
#define DMI_GLTF_SKIN_H

#include "gltf/gltf_shape.h"

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
