/* A saved game keeps joint and value of every part that a player has moved, as numbers, and what pulls have said of its
 * joints. Structs are not written as they are: they grow. */
#include <inttypes.h>

#include "recipe.h"

enum { NUMBERS = 12, WORDS = sizeof((dm_joint*)0)->evidence / sizeof(uint32_t) };

static void save(FILE* file, const dm_part_state* door) {
    const dm_joint* j = &door->joint;
    fprintf(file, "door %d %d", j->type, j->source);
    const float numbers[NUMBERS] = {
        door->value, j->type_confidence, j->joint_confidence, j->pitch,    j->axis.x, j->axis.y,
        j->axis.z,   j->origin.x,        j->origin.y,         j->origin.z, j->lower,  j->upper};
    for (int i = 0; i < NUMBERS; i++) fprintf(file, " %a", (double)numbers[i]); /* %a loses no bit */
    for (int i = 0; i < WORDS; i++) fprintf(file, " %" PRIu32, j->evidence[i]);
}

static dm_part_state load(FILE* file) {
    dm_part_state door = dm_part_state_default();
    door.joint = dm_joint_default();
    dm_joint* j = &door.joint;
    float n[NUMBERS];
    /* NOLINTBEGIN(cert-err34-c): the game has written the file itself */
    EXPECT(fscanf(file, "door %d %d", &j->type, &j->source) == 2);
    for (int i = 0; i < NUMBERS; i++) EXPECT(fscanf(file, "%f", &n[i]) == 1);
    for (int i = 0; i < WORDS; i++) EXPECT(fscanf(file, "%" SCNu32, &j->evidence[i]) == 1);
    /* NOLINTEND(cert-err34-c) */
    door.value = n[0], j->type_confidence = n[1], j->joint_confidence = n[2], j->pitch = n[3];
    j->axis = (dm_vec3){n[4], n[5], n[6]}, j->origin = (dm_vec3){n[7], n[8], n[9]};
    j->lower = n[10], j->upper = n[11];
    EXPECT(dm_joint_pose(j, door.value, &door.pose) == DM_OK); /* draw it so, before anyone touches it */
    return door;
}

int main(void) {
    dm_context* context = NULL;
    const dm_object object = recipe_open(&context);
    dm_part_state door = recipe_closed(context, object, CABINET_DOOR);
    const dm_drag_state last = recipe_open_door(context, object, 0.9f, &door);

    EXPECT(door.joint.evidence[0] != 0); /* the pull has said something */

    FILE* file = tmpfile();
    EXPECT(file != NULL);
    save(file, &door);
    rewind(file);
    const dm_part_state loaded = load(file);
    fclose(file);
    printf("saved at %.3f, loaded at %.3f\n", (double)door.value, (double)loaded.value);
    /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is asked */
    EXPECT(loaded.value == door.value && memcmp(&loaded.joint, &door.joint, sizeof door.joint) == 0);

    const dm_drag_desc again = {.struct_size = sizeof again,
                                .object = object,
                                .part_id = CABINET_DOOR,
                                .grab_point = last.grab_point,
                                .state = &loaded};
    dm_drag drag = 0;
    EXPECT(dm_drag_begin(context, &again, &drag) == DM_OK);
    dm_part_state now = dm_part_state_default();
    EXPECT(dm_drag_end(context, drag, &now) == DM_OK);
    EXPECT(shift_between(&now.pose, &loaded.pose) < 1e-5f);
    dm_context_destroy(context);
    return 0;
}
