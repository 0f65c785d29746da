/* Packs, unpacks and stores the triangles of an object. */
#include "kinematics/object/object_mesh.h"

#include "pick/backend.h"

static dmi_bvh_source source_of(const dmi_object* object, const dmi_tree_shape* shapes) {
    return (dmi_bvh_source){
        .mesh = object->mesh, .ids = {&object->parts->shape.id, sizeof *object->parts}, .shapes = shapes};
}

dm_result dmi_object_pack(dmi_env* env, const dmi_unpacked* from, bool wide, const dmi_progress* progress,
                          dmi_object* object) {
    return dmi_packed_mesh_create(env, from, wide, progress, &object->mesh);
}

dm_result dmi_object_make_trees(dmi_picker* picker, const dmi_tree_shape* shapes, const dmi_progress* progress,
                                dmi_object* object) {
    const dmi_bvh_source source = source_of(object, shapes);
    return dmi_bvh_create(picker, &source, progress, &object->bvh);
}

dm_result dmi_object_unpack(dmi_env* env, const dmi_object* object, const dmi_progress* progress, dmi_mesh** out_mesh) {
    const dmi_packed_mesh* packed = object->mesh;
    dmi_mesh* mesh = NULL;
    dm_result result =
        dmi_mesh_restore(env, &object->frame, packed->vertex_count, packed->face_count, packed->part_count, &mesh);
    if (result != DM_OK) return result;
    dmi_packed_mesh_unpack(packed, mesh);
    for (uint32_t i = 0; i < packed->part_count; i++) {
        mesh->parts[i].id = object->parts[i].shape.id;
        mesh->parts[i].parent = object->parts[i].shape.parent;
        mesh->parts[i].face_count = packed->parts[i].face_count;
    }
    result = dmi_mesh_measure(env, progress, mesh);
    if (result != DM_OK) {
        dmi_mesh_destroy(env, mesh);
        return result;
    }
    *out_mesh = mesh;
    return DM_OK;
}

dm_result dmi_object_stored_trees(dmi_env* env, const dmi_object* object, const dmi_bvh** out_trees,
                                  dmi_bvh** out_made) {
    dmi_tree_shape shape;
    *out_trees = *out_made = NULL;
    if (object->mesh == NULL) return DM_OK;
    if (dmi_bvh_shapes(object->bvh, 0, &shape)) {
        *out_trees = object->bvh;
        return DM_OK;
    }
    const dmi_bvh_source source = source_of(object, NULL);
    const dm_result result = dmi_bvh_create_to_store(env, &source, out_made);
    *out_trees = *out_made;
    return result;
}
