/* dragmesh extension in libdragmesh_gltf: writes a rigged asset as files of engines and simulators. It needs no
 * context. It is a draft: unlike dm.core/1 it may change with a minor version, so use the library of the header's own
 * version (dm_gltf_version). All functions [any-thread]; one dm_gltf_rig is for one thread at a time. */
#ifndef DRAGMESH_EXT_GLTF_RIG_H
#define DRAGMESH_EXT_GLTF_RIG_H

#include "dragmesh/ext/gltf.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Formats, as bits. docs/exports.md says which consumers read them and what each one cannot hold. */
enum {
    DM_GLTF_RIG_URDF = 1,  /* rigged.urdf: ROS, Gazebo, MuJoCo, Bullet */
    DM_GLTF_RIG_MJCF = 2,  /* rigged.xml: MuJoCo */
    DM_GLTF_RIG_SDF = 4,   /* rigged.sdf, SDF 1.7: Gazebo */
    DM_GLTF_RIG_USDA = 8,  /* rigged.usda, with UsdPhysics: Isaac Sim, Omniverse; all in one file */
    DM_GLTF_RIG_TSCN = 16, /* rigged.tscn: Godot 4 */
    /* rigged.glb: the file with an animation that opens and closes all parts, with KHR_physics_rigid_bodies,
     * KHR_implicit_shapes and KHR_node_selectability, and with the joints in `extras` as dm_gltf_get_asset reads them.
     * What a clip of the file moves, with all that it carries, is left to that clip, and has its joint in `extras`
     * alone. */
    DM_GLTF_RIG_GLB = 32
};

/* The input and the answers of dm_asset_create. Everything is borrowed for the call. */
typedef struct dm_gltf_rig_desc {
    uint32_t struct_size;
    uint32_t formats;              /* DM_GLTF_RIG_* */
    const dm_asset_node* nodes;    /* the nodes that dm_asset_create took */
    const dm_asset_part* parts;    /* all parts that dm_asset_get_part answers; NULL: none */
    const dm_joint* joints;        /* all joints that dm_asset_get_joint answers, one a part */
    const uint32_t* node_parts;    /* what dm_asset_get_node_parts answers */
    const float* colours;          /* red, green, blue, opacity of each node, linear; NULL: white */
    const char* name;              /* name of the asset, UTF-8; NULL: "asset" */
    const char* const* part_names; /* name of each part, UTF-8; NULL: that of its first node that has one */
    /* The file whose dm_gltf_get_asset has made the nodes; NULL: there is none. A GLB needs it. Where `colours` is
     * NULL, nodes have the colours of the file. */
    dm_gltf* gltf;
    uint32_t node_count, part_count;
    int32_t axes;         /* axes of the asset frame: DM_AXES_*, except DM_AXES_CUSTOM */
    float unit_in_metres; /* length of one unit of the asset, m; 0 = 1 */
    float density;        /* density of closed pieces, kg/m³; 0 = 600, wood */
    float thickness;      /* thickness of pieces that are open surfaces, m; 0 = 0.003 */
    float friction;       /* share of a part's weight that holds it back; 0 = 0.1; negative: none */
    /* Seconds in which a part that nothing drives loses 63 % of its speed; 0 = 0.5; negative: no damping. */
    float damping_time;
    dm_allocator allocator; /* zeros = malloc/free */
    dm_log log;             /* zeros = silent; gets warnings of what a format cannot hold */
} dm_gltf_rig_desc;

typedef struct dm_gltf_rig dm_gltf_rig;

typedef struct dm_gltf_rig_file {
    const char* path; /* path below the folder of the rig: letters, digits, '_', '.', and '/' between folders */
    const void* data; /* lives as long as the dm_gltf_rig */
    size_t size;
} dm_gltf_rig_file;

/* Makes the files of all formats asked for in memory, with the meshes that they share. Parts that move become bodies,
 * in metres and Z up, hung on what carries them. Parts that stay, and fixed ones, are one with it. Bodies are called
 * part_N_NAME, where N is the part's index + 1 and NAME what is legal of its first node's name; the body that stays is
 * "body". Errors: those of the meshes, NOT_FINITE, INVALID_ARGUMENT (no format, parents in a circle),
 * INDEX_OUT_OF_RANGE, DEGENERATE_MESH (no triangle), OUT_OF_MEMORY, STRUCT_SIZE. */
DM_API dm_result DM_CALL dm_gltf_rig_make(const dm_gltf_rig_desc* desc, dm_gltf_rig** out_rig);
/* Frees the files. NULL does nothing. */
DM_API void DM_CALL dm_gltf_rig_destroy(dm_gltf_rig* rig);
/* Returns how many files there are, and 0 for NULL. */
DM_API uint32_t DM_CALL dm_gltf_rig_file_count(const dm_gltf_rig* rig);
/* Writes the path and the bytes of a file. Meshes come before the files that refer to them. Errors: INVALID_ARGUMENT,
 * NOT_FOUND. */
DM_API dm_result DM_CALL dm_gltf_rig_get_file(const dm_gltf_rig* rig, uint32_t index, dm_gltf_rig_file* out_file);

#ifdef __cplusplus
}
#endif

#endif
