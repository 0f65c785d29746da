/* Fuzz target: weights through dm_model_load, and what is computed with them. An input is a byte that names the model,
 * a kind byte, and then: bytes     a file of weights as it is; changes   of the shipped file: 4 bytes of place (odd:
 * anywhere, even: in its header), 4 of content, again and again.
 *
 * Whatever the weights: an error, or joints and motions of finite numbers. Nothing is lost. Run from the root of the
 * repository, where the shipped files are. */
#include "../include/test_shapes.h"
#include "use_object.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

enum { RANKER, MOTION, KINEMATICS, MODELS }; /* KINEMATICS takes seconds, and so comes seldom */
enum { BYTES, CHANGES, KINDS };
enum { DOOR = 1, CHANGE = 8, SAMPLES = 4 };
enum { LENGTH_SIZE = 8 }; /* bytes before the header that say how long it is */

typedef struct weights {
    uint8_t* bytes;
    size_t size, header;
} weights;

static weights shipped[MODELS];

static weights read_weights(const char* path) {
    FILE* file = fopen(path, "rb");
    weights out = {NULL, 0, 0};
    fuzz_expect(file != NULL && fseek(file, 0, SEEK_END) == 0);
    out.size = (size_t)ftell(file);
    out.bytes = malloc(out.size);
    rewind(file);
    fuzz_expect(out.bytes != NULL && fread(out.bytes, 1, out.size, file) == out.size);
    fclose(file);
    for (int i = 0; i < 4; i++) out.header |= (size_t)out.bytes[i] << 8 * i;
    out.header += LENGTH_SIZE;
    return out;
}

static void start(void) {
    open_contexts();
    shipped[RANKER] = read_weights("sdk/models/ranker.safetensors");
    shipped[MOTION] = read_weights("sdk/models/dq_vae.safetensors");
    shipped[KINEMATICS] = read_weights("sdk/models/kpp_net.safetensors");
}

/* ---- an input ---- */

static weights copy_bytes(const fuzz_input* in) {
    weights out = {malloc(in->size > 0 ? in->size : 1), in->size, 0};
    fuzz_expect(out.bytes != NULL);
    if (in->size > 0) memcpy(out.bytes, in->data, in->size);
    return out;
}

static weights change_shipped(const weights* original, fuzz_input* in) {
    weights out = {malloc(original->size), original->size, 0};
    fuzz_expect(out.bytes != NULL);
    memcpy(out.bytes, original->bytes, out.size);
    while (in->size >= CHANGE) {
        const uint32_t place = fuzz_word(in), content = fuzz_word(in);
        const size_t at = place / 2 % ((place % 2 ? out.size : original->header) - sizeof content);
        memcpy(out.bytes + at, &content, sizeof content);
    }
    return out;
}

/* ---- what is computed ---- */

static void generate(dm_context* context, dm_object object, const dm_part_info* part) {
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = part->id, .drag = {part->centre, {0, 0, 1}}};
    dm_motion motion;
    const dm_result result = dm_motion_generate(context, object, &desc, &motion);
    fuzz_expect_result(result);
    if (result != DM_OK) return;
    for (int i = 0; i <= SAMPLES; i++) {
        dm_pose pose;
        float value;
        fuzz_expect(dm_motion_sample(context, motion, (float)i / SAMPLES, &pose, &value) == DM_OK);
        fuzz_expect_pose(&pose);
        fuzz_expect(isfinite(value));
    }
    fuzz_expect(dm_motion_destroy(context, motion) == DM_OK);
}

static void use_model(dm_context* context, dm_model model) {
    static test_shape shape;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){1, 1, 0.5f}, 0);
    test_shape_box(&shape, (const float[]){0, 0, 0.52f}, (const float[]){1, 1, 0.56f}, DOOR);
    const dm_mesh_desc mesh = test_shape_desc(&shape);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .model = model};
    dm_object object;
    const dm_result result = dm_object_prepare(context, &desc, &object);
    fuzz_expect_result(result);
    if (result != DM_OK) return;
    const dm_part_info part = use_part(context, object, 0);
    use_object(context, object);
    generate(context, object, &part);
    fuzz_expect(dm_object_destroy(context, object) == DM_OK);
}

static dm_model_desc describe(uint32_t which, const weights* w) {
    dm_model_desc desc = {.struct_size = sizeof desc};
    if (which == RANKER) desc.ranker = w->bytes, desc.ranker_size = w->size;
    if (which == MOTION) desc.motion = w->bytes, desc.motion_size = w->size;
    if (which == KINEMATICS) desc.kinematics = w->bytes, desc.kinematics_size = w->size;
    return desc;
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (contexts[0] == NULL) start();
    fuzz_input in = {data, size};
    const uint32_t kind = fuzz_below(&in, KINDS), way = fuzz_below(&in, 32);
    const uint32_t which = way == 0 ? KINEMATICS : way < 12 ? MOTION : RANKER;
    weights w = kind == CHANGES ? change_shipped(&shipped[which], &in) : copy_bytes(&in);
    const dm_model_desc desc = describe(which, &w);
    const bool none = w.size == 0;
    dm_model model;
    const dm_result result = dm_model_load(contexts[0], &desc, &model);
    free(w.bytes);
    fuzz_expect(result == DM_OK || result == DM_ERROR_BAD_DATA || result == DM_ERROR_WRONG_MODEL ||
                result == DM_ERROR_VERSION || result == DM_ERROR_NOT_FINITE ||
                (none && result == DM_ERROR_INVALID_ARGUMENT));
    if (result == DM_OK) {
        use_model(contexts[0], model);
        fuzz_expect(dm_model_unload(contexts[0], model) == DM_OK);
    }
    fuzz_expect(hosts[0].live <= CONTEXT_BLOCKS);
    return 0;
}
