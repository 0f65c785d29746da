/* A prepared object: how each of its parts moves, and the triangles it keeps for picking. */
#ifndef DMI_OBJECT_OBJECT_H
#define DMI_OBJECT_OBJECT_H

#include "kinematics/inference/joint_inference.h"
#include "pick/pick.h"

/* Of a part's cloud, kept for the motion network, which sees a part through so few points. */
#define DMI_OBJECT_POINTS 512
#define DMI_OBJECT_STRIDE (DMI_CLOUD_POINTS / DMI_OBJECT_POINTS)

typedef struct dmi_object_part {
    dmi_part shape;                     /* shape.parent: index in dmi_object.parts */
    int32_t given_type;                 /* DM_JOINT_* as the host said it; UNKNOWN: the library's to find */
    dm_joint joint;                     /* in force; host object frame */
    dmi_hypotheses hypotheses;          /* inner frame */
    dmi_alternatives alternatives;      /* inner frame */
    float points[DMI_OBJECT_POINTS][3]; /* dmi_cloud_thin; inner frame */
} dmi_object_part;

typedef struct dmi_object {
    dmi_frame frame;
    float box_min[3], box_max[3]; /* inner frame */
    uint64_t vertex_count, triangle_count, seed;
    dmi_object_part* parts; /* [0] is the body; then parts by rising id */
    uint32_t part_count;    /* the body included */
    int network_alone;      /* joints are found by the network, unaided */
    dmi_mesh* mesh;         /* NULL: kept no triangles */
    dmi_bvh* bvh;           /* NULL: kept no triangles */
} dmi_object;

/* Parts zeroed. */
dm_result dmi_object_create(dmi_env* env, uint32_t part_count, dmi_object** out_object);
/* NULL does nothing. */
void dmi_object_destroy(dmi_env* env, dmi_object* object);
/* Frees the triangles, and with them picking and refinement. */
void dmi_object_drop_triangles(dmi_env* env, dmi_object* object);

/* Index of a part by the host's id; -1 when there is none (0 is the body). */
int32_t dmi_object_find_part(const dmi_object* object, uint32_t id);
/* 1 when part `index` is `ancestor` or is carried by it. */
int dmi_object_moves_with(const dmi_object* object, uint32_t index, uint32_t ancestor);

/* Sets the object's box from its parts'. */
void dmi_object_bound(dmi_object* object);
/* Box of an inner box's corners in the host object frame: tight for axes that permute, else it covers. */
void dmi_object_box_out(const dmi_frame* frame, const float min[3], const float max[3], dm_vec3* out_min,
                        dm_vec3* out_max);

/* Checks a host's drag on a part and brings it into the inner frame. Errors: NOT_FINITE, ZERO_DRAG, DRAG_OFF_PART, with
 * `what` ("dm_function: field") in the message. */
dm_result dmi_object_hint(dmi_env* env, const char* what, const dmi_object* object, uint32_t part,
                          const dm_drag_hint* drag, dmi_drag_hint* out_hint);

/* Points 0, 8, 16, ... of a cloud, as dmi_vae_object_points takes them; and a cloud that thins to a part's points. */
void dmi_cloud_thin(const dmi_cloud* cloud, float out_points[DMI_OBJECT_POINTS][3]);
void dmi_cloud_widen(const dmi_object_part* part, dmi_cloud* out_cloud);

#endif
