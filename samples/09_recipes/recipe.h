/* What the recipes share: a prepared cabinet and a player's hand. Vectors are cglm's, as a host's are of its engine. */
#ifndef SAMPLES_RECIPE_H
#define SAMPLES_RECIPE_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../common/cabinet.h"
#include "../common/vectors.h"

/* The recipes are tests of what they claim. */
#define EXPECT(condition)                                                                                              \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            fprintf(stderr, "%s:%d: %s does not hold\n", __FILE__, __LINE__, #condition);                              \
            exit(1);                                                                                                   \
        }                                                                                                              \
    } while (0)

enum { FPS = 60 };

static const dm_vec3 handle_point = {0.55f, 0.45f, 0.45f}; /* on the door's handle */
static const dm_vec3 eye = {1.2f, 1.4f, 2.2f};             /* of the player, object frame */

/* Prepares the cabinet by geometry alone: no weights, no triangles for picking. */
static inline dm_object recipe_open(dm_context** out_context) {
    static cabinet shape;
    dm_context_desc host = dm_context_desc_default();
    host.log = (dm_log){NULL, print_message};
    EXPECT(dm_context_create(&host, out_context) == DM_OK);
    const dm_mesh_desc mesh = cabinet_make(&shape);
    dm_object_desc desc = dm_object_desc_default();
    dm_object object = 0;
    desc.mesh = &mesh, desc.flags = DM_PREPARE_WITHOUT_PICKING;
    EXPECT(dm_object_prepare(*out_context, &desc, &object) == DM_OK);
    return object;
}

/* A part at rest, by the joint that the library found. */
static inline dm_part_state recipe_closed(dm_context* context, dm_object object, uint32_t part) {
    dm_part_state state = dm_part_state_default();
    state.joint = dm_joint_default();
    EXPECT(dm_object_get_joint(context, object, part, &state.joint) == DM_OK);
    return state;
}

/* A ray from `from` through `to`. */
static inline dm_ray ray_through(dm_vec3 from, dm_vec3 to) {
    return (dm_ray){from, sub(to, from)};
}

/* Where a hand is that swings the door's handle open by `angle` about its left edge. */
static inline dm_vec3 hand_at(float angle) {
    const dm_vec3 hinge = {0, 0, 0.41f};
    raw_vec3 arm = raw(sub(handle_point, hinge));
    glm_vec3_rotate(arm.v, -angle, (vec3){0, 1, 0});
    return add(hinge, vec_from(arm.v));
}

/* Half a second of pulling from one angle to another. The first ray is the one that grabbed the part. */
static inline dm_drag_state recipe_pull(dm_context* context, dm_drag drag, float from, float to) {
    dm_drag_state now = dm_drag_state_default();
    for (int frame = 0; frame <= FPS / 2; frame++) {
        const dm_ray ray = ray_through(eye, hand_at(from + (to - from) * (float)frame / (FPS / 2.0f)));
        EXPECT(dm_drag_update(context, drag, &ray, 1.0f / FPS, &now) == DM_OK);
    }
    return now;
}

/* Grabs the handle of a shut door, pulls it open by `angle` and lets go: the door's state, and the last update. */
static inline dm_drag_state recipe_open_door(dm_context* context, dm_object object, float angle, dm_part_state* door) {
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .object = object,
                               .part_id = CABINET_DOOR,
                               .grab_point = handle_point,
                               .state = door};
    dm_drag drag = 0;
    EXPECT(dm_drag_begin(context, &desc, &drag) == DM_OK);
    recipe_pull(context, drag, 0, angle); /* the pull may change the joint: the part has come over to it in 0.6 s */
    const dm_drag_state last = recipe_pull(context, drag, angle, 1.5f * angle);
    EXPECT(dm_drag_end(context, drag, door) == DM_OK);
    return last;
}

static inline float shift_between(const dm_pose* a, const dm_pose* b) {
    return distance(pose_point(a, handle_point), pose_point(b, handle_point));
}

#endif
