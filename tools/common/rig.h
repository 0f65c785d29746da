/* A whole asset, rigged: which of a file's nodes move, how, and what carries what. */
#ifndef CLI_RIG_H
#define CLI_RIG_H

#include "job.h"
#include "session.h"

#define RIG_USUAL_MOVES 0.5 /* as dm_asset_desc.min_moves */

/* How to rig. */
typedef struct rig_options {
    bool without_names, without_clips, without_pivots;
    double min_moves; /* probability from which on a part moves */
    uint32_t formats; /* that are written: DM_GLTF_RIG_* */
    char up;          /* of the files: 'x', 'y' or 'z'; 0: nothing says it, as in glTF 'y' */
} rig_options;

typedef struct rig_part {
    dm_asset_part part;
    dm_joint joint;  /* in the session's frame */
    uint32_t* nodes; /* part.node_count positions in rig.nodes */
} rig_part;

typedef struct rig {
    const dm_asset_node* nodes; /* of the session's file */
    uint32_t node_count;
    dm_asset asset;
    dm_asset_info info;
    rig_part* parts; /* info.part_count */
    double seconds;  /* that the asset took, its file included */
} rig;

/* Rigs a file, which becomes the session's. */
dm_result rig_make(session* session, const char* path, const rig_options* options, rig* out_rig);
void rig_free(session* session, rig* rig);

/* Returns the name of the node that carries most of a part; "": it has none. */
const char* rig_part_name(const rig* rig, uint32_t index);
/* Returns the id of the part that moves each face of the session's mesh; 0: it stays. To be freed. */
uint32_t* rig_face_parts(const session* session, const rig* rig);

#endif
