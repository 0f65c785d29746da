/* Types behind the context and the handles it gives out, and the look-up of handles. */
#ifndef DMI_API_HANDLES_H
#define DMI_API_HANDLES_H

#include "assets/asset.h"
#include "base/cpu.h"
#include "base/pool.h"
#include "drag/drag.h"
#include "drag/part_links.h"
#include "kinematics/object/prepare.h"
#include "motion/motion.h"
#include "pick/pick.h"

enum { DMI_KIND_MODEL = 1, DMI_KIND_OBJECT, DMI_KIND_MOTION, DMI_KIND_DRAG, DMI_KIND_SCENE, DMI_KIND_ASSET };

/* Link of a motion or a drag in the list of its object, with which it is destroyed. First member of both. */
typedef struct dmi_dependent {
    struct dmi_dependent *next, *previous;
    uint64_t handle;
} dmi_dependent;

typedef struct dmi_model_slot {
    dmi_kpp_net* kinematics;  /* NULL: not given */
    dmi_dq_vae* motion;       /* NULL: not given */
    dmi_joint_models* joints; /* NULL: not given */
} dmi_model_slot;

/* One instance of an object in a scene, linked in both, so that either can be destroyed first. */
typedef struct dmi_placement {
    struct dmi_placement *next_of_scene, *next_of_object;
    struct dmi_placement **link_of_scene, **link_of_object; /* what points to this one in each list */
    struct dmi_scene_slot* scene;
    struct dmi_object_slot* object;
    uint32_t instance;
} dmi_placement;

typedef struct dmi_object_slot {
    dmi_object* object;
    dm_model model;           /* 0: none */
    dmi_vae_object* features; /* one a part, the body's is unused; NULL without a motion network */
    dmi_dependent *motions, *drags;
    dmi_placement* placements;
    dmi_link* links; /* sorted by dmi_links_order; parts are counted without the body. NULL: none */
    uint32_t link_count;
} dmi_object_slot;

typedef struct dmi_motion_slot {
    dmi_dependent link;
    dmi_object_slot* owner;
    dmi_motion motion;
} dmi_motion_slot;

typedef struct dmi_drag_slot {
    dmi_dependent link;
    dmi_object_slot* owner;
    uint32_t part;       /* index in the object */
    dm_vec3 scale;       /* the instance's scale */
    int8_t open_side;    /* +1: no upper limit, but a lower one; -1: the reverse; 0: both limits or neither */
    float value_unit;    /* the object's size for slides, 1 rad for turns */
    float longest_frame; /* s; longest dt of an update that was too long to be meant; 0: none, -1: reported */
    uint32_t refused;    /* updates that had an error, not yet reported */
    dm_result first_refusal;
    dmi_drag drag;
} dmi_drag_slot;

typedef struct dmi_scene_slot {
    dmi_scene* scene;
    dmi_placement* placements;
} dmi_scene_slot;

typedef struct dmi_asset_slot {
    dmi_asset* asset;
    dm_model model;      /* 0: none */
    bool keep_triangles; /* the objects made of it keep their triangles */
} dmi_asset_slot;

struct dm_context {
    dmi_env env;
    dmi_axes axes;
    dmi_isa isa;
    dmi_picker* picker;
    dmi_pool *models, *objects, *motions, *drags, *scenes, *assets;
    /* Spin lock of the lists in objects and scenes. It is held for a few loads and stores, never in a [frame]
     * function. */
    atomic_flag lock;
};

void dmi_lock(dm_context* context);
void dmi_unlock(dm_context* context);

/* Returns the item of a handle, or NULL, after a message in the name of `function`, when it is null, stale or
 * foreign. */
void* dmi_find(dm_context* context, const dmi_pool* pool, const char* function, uint64_t handle);
/* Does the same, and removes the item from the pool. */
void* dmi_take(dm_context* context, dmi_pool* pool, const char* function, uint64_t handle);

/* Gives an item a handle and links it to its object. It frees nothing on failure. */
dm_result dmi_dependent_add(dm_context* context, dmi_pool* pool, dmi_dependent** list, dmi_dependent* item);
void dmi_dependent_unlink(dm_context* context, dmi_dependent** list, dmi_dependent* item);

/* Finds the index of a part by the host's id. Answers NOT_FOUND, with a message, for unknown ids and for the body. */
dm_result dmi_find_part(dm_context* context, const char* function, const dmi_object* object, uint32_t part_id,
                        uint32_t* out_index);

#endif
