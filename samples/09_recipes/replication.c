/* Replication: the server drags, clients show. They get the joint when it changes and the value every frame, and need
 * neither object nor context. A late joiner gets both once. */
#include "recipe.h"

typedef struct packet {
    uint32_t changes; /* of the joint so far */
    float value;
    dm_pose pose; /* while the part comes over to a new joint, joint and value do not say it */
    int has_joint;
    dm_joint joint; /* field by field on the wire, as in saving.c; its evidence is for who drags next */
} packet;

typedef struct client {
    dm_joint joint;
    dm_pose pose;
} client;

static packet make_packet(dm_context* context, dm_drag drag, const dm_drag_state* now, uint32_t sent, int newcomer) {
    dm_part_state part = dm_part_state_default();
    EXPECT(dm_drag_get_part_state(context, drag, &part) == DM_OK);
    return (packet){now->changes, part.value, part.pose, newcomer || now->changes != sent, part.joint};
}

static void receive(client* c, const packet* p) {
    if (p->has_joint) c->joint = p->joint;
    dm_pose on_joint;
    EXPECT(dm_joint_pose(&c->joint, p->value, &on_joint) == DM_OK);
    c->pose = shift_between(&on_joint, &p->pose) < 1e-4f ? on_joint : p->pose;
}

int main(void) {
    dm_context* context = NULL;
    const dm_object object = recipe_open(&context);
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .object = object, .part_id = CABINET_DOOR, .grab_point = handle_point};
    dm_drag drag = 0;
    EXPECT(dm_drag_begin(context, &desc, &drag) == DM_OK);
    client first = {.joint = dm_joint_default()}, late = first;
    dm_drag_state now = dm_drag_state_default();
    uint32_t sent = 0;
    int joints = 0;
    for (int frame = 0; frame < 2 * FPS; frame++) {
        const dm_ray ray = ray_through(eye, hand_at(0.01f * (float)frame));
        EXPECT(dm_drag_update(context, drag, &ray, 1.0f / FPS, &now) == DM_OK);
        const packet p = make_packet(context, drag, &now, sent, frame == 0);
        sent = p.changes, joints += p.has_joint;
        receive(&first, &p);
        EXPECT(shift_between(&first.pose, &now.pose) < 1e-3f);
    }
    const packet whole = make_packet(context, drag, &now, sent, 1);
    receive(&late, &whole);
    EXPECT(shift_between(&late.pose, &first.pose) < 1e-3f);

    /* Where an engine replicates transforms anyway, the value comes back out of the pose. */
    float value, angle, off;
    EXPECT(dm_joint_value(&late.joint, &late.pose, &value, &angle, &off) == DM_OK);
    printf("%d joints in %d packets; value %.3f, from the pose %.3f\n", joints, 2 * FPS, (double)now.value,
           (double)value);
    EXPECT(fabsf(value - now.value) < 1e-3f && angle < 1e-3f && off < 1e-3f);
    dm_context_destroy(context);
    return 0;
}
