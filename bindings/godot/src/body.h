/* The node DragMeshBody3D: an object whose parts are nodes below it. Its frame is the object frame.
 *
 * Parts are marked, by the properties `parts` or `body`, or found out: then all nodes are handed over as one asset. */
#ifndef DRAGMESH_GODOT_BODY_H
#define DRAGMESH_GODOT_BODY_H

#include <stdbool.h>

#include "affine.h"
#include "dragmesh/dragmesh.h"
#include "engine.h"
#include "preparation.h"

enum { HANDLES = 2 }; /* of a latch: dm_drag_input.handles */

/* How a part is to behave: what its entry in the property `parts` says. */
typedef struct settings {
    int32_t joint_type; /* DM_JOINT_*; 0 = to be found out */
    bool has_joint;     /* `joint` replaces what is found */
    dm_joint joint;
    dm_drag_feel feel;
    dm_drag_rules rules;
    float snaps[DM_MAX_SNAPS];
    uint32_t handles[HANDLES]; /* ids of the parts that open its latch; 0 = none */
} settings;

typedef struct part {
    uint32_t id, parent;     /* id: place + 1; parent 0: the body */
    GDObjectInstanceID node; /* that it is called by */
    affine rest;             /* of the node, object frame */
    settings settings;
    bool locked;

    dm_part_state state; /* where `moved` */
    bool moved;
    dm_drag drag;        /* 0 = it does not move */
    bool held, by_mouse; /* by_mouse: each frame's ray pulls it */
    uint32_t events;     /* not yet told */
} part;

/* A node whose place the body knows: that of a marked part; of an asset, every one. Those above come before those
 * below. */
typedef struct member {
    GDObjectInstanceID node;
    affine rest;    /* object frame */
    uint32_t part;  /* id of the part that it goes with; 0 = the body */
    uint32_t above; /* place + 1 of the nearest member above it in the scene; 0 = none */
    bool solid;     /* it has triangles that were looked at */
    bool placed;    /* it goes with something else than what is above it */
} member;

enum {
    PROPERTY_PARTS,
    PROPERTY_BODY,
    PROPERTY_DMO,
    PROPERTY_DMO_PARTS,
    PROPERTY_PREPARE,
    PROPERTY_NAMES,
    PROPERTY_PIVOTS,
    PROPERTY_MOUSE,
    PROPERTY_BY_RULE,
    PROPERTIES
};
extern const gd_property_row body_properties[PROPERTIES];

typedef struct body {
    GDExtensionObjectPtr object;
    gd_value properties[PROPERTIES];
    part* parts;
    uint32_t part_count;
    member* members;
    uint32_t member_count;
    bool whole;  /* the parts are found out, not marked */
    int walking; /* how many functions go through the parts and call nodes, whose scripts may call this one */
    preparation* preparation; /* while one runs */
    float told_progress;
    dm_object prepared; /* 0 = not yet */
    dm_scene scene;
    uint32_t instance;
    gd_value mouse; /* a Vector2: where the pointer is */
    struct body *next, *previous;
} body;

body* body_new(GDExtensionObjectPtr object);
void body_free(body* b);

/* ---- parts and nodes: nodes.c ---- */

gd_value body_self(const body* b);
part* body_part(body* b, uint32_t id);
/* The part that a node is, or in an asset is of; NULL: none. */
part* body_part_of(body* b, const gd_value* node);
gd_value part_node(const part* p);
/* Whether a part is another, or is carried by it, over whatever is between them. */
bool part_is_carried_by(body* b, const part* p, const part* other);
/* Ends a drag and keeps where the part is. */
void part_end(part* p);
void body_forget_parts(body* b);
/* All nodes of a class below the body, those above before those below: an Array. */
gd_value body_nodes(const body* b, const char* class_name);
/* A property as text of malloc; NULL without memory. */
char* body_text_of(const gd_value* object, const char* property);
/* "above/name", with another letter between; frees both; NULL without memory. */
char* body_joined(char* above, char* name, char between);

/* ---- marked parts: parts.c ---- */

/* Whether the properties say which nodes are parts. */
bool body_is_marked(const body* b);
/* Reads which nodes are parts, where they rest and how they behave: what is marked, and every other mesh but the one
 * that stays. */
void body_find_parts(body* b);
/* Mesh and hints of all nodes; NULL without memory. */
preparation* body_collect(body* b);
/* The diagonal of a node's box at rest, squared. */
double body_size_of(const body* b, const gd_value* node);
/* Describes a part that is found out. */
void body_fill_part(part* p, uint32_t id, const member* m);

/* ---- places: places.c ---- */

/* Makes members of the nodes of marked parts, each placed by itself. */
void body_place_marked(body* b);
/* Finds what is above each member. */
void body_find_above(body* b);
/* Where the nodes of the parts are, in order of id: strings. Of an asset, each has the nodes of a part, and a last one
 * those of the body. */
gd_value body_part_paths(const body* b);
/* Where a node is in the object frame. */
affine body_place_of(const body* b, const gd_value* node);
/* Moves the nodes of a part and of what it carries to where they are now. */
void body_show(body* b, part* p);
/* The pose of what carries a part, from rest. */
dm_pose body_carrier(body* b, const part* p);

/* ---- parts that are found out: whole.c ---- */

/* Reads all nodes as those of one asset; what the parts are is not known yet. */
void whole_find_members(body* b);
/* The nodes with their meshes; NULL without memory. */
preparation* whole_collect(body* b);
/* Makes the parts that the answer says, or that the property `dmo_parts` says of a loaded object. */
dm_result whole_take_answer(body* b, const preparation* p, dm_object object);
dm_result whole_take_paths(body* b, dm_object object);

/* ---- objects: body.c ---- */

/* In the background; `prepared` is emitted when it is done. It, and the two below, do nothing while the parts are gone
 * through: DM_ERROR_UNSUPPORTED. */
void body_prepare(body* b);
dm_result body_prepare_now(body* b);
/* Loads the bytes of the property `dmo`. */
dm_result body_load(body* b);
void body_unload(body* b);
void body_ready(body* b);
/* One frame: preparation, parts that the mouse holds or that move by themselves, signals. */
void body_advance(body* b, double seconds);
void body_process(body* b);
void body_input(body* b, const gd_value* event);

/* ---- drags: drags.c ---- */

dm_result part_grab(body* b, part* p, const dm_vec3* point, bool by_mouse);
/* One update; events are added to part.events. */
dm_result part_step(body* b, part* p, dm_drag_input* input, double seconds, dm_drag_state* out);
/* Takes a state over: the joint value, the pose, the nodes. */
void part_take(body* b, part* p, const dm_drag_state* state);
dm_result part_release(body* b, part* p, int32_t intent, dm_release_plan* out);
/* A ray of the world in the frame of what carries a part; p NULL: in the object frame. */
dm_ray body_ray(body* b, const part* p, const double origin[3], const double direction[3]);
/* Nearest hit of a ray of the world; distance: in the world. */
bool body_pick(body* b, const double origin[3], const double direction[3], dm_hit* out, double* distance);
/* Emits what happened since it was last called. The node may be gone after it. */
void body_tell(body* b);
void body_register_signals(GDExtensionClassLibraryPtr library, const char* class_name);

/* ---- class.c ---- */

void body_register(GDExtensionClassLibraryPtr library);
void body_unregister(GDExtensionClassLibraryPtr library);

#endif
