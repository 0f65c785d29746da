/* What real hands do to a kitchen cabinet, through the public functions and with the shipped weights: they push a
 * closed part the wrong way first, let go and grab again, pull what they see end on. Run from the repository's root. */
#include <math.h>
#include <stdbool.h>

#include "test_world.h"

enum { DOOR = 1, DRAWER = 2, BOXES = 13 };

/* A cabinet 0.6 m wide, 1 m high and 0.4 m deep whose front faces +z, with a door and a drawer above it. */
static const struct box {
    float min[3], max[3];
    uint32_t part;
} boxes[BOXES] = {
    {{0, 0, 0}, {0.6f, 0.02f, 0.4f}, 0},                     /* bottom */
    {{0, 0.98f, 0}, {0.6f, 1, 0.42f}, 0},                    /* top */
    {{0, 0.02f, 0}, {0.02f, 0.98f, 0.4f}, 0},                /* left */
    {{0.58f, 0.02f, 0}, {0.6f, 0.98f, 0.4f}, 0},             /* right */
    {{0.02f, 0.02f, 0}, {0.58f, 0.98f, 0.02f}, 0},           /* back */
    {{0, 0, 0.402f}, {0.6f, 0.79f, 0.42f}, DOOR},            /* hinged on the left … */
    {{0.54f, 0.35f, 0.42f}, {0.56f, 0.55f, 0.45f}, DOOR},    /* … and its handle */
    {{0, 0.8f, 0.402f}, {0.6f, 0.97f, 0.42f}, DRAWER},       /* the drawer's front … */
    {{0.25f, 0.87f, 0.42f}, {0.35f, 0.89f, 0.45f}, DRAWER},  /* … handle … */
    {{0.04f, 0.82f, 0.03f}, {0.56f, 0.83f, 0.402f}, DRAWER}, /* … and box */
    {{0.04f, 0.83f, 0.03f}, {0.05f, 0.95f, 0.402f}, DRAWER}, /* left */
    {{0.55f, 0.83f, 0.03f}, {0.56f, 0.95f, 0.402f}, DRAWER}, /* right */
    {{0.05f, 0.83f, 0.03f}, {0.55f, 0.95f, 0.04f}, DRAWER},  /* back */
};
static const float size = 1;        /* of the cabinet: its height, m */
static const float touched = 0.01f; /* of its size: no more than that is the same place */

enum { WIDTH = 1280, HEIGHT = 720, FRAMES_A_STROKE = 20, FRAMES_OF_REST = 30 };

static dm_context* context;
static dm_object object;
static test_shape shape;

static int open_cabinet(void** state) {
    (void)state;
    assert_int_equal(dm_context_create(NULL, &context), DM_OK);
    for (int i = 0; i < BOXES; i++) test_shape_box(&shape, boxes[i].min, boxes[i].max, boxes[i].part);
    const dm_mesh_desc mesh = test_shape_desc(&shape);
    const dm_object_desc prepared = {
        .struct_size = sizeof prepared, .mesh = &mesh, .model = test_load_model(context), .seed = 1};
    assert_int_equal(dm_object_prepare(context, &prepared, &object), DM_OK);
    return 0;
}

static int close_cabinet(void** state) {
    (void)state;
    dm_context_destroy(context);
    return 0;
}

/* ---- a player ---- */

/* Pixels from the middle of the screen: right and down. */
typedef struct place {
    float x, y;
} place;

/* A place to look from, a point to grab, which is then in the middle of the screen, and how far to open the part. */
typedef struct player {
    uint32_t part;
    dm_vec3 eye, grab;
    float value; /* of the part's true joint */
} player;

static const player above_drawer = {DRAWER, {0.3f, 1.7f, 1.6f}, {0.3f, 0.88f, 0.45f}, 0.2f};
static const player high_above_drawer = {DRAWER, {0.3f, 2.4f, 1.3f}, {0.3f, 0.88f, 0.45f}, 0.2f};
static const player beside_drawer = {DRAWER, {1.5f, 1.3f, 1.5f}, {0.3f, 0.88f, 0.45f}, 0.2f};
static const player before_door = {DOOR, {0.3f, 1.3f, 1.7f}, {0.55f, 0.45f, 0.45f}, 0.9f};
static const player beside_door = {DOOR, {1.3f, 1.2f, 1.6f}, {0.55f, 0.45f, 0.45f}, 0.9f};

/* Where the true joint takes the grabbed point. */
static dm_vec3 opened(const player* p, float value) {
    const float x = p->grab.x, z = p->grab.z - 0.402f; /* from the door's hinge */
    if (p->part == DRAWER) return (dm_vec3){x, p->grab.y, p->grab.z + value};
    return (dm_vec3){x * cosf(value) - z * sinf(value), p->grab.y, 0.402f + x * sinf(value) + z * cosf(value)};
}

static dm_camera camera_of(const player* p) {
    return (dm_camera){.struct_size = sizeof(dm_camera),
                       .fov_y = 1,
                       .eye = p->eye,
                       .forward = {p->grab.x - p->eye.x, p->grab.y - p->eye.y, p->grab.z - p->eye.z},
                       .up = {0, 1, 0},
                       .viewport_width = WIDTH,
                       .viewport_height = HEIGHT};
}

static dm_drag grab_part(const player* p, uint32_t flags, const dm_part_state* state) {
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = p->part,
                               .object = object,
                               .grab_point = p->grab,
                               .flags = flags,
                               .state = state};
    dm_drag drag = 0;
    assert_int_equal(dm_drag_begin(context, &desc, &drag), DM_OK);
    return drag;
}

static float dot(dm_vec3 a, dm_vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* Returns the pixel of a point. */
static place on_screen(const player* p, dm_vec3 point) {
    const dm_camera camera = camera_of(p);
    const dm_vec3 f = camera.forward, to = {point.x - p->eye.x, point.y - p->eye.y, point.z - p->eye.z};
    const dm_vec3 right = {-f.z, 0, f.x}, up = {-f.x * f.y, f.x * f.x + f.z * f.z, -f.z * f.y};
    const float scale = 0.5f * HEIGHT / tanf(0.5f * camera.fov_y) * sqrtf(dot(f, f)) / dot(to, f);
    return (place){scale * dot(to, right) / sqrtf(dot(right, right)), -scale * dot(to, up) / sqrtf(dot(up, up))};
}

static dm_drag_state update(const player* p, dm_drag drag, place pointer) {
    const dm_camera camera = camera_of(p);
    const float x = 0.5f * WIDTH + pointer.x, y = 0.5f * HEIGHT + pointer.y;
    dm_drag_state now = dm_drag_state_default();
    dm_ray ray;
    assert_int_equal(dm_camera_ray(context, &camera, x, y, &ray), DM_OK);
    assert_int_equal(dm_drag_update(context, drag, &ray, 1.0f / 60, &now), DM_OK);
    return now;
}

/* Moves the pointer straight from the middle to a place and holds it there. */
static dm_drag_state go_to(const player* p, dm_drag drag, place to) {
    dm_drag_state now = dm_drag_state_default();
    for (int i = 0; i <= FRAMES_A_STROKE + FRAMES_OF_REST; i++) {
        const float share = fminf((float)i / FRAMES_A_STROKE, 1);
        now = update(p, drag, (place){share * to.x, share * to.y});
    }
    return now;
}

/* Moves the pointer along the true way of the grabbed point, to which it comes over from a place in the first half. */
static dm_drag_state open_from(const player* p, dm_drag drag, place from) {
    dm_drag_state now = dm_drag_state_default();
    for (int i = 0; i <= FRAMES_A_STROKE + FRAMES_OF_REST; i++) {
        const float share = fminf((float)i / FRAMES_A_STROKE, 1), left = fmaxf(1 - 2 * share, 0);
        const place on_way = on_screen(p, opened(p, share * p->value));
        now = update(p, drag, (place){on_way.x + left * from.x, on_way.y + left * from.y});
    }
    return now;
}

static dm_part_state let_go(dm_drag drag) {
    dm_part_state end = dm_part_state_default();
    assert_int_equal(dm_drag_end(context, drag, &end), DM_OK);
    return end;
}

/* Largest distance of the part's corners under two poses. */
static float apart(uint32_t part, const dm_pose* a, const dm_pose* b) {
    float most = 0;
    for (int i = 0; i < 8 * BOXES; i++) {
        const struct box* box = &boxes[i / 8];
        if (box->part != part) continue;
        float p[3], q[3], corner[3], sum = 0;
        for (int k = 0; k < 3; k++) corner[k] = i >> k & 1 ? box->max[k] : box->min[k];
        dm_pose_apply_points(a, corner, 0, p, 0, 1);
        dm_pose_apply_points(b, corner, 0, q, 0, 1);
        for (int k = 0; k < 3; k++) sum += (p[k] - q[k]) * (p[k] - q[k]);
        most = fmaxf(most, sqrtf(sum));
    }
    return most;
}

/* ---- pushed the wrong way first ---- */

static const float pushed_pixels[] = {3, 5, 8, 10, 16, 20, 40, 80};

/* The pointer against the part's way out, or across it. */
static place wrong_way(const player* p, float pixels, bool across) {
    const place out = on_screen(p, opened(p, 0.1f * p->value));
    const float share = pixels / hypotf(out.x, out.y);
    return across ? (place){share * out.y, -share * out.x} : (place){-share * out.x, -share * out.y};
}

/* Returns where the part ends by the joint that was found, whatever the pull says. */
static dm_pose open_by_joint(const player* p) {
    const dm_drag drag = grab_part(p, DM_DRAG_KEEP_JOINT, NULL);
    const dm_drag_state now = open_from(p, drag, (place){0, 0});
    let_go(drag);
    assert_true(fabsf(now.value - p->value) < 0.1f * p->value); /* it was found right, or this tests nothing */
    return now.pose;
}

static void assert_opens_after_a_push(const player* p) {
    const dm_pose right = open_by_joint(p);
    for (int across = 0; across < 2; across++) {
        for (size_t i = 0; i < sizeof pushed_pixels / sizeof *pushed_pixels; i++) {
            const place wrong = wrong_way(p, pushed_pixels[i], across != 0);
            const dm_drag drag = grab_part(p, 0, NULL);
            go_to(p, drag, wrong);
            const dm_drag_state end = open_from(p, drag, wrong);
            let_go(drag);
            const float off = apart(p->part, &end.pose, &right);
            if (off > touched * size)
                fail_msg("part %u, pushed by (%g, %g) px first: ends %g off", p->part, (double)wrong.x, (double)wrong.y,
                         (double)off);
        }
    }
}

static void a_part_pushed_the_wrong_way_first_opens(void** state) {
    (void)state;
    static const player* const players[] = {&above_drawer, &high_above_drawer, &beside_drawer, &before_door,
                                            &beside_door};
    for (size_t k = 0; k < sizeof players / sizeof *players; k++) assert_opens_after_a_push(players[k]);
}

/* ---- let go and grabbed again ---- */

/* The pull takes a part along a way that is not its joint's; the next grab begins where this one ended. */
static void a_part_grabbed_again_stays(void** state) {
    (void)state;
    static const place ways[] = {{0, 120}, {-60, 80}, {40, 120}, {-100, 20}};
    static const player* const players[] = {&above_drawer, &high_above_drawer, &before_door, &beside_door};
    uint32_t changes = 0;
    for (size_t k = 0; k < sizeof players / sizeof *players; k++) {
        for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
            const dm_drag first = grab_part(players[k], 0, NULL);
            const dm_drag_state last = go_to(players[k], first, ways[i]);
            changes += last.changes;
            const dm_part_state end = let_go(first);
            player again = *players[k];
            again.grab = last.grab_point;
            const dm_drag second = grab_part(&again, 0, &end);
            const dm_drag_state now = update(&again, second, (place){0, 0}); /* looks at the point where it is now */
            assert_true(apart(again.part, &now.pose, &last.pose) < 1e-4f * size);
            let_go(second);
        }
    }
    assert_true(changes > 0); /* or the joint in force would do */
}

/* ---- seen end on ---- */

/* A drawer looked at along its way shows no motion: a pull to any side brings it out, or leaves it shut. */
static void a_drawer_seen_end_on_stays_on_its_way(void** state) {
    (void)state;
    static const player front = {DRAWER, {0.3f, 0.88f, 2}, {0.3f, 0.88f, 0.45f}, 0.2f};
    static const place sides[] = {{0, -80}, {0, 80}, {-80, 0}, {80, 0}};
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        const dm_drag drag = grab_part(&front, 0, NULL);
        const dm_drag_state now = go_to(&front, drag, sides[i]);
        const dm_part_state end = let_go(drag);
        const float out = now.grab_point.z - front.grab.z;
        assert_true(fabsf(now.grab_point.x - front.grab.x) < touched * size);
        assert_true(fabsf(now.grab_point.y - front.grab.y) < touched * size);
        assert_true(out > -touched * size && out < 0.4f);
        assert_int_equal(end.joint.type, DM_JOINT_PRISMATIC);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_part_pushed_the_wrong_way_first_opens),
        cmocka_unit_test(a_part_grabbed_again_stays),
        cmocka_unit_test(a_drawer_seen_end_on_stays_on_its_way),
    };
    return cmocka_run_group_tests_name("hands", tests, open_cabinet, close_cabinet);
}
