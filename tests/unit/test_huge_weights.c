/* Weights whose numbers are finite and overflow as soon as they are used: joints, motions and drags stay finite, or a
 * call says what is wrong. */
#include <math.h>
#include <string.h>

#include "cjson/cJSON.h"
#include "test_world.h"

enum { LENGTH_BYTES = 8 };

typedef struct bytes {
    uint8_t* data;
    size_t size;
} bytes;

/* The file with all tensors called NAME.weight filled: 32-bit floats `value`, every other one negative. */
static bytes filled(const char* path, float value) {
    size_t size = 0;
    uint8_t* file = test_read_file(path, &size);
    uint64_t length = 0, at = 0;
    memcpy(&length, file, sizeof length);
    const uint8_t* tensors = file + LENGTH_BYTES + length;
    cJSON* header = cJSON_ParseWithLength((const char*)file + LENGTH_BYTES, (size_t)length);
    uint8_t* data = calloc(2, size);
    assert_true(header != NULL && data != NULL);
    cJSON* tensor;
    cJSON_ArrayForEach(tensor, header) {
        if (strcmp(tensor->string, "__metadata__") == 0) continue;
        const cJSON* old = cJSON_GetObjectItem(tensor, "data_offsets");
        const uint64_t from = (uint64_t)cJSON_GetArrayItem(old, 0)->valuedouble;
        uint64_t room = (uint64_t)cJSON_GetArrayItem(old, 1)->valuedouble - from;
        const char* end = strrchr(tensor->string, '.');
        if (end != NULL && strcmp(end, ".weight") == 0) {
            uint64_t count = 1;
            const cJSON* side;
            cJSON_ArrayForEach(side, cJSON_GetObjectItem(tensor, "shape")) count *= (uint64_t)side->valuedouble;
            for (uint64_t i = 0; i < count; i++)
                memcpy(data + at + i * sizeof value, &(float){i % 2 ? -value : value}, sizeof value);
            room = count * sizeof value;
            cJSON_ReplaceItemInObject(tensor, "dtype", cJSON_CreateString("F32"));
        } else {
            memcpy(data + at, tensors + from, (size_t)room);
        }
        const double offsets[2] = {(double)at, (double)(at + room)};
        at += room;
        cJSON_ReplaceItemInObject(tensor, "data_offsets", cJSON_CreateDoubleArray(offsets, 2));
    }
    char* text = cJSON_PrintUnformatted(header);
    length = strlen(text);
    bytes out = {malloc(LENGTH_BYTES + (size_t)(length + at)), LENGTH_BYTES + (size_t)(length + at)};
    assert_non_null(out.data);
    memcpy(out.data, &length, sizeof length);
    memcpy(out.data + LENGTH_BYTES, text, (size_t)length);
    memcpy(out.data + LENGTH_BYTES + length, data, (size_t)at);
    free(data);
    free(text);
    cJSON_Delete(header);
    free(file);
    return out;
}

static void assert_finite(const float* values, int count) {
    for (int i = 0; i < count; i++) assert_true(isfinite(values[i]));
}

static void assert_joint(const dm_joint* joint) {
    const float numbers[] = {joint->axis.x,          joint->axis.y,           joint->axis.z, joint->origin.x,
                             joint->origin.y,        joint->origin.z,         joint->lower,  joint->upper,
                             joint->type_confidence, joint->joint_confidence, joint->pitch};
    assert_finite(numbers, sizeof numbers / sizeof *numbers);
}

static void check_motion(dm_context* context, dm_object object) {
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR, .drag = test_pull(), .seed = 3};
    dm_motion motion;
    dm_pose poses[DM_MOTION_FRAMES];
    float values[DM_MOTION_FRAMES];
    if (dm_motion_generate(context, object, &desc, &motion) != DM_OK) return;
    assert_int_equal(dm_motion_get_frames(context, motion, poses, values), DM_OK);
    for (int i = 0; i < DM_MOTION_FRAMES; i++) assert_finite(poses[i].real, 4), assert_finite(poses[i].dual, 4);
    assert_finite(values, DM_MOTION_FRAMES);
}

static void check_release(dm_context* context, dm_object object) {
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .object = object, .part_id = TEST_DOOR, .grab_point = test_pull().point};
    dm_drag drag;
    dm_drag_state state = {.struct_size = sizeof state};
    assert_int_equal(dm_drag_begin(context, &desc, &drag), DM_OK);
    for (int frame = 0; frame < 30; frame++) {
        const dm_ray ray = test_ray_to((dm_vec3){0.9f - 0.01f * (float)frame, 0.5f, 1.1f + 0.02f * (float)frame});
        if (frame == 15) assert_int_equal(dm_drag_release(context, drag, NULL, NULL), DM_OK);
        assert_int_equal(dm_drag_update(context, drag, frame < 15 ? &ray : NULL, 1.0f / 60, &state), DM_OK);
        assert_finite(state.pose.real, 4), assert_finite(state.pose.dual, 4), assert_finite(&state.value, 1);
    }
    assert_int_equal(dm_drag_end(context, drag, NULL), DM_OK);
}

/* One of the three files is filled, the others are as shipped. */
static void check(int which, float value) {
    static const char* const paths[3] = {"sdk/models/kpp_net.safetensors", "sdk/models/ranker.safetensors",
                                         "sdk/models/dq_vae.safetensors"};
    bytes files[3];
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    for (int i = 0; i < 3; i++) {
        if (i == which)
            files[i] = filled(paths[i], value);
        else
            files[i].data = test_read_file(paths[i], &files[i].size);
    }
    const dm_model_desc desc = {.struct_size = sizeof desc,
                                .kinematics = files[0].data,
                                .kinematics_size = files[0].size,
                                .ranker = files[1].data,
                                .ranker_size = files[1].size,
                                .motion = files[2].data,
                                .motion_size = files[2].size};
    dm_object object = 0;
    assert_int_equal(dm_model_load(w.context, &desc, &w.model), DM_OK);
    if (test_world_prepare(&w, 0, &object) == DM_OK) {
        for (uint32_t part = TEST_DOOR; part <= TEST_HANDLE; part++) {
            dm_joint joints[DM_MAX_HYPOTHESES] = {{.struct_size = sizeof *joints}};
            uint32_t count = 0;
            assert_int_equal(dm_object_get_hypotheses(w.context, object, part, NULL, joints, DM_MAX_HYPOTHESES, &count),
                             DM_OK);
            for (uint32_t i = 0; i < count; i++) assert_joint(&joints[i]);
        }
        check_motion(w.context, object);
        check_release(w.context, object);
    }
    for (int i = 0; i < 3; i++) free(files[i].data);
    test_world_close(&w);
}

static void test_all_answers_stay_finite(void** state) {
    (void)state;
    static const float values[] = {1e4f, 1e12f, 1e19f, 1e30f, 3e38f};
    for (int which = 0; which < 3; which++) {
        for (size_t i = 0; i < sizeof values / sizeof *values; i++) check(which, values[i]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_all_answers_stay_finite)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
