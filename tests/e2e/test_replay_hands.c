/* Recorded sessions of all kinds of hands (tests/replay/hands): the part goes where the hand means it to be, along its
 * true joint, and does not jump. Nothing is compared with what came out before. Runs from the repository's root. */
#include <math.h>

#include "dragmesh/dragmesh.h"
#include "test_tool.h"

/* By hand, shares of the object's size or of the way. */
#define NEAR_GOAL 0.1    /* of the way: dragbot calls a part there that is within a tenth */
#define OFF_JOINT 0.05   /* of the size: the joint found is off by so much from the true one */
#define INTO_BODY 0.01   /* of the size, beyond the true limits; docs/feel.md counts the same */
#define REGRAB_JUMP 0.01 /* of the size, between the last pose before a new grab and the first one after it */
#define LEAP 0.06        /* of the size, in one frame: this hand pulls by less than a fiftieth */
#define STILL 1e-4       /* of the size: a part that does not move */

enum { FRAMES = 512 };

typedef struct meaning {
    char part[64];
    dm_joint joint; /* the true one */
    dm_vec3 point;
    float goal, size;
} meaning;

typedef struct recording {
    dm_pose poses[FRAMES]; /* of the part, by frame */
    int end;               /* frames */
    int presses[8], press_count, last_release;
} recording;

static tool_output out;

/* ---- reading ---- */

static void read_meaning(const char* name, meaning* m) {
    char path[TOOL_PATH], type[16] = "";
    size_t size;
    snprintf(path, sizeof path, "tests/replay/hands/%s.meant", name);
    char* text = tool_read(path, &size);
    dm_joint* j = &m->joint;
    *j = dm_joint_default();
    const int read = sscanf(text, "part %63[^\n]\n%15s %f %f %f %f %f %f %f %f\npoint %f %f %f\ngoal %f\nsize %f",
                            m->part, type, &j->axis.x, &j->axis.y, &j->axis.z, &j->origin.x, &j->origin.y, &j->origin.z,
                            &j->lower, &j->upper, &m->point.x, &m->point.y, &m->point.z, &m->goal, &m->size);
    free(text);
    if (read != 15) fail_msg("%s: %d of 15 words", path, read);
    j->type = strcmp(type, "prismatic") == 0 ? DM_JOINT_PRISMATIC : DM_JOINT_REVOLUTE;
}

/* When the hand takes hold and lets go. */
static void read_session(const char* path, recording* r) {
    size_t size;
    char* text = tool_read(path, &size);
    for (char *rest = text, *line; (line = strtok_r(rest, "\n", &rest));) {
        const int frame = (int)strtol(line, NULL, 10);
        if (strstr(line, " press left") && r->press_count < 8) r->presses[r->press_count++] = frame;
        if (strstr(line, " release left")) r->last_release = frame;
        if (strstr(line, " end")) r->end = frame;
    }
    free(text);
    assert_true(r->end < FRAMES && r->press_count > 0 && r->last_release > 0);
}

/* Number of a part in the viewer's output, "part 3 'door': 0". */
static unsigned find_part(const char* name) {
    char quoted[80];
    snprintf(quoted, sizeof quoted, " '%s':", name);
    const char* at = strstr(out.text, quoted);
    if (at == NULL) fail_msg("no part %s in: %s", name, out.text);
    while (at > out.text && strncmp(at, "part ", 5) != 0) at--;
    return (unsigned)strtoul(at + 5, NULL, 10);
}

/* The file has a line for each frame in which a part moved: frame, part, value, pose. */
static void read_poses(const char* path, unsigned part, recording* r) {
    size_t size;
    char* text = tool_read(path, &size);
    const dm_pose rest = {.real = {0, 0, 0, 1}};
    int known = 0;
    r->poses[0] = rest;
    for (char *next = text, *line; (line = strtok_r(next, "\n", &next));) {
        unsigned frame, id;
        dm_pose p;
        if (sscanf(line, "%u %u %*f %f %f %f %f %f %f %f %f", &frame, &id, &p.real[0], &p.real[1], &p.real[2],
                   &p.real[3], &p.dual[0], &p.dual[1], &p.dual[2], &p.dual[3]) != 10 ||
            id != part)
            continue;
        assert_true(frame < FRAMES);
        while (known < (int)frame) r->poses[known + 1] = r->poses[known], known++;
        r->poses[known] = p;
    }
    while (known < r->end) r->poses[known + 1] = r->poses[known], known++;
    free(text);
}

static void play(const char* name, meaning* m, recording* r) {
    char folder[TOOL_PATH], session[TOOL_PATH], poses[TOOL_PATH + 16];
    memset(r, 0, sizeof *r);
    snprintf(session, sizeof session, "tests/replay/hands/%s.session", name);
    read_meaning(name, m);
    read_session(session, r);
    tool_folder_make(folder);
    snprintf(poses, sizeof poses, "%s/poses", folder);
    tool_run(&out, "dragmesh_viewer", NULL,
             "tests/replay/cabinet_door/object.glb|--replay|%s|--dmo|tests/replay/hands/object.dmo|--models|none|"
             "--poses|%s",
             session, poses);
    if (out.status != 0) fail_msg("%s: %s", name, out.errors);
    read_poses(poses, find_part(m->part), r);
    tool_folder_remove(folder);
}

/* ---- what must hold ---- */

static dm_vec3 place(const dm_pose* pose, dm_vec3 point) {
    float p[3] = {point.x, point.y, point.z};
    dm_pose_apply_points(pose, p, 0, p, 0, 1);
    return (dm_vec3){p[0], p[1], p[2]};
}

static double distance(dm_vec3 a, dm_vec3 b) {
    return hypot(hypot((double)a.x - (double)b.x, (double)a.y - (double)b.y), (double)a.z - (double)b.z);
}

/* At the end of the pull the point is where the hand means it to be. */
static void expect_goal(const char* name, const meaning* m, const recording* r) {
    dm_pose there;
    assert_int_equal(dm_joint_pose(&m->joint, m->goal, &there), DM_OK);
    const dm_vec3 goal = place(&there, m->point), now = place(&r->poses[r->last_release], m->point);
    const double off = distance(goal, now), way = distance(goal, m->point);
    if (off > NEAR_GOAL * way) fail_msg("%s: %.3f off its goal, after a way of %.3f", name, off, way);
}

/* In no frame the part is off its true joint, or beyond its stop at rest: it goes through nothing. */
static void expect_true_joint(const char* name, const meaning* m, const recording* r) {
    for (int i = 0; i <= r->end; i++) {
        float value, angle, off;
        dm_pose nearest;
        assert_int_equal(dm_joint_value(&m->joint, &r->poses[i], &value, &angle, &off), DM_OK);
        const dm_joint* j = &m->joint;
        const float inside = fmaxf(value, j->lower);
        assert_int_equal(dm_joint_pose(j, value, &nearest), DM_OK);
        const double away = distance(place(&nearest, m->point), place(&r->poses[i], m->point));
        assert_int_equal(dm_joint_pose(j, inside, &nearest), DM_OK);
        const double beyond = distance(place(&nearest, m->point), place(&r->poses[i], m->point));
        if (away > OFF_JOINT * (double)m->size || (double)off > OFF_JOINT * (double)m->size)
            fail_msg("%s: frame %d is %.3f off the true joint", name, i, fmax(away, (double)off));
        if (beyond - away > INTO_BODY * (double)m->size) fail_msg("%s: frame %d is %.3f in the body", name, i, beyond);
    }
}

/* A new grab leaves the part where it is. */
static void expect_no_jump(const char* name, const meaning* m, const recording* r) {
    for (int k = 0; k < r->press_count; k++) {
        const int frame = r->presses[k];
        const double jump = distance(place(&r->poses[frame - 1], m->point), place(&r->poses[frame], m->point));
        if (jump > REGRAB_JUMP * (double)m->size) fail_msg("%s: jumps by %.4f in frame %d", name, jump, frame);
    }
}

/* In no frame the part leaps. */
static void expect_smooth(const char* name, const meaning* m, const recording* r) {
    for (int i = 1; i <= r->end; i++) {
        const double leap = distance(place(&r->poses[i - 1], m->point), place(&r->poses[i], m->point));
        if (leap > LEAP * (double)m->size) fail_msg("%s: leaps by %.4f in frame %d", name, leap, i);
    }
}

static void test_moves_smoothly(void** state) {
    meaning m;
    static recording r;
    play(*state, &m, &r);
    expect_no_jump(*state, &m, &r);
    expect_smooth(*state, &m, &r);
}

static void test_gets_there(void** state) {
    meaning m;
    static recording r;
    play(*state, &m, &r);
    expect_goal(*state, &m, &r);
    expect_no_jump(*state, &m, &r);
    expect_smooth(*state, &m, &r);
}

static void test_goes_its_way(void** state) {
    meaning m;
    static recording r;
    play(*state, &m, &r);
    expect_true_joint(*state, &m, &r);
    expect_no_jump(*state, &m, &r);
    expect_smooth(*state, &m, &r);
}

static void test_opens_as_meant(void** state) {
    test_gets_there(state);
    test_goes_its_way(state);
}

/* Taken hold of beside the point, and not moved for half a second. */
static void test_rests_in_a_resting_hand(void** state) {
    meaning m;
    static recording r;
    play(*state, &m, &r);
    const int until = r.presses[0] + 29; /* make_session.py: REST */
    for (int i = 0; i <= until; i++) {
        const double moved = distance(m.point, place(&r.poses[i], m.point));
        if (moved > STILL * (double)m.size) fail_msg("%s: moved by %.5f in frame %d", (const char*)*state, moved, i);
    }
    assert_true(distance(m.point, place(&r.poses[r.last_release], m.point)) > 0.1 * (double)m.size);
}

static int skip_without_viewer(void** state) {
    (void)state;
    char path[TOOL_PATH];
    tool_find("dragmesh_viewer", path);
    if (access(path, X_OK) == 0) return 0;
    print_message("skipped: the viewer is not built, SDL2 or libepoxy is missing (scripts/install viewer)\n");
    return 1;
}

#define HAND(name, test)                                                                                               \
    { #name, test, NULL, NULL, #name }

int main(void) {
    setenv("SDL_VIDEODRIVER", "offscreen", 1);
    setenv("XDG_RUNTIME_DIR", "/tmp", 0);
    if (skip_without_viewer(NULL)) return 0;
    /* Hands whose parts leave their true joint on the way, or for good, are known faults: docs/viewer.md. */
    const struct CMUnitTest tests[] = {
        HAND(door_followed, test_opens_as_meant),     HAND(door_straight, test_opens_as_meant),
        HAND(door_offset, test_opens_as_meant),       HAND(door_offset, test_rests_in_a_resting_hand),
        HAND(door_paused, test_opens_as_meant),       HAND(door_regrabbed, test_opens_as_meant),
        HAND(door_jostled, test_gets_there),          HAND(door_unsteady, test_gets_there),
        HAND(door_along_axis, test_moves_smoothly),   HAND(drawer_followed, test_opens_as_meant),
        HAND(drawer_along_axis, test_opens_as_meant), HAND(drawer_jostled, test_opens_as_meant),
        HAND(drawer_regrabbed, test_opens_as_meant),  HAND(drawer_from_above, test_goes_its_way),
        HAND(drawer_end_on_down, test_goes_its_way),  HAND(drawer_end_on_up, test_goes_its_way),
        HAND(drawer_end_on_left, test_goes_its_way),  HAND(drawer_end_on_right, test_goes_its_way)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
