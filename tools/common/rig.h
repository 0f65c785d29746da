/* A whole asset, rigged: which of a file's nodes move, how, and what carries what. */
#ifndef CLI_RIG_H
#define CLI_RIG_H

#include "file_set.h"
#include "job.h"
#include "session.h"

#define RIG_USUAL_MOVES 0.5 /* as dm_asset_desc.min_moves */
enum {
    RIG_FORMATS_TEXT = 64,
    RIG_OPTIONS_TEXT = 256
}; /* bytes of a list of all formats, of rig_options_text; by hand */

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
/* Adds `nodes` and `node_indices` of a part: the names of its nodes, and their indices in the file. */
void rig_nodes_to_json(const session* session, const rig* rig, uint32_t index, cJSON* out);

/* Returns what was asked for, as text: with another text, an answer is another. */
const char* rig_options_text(const rig_options* options, char* out, size_t size);
/* Returns the answer: parts with nodes, carriers, joints and probabilities, and warnings. */
cJSON* rig_to_json(const session* session, const rig* rig, const rig_options* options);
/* Writes `%s` with what the parts are: "3 of 12 parts move". */
void rig_describe(const rig* rig, char* out, size_t size);

/* Writes the poses of all parts, those that carry them included, at a share of the way from rest to open, 0 to 1.
 * out_poses: by part id, 1 and the count of parts. */
dm_result rig_pose(const rig* rig, float share, dm_pose* out_poses);
/* Returns the id of the part that moves each face of the session's mesh; 0: it stays. To be freed. */
uint32_t* rig_face_parts(const session* session, const rig* rig);

/* Reads a list of formats, "glb,urdf". Returns their bits; 0, and the name that is none: one is unknown. */
uint32_t rig_read_formats(const char* list, char* out_unknown, size_t size);
/* Writes the list for bits. */
void rig_format_names(uint32_t formats, char* out, size_t size);
/* Writes the files of the formats into a folder. Where nothing moves there is no GLB: it would be the file itself. */
dm_result rig_write_formats(file_set* set, const rig* rig, uint32_t formats, const char* folder);
/* Writes a strip of pictures from closed to open, with the axes of the parts. up: 'x', 'y' or 'z'. */
dm_result rig_write_film(file_set* set, const rig* rig, char up, const char* path);

#endif
