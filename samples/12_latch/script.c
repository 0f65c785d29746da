/* A scene's own hands: each takes hold, goes its way in straight lines, and lets go. */
#include "game.h"

#include "../common/vectors.h"

static float length_of(const scene_hand* hand) {
    float seconds = 0;
    for (int i = 0; i < SCENE_WAYPOINTS; i++) seconds += hand->way[i].seconds;
    return seconds;
}

/* Where a hand is, `seconds` after it took hold at `from`. */
static dm_vec3 place_of(const scene_hand* hand, dm_vec3 from, float seconds) {
    for (int i = 0; i < SCENE_WAYPOINTS && hand->way[i].seconds > 0 && seconds > 0; i++) {
        const float share = seconds < hand->way[i].seconds ? seconds / hand->way[i].seconds : 1;
        from = along(from, hand->way[i].move, share);
        seconds -= hand->way[i].seconds;
    }
    return from;
}

void script_open(script* script) {
    *script = (struct script){.acting = {GAME_NO_HAND, GAME_NO_HAND}};
}

static void take_hold(script* script, game* game, int32_t free_hand) {
    const scene_hand* hand = &game->scene->hands[script->next];
    const dm_vec3 point = pose_point(&game->poses[hand->part - 1], hand->grab);
    script->acting[free_hand] = (int32_t)script->next++;
    script->from[free_hand] = point;
    game_grab(game, free_hand, hand->part, point);
}

int script_step(script* script, game* game, float dt) {
    const scene* scene = game->scene;
    script->time += dt;
    for (int32_t h = 0; h < GAME_HANDS; h++) {
        if (script->acting[h] == GAME_NO_HAND && script->next < scene->hand_count &&
            script->time >= scene->hands[script->next].begin)
            take_hold(script, game, h);
        if (script->acting[h] == GAME_NO_HAND) continue;
        const scene_hand* hand = &scene->hands[script->acting[h]];
        const float seconds = script->time - hand->begin;
        script->hands[h] = (dm_hand){.kind = DM_HAND_POINT, .point = place_of(hand, script->from[h], seconds)};
        if (seconds <= length_of(hand)) continue;
        game_release(game, h);
        script->acting[h] = GAME_NO_HAND;
    }
    game_step(game, script->hands, dt);
    return script->time < scene->seconds;
}
