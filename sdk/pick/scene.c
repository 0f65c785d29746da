/* Scenes: instances of objects in a tree of their parts' boxes.
 *
 * A move only stores the pose. Commit computes matrices and boxes and mends the tree, so picks between a move and the
 * commit see the scene as it was. Whatever a commit needs is allocated when an instance is added. */
#include <math.h>
#include <string.h>

#include "base/cpu.h"
#include "math/linear3.h"
#include "pick/placed.h"

#define FIRST_CAPACITY 16 /* instances; doubles when full */
/* Bounds of an object, in host units. Within them no product of floats overflows while a ray is traced. */
#define MIN_OBJECT_SIZE 1e-6 /* largest side */
#define MAX_OBJECT_SIZE 1e12
/* A commit that changes more than one in so many parts builds the tree anew; measured: placing one part takes as long
 * as rebuilding the tree takes for four to eight parts. */
#define REBUILT_SHARE 6

struct dmi_scene {
    dmi_picker* picker;
    dmi_placed_object** objects; /* objects by instance id; NULL where one was removed */
    uint32_t* free_ids;          /* a stack of `free_count` ids; the next one to use is on top */
    uint32_t capacity, free_count;
    dmi_placed_object* dirty; /* first of a linked list: the objects that have moved since the last commit */
    dmi_top_tree tree;
    dmi_scene_trace* trace; /* the trace of the machine's instruction set */
};

/* ---- placed objects ---- */

static size_t placed_size(const dmi_bvh* bvh) {
    return sizeof(dmi_placed_object) + bvh->part_count * sizeof(dmi_placed_part);
}

static void mark_dirty(dmi_scene* scene, dmi_placed_object* placed) {
    if (placed->dirty) return;
    placed->dirty = true;
    placed->previous_dirty = NULL;
    placed->next_dirty = scene->dirty;
    if (scene->dirty != NULL) scene->dirty->previous_dirty = placed;
    scene->dirty = placed;
}

static void unmark_dirty(dmi_scene* scene, dmi_placed_object* placed) {
    if (!placed->dirty) return;
    placed->dirty = false;
    if (placed->next_dirty != NULL) placed->next_dirty->previous_dirty = placed->previous_dirty;
    if (placed->previous_dirty != NULL)
        placed->previous_dirty->next_dirty = placed->next_dirty;
    else
        scene->dirty = placed->next_dirty;
}

static void release_placed(dmi_scene* scene, dmi_placed_object* placed) {
    for (uint32_t p = 0; p < placed->bvh->part_count; p++) {
        if (placed->parts[p].leaf != DMI_TOP_NONE) dmi_top_tree_remove(&scene->tree, placed->parts[p].leaf);
    }
    dmi_free(scene->picker->env, placed, placed_size(placed->bvh));
}

static dm_result grow(dmi_scene* scene) {
    dmi_env* env = scene->picker->env;
    const uint32_t old = scene->capacity, capacity = old > 0 ? 2 * old : FIRST_CAPACITY;
    const size_t size = capacity * sizeof(void*), old_size = old * sizeof(void*);
    dmi_placed_object** objects = dmi_alloc_zeroed(env, size, DMI_ALIGNMENT);
    uint32_t* free_ids = dmi_alloc(env, capacity * sizeof *free_ids, DMI_ALIGNMENT);
    if (objects == NULL || free_ids == NULL) {
        dmi_free(env, objects, size);
        dmi_free(env, free_ids, capacity * sizeof *free_ids);
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u instances", capacity);
    }
    if (old > 0) memcpy(objects, scene->objects, old_size);
    for (uint32_t id = capacity; id > old; id--) free_ids[scene->free_count++] = id - 1;
    dmi_free(env, scene->objects, old_size);
    dmi_free(env, scene->free_ids, old * sizeof *free_ids);
    scene->objects = objects;
    scene->free_ids = free_ids;
    scene->capacity = capacity;
    return DM_OK;
}

/* Makes the parts of a placed object, at rest. Their matrices, which are most of the memory, wait for the commit. */
static dm_result make_parts(dmi_scene* scene, dmi_placed_object* placed) {
    dm_result result = DM_OK;
    for (uint32_t p = 0; p < placed->bvh->part_count; p++) {
        dmi_placed_part* part = &placed->parts[p];
        part->owner = placed;
        part->shape = &placed->bvh->parts[p];
        part->leaf = DMI_TOP_NONE;
        part->moved = false;
        part->pose = dmi_pose_identity();
        if (result == DM_OK && placed->bvh->parts[p].tree != NULL)
            result = dmi_top_tree_add(&scene->tree, part, &part->leaf);
    }
    return result;
}

/* Normalises a pose. Returns whether its translation is within the bounds. */
static bool read_pose(const dm_pose* pose, dm_pose* out) {
    float t[3];
    *out = dmi_pose_normalize(pose);
    dmi_pose_translation(out, t);
    return fabs((double)t[0]) <= DMI_MAX_COORDINATE && fabs((double)t[1]) <= DMI_MAX_COORDINATE &&
           fabs((double)t[2]) <= DMI_MAX_COORDINATE;
}

static dm_result check_placement(dmi_env* env, const dm_pose* pose, dm_pose* out) {
    if (read_pose(pose, out)) return DM_OK;
    float t[3];
    dmi_pose_translation(out, t);
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "scene: a pose by (%g, %g, %g), must be within %g units",
                    (double)t[0], (double)t[1], (double)t[2], DMI_MAX_COORDINATE);
}

static dm_result check_size(dmi_env* env, const dmi_frame* frame) {
    double size = (double)dmi_frame_length_out(frame);
    if (size >= MIN_OBJECT_SIZE && size <= MAX_OBJECT_SIZE) return DM_OK;
    return dmi_fail(env, DM_ERROR_UNSUPPORTED, "scene: an object %g units large, can pick those of %g to %g", size,
                    MIN_OBJECT_SIZE, MAX_OBJECT_SIZE);
}

static dm_result make_placed(dmi_scene* scene, const dmi_bvh* bvh, const dmi_frame* frame, dm_object object,
                             const dm_pose* placement, dmi_placed_object** out_placed) {
    dmi_env* env = scene->picker->env;
    dmi_placed_object* placed = dmi_alloc(env, placed_size(bvh), _Alignof(dmi_placed_object));
    if (placed == NULL) {
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for an instance of %u parts", bvh->part_count);
    }
    *placed =
        (dmi_placed_object){.bvh = bvh, .frame = *frame, .object = object, .placement = *placement, .moved = true};
    const dm_result result = make_parts(scene, placed);
    if (result != DM_OK) {
        release_placed(scene, placed);
        return result;
    }
    *out_placed = placed;
    return DM_OK;
}

dm_result dmi_scene_add(dmi_scene* scene, const dmi_bvh* bvh, const dmi_frame* frame, dm_object object,
                        const dm_pose* host_placement, uint32_t* out_instance) {
    dmi_env* env = scene->picker->env;
    dmi_placed_object* placed = NULL;
    dm_pose placement;
    dm_result result = check_size(env, frame);
    if (result == DM_OK) result = check_placement(env, host_placement, &placement);
    if (result == DM_OK && scene->free_count == 0) result = grow(scene);
    if (result == DM_OK) result = make_placed(scene, bvh, frame, object, &placement, &placed);
    if (result != DM_OK || placed == NULL) return result;
    placed->id = scene->free_ids[--scene->free_count];
    scene->objects[placed->id] = placed;
    mark_dirty(scene, placed);
    *out_instance = placed->id;
    return DM_OK;
}

static dmi_placed_object* find_placed(const dmi_scene* scene, uint32_t instance) {
    return instance < scene->capacity ? scene->objects[instance] : NULL;
}

void dmi_scene_set_user(dmi_scene* scene, uint32_t instance, void* user) {
    scene->objects[instance]->user = user;
}

void* dmi_scene_user(const dmi_scene* scene, uint32_t instance) {
    const dmi_placed_object* placed = find_placed(scene, instance);
    return placed != NULL ? placed->user : NULL;
}

dm_result dmi_scene_move(dmi_scene* scene, uint32_t instance, uint32_t part_id, const dm_pose* host_pose) {
    dmi_placed_object* placed = find_placed(scene, instance);
    if (placed == NULL) return DM_ERROR_NOT_FOUND;
    int32_t part = dmi_bvh_find_part(placed->bvh, part_id);
    if (part < 0) return DM_ERROR_NOT_FOUND;
    dm_pose pose;
    if (!read_pose(host_pose, &pose)) return DM_ERROR_INVALID_ARGUMENT;
    if (part == 0) {
        placed->placement = pose;
        placed->moved = true;
    } else {
        placed->parts[part].pose = pose;
        placed->parts[part].moved = true;
    }
    mark_dirty(scene, placed);
    return DM_OK;
}

dm_result dmi_scene_remove(dmi_scene* scene, uint32_t instance) {
    dmi_placed_object* placed = find_placed(scene, instance);
    if (placed == NULL) return dmi_fail(scene->picker->env, DM_ERROR_NOT_FOUND, "scene: no instance %u", instance);
    scene->objects[instance] = NULL;
    scene->free_ids[scene->free_count++] = instance;
    unmark_dirty(scene, placed);
    release_placed(scene, placed);
    dmi_top_tree_settle(&scene->tree);
    return DM_OK;
}

/* ---- commit ---- */

/* Computes matrices and boxes of an object's parts that have moved. Returns how many of them the tree holds. */
static uint32_t update_placed(dmi_scene* scene, dmi_placed_object* placed) {
    double placement[DMI_MATRIX], from_inner[DMI_MATRIX] = {0};
    const dmi_placed_part* at_rest = NULL;
    uint32_t changed = 0;
    dmi_pose_matrix_f64(&placed->placement, placement);
    dmi_frame_matrix_out(&placed->frame, from_inner);
    for (uint32_t p = 0; p < placed->bvh->part_count; p++) {
        dmi_placed_part* part = &placed->parts[p];
        if (part->leaf == DMI_TOP_NONE || !(placed->moved || part->moved)) continue;
        dmi_placed_part_update(part, &scene->tree, placement, from_inner, &at_rest);
        part->moved = true; /* the part counts as moved until it is placed */
        changed++;
    }
    placed->moved = false;
    return changed;
}

/* Puts a part that has moved where it belongs now. A part that is new to the tree waits for the other new ones. */
static void place_part(dmi_top_tree* tree, uint32_t leaf, bool rebuild) {
    if (rebuild)
        tree->leaves[leaf].placed = true;
    else if (tree->leaves[leaf].placed)
        dmi_top_tree_place(tree, leaf);
    else
        dmi_top_tree_wait(tree, leaf);
}

/* Takes the objects off the list, and places their moved parts. */
static void place_dirty(dmi_scene* scene, bool rebuild) {
    while (scene->dirty != NULL) {
        dmi_placed_object* placed = scene->dirty;
        unmark_dirty(scene, placed);
        for (uint32_t p = 0; p < placed->bvh->part_count; p++) {
            dmi_placed_part* part = &placed->parts[p];
            if (!part->moved || part->leaf == DMI_TOP_NONE) continue;
            part->moved = false;
            place_part(&scene->tree, part->leaf, rebuild);
        }
    }
}

void dmi_scene_commit(dmi_scene* scene) {
    uint32_t changed = 0;
    for (dmi_placed_object* placed = scene->dirty; placed != NULL; placed = placed->next_dirty)
        changed += update_placed(scene, placed);
    const bool rebuild = changed > scene->tree.placed_count / REBUILT_SHARE;
    place_dirty(scene, rebuild);
    if (rebuild)
        dmi_top_tree_rebuild(&scene->tree);
    else
        dmi_top_tree_place_waiting(&scene->tree);
    dmi_top_tree_settle(&scene->tree);
}

/* ---- pick ---- */

void dmi_scene_pick(const dmi_scene* scene, const dm_ray* host_ray, dm_hit* out_hit) {
    scene->trace(&scene->tree, host_ray, out_hit);
}

/* ---- scenes ---- */

static dmi_scene_trace* best_trace(void) {
#if defined(__x86_64__)
    if (dmi_isa_has_avx2(dmi_cpu_best_isa())) return dmi_scene_trace_avx2;
#endif
    return dmi_scene_trace_plain;
}

dm_result dmi_scene_create(dmi_picker* picker, dmi_scene** out_scene) {
    if (picker->backend == NULL)
        return dmi_fail(picker->env, DM_ERROR_UNSUPPORTED, "scene: no ray picking: %s", picker->why);
    dmi_scene* scene = dmi_alloc_zeroed(picker->env, sizeof *scene, DMI_ALIGNMENT);
    if (scene == NULL) return dmi_fail(picker->env, DM_ERROR_OUT_OF_MEMORY, "no memory for a scene");
    scene->picker = picker;
    dmi_top_tree_init(&scene->tree, picker->env);
    scene->trace = best_trace();
    *out_scene = scene;
    return DM_OK;
}

void dmi_scene_destroy(dmi_scene* scene) {
    if (scene == NULL) return;
    dmi_env* env = scene->picker->env;
    dmi_top_tree_release(&scene->tree);
    for (uint32_t i = 0; i < scene->capacity; i++) {
        if (scene->objects[i] != NULL) dmi_free(env, scene->objects[i], placed_size(scene->objects[i]->bvh));
    }
    dmi_free(env, scene->objects, scene->capacity * sizeof(void*));
    dmi_free(env, scene->free_ids, scene->capacity * sizeof *scene->free_ids);
    dmi_free(env, scene, sizeof *scene);
}
