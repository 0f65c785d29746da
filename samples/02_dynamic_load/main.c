/* Hello, drag without linking: the library is loaded at run time and called through its function table. */
#include <stdio.h>

#include "dragmesh/dragmesh_loader.h"

static const dm_core_1* dm;

enum { BOXES = 7, FIRST_BOX_OF_DOOR = 5, DOOR = 1, VERTICES = BOXES * 8, CORNERS = BOXES * 36 };
static float positions[VERTICES][3];
static uint16_t indices[CORNERS];
static uint8_t parts[BOXES * 8]; /* of each vertex; 0 is the body */
static const float boxes[BOXES][6] = {
    {0.00f, 0.00f, 0.000f, 0.60f, 0.02f, 0.40f}, /* bottom, from x, y, z to x, y, z, in metres */
    {0.00f, 0.78f, 0.000f, 0.60f, 0.80f, 0.40f}, /* top */
    {0.00f, 0.00f, 0.000f, 0.02f, 0.80f, 0.40f}, /* left */
    {0.58f, 0.00f, 0.000f, 0.60f, 0.80f, 0.40f}, /* right */
    {0.00f, 0.00f, 0.000f, 0.60f, 0.80f, 0.02f}, /* back */
    {0.00f, 0.00f, 0.402f, 0.60f, 0.80f, 0.42f}, /* door, with its hinge on the left */
    {0.54f, 0.30f, 0.420f, 0.56f, 0.50f, 0.45f}, /* its handle, on the right */
};

static void make_cabinet(void) {
    static const uint8_t corners[36] = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                        2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
    for (int v = 0; v < BOXES * 8; v++) {
        for (int k = 0; k < 3; k++) positions[v][k] = boxes[v / 8][v >> k & 1 ? k + 3 : k];
        parts[v] = v / 8 >= FIRST_BOX_OF_DOOR ? DOOR : 0;
    }
    for (int i = 0; i < CORNERS; i++) indices[i] = (uint16_t)(i / 36 * 8 + corners[i % 36]);
}

static size_t read_file(const char* folder, const char* name, void* out, size_t capacity) {
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE* file = fopen(path, "rb");
    size_t size = file != NULL ? fread(out, 1, capacity, file) : 0;
    if (file != NULL) fclose(file);
    return size;
}

static void DM_CALL print(void* user, int32_t level, dm_result code, const char* text) {
    fprintf(user, "%s (level %d): %s\n", dm->result_string(code), level, text);
}

int main(int argc, char** argv) {
    static char kpp[4 << 20], vae[4 << 20], ranker[4 << 20];
    const char* file = argc > 1 ? argv[1] : "libdragmesh.so";
    const char* folder = argc > 2 ? argv[2] : "sdk/models";
    dm_library library;
    dm = dm_library_open(&library, file);
    if (dm == NULL) return fprintf(stderr, "%s: %s\n", file, library.error), 1;
    const uint32_t odd = dm->version() & 1, version = dm->version() + odd; /* odd: in development (DM_VERSION) */
    printf("dragmesh %u.%u.%u%s\n", version >> 22, version >> 12 & 0x3ff, version & 0xfff, odd ? "-dev" : "");
    dm_context* context;
    dm_model model;
    dm_context_desc host = {.struct_size = sizeof host, .log = {stderr, print}};
    dm_model_desc weights = {.struct_size = sizeof weights, .kinematics = kpp, .motion = vae, .ranker = ranker};
    weights.kinematics_size = read_file(folder, "kpp_net.safetensors", kpp, sizeof kpp);
    weights.motion_size = read_file(folder, "dq_vae.safetensors", vae, sizeof vae);
    weights.ranker_size = read_file(folder, "ranker.safetensors", ranker, sizeof ranker);
    if (dm->context_create(&host, &context) != DM_OK || dm->model_load(context, &weights, &model) != DM_OK) return 1;

    make_cabinet();
    dm_mesh_desc mesh = {.struct_size = sizeof mesh, .positions = positions, .vertex_count = VERTICES};
    mesh.indices = indices, mesh.index_count = CORNERS, mesh.index_format = DM_UINT16;
    mesh.part_ids = parts, mesh.part_id_bytes = sizeof parts, mesh.part_id_format = DM_UINT8;
    dm_object cabinet;
    dm_joint j = {.struct_size = sizeof j};
    dm_object_desc object = {.struct_size = sizeof object, .mesh = &mesh, .model = model};
    if (dm->object_prepare(context, &object, &cabinet) != DM_OK) return 1;
    dm->object_get_joint(context, cabinet, DOOR, &j);
    printf("%s: axis (%.2f, %.2f, %.2f), origin (%.2f, %.2f, %.2f), %.2f to %.2f, confidence %.2f\n",
           j.type == DM_JOINT_REVOLUTE ? "hinge" : "not a hinge", j.axis.x, j.axis.y, j.axis.z, j.origin.x, j.origin.y,
           j.origin.z, j.lower, j.upper, j.joint_confidence);

    const dm_vec3 handle = {0.55f, 0.4f, 0.45f}; /* someone pulls it towards themselves */
    dm_motion motion;
    dm_motion_desc pull = {.struct_size = sizeof pull, .part_id = DOOR, .drag = {handle, {0, 0, 0.1f}}};
    if (dm->motion_generate(context, cabinet, &pull, &motion) != DM_OK) return 1;
    for (int quarter = 0; quarter <= 4; quarter++) {
        const float t = 0.25f * (float)quarter;
        float value;
        dm_pose pose;
        float at[3] = {handle.x, handle.y, handle.z};
        dm->motion_sample(context, motion, t, &pose, &value);
        dm->pose_apply_points(&pose, at, 0, at, 0, 1);
        printf("t %.2f  value %6.3f  handle (%6.3f, %6.3f, %6.3f)\n", t, value, at[0], at[1], at[2]);
    }
    dm->context_destroy(context); /* and with it the model, the cabinet and the motion */
    dm_library_close(&library);
    return 0;
}
