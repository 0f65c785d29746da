/* Fuzz target: all words of the vocabulary in any order. Whatever the bytes, numbers are finite, values inside limits
 * and bounds, errors are those that the header names, and the part makes no jump without a reason.
 *
 * An input is a list of letters, each a byte and the bytes that it takes: see `say`. Each letter ends with an update,
 * in which the hand goes on: it wanders over a door with a hinge of the host's, seen from above. */
#include <math.h>
#include <string.h>

#include "../include/test_shapes.h"
#include "expect.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

enum { DOOR = 1, KNOB, PARTS = 2, MOST_LETTERS = 4000 };

#define FRAME (1.0f / 144)
#define RANGE 1.5f      /* rad of the door, 0 to that */
#define JUMP 0.01f      /* of the range: a longer step that differs by more from the one before is a jump */
#define REASON 0.25f    /* s for which an event, or a letter that changes the rules of the game, is a reason */
#define SHORTEST 0.35f  /* s */
#define TOLERANCE 1e-4f /* rad: rounding */

/* What the bytes have said so far. */
typedef struct game {
    const uint8_t* data;
    size_t size;
    dm_drag drag;
    dm_drag_input input;
    float values[PARTS];
    uint8_t held[PARTS];
    float angle, speed, radius; /* of the hand round the hinge: rad, rad/s, shares of the door's width */
    float dt, calm;
    dm_drag_state now, last;
    float step; /* of the value in the last update */
    bool saved;
    float taken; /* NAN: the host takes what comes */
} game;

static dm_context* context;
static dm_object object;
static uint8_t snapshot[DM_DRAG_SNAPSHOT_MAX];
static float saved_values[PARTS];

/* ---- an object ---- */

static void start(void) {
    static test_shape shape;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, -0.9f}, (const float[]){1, 1, -0.05f}, 0);
    test_shape_box(&shape, (const float[]){0, 0, -0.04f}, (const float[]){1, 1, 0}, DOOR);
    test_shape_box(&shape, (const float[]){0.85f, 0.45f, 0}, (const float[]){0.95f, 0.55f, 0.05f}, KNOB);
    const dm_mesh_desc mesh = test_shape_desc(&shape);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh};
    const dm_joint hinge = {.struct_size = sizeof hinge, .type = DM_JOINT_REVOLUTE, .axis = {0, -1, 0}, .upper = RANGE};
    const dm_joint turn = {.struct_size = sizeof turn,
                           .type = DM_JOINT_REVOLUTE,
                           .axis = {0, 0, 1},
                           .origin = {0.9f, 0.5f, 0},
                           .upper = 1};
    fuzz_expect(dm_context_create(NULL, &context) == DM_OK);
    fuzz_expect(dm_object_prepare(context, &desc, &object) == DM_OK);
    fuzz_expect(dm_object_set_joint(context, object, DOOR, &hinge) == DM_OK);
    fuzz_expect(dm_object_set_joint(context, object, KNOB, &turn) == DM_OK);
}

/* ---- bytes ---- */

static uint8_t byte(game* g) {
    if (g->size == 0) return 0;
    g->size--;
    return *g->data++;
}

/* A number from least to most. */
static float number(game* g, float least, float most) {
    return least + (most - least) * (float)byte(g) / 255;
}

/* The same from more than 0 on, or 0 every second time: off. */
static float some(game* g, float most) {
    const uint8_t b = byte(g);
    return b % 2 ? most * (float)(b / 2 + 1) / 128 : 0;
}

/* A time of a motion over the range, or 0: slow enough that a step of a frame is no jump. */
static float some_time(game* g) {
    const float time = some(g, 0.7f);
    return time > 0 ? SHORTEST + time : 0;
}

/* ---- letters ---- */

static dm_vec3 place(const game* g, float angle) {
    return (dm_vec3){g->radius * cosf(angle), 0.5f, g->radius * sinf(angle)};
}

static void begin(game* g) {
    static float snaps[DM_MAX_SNAPS];
    const float value = fminf(fmaxf(g->values[DOOR - 1], 0), RANGE);
    dm_drag_rules rules = dm_drag_rules_default();
    rules.flags = byte(g) % 4;
    rules.snap_count = byte(g) % 3;
    for (uint32_t i = 0; i < rules.snap_count; i++) snaps[i] = (float)i * 0.6f + number(g, 0, 0.5f);
    rules.snaps = snaps, rules.snap_reach = some(g, 0.2f);
    rules.event_time = some(g, 0.5f), rules.max_speed = some(g, 3), rules.max_acceleration = some(g, 12);
    rules.lock_give = some(g, 0.05f), rules.latch_turn = some(g, 1);
    rules.auto_close_share = some(g, 0.3f), rules.auto_close_time = some_time(g), rules.close_delay = some(g, 0.5f);
    rules.tip_share = some(g, 1), rules.fall_time = some_time(g), rules.restitution = some(g, 1);
    rules.break_distance = some(g, 2), rules.drive_speed = some(g, 2);
    dm_drag_feel feel = {0};
    feel.smoothing_time = some(g, 0.1f), feel.soft_limit = some(g, 0.1f), feel.coast_time = some(g, 0.4f);
    feel.return_time = some_time(g);
    if (rules.snap_count == 0) feel.detent = some(g, 0.5f), feel.detent_pull = some(g, 1);
    g->angle = value, g->speed = 0, g->radius = number(g, 0.5f, 1);
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = DOOR,
                               .object = object,
                               .grab_point = place(g, value),
                               .start_value = value,
                               .feel = feel,
                               .flags = byte(g) % 4,
                               .rules = &rules};
    if (g->drag != 0) fuzz_expect(dm_drag_end(context, g->drag, NULL) == DM_OK);
    fuzz_expect(dm_drag_begin(context, &desc, &g->drag) == DM_OK);
    g->saved = false;
    g->now.value = g->last.value = value, g->step = 0;
}

static void hold_otherwise(game* g) {
    g->input.hand.kind = byte(g) % 6;
    if (g->input.hand.kind > DM_HAND_POINT) g->input.second.kind = DM_HAND_NONE;
}

static void second_hand(game* g) {
    const bool may = g->input.hand.kind <= DM_HAND_POINT;
    g->input.second.kind = may ? byte(g) % 3 : DM_HAND_NONE;
}

static void set_bounds(game* g) {
    const float lower = number(g, -0.5f, 0.7f), upper = number(g, 0.8f, 2);
    const uint8_t which = byte(g) % 4;
    g->input.lower = which == 0 ? 0 : which == 1 ? -INFINITY : lower;
    g->input.upper = which == 0 ? 0 : which == 2 ? INFINITY : upper;
}

static void let_go(game* g) {
    dm_release_desc desc = dm_release_desc_default();
    desc.intent = byte(g) % 7, desc.flags = DM_RELEASE_BY_RULE | byte(g) % 4, desc.duration = some_time(g);
    desc.away_from = place(g, number(g, 0, 6));
    const dm_result result = dm_drag_release(context, g->drag, &desc, NULL);
    fuzz_expect(result == DM_OK || (desc.intent == DM_INTENT_REPLAY && result == DM_ERROR_INVALID_ARGUMENT));
    dm_part_state state = dm_part_state_default(); /* a replay begins where it began before */
    fuzz_expect(dm_drag_get_part_state(context, g->drag, &state) == DM_OK);
    g->now.value = state.value;
}

static void save(game* g) {
    fuzz_expect(dm_drag_save(context, g->drag, snapshot, sizeof snapshot) == DM_OK);
    memcpy(saved_values, g->values, sizeof saved_values);
    g->saved = true;
}

static void restore(game* g) {
    if (!g->saved) return;
    fuzz_expect(dm_drag_restore(context, g->drag, snapshot, sizeof snapshot) == DM_OK);
    memcpy(g->values, saved_values, sizeof g->values);
    g->now.value = g->last.value = g->values[DOOR - 1], g->step = 0;
}

static void link_parts(game* g) {
    dm_link links[3];
    const uint32_t count = byte(g) % 4;
    for (uint32_t i = 0; i < count; i++) {
        const uint8_t way = byte(g);
        links[i] = (dm_link){.driver = way % 2 ? DOOR : KNOB,
                             .driven = way / 2 % 2 ? DOOR : KNOB,
                             .kind = way / 4 % 3,
                             .ratio = number(g, -2, 2),
                             .offset = number(g, -0.2f, 0.2f),
                             .from = number(g, -0.2f, 1)};
        if (links[i].kind == DM_LINK_MOVES) links[i].flags = way / 16 % 2;
    }
    const dm_result result = dm_object_set_links(context, object, links, count);
    fuzz_expect(result == DM_OK || result == DM_ERROR_INVALID_ARGUMENT);
}

static void turn_knob(game* g) {
    g->values[KNOB - 1] = number(g, 0, 1);
    g->input.handles[byte(g) % 2] = g->values[KNOB - 1];
}

static void set_frame(game* g) {
    static const float times[4] = {FRAME, 1.0f / 30, 0.25f, 0};
    g->dt = times[byte(g) % 4];
}

/* One letter. Returns whether what follows may come with a jump. */
static bool say(game* g) {
    switch (byte(g)) { /* mostly, the hand just goes on */
    case 0:
        begin(g);
        return true;
    case 1:
        hold_otherwise(g);
        return true;
    case 2:
        second_hand(g);
        return true;
    case 3:
        set_bounds(g);
        return true;
    case 4:
        let_go(g);
        return true;
    case 5:
        save(g);
        return false;
    case 6:
        restore(g);
        return true;
    case 7:
        link_parts(g);
        return true;
    case 8:
        turn_knob(g);
        return true;
    case 9:
        g->input.flags ^= DM_INPUT_LOCKED;
        return true;
    case 10:
        g->taken = number(g, -0.5f, 2);
        return true;
    case 11:
        set_frame(g);
        return true;
    default:
        g->speed = fminf(fmaxf(g->speed + number(g, -0.1f, 0.1f), -2), 2);
        return false;
    }
}

/* ---- an update ---- */

static void move_hands(game* g) {
    g->angle = fminf(fmaxf(g->angle + g->speed * g->dt, -0.4f), RANGE + 0.4f);
    const dm_vec3 eye = {0.3f, 6, 0.4f}, at = place(g, g->angle), beside = place(g, g->angle + 0.05f);
    dm_hand* const hands[2] = {&g->input.hand, &g->input.second};
    const dm_vec3 points[2] = {at, beside};
    for (int i = 0; i < 2; i++) {
        const dm_vec3 p = points[i];
        hands[i]->ray = (dm_ray){eye, {p.x - eye.x, p.y - eye.y, p.z - eye.z}};
        hands[i]->point = p;
    }
    const float amounts[] = {[DM_HAND_RATE] = g->speed / RANGE, /* all as fast as the hand */
                             [DM_HAND_STEP] = g->speed / RANGE * g->dt,
                             [DM_HAND_VALUE] = g->angle};
    g->input.hand.amount = amounts[g->input.hand.kind];
    g->input.second.grab_point = place(g, g->now.value);
}

static void check_numbers(const dm_drag_state* s) {
    fuzz_expect_state(s);
    fuzz_expect(s->value >= 0 && s->value <= RANGE && s->target >= -TOLERANCE && s->target <= RANGE + TOLERANCE);
}

/* Inside the bounds, or on the way back to them. */
static void check_bounds(const game* g) {
    if (!(g->input.lower < g->input.upper)) return;
    const float lower = fminf(fmaxf(g->input.lower, 0), fminf(g->last.value, RANGE));
    const float upper = fmaxf(fminf(g->input.upper, RANGE), g->last.value);
    fuzz_expect(g->now.value >= lower - TOLERANCE && g->now.value <= upper + TOLERANCE);
}

static void check_jump(const game* g, float step) {
    if (g->calm < REASON || g->dt != FRAME) return;
    fuzz_expect(fabsf(step) <= JUMP * RANGE || fabsf(step - g->step) <= JUMP * RANGE);
}

/* What links say of the value, and what the host makes of it. */
static void take(game* g) {
    g->values[DOOR - 1] = g->now.value;
    fuzz_expect(dm_object_follow_links(context, object, DOOR, g->values, g->held, PARTS) == DM_OK);
    if (!isnan(g->taken)) g->values[DOOR - 1] = g->taken;
    if (g->values[DOOR - 1] != g->now.value) {
        fuzz_expect(dm_drag_take(context, g->drag, g->values[DOOR - 1], &g->now) == DM_OK);
        g->calm = 0;
    }
    g->values[DOOR - 1] = g->now.value;
    g->taken = NAN;
}

static void update(game* g) {
    move_hands(g);
    g->last = g->now;
    dm_drag_input input = g->input;
    input.flags |= DM_INPUT_ASK | (g->held[DOOR - 1] ? (uint32_t)DM_INPUT_LOCKED : 0);
    const uint8_t was_held = g->held[DOOR - 1];
    fuzz_expect(dm_drag_step(context, g->drag, &input, g->dt, &g->now) == DM_OK);
    check_numbers(&g->now);
    check_bounds(g);
    take(g);
    check_numbers(&g->now);
    const float step = g->now.value - g->last.value;
    g->calm = g->now.events != 0 || g->held[DOOR - 1] != was_held ? 0 : g->calm + g->dt;
    check_jump(g, step);
    g->step = step;
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (context == NULL) start();
    game g = {.data = data, .size = size, .dt = FRAME, .taken = NAN};
    g.input = dm_drag_input_default(), g.now = g.last = dm_drag_state_default();
    g.input.hand.kind = DM_HAND_RAY;
    fuzz_expect(dm_object_set_links(context, object, NULL, 0) == DM_OK);
    begin(&g);
    for (int i = 0; i < MOST_LETTERS && g.size > 0; i++) {
        if (say(&g)) g.calm = 0;
        update(&g);
    }
    fuzz_expect(dm_drag_end(context, g.drag, NULL) == DM_OK);
    return 0;
}
