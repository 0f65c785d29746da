/* The binary interface: sizes and offsets, values, and the order of the function table, against a file in golden/. That
 * file may only grow: a line that changes or moves breaks programs that were built before. After adding to the
 * interface:
 *
 *     build/release/tests/test_layout write */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "dragmesh/dragmesh.h"

#define GOLDEN "tests/abi/golden/lp64.txt" /* 64-bit pointers, as on every desktop and console of today */

typedef struct layout_line {
    const char *type, *field; /* field NULL: the struct itself */
    size_t size, offset;
} layout_line;

#define S(type)                                                                                                        \
    { #type, NULL, sizeof(type), 0 }
#define F(type, field)                                                                                                 \
    { #type, #field, sizeof(((type*)0)->field), offsetof(type, field) }
static const layout_line layout[] = {
    S(dm_vec3),
    F(dm_vec3, x),
    F(dm_vec3, y),
    F(dm_vec3, z),
    S(dm_pose),
    F(dm_pose, real),
    F(dm_pose, dual),
    S(dm_ray),
    F(dm_ray, origin),
    F(dm_ray, direction),
    S(dm_allocator),
    F(dm_allocator, user),
    F(dm_allocator, allocate),
    F(dm_allocator, release),
    S(dm_log),
    F(dm_log, user),
    F(dm_log, message),
    S(dm_jobs),
    F(dm_jobs, user),
    F(dm_jobs, parallel_for),
    S(dm_context_desc),
    F(dm_context_desc, struct_size),
    F(dm_context_desc, axes),
    F(dm_context_desc, unit_in_metres),
    F(dm_context_desc, custom_axes),
    F(dm_context_desc, allocator),
    F(dm_context_desc, log),
    F(dm_context_desc, jobs),
    F(dm_context_desc, picking),
    F(dm_context_desc, reserved),
    F(dm_context_desc, progress),
    F(dm_context_desc, progress_user),
    F(dm_context_desc, kept_bytes),
    S(dm_memory_info),
    F(dm_memory_info, struct_size),
    F(dm_memory_info, reserved),
    F(dm_memory_info, bytes),
    F(dm_memory_info, peak_bytes),
    F(dm_memory_info, allocations),
    F(dm_memory_info, pick_bytes),
    F(dm_memory_info, kept_bytes),
    S(dm_model_desc),
    F(dm_model_desc, struct_size),
    F(dm_model_desc, kinematics),
    F(dm_model_desc, kinematics_size),
    F(dm_model_desc, motion),
    F(dm_model_desc, motion_size),
    F(dm_model_desc, ranker),
    F(dm_model_desc, ranker_size),
    S(dm_mesh_desc),
    F(dm_mesh_desc, struct_size),
    F(dm_mesh_desc, position_stride),
    F(dm_mesh_desc, positions),
    F(dm_mesh_desc, vertex_count),
    F(dm_mesh_desc, position_bytes),
    F(dm_mesh_desc, indices),
    F(dm_mesh_desc, index_count),
    F(dm_mesh_desc, index_bytes),
    F(dm_mesh_desc, part_ids),
    F(dm_mesh_desc, part_id_bytes),
    F(dm_mesh_desc, part_id_stride),
    F(dm_mesh_desc, position_format),
    F(dm_mesh_desc, index_format),
    F(dm_mesh_desc, part_id_format),
    F(dm_mesh_desc, part_id_scope),
    F(dm_mesh_desc, reserved),
    S(dm_drag_hint),
    F(dm_drag_hint, point),
    F(dm_drag_hint, vector),
    S(dm_pivot),
    F(dm_pivot, origin),
    F(dm_pivot, axes),
    S(dm_part_desc),
    F(dm_part_desc, struct_size),
    F(dm_part_desc, id),
    F(dm_part_desc, parent),
    F(dm_part_desc, joint_type),
    F(dm_part_desc, drag),
    F(dm_part_desc, label),
    F(dm_part_desc, pivot),
    F(dm_part_desc, pivot_kind),
    F(dm_part_desc, reserved),
    S(dm_joint),
    F(dm_joint, struct_size),
    F(dm_joint, type),
    F(dm_joint, type_confidence),
    F(dm_joint, joint_confidence),
    F(dm_joint, pitch),
    F(dm_joint, axis),
    F(dm_joint, origin),
    F(dm_joint, lower),
    F(dm_joint, upper),
    F(dm_joint, source),
    F(dm_joint, evidence),
    F(dm_joint, closed),
    S(dm_joint_frame),
    F(dm_joint_frame, struct_size),
    F(dm_joint_frame, type),
    F(dm_joint_frame, origin),
    F(dm_joint_frame, x),
    F(dm_joint_frame, y),
    F(dm_joint_frame, z),
    F(dm_joint_frame, rotation),
    F(dm_joint_frame, lower),
    F(dm_joint_frame, upper),
    F(dm_joint_frame, limits),
    F(dm_joint_frame, pitch),
    S(dm_part_state),
    F(dm_part_state, struct_size),
    F(dm_part_state, value),
    F(dm_part_state, velocity),
    F(dm_part_state, status),
    F(dm_part_state, pose),
    F(dm_part_state, joint),
    S(dm_joint_end),
    F(dm_joint_end, value),
    F(dm_joint_end, pose),
    F(dm_joint_end, box_min),
    F(dm_joint_end, box_max),
    F(dm_joint_end, centre),
    S(dm_hypothesis),
    F(dm_hypothesis, struct_size),
    F(dm_hypothesis, reserved),
    F(dm_hypothesis, joint),
    F(dm_hypothesis, ends),
    S(dm_choice),
    F(dm_choice, struct_size),
    F(dm_choice, count),
    F(dm_choice, part),
    F(dm_choice, hypotheses),
    S(dm_object_desc),
    F(dm_object_desc, struct_size),
    F(dm_object_desc, flags),
    F(dm_object_desc, mesh),
    F(dm_object_desc, parts),
    F(dm_object_desc, part_count),
    F(dm_object_desc, reserved),
    F(dm_object_desc, model),
    F(dm_object_desc, seed),
    F(dm_object_desc, intent),
    F(dm_object_desc, intent_user),
    F(dm_object_desc, progress),
    F(dm_object_desc, progress_user),
    F(dm_object_desc, label),
    F(dm_object_desc, up),
    F(dm_object_desc, choose),
    F(dm_object_desc, choose_user),
    S(dm_object_info),
    F(dm_object_info, struct_size),
    F(dm_object_info, part_count),
    F(dm_object_info, vertex_count),
    F(dm_object_info, triangle_count),
    F(dm_object_info, box_min),
    F(dm_object_info, box_max),
    F(dm_object_info, size),
    F(dm_object_info, pickable),
    F(dm_object_info, degraded),
    F(dm_object_info, picking),
    S(dm_part_info),
    F(dm_part_info, struct_size),
    F(dm_part_info, id),
    F(dm_part_info, parent),
    F(dm_part_info, triangle_count),
    F(dm_part_info, box_min),
    F(dm_part_info, box_max),
    F(dm_part_info, centre),
    F(dm_part_info, area),
    S(dm_motion_desc),
    F(dm_motion_desc, struct_size),
    F(dm_motion_desc, part_id),
    F(dm_motion_desc, drag),
    F(dm_motion_desc, path),
    F(dm_motion_desc, path_count),
    F(dm_motion_desc, seed),
    S(dm_drag_feel),
    F(dm_drag_feel, smoothing_time),
    F(dm_drag_feel, soft_limit),
    F(dm_drag_feel, coast_time),
    F(dm_drag_feel, detent),
    F(dm_drag_feel, detent_pull),
    F(dm_drag_feel, return_time),
    S(dm_drag_desc),
    F(dm_drag_desc, struct_size),
    F(dm_drag_desc, part_id),
    F(dm_drag_desc, object),
    F(dm_drag_desc, grab_point),
    F(dm_drag_desc, start_value),
    F(dm_drag_desc, feel),
    F(dm_drag_desc, flags),
    F(dm_drag_desc, limit_give),
    F(dm_drag_desc, state),
    F(dm_drag_desc, scale),
    F(dm_drag_desc, reserved),
    F(dm_drag_desc, rules),
    S(dm_drag_rules),
    F(dm_drag_rules, struct_size),
    F(dm_drag_rules, flags),
    F(dm_drag_rules, snaps),
    F(dm_drag_rules, snap_count),
    F(dm_drag_rules, snap_reach),
    F(dm_drag_rules, open_share),
    F(dm_drag_rules, closed_share),
    F(dm_drag_rules, event_time),
    F(dm_drag_rules, max_speed),
    F(dm_drag_rules, max_acceleration),
    F(dm_drag_rules, lock_give),
    F(dm_drag_rules, latch_turn),
    F(dm_drag_rules, auto_close_share),
    F(dm_drag_rules, auto_close_time),
    F(dm_drag_rules, close_delay),
    F(dm_drag_rules, tip_share),
    F(dm_drag_rules, fall_time),
    F(dm_drag_rules, restitution),
    F(dm_drag_rules, break_distance),
    F(dm_drag_rules, drive_speed),
    F(dm_drag_rules, reserved),
    S(dm_link),
    F(dm_link, driver),
    F(dm_link, driven),
    F(dm_link, kind),
    F(dm_link, flags),
    F(dm_link, ratio),
    F(dm_link, offset),
    F(dm_link, from),
    S(dm_hand),
    F(dm_hand, kind),
    F(dm_hand, ray),
    F(dm_hand, point),
    F(dm_hand, amount),
    F(dm_hand, grab_point),
    S(dm_drag_input),
    F(dm_drag_input, struct_size),
    F(dm_drag_input, flags),
    F(dm_drag_input, hand),
    F(dm_drag_input, second),
    F(dm_drag_input, handles),
    F(dm_drag_input, lower),
    F(dm_drag_input, upper),
    S(dm_drag_state),
    F(dm_drag_state, struct_size),
    F(dm_drag_state, pose),
    F(dm_drag_state, grab_point),
    F(dm_drag_state, value),
    F(dm_drag_state, target),
    F(dm_drag_state, velocity),
    F(dm_drag_state, at_limit),
    F(dm_drag_state, phase),
    F(dm_drag_state, changes),
    F(dm_drag_state, events),
    F(dm_drag_state, detents),
    F(dm_drag_state, impact),
    F(dm_drag_state, status),
    F(dm_drag_state, joint_confidence),
    F(dm_drag_state, joint_basis),
    F(dm_drag_state, open_share),
    S(dm_release_desc),
    F(dm_release_desc, struct_size),
    F(dm_release_desc, intent),
    F(dm_release_desc, duration),
    F(dm_release_desc, seed),
    F(dm_release_desc, flags),
    F(dm_release_desc, away_from),
    S(dm_release_plan),
    F(dm_release_plan, struct_size),
    F(dm_release_plan, intent),
    F(dm_release_plan, start_value),
    F(dm_release_plan, end_value),
    F(dm_release_plan, duration),
    F(dm_release_plan, from_network),
    S(dm_camera),
    F(dm_camera, struct_size),
    F(dm_camera, fov_y),
    F(dm_camera, eye),
    F(dm_camera, forward),
    F(dm_camera, up),
    F(dm_camera, viewport_width),
    F(dm_camera, viewport_height),
    F(dm_camera, ortho_height),
    S(dm_scene_desc),
    F(dm_scene_desc, struct_size),
    F(dm_scene_desc, reserved),
    S(dm_hit),
    F(dm_hit, struct_size),
    F(dm_hit, instance),
    F(dm_hit, object),
    F(dm_hit, part_id),
    F(dm_hit, triangle),
    F(dm_hit, distance),
    F(dm_hit, u),
    F(dm_hit, v),
    F(dm_hit, point),
    F(dm_hit, normal),
    F(dm_hit, object_point),
    S(dm_asset_clip),
    F(dm_asset_clip, name),
    F(dm_asset_clip, times),
    F(dm_asset_clip, poses),
    F(dm_asset_clip, key_count),
    F(dm_asset_clip, flags),
    S(dm_asset_node),
    F(dm_asset_node, struct_size),
    F(dm_asset_node, flags),
    F(dm_asset_node, parent),
    F(dm_asset_node, follows),
    F(dm_asset_node, name),
    F(dm_asset_node, mesh_name),
    F(dm_asset_node, mesh),
    F(dm_asset_node, transform),
    F(dm_asset_node, pivot),
    F(dm_asset_node, clips),
    F(dm_asset_node, clip_count),
    F(dm_asset_node, reserved),
    F(dm_asset_node, joint),
    S(dm_asset_desc),
    F(dm_asset_desc, struct_size),
    F(dm_asset_desc, flags),
    F(dm_asset_desc, nodes),
    F(dm_asset_desc, label),
    F(dm_asset_desc, node_count),
    F(dm_asset_desc, min_moves),
    F(dm_asset_desc, model),
    F(dm_asset_desc, seed),
    F(dm_asset_desc, progress),
    F(dm_asset_desc, progress_user),
    F(dm_asset_desc, up),
    F(dm_asset_desc, reserved),
    S(dm_asset_info),
    F(dm_asset_info, struct_size),
    F(dm_asset_info, node_count),
    F(dm_asset_info, part_count),
    F(dm_asset_info, moving_count),
    F(dm_asset_info, triangle_count),
    F(dm_asset_info, degraded),
    F(dm_asset_info, warnings),
    S(dm_asset_part),
    F(dm_asset_part, struct_size),
    F(dm_asset_part, parent),
    F(dm_asset_part, part_id),
    F(dm_asset_part, state),
    F(dm_asset_part, basis),
    F(dm_asset_part, moves),
    F(dm_asset_part, node_count),
    F(dm_asset_part, triangle_count),
    F(dm_asset_part, duration),
    F(dm_asset_part, reserved),
    F(dm_asset_part, box_min),
    F(dm_asset_part, box_max),
};

typedef struct value_line {
    const char* name;
    int value;
} value_line;

#define V(name)                                                                                                        \
    { #name, name }
static const value_line values[] = {V(DM_OK),
                                    V(DM_ERROR_INVALID_ARGUMENT),
                                    V(DM_ERROR_STRUCT_SIZE),
                                    V(DM_ERROR_STALE_HANDLE),
                                    V(DM_ERROR_OUT_OF_MEMORY),
                                    V(DM_ERROR_NOT_FINITE),
                                    V(DM_ERROR_INDEX_OUT_OF_RANGE),
                                    V(DM_ERROR_EMPTY_MASK),
                                    V(DM_ERROR_FULL_MASK),
                                    V(DM_ERROR_DEGENERATE_MESH),
                                    V(DM_ERROR_ZERO_DRAG),
                                    V(DM_ERROR_DRAG_OFF_PART),
                                    V(DM_ERROR_BAD_DATA),
                                    V(DM_ERROR_WRONG_MODEL),
                                    V(DM_ERROR_VERSION),
                                    V(DM_ERROR_CANCELLED),
                                    V(DM_ERROR_NO_MODEL),
                                    V(DM_ERROR_TOO_LARGE),
                                    V(DM_ERROR_BUFFER_TOO_SMALL),
                                    V(DM_ERROR_NOT_FOUND),
                                    V(DM_ERROR_UNSUPPORTED),
                                    V(DM_ERROR_INTERNAL),
                                    V(DM_LOG_ERROR),
                                    V(DM_LOG_WARNING),
                                    V(DM_LOG_INFO),
                                    V(DM_AXES_GLTF),
                                    V(DM_AXES_UNITY),
                                    V(DM_AXES_UNREAL),
                                    V(DM_AXES_BLENDER),
                                    V(DM_AXES_CUSTOM),
                                    V(DM_PICK_AUTO),
                                    V(DM_PICK_EMBREE),
                                    V(DM_PICK_PORTABLE),
                                    V(DM_PICK_NONE),
                                    V(DM_JOINT_UNKNOWN),
                                    V(DM_JOINT_REVOLUTE),
                                    V(DM_JOINT_PRISMATIC),
                                    V(DM_JOINT_SCREW),
                                    V(DM_JOINT_CONTINUOUS),
                                    V(DM_JOINT_FIXED),
                                    V(DM_FLOAT32),
                                    V(DM_FLOAT64),
                                    V(DM_UINT32),
                                    V(DM_UINT16),
                                    V(DM_UINT8),
                                    V(DM_INT32),
                                    V(DM_PER_VERTEX),
                                    V(DM_PER_FACE),
                                    V(DM_JOINT_FROM_NETWORK),
                                    V(DM_JOINT_FROM_GEOMETRY),
                                    V(DM_JOINT_FROM_HOST),
                                    V(DM_JOINT_CHOSEN),
                                    V(DM_CHOICE_KEEP),
                                    V(DM_LIMIT_LOWER),
                                    V(DM_LIMIT_UPPER),
                                    V(DM_PREPARE_WITHOUT_PICKING),
                                    V(DM_PREPARE_NETWORK_ALONE),
                                    V(DM_PREPARE_MESH_INCOMPLETE),
                                    V(DM_DEGRADED_NO_KINEMATICS),
                                    V(DM_DEGRADED_NO_RANKER),
                                    V(DM_DEGRADED_NO_MOTION),
                                    V(DM_DEGRADED_NO_BODY),
                                    V(DM_DEGRADED_HINT),
                                    V(DM_DEGRADED_MESH),
                                    V(DM_DRAG_KEEP_JOINT),
                                    V(DM_DRAG_WITHOUT_POINT),
                                    V(DM_HAND_NONE),
                                    V(DM_HAND_RAY),
                                    V(DM_HAND_POINT),
                                    V(DM_HAND_RATE),
                                    V(DM_HAND_STEP),
                                    V(DM_HAND_VALUE),
                                    V(DM_INPUT_LOCKED),
                                    V(DM_INPUT_ASK),
                                    V(DM_INPUT_BOUNDS),
                                    V(DM_RULE_LOCKED),
                                    V(DM_RULE_LATCH),
                                    V(DM_LINK_MOVES),
                                    V(DM_LINK_FREES),
                                    V(DM_LINK_HOLDS),
                                    V(DM_LINK_BOTH_WAYS),
                                    V(DM_EVENT_LIMIT_LOWER),
                                    V(DM_EVENT_LIMIT_UPPER),
                                    V(DM_EVENT_LEFT_REST),
                                    V(DM_EVENT_REACHED_REST),
                                    V(DM_EVENT_OPENED),
                                    V(DM_EVENT_CLOSED),
                                    V(DM_EVENT_DETENT),
                                    V(DM_EVENT_JOINT),
                                    V(DM_EVENT_BLOCKED),
                                    V(DM_EVENT_FREED),
                                    V(DM_EVENT_LATCHED),
                                    V(DM_EVENT_UNLATCHED),
                                    V(DM_EVENT_LOCKED),
                                    V(DM_EVENT_LET_GO),
                                    V(DM_STATUS_LATCHED),
                                    V(DM_STATUS_LOCKED),
                                    V(DM_STATUS_BLOCKED),
                                    V(DM_STATUS_OPEN),
                                    V(DM_PIVOT_UNKNOWN),
                                    V(DM_PIVOT_DEFAULT),
                                    V(DM_PIVOT_SET),
                                    V(DM_BASIS_PREPARED),
                                    V(DM_BASIS_PULL),
                                    V(DM_BASIS_HOST),
                                    V(DM_BASIS_CHOSEN),
                                    V(DM_DRAG_HELD),
                                    V(DM_DRAG_RELEASED),
                                    V(DM_DRAG_AT_REST),
                                    V(DM_RELEASE_BY_RULE),
                                    V(DM_RELEASE_AWAY_FROM),
                                    V(DM_GO_AUTO),
                                    V(DM_GO_STAY),
                                    V(DM_GO_OPEN),
                                    V(DM_GO_CLOSE),
                                    V(DM_GO_REPLAY),
                                    V(DM_GO_FREEZE),
                                    V(DM_GO_TOGGLE),
                                    V(DM_INTENT_AUTO),
                                    V(DM_INTENT_STAY),
                                    V(DM_INTENT_OPEN),
                                    V(DM_INTENT_CLOSE),
                                    V(DM_INTENT_REPLAY),
                                    V(DM_INTENT_FREEZE),
                                    V(DM_INTENT_TOGGLE),
                                    V(DM_MOTION_FRAMES),
                                    V(DM_MAX_HYPOTHESES),
                                    V(DM_MAX_PARTS),
                                    V(DM_MAX_LABEL),
                                    V(DM_MAX_ELEMENTS),
                                    V(DM_MAX_SNAPS),
                                    V(DM_MAX_LINKS),
                                    V(DM_DRAG_SNAPSHOT_MAX),
                                    V(DM_MAX_ASSET_NODES),
                                    V(DM_ASSET_NODE_FOLLOWS),
                                    V(DM_ASSET_NODE_NO_PIVOT),
                                    V(DM_CLIP_NOT_RIGID),
                                    V(DM_ASSET_WITHOUT_CLIPS),
                                    V(DM_ASSET_WITHOUT_NAMES),
                                    V(DM_ASSET_CLIP_LEFT_OUT),
                                    V(DM_ASSET_STAYS),
                                    V(DM_ASSET_MOVES),
                                    V(DM_ASSET_FREE),
                                    V(DM_ASSET_INFERRED),
                                    V(DM_ASSET_FROM_FILE),
                                    V(DM_ASSET_FROM_CLIP)};

#define T(result, name, arguments) #name " " #result " " #arguments,
static const char* const table[] = {DM_CORE_FUNCTIONS(T)};

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* Without the spaces round stars, on which formatters of the header disagree. */
static void write_entry(FILE* out, size_t index, const char* entry) {
    fprintf(out, "dm.core/1 %zu ", index);
    for (const char* c = entry; *c; c++) {
        if (*c != ' ' || (c[1] != '*' && c[-1] != '*')) fputc(*c, out);
    }
    fputc('\n', out);
}

static void write_layout(FILE* out) {
    for (size_t i = 0; i < COUNT(table); i++) write_entry(out, i, table[i]);
    for (size_t i = 0; i < COUNT(layout); i++) {
        const layout_line* line = &layout[i];
        if (!line->field)
            fprintf(out, "%s %zu bytes\n", line->type, line->size);
        else
            fprintf(out, "%s.%s at %zu, %zu bytes\n", line->type, line->field, line->offset, line->size);
    }
    for (size_t i = 0; i < COUNT(values); i++) fprintf(out, "%s = %d\n", values[i].name, values[i].value);
}

static void test_layout_is_that_of_the_golden_file(void** state) {
    (void)state;
    FILE *golden = fopen(GOLDEN, "r"), *now = tmpfile();
    if (!golden) fail_msg("no %s: run the tests from the repository's root", GOLDEN);
    assert_non_null(now);
    write_layout(now);
    rewind(now);
    char was[512], is[512];
    while (fgets(was, sizeof was, golden)) {
        if (!fgets(is, sizeof is, now)) is[0] = 0;
        assert_string_equal(is, was);
    }
    assert_null(fgets(is, sizeof is, now)); /* something new: write it down */
    fclose(golden);
    fclose(now);
}

/* Bytes that belong to no field: inside a struct they are harmless, but after the last field of a struct that may grow
 * they would become part of a new field, with an old caller's garbage in them. */
static void test_growing_structs_end_with_a_field(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(layout); i++) {
        if (layout[i].field) continue;
        size_t last = i;
        while (last + 1 < COUNT(layout) && layout[last + 1].field) last++;
        if (strcmp(layout[i + 1].field, "struct_size") != 0) continue;
        if (layout[last].offset + layout[last].size != layout[i].size) fail_msg("%s ends with padding", layout[i].type);
    }
}

/* Checks the fields of a struct behind struct_size; bytes that belong to no field may hold anything. */
static void assert_other_fields_are_zero(const char* type, const void* value) {
    size_t i = 0;
    while (i < COUNT(layout) && (layout[i].field || strcmp(layout[i].type, type) != 0)) i++;
    assert_true(i + 1 < COUNT(layout)); /* or it is not in the table */
    for (i += 2; i < COUNT(layout) && layout[i].field; i++) {
        for (size_t b = 0; b < layout[i].size; b++)
            if (((const uint8_t*)value)[layout[i].offset + b] != 0) fail_msg("%s.%s", type, layout[i].field);
    }
}

/* Initialisers set the size and nothing else. */
static void test_defaults_are_zeros_with_their_size(void** state) {
    (void)state;
#define CHECK_DEFAULT(type)                                                                                            \
    do {                                                                                                               \
        const type value = type##_default();                                                                           \
        assert_int_equal(value.struct_size, sizeof value);                                                             \
        assert_other_fields_are_zero(#type, &value);                                                                   \
    } while (0);
    DM_SIZED_STRUCTS(CHECK_DEFAULT)
}

static void test_table_holds_the_linked_functions(void** state) {
    (void)state;
    const dm_core_1* core = dm_get_interface("dm.core/1");
    assert_non_null(core);
    assert_int_equal(core->struct_size, sizeof(dm_core_1));
#define SAME(result, name, arguments) assert_true(core->name == dm_##name);
    DM_CORE_FUNCTIONS(SAME)
    assert_null(dm_get_interface("dm.core/2"));
    assert_null(dm_get_interface(""));
    assert_null(dm_get_interface(NULL));
}

int main(int argc, char** argv) {
    if (argc == 2 && strcmp(argv[1], "write") == 0) {
        FILE* golden = fopen(GOLDEN, "w");
        if (golden) write_layout(golden);
        return golden ? fclose(golden) : 1;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_layout_is_that_of_the_golden_file),
        cmocka_unit_test(test_growing_structs_end_with_a_field),
        cmocka_unit_test(test_defaults_are_zeros_with_their_size),
        cmocka_unit_test(test_table_holds_the_linked_functions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
