/* VR: two controllers pull two parts at the same time, each by its own drag. A pointing controller is a ray; a hand
 * that holds the handle itself is the ray from the eye through the hand. */
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
    const dm_vec3 head = {0.3f, 1.5f, 1.4f}, belt = {0.9f, 1.1f, 1.9f};
    controller left = {.part = CABINET_DRAWER, .held = {0.3f, 0.88f, 0.45f}};
    controller right = {.part = CABINET_DOOR, .held = handle_point};
    squeeze(context, object, &left);
    squeeze(context, object, &right);
    dm_drag_state drawer = dm_drag_state_default(), door = dm_drag_state_default();
    for (int frame = 0; frame <= 90; frame++) { /* a second at 90 Hz; the head moves meanwhile, as heads do */
        const float share = (float)frame / 90;
        const dm_vec3 looks_from = {head.x + 0.05f * share, head.y, head.z};
        const dm_vec3 left_hand = {left.held.x, left.held.y, left.held.z + 0.25f * share};
        const dm_ray touch = ray_through(looks_from, left_hand);       /* the hand is on the handle */
        const dm_ray laser = ray_through(belt, hand_at(0.8f * share)); /* the controller points from afar */
        EXPECT(dm_drag_update(context, left.drag, &touch, 1.0f / 90, &drawer) == DM_OK);
        EXPECT(dm_drag_update(context, right.drag, &laser, 1.0f / 90, &door) == DM_OK);
    }
    printf("drawer at %.3f, door at %.3f\n", (double)drawer.value, (double)door.value);
    EXPECT(fabsf(drawer.grab_point.z - left.held.z - 0.25f) < 0.05f);
    EXPECT(distance(door.grab_point, hand_at(0.8f)) < 0.1f);
    dm_context_destroy(context);
    return 0;
}
