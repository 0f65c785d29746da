/* The common scenario, in C: what every binding must do to the same bits. It prints numbers as the bits of their
 * floats, so that a binding's output can be compared as text. README.md lists the steps. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cabinet.h"
#include "weights.h"

enum { FRAMES = 60, SHOWN_EVERY = 10, SAVED_AT = 30, RELEASED_FRAMES = 120, HANDLE_TURNS_AT = 25 };
static const float frame_time = 1.0f / 60;
static const float handle_turn = 1, widest = 0.45f; /* rad */
static const float snaps[2] = {0.2f, 0.4f};         /* rad */
static const dm_ray first_ray = {{0.9f, 0.9f, 2.0f}, {-0.35f, -0.45f, -1.55f}};

static void must(dm_result result, const char* what) {
    if (result == DM_OK) return;
    printf("%s: %s\n", what, dm_result_string(result));
    exit(1);
}

static void print_floats(const char* name, const float* values, int count) {
    printf("%s", name);
    for (int i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        printf(" %08x", bits);
    }
    printf("\n");
}

static void print_joint(const dm_joint* j) {
    const float numbers[] = {j->axis.x,   j->axis.y, j->axis.z, j->origin.x,        j->origin.y,
                             j->origin.z, j->lower,  j->upper,  j->type_confidence, j->joint_confidence};
    printf("joint %d source %d\n", j->type, j->source);
    print_floats(" ", numbers, 10);
}

static void print_state(const char* name, const dm_drag_state* s) {
    const float numbers[] = {s->value, s->joint_confidence};
    printf("%s phase %d events %u changes %u basis %d\n", name, s->phase, s->events, s->changes, s->joint_basis);
    print_floats(" ", numbers, 2);
    print_floats(" ", s->pose.real, 4);
    print_floats(" ", s->pose.dual, 4);
}

/* What the pulls have said, which a drag has handed to the next one. */
static void print_evidence(const dm_joint* j) {
    const uint32_t* words = j->evidence;
    printf("evidence %u %u %u %u\n", words[0], words[1], words[2], words[3]);
}

/* The pointer's ray in a frame: it goes to the left and towards the camera. */
static dm_ray ray_at(int frame) {
    dm_ray ray = first_ray;
    ray.direction.x -= 0.01f * (float)frame;
    ray.direction.z += 0.005f * (float)frame;
    return ray;
}

static dm_object prepare(dm_context* context, dm_model model, const dm_mesh_desc* mesh) {
    dm_part_desc parts[2] = {dm_part_desc_default(), dm_part_desc_default()};
    parts[0].id = CABINET_DOOR, parts[0].label = "kitchen/cabinet/door";
    parts[1].id = CABINET_DRAWER, parts[1].label = "kitchen/cabinet/drawer";
    dm_object_desc desc = dm_object_desc_default();
    desc.mesh = mesh, desc.parts = parts, desc.part_count = 2, desc.model = model;
    dm_object object;
    must(dm_object_prepare(context, &desc, &object), "prepare");
    return object;
}

static void print_hypotheses(dm_context* context, dm_object object, uint32_t part) {
    dm_joint joint = dm_joint_default(), all[DM_MAX_HYPOTHESES];
    uint32_t count;
    for (int i = 0; i < DM_MAX_HYPOTHESES; i++) all[i] = dm_joint_default();
    must(dm_object_get_joint(context, object, part, &joint), "joint");
    must(dm_object_get_hypotheses(context, object, part, NULL, all, DM_MAX_HYPOTHESES, &count), "hypotheses");
    printf("part %u hypotheses %u\n", part, count);
    print_joint(&joint);
    for (uint32_t i = 0; i < count; i++) print_joint(&all[i]);
}

static dm_hit pick(dm_context* context, dm_object object) {
    dm_scene scene;
    uint32_t instance;
    dm_hit hit = dm_hit_default();
    const dm_scene_desc desc = dm_scene_desc_default();
    must(dm_scene_create(context, &desc, &scene), "scene");
    must(dm_scene_add(context, scene, object, NULL, &instance), "add");
    must(dm_scene_commit(context, scene), "commit");
    must(dm_scene_pick(context, scene, &first_ray, &hit), "pick");
    must(dm_scene_destroy(context, scene), "destroy scene");
    printf("picked part %u triangle %u\n", hit.part_id, hit.triangle);
    print_floats(" ", &hit.object_point.x, 3);
    return hit;
}

static void drag_and_release(dm_context* context, dm_object object, const dm_hit* hit) {
    dm_drag_rules rules = dm_drag_rules_default();
    dm_drag_desc desc = dm_drag_desc_default();
    dm_drag_state state = dm_drag_state_default();
    dm_part_state end = dm_part_state_default();
    static char saved[DM_DRAG_SNAPSHOT_MAX];
    const size_t size = dm_drag_snapshot_size();
    dm_drag drag;
    desc.object = object, desc.part_id = hit->part_id, desc.grab_point = hit->object_point, desc.rules = &rules;
    must(dm_drag_begin(context, &desc, &drag), "begin");
    uint32_t events = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
        const dm_ray ray = ray_at(frame);
        must(dm_drag_update(context, drag, &ray, frame_time, &state), "update");
        events |= state.events;
        if (frame % SHOWN_EVERY == 0) print_state("frame", &state);
        if (frame == SAVED_AT) must(dm_drag_save(context, drag, saved, size), "save");
    }
    must(dm_drag_restore(context, drag, saved, size), "restore");
    const dm_ray last = ray_at(FRAMES);
    must(dm_drag_update(context, drag, &last, frame_time, &state), "update");
    print_state("restored", &state);
    dm_release_desc release = {.struct_size = sizeof release, .intent = DM_GO_OPEN, .flags = DM_RELEASE_BY_RULE};
    dm_release_plan plan = dm_release_plan_default();
    must(dm_drag_release(context, drag, &release, &plan), "release");
    print_floats("plan", &plan.end_value, 1);
    for (int frame = 0; frame < RELEASED_FRAMES; frame++) {
        must(dm_drag_update(context, drag, NULL, frame_time, &state), "released");
        events |= state.events;
    }
    state.events = events;
    print_state("released", &state);
    must(dm_drag_end(context, drag, &end), "end");
    desc.grab_point = state.grab_point, desc.state = &end;
    must(dm_drag_begin(context, &desc, &drag), "begin again");
    must(dm_drag_end(context, drag, &end), "end again");
    print_floats("again", &end.value, 1);
    print_floats(" ", end.pose.real, 4);
    print_floats(" ", end.pose.dual, 4);
    print_evidence(&end.joint);
}

/* The door is held by a latch until its handle turns, and opens no wider than the host takes. */
static void drag_behind_latch(dm_context* context, dm_object object, const dm_hit* hit) {
    dm_drag_rules rules = dm_drag_rules_default();
    dm_drag_desc desc = dm_drag_desc_default();
    dm_drag_input input = dm_drag_input_default();
    dm_drag_state state = dm_drag_state_default();
    dm_drag drag;
    rules.flags = DM_RULE_LATCH, rules.snaps = snaps, rules.snap_count = 2;
    desc.object = object, desc.part_id = hit->part_id, desc.grab_point = hit->object_point, desc.rules = &rules;
    must(dm_drag_begin(context, &desc, &drag), "begin");
    input.flags = DM_INPUT_ASK, input.hand.kind = DM_HAND_RAY;
    uint32_t events = 0, detents = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
        input.hand.ray = ray_at(frame);
        input.handles[0] = frame < HANDLE_TURNS_AT ? 0 : handle_turn;
        must(dm_drag_update_input(context, drag, &input, frame_time, &state), "step");
        if (state.value > widest) must(dm_drag_override(context, drag, widest, &state), "take");
        events |= state.events, detents += state.detents;
        if (frame % SHOWN_EVERY == 0) print_state("latch", &state);
    }
    state.events = events;
    print_state("latched", &state);
    printf("detents %u\n", detents);
    must(dm_drag_end(context, drag, NULL), "end");
}

/* The drawer comes along with the door, and holds it again once it is far out. */
static void follow_links(dm_context* context, dm_object object) {
    const dm_link links[2] = {{.driver = CABINET_DOOR, .driven = CABINET_DRAWER, .ratio = 0.25f, .from = 0.1f},
                              {.driver = CABINET_DRAWER, .driven = CABINET_DOOR, .kind = DM_LINK_HOLDS, .from = 0.05f}};
    float values[2] = {-0.9f, 0};
    uint8_t held[2];
    must(dm_object_set_links(context, object, links, 2), "links");
    for (int i = 0; i < 2; i++) {
        must(dm_object_follow_links(context, object, CABINET_DOOR, values, held, 2), "follow");
        print_floats("linked", values, 2);
        printf("held %u %u\n", held[0], held[1]);
        values[0] = 0.9f;
    }
}

static void save_and_load(dm_context* context, dm_object object) {
    size_t size = 0;
    dm_object again;
    dm_joint joint = dm_joint_default();
    must(dm_object_save(context, object, NULL, 0, &size), "size");
    unsigned char* data = malloc(size);
    if (data == NULL) exit(1);
    must(dm_object_save(context, object, data, size, &size), "save");
    uint32_t hash = 2166136261u; /* FNV-1a */
    for (size_t i = 0; i < size; i++) hash = (hash ^ data[i]) * 16777619u;
    printf("saved %zu bytes %08x\n", size, hash);
    must(dm_object_load(context, data, size, 0, &again), "load");
    must(dm_object_get_joint(context, again, CABINET_DOOR, &joint), "joint");
    print_joint(&joint);
    free(data);
}

int main(int argc, char** argv) {
    static cabinet arrays;
    dm_context* context;
    const dm_context_desc host = dm_context_desc_default();
    must(dm_context_create(&host, &context), "context");
    dm_model model;
    must(load_weights(context, argc > 1 ? argv[1] : "sdk/models", &model), "weights");
    dm_mesh_desc mesh = cabinet_make(&arrays);
    const dm_object object = prepare(context, model, &mesh);
    print_hypotheses(context, object, CABINET_DOOR);
    print_hypotheses(context, object, CABINET_DRAWER);
    const dm_hit hit = pick(context, object);
    drag_and_release(context, object, &hit);
    drag_behind_latch(context, object, &hit);
    follow_links(context, object);
    save_and_load(context, object);
    mesh.index_count = 36; /* one box, without any part */
    dm_object none;
    dm_object_desc broken = dm_object_desc_default();
    broken.mesh = &mesh;
    printf("error %s\n", dm_result_string(dm_object_prepare(context, &broken, &none)));
    dm_context_destroy(context);
    return 0;
}
