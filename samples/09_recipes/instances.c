/* One prepared object, two cabinets in the room. Joints belong to the object, where the doors stand to the instance. */
#include "recipe.h"

typedef struct furniture {
    dm_object object;   /* shared */
    dm_part_state door; /* its own */
} furniture;

/* The player takes hold of the door at `point`, in the frame of this instance. */
static dm_drag grab(dm_context* context, const furniture* one, dm_vec3 point) {
    dm_drag_desc desc = dm_drag_desc_default();
    dm_drag drag = 0;
    desc.object = one->object;
    desc.part_id = CABINET_DOOR;
    desc.grab_point = point;
    desc.state = &one->door;
    EXPECT(dm_drag_begin(context, &desc, &drag) == DM_OK);
    return drag;
}

int main(void) {
    dm_context* context = NULL;
    const dm_object object = recipe_open(&context);
    furniture left = {object, recipe_closed(context, object, CABINET_DOOR)}, right = left;
    const dm_drag a = grab(context, &left, handle_point), b = grab(context, &right, handle_point);
    const dm_drag_state wide = recipe_pull(context, a, 0, 1.2f), ajar = recipe_pull(context, b, 0, 0.4f);
    EXPECT(dm_drag_end(context, a, &left.door) == DM_OK);
    EXPECT(dm_drag_end(context, b, &right.door) == DM_OK);
    printf("left door at %.2f, right door at %.2f\n", (double)left.door.value, (double)right.door.value);
    EXPECT(left.door.value == wide.value && right.door.value == ajar.value && wide.value != ajar.value);

    /* The next grab goes on where this one ended, whatever joint the pull had found. */
    const dm_drag again = grab(context, &left, wide.grab_point);
    const dm_ray still = ray_through(eye, wide.grab_point);
    dm_drag_state now = dm_drag_state_default();
    EXPECT(dm_drag_update(context, again, &still, 1.0f / FPS, &now) == DM_OK);
    printf("grabbed again: the handle moves %.6f\n", (double)shift_between(&now.pose, &wide.pose));
    EXPECT(shift_between(&now.pose, &wide.pose) < 1e-3f);
    dm_context_destroy(context);
    return 0;
}
