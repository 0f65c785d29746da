/* A rigged asset as simulators and engines take it, whatever the format: bodies in metres, Z up, that hang on each
 * other by joints, with masses and collision boxes. The files of the formats only print it. */
#ifndef DMI_EXPORT_RIG_MODEL_H
#define DMI_EXPORT_RIG_MODEL_H

#include <stdbool.h>

#include "base/arena.h"
#include "dragmesh/ext/gltf_rig.h"
#include "math/frames.h"

/* Bytes of a legal name, the zero included, and how many of them the asset's own words may take; by hand. */
enum { DMI_RIG_NAME = 80, DMI_RIG_WORDS = 60 };

/* Triangles that one or more bodies show. */
typedef struct dmi_rig_mesh {
    char name[DMI_RIG_NAME];
    float (*points)[3]; /* points about the middle of the mesh's box */
    uint32_t (*faces)[3];
    uint32_t point_count, face_count;
} dmi_rig_mesh;

/* A mesh as a body shows it. */
typedef struct dmi_rig_shape {
    uint32_t mesh, body, node;
    double place[3]; /* place of the mesh's middle: in the asset frame first, then in that of the body */
    float colour[4];
} dmi_rig_shape;

/* A collision box in the body's frame. */
typedef struct dmi_rig_box {
    double centre[3], half[3];
} dmi_rig_box;

/* How a body moves against what carries it. */
typedef enum dmi_rig_kind {
    DMI_RIG_ROOT, /* it stays */
    DMI_RIG_HINGE,
    DMI_RIG_SLIDE,
    DMI_RIG_SCREW,
    DMI_RIG_FREE,
    DMI_RIG_KINDS
} dmi_rig_kind;

/* A body. At rest all bodies have the axes of the asset. A joint's line goes through the origin of its body. */
typedef struct dmi_rig_body {
    char name[DMI_RIG_NAME], joint_name[DMI_RIG_NAME];
    const char* original;  /* the asset's own name; "": none */
    uint32_t part, parent; /* part: DM_ASSET_NO_PART for the root; parent: a body before this one */
    dmi_rig_kind kind;
    double origin[3];            /* asset frame */
    double place[3];             /* frame of the parent */
    double axis[3];              /* unit */
    bool limited, is_range_made; /* is_range_made: its limits are not the asset's */
    double lower, upper;         /* rad; m for a slide */
    double pitch;                /* m a radian, for a screw */
    double damping, friction;    /* N m s and N m; N s/m and N for a slide */
    double mass, centre[3];      /* kg; m, in the body's frame */
    double inertia[3][3];        /* kg m², about the centre of mass */
    uint32_t first_shape, shape_count, first_box, box_count;
} dmi_rig_body;

/* Stated values, defaults put in. */
typedef struct dmi_rig_values {
    double density, thickness, friction, damping_time; /* 0: no friction, no damping */
} dmi_rig_values;

typedef struct dmi_rig_model {
    dmi_env* env;
    dmi_arena arena;
    const dm_gltf_rig_desc* desc;
    dmi_axes axes;
    dmi_rig_values values;
    char name[DMI_RIG_NAME];
    const char* original;
    double size;          /* m, largest side of the box of all shapes */
    dmi_rig_body* bodies; /* the root first, parents before what they carry */
    dmi_rig_mesh* meshes;
    dmi_rig_shape* shapes; /* shapes, sorted by body */
    dmi_rig_box* boxes;    /* boxes, sorted by body */
    uint32_t body_count, mesh_count, shape_count, box_count;
} dmi_rig_model;

/* Makes the model of a description that was checked. dmi_rig_model_close frees it, also after a failure. */
dm_result dmi_rig_model_make(dmi_env* env, const dm_gltf_rig_desc* desc, dmi_rig_model* out);
void dmi_rig_model_close(dmi_rig_model* model);

/* Takes memory of the model; NULL: there is none, which was logged. */
static inline void* dmi_rig_push(dmi_rig_model* model, size_t count, size_t size) {
    void* memory = count <= SIZE_MAX / 2 / size ? dmi_arena_push(&model->arena, count * size) : NULL;
    if (memory == NULL) dmi_fail(model->env, DM_ERROR_OUT_OF_MEMORY, "dm_gltf_rig_make: no memory for the model");
    return memory;
}

/* ---- steps of dmi_rig_model_make, each in its file ---- */

/* Makes the bodies of the parts that move, and says which body each part goes with. */
dm_result dmi_rig_make_bodies(dmi_rig_model* model, uint32_t* out_part_bodies);
/* Reads the meshes of the nodes as shapes of the bodies. Alike meshes become one. */
dm_result dmi_rig_make_shapes(dmi_rig_model* model, const uint32_t* part_bodies);
/* Weighs the bodies and boxes them, piece by piece. */
dm_result dmi_rig_make_masses(dmi_rig_model* model);

/* ---- what formats ask ---- */

static inline bool dmi_rig_turns(const dmi_rig_body* body) {
    return body->kind == DMI_RIG_HINGE || body->kind == DMI_RIG_SCREW;
}

#endif
