/* An object of a .glb file with its parts, joints and drags. Independent of the screen: the same calls give the same
 * poses with or without a window. */
#ifndef VIEWER_WORLD_H
#define VIEWER_WORLD_H

#include "../12_latch/game.h"
#include "dragmesh/dragmesh.h"
#include "dragmesh/ext/gltf.h"
#include "vec.h"

/* Parts, whose ids fit a byte; bytes of a name; steps back that undo knows. */
enum { WORLD_MAX_PARTS = 250, WORLD_NAME = 64, WORLD_HISTORY = 64 };

typedef struct world_part {
    char name[WORLD_NAME];
    uint32_t id, parent; /* ids given to the library; 1.. */
    int is_free;         /* nothing but its weight holds it */
    int is_stated;       /* the file states its joint, or moves it by a clip */
    dm_joint hypotheses[DM_MAX_HYPOTHESES];
    uint32_t hypothesis_count;
    dm_part_state state; /* this instance's own joint, value and pose; during a drag, those of now */
    int32_t basis;       /* DM_BASIS_*: where state.joint comes from */
    dm_part_state taken; /* as it was when the hand took it; later grabs of a changed joint leave it */
    int has_changed;     /* pulls since then have changed the joint: its line, type or side */
    dm_pose carried;     /* state.pose with the parts that carry it */
    dm_vec3 centre, box_min, box_max;
    dm_pose keys[DM_MOTION_FRAMES]; /* the motion the last pull asked for */
    int has_keys;
    dm_drag drag;       /* in hand, or still moving after the hand let go; 0 = neither */
    dm_drag_state last; /* of the drag's last update */
} world_part;

/* A part as it was before the hand took it. */
typedef struct world_past {
    uint32_t part;
    dm_part_state state;
    int32_t basis;
} world_past;

/* Which nodes of the file move as one: names, comma-separated. */
typedef struct world_options {
    const char* file;
    const char* scene;  /* name of a scene of samples/12_latch in place of a file; may be NULL */
    const char* models; /* folder with the weights; NULL = weights_folder_find; "none" = geometry alone */
    const char* dmo;    /* a prepared object to load in place of preparing; may be NULL */
    const char* parts[WORLD_MAX_PARTS];
    uint32_t part_count; /* 0: the library is asked which nodes move */
} world_options;

typedef struct world {
    dm_context* context;
    dm_model model;
    int has_motion;
    dm_gltf* gltf;
    dm_mesh_desc mesh; /* merged; points into gltf */
    uint32_t face_count;
    uint8_t* face_part; /* id of every face's part; 0 = the body */
    dm_object object;
    dm_scene scene;
    uint32_t instance;
    dm_object_info info;
    float size;                            /* diagonal of the box round all vertices */
    world_part parts[WORLD_MAX_PARTS + 1]; /* [id]; [0] is the body */
    uint32_t part_count;                   /* ids are 1 .. part_count */
    uint32_t revision;                     /* counts the preparations */
    double prepare_seconds;
    char message[512]; /* what the library, or the world, said last */
    uint32_t held;     /* the part in hand; 0 = none */
    dm_drag_hint pull; /* of the hand so far, in the frame of the part's carrier; vector 0 = none yet */
    dm_vec3 grab_normal;
    int32_t intent;                    /* DM_GO_*: what parts do when they are let go */
    world_past history[WORLD_HISTORY]; /* the latest last */
    uint32_t history_count;
    const scene* table; /* the scene whose joints and rules the parts have; NULL: none */
    game game;          /* its instance */
    script script;      /* its own hands */
    int acting;         /* they are at work */
} world;

/* 0, or -1 with a line in message. The world is closed in either case. */
int world_open(world* world, const world_options* options);
void world_close(world* world);

/* Prepares the object again, after face_part, names or parents changed. */
int world_prepare(world* world);

/* Loads a prepared object instead of preparing one. */
int world_load(world* world, const char* path);

/* Picks along a ray; distance 0: nothing. */
dm_hit world_pick(world* world, const dm_ray* ray);

/* Begins a drag; releases it, after which the part moves by itself. */
int world_grab(world* world, const dm_hit* hit);
void world_release(world* world);

/* Advances by dt seconds: the held part follows the pointer's ray, released ones move on. */
void world_step(world* world, const dm_ray* ray, float dt);

/* Ends the drag of a part, which stays where it is. */
void world_end_drag(world* world, uint32_t part);

/* Generates the key poses of the motion for the pull so far. */
void world_imagine(world* world, const dm_ray* ray);

/* Reads the object's joint and its other hypotheses; the part is at rest on it. */
void world_read_joint(world* world, uint32_t part);

void world_set_value(world* world, uint32_t part, float value);

/* A designer's joint: the object gets it, and this instance with it. Undo does not go back beyond it. */
void world_set_joint(world* world, uint32_t part, const dm_joint* joint);

/* Keeps the part as it is now; a grab does so by itself. Puts back what was kept last; 0, or -1 when there is none. */
void world_remember(world* world, uint32_t part);
int world_undo(world* world);

/* Puts a part back to before the pulls that have changed its joint. The player has said which joint is right, so
 * further pulls keep it, and what those pulls taught is forgotten. Undo takes it back. 0, or -1 when no pull has
 * changed it. */
int world_as_before(world* world, uint32_t part);

/* ---- world_scene.c: only of worlds with a table ---- */

/* The nodes of the scene's .glb are the body and its parts, in order of their ids. */
void world_scene_parts(world* world);
/* Gives a prepared object the scene's joints and links; drops the table when the parts are no longer the scene's. */
int world_scene_equip(world* world);
int world_scene_grab(world* world, const dm_hit* hit);
void world_scene_step(world* world, const dm_ray* ray, float dt);
/* The scene's own hands take over, or stop. */
void world_scene_act(world* world);

/* Poses of all parts from their values, into the scene too. */
void world_update(world* world);

/* The prepared object, and beside it which faces are whose: FILE.dmo and FILE.parts.npy. */
int world_save(world* world, const char* path);

#endif
