/* Parts in motion: picked, grabbed, pulled, let go; their joints read, weighed and overridden. */
#include <string.h>

#include "world.h"

void world_read_joint(world* world, uint32_t id, const dm_drag_hint* pull) {
    world_part* part = &world->parts[id];
    dm_object_get_joint(world->context, world->object, id, &part->joint);
    if (dm_object_get_hypotheses(world->context, world->object, id, pull, part->hypotheses, DM_MAX_HYPOTHESES,
                                 &part->hypothesis_count) != DM_OK)
        part->hypothesis_count = 0;
}

void world_update(world* world) {
    if (!world->object) return;
    for (uint32_t id = 1; id <= world->part_count; id++)
        dm_joint_pose(&world->parts[id].joint, world->parts[id].value, &world->parts[id].pose);
    if (world->held && world->drag) world->parts[world->held].pose = world->state.pose;
    for (uint32_t id = 1; id <= world->part_count; id++) {
        dm_pose pose = world->parts[id].pose;
        /* Chains are short; ids of carriers may be larger, and a loop has been refused by the library. */
        for (uint32_t carrier = world->parts[id].parent; carrier; carrier = world->parts[carrier].parent)
            dm_pose_multiply(&world->parts[carrier].pose, &pose, &pose);
        world->parts[id].carried = pose;
        dm_scene_move(world->context, world->scene, world->instance, id, &pose);
    }
    dm_scene_commit(world->context, world->scene);
}

dm_hit world_pick(world* world, const dm_ray* ray) {
    dm_hit hit;
    memset(&hit, 0, sizeof hit);
    if (world->scene && dm_scene_pick(world->context, world->scene, ray, &hit) != DM_OK) hit.object = 0;
    return hit;
}

static dm_pose carrier_of(const world* world, uint32_t id) {
    const uint32_t carrier = world->parts[id].parent;
    return carrier ? world->parts[carrier].carried : pose_identity;
}

/* A ray of the object as the part's carrier sees it. */
static dm_ray carried_ray(const world* world, const dm_ray* ray) {
    const dm_pose carrier = carrier_of(world, world->held), inverse = pose_inverse(&carrier);
    return (dm_ray){pose_point(&inverse, ray->origin), pose_direction(&inverse, ray->direction)};
}

static int begin_drag(world* world) {
    const world_part* part = &world->parts[world->held];
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = world->held,
                               .object = world->object,
                               .grab_point = world->grab,
                               .start_value = part->value};
    world->decided = 1;
    memset(&world->state, 0, sizeof world->state);
    world->state.pose = part->pose;
    world->state.value = part->value;
    return dm_drag_begin(world->context, &desc, &world->drag) == DM_OK ? 0 : -1;
}

int world_grab(world* world, const dm_hit* hit) {
    if (!hit->object || hit->part_id == 0 || hit->part_id > world->part_count) return -1;
    const dm_pose carrier = carrier_of(world, hit->part_id), inverse = pose_inverse(&carrier);
    world_part* part = &world->parts[hit->part_id];
    world->held = hit->part_id;
    world->drag = 0;
    world->grab = pose_point(&inverse, hit->point);
    world->grab_normal = pose_direction(&inverse, hit->normal);
    /* A part away from rest, or told by the host how it moves, follows at once; another waits for the first pull. */
    world->decided = part->value != 0 || part->joint.source == DM_JOINT_FROM_HOST;
    return world->decided ? begin_drag(world) : 0;
}

/* What a pull on the screen means in space: the ray cut with the plane through the grabbed point that holds the
 * surface's normal and faces the camera best, so that pulling, pushing and sliding can all be said. */
static dm_drag_hint pull_in_space(const world* world, const dm_ray* ray) {
    const vec3 direction = unit(ray->direction), normal = world->grab_normal;
    const vec3 across = along(direction, normal, -dot(direction, normal));
    const vec3 plane = length(across) > 1e-3f ? unit(across) : direction;
    const float distance = dot(sub(world->grab, ray->origin), plane) / dot(direction, plane);
    return (dm_drag_hint){world->grab, sub(along(ray->origin, direction, distance), world->grab)};
}

/* The key poses of the motion that the pull asks for. */
static void imagine(world* world, const dm_drag_hint* pull) {
    world_part* part = &world->parts[world->held];
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = world->held, .drag = *pull};
    dm_motion motion;
    part->has_keys = 0;
    if (!world->has_motion || dm_motion_generate(world->context, world->object, &desc, &motion) != DM_OK) return;
    part->has_keys = dm_motion_get_frames(world->context, motion, part->keys, NULL) == DM_OK;
    dm_motion_destroy(world->context, motion);
}

void world_hear_pull(world* world, const dm_ray* ray) {
    const dm_ray local = carried_ray(world, ray);
    const dm_drag_hint pull = pull_in_space(world, &local);
    if (world->decided || length(pull.vector) <= 0) return;
    if (world->model) dm_object_refine(world->context, world->object, world->held, &pull);
    world_read_joint(world, world->held, &pull);
    imagine(world, &pull);
    if (begin_drag(world) != 0) world->held = 0;
}

void world_pull(world* world, const dm_ray* ray, float dt) {
    if (!world->held || !world->drag) return;
    const dm_ray local = carried_ray(world, ray);
    if (dm_drag_update(world->context, world->drag, &local, dt, &world->state) != DM_OK) return;
    world->parts[world->held].value = world->state.value;
    world_update(world);
}

void world_release(world* world) {
    if (world->held && world->drag && dm_drag_end(world->context, world->drag, &world->state) == DM_OK)
        world->parts[world->held].value = world->state.value;
    world->held = 0;
    world->drag = 0;
    world_update(world);
}

static float within(const dm_joint* joint, float value) {
    return joint->upper > joint->lower ? clampf(value, joint->lower, joint->upper) : value;
}

void world_set_value(world* world, uint32_t id, float value) {
    world->parts[id].value = within(&world->parts[id].joint, value);
    world_update(world);
}

void world_set_joint(world* world, uint32_t id, const dm_joint* joint) {
    if (dm_object_set_joint(world->context, world->object, id, joint) != DM_OK) return;
    world_part* part = &world->parts[id];
    dm_object_get_joint(world->context, world->object, id, &part->joint);
    part->has_keys = 0;
    world_set_value(world, id, part->value);
}
