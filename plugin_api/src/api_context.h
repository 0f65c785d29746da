/* What stands behind a dm_context and behind the handles it gives out. */
#ifndef DMI_API_CONTEXT_H
#define DMI_API_CONTEXT_H

#include "base/cpu.h"
#include "base/pool.h"
#include "kinematics/object/prepare.h"
#include "motion/drag.h"
#include "motion/motion.h"
#include "pick/pick.h"

enum { DMI_KIND_MODEL = 1, DMI_KIND_OBJECT, DMI_KIND_MOTION, DMI_KIND_DRAG, DMI_KIND_SCENE };

/* A motion or a drag in the list of its object, with which it ends. First member of both. */
typedef struct dmi_dependent {
    struct dmi_dependent *next, *previous;
    uint64_t handle;
} dmi_dependent;

typedef struct dmi_model_slot {
    dmi_kpp_net* kinematics;  /* NULL: not given */
    dmi_dq_vae* motion;       /* NULL: not given */
    dmi_joint_models* joints; /* NULL: not given */
} dmi_model_slot;

/* An object standing in a scene: known to both, so that either can go first. */
typedef struct dmi_placement {
    struct dmi_placement *next_of_scene, *next_of_object;
    struct dmi_scene_slot* scene;
    struct dmi_object_slot* object;
    uint32_t instance;
} dmi_placement;

typedef struct dmi_object_slot {
    dmi_object* object;
    dm_model model;           /* 0: none */
    dmi_vae_object* features; /* one a part, the body's unused; NULL without a motion network */
    dmi_dependent *motions, *drags;
    dmi_placement* placements;
} dmi_object_slot;

typedef struct dmi_motion_slot {
    dmi_dependent link;
    dmi_object_slot* owner;
    dmi_motion motion;
} dmi_motion_slot;

typedef struct dmi_drag_slot {
    dmi_dependent link;
    dmi_object_slot* owner;
    uint32_t part; /* index in the object */
    dmi_drag drag;
} dmi_drag_slot;

typedef struct dmi_scene_slot {
    dmi_scene* scene;
    dmi_placement* placements;
} dmi_scene_slot;

struct dm_context {
    dmi_env env;
    dmi_axes axes;
    dmi_isa isa;
    dmi_picker* picker;
    dmi_pool *models, *objects, *motions, *drags, *scenes;
    atomic_flag
        lock; /* of the lists in objects and scenes; held for a few loads and stores, never in a [frame] function */
};

void dmi_lock(dm_context* context);
void dmi_unlock(dm_context* context);

/* The item of a handle. NULL, after a message in the name of `function`, when the handle is null, stale or foreign. */
void* dmi_find(dm_context* context, const dmi_pool* pool, const char* function, uint64_t handle);
/* The same, taking it out of the pool. */
void* dmi_take(dm_context* context, dmi_pool* pool, const char* function, uint64_t handle);

/* Names an item and links it to its object; frees nothing on failure. */
dm_result dmi_dependent_add(dm_context* context, dmi_pool* pool, dmi_dependent** list, dmi_dependent* item);
void dmi_dependent_unlink(dm_context* context, dmi_dependent** list, dmi_dependent* item);

/* The index of a part by the host's id; NOT_FOUND, with a message, for ids the object lacks and for the body. */
dm_result dmi_find_part(dm_context* context, const char* function, const dmi_object* object, uint32_t part_id,
                        uint32_t* out_index);

/* model NULL: geometry and rules. */
dmi_inference_models dmi_inference_models_of(const dm_context* context, const dmi_model_slot* model);

/* Takes an object over, encodes it for the motion network of `model` (0: none), and names it. */
dm_result dmi_object_publish(dm_context* context, const char* function, dmi_object* object, dm_model model,
                             dm_object* out_object);

/* Free one item that has been taken out of its pool, with all that ends with it. */
void dmi_model_release(dm_context* context, dmi_model_slot* slot);
void dmi_object_release(dm_context* context, dmi_object_slot* slot);
void dmi_scene_release(dm_context* context, dmi_scene_slot* slot);
/* Takes an object out of all scenes it stands in. */
void dmi_scenes_forget(dm_context* context, dmi_object_slot* slot);

#endif
