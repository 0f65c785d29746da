/* A host that reads a prepared object: host OBJECT.dmo MODELS. Drags its first part along a curve of rays and prints
 * the bits of every state; then generates a motion of it and prints the key poses as numbers. */
#include <string.h>

#include "dragmesh/dragmesh.h"
#include "weights.h"

enum { PART = 2, FRAMES = 120 }; /* the first part that moves: 1 is the body of a generated object */

static void must(dm_result result, const char* what) {
    if (result == DM_OK) return;
    fprintf(stderr, "host: %s: %s\n", what, dm_result_string(result));
    exit(1);
}

static uint32_t bits_of(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* From an eye in front and above, past the grabbed point in a wide arc. */
static dm_ray ray_at(int frame, dm_vec3 grab) {
    const float away = 0.02f * (float)frame, dip = 0.0001f * (float)(frame * frame);
    const dm_vec3 eye = {grab.x + 0.3f, grab.y + 1.2f, grab.z + 2.5f};
    const dm_vec3 seen = {grab.x - 0.5f * away, grab.y - dip, grab.z + away};
    return (dm_ray){eye, {seen.x - eye.x, seen.y - eye.y, seen.z - eye.z}};
}

static void drag(dm_context* context, dm_object object, dm_vec3 grab) {
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .object = object,
                               .part_id = PART,
                               .grab_point = grab,
                               .feel = {.detent = 0.2f, .coast_time = 0.4f}};
    dm_drag handle;
    dm_drag_state state = {.struct_size = sizeof state};
    must(dm_drag_begin(context, &desc, &handle), "begin");
    for (int frame = 0; frame < FRAMES; frame++) {
        const dm_ray ray = ray_at(frame, grab);
        if (frame == FRAMES / 2) must(dm_drag_release(context, handle, NULL, NULL), "release");
        must(dm_drag_update(context, handle, frame < FRAMES / 2 ? &ray : NULL, 1.0f / 60, &state), "update");
        printf("drag %d %08x %08x", state.phase, bits_of(state.value), bits_of(state.velocity));
        for (int i = 0; i < 4; i++) printf(" %08x %08x", bits_of(state.pose.real[i]), bits_of(state.pose.dual[i]));
        printf("\n");
    }
    must(dm_drag_end(context, handle, NULL), "end");
}

static void generate(dm_context* context, dm_object object, dm_vec3 grab) {
    dm_pose poses[DM_MOTION_FRAMES];
    dm_motion motion;
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = PART, .drag = {grab, {0, 0, 0.2f}}, .seed = 7};
    must(dm_motion_generate(context, object, &desc, &motion), "generate");
    must(dm_motion_get_frames(context, motion, poses, NULL), "frames");
    for (int i = 0; i < DM_MOTION_FRAMES; i++) {
        printf("motion");
        for (int k = 0; k < 4; k++) printf(" %.9g %.9g", (double)poses[i].real[k], (double)poses[i].dual[k]);
        printf("\n");
    }
}

int main(int argc, char** argv) {
    dm_context* context;
    dm_model model;
    dm_object object;
    dm_part_info part = {.struct_size = sizeof part};
    size_t size;
    if (argc != 3) return 2;
    void* data = read_whole(argv[1], &size);
    must(dm_context_create(NULL, &context), "context");
    must(load_weights(context, argv[2], &model), "weights");
    must(dm_object_load(context, data, size, model, &object), "object");
    free(data);
    must(dm_object_get_part(context, object, 0, &part), "part");
    const dm_vec3 grab = {part.box_max.x, part.centre.y, part.box_max.z}; /* a corner, far from the middle */
    drag(context, object, grab);
    generate(context, object, grab);
    dm_context_destroy(context);
    return 0;
}
