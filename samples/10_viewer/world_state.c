/* Where parts are and by which joints: read, shown, set, remembered and put back. */
#include <string.h>

#include "world.h"

static int32_t basis_of(const dm_joint* joint) {
    if (joint->source == DM_JOINT_FROM_HOST) return DM_BASIS_HOST;
    return joint->source == DM_JOINT_CHOSEN ? DM_BASIS_CHOSEN : DM_BASIS_PREPARED;
}

void world_read_joint(world* world, uint32_t id) {
    world_part* part = &world->parts[id];
    part->state = dm_part_state_default();
    part->state.pose = pose_identity;
    part->state.joint = part->hypotheses[0] = dm_joint_default();
    dm_object_get_joint(world->context, world->object, id, &part->state.joint);
    part->basis = basis_of(&part->state.joint);
    part->has_changed = 0;
    if (dm_object_get_hypotheses(world->context, world->object, id, NULL, part->hypotheses, DM_MAX_HYPOTHESES,
                                 &part->hypothesis_count) != DM_OK)
        part->hypothesis_count = 0;
}

void world_update(world* world) {
    if (!world->object) return;
    for (uint32_t id = 1; id <= world->part_count; id++) {
        dm_pose pose = world->parts[id].state.pose;
        /* Chains are short; ids of carriers may be larger, and a loop has been refused by the library. */
        for (uint32_t carrier = world->parts[id].parent; carrier; carrier = world->parts[carrier].parent)
            dm_pose_multiply(&world->parts[carrier].state.pose, &pose, &pose);
        world->parts[id].carried = pose;
        dm_scene_move(world->context, world->scene, world->instance, id, &pose);
    }
    dm_scene_commit(world->context, world->scene);
}

void world_end_drag(world* world, uint32_t id) {
    world_part* part = &world->parts[id];
    dm_drag_end(world->context, part->drag, &part->state);
    part->drag = 0;
}

static void let_go(world* world, uint32_t id) {
    if (world->parts[id].drag) world_end_drag(world, id);
    if (world->held == id) world->held = 0;
}

static float within(const dm_joint* joint, float value) {
    return joint->upper > joint->lower ? glm_clamp(value, joint->lower, joint->upper) : value;
}

void world_set_value(world* world, uint32_t id, float value) {
    dm_part_state* state = &world->parts[id].state;
    let_go(world, id);
    state->value = within(&state->joint, value);
    if (world->table != NULL) game_set(&world->game, id, state->value);
    dm_joint_pose(&state->joint, state->value, &state->pose);
    world_update(world);
}

/* ---- undo ---- */

void world_remember(world* world, uint32_t id) {
    world_past* history = world->history;
    if (world->history_count == WORLD_HISTORY) { /* the oldest goes */
        world->history_count--;
        memmove(history, history + 1, world->history_count * sizeof *history);
    }
    history[world->history_count++] = (world_past){id, world->parts[id].state, world->parts[id].basis};
}

static void put_back(world* world, uint32_t id, const dm_part_state* state, int32_t basis) {
    world_part* part = &world->parts[id];
    part->state = *state;
    part->basis = basis;
    part->has_keys = part->has_changed = 0;
    world_update(world);
}

int world_undo(world* world) {
    if (world->history_count == 0) return -1;
    const world_past* past = &world->history[--world->history_count];
    let_go(world, past->part);
    put_back(world, past->part, &past->state, past->basis);
    return 0;
}

int world_as_before(world* world, uint32_t id) {
    world_part* part = &world->parts[id];
    if (!part->has_changed) return -1;
    let_go(world, id);
    world_remember(world, id);
    dm_part_state before = part->taken;
    before.joint.source = DM_JOINT_CHOSEN; /* no pull changes it; its limits go on being estimates */
    before.joint.joint_confidence = before.joint.type_confidence = 1;
    put_back(world, id, &before, DM_BASIS_CHOSEN);
    return 0;
}

/* A part's pieces that were by another joint. */
static void forget_past(world* world, uint32_t id) {
    uint32_t kept = 0;
    for (uint32_t i = 0; i < world->history_count; i++)
        if (world->history[i].part != id) world->history[kept++] = world->history[i];
    world->history_count = kept;
}

void world_set_joint(world* world, uint32_t id, const dm_joint* joint) {
    let_go(world, id);
    if (dm_object_set_joint(world->context, world->object, id, joint) != DM_OK) return;
    world_part* part = &world->parts[id];
    dm_object_get_joint(world->context, world->object, id, &part->state.joint);
    part->basis = basis_of(&part->state.joint);
    part->has_keys = part->has_changed = part->is_stated = 0;
    forget_past(world, id);
    world_set_value(world, id, part->state.value);
}
