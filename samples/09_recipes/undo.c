/* Undo puts back the piece that the part had before, with what earlier pulls have said of its joints. Nothing in the
 * library has to be told. */
#include "recipe.h"

enum { HISTORY = 8 };

int main(void) {
    dm_context* context = NULL;
    const dm_object object = recipe_open(&context);
    dm_part_state door = recipe_closed(context, object, CABINET_DOOR), history[HISTORY];
    int depth = 0;
    float angle = 0;
    for (int pull = 0; pull < 3; pull++) {
        history[depth++] = door; /* before every grab */
        dm_pose pose;
        EXPECT(dm_joint_pose(&door.joint, door.value, &pose) == DM_OK);
        const dm_drag_desc desc = {.struct_size = sizeof desc,
                                   .object = object,
                                   .part_id = CABINET_DOOR,
                                   .grab_point = pose_point(&pose, handle_point),
                                   .state = &door};
        dm_drag drag = 0;
        EXPECT(dm_drag_begin(context, &desc, &drag) == DM_OK);
        recipe_pull(context, drag, angle, angle + 0.4f);
        angle += 0.4f;
        EXPECT(dm_drag_end(context, drag, &door) == DM_OK);
        printf("pulled to %.3f\n", (double)door.value);
    }
    while (depth > 0) {
        door = history[--depth];
        printf("undone to %.3f\n", (double)door.value);
    }
    EXPECT(door.value == 0 && door.joint.evidence[0] == 0);

    /* A designer's joint is undone in the object itself. */
    dm_joint own = dm_joint_default(), mine = dm_joint_default(), now = dm_joint_default();
    EXPECT(dm_object_get_joint(context, object, CABINET_DOOR, &own) == DM_OK);
    mine.type = DM_JOINT_PRISMATIC, mine.axis = (dm_vec3){0, 0, 1}, mine.upper = 0.3f;
    EXPECT(dm_object_set_joint(context, object, CABINET_DOOR, &mine) == DM_OK);
    EXPECT(dm_object_reset_joint(context, object, CABINET_DOOR) == DM_OK);
    EXPECT(dm_object_get_joint(context, object, CABINET_DOOR, &now) == DM_OK);
    /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is asked */
    EXPECT(memcmp(&own, &now, sizeof own) == 0);
    dm_context_destroy(context);
    return 0;
}
