/* Parts in motion: picked, grabbed, pulled, let go. */
#include <string.h>

#include "world.h"

/* Moeller and Trumbore: distance along the ray, 0 when it misses. */
static float meet(const dm_ray* ray, dm_vec3 a, dm_vec3 b, dm_vec3 c) {
    const dm_vec3 ab = sub(b, a), ac = sub(c, a), p = cross(ray->direction, ac), from = sub(ray->origin, a);
    const float det = dot(ab, p);
    if (det == 0) return 0;
    const dm_vec3 q = cross(from, ab);
    const float u = dot(from, p) / det, v = dot(ray->direction, q) / det;
    return u < 0 || v < 0 || u + v > 1 ? 0 : fmaxf(dot(ac, q) / det, 0);
}

/* While nothing is prepared there is no scene to ask: the file's own triangles, one by one. */
static dm_hit pick_file(const world* world, const dm_ray* ray) {
    const float* positions = world->mesh.positions;
    const uint32_t* indices = world->mesh.indices;
    dm_hit hit = {.struct_size = sizeof hit};
    memset(&hit, 0, sizeof hit);
    for (uint32_t face = 0; face < world->face_count; face++) {
        const uint32_t* corners = indices + 3 * (size_t)face;
        const dm_vec3 a = vec_from(positions + 3 * (size_t)corners[0]),
                      b = vec_from(positions + 3 * (size_t)corners[1]),
                      c = vec_from(positions + 3 * (size_t)corners[2]);
        const float distance = meet(ray, a, b, c);
        if (distance <= 0 || (hit.distance > 0 && distance >= hit.distance)) continue;
        hit.distance = distance;
        hit.triangle = face;
        hit.normal = unit(cross(sub(b, a), sub(c, a)));
    }
    hit.point = hit.object_point = along(ray->origin, ray->direction, hit.distance);
    return hit;
}

dm_hit world_pick(world* world, const dm_ray* ray) {
    dm_hit hit = {.struct_size = sizeof hit};
    if (!world->scene) return pick_file(world, ray);
    if (dm_scene_pick(world->context, world->scene, ray, &hit) != DM_OK || !hit.object) memset(&hit, 0, sizeof hit);
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

/* The hand is off, and the part stands. Joint and value stay with this instance: the object learns nothing. */
int world_grab(world* world, const dm_hit* hit) {
    if (!world->object || hit->part_id == 0 || hit->part_id > world->part_count) return -1;
    if (world->table != NULL) return world_scene_grab(world, hit);
    world_part* part = &world->parts[hit->part_id];
    if (part->drag) world_end_drag(world, hit->part_id);
    const dm_pose carrier = carrier_of(world, hit->part_id), inverse = pose_inverse(&carrier);
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = hit->part_id,
                               .object = world->object,
                               .grab_point = pose_point(&inverse, hit->point),
                               .state = &part->state};
    if (dm_drag_begin(world->context, &desc, &part->drag) != DM_OK) return -1;
    world_remember(world, hit->part_id);
    if (!part->has_changed) part->taken = part->state;
    world->held = hit->part_id;
    world->pull = (dm_drag_hint){.point = desc.grab_point};
    world->grab_normal = pose_direction(&inverse, hit->normal);
    part->last = (dm_drag_state){.struct_size = sizeof part->last, .grab_point = desc.grab_point};
    return 0;
}

/* What a pull on the screen means in space: the ray cut with the plane through the grabbed point that holds the
 * surface's normal and faces the camera best, so that pulling, pushing and sliding can all be said. */
static dm_vec3 pull_in_space(const world* world, const dm_ray* ray) {
    const dm_vec3 direction = unit(ray->direction), normal = world->grab_normal;
    const dm_vec3 across = along(direction, normal, -dot(direction, normal));
    const dm_vec3 plane = length(across) > 1e-3f ? unit(across) : direction;
    const float distance = dot(sub(world->pull.point, ray->origin), plane) / dot(direction, plane);
    return sub(along(ray->origin, direction, distance), world->pull.point);
}

void world_imagine(world* world, const dm_ray* ray) {
    if (world->table != NULL) return; /* the joint is the table's, whatever the pull */
    const dm_ray local = carried_ray(world, ray);
    world_part* part = &world->parts[world->held];
    world->pull.vector = pull_in_space(world, &local);
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = world->held, .drag = world->pull};
    dm_motion motion;
    part->has_keys = 0;
    if (!world->has_motion || dm_motion_generate(world->context, world->object, &desc, &motion) != DM_OK) return;
    part->has_keys = dm_motion_get_frames(world->context, motion, part->keys, NULL) == DM_OK;
    dm_motion_destroy(world->context, motion);
}

static void step_part(world* world, uint32_t id, const dm_ray* ray, float dt) {
    world_part* part = &world->parts[id];
    const uint32_t changes = part->last.changes;
    if (dm_drag_update(world->context, part->drag, ray, dt, &part->last) != DM_OK) return;
    dm_drag_get_part_state(world->context, part->drag, &part->state);
    part->basis = part->last.joint_basis;
    if (part->last.changes != changes) {
        part->has_keys = 0;
        part->has_changed = 1;
    }
    if (part->last.phase == DM_DRAG_AT_REST) world_end_drag(world, id);
}

void world_step(world* world, const dm_ray* ray, float dt) {
    int moving = 0;
    if (world->table != NULL && world->object) {
        world_scene_step(world, ray, dt);
        return;
    }
    for (uint32_t id = 1; id <= world->part_count; id++) {
        if (!world->parts[id].drag) continue;
        const dm_ray local = id == world->held ? carried_ray(world, ray) : *ray;
        step_part(world, id, id == world->held ? &local : NULL, dt);
        moving = 1;
    }
    if (moving) world_update(world);
}

void world_release(world* world) {
    const dm_release_desc desc = {.struct_size = sizeof desc, .intent = world->intent};
    const uint32_t id = world->held;
    world->held = 0;
    if (world->table != NULL) {
        game_release(&world->game, 0);
        return;
    }
    if (dm_drag_release(world->context, world->parts[id].drag, &desc, NULL) != DM_OK) world_end_drag(world, id);
    world_update(world);
}
