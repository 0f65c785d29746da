/* Scenes as tables: what an object is made of, how its parts move, by which rules, and what a scripted hand does. */
#ifndef LATCH_SCENE_H
#define LATCH_SCENE_H

#include "dragmesh/dragmesh.h"

enum { SCENE_PARTS = 4, SCENE_WAYPOINTS = 6, SCENE_COUNT = 8 }; /* most parts of a scene, most ways of a hand */

/* Teeth of a shape that is no wheel, and of a round one. */
enum { NO_WHEEL = -1, ROUND = 0 };

/* A box from `low` to `high`, or the wheel along z that fits into it. */
typedef struct scene_shape {
    uint32_t part; /* 0: the body */
    dm_vec3 low, high;
    int32_t teeth;
} scene_shape;

#define BOX(part, x0, y0, z0, x1, y1, z1)                                                                              \
    { part, {x0, y0, z0}, {x1, y1, z1}, NO_WHEEL }
#define WHEEL(part, x, y, radius, z0, z1, teeth)                                                                       \
    { part, {(x) - (radius), (y) - (radius), z0}, {(x) + (radius), (y) + (radius), z1}, teeth }
#define COUNT(array) ((uint32_t)(sizeof(array) / sizeof *(array)))

typedef struct scene_part {
    const char* name;
    uint32_t parent; /* id of the part that carries it, which comes first; 0: the body */
    dm_joint joint;  /* of a designer; its struct_size is filled in */
    dm_drag_feel feel;
    dm_drag_rules rules; /* its struct_size is filled in */
    uint32_t handle;     /* part that opens its latch; 0: none */
    int32_t pulls;       /* a hand on it pulls its parent too, as the hand on a door's handle does */
    uint32_t obstacle;   /* part that stands in its way until that part's value is `out_of_way`; 0: none */
    float stops_at, out_of_way;
} scene_part;

/* A hand in space: takes hold of a part where `grab` is at rest, goes its way, and lets go. */
typedef struct scene_hand {
    uint32_t part;
    float begin;  /* s */
    dm_vec3 grab; /* object frame, with the part at rest */
    struct {
        float seconds; /* 0: the end */
        dm_vec3 move;  /* by which it goes on in that time */
    } way[SCENE_WAYPOINTS];
} scene_hand;

typedef struct scene {
    const char* name;
    float seconds;           /* that the scripted hands take, and what they have started */
    const scene_part* parts; /* ids 1, 2, … */
    uint32_t part_count;
    const scene_shape* shapes;
    uint32_t shape_count;
    const dm_link* links;
    uint32_t link_count;
    const scene_hand* hands; /* by time; two at once at most */
    uint32_t hand_count;
} scene;

extern const scene scene_house_door, scene_double_door, scene_safe, scene_drawers, scene_hatch, scene_gears,
    scene_blocked_door, scene_two_hands;

const scene* scene_at(uint32_t index);     /* NULL: there are no more */
const scene* scene_find(const char* name); /* NULL: none has that name */

/* ---- scene_mesh.c ---- */

enum { SCENE_VERTICES = 8192, SCENE_INDICES = 16384 };

/* The shapes as triangles, part after part, the body first. */
typedef struct scene_mesh {
    float positions[SCENE_VERTICES][3];
    uint32_t indices[SCENE_INDICES];
    uint8_t parts[SCENE_VERTICES]; /* of each vertex */
    uint32_t vertex_count, index_count;
    uint32_t first_vertex[SCENE_PARTS + 2], first_index[SCENE_PARTS + 2]; /* of each part; the last one ends them */
} scene_mesh;

void scene_mesh_make(const scene* scene, scene_mesh* out);
dm_mesh_desc scene_mesh_desc(const scene_mesh* mesh); /* points into `mesh` */

/* Gives a prepared object the designer's joints and the links of the table. */
dm_result scene_equip(const scene* scene, dm_context* context, dm_object object);
/* Prepares the object, and gives it those. */
dm_result scene_prepare(const scene* scene, dm_context* context, const dm_mesh_desc* mesh, dm_object* out_object);

/* ---- scene_glb.c ---- */

/* The scene as the bytes of a .glb with a node a part; the caller frees them. NULL: no memory. */
void* scene_glb(const scene* scene, size_t* out_size);

#endif
