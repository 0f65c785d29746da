/* Prepares an object: infers the joint of each part of a mesh. */
#ifndef DMI_OBJECT_PREPARE_H
#define DMI_OBJECT_PREPARE_H

#include "kinematics/object/object.h"

/* What an object's descriptor says of all its parts. */
typedef struct dmi_object_labels {
    const char* label; /* NULL: none */
    dm_vec3 up;        /* host object frame; 0: that of the axes */
} dmi_object_labels;

typedef struct dmi_prepare_desc {
    const dmi_axes* axes;
    const dm_mesh_desc* mesh;
    const dm_part_desc* parts; /* NULL: every id in the mesh is a part of the body */
    uint32_t part_count;
    dmi_inference_models models;
    dmi_object_labels labels;
    uint64_t seed;
    bool mesh_is_incomplete; /* DM_PREPARE_MESH_INCOMPLETE */
    bool keep_triangles;
    bool without_trees;        /* no trees to pick by, whatever keep_triangles says */
    bool network_alone;        /* joints are inferred by models.kpp alone */
    dm_intent_callback intent; /* NULL: none */
    void* intent_user;
    dm_choice_callback choose; /* NULL: none; called on this thread alone */
    void* choose_user;
    dm_progress_callback progress; /* NULL: the context's; called on this thread alone */
    void* progress_user;
    /* Progress of the call that this preparation is a piece of; NULL: it is the whole call. */
    const dmi_progress* watched;
} dmi_prepare_desc;

/* Prepares an object. The result has the same bits for any number of workers behind env->jobs. */
dm_result dmi_object_prepare(dmi_env* env, dmi_picker* picker, const dmi_prepare_desc* desc, dmi_object** out_object);

/* Infers the joint of one part again, with a drag; the best hypothesis becomes the joint in use. The object must have
 * kept its triangles. */
dm_result dmi_object_refine(dmi_env* env, dmi_object* object, uint32_t part, const dmi_inference_models* models,
                            const dmi_drag_hint* hint);

#endif
