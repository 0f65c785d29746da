/* Who moves with which track of an export, the keys of a track as an animated node, and meshes of what moves
 * (gltf_split.c). */
#ifndef DMI_GLTF_MOVES_H
#define DMI_GLTF_MOVES_H

#include "gltf/gltf_edit.h"

/* What moves the triangles of a node: a track by its number from 0, or one of these. */
enum { DMI_MOVES_NOTHING = -1 /* it stays */, DMI_MOVES_EMPTY = -2 /* no triangles */, DMI_MOVES_MIXED = -3 };

typedef struct dmi_moves {
    dm_gltf* gltf;
    uint32_t track_count;
    uint32_t* owners;       /* per face: 1 + the track that moves it; 0: it stays */
    uint64_t* faces;        /* one a track */
    int32_t* own;           /* per node of the file: what moves its own triangles */
    int32_t* below;         /* per node of the file: what moves it with all below it */
    uint32_t* first_pieces; /* per node of the file: its first piece */
    uint32_t* places;       /* per merged vertex: zeros, for functions that need such an array */
} dmi_moves;

/* Gives every face to the first track that claims it. Answers EMPTY_MASK for a track that gets none. */
dm_result dmi_moves_open(dmi_moves* m, dmi_env* env, dm_gltf* gltf, const dm_gltf_track* tracks, uint32_t track_count);
void dmi_moves_close(dmi_moves* m, dmi_env* env);
/* Returns how many faces of a piece `owner` has, as dmi_moves.owners counts. */
uint64_t dmi_moves_count(const dmi_moves* m, const dmi_gltf_piece* piece, uint32_t owner);

/* ---- keys of a track as an animated node ---- */

/* Adds an animation in front of all others, so that a viewer plays it. */
cJSON* dmi_animation_add(dmi_edit* e, const char* name);
/* Adds the node that the track moves and its channels. Returns the node, which has no children yet and stands at
 * `out_pivot` in the scene. */
dmi_edit_item dmi_animation_add_track(dmi_edit* e, const dmi_moves* moves, cJSON* animation, const dm_gltf_track* track,
                                      uint32_t index, double out_pivot[3]);

/* ---- meshes of some of a node's triangles ---- */

/* Adds a mesh of the triangles of a node that `owner` has (as dmi_moves.owners counts), with owner 0 also of what has
 * no triangles. Returns its index, or -1 when there is nothing. For a node with a skin, a mesh that moves stands in the
 * scene's frame, less the origin, and has no bones. */
int32_t dmi_split_mesh(dmi_edit* e, const dmi_moves* moves, uint32_t node, uint32_t owner);

#endif
