/* An instance that the level designer stretched: twice as wide, as a mirror image. The scale goes into the drag; poses
 * are rigid, so nothing shears. */
#include "recipe.h"

int main(void) {
    dm_context* context = NULL;
    const dm_object object = recipe_open(&context);
    const dm_vec3 scale = {-2, 1, 1};
    const dm_vec3 grabbed = times(handle_point, scale), watcher = {-2.5f, 1.4f, 3};

    dm_drag_desc desc = dm_drag_desc_default();
    desc.object = object, desc.part_id = CABINET_DOOR;
    desc.scale = scale;
    desc.grab_point = grabbed; /* object coordinates times scale; rays too */
    dm_drag drag = 0;
    EXPECT(dm_drag_begin(context, &desc, &drag) == DM_OK);

    dm_joint joint = dm_joint_default();
    EXPECT(dm_object_get_joint(context, object, CABINET_DOOR, &joint) == DM_OK);
    EXPECT(dm_joint_scale(&joint, scale, &joint) == DM_OK); /* for a physics constraint, or to draw the axis */
    dm_drag_state now = dm_drag_state_default();
    dm_vec3 hand = grabbed;
    for (int frame = 0; frame <= FPS; frame++) {
        dm_pose pose;
        EXPECT(dm_joint_pose(&joint, 0.8f * fminf(2.0f * (float)frame / FPS, 1), &pose) == DM_OK);
        hand = pose_point(&pose, grabbed);
        const dm_ray ray = ray_through(watcher, hand);
        EXPECT(dm_drag_update(context, drag, &ray, 1.0f / FPS, &now) == DM_OK);
    }
    /* To draw: vertex -> times scale -> pose -> the instance's rotation and place. */
    const dm_vec3 corner = pose_point(&now.pose, times((dm_vec3){0.6f, 0.79f, 0.42f}, scale));
    printf("the handle is %.4f from the hand, the door's corner at (%.2f, %.2f, %.2f)\n",
           (double)distance(now.grab_point, hand), (double)corner.x, (double)corner.y, (double)corner.z);
    EXPECT(distance(now.grab_point, hand) < 0.02f);

    dm_part_state door = dm_part_state_default();
    EXPECT(dm_drag_end(context, drag, &door) == DM_OK);
    desc.state = &door; /* of this instance, in its scaled frame: the next grab gets both */
    desc.grab_point = now.grab_point;
    EXPECT(dm_drag_begin(context, &desc, &drag) == DM_OK);
    dm_context_destroy(context);
    return 0;
}
