/* The node DragMeshBody3D: an object whose parts are nodes below it. Its frame is the object frame. */
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
    uint32_t id, parent; /* id: place + 1; parent 0: the body */
    GDObjectInstanceID node;
    affine rest; /* of the node, object frame */
    settings settings;
    bool locked;

    dm_part_state state; /* where `moved` */
    bool moved;
    dm_drag drag;        /* 0 = it does not move */
    bool held, by_mouse; /* by_mouse: each frame's ray pulls it */
    uint32_t events;     /* not yet told */
} part;

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

gd_value body_self(const body* b);

/* ---- parts: parts.c ---- */

/* Reads which nodes are parts, where they rest and how they behave. */
void body_find_parts(body* b);
void body_forget_parts(body* b);
part* body_part(body* b, uint32_t id);
/* The part that a node is; NULL: none. */
part* body_part_of(body* b, const gd_value* node);
gd_value part_node(const part* p);
/* Where the nodes of the parts are, in order of id: strings. */
gd_value body_part_paths(const body* b);
/* Mesh and hints of all nodes; NULL without memory. */
preparation* body_collect(body* b);
/* Where a node is in the object frame. */
affine body_place_of(const body* b, const gd_value* node);
/* Moves the nodes of a part and of what it carries to where they are now. */
void body_show(body* b, part* p);
/* The pose of what carries a part, from rest. */
dm_pose body_carrier(body* b, const part* p);

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
/* Ends a drag and keeps where the part is. */
void part_end(part* p);
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
