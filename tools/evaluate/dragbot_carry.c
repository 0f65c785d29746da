/* What a moving camera and a moving instance do to the scripted player's points, rays and view. */
#include "dragbot.h"

vec bot_carry_point(const bot_carry* carry, vec point) {
    const vec turned = turn(sub(point, carry->centre), carry->up, carry->angle);
    return add(add(carry->centre, turned), scale(carry->up, carry->rise));
}

dm_ray bot_carry_ray_back(const bot_carry* carry, const dm_ray* ray) {
    const vec from = sub(sub(vec_of(ray->origin), scale(carry->up, carry->rise)), carry->centre);
    return (dm_ray){vec_out(add(carry->centre, turn(from, carry->up, -carry->angle))),
                    vec_out(turn(vec_of(ray->direction), carry->up, -carry->angle))};
}

bot_view bot_carry_view(const bot_carry* carry, const bot_view* view) {
    bot_view moved = *view;
    moved.eye = bot_carry_point(carry, view->eye);
    moved.forward = turn(view->forward, carry->up, carry->angle);
    moved.right = turn(view->right, carry->up, carry->angle);
    moved.up = turn(view->up, carry->up, carry->angle);
    moved.camera.eye = vec_out(moved.eye);
    moved.camera.forward = vec_out(moved.forward);
    moved.camera.up = vec_out(moved.up);
    return moved;
}
