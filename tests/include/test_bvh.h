/* Trees of a mesh as an object keeps it, which come and go together here. */
#ifndef DM_TEST_BVH_H
#define DM_TEST_BVH_H

#include "mesh/mesh.h"
#include "pick/bvh.h"

static inline dm_result test_bvh_restore(dmi_picker* picker, const dmi_mesh* mesh, const dmi_tree_shape* shapes,
                                         const dmi_progress* progress, dmi_bvh** out_bvh) {
    dmi_packed_mesh* packed = NULL;
    const dmi_unpacked all = dmi_unpacked_of(mesh);
    dm_result result = dmi_packed_mesh_create(picker->env, &all, dmi_picker_is_wide(picker), progress, &packed);
    const dmi_bvh_source source = {packed, {&mesh->parts->id, sizeof *mesh->parts}, shapes};
    *out_bvh = NULL;
    if (result == DM_OK) result = dmi_bvh_create(picker, &source, progress, out_bvh);
    if (*out_bvh == NULL) dmi_packed_mesh_destroy(picker->env, packed);
    return result;
}

static inline dm_result test_bvh_create(dmi_picker* picker, const dmi_mesh* mesh, const dmi_progress* progress,
                                        dmi_bvh** out_bvh) {
    return test_bvh_restore(picker, mesh, NULL, progress, out_bvh);
}

static inline void test_bvh_destroy(dmi_bvh* bvh) {
    if (bvh == NULL) return;
    dmi_env* env = bvh->env;
    dmi_packed_mesh* packed = (dmi_packed_mesh*)bvh->mesh;
    dmi_bvh_destroy(bvh);
    dmi_packed_mesh_destroy(env, packed);
}

#endif
