/* Hand-over to a physics engine and back: the joint becomes a hinge constraint, the body swings by itself, and the next
 * grab begins where physics left it. */
#include "recipe.h"

#include "cglm/scalar_quat.h"

/* What engines call it: PxRevoluteJoint, btHingeConstraint, JPH::HingeConstraint, hingeJoint … */
typedef struct engine_hinge {
    dm_vec3 anchor;
    float rotation[4]; /* local frame of the constraint, x = axis */
    int limited;
    float low, high, angle, speed; /* rad, rad/s */
} engine_hinge;

static engine_hinge make_hinge(const dm_part_state* door) {
    dm_joint_frame frame = dm_joint_frame_default();
    EXPECT(dm_joint_get_frame(&door->joint, &frame) == DM_OK);
    engine_hinge hinge = {.anchor = frame.origin, .low = frame.lower, .high = frame.upper, .angle = door->value};
    memcpy(hinge.rotation, frame.rotation, sizeof hinge.rotation);
    hinge.limited = frame.limits == (DM_LIMIT_LOWER | DM_LIMIT_UPPER);
    return hinge;
}

/* The body's transform as the engine has it after a step: a turn of `angle` about the frame's x axis, at the anchor. */
static dm_pose step(engine_hinge* hinge, float dt) {
    hinge->angle += dt * hinge->speed;
    if (hinge->limited) hinge->angle = fminf(fmaxf(hinge->angle, hinge->low), hinge->high);
    vec3 axis, turned;
    versor turn;
    dm_pose body;
    glm_quat_rotatev(hinge->rotation, (vec3){1, 0, 0}, axis);
    glm_quatv(turn, hinge->angle, axis);
    glm_quat_rotatev(turn, raw(hinge->anchor).v, turned);
    EXPECT(dm_pose_from_rotation(turn, sub(hinge->anchor, vec_from(turned)), &body) == DM_OK);
    return body;
}

int main(void) {
    dm_context* context = NULL;
    const dm_object object = recipe_open(&context);
    dm_part_state door = recipe_closed(context, object, CABINET_DOOR);
    const dm_drag_state last = recipe_open_door(context, object, 0.6f, &door);

    engine_hinge hinge = make_hinge(&door); /* the engine takes over, at the speed of the hand */
    hinge.speed = last.velocity;
    dm_pose body = step(&hinge, 0);
    EXPECT(shift_between(&body, &door.pose) < 1e-3f);
    for (int i = 0; i < 20; i++) body = step(&hinge, 1.0f / FPS);

    float angle_off, distance_off; /* and back: where does it stand, and is it still on its hinge? */
    EXPECT(dm_joint_value(&door.joint, &body, &door.value, &angle_off, &distance_off) == DM_OK);
    door.pose = body;
    printf("physics left the door at %.3f, %.1g rad and %.1g m off its hinge\n", (double)door.value, (double)angle_off,
           (double)distance_off);
    EXPECT(fabsf(door.value - hinge.angle) < 1e-3f && angle_off < 1e-3f && distance_off < 1e-3f);

    const dm_drag_desc again = {.struct_size = sizeof again,
                                .object = object,
                                .part_id = CABINET_DOOR,
                                .grab_point = pose_point(&body, handle_point),
                                .state = &door};
    dm_drag drag = 0;
    EXPECT(dm_drag_begin(context, &again, &drag) == DM_OK);
    dm_part_state now = dm_part_state_default();
    EXPECT(dm_drag_get_part_state(context, drag, &now) == DM_OK);
    EXPECT(shift_between(&now.pose, &body) < 1e-3f);
    dm_context_destroy(context);
    return 0;
}
