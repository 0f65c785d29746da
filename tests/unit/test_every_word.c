/* Every word of the vocabulary, one by one, through the public functions: the same at 30, 60 and 144 Hz and with a
 * hitch of a quarter of a second; the same bits after a save and a restore in the middle, into a drag that knew nothing
 * of it; and two instances of one object that don't know of each other. */
#include "test_world.h"

#include <math.h>
#include <stdbool.h>

enum { MOST_FRAMES = 512, EVENTS = 14, PARTS = 2, RATES = 4, HITCH = 3 };
static const float rates[RATES] = {30, 60, 144, 60}; /* Hz; the last one has the hitch */
static const float seconds = 2.6f, hitch_at = 0.45f, hitch = 0.25f, rounding = 1e-4f; /* s; all whole frames */
static const float place_error = 0.01f;                                               /* rad between two rates */
static const float glide_error =
    0.03f; /* the same of a glide, which begins at the speed that the hand has been sampled at */

typedef struct word {
    const char* name;
    uint32_t must; /* events without which the word has not been played */
    dm_drag_rules rules;
    dm_drag_feel feel;
    uint32_t drag_flags;         /* DM_DRAG_* */
    float start;                 /* joint value at which it begins */
    dm_link links[2];            /* of the object; kind is read where driver is set */
    float (*handle)(float time); /* value of the other part; NULL: links alone move it */
    void (*tell)(float before, float now, dm_drag_input* input); /* besides the pointer of `way` */
    float release_at;                                            /* s; 0: never */
    dm_release_desc release;
    bool glides;
    float filter; /* the host takes no more than this value; 0: it takes what comes */
} word;

/* ---- what hand and world do, as functions of time ---- */

/* Out to 1.2 rad in 0.6 s, a rest there, and back by 1.8 s. */
static float way(float t) {
    const float out = fminf(fmaxf(t / 0.6f, 0), 1), back = fminf(fmaxf((t - 1.2f) / 0.6f, 0), 1);
    return 1.2f * (out * out * (3 - 2 * out) - back * back * (3 - 2 * back));
}

static float turns_late(float t) {
    return t > 0.8f && t < 1.6f ? 1.0f : 0.0f;
}

static dm_vec3 place_on_door(float value) {
    const dm_joint hinge = test_hinge();
    return test_point_on(&hinge, value);
}

static void lock_till_half(float before, float now, dm_drag_input* input) {
    (void)before;
    input->flags |= now < 0.8f ? DM_INPUT_LOCKED : 0;
}

static void second_handle(float before, float now, dm_drag_input* input) {
    (void)before;
    input->handles[1] = -turns_late(now);
}

static void block(float before, float now, dm_drag_input* input) {
    (void)before;
    if (now < 0.9f) input->lower = -INFINITY, input->upper = 0.7f;
}

static void hand_in_space(float before, float now, dm_drag_input* input) {
    (void)before;
    input->hand = (dm_hand){.kind = DM_HAND_POINT, .point = place_on_door(way(now))};
}

static void hand_far_off(float before, float now, dm_drag_input* input) {
    hand_in_space(before, now, input);
    if (now > 0.9f) input->hand.point.y += 5;
}

static void stick(float before, float now, dm_drag_input* input) {
    (void)now;
    const float t = before + rounding;
    input->hand = (dm_hand){.kind = DM_HAND_RATE, .amount = t < 1 ? 0.5f : t < 2 ? -0.25f : 0};
}

static void wheel(float before, float now, dm_drag_input* input) {
    const bool clicks = before < 0.4f && now >= 0.4f;
    input->hand = (dm_hand){.kind = clicks ? DM_HAND_STEP : DM_HAND_NONE, .amount = 0.3f};
}

static void slider(float before, float now, dm_drag_input* input) {
    (void)before;
    input->hand = (dm_hand){.kind = DM_HAND_VALUE, .amount = way(now)};
}

static void second_hand(float before, float now, dm_drag_input* input) {
    hand_in_space(before, now, input);
    if (now > 0.3f && now < 1)
        input->second = (dm_hand){
            .kind = DM_HAND_POINT, .grab_point = place_on_door(way(0.3f)), .point = place_on_door(0.8f * way(now))};
}

static void no_hand(float before, float now, dm_drag_input* input) {
    (void)before, (void)now;
    input->hand.kind = DM_HAND_NONE;
}

/* ---- the words ---- */

static const float snap_values[2] = {0.3f, 0.9f};

#define RELEASE(what) .release = {.struct_size = sizeof(dm_release_desc), .intent = what, .flags = DM_RELEASE_BY_RULE}

static const word words[] = {
    {.name = "events",
     .must = DM_EVENT_LEFT_REST | DM_EVENT_OPENED | DM_EVENT_CLOSED | DM_EVENT_REACHED_REST | DM_EVENT_LIMIT_LOWER},
    {.name = "event time", .must = DM_EVENT_OPENED, .rules = {.event_time = 1.5f}},
    {.name = "snaps", .must = DM_EVENT_DETENT, .rules = {.snaps = snap_values, .snap_count = 2}},
    {.name = "snaps of a reach",
     .must = DM_EVENT_DETENT,
     .rules = {.snaps = snap_values, .snap_count = 2, .snap_reach = 0.1f}},
    {.name = "snap after release",
     .must = DM_EVENT_DETENT,
     .rules = {.snaps = snap_values, .snap_count = 2},
     .release_at = 1,
     RELEASE(DM_INTENT_AUTO)},
    {.name = "detents", .must = DM_EVENT_DETENT, .feel = {.detent = 0.25f}},
    {.name = "soft limits", .must = DM_EVENT_LEFT_REST, .feel = {.soft_limit = 0.1f}},
    {.name = "weight", .must = DM_EVENT_LEFT_REST, .feel = {.coast_time = 0.15f, .smoothing_time = 0.05f}},
    {.name = "highest speed", .must = DM_EVENT_OPENED, .rules = {.max_speed = 1}},
    {.name = "highest acceleration", .must = DM_EVENT_OPENED, .rules = {.max_acceleration = 5}},
    {.name = "bounds", .must = DM_EVENT_BLOCKED | DM_EVENT_FREED, .tell = block},
    {.name = "lock", .must = DM_EVENT_LOCKED, .rules = {.flags = DM_RULE_LOCKED}},
    {.name = "lock of an update", .must = DM_EVENT_LOCKED | DM_EVENT_OPENED, .tell = lock_till_half},
    {.name = "lock without give", .must = DM_EVENT_LOCKED, .rules = {.flags = DM_RULE_LOCKED, .lock_give = -1}},
    {.name = "latch",
     .must = DM_EVENT_UNLATCHED | DM_EVENT_LATCHED | DM_EVENT_OPENED,
     .rules = {.flags = DM_RULE_LATCH},
     .handle = turns_late},
    {.name = "latch, second handle",
     .must = DM_EVENT_UNLATCHED | DM_EVENT_LATCHED,
     .rules = {.flags = DM_RULE_LATCH},
     .tell = second_handle},
    {.name = "auto-close",
     .must = DM_EVENT_CLOSED,
     .rules = {.auto_close_share = 0.5f},
     .release_at = 0.3f,
     RELEASE(DM_INTENT_AUTO)},
    {.name = "spring",
     .must = DM_EVENT_CLOSED,
     .feel = {.return_time = 0.6f},
     .release_at = 1,
     RELEASE(DM_INTENT_AUTO)},
    {.name = "closer with a delay",
     .must = DM_EVENT_CLOSED,
     .feel = {.return_time = 0.4f},
     .rules = {.close_delay = 0.5f},
     .release_at = 1,
     RELEASE(DM_INTENT_AUTO)},
    {.name = "fall shut",
     .must = DM_EVENT_LIMIT_LOWER,
     .rules = {.tip_share = 0.9f},
     .release_at = 1,
     RELEASE(DM_INTENT_AUTO)},
    {.name = "fall open with bounces",
     .must = DM_EVENT_LIMIT_UPPER,
     .rules = {.tip_share = 0.3f, .restitution = 0.4f},
     .release_at = 1,
     RELEASE(DM_INTENT_AUTO)},
    {.name = "glide with a bounce",
     .glides = true,
     .must = DM_EVENT_LIMIT_LOWER,
     .feel = {.coast_time = 0.4f},
     .rules = {.restitution = 0.5f},
     .release_at = 1.5f,
     RELEASE(DM_INTENT_STAY)},
    {.name = "hand in space", .must = DM_EVENT_OPENED | DM_EVENT_CLOSED, .tell = hand_in_space},
    {.name = "break distance", .must = DM_EVENT_LET_GO, .rules = {.break_distance = 2}, .tell = hand_far_off},
    {.name = "stick", .must = DM_EVENT_OPENED, .drag_flags = DM_DRAG_WITHOUT_POINT, .tell = stick},
    {.name = "stick, drive speed",
     .must = DM_EVENT_LIMIT_UPPER,
     .rules = {.drive_speed = 3},
     .drag_flags = DM_DRAG_WITHOUT_POINT,
     .tell = stick},
    {.name = "wheel", .must = DM_EVENT_OPENED, .drag_flags = DM_DRAG_WITHOUT_POINT, .tell = wheel},
    {.name = "slider", .must = DM_EVENT_OPENED | DM_EVENT_CLOSED, .drag_flags = DM_DRAG_WITHOUT_POINT, .tell = slider},
    {.name = "two hands", .must = DM_EVENT_OPENED | DM_EVENT_CLOSED, .tell = second_hand},
    {.name = "open without a pointer",
     .must = DM_EVENT_OPENED,
     .drag_flags = DM_DRAG_WITHOUT_POINT,
     .tell = no_hand,
     .release_at = 0.2f,
     RELEASE(DM_INTENT_OPEN)},
    {.name = "toggle",
     .must = DM_EVENT_CLOSED,
     .start = 1.5f,
     .drag_flags = DM_DRAG_WITHOUT_POINT,
     .tell = no_hand,
     .release_at = 0.2f,
     RELEASE(DM_INTENT_TOGGLE)},
    {.name = "ajar",
     .must = DM_EVENT_CLOSED,
     .start = 0.15f,
     .drag_flags = DM_DRAG_WITHOUT_POINT,
     .tell = no_hand,
     .release_at = 0.2f,
     RELEASE(DM_INTENT_CLOSE)},
    {.name = "filter", .must = DM_EVENT_OPENED | DM_EVENT_CLOSED, .filter = 0.5f},
    {.name = "filter of a release",
     .must = DM_EVENT_LEFT_REST,
     .filter = 0.5f,
     .drag_flags = DM_DRAG_WITHOUT_POINT,
     .tell = no_hand,
     .release_at = 0.2f,
     RELEASE(DM_INTENT_OPEN)},
    {.name = "link that moves",
     .must = DM_EVENT_OPENED,
     .links = {{.driver = TEST_DOOR, .driven = TEST_HANDLE, .ratio = 0.5f, .from = 0.2f}}},
    {.name = "link both ways, the driver at its limit",
     .must = DM_EVENT_OPENED,
     .links = {{.driver = TEST_HANDLE, .driven = TEST_DOOR, .ratio = 0.5f, .flags = DM_LINK_BOTH_WAYS}}},
    {.name = "link that frees",
     .must = DM_EVENT_LOCKED | DM_EVENT_OPENED,
     .links = {{.driver = TEST_HANDLE, .driven = TEST_DOOR, .kind = DM_LINK_FREES, .from = 0.7f}},
     .handle = turns_late},
    {.name = "link that holds",
     .must = DM_EVENT_OPENED,
     .links = {{.driver = TEST_HANDLE, .driven = TEST_DOOR, .kind = DM_LINK_HOLDS, .from = 0.7f}},
     .handle = turns_late},
};
enum { WORDS = sizeof words / sizeof *words };

/* ---- playing one ---- */

typedef struct house {
    test_world w;
    dm_object object;
    uint32_t door, handle; /* indexes of parts */
} house;

/* One instance, and what came of it. */
typedef struct instance {
    const house* house;
    const word* word;
    dm_drag drag;
    float values[PARTS];
    float time;
    bool released;
    uint32_t frame;
    dm_drag_state states[MOST_FRAMES];
    float others[MOST_FRAMES]; /* values of the other part */
    uint32_t counts[EVENTS], detents;
    float first[EVENTS]; /* s of the first event of a kind */
} instance;

static void open_house(house* h) {
    test_world_init(&h->w);
    test_world_open(&h->w);
    h->object = test_world_cabinet(&h->w);
    const dm_joint hinge = test_hinge();
    assert_int_equal(dm_object_set_joint(h->w.context, h->object, TEST_DOOR, &hinge), DM_OK);
    assert_int_equal(dm_object_set_joint(h->w.context, h->object, TEST_HANDLE, &hinge), DM_OK);
    dm_part_info part = dm_part_info_default();
    assert_int_equal(dm_object_get_part(h->w.context, h->object, 0, &part), DM_OK);
    h->door = part.id == TEST_DOOR ? 0 : 1, h->handle = 1 - h->door;
}

static void link_parts(const house* h, const word* word) {
    const uint32_t count = word->links[0].driver != 0;
    assert_int_equal(dm_object_set_links(h->w.context, h->object, word->links, count), DM_OK);
}

static dm_drag begin(const house* h, const word* word, const dm_drag_rules* rules) {
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = TEST_DOOR,
                               .object = h->object,
                               .grab_point = place_on_door(word->start),
                               .start_value = word->start,
                               .feel = word->feel,
                               .flags = word->drag_flags,
                               .rules = rules};
    dm_drag drag = 0;
    assert_int_equal(dm_drag_begin(h->w.context, &desc, &drag), DM_OK);
    return drag;
}

static void start(instance* in, const house* h, const word* word) {
    dm_drag_rules rules = word->rules;
    rules.struct_size = sizeof rules;
    memset(in, 0, sizeof *in);
    in->house = h, in->word = word, in->values[h->door] = word->start;
    in->drag = begin(h, word, &rules);
}

static void note(instance* in, const dm_drag_state* now) {
    for (int event = 0; event < EVENTS; event++) {
        if (!(now->events >> event & 1)) continue;
        if (in->counts[event]++ == 0) in->first[event] = in->time;
    }
    in->detents += now->detents;
    in->others[in->frame] = in->values[in->house->handle];
    in->states[in->frame++] = *now;
}

static dm_drag_input input_of(const instance* in, float now) {
    dm_drag_input input = dm_drag_input_default();
    input.hand = (dm_hand){.kind = DM_HAND_RAY, .ray = test_ray_to(place_on_door(way(now)))};
    input.handles[0] = in->values[in->house->handle];
    if (in->word->tell != NULL) in->word->tell(in->time, now, &input);
    return input;
}

/* What links say of the parts, the value that the host takes included. */
static void follow(instance* in, uint8_t* held) {
    assert_int_equal(
        dm_object_follow_links(in->house->w.context, in->house->object, TEST_DOOR, in->values, held, PARTS), DM_OK);
}

/* One update, as a game makes it. */
static void advance(instance* in, float dt) {
    const house* h = in->house;
    const word* word = in->word;
    uint8_t held[PARTS];
    dm_drag_state now = dm_drag_state_default();
    if (word->release_at > 0 && in->time + rounding >= word->release_at && !in->released) {
        assert_int_equal(dm_drag_release(h->w.context, in->drag, &word->release, NULL), DM_OK);
        in->released = true;
    }
    if (word->handle != NULL) in->values[h->handle] = word->handle(in->time + dt);
    dm_drag_input input = input_of(in, in->time + dt);
    float before[PARTS];
    memcpy(before, in->values, sizeof before);
    follow(in, held);
    memcpy(in->values, before, sizeof before);
    input.flags |= DM_INPUT_ASK | (held[h->door] ? (uint32_t)DM_INPUT_LOCKED : 0);
    assert_int_equal(dm_drag_step(h->w.context, in->drag, &input, dt, &now), DM_OK);
    in->values[h->door] = now.value;
    if (word->links[0].kind == DM_LINK_MOVES) follow(in, NULL);
    if (word->filter > 0) in->values[h->door] = fminf(in->values[h->door], word->filter);
    if (in->values[h->door] != now.value)
        assert_int_equal(dm_drag_take(h->w.context, in->drag, in->values[h->door], &now), DM_OK);
    in->values[h->door] = now.value;
    in->time += dt;
    note(in, &now);
}

/* The first ray of a drag is that of the grab; then frame after frame. */
static void play(instance* in, int rate) {
    while (in->time < seconds) {
        const float dt = 1 / rates[rate], late = in->time < hitch_at && in->time + dt >= hitch_at ? hitch : dt;
        advance(in, in->frame == 0 ? 0 : rate == HITCH ? late : dt);
    }
}

static void finish(instance* in) {
    assert_int_equal(dm_drag_end(in->house->w.context, in->drag, NULL), DM_OK);
}

/* ---- properties ---- */

static void assert_alike(const instance* a, const instance* b, bool hitched) {
    const float most = hitched ? hitch + 0.05f : 0.06f;
    const float end = a->states[a->frame - 1].value, other = b->states[b->frame - 1].value;
    if (fabsf(end - other) > (a->word->glides ? glide_error : place_error))
        fail_msg("%s: ends at %g and at %g", a->word->name, (double)end, (double)other);
    if (fabsf(a->others[a->frame - 1] - b->others[b->frame - 1]) > 0.01f)
        fail_msg("%s: the other part ends elsewhere", a->word->name);
    if (a->detents != b->detents) fail_msg("%s: %u and %u detents", a->word->name, a->detents, b->detents);
    for (int event = 0; event < EVENTS; event++) {
        if (1u << event != DM_EVENT_DETENT && a->counts[event] != b->counts[event])
            fail_msg("%s: event %u comes %u and %u times", a->word->name, 1u << event, a->counts[event],
                     b->counts[event]);
        if (fabsf(a->first[event] - b->first[event]) > most)
            fail_msg("%s: event %u comes at %g and at %g s", a->word->name, 1u << event, (double)a->first[event],
                     (double)b->first[event]);
    }
}

static void no_word_depends_on_the_rate(void** state) {
    (void)state;
    static instance of[RATES];
    house h;
    open_house(&h);
    for (int i = 0; i < WORDS; i++) {
        link_parts(&h, &words[i]);
        for (int rate = 0; rate < RATES; rate++) {
            start(&of[rate], &h, &words[i]);
            play(&of[rate], rate);
            finish(&of[rate]);
        }
        for (int event = 0; event < EVENTS; event++)
            if (words[i].must >> event & 1 && of[1].counts[event] == 0)
                fail_msg("%s: no event %u", words[i].name, 1u << event);
        for (int rate = 0; rate < RATES; rate++) assert_alike(&of[1], &of[rate], rate == HITCH);
    }
    test_world_close(&h.w);
}

static void assert_same_bits(const instance* a, const instance* b, uint32_t from) {
    assert_int_equal(a->frame, b->frame);
    for (uint32_t k = from; k < a->frame; k++) {
        if (memcmp(&a->states[k], &b->states[k], sizeof a->states[k]) != 0 || a->others[k] != b->others[k])
            fail_msg("%s: frame %u has other bits", a->word->name, k);
    }
}

/* Saved after so many frames, and taken up by a drag that began with no rules at all. */
static void every_word_is_saved_and_restored(void** state) {
    (void)state;
    static instance whole, again;
    static uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
    static const uint32_t moments[] = {1, 20, 40, 62, 75, 110};
    house h;
    open_house(&h);
    for (int i = 0; i < WORDS; i++) {
        link_parts(&h, &words[i]);
        start(&whole, &h, &words[i]);
        play(&whole, 1);
        finish(&whole);
        for (size_t m = 0; m < sizeof moments / sizeof *moments; m++) {
            start(&again, &h, &words[i]);
            while (again.frame < moments[m]) advance(&again, again.frame == 0 ? 0 : 1 / rates[1]);
            assert_int_equal(dm_drag_save(h.w.context, again.drag, saved, sizeof saved), DM_OK);
            finish(&again);
            again.drag = begin(&h, &words[0], NULL);
            assert_int_equal(dm_drag_restore(h.w.context, again.drag, saved, sizeof saved), DM_OK);
            play(&again, 1);
            finish(&again);
            assert_same_bits(&whole, &again, 0);
        }
    }
    test_world_close(&h.w);
}

/* Another instance of the same object, some frames behind, plays between the frames of the first. */
static void instances_do_not_know_of_each_other(void** state) {
    (void)state;
    static instance alone, first, second;
    house h;
    open_house(&h);
    for (int i = 0; i < WORDS; i++) {
        link_parts(&h, &words[i]);
        start(&alone, &h, &words[i]);
        play(&alone, 1);
        finish(&alone);
        start(&first, &h, &words[i]);
        start(&second, &h, &words[i]);
        for (uint32_t k = 0; k < alone.frame + 37; k++) {
            if (k < alone.frame) advance(&first, k == 0 ? 0 : 1 / rates[1]);
            if (k >= 37) advance(&second, k == 37 ? 0 : 1 / rates[1]);
        }
        finish(&first);
        finish(&second);
        assert_same_bits(&alone, &first, 0);
        assert_same_bits(&alone, &second, 0);
    }
    test_world_close(&h.w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_word_depends_on_the_rate),
        cmocka_unit_test(every_word_is_saved_and_restored),
        cmocka_unit_test(instances_do_not_know_of_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
