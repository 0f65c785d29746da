/* What a game does with handles, locks, links and obstacles. Nothing here knows a scene: a game has its own tables. */
#include "game.h"

#include <math.h>
#include <string.h>

#include "../common/vectors.h"

static const dm_pose at_rest = {{0, 0, 0, 1}, {0, 0, 0, 0}};

/* ---- frames: a part that is carried moves in the frame of its carrier ---- */

static dm_pose inverse(dm_pose pose) {
    for (int i = 0; i < 3; i++) pose.real[i] = -pose.real[i], pose.dual[i] = -pose.dual[i];
    return pose;
}

static dm_pose carrier_pose(const game* game, uint32_t index) {
    const uint32_t parent = game->scene->parts[index].parent;
    return parent ? game->poses[parent - 1] : at_rest;
}

static dm_hand carried(const dm_pose* to_carrier, const dm_hand* hand) {
    dm_hand out = *hand;
    const dm_vec3 ahead = pose_point(to_carrier, add(hand->ray.origin, hand->ray.direction));
    out.point = pose_point(to_carrier, hand->point);
    out.ray.origin = pose_point(to_carrier, hand->ray.origin);
    out.ray.direction = sub(ahead, out.ray.origin);
    return out;
}

static void update_pose(game* game, uint32_t index) {
    const dm_pose carrier = carrier_pose(game, index);
    dm_pose pose = at_rest;
    dm_joint_pose(&game->parts[index].joint, game->values[index], &pose);
    dm_pose_multiply(&carrier, &pose, &game->poses[index]);
}

/* ---- hands ---- */

static dm_result begin_drag(game* game, uint32_t index, dm_vec3 point) {
    const scene_part* table = &game->scene->parts[index];
    dm_drag_rules rules = table->rules;
    dm_drag_desc desc = dm_drag_desc_default();
    rules.struct_size = sizeof rules;
    desc.object = game->object, desc.part_id = index + 1;
    desc.grab_point = point, desc.start_value = game->values[index];
    desc.feel = table->feel, desc.rules = &rules;
    return dm_drag_begin(game->context, &desc, &game->parts[index].drag);
}

static void end_drag(game* game, uint32_t index) {
    game_part* part = &game->parts[index];
    if (part->drag) dm_drag_end(game->context, part->drag, NULL);
    part->drag = 0;
    part->hands[0] = part->hands[1] = GAME_NO_HAND;
}

static int is_in_hand(const game_part* part) {
    return part->hands[0] != GAME_NO_HAND || part->hands[1] != GAME_NO_HAND;
}

dm_result game_grab(game* game, int32_t hand, uint32_t part_id, dm_vec3 point) {
    if (part_id == 0 || part_id > game->scene->part_count) return DM_ERROR_NOT_FOUND;
    const uint32_t index = part_id - 1;
    game_part* part = &game->parts[index];
    const dm_pose carrier = carrier_pose(game, index), to_carrier = inverse(carrier);
    const dm_vec3 local = pose_point(&to_carrier, point);
    if (is_in_hand(part)) { /* one hand is on it already */
        part->hands[1] = hand, part->second_at = local;
        return DM_OK;
    }
    end_drag(game, index);
    const dm_result result = begin_drag(game, index, local);
    if (result != DM_OK) return result;
    part->hands[0] = hand;
    const scene_part* table = &game->scene->parts[index];
    return table->pulls ? game_grab(game, hand, table->parent, point) : DM_OK;
}

void game_release(game* game, int32_t hand) {
    for (uint32_t i = 0; i < game->scene->part_count; i++) {
        game_part* part = &game->parts[i];
        const int was = is_in_hand(part);
        for (int k = 0; k < 2; k++)
            if (part->hands[k] == hand) part->hands[k] = GAME_NO_HAND;
        if (was && !is_in_hand(part)) dm_drag_release(game->context, part->drag, NULL, NULL);
    }
}

/* ---- a frame ---- */

/* What this frame tells the part: hands, handle, links, and what stands in its way. */
static dm_drag_input input_of(const game* game, uint32_t index) {
    const scene_part* table = &game->scene->parts[index];
    const game_part* part = &game->parts[index];
    const dm_pose carrier = carrier_pose(game, index), to_carrier = inverse(carrier);
    dm_drag_input input = dm_drag_input_default();
    if (part->hands[0] != GAME_NO_HAND) input.hand = carried(&to_carrier, &game->hands[part->hands[0]]);
    if (part->hands[1] != GAME_NO_HAND) {
        input.second = carried(&to_carrier, &game->hands[part->hands[1]]);
        input.second.grab_point = part->second_at;
    }
    input.flags = DM_INPUT_ASK | (game->held[index] ? (uint32_t)DM_INPUT_LOCKED : 0);
    if (table->handle) input.handles[0] = game->values[table->handle - 1];
    if (table->obstacle && game->values[table->obstacle - 1] < table->out_of_way)
        input.lower = -INFINITY, input.upper = table->stops_at;
    return input;
}

/* A part whose driver has moved it no longer moves by itself. */
static void follow_links(game* game, uint32_t index) {
    float before[SCENE_PARTS];
    memcpy(before, game->values, sizeof before);
    dm_object_follow_links(game->context, game->object, index + 1, game->values, game->held, game->scene->part_count);
    for (uint32_t i = 0; i < game->scene->part_count; i++)
        if (i != index && game->values[i] != before[i] && !is_in_hand(&game->parts[i])) end_drag(game, i);
}

static void step_part(game* game, uint32_t index, float dt) {
    game_part* part = &game->parts[index];
    const dm_drag_input input = input_of(game, index);
    dm_drag_state now = dm_drag_state_default();
    if (dm_drag_update_input(game->context, part->drag, &input, dt, &now) != DM_OK) return;
    game->values[index] = now.value;
    follow_links(game, index);
    if (game->values[index] != now.value) /* what it drives is at its limit */
        dm_drag_override(game->context, part->drag, game->values[index], &now);
    if (now.events & DM_EVENT_LET_GO) part->hands[0] = part->hands[1] = GAME_NO_HAND;
    if (now.events && game->heard != NULL) game->heard(game->user, index + 1, &now);
    if (now.phase == DM_DRAG_AT_REST) end_drag(game, index);
}

void game_step(game* game, const dm_hand hands[GAME_HANDS], float dt) {
    memcpy(game->hands, hands, sizeof game->hands);
    for (uint32_t i = 0; i < game->scene->part_count; i++) { /* carriers come first */
        if (game->parts[i].drag) step_part(game, i, dt);
        update_pose(game, i);
    }
    for (uint32_t i = 0; i < game->scene->part_count; i++) update_pose(game, i); /* what links have moved */
}

void game_open(game* game, const scene* scene, dm_context* context, dm_object object) {
    memset(game, 0, sizeof *game);
    game->context = context, game->object = object, game->scene = scene;
    for (uint32_t i = 0; i < scene->part_count; i++) {
        game_part* part = &game->parts[i];
        part->hands[0] = part->hands[1] = GAME_NO_HAND;
        part->joint = dm_joint_default();
        dm_object_get_joint(context, object, i + 1, &part->joint);
        update_pose(game, i);
    }
    follow_links(game, 0); /* which parts links hold from the start */
}

void game_set(game* game, uint32_t part_id, float value) {
    end_drag(game, part_id - 1);
    game->values[part_id - 1] = value;
    follow_links(game, part_id - 1);
    for (uint32_t i = 0; i < game->scene->part_count; i++) update_pose(game, i);
}

const char* game_sound(uint32_t event) {
    static const struct {
        uint32_t event;
        const char* words;
    } sounds[] = {
        {DM_EVENT_LEFT_REST, "leaves rest"},
        {DM_EVENT_REACHED_REST, "is at rest"},
        {DM_EVENT_OPENED, "opened"},
        {DM_EVENT_CLOSED, "closed"},
        {DM_EVENT_DETENT, "clicks"},
        {DM_EVENT_LIMIT_LOWER, "meets its lower limit"},
        {DM_EVENT_LIMIT_UPPER, "meets its upper limit"},
        {DM_EVENT_BLOCKED, "is blocked"},
        {DM_EVENT_FREED, "is free"},
        {DM_EVENT_LATCHED, "latches"},
        {DM_EVENT_UNLATCHED, "unlatches"},
        {DM_EVENT_LOCKED, "is held"},
        {DM_EVENT_LET_GO, "is let go"},
    };
    for (size_t i = 0; i < sizeof sounds / sizeof *sounds; i++)
        if (sounds[i].event == event) return sounds[i].words;
    return NULL;
}
