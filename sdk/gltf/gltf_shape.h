/* The triangles of one mesh of the file in the mesh's own frame, which every node that has the mesh places, and what
 * their surface looks like (gltf_surface.c). */
#ifndef DMI_GLTF_SHAPE_H
#define DMI_GLTF_SHAPE_H

#include "gltf/gltf_file.h"
#include "gltf/gltf_geometry.h"

/* Primitives that share their vertices. */
typedef struct dmi_gltf_group {
    dmi_gltf_geometry geometry;
    uint64_t first_vertex, vertex_count;
    int32_t first_run, last_run;
    int32_t unused;       /* it has vertices that no triangle has */
    const cJSON* weights; /* weights of the morph targets of its one primitive; NULL: none */
} dmi_gltf_group;

typedef struct dmi_gltf_run {
    uint32_t primitive, group;
    const cJSON* json;
    int32_t next; /* next run of the same group; -1: none */
    uint64_t first_face, face_count;
    float colour[4];
} dmi_gltf_run;

typedef struct dmi_gltf_shape {
    uint8_t shown;     /* some node that the scene shows has the mesh */
    uint8_t built;     /* the mesh was asked for; it may still be empty */
    uint32_t capacity; /* capacity of groups and runs: primitives of the mesh */
    dmi_gltf_group* groups;
    dmi_gltf_run* runs; /* one a primitive that has triangles, in file order */
    uint32_t group_count, run_count;
    float* local;       /* 3 a vertex */
    uint32_t* elements; /* per vertex: its position in the accessors */
    uint32_t* corners;  /* 3 a face, as vertices */
    uint64_t vertex_count, vertex_capacity, face_count, face_capacity;
    float low[3], high[3]; /* box of the vertices that triangles have */
} dmi_gltf_shape;

/* What building shapes needs, for all meshes of a file. */
typedef struct dmi_gltf_builder {
    dm_gltf* gltf;
    dmi_gltf_shape* shapes; /* one a mesh of the file */
    uint32_t* users;        /* per key: 1 + the mesh that has it; SEVERAL: more than one */
    uint32_t* stamps;       /* per key: 1 + the mesh whose group is in `owners` */
    uint32_t* owners;       /* per key: a group of the mesh being built */
    uint8_t* finite;        /* per key: whether all its positions are finite, once that was checked */
    uint64_t* used;         /* one bit an element of the group that is being built */
    uint32_t* places;       /* per element of that group: its vertex */
    uint64_t element_capacity;
} dmi_gltf_builder;

dm_result dmi_gltf_builder_open(dm_gltf* gltf, dmi_gltf_problem* problem, dmi_gltf_builder* out);
void dmi_gltf_builder_close(dmi_gltf_builder* builder);

/* Builds the shape of a node's mesh, unless that was done. Bad primitives are left out with a warning. */
dm_result dmi_gltf_build_shape(dmi_gltf_builder* builder, uint32_t node, dmi_gltf_problem* problem);

/* Returns the primitive's material, and writes its base colour. Without a material it returns NULL and writes white. */
const cJSON* dmi_gltf_material_of(const dm_gltf* gltf, const cJSON* primitive, float out_colour[4]);

#endif
