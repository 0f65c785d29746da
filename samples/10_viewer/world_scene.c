/* Scenes of samples/12_latch in the viewer: joints, rules, links and hands of a table. */
#include <stdio.h>
#include <string.h>

#include "parts.h"

/* What is heard stands as the message. */
static void hear(void* user, uint32_t part_id, const dm_drag_state* now) {
    world* w = user;
    for (uint32_t event = 1; event <= now->events; event <<= 1) {
        const char* words = game_sound(now->events & event);
        if (words == NULL) continue;
        snprintf(w->message, sizeof w->message, "%s %s", w->parts[part_id].name, words);
    }
}

void world_scene_parts(world* world) {
    const scene* table = world->table;
    for (uint32_t i = 0; i <= table->part_count; i++) {
        const uint32_t id = i > 0 ? parts_add(world, table->parts[i - 1].name) : 0;
        dm_gltf_node node;
        if (dm_gltf_get_node(world->gltf, i, &node) != DM_OK) return;
        memset(world->face_part + node.first_face, (int)id, node.face_count);
        if (id > 0) world->parts[id].parent = table->parts[i - 1].parent;
    }
}

int world_scene_equip(world* world) {
    const scene* table = world->table;
    world->acting = 0;
    if (table == NULL) return 0;
    if (world->part_count != table->part_count) {
        world->table = NULL;
        return 0;
    }
    if (scene_equip(table, world->context, world->object) != DM_OK) return -1;
    game_open(&world->game, table, world->context, world->object);
    world->game.heard = hear, world->game.user = world;
    return 0;
}

int world_scene_grab(world* world, const dm_hit* hit) {
    const dm_pose back = pose_inverse(&world->parts[hit->part_id].carried);
    if (world->acting || game_grab(&world->game, 0, hit->part_id, hit->point) != DM_OK) return -1;
    world_remember(world, hit->part_id);
    world->held = hit->part_id;
    world->pull = (dm_drag_hint){.point = pose_point(&back, hit->point)}; /* on the part at rest */
    return 0;
}

void world_scene_act(world* world) {
    if (world->table == NULL || !world->object) return;
    for (int32_t hand = 0; hand < GAME_HANDS; hand++) game_release(&world->game, hand);
    world->held = 0;
    world->acting = !world->acting;
    script_open(&world->script);
}

void world_scene_step(world* world, const dm_ray* ray, float dt) {
    if (world->acting) {
        world->acting = script_step(&world->script, &world->game, dt);
    } else {
        const dm_hand hands[GAME_HANDS] = {{.kind = world->held ? DM_HAND_RAY : DM_HAND_NONE, .ray = *ray}};
        game_step(&world->game, hands, dt);
    }
    for (uint32_t id = 1; id <= world->part_count; id++) {
        world_part* part = &world->parts[id];
        part->state.value = world->game.values[id - 1];
        dm_joint_pose(&part->state.joint, part->state.value, &part->state.pose);
        if (id == world->held) part->last.grab_point = pose_point(&part->state.pose, world->pull.point);
    }
    world_update(world);
}
