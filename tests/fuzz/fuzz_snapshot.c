/* Fuzz target: saved drags and part states. Whatever the bytes, the answer is an error, or finite numbers from then on.
 *
 * An input is a kind byte, and then:
 *   bytes     a saved drag as it is, or cut off;
 *   changes   of a good saved drag, whose checksum is set right: 2 bytes of place, 4 of content, again and again;
 *   a state   its joint and value, the scale of its instance, all as floats, and how it is dragged.
 * Corpora of the last two stay of use when a drag's layout changes. */
#include <stdlib.h>
#include <string.h>

#include "../include/test_shapes.h"
#include "../include/test_snapshot.h"
#include "expect.h"
#include "math/elementary.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

enum { BYTES, CHANGES, STATE, KINDS };                    /* kinds of input */
enum { HELD_FRAMES = 12, RELEASED_FRAMES = 6, DOOR = 1 }; /* updates of a drag; the part's id */

static dm_context* context;
static dm_object object;
static uint8_t good[DM_DRAG_SNAPSHOT_MAX]; /* a saved drag, half-way */
static const dm_vec3 handle = {0.45f, 0.5f, 0.55f};

static void prepare(void) {
    static test_shape shape;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){-0.5f, 0, -0.5f}, (const float[]){0.5f, 1, 0.45f}, 0);
    test_shape_box(&shape, (const float[]){-0.5f, 0, 0.46f}, (const float[]){0.5f, 1, 0.5f}, DOOR);
    test_shape_box(&shape, (const float[]){0.4f, 0.45f, 0.5f}, (const float[]){0.5f, 0.55f, 0.55f}, DOOR);
    const dm_mesh_desc mesh = test_shape_desc(&shape);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh};
    fuzz_expect(dm_context_create(NULL, &context) == DM_OK);
    fuzz_expect(dm_object_prepare(context, &desc, &object) == DM_OK);
}

/* ---- drags ---- */

/* A hand that pulls the handle out and to the side. */
static dm_ray pointer(int frame) {
    const float t = 0.02f * (float)frame;
    const dm_vec3 eye = {1.5f, 1.6f, 3};
    return (dm_ray){eye, {handle.x - t - eye.x, handle.y - eye.y, handle.z + 2 * t - eye.z}};
}

static void expect_finite_update(dm_drag drag, const dm_ray* ray) {
    dm_drag_state now = dm_drag_state_default();
    fuzz_expect(dm_drag_update(context, drag, ray, 1.0f / 60, &now) == DM_OK);
    fuzz_expect_state(&now);
}

/* All kinds of hands in turn. Whether the drag has rules is not known: so nothing that needs them. */
static void expect_finite_step(dm_drag drag, int frame) {
    dm_drag_state now = dm_drag_state_default();
    dm_drag_input input = dm_drag_input_default();
    input.hand = (dm_hand){.kind = frame % 6, .ray = pointer(frame), .point = handle, .amount = 0.2f};
    if (input.hand.kind <= DM_HAND_POINT)
        input.second = (dm_hand){.kind = DM_HAND_POINT, .point = handle, .grab_point = now.grab_point};
    input.flags = DM_INPUT_ASK;
    fuzz_expect(dm_drag_step(context, drag, &input, 1.0f / 60, &now) == DM_OK);
    const dm_result taken = dm_drag_take(context, drag, now.value, &now);
    fuzz_expect(taken == DM_OK || fabsf(now.value) > DMI_LARGEST);
    fuzz_expect_state(&now);
}

/* Drags on, saves, goes back, lets go, ends. meant: such as hosts have, so that what is saved can be restored. */
static void use(dm_drag drag, bool meant) {
    static uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
    dm_part_state end = dm_part_state_default();
    dm_ray ray;
    for (int frame = 0; frame < HELD_FRAMES; frame++) {
        ray = pointer(frame);
        expect_finite_update(drag, &ray);
        expect_finite_step(drag, frame);
    }
    fuzz_expect(dm_drag_save(context, drag, saved, sizeof saved) == DM_OK);
    const dm_result restored = dm_drag_restore(context, drag, saved, sizeof saved);
    fuzz_expect(restored == DM_OK || (!meant && restored == DM_ERROR_BAD_DATA));
    if (dm_drag_release(context, drag, NULL, NULL) == DM_OK)
        for (int frame = 0; frame < RELEASED_FRAMES; frame++) expect_finite_update(drag, NULL);
    fuzz_expect(dm_drag_end(context, drag, &end) == DM_OK);
    fuzz_expect_finite(&end.value, 1);
    fuzz_expect_pose(&end.pose);
    fuzz_expect_finite_joint(&end.joint);
}

static dm_drag begin(const dm_part_state* state, dm_vec3 scale) {
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = DOOR,
                               .object = object,
                               .grab_point = handle,
                               .state = state,
                               .scale = scale};
    dm_drag drag = 0;
    return dm_drag_begin(context, &desc, &drag) == DM_OK ? drag : 0;
}

/* A drag with every rule. */
static dm_drag begin_ruled(void) {
    const dm_drag_rules rules = test_every_rule();
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .part_id = DOOR, .object = object, .grab_point = handle, .rules = &rules};
    dm_drag drag = 0;
    fuzz_expect(dm_drag_begin(context, &desc, &drag) == DM_OK);
    return drag;
}

static void start(void) {
    prepare();
    const dm_drag drag = begin_ruled();
    for (int frame = 0; frame < HELD_FRAMES; frame++) {
        const dm_ray ray = pointer(frame);
        expect_finite_update(drag, &ray);
    }
    fuzz_expect(dm_drag_save(context, drag, good, sizeof good) == DM_OK);
    fuzz_expect(dm_drag_end(context, drag, NULL) == DM_OK);
}

/* ---- saved drags ---- */

static void restore(const uint8_t* saved, size_t size) {
    const dm_drag drag = begin(NULL, (dm_vec3){0, 0, 0});
    fuzz_expect(drag != 0);
    const dm_result result = dm_drag_restore(context, drag, saved, size);
    fuzz_expect(result == DM_OK || result == DM_ERROR_BAD_DATA || result == DM_ERROR_VERSION ||
                result == DM_ERROR_INVALID_ARGUMENT);
    use(drag, result != DM_OK); /* an error has left it as it was */
}

static void restore_changed(const uint8_t* data, size_t size) {
    const size_t whole = dm_drag_snapshot_size();
    uint8_t* saved = malloc(whole);
    if (saved == NULL) return;
    memcpy(saved, good, whole);
    for (; size >= 6; data += 6, size -= 6) {
        const size_t at = (size_t)(data[0] | data[1] << 8) * 4 % (whole - 3);
        memcpy(saved + at, data + 2, 4);
    }
    test_snapshot_sign(saved, whole);
    restore(saved, whole);
    free(saved);
}

/* ---- states ---- */

static void ask_joint(const dm_part_state* state, dm_vec3 scale) {
    const dm_joint* joint = &state->joint;
    dm_pose pose;
    dm_joint scaled = dm_joint_default();
    dm_joint_frame frame = dm_joint_frame_default();
    float numbers[3];
    if (dm_joint_pose(joint, state->value, &pose) == DM_OK) fuzz_expect_pose(&pose);
    if (dm_joint_value(joint, &state->pose, numbers, numbers + 1, numbers + 2) == DM_OK) fuzz_expect_finite(numbers, 3);
    if (dm_joint_scale(joint, scale, &scaled) == DM_OK && isfinite(joint->lower) && isfinite(joint->upper) &&
        isfinite(joint->type_confidence) && isfinite(joint->joint_confidence))
        fuzz_expect_finite_joint(&scaled);
    if (dm_joint_get_frame(joint, &frame) != DM_OK) return;
    const dm_vec3 vectors[4] = {frame.origin, frame.x, frame.y, frame.z};
    for (int i = 0; i < 4; i++) fuzz_expect(isfinite(vectors[i].x) && isfinite(vectors[i].y) && isfinite(vectors[i].z));
    fuzz_expect_finite(frame.rotation, 4);
    const float rest[3] = {frame.lower, frame.upper, frame.pitch};
    fuzz_expect_finite(rest, 3);
}

/* Copies the next bytes, zeros where there are no more. */
static void take(const uint8_t** data, size_t* size, void* out, size_t wanted) {
    const size_t count = *size < wanted ? *size : wanted;
    memset(out, 0, wanted);
    memcpy(out, *data, count);
    *data += count;
    *size -= count;
}

/* Numbers of a host that means them, whatever its units. */
static bool is_meant(const dm_part_state* state, dm_vec3 scale) {
    const dm_joint* j = &state->joint;
    const float numbers[] = {state->value, j->origin.x, j->origin.y, j->origin.z, j->pitch,
                             j->lower,     j->upper,    scale.x,     scale.y,     scale.z};
    bool meant = true;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) meant = meant && fabsf(numbers[i]) < 1e4f;
    for (int i = 0; i < 4; i++) meant = meant && fabsf(state->pose.dual[i]) < 1e4f;
    return meant;
}

static void use_state(const uint8_t* data, size_t size) {
    dm_part_state state = dm_part_state_default();
    dm_vec3 scale;
    take(&data, &size, (uint8_t*)&state + sizeof state.struct_size, sizeof state - sizeof state.struct_size);
    take(&data, &size, &scale, sizeof scale);
    if (state.joint.struct_size == 0) state.joint.struct_size = sizeof state.joint;
    const dm_drag drag = begin(&state, scale); /* the size of the joint in a state is data */
    if (drag != 0) use(drag, is_meant(&state, scale));
    state.joint.struct_size = sizeof state.joint;
    ask_joint(&state, scale);
    dm_object_set_joint(context, object, DOOR, &state.joint);
    dm_joint now = dm_joint_default();
    fuzz_expect(dm_object_get_joint(context, object, DOOR, &now) == DM_OK);
    fuzz_expect_joint(&now);
    const dm_drag other = begin(NULL, scale);
    if (other != 0) use(other, is_meant(&state, scale));
    fuzz_expect(dm_object_reset_joint(context, object, DOOR) == DM_OK);
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (context == NULL) start();
    if (size == 0) return 0;
    switch (data[0] % KINDS) {
    case BYTES:
        restore(data + 1, size - 1);
        break;
    case CHANGES:
        restore_changed(data + 1, size - 1);
        break;
    default:
        use_state(data + 1, size - 1);
    }
    return 0;
}
