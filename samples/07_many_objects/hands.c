/* A hand is a drag and where it pulls. What it has moved is kept with the level, not with the instance. */
#include "hands.h"

#include "../common/vectors.h"

#define FRAME_TIME (1.0f / 60)
#define PULL_LENGTH 0.6f /* m, out of the surface that was grabbed */

static void let_go(hands* h, hand* one) {
    dm_part_state state = {.struct_size = sizeof state};
    if (one->drag == 0) return;
    if (dm_drag_end(h->stream->context, one->drag, &state) == DM_OK)
        level_keep(h->stream->level, one->prop, one->part, &state);
    one->drag = 0;
}

void hands_leave(void* user, uint32_t prop) {
    hands* h = user;
    for (int i = 0; i < HANDS; i++)
        if (h->hand[i].prop == prop) let_go(h, &h->hand[i]);
}

void hands_rest(hands* h) {
    for (int i = 0; i < HANDS; i++) let_go(h, &h->hand[i]);
}

/* A ray of the world in the frame of an instance. */
static dm_ray ray_in(const dm_pose* place, dm_vec3 from, dm_vec3 to) {
    dm_pose back;
    dm_pose_inverse(place, &back);
    const dm_vec3 origin = pose_point(&back, from);
    return (dm_ray){origin, sub(pose_point(&back, to), origin)};
}

static dm_result pull(hands* h, hand* one) {
    const prop* p = &h->stream->level->props[one->prop];
    const float share = (float)++one->frame / PULL_FRAMES;
    const dm_ray ray = ray_in(&p->place, one->eye, mix(one->from, one->to, share));
    dm_drag_state state = {.struct_size = sizeof state};
    dm_result result = dm_drag_update(h->stream->context, one->drag, &ray, FRAME_TIME, &state);
    if (result == DM_OK) result = stream_move(h->stream, one->prop, one->part, &state.pose);
    h->updates++;
    if (one->frame == PULL_FRAMES) let_go(h, one);
    return result;
}

dm_result hands_pull(hands* h) {
    dm_result result = DM_OK;
    for (int i = 0; i < HANDS && result == DM_OK; i++)
        if (h->hand[i].drag != 0) result = pull(h, &h->hand[i]);
    return result;
}

/* Whether a part may be taken: the body carries it, nobody has it, and nobody has moved it yet. */
static bool is_free(const hands* h, uint32_t prop, uint32_t part) {
    const kind* k = &h->stream->kinds[h->stream->level->props[prop].kind];
    for (int i = 0; i < HANDS; i++)
        if (h->hand[i].drag != 0 && h->hand[i].prop == prop) return false;
    for (uint32_t i = 0; i < k->part_count; i++)
        if (k->parts[i].id == part && k->parts[i].parent != 0) return false;
    return part != 0 && level_kept(h->stream->level, prop, part) == NULL;
}

static void grab(hands* h, hand* one, const dm_ray* ray, const dm_hit* hit) {
    const uint32_t prop = h->stream->prop_of[hit->instance];
    if (hit->distance > ARM || !is_free(h, prop, hit->part_id)) return;
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .object = hit->object, .part_id = hit->part_id, .grab_point = hit->object_point};
    dm_drag drag;
    if (dm_drag_begin(h->stream->context, &desc, &drag) != DM_OK) return;
    const float towards = dot(hit->normal, ray->direction) < 0 ? 1.0f : -1.0f;
    const dm_vec3 to = along(hit->point, hit->normal, towards * PULL_LENGTH);
    *one = (hand){drag, prop, hit->part_id, 0, ray->origin, hit->point, to};
    h->drags++;
}

/* Where a hand points, in pixels: over the whole view in turn. */
static void aim(const dm_camera* camera, uint64_t frame, int i, float* out_x, float* out_y) {
    const uint64_t turn = frame * 37 + (uint64_t)i * 61;
    *out_x = camera->viewport_width * (float)(turn * 29 % 101) / 101;
    *out_y = camera->viewport_height * (0.3f + 0.6f * (float)(turn % 89) / 89);
}

dm_result hands_look(hands* h, const dm_camera* camera, uint64_t frame) {
    dm_result result = DM_OK;
    for (int i = 0; i < HANDS && result == DM_OK; i++) {
        dm_ray ray;
        dm_hit hit = {.struct_size = sizeof hit};
        float x, y;
        aim(camera, frame, i, &x, &y);
        result = dm_camera_ray(h->stream->context, camera, x, y, &ray);
        if (result == DM_OK) result = dm_scene_pick(h->stream->context, h->stream->scene, &ray, &hit);
        h->picks++;
        h->hits += hit.object != 0;
        if (result == DM_OK && hit.object != 0 && h->hand[i].drag == 0) grab(h, &h->hand[i], &ray, &hit);
    }
    return result;
}
