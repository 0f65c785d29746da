/* soak LIBRARY MODELS [SHARE] — long lives of a host, after each of which no more memory is held than soon after its
 * start: the library opened and closed, contexts, levels, an editor's cycles, drags, and a day of a scene whose objects
 * come and go. SHARE of the full numbers; 1 without it. Prints a line a life: how often, what the host's allocator
 * holds at the first and the last look, and the resident set. Status 1 where one has grown. */
#include <malloc.h>
#include <stdatomic.h>
#include <string.h>
#include <unistd.h>

#include "cabinet.h"
#include "dragmesh/dragmesh_loader.h"
#include "weights.h"

enum {
    OPENINGS = 2000,
    CONTEXTS = 100000,
    LEVELS = 10000,
    EDITOR_CYCLES = 2000,
    DRAGS = 10000000,
    DAY = 24 * 3600, /* s */
    FRAME_RATE = 60,
    SLOTS = 12,          /* instances that the scene holds at most */
    STREAM_SECONDS = 10, /* from one object that is loaded to the next */
    PREPARE_SECONDS = 60,
    DRAG_FRAMES = 240, /* of one drag in the scene: half in the hand, half let go */
    DRAG_UPDATES = 4,  /* of each of the ten million */
    LOOKS = 10,        /* at the memory, over a life; the first is after a tenth of it */
    LEAST = 100,       /* rounds of a life, whatever the share: it takes some until the C library's lists are full */
    RSS_GROWTH =
        1024 /* KB that the resident set may grow from the first look on: stacks and the C library's own lists */
};
static const float frame_time = 1.0f / FRAME_RATE;

static const dm_core_1* dm;
static _Atomic int64_t held, blocks;

static void* DM_CALL allocate(void* user, size_t size, size_t alignment) {
    (void)user;
    void* memory = aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    if (memory != NULL) atomic_fetch_add(&held, (int64_t)size), atomic_fetch_add(&blocks, 1);
    return memory;
}

static void DM_CALL release(void* user, void* memory, size_t size) {
    (void)user;
    free(memory);
    atomic_fetch_sub(&held, (int64_t)size), atomic_fetch_sub(&blocks, 1);
}

static void must(dm_result result, const char* what) {
    if (result == DM_OK) return;
    fprintf(stderr, "soak: %s: %s\n", what, dm->result_string(result));
    exit(1);
}

/* ---- looks at the memory ---- */

typedef struct life {
    const char* name;
    uint64_t count, next_look;
    int64_t first_held, last_held, first_rss, last_rss;
} life;

/* Pages that are this process's alone, in KB, after the C library has given back what it keeps for later: pages of
 * files come and go as the system likes. */
static int64_t resident_kb(void) {
    malloc_trim(0);
    char line[256];
    long kb = -1;
    FILE* file = fopen("/proc/self/status", "r");
    if (file == NULL) exit(1);
    while (kb < 0 && fgets(line, sizeof line, file) != NULL) sscanf(line, "RssAnon: %ld", &kb);
    fclose(file);
    return kb;
}

static life begin(const char* name, double count) {
    return (life){.name = name, .count = count < LEAST ? LEAST : (uint64_t)count, .next_look = 1};
}

/* After round `done` of a life, where what it has made is gone. */
static void look(life* l, uint64_t done) {
    if (done * LOOKS < l->next_look * l->count) return;
    l->last_held = atomic_load(&held), l->last_rss = resident_kb();
    if (l->next_look == 1) l->first_held = l->last_held, l->first_rss = l->last_rss;
    l->next_look++;
}

static int end(const life* l) {
    const int grown = l->last_held != l->first_held || l->last_rss > l->first_rss + RSS_GROWTH;
    printf("%-32s %10llu  held %9lld to %9lld bytes  resident %7lld to %7lld KB%s\n", l->name,
           (unsigned long long)l->count, (long long)l->first_held, (long long)l->last_held, (long long)l->first_rss,
           (long long)l->last_rss, grown ? "  GROWN" : "");
    fflush(stdout);
    return grown;
}

/* ---- what lives are made of ---- */

static dm_context* open_context(void) {
    dm_context_desc host = dm_context_desc_default();
    dm_context* context;
    host.allocator = (dm_allocator){NULL, allocate, release};
    must(dm->context_create(&host, &context), "context");
    return context;
}

static dm_model load_model(dm_context* context, const char* folder) {
    dm_model_desc desc = dm_model_desc_default();
    dm_model model;
    void* kinematics = read_from(folder, "kpp_net.safetensors", &desc.kinematics_size);
    void* motion = read_from(folder, "dq_vae.safetensors", &desc.motion_size);
    void* ranker = read_from(folder, "ranker.safetensors", &desc.ranker_size);
    desc.kinematics = kinematics, desc.motion = motion, desc.ranker = ranker;
    must(dm->model_load(context, &desc, &model), folder);
    free(kinematics), free(motion), free(ranker);
    return model;
}

static dm_object prepare(dm_context* context, dm_model model, uint64_t seed) {
    static cabinet arrays;
    const dm_mesh_desc mesh = cabinet_make(&arrays);
    dm_object_desc desc = dm_object_desc_default();
    dm_object object;
    desc.mesh = &mesh, desc.model = model, desc.seed = seed;
    must(dm->object_prepare(context, &desc, &object), "prepare");
    return object;
}

typedef struct file {
    void* data;
    size_t size;
} file;

static file save(dm_context* context, dm_object object) {
    file out = {NULL, 0};
    must(dm->object_save(context, object, NULL, 0, &out.size), "size");
    out.data = malloc(out.size);
    if (out.data == NULL) exit(1);
    must(dm->object_save(context, object, out.data, out.size, &out.size), "save");
    return out;
}

static dm_drag grab(dm_context* context, dm_object object, uint32_t part) {
    dm_drag_desc desc = dm_drag_desc_default();
    dm_drag drag;
    desc.object = object, desc.part_id = part;
    desc.grab_point = part == CABINET_DOOR ? (dm_vec3){0.55f, 0.45f, 0.45f} : (dm_vec3){0.3f, 0.88f, 0.45f};
    must(dm->drag_begin(context, &desc, &drag), "begin");
    return drag;
}

static dm_drag_state pull(dm_context* context, dm_drag drag, int frame) {
    const float away = 0.004f * (float)frame;
    const dm_ray ray = {{0.6f, 0.9f, 2.0f}, {-0.1f - away, -0.45f, -1.55f + away}};
    dm_drag_state state = dm_drag_state_default();
    must(dm->drag_update(context, drag, &ray, frame_time, &state), "update");
    return state;
}

/* ---- lives ---- */

static int openings(const char* path, double share) {
    life l = begin("opened and closed", OPENINGS * share);
    for (uint64_t i = 1; i <= l.count; i++) {
        dm_library library;
        dm = dm_library_open(&library, path);
        if (dm == NULL) return fprintf(stderr, "soak: %s: %s\n", path, library.error), 1;
        dm_context* context = open_context();
        must(dm->object_destroy(context, prepare(context, 0, i)), "destroy");
        dm->context_destroy(context);
        dm_library_close(&library);
        look(&l, i);
    }
    return end(&l);
}

static int contexts(double share) {
    life l = begin("contexts", CONTEXTS * share);
    for (uint64_t i = 1; i <= l.count; i++) {
        dm_context *one = open_context(), *other = open_context();
        dm->context_destroy(one);
        dm->context_destroy(other);
        look(&l, i);
    }
    return end(&l);
}

/* After dm_context_trim nothing is kept, and the context counts what the host's allocator has given. */
static void expect_trimmed(dm_context* context) {
    dm_memory_info now = dm_memory_info_default();
    must(dm->context_trim(context), "trim");
    must(dm->context_get_memory(context, &now), "memory");
    if (now.kept_bytes == 0 && now.bytes == (uint64_t)atomic_load(&held)) return;
    fprintf(stderr, "soak: %llu bytes by the context, %lld by the host, %llu kept\n", (unsigned long long)now.bytes,
            (long long)atomic_load(&held), (unsigned long long)now.kept_bytes);
    exit(1);
}

/* A level comes, is played, and goes: weights, an object from a file, its instance in a scene. */
static void play_level(dm_context* context, const char* folder, const file* saved) {
    const dm_scene_desc desc = dm_scene_desc_default();
    const dm_ray ray = {{0.3f, 0.5f, 3}, {0, 0, -1}};
    dm_hit hit = dm_hit_default();
    dm_object object;
    dm_scene scene;
    uint32_t instance;
    const dm_model model = load_model(context, folder);
    must(dm->object_load(context, saved->data, saved->size, model, &object), "load");
    must(dm->scene_create(context, &desc, &scene), "scene");
    must(dm->scene_add(context, scene, object, NULL, &instance), "add");
    must(dm->scene_commit(context, scene), "commit");
    must(dm->context_trim(context), "trim");
    must(dm->scene_pick(context, scene, &ray, &hit), "pick");
    if (hit.object != object) exit(1);
    pull(context, grab(context, object, CABINET_DOOR), 3); /* ends with its object */
    must(dm->object_destroy(context, object), "destroy");
    must(dm->scene_destroy(context, scene), "destroy");
    must(dm->model_unload(context, model), "unload");
    expect_trimmed(context);
}

static int levels(const char* folder, double share) {
    life l = begin("levels loaded, trimmed, unloaded", LEVELS * share);
    dm_context* context = open_context();
    const dm_object object = prepare(context, 0, 1);
    const file saved = save(context, object);
    must(dm->object_destroy(context, object), "destroy");
    for (uint64_t i = 1; i <= l.count; i++) {
        play_level(context, folder, &saved);
        look(&l, i);
    }
    free(saved.data);
    dm->context_destroy(context);
    return end(&l);
}

/* As somebody edits: prepares again, corrects a joint, tries a pull, saves, looks at what was saved. */
static int editor(dm_context* context, dm_model model, double share) {
    life l = begin("cycles of an editor", EDITOR_CYCLES * share);
    for (uint64_t i = 1; i <= l.count; i++) {
        const dm_object object = prepare(context, model, i);
        dm_joint joint = dm_joint_default();
        const dm_drag_hint hint = {{0.55f, 0.45f, 0.45f}, {0, 0, 0.2f}};
        dm_motion_desc motion_desc = dm_motion_desc_default();
        dm_motion motion;
        dm_object again;
        must(dm->object_refine(context, object, CABINET_DOOR, &hint), "refine");
        must(dm->object_get_joint(context, object, CABINET_DOOR, &joint), "joint");
        joint.upper += 0.1f;
        must(dm->object_set_joint(context, object, CABINET_DOOR, &joint), "set");
        motion_desc.part_id = CABINET_DOOR, motion_desc.drag = hint;
        must(dm->motion_generate(context, object, &motion_desc, &motion), "motion");
        file saved = save(context, object);
        must(dm->object_load(context, saved.data, saved.size, model, &again), "load");
        pull(context, grab(context, again, CABINET_DOOR), 3); /* ends with its object */
        free(saved.data);
        must(dm->object_destroy(context, again), "destroy");
        must(dm->object_destroy(context, object), "destroy");
        look(&l, i);
    }
    return end(&l);
}

static int drags(dm_context* context, dm_object object, double share) {
    life l = begin("drags", DRAGS * share);
    for (uint64_t i = 1; i <= l.count; i++) {
        const dm_drag drag = grab(context, object, i % 2 ? CABINET_DOOR : CABINET_DRAWER);
        for (int frame = 0; frame < DRAG_UPDATES; frame++) pull(context, drag, frame * 20);
        must(dm->drag_end(context, drag, NULL), "end");
        look(&l, i);
    }
    return end(&l);
}

typedef struct world {
    dm_context* context;
    dm_model model;
    dm_scene scene;
    file saved;
    dm_object object[SLOTS]; /* 0: nothing there */
    uint32_t instance[SLOTS];
    uint32_t next_slot;
    dm_drag drag;
    uint32_t dragged; /* slot */
} world;

static void drop(world* w, uint32_t slot) {
    if (w->object[slot] == 0) return;
    if (w->drag != 0 && w->dragged == slot) w->drag = 0; /* it ends with its object */
    must(dm->scene_remove(w->context, w->scene, w->instance[slot]), "remove");
    must(dm->object_destroy(w->context, w->object[slot]), "destroy");
    w->object[slot] = 0;
}

/* The oldest object goes, and one comes: from a file, or prepared. */
static void stream(world* w, int prepared, uint64_t seed) {
    const uint32_t slot = w->next_slot;
    const dm_pose placement = {{0, 0, 0, 1}, {(float)slot, 0, 0, 0}};
    w->next_slot = (slot + 1) % SLOTS;
    drop(w, slot);
    if (prepared)
        w->object[slot] = prepare(w->context, w->model, seed);
    else
        must(dm->object_load(w->context, w->saved.data, w->saved.size, w->model, &w->object[slot]), "load");
    must(dm->scene_add(w->context, w->scene, w->object[slot], &placement, &w->instance[slot]), "add");
}

static void play(world* w, uint64_t frame) {
    const int at = (int)(frame % DRAG_FRAMES);
    const uint32_t slot = (uint32_t)(frame / DRAG_FRAMES % SLOTS);
    if (at == 0 && w->object[slot] != 0) w->drag = grab(w->context, w->object[slot], CABINET_DOOR), w->dragged = slot;
    if (w->drag != 0) {
        dm_drag_state state = dm_drag_state_default();
        if (at == DRAG_FRAMES / 2) must(dm->drag_release(w->context, w->drag, NULL, NULL), "release");
        if (at < DRAG_FRAMES / 2)
            state = pull(w->context, w->drag, at);
        else
            must(dm->drag_update(w->context, w->drag, NULL, frame_time, &state), "update");
        must(dm->scene_move(w->context, w->scene, w->instance[w->dragged], CABINET_DOOR, &state.pose), "move");
        if (at == DRAG_FRAMES - 1) must(dm->drag_end(w->context, w->drag, NULL), "end"), w->drag = 0;
    }
    const dm_ray ray = {{(float)slot + 0.3f, 0.5f, 3}, {0, 0, -1}};
    dm_hit hit = dm_hit_default();
    must(dm->scene_commit(w->context, w->scene), "commit");
    must(dm->scene_pick(w->context, w->scene, &ray, &hit), "pick");
}

/* Frames of a scene. It is full again at each look: a whole number of rounds over its places has come and gone. */
static int day(dm_context* context, dm_model model, dm_object object, double share) {
    world w = {.context = context, .model = model, .saved = save(context, object)};
    const dm_scene_desc desc = dm_scene_desc_default();
    const uint64_t round = (uint64_t)FRAME_RATE * STREAM_SECONDS * SLOTS;
    life l = begin("frames of a scene that streams", (double)DAY * FRAME_RATE * share);
    l.count = (l.count + LOOKS * round - 1) / (LOOKS * round) * (LOOKS * round);
    must(dm->scene_create(context, &desc, &w.scene), "scene");
    for (uint64_t frame = 0; frame < l.count; frame++) {
        const uint64_t second = frame / FRAME_RATE;
        if (frame % (FRAME_RATE * STREAM_SECONDS) == 0) stream(&w, second % PREPARE_SECONDS == 0, 1);
        play(&w, frame);
        if ((frame + 1) % round != 0) continue;
        if (w.drag != 0) must(dm->drag_end(context, w.drag, NULL), "end"), w.drag = 0;
        look(&l, frame + 1);
    }
    for (uint32_t slot = 0; slot < SLOTS; slot++) drop(&w, slot);
    must(dm->scene_destroy(context, w.scene), "destroy");
    free(w.saved.data);
    return end(&l);
}

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    const double share = argc > 3 ? atof(argv[3]) : 1;
    int grown = openings(argv[1], share);
    dm_library library;
    dm = dm_library_open(&library, argv[1]);
    if (dm == NULL) return 1;
    grown |= contexts(share);
    grown |= levels(argv[2], share);
    dm_context* context = open_context();
    const dm_model model = load_model(context, argv[2]);
    const dm_object object = prepare(context, model, 1);
    grown |= editor(context, model, share);
    grown |= drags(context, object, share);
    grown |= day(context, model, object, share);
    dm->context_destroy(context);
    dm_library_close(&library);
    const int64_t left = atomic_load(&held) + atomic_load(&blocks);
    if (left != 0) fprintf(stderr, "soak: %lld bytes and blocks are left at the end\n", (long long)left);
    return grown || left != 0;
}
