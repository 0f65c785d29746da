/* Which nodes of an asset are one body, which bodies may move, and which carries which. */
#ifndef DMI_ASSETS_ASSET_GROUPING_H
#define DMI_ASSETS_ASSET_GROUPING_H

#include <stdbool.h>

#include "assets/asset_models.h"
#include "assets/node_cells.h"
#include "assets/node_labels.h"
#include "base/arena.h"
#include "base/progress.h"
#include "mesh/mesh.h"

#define DMI_ASSET_BODY UINT32_MAX /* stands for an index: the body that stays, or nothing */
#define DMI_ASSET_MAX_UNITS 1024  /* nodes with faces that are grouped: tables of pairs stay below 20 MB */

/* What is known of a node before its shape is looked at. */
typedef struct dmi_asset_node {
    const char *name, *mesh_name; /* "": none */
    uint32_t parent;              /* or DMI_ASSET_BODY */
    bool follows;                 /* neither part nor body; it has no faces in the mesh */
    bool is_fixed;                /* certainly one body with its parent */
    uint32_t given_body; /* nodes with the same number, other than DMI_ASSET_BODY, are one part that moves, for certain:
                            clips or joints of the file say so */
} dmi_asset_node;

typedef struct dmi_asset_query {
    const dmi_mesh* mesh; /* parts[i + 1] has the faces of node i; without faces where it has no mesh or follows */
    const dmi_asset_node* nodes;
    const uint32_t* order; /* the nodes, each after its parent */
    uint32_t node_count;
    bool use_names;
    const dmi_asset_models* models; /* NULL: by rules */
    float min_moves;                /* bodies whose probability is below stay, unless they are given */
    const dmi_progress* progress;
    dmi_arena* arena; /* holds the answers too */
} dmi_asset_query;

typedef struct dmi_asset_body {
    uint32_t carrier; /* index of the body that carries it, or DMI_ASSET_BODY */
    float moves;      /* probability that it moves against its carrier */
} dmi_asset_body;

typedef struct dmi_asset_bodies {
    dmi_asset_body* bodies; /* those that move, then those that might */
    uint32_t count;
    uint32_t* body_of_node; /* one a node; DMI_ASSET_BODY: it stays */
} dmi_asset_bodies;

/* Returns whether the carrier is the body itself, or carries it, directly or through others. */
static inline bool dmi_asset_is_carried_by(const dmi_asset_bodies* bodies, uint32_t body, uint32_t carrier) {
    while (body != DMI_ASSET_BODY && body != carrier) body = bodies->bodies[body].carrier;
    return body == carrier;
}

/* Finds the bodies that may move. */
dm_result dmi_asset_find_bodies(dmi_env* env, const dmi_asset_query* query, dmi_asset_bodies* out);

/* Drops the bodies for which keep is 0, and renumbers the others. Their nodes become those of what carries them. */
void dmi_asset_bodies_keep(dmi_asset_bodies* bodies, uint32_t node_count, const uint8_t* keep, uint32_t* scratch);

/* ---- which units go with which body, and which body carries which (body_carriers.c) ---- */

/* Nodes with faces, or nodes that are one body for certain. */
typedef struct dmi_asset_units {
    uint32_t* of_node; /* UINT32_MAX: it has no faces */
    uint32_t* of_part; /* index in mesh->parts -> unit; UINT32_MAX: none */
    uint32_t* node;    /* unit -> the first of its nodes */
    uint32_t count;
} dmi_asset_units;

/* Gives units of no body that touch a body, directly or through each other, and nothing else that stays, to the body
 * that they touch most: a handle goes with its door, a book with its drawer. body_of_unit: UINT32_MAX: it stays. */
dm_result dmi_asset_attach_loose_units(dmi_arena* arena, const dmi_node_cells* grid, uint32_t body_count,
                                       uint32_t* inout_body_of_unit);

/* Sets the carriers of all bodies: by the models, else by rules. The units are the grid's nodes. */
dm_result dmi_asset_find_carriers(const dmi_asset_query* query, const dmi_asset_units* units,
                                  const dmi_node_cells* grid, const dmi_node_labels* labels,
                                  const uint32_t* body_of_unit, dmi_asset_bodies* inout_bodies);

#endif
