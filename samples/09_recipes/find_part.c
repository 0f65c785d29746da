/* A mesh without part ids: the part that a grabbed point belongs to is found, and its joint with it. */
#include "recipe.h"

enum { FACES = CABINET_INDICES / 3, BOX_FACES = FACES / CABINET_BOXES };

/* How many faces of the door are not said to move, and how many others are. */
static int count_wrong_faces(const uint8_t moves[FACES]) {
    int wrong = 0;
    for (int face = 0; face < FACES; face++)
        wrong += moves[face] != ((int)cabinet_boxes[face / BOX_FACES][6] == CABINET_DOOR);
    return wrong;
}

int main(void) {
    static cabinet shape;
    static uint8_t moves[FACES]; /* of each face: 1 = of the part */
    dm_context* context = NULL;
    dm_context_desc host = dm_context_desc_default();
    host.log = (dm_log){NULL, print_message};
    EXPECT(dm_context_create(&host, &context) == DM_OK);
    dm_mesh_desc mesh = cabinet_make(&shape);
    mesh.part_ids = NULL, mesh.part_id_bytes = 0;
    const dm_drag_hint pull = {.point = {0.45f, 0.6f, 0.42f}, .vector = {-0.05f, 0, 0.3f}}; /* of the door */
    EXPECT(dm_mesh_find_part(context, &mesh, &pull, moves, FACES) == DM_OK);
    mesh.part_ids = moves, mesh.part_id_bytes = FACES;
    mesh.part_id_format = DM_UINT8, mesh.part_id_scope = DM_PER_FACE;
    EXPECT(count_wrong_faces(moves) == 0);
    dm_object_desc desc = dm_object_desc_default();
    dm_object object = 0;
    dm_joint joint = dm_joint_default();
    dm_part_desc part = dm_part_desc_default();
    part.id = 1, part.drag = &pull;
    desc.mesh = &mesh, desc.parts = &part, desc.part_count = 1;
    EXPECT(dm_object_prepare(context, &desc, &object) == DM_OK);
    EXPECT(dm_object_get_joint(context, object, 1, &joint) == DM_OK);
    EXPECT(joint.type == DM_JOINT_REVOLUTE);
    printf("the part turns, with confidence %.2f\n", (double)joint.type_confidence);
    dm_context_destroy(context);
    return 0;
}
