/* VR: two controllers pull two parts at the same time, each by its own drag. A hand that holds the handle itself is a
 * point in space, DM_HAND_POINT. A controller that points from afar is a ray, DM_HAND_RAY. */
#include "recipe.h"

typedef struct controller {
    dm_drag drag;
    uint32_t part;
    dm_vec3 held; /* where it holds the part */
} controller;

static void squeeze(dm_context* context, dm_object object, controller* hand) {
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .object = object, .part_id = hand->part, .grab_point = hand->held};
    EXPECT(dm_drag_begin(context, &desc, &hand->drag) == DM_OK);
}

int main(void) {
    dm_context* context = NULL;
    const dm_object object = recipe_open(&context);
    const dm_vec3 belt = {0.9f, 1.1f, 1.9f};
    controller left = {.part = CABINET_DRAWER, .held = {0.3f, 0.88f, 0.45f}};
    controller right = {.part = CABINET_DOOR, .held = handle_point};
    squeeze(context, object, &left);
    squeeze(context, object, &right);
    dm_drag_state drawer = dm_drag_state_default(), door = dm_drag_state_default();
    for (int frame = 0; frame <= 90; frame++) { /* a second at 90 Hz */
        const float share = (float)frame / 90;
        dm_drag_input touch = dm_drag_input_default(), laser = dm_drag_input_default();
        touch.hand.kind = DM_HAND_POINT; /* the hand is on the handle */
        touch.hand.point = (dm_vec3){left.held.x, left.held.y, left.held.z + 0.25f * share};
        laser.hand.kind = DM_HAND_RAY; /* the controller points from afar */
        laser.hand.ray = ray_through(belt, hand_at(0.8f * share));
        EXPECT(dm_drag_update_input(context, left.drag, &touch, 1.0f / 90, &drawer) == DM_OK);
        EXPECT(dm_drag_update_input(context, right.drag, &laser, 1.0f / 90, &door) == DM_OK);
    }
    printf("drawer at %.3f, door at %.3f\n", (double)drawer.value, (double)door.value);
    EXPECT(fabsf(drawer.grab_point.z - left.held.z - 0.25f) < 0.05f);
    EXPECT(distance(door.grab_point, hand_at(0.8f)) < 0.1f);
    dm_context_destroy(context);
    return 0;
}
