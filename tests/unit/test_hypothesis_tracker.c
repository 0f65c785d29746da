/* The pull identifies the joint early, without a jump, in any axes; tremor of the hand does not change it. */
#include "test_math.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "drag/drag.h"
#include "drag/joint_hypothesis.h"
#include "math/frames.h"
#include "math/linear3.h"

#define FRAME (1.0f / 60)

/* A front panel that might slide out, or swing on either side, or on its lower edge. */
enum { SLIDES, LEFT, RIGHT, LOWER, JOINTS };
static const dm_joint joints[JOINTS] = {
    {.type = DM_JOINT_PRISMATIC, .joint_confidence = 0.5f, .axis = {0, 0, 1}, .upper = 0.5f},
    {.type = DM_JOINT_REVOLUTE, .joint_confidence = 0.3f, .axis = {0, -1, 0}, .origin = {-0.5f, 0, 0}, .upper = 1.57f},
    {.type = DM_JOINT_REVOLUTE, .joint_confidence = 0.1f, .axis = {0, 1, 0}, .origin = {0.5f, 0, 0}, .upper = 1.57f},
    {.type = DM_JOINT_REVOLUTE, .joint_confidence = 0.1f, .axis = {1, 0, 0}, .origin = {0, -0.5f, 0}, .upper = 1.57f},
};
static const float handle[3] = {0.3f, 0.3f, 0.02f}, eye[3] = {1.2f, 1.4f, 3};

static dm_ray ray_to(const float from[3], const float point[3]) {
    return (dm_ray){dmi_vec3(from), {point[0] - from[0], point[1] - from[1], point[2] - from[2]}};
}

static void point_on(const dm_joint* joint, float value, float out[3]) {
    const dm_pose pose = dmi_joint_pose(joint, value);
    dmi_pose_apply(&pose, handle, out);
}

typedef struct pulled {
    dmi_drag drag;
    dm_drag_state now;
    float longest_step; /* of the grabbed point between two frames */
    int decided;        /* the frame of the last change */
} pulled;

/* Pulls along `truth` to `to` in `frames`, then holds on for the blend. */
/* Slides along the axes, as a last resort. */
static void add_slides(dmi_hypothesis_tracker* tracker) {
    for (int i = 0; i < 3; i++)
        dmi_hypothesis_tracker_add_slide(tracker, (dm_vec3){i == 0, i == 1, i == 2}, dmi_unbounded_range());
}

static pulled pull(const dm_joint* truth, float to, int frames, float tremor) {
    pulled p = {.decided = -1};
    dmi_random random = dmi_random_make(9, 9);
    const dm_drag_feel feel = {0};
    float last[3], point[3];
    uint32_t changes = 0;
    dmi_drag_begin(&p.drag, &joints[SLIDES], handle, 0, &feel);
    dmi_drag_track_hypotheses(&p.drag, joints, NULL, JOINTS, 1, (dmi_limit_give){.length = 4});
    add_slides(&p.drag.tracker);
    memcpy(last, handle, sizeof last);
    for (int k = 0; k <= frames + 60; k++) {
        point_on(truth, to * fminf((float)k / (float)frames, 1), point);
        for (int i = 0; i < 3; i++) point[i] += tremor * dmi_random_normal(&random);
        const dm_ray ray = ray_to(eye, point);
        dmi_drag_update(&p.drag, &ray, FRAME, &p.now);
        p.longest_step = fmaxf(p.longest_step, (float)test_distance(last, dmi_xyz(p.now.grab_point).v));
        memcpy(last, dmi_xyz(p.now.grab_point).v, sizeof last);
        if (p.now.changes != changes) p.decided = k, changes = p.now.changes;
    }
    return p;
}

static void the_pull_tells_the_joint(void** state) {
    (void)state;
    for (int i = 0; i < JOINTS; i++) {
        const float to = i == SLIDES ? 0.4f : 1.4f;
        const pulled p = pull(&joints[i], to, 120, 0);
        float there[3];
        point_on(&joints[i], to, there);
        assert_near3(dmi_xyz(p.now.grab_point).v, there, 0.02);
        assert_int_equal(p.drag.joint.type, joints[i].type);
        assert_near3(dmi_xyz(p.drag.joint.axis).v, dmi_xyz(joints[i].axis).v, 0);
        assert_near(p.now.value, to, 0.02);
        assert_true(p.longest_step < 0.06f);
        const dm_pose pose = dmi_joint_pose(&p.drag.joint, p.now.value); /* on the joint again */
        assert_same_motion(&pose, &p.now.pose, 1, 1e-6);
        assert_true(dmi_hypothesis_tracker_confidence(&p.drag.tracker) > 0.3f);
    }
}

/* Straight to where the door should be, or straight out: then the drawer that was inferred stays. */
static void a_hand_may_cut_the_corner(void** state) {
    (void)state;
    for (int slides = 0; slides < 2; slides++) {
        dm_joint two[2] = {joints[LEFT], joints[SLIDES]};
        two[0].joint_confidence = slides ? 0.2f : 0.6f;
        const dm_drag_feel feel = {0};
        dmi_drag drag;
        dm_drag_state now;
        float there[3], point[3];
        point_on(&two[slides], slides ? 0.4f : 1.2f, there);
        dmi_drag_begin(&drag, &two[0], handle, 0, &feel);
        dmi_drag_track_hypotheses(&drag, two, NULL, 2, 1, (dmi_limit_give){.length = 4});
        for (int k = 0; k <= 180; k++) {
            const float share = fminf((float)k / 120, 1);
            for (int i = 0; i < 3; i++) point[i] = handle[i] + share * (there[i] - handle[i]);
            const dm_ray ray = ray_to(eye, point);
            dmi_drag_update(&drag, &ray, FRAME, &now);
        }
        assert_int_equal(drag.joint.type, two[slides].type);
        assert_near3(dmi_xyz(now.grab_point).v, there, 0.02);
    }
}

/* By twice as much as the drag takes for granted: it may waver, and comes to the same. */
static void a_hand_that_trembles_decides_the_same(void** state) {
    (void)state;
    for (int i = 0; i < JOINTS; i++) {
        const pulled p = pull(&joints[i], i == SLIDES ? 0.4f : 1.4f, 120, 0.003f);
        assert_int_equal(p.drag.joint.type, joints[i].type);
        assert_near3(dmi_xyz(p.drag.joint.axis).v, dmi_xyz(joints[i].axis).v, 0);
        assert_true(p.now.changes <= 3);
        assert_true(p.longest_step < 0.08f);
    }
}

/* Lines all over the panel, none of which explains how it is pulled, and the right one among the last. */
static void add_alternatives(dmi_drag* drag, const dm_joint* right) {
    for (int k = 0; k < 80; k++) {
        const float x = 0.1f * (float)(k % 8) - 0.35f, y = 0.1f * (float)(k / 8) - 0.35f;
        dm_joint other = {.type = DM_JOINT_REVOLUTE, .joint_confidence = 0.01f, .axis = {0, 0, 1}, .origin = {x, y, 0}};
        if (k == 37) other = *right, other.joint_confidence = right->type == DM_JOINT_PRISMATIC ? 0.05f : 0.005f;
        dmi_hypothesis_tracker_add_alternative(&drag->tracker, &other, dmi_unbounded_range());
    }
}

/* How far off the grabbed point was at most while an alternative was pulled from `from` to `to`. */
static float pull_alternative(dmi_drag* drag, const dm_joint* joint, float from, float to, dm_drag_state* now) {
    float point[3], off = 0;
    for (int k = 0; k <= 120; k++) {
        point_on(joint, from + (to - from) * (float)k / 120, point);
        const dm_ray ray = ray_to(eye, point);
        dmi_drag_update(drag, &ray, FRAME, now);
        off = fmaxf(off, (float)test_distance(point, dmi_xyz(now->grab_point).v));
    }
    return off;
}

static void an_alternative_takes_over(void** state) {
    (void)state;
    static const dm_joint slide = {.type = DM_JOINT_PRISMATIC, .axis = {0.8f, -0.6f, 0}};
    const dm_joint* right[] = {&joints[LEFT], &joints[RIGHT], &joints[LOWER], &slide};
    for (int i = 0; i < 4; i++) {
        const int slides = right[i]->type == DM_JOINT_PRISMATIC;
        const dm_drag_feel feel = {0};
        const float to = slides ? -0.6f : 1.4f;
        dmi_drag drag;
        dm_drag_state now = {0};
        dmi_drag_begin(&drag, &joints[SLIDES], handle, 0, &feel);
        dmi_drag_track_hypotheses(&drag, joints, NULL, 1, 1, (dmi_limit_give){.length = 4});
        add_alternatives(&drag, right[i]);
        assert_int_equal(drag.tracker.count, DMI_TRACKED_HYPOTHESES); /* what is too many is left out */
        assert_near(pull_alternative(&drag, right[i], 0, to, &now), 0, 0.2);
        assert_int_equal(drag.joint.type, slides ? DM_JOINT_PRISMATIC : DM_JOINT_CONTINUOUS);
        assert_near3(dmi_xyz(drag.joint.axis).v, dmi_xyz(right[i]->axis).v, 0);
        assert_near(now.value, to, 0.03);
        /* A slide has come out of its stop; nothing is known of a turn's. */
        pull_alternative(&drag, right[i], to, slides ? 0.3f : -0.3f, &now);
        assert_near(now.value, slides ? 0 : -0.3f, slides ? 1e-6 : 0.03);
    }
}

/* A panel pulled the way its range does not lie opens to the other side. */
static void the_pull_tells_the_side(void** state) {
    (void)state;
    const dm_joint door = joints[LEFT];
    const dm_drag_feel feel = {0};
    dmi_drag drag;
    dm_drag_state now = {0};
    dmi_drag_begin(&drag, &door, handle, 0, &feel);
    dmi_drag_track_hypotheses(&drag, &door, NULL, 1, 1, (dmi_limit_give){.length = 4});
    for (int k = 0; k <= 150; k++) {
        float point[3];
        point_on(&door, -1.2f * fminf((float)k / 120, 1), point);
        const dm_ray ray = ray_to(eye, point);
        dmi_drag_update(&drag, &ray, FRAME, &now);
    }
    assert_near(now.value, -1.2f, 0.01);
    assert_int_equal(now.changes, 1);
    assert_true(drag.joint.lower < -1.5f && drag.joint.upper == 0);
    dmi_drag_begin(&drag, &door, handle, 0, &feel); /* a joint that is sure has its stop */
    for (int k = 0; k <= 150; k++) {
        float point[3];
        point_on(&door, -1.2f * fminf((float)k / 120, 1), point);
        const dm_ray ray = ray_to(eye, point);
        dmi_drag_update(&drag, &ray, FRAME, &now);
        assert_near(now.value, 0, 1e-6);
    }
}

/* A right-hand door pulled straight to the right and down, seen from its hinge's side: its handle goes that way where
 * it opens wide, and at first where it swings inwards. The body leaves less room inwards than the range. */
static void a_door_does_not_swing_into_its_body(void** state) {
    (void)state;
    const dm_joint door = {
        .type = DM_JOINT_REVOLUTE, .joint_confidence = 0.7f, .axis = {0, 1, 0}, .origin = {0.5f, 0, 0}, .upper = 1.8f};
    const float knob[3] = {-0.4f, 0, 0.02f}, from[3] = {3, 1.2f, 3}, way[3] = {0.4f, -0.56f, -0.4f};
    for (int blocked = 0; blocked < 2; blocked++) {
        const dmi_free_range room = {blocked ? -1.2f : -FLT_MAX, FLT_MAX};
        const dm_drag_feel feel = {0};
        dmi_drag drag;
        dm_drag_state now = {0};
        dmi_drag_begin(&drag, &door, knob, 0, &feel);
        dmi_drag_track_hypotheses(&drag, &door, &room, 1, 1, (dmi_limit_give){.length = 4});
        add_slides(&drag.tracker);
        for (int k = 0; k <= 120; k++) {
            float point[3];
            for (int i = 0; i < 3; i++) point[i] = knob[i] + 0.8f * fminf((float)k / 60, 1) * way[i];
            const dm_ray ray = ray_to(from, point);
            dmi_drag_update(&drag, &ray, FRAME, &now);
        }
        assert_int_equal(drag.joint.type, DM_JOINT_REVOLUTE);
        assert_int_equal(drag.joint.lower < 0, !blocked);
        assert_int_equal(now.value < -0.1f, !blocked);
    }
}

/* A drawer that is pushed back does not come out behind. */
static void what_was_opened_shuts_at_rest(void** state) {
    (void)state;
    const dm_joint drawer = joints[SLIDES];
    const dm_drag_feel feel = {0};
    dmi_drag drag;
    dm_drag_state now = {0};
    dmi_drag_begin(&drag, &drawer, handle, 0, &feel);
    dmi_drag_track_hypotheses(&drag, &drawer, NULL, 1, 1, (dmi_limit_give){.length = 4});
    for (int k = 0; k <= 240; k++) {
        float point[3];
        point_on(&drawer, k <= 80 ? 0.3f * (float)k / 80 : 0.3f - 0.8f * (float)(k - 80) / 160, point);
        const dm_ray ray = ray_to(eye, point);
        dmi_drag_update(&drag, &ray, FRAME, &now);
        if (k == 80) assert_near(now.value, 0.3f, 0.02);
    }
    assert_near(now.value, 0, 1e-6);
    assert_int_equal(now.changes, 0);
}

/* A drawer whose side was found wrong opens as soon as it is pulled farther out than it was pushed in. */
static void a_jostle_is_undone_by_as_much(void** state) {
    (void)state;
    const dm_joint drawer = joints[SLIDES];
    const dm_drag_feel feel = {0};
    const float jostle = 0.1f, out = -0.16f;
    dmi_drag drag;
    dm_drag_state now = {0};
    dmi_drag_begin(&drag, &drawer, handle, 0, &feel);
    dmi_drag_track_hypotheses(&drag, &drawer, NULL, 1, 1, (dmi_limit_give){.length = 4});
    for (int k = 0; k <= 120; k++) {
        float point[3];
        point_on(&drawer, k <= 40 ? jostle * (float)k / 40 : jostle + (out - jostle) * (float)(k - 40) / 80, point);
        const dm_ray ray = ray_to(eye, point);
        dmi_drag_update(&drag, &ray, FRAME, &now);
        if (k == 40) assert_near(now.value, jostle, 0.02);
    }
    assert_near(now.value, out, 0.02);
    assert_int_equal(now.changes, 1);
}

/* A pull that is seen across the way of every joint takes the part along. */
static void nothing_is_stuck(void** state) {
    (void)state;
    static const float before[3] = {0.3f, 1.4f, 3}; /* from there all of them move up or down the screen at first */
    const dm_joint sideways = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}};
    const dm_drag_feel feel = {0};
    dmi_drag drag;
    dm_drag_state now = {0};
    float there[3];
    dmi_drag_begin(&drag, &joints[SLIDES], handle, 0, &feel);
    dmi_drag_track_hypotheses(&drag, joints, NULL, JOINTS, 1, (dmi_limit_give){.length = 4});
    add_slides(&drag.tracker);
    for (int k = 0; k <= 120; k++) {
        point_on(&sideways, 0.6f * (float)k / 120, there);
        const dm_ray ray = ray_to(before, there);
        dmi_drag_update(&drag, &ray, FRAME, &now);
    }
    assert_near3(dmi_xyz(now.grab_point).v, there, 0.02);
}

static void half_the_step_is_the_same_drag(void** state) {
    (void)state;
    for (int i = 0; i < JOINTS; i++) {
        const float to = i == SLIDES ? 0.4f : 1.4f;
        const dm_drag_feel feel = {0};
        float ends[2];
        for (int fine = 0; fine < 2; fine++) {
            dmi_drag drag;
            dm_drag_state now = {0};
            const int steps = fine ? 240 : 120;
            dmi_drag_begin(&drag, &joints[SLIDES], handle, 0, &feel);
            dmi_drag_track_hypotheses(&drag, joints, NULL, JOINTS, 1, (dmi_limit_give){.length = 4});
            for (int k = 0; k <= steps; k++) {
                float point[3];
                point_on(&joints[i], to * (float)k / (float)steps, point);
                const dm_ray ray = ray_to(eye, point);
                dmi_drag_update(&drag, &ray, 2.0f / (float)steps, &now);
            }
            ends[fine] = now.value;
        }
        assert_near(ends[0], ends[1], 0.01 * (double)to);
    }
}

static void host_axes_do_not_matter(void** state) {
    (void)state;
    for (int axes = 0; axes < 4; axes++) {
        for (int i = 0; i < JOINTS; i++) {
            dmi_frame frame = {.size = 0.8, .centre = {0.3, -0.2, 5}};
            assert_true(dmi_axes_init(&frame.axes, axes, NULL, 0.01f));
            dm_joint host[JOINTS];
            for (int k = 0; k < JOINTS; k++) host[k] = dmi_frame_joint_out(&frame, &joints[k]);
            float host_handle[3], host_eye[3], point[3], host_point[3];
            dmi_frame_point_out(&frame, handle, host_handle);
            dmi_frame_point_out(&frame, eye, host_eye);
            const dm_drag_feel feel = {0};
            const float unit = dmi_frame_length_out(&frame), to = i == SLIDES ? 0.4f : 1.4f;
            dmi_drag inner, outer;
            dm_drag_state a, b;
            dmi_drag_begin(&inner, &joints[SLIDES], handle, 0, &feel);
            dmi_drag_track_hypotheses(&inner, joints, NULL, JOINTS, 1, (dmi_limit_give){.length = 4});
            dmi_drag_begin(&outer, &host[SLIDES], host_handle, 0, &feel);
            dmi_drag_track_hypotheses(&outer, host, NULL, JOINTS, unit, (dmi_limit_give){.length = 4 * unit});
            for (int k = 0; k <= 120; k++) {
                point_on(&joints[i], to * (float)k / 120, point);
                dmi_frame_point_out(&frame, point, host_point);
                const dm_ray ray = ray_to(eye, point), host_ray = ray_to(host_eye, host_point);
                dmi_drag_update(&inner, &ray, FRAME, &a);
                dmi_drag_update(&outer, &host_ray, FRAME, &b);
            }
            assert_int_equal(inner.joint.type, outer.joint.type);
            assert_near(b.value, a.value * (i == SLIDES ? unit : 1), 2e-3 * (double)(i == SLIDES ? unit : 1));
            dmi_frame_point_out(&frame, dmi_xyz(a.grab_point).v, host_point);
            assert_near3(dmi_xyz(b.grab_point).v, host_point, 2e-3 * (double)unit);
        }
    }
}

/* A turn about an axis a hair beside the grabbed point explains every small pull, by a large angle: its prior is
 * lower, that of an axis far off is not. */
static void no_turn_about_the_grabbed_point(void** state) {
    (void)state;
    static const dm_joint panel[2] = {
        {.type = DM_JOINT_PRISMATIC, .joint_confidence = 0.5f, .axis = {0, 0, 1}, .upper = 0.5f},
        {.type = DM_JOINT_REVOLUTE,
         .joint_confidence = 0.5f,
         .axis = {0, 0, 1},
         .origin = {0.29f, 0.3f, 0},
         .upper = 3.0f}};
    static const dm_joint far_off = {
        .type = DM_JOINT_REVOLUTE, .joint_confidence = 0.5f, .axis = {0, 0, 1}, .origin = {-0.5f, 0, 0}, .upper = 3.0f};
    dmi_hypothesis_tracker tracker;
    dmi_hypothesis_tracker_init(&tracker, panel, NULL, 2, handle, 1, (dmi_limit_give){.length = 4});
    dmi_hypothesis_tracker_add_alternative(&tracker, &far_off, dmi_unbounded_range());
    assert_near(tracker.list[0].log_prior, 0, 1e-6);
    assert_true(tracker.list[1].log_prior < -1);
    assert_true(tracker.list[tracker.count - 1].log_prior > -0.5f);
}

/* Hypotheses whose likelihood overflowed are not updated in the place of others. */
static void what_is_no_number_is_not_waited_for(void** state) {
    (void)state;
    enum { ALONG_X = JOINTS, ALONG_Y }; /* the last resorts; along z there is a slide already */
    dmi_hypothesis_tracker tracker;
    dmi_hypothesis_tracker_init(&tracker, joints, NULL, JOINTS, handle, 1, (dmi_limit_give){.length = 4});
    add_slides(&tracker);
    tracker.priority[LEFT] = tracker.priority[RIGHT] = tracker.priority[LOWER] = NAN;
    dm_ray ray = ray_to(eye, (const float[3]){handle[0] + 0.1f, handle[1], handle[2]});
    dmi_float3 direction = dmi_xyz(ray.direction);
    dmi_normalize3(direction.v);
    ray.direction = dmi_vec3(direction.v);
    dmi_hypothesis_tracker_update(&tracker, 0, &ray, DMI_PERSPECTIVE);
    assert_near(tracker.list[ALONG_X].pointer_value, 0.1f, 1e-4);
    assert_true(tracker.list[ALONG_Y].max_residual > 0);
    for (int i = LEFT; i <= LOWER; i++) assert_near(tracker.list[i].max_residual, 0, 0);
}

/* ---- one hypothesis against its formulas ---- */

enum { DOOR, DRAWER, BOTH, WHEEL, SCREW, DOWN, KINDS };
static const dm_joint kinds[KINDS] = {
    {.type = DM_JOINT_REVOLUTE, .axis = {0, -1, 0}, .origin = {-0.5f, 0, 0}, .lower = 0, .upper = 2},
    {.type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}, .lower = 0, .upper = 0.6f},
    {.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}, .origin = {0.5f, 0, 0}, .lower = -1, .upper = 1.4f},
    {.type = DM_JOINT_CONTINUOUS, .axis = {0, 1, 0}, .origin = {0.5f, 0, 0}},
    {.type = DM_JOINT_SCREW, .axis = {0, 1, 0}, .origin = {0.5f, 0, 0}, .lower = -3, .upper = 0, .pitch = 0.1f},
    {.type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}, .lower = -0.5f, .upper = 0},
};

static dmi_grasp grasp_of(float size, dmi_limit_give give) {
    dmi_grasp grasp = {.size = size, .limit_give = give};
    dmi_pull_begin(&grasp.pull, handle, 0.006f * size);
    return grasp;
}

static dmi_joint_hypothesis made(const dmi_grasp* grasp, const dm_joint* joint, dmi_free_range range) {
    return dmi_joint_hypothesis_make(grasp, joint, 0, false, range);
}

static void odds_are_those_of_the_confidence(void** state) {
    (void)state;
    for (int k = 0; k <= 20; k++) {
        const dm_joint joint = {.type = DM_JOINT_REVOLUTE, .joint_confidence = 0.05f * (float)k};
        const double p = fmin(fmax((double)joint.joint_confidence, 1e-3), 1 - 1e-3);
        assert_near(dmi_joint_log_odds(&joint), 0.85 * log(p / (1 - p)), 2e-5);
    }
}

/* Half the logarithm of the lever over 0.15 of the part, from a twentieth of that to it. */
static void a_short_lever_lowers_the_prior(void** state) {
    (void)state;
    for (int k = 0; k <= 40; k++) {
        for (float size = 0.5f; size < 3; size *= 2) {
            const dmi_grasp grasp = grasp_of(size, (dmi_limit_give){0});
            const float arm = 0.005f * (float)k * size;
            const dm_joint turn = {.type = k % 2 ? DM_JOINT_REVOLUTE : DM_JOINT_SCREW,
                                   .axis = {0, 0, 1},
                                   .origin = {handle[0] + 0.6f * arm, handle[1] - 0.8f * arm, 5}},
                           slide = {.type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}, .origin = turn.origin};
            const double share = fmin(fmax((double)arm / (0.15 * (double)size), 0.05), 1);
            assert_near(dmi_lever_arm_log_prior(&grasp, &turn), 0.5 * log(share), 2e-4);
            assert_near(dmi_lever_arm_log_prior(&grasp, &slide), 0, 0);
            const dmi_joint_hypothesis hypothesis =
                dmi_joint_hypothesis_make(&grasp, &turn, -1.5f, true, dmi_unbounded_range());
            assert_near(hypothesis.log_prior, -1.5 + 0.5 * log(share), 2e-4);
            assert_near(hypothesis.log_posterior, hypothesis.log_prior, 0);
            assert_true(hypothesis.range_unknown && !hypothesis.grabbed);
        }
    }
}

/* Of one type, within 20 mrad, the lines of turns within 1/50 of the part; either sign of the axis. */
static void joints_alike_are_within_their_tolerances(void** state) {
    (void)state;
    const dm_joint door = kinds[DOOR];
    const struct {
        float angle, x, y;
        int32_t type;
        bool alike, slides_alike;
    } cases[] = {{0, 0, 0, DM_JOINT_REVOLUTE, true, true},
                 {0, 0.039f, 0, DM_JOINT_REVOLUTE, true, true},
                 {0, -0.041f, 0, DM_JOINT_REVOLUTE, false, true},
                 {0, 0, 3, DM_JOINT_REVOLUTE, true, true},
                 {0.0199f, 0, 0, DM_JOINT_REVOLUTE, true, true},
                 {0.0201f, 0, 0, DM_JOINT_REVOLUTE, false, false},
                 {3.14159265f, 0.03f, 0, DM_JOINT_REVOLUTE, true, true},
                 {0, 0, 0, DM_JOINT_SCREW, false, false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        dm_joint other = door;
        other.axis = (dm_vec3){sinf(cases[i].angle), -cosf(cases[i].angle), 0};
        other.origin.x += cases[i].x, other.origin.y += cases[i].y;
        other.type = cases[i].type;
        assert_int_equal(dmi_joints_alike(&door, &other, 2), cases[i].alike);
        dm_joint slide = door, along = other;
        slide.type = DM_JOINT_PRISMATIC;
        if (other.type == DM_JOINT_REVOLUTE) along.type = DM_JOINT_PRISMATIC;
        assert_int_equal(dmi_joints_alike(&slide, &along, 2), cases[i].slides_alike);
    }
}

/* A range that begins within 1/20 of itself from rest lies on one side; where too little of the other side is free, it
 * is blocked: less than a quarter of a slide's range, or less than all of a turn's. */
static void a_range_has_a_side_and_maybe_a_blocked_one(void** state) {
    (void)state;
    const dmi_grasp grasp = grasp_of(1, (dmi_limit_give){0});
    const struct {
        float lower, upper, side;
    } cases[] = {{0, 1, 1},
                 {-1, 0, -1},
                 {-0.5f, 0.5f, 0},
                 {0.049f, 1.049f, 1},
                 {0.051f, 1.051f, 0},
                 {-0.049f, 0.951f, 1},
                 {-0.051f, 0.949f, 0},
                 {-0.951f, 0.049f, -1},
                 {-0.949f, 0.051f, 0},
                 {1, 1, 0}};
    for (size_t i = 0; i < 2 * sizeof cases / sizeof *cases; i++) {
        const bool turns = i % 2;
        const float lower = cases[i / 2].lower, upper = cases[i / 2].upper, side = cases[i / 2].side;
        const dm_joint joint = {
            .type = turns ? DM_JOINT_REVOLUTE : DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = lower, .upper = upper};
        for (int blocked = 0; blocked < 2; blocked++) {
            const float room = (turns ? 1 : 0.25f) + (blocked ? -0.001f : 0.001f);
            const dmi_free_range range = side > 0 ? (dmi_free_range){-room, 9} : (dmi_free_range){-9, room};
            const dmi_joint_hypothesis hypothesis = made(&grasp, &joint, range);
            assert_near(hypothesis.side, side, 0);
            assert_int_equal(hypothesis.other_side_blocked, blocked && side != 0);
            for (int sign = -1; sign <= 1; sign++)
                assert_int_equal(dmi_joint_hypothesis_is_pushed_shut(&hypothesis, 0.1f * (float)sign),
                                 blocked && side * (float)sign < 0);
        }
    }
}

static void a_pull_reaches_beyond_estimates_alone(void** state) {
    (void)state;
    const struct {
        int kind;
        dmi_limit_give give;
        float lower, upper;
    } cases[] = {{DOOR, {0, 3}, 0, 2 + 6.2831853f}, {DRAWER, {0, 3}, 0, 3.6f},           {DRAWER, {0.5f, 3}, 0, 0.9f},
                 {DRAWER, {-1, 3}, 0, 0.6f},        {BOTH, {0.25f, 3}, -1.6f, 2},        {SCREW, {0.1f, 3}, -3.3f, 0},
                 {DOWN, {0, 2}, -2.5f, 0},          {WHEEL, {0, 3}, -INFINITY, INFINITY}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const dmi_grasp grasp = grasp_of(1, cases[i].give);
        const dmi_joint_hypothesis hypothesis = made(&grasp, &kinds[cases[i].kind], dmi_unbounded_range());
        float lower, upper;
        dmi_joint_reachable_range(&kinds[cases[i].kind], cases[i].give, &lower, &upper);
        if (lower > -INFINITY) assert_near(lower, cases[i].lower, 1e-6);
        if (upper < INFINITY) assert_near(upper, cases[i].upper, 1e-6);
        assert_true((lower == -INFINITY) == (cases[i].lower == -INFINITY) &&
                    (upper == INFINITY) == (cases[i].upper == INFINITY));
        dmi_joint_hypothesis_range(&grasp, &hypothesis, &lower, &upper);
        const float most = fmaxf(-cases[i].lower, cases[i].upper);
        const bool one_side = hypothesis.side != 0;
        if (upper < INFINITY) assert_near(upper, one_side ? most : cases[i].upper, 1e-6);
        if (lower > -INFINITY) assert_near(lower, one_side ? -most : cases[i].lower, 1e-6);
    }
    dmi_grasp grasp = grasp_of(1, (dmi_limit_give){0, 3});
    dmi_joint_hypothesis unknown =
        dmi_joint_hypothesis_make(&grasp, &kinds[DRAWER], 0, true, (dmi_free_range){-0.2f, 5});
    float lower, upper;
    dmi_joint_hypothesis_range(&grasp, &unknown, &lower, &upper);
    assert_true(lower == -0.2f && upper == 5);
    for (int grabbed = 0; grabbed < 2; grabbed++) { /* a slide seen end on tells nothing of its limits */
        for (int kind = DOOR; kind <= DRAWER; kind++) {
            const float toward = kind == DOOR ? 0.025f : 0, way[3] = {toward, 0, 1};
            dmi_joint_hypothesis seen = made(&grasp, &kinds[kind], dmi_unbounded_range());
            seen.grabbed = grabbed;
            memcpy(grasp.pull.pointer.sight, way, sizeof way);
            dmi_joint_hypothesis_range(&grasp, &seen, &lower, &upper);
            const bool stated = grabbed && kind == DRAWER;
            assert_near(upper, stated ? 0.6f : kind == DRAWER ? 3.6f : 2 + 6.2831853f, 1e-5);
            assert_near(lower, stated ? 0 : -upper, 0);
            if (grabbed) assert_near(dmi_joint_hypothesis_log_likelihood(&grasp, &seen, 1), 0, 0);
        }
    }
}

/* The side that the pull went to most is its side: to leave the stated one it must go 3.5 times what exceeds a jostle
 * of 0.15 of the part, to come back half. */
static void a_side_costs_by_how_far_the_pull_went(void** state) {
    (void)state;
    const float size = 1.5f;
    const dmi_grasp grasp = grasp_of(size, (dmi_limit_give){0});
    const double arms[] = {hypot((double)handle[0] + 0.5, (double)handle[2]), 1,
                           hypot((double)handle[0] - 0.5, (double)handle[2])};
    const int which[] = {DOOR, DRAWER, SCREW};
    for (int i = 0; i < 3; i++) {
        for (int far = 0; far < 2; far++) {
            for (int blocked = 0; blocked < 2; blocked++) {
                dmi_joint_hypothesis hypothesis = made(&grasp, &kinds[which[i]], dmi_unbounded_range());
                const float side = hypothesis.side;
                hypothesis.other_side_blocked = blocked;
                hypothesis.excursion[side > 0] = far ? 0.5f : 0.1f; /* on the stated side */
                hypothesis.excursion[side < 0] = 0.3f;
                const double jostle = 0.15 * (double)size / arms[i], was = far ? 0.5 : 0.1;
                const double out = was > jostle ? jostle + 3.5 * (was - jostle) : was, back = 0.5 * 0.3;
                for (int k = -40; k <= 40; k++) {
                    const float value = 0.05f * (float)k;
                    const bool leaves = side * value < 0;
                    const double limit = leaves ? out : back, less = limit - fabs((double)value);
                    double wanted = (less > 0 ? -4 * less / limit : 0) + (leaves ? -0.2 : 0);
                    if (blocked) wanted = leaves ? -1.5 : 0;
                    assert_near(dmi_joint_hypothesis_side_log_prior(&grasp, &hypothesis, value), wanted, 1e-4);
                }
            }
        }
    }
    const dmi_joint_hypothesis both = made(&grasp, &kinds[BOTH], dmi_unbounded_range());
    assert_near(dmi_joint_hypothesis_side_log_prior(&grasp, &both, -0.5f), 0, 0);
}

/* A joint gets the side of the pull unless that is blocked; one without a range gets it inside what is free. */
static void a_joint_adopts_the_side_of_the_pull(void** state) {
    (void)state;
    const dmi_grasp grasp = grasp_of(2, (dmi_limit_give){0});
    for (int sign = -1; sign <= 1; sign += 2) {
        dmi_joint_hypothesis door = made(&grasp, &kinds[DOOR], dmi_unbounded_range()), blocked = door,
                             both = made(&grasp, &kinds[BOTH], dmi_unbounded_range());
        door.pointer_value = blocked.pointer_value = both.pointer_value = 0.3f * (float)sign;
        blocked.other_side_blocked = true;
        assert_int_equal(dmi_joint_hypothesis_adopt_side(&door, 2), sign < 0);
        assert_true(door.joint.lower == (sign < 0 ? -2.0f : 0) && door.joint.upper == (sign < 0 ? 0 : 2.0f));
        assert_false(dmi_joint_hypothesis_adopt_side(&blocked, 2));
        assert_true(blocked.joint.lower == 0 && blocked.joint.upper == 2);
        assert_false(dmi_joint_hypothesis_adopt_side(&both, 2));
        for (int tight = 0; tight < 2; tight++) {
            const dmi_free_range room = tight ? (dmi_free_range){-0.7f, 0.4f} : dmi_unbounded_range();
            dmi_joint_hypothesis slide = dmi_joint_hypothesis_make(&grasp, &kinds[DRAWER], 0, true, room),
                                 turn = dmi_joint_hypothesis_make(&grasp, &kinds[DOOR], 0, true, room);
            slide.pointer_value = turn.pointer_value = 0.3f * (float)sign;
            assert_false(dmi_joint_hypothesis_adopt_side(&slide, 2) || dmi_joint_hypothesis_adopt_side(&turn, 2));
            assert_near(slide.joint.lower, sign > 0 ? 0 : tight ? -0.7f : -2, 0);
            assert_near(slide.joint.upper, sign < 0 ? 0 : tight ? 0.4f : 2, 0);
            assert_near(slide.side, sign, 0);
            assert_false(slide.range_unknown || turn.range_unknown);
            assert_int_equal(turn.joint.type, tight ? DM_JOINT_REVOLUTE : DM_JOINT_CONTINUOUS);
            assert_near(turn.joint.lower, tight ? -0.7 : -3.14159265, 1e-6);
            assert_near(turn.joint.upper, tight ? 0.4 : 3.14159265, 1e-6);
        }
    }
}

/* What a ray adds up to, from the parts above; the value is followed on both sides of rest. */
static void a_posterior_is_the_sum_of_its_parts(void** state) {
    (void)state;
    for (int kind = DRAWER; kind <= BOTH; kind++) {
        dmi_grasp grasp = grasp_of(1, (dmi_limit_give){0, 4});
        grasp.pull.projection = DMI_PERSPECTIVE;
        dmi_joint_hypothesis hypothesis = made(&grasp, &kinds[kind], dmi_unbounded_range());
        hypothesis.log_prior = -0.7f, hypothesis.shift_cost = 0.3f;
        double worst = 0, reached[2] = {0};
        for (int k = 1; k <= 30; k++) {
            const float value = 0.02f * (float)(k < 20 ? k : 40 - 2 * k);
            float point[3], there[3];
            point_on(&kinds[kind], value, point);
            point[1] += 0.02f * sinf(0.4f * (float)k);
            dm_ray ray = ray_to(eye, point);
            dmi_float3 direction = dmi_xyz(ray.direction);
            dmi_normalize3(direction.v);
            ray.direction = dmi_vec3(direction.v);
            dmi_grasp_add(&grasp, &ray);
            const float got = dmi_joint_hypothesis_update(&grasp, &hypothesis, &ray);
            point_on(&kinds[kind], value, there);
            const float as_drawn = dmi_pull_residual(&grasp.pull, &ray, there);
            point_on(&kinds[kind], hypothesis.pointer_value, there);
            assert_true(dmi_pull_residual(&grasp.pull, &ray, there) < as_drawn + 1e-3f);
            worst = fmax(worst, (double)dmi_pull_residual(&grasp.pull, &ray, there));
            const int above = hypothesis.pointer_value > 0;
            reached[above] = fmax(reached[above], fabs((double)hypothesis.pointer_value));
            assert_near(hypothesis.max_residual, worst, 1e-5);
            assert_near(hypothesis.excursion[0], reached[0], 0);
            assert_near(hypothesis.excursion[1], reached[1], 0);
            const double likelihood = (double)dmi_joint_hypothesis_log_likelihood(&grasp, &hypothesis, (float)worst);
            const double side =
                (double)dmi_joint_hypothesis_side_log_prior(&grasp, &hypothesis, hypothesis.pointer_value);
            assert_near(got, likelihood, 1e-3);
            assert_near(hypothesis.log_posterior, -0.7 - 0.3 + side + likelihood, 1e-3);
        }
        assert_true(reached[0] > 0.2 && reached[1] > 0.2);
    }
}

/* With each ray the active one and the three of the highest priority among the others; those that wait gain 0.05. The
 * joint of the grab does not wait again. */
static void the_likeliest_are_updated(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(4, 4);
    for (int i = 0; i < 100; i++) {
        dmi_hypothesis_tracker tracker;
        dmi_hypothesis_tracker_init(&tracker, joints, NULL, JOINTS, handle, 1, (dmi_limit_give){.length = 4});
        add_slides(&tracker);
        const uint32_t round = dmi_random_u32(&random) % 20 * 2, count = tracker.count;
        float before[DMI_TRACKED_HYPOTHESES];
        tracker.round = round; /* it is odd in the update: no axis is refined */
        tracker.best = dmi_random_u32(&random) % count;
        for (uint32_t k = 0; k < count; k++) before[k] = tracker.priority[k] = test_range(&random, -5, 0);
        for (uint32_t k = 0; k < count; k++) tracker.list[k].log_posterior = k == tracker.best ? 50 : -1;
        tracker.list[tracker.best].log_prior = 50;
        const uint32_t best = tracker.best;
        dm_ray ray = ray_to(eye, (const float[3]){handle[0] + 0.05f, handle[1] + 0.02f, handle[2] + 0.1f});
        dmi_float3 direction = dmi_xyz(ray.direction);
        dmi_normalize3(direction.v);
        ray.direction = dmi_vec3(direction.v);
        assert_false(dmi_hypothesis_tracker_update(&tracker, 0, &ray, DMI_PERSPECTIVE));
        assert_int_equal(tracker.round, round + 1);
        for (uint32_t k = 0; k < count; k++) {
            uint32_t higher = 0;
            for (uint32_t n = 0; n < count; n++) higher += n != best && before[n] > before[k];
            const bool updated = k == best || higher < 3;
            const double now = (double)tracker.list[k].log_posterior - 0.05 * (double)(round + 1);
            assert_near(tracker.priority[k], !updated ? (double)before[k] : k == 0 ? 1e9 : now, 1e-5);
            if (!updated) assert_near(tracker.list[k].log_posterior, -1, 0);
        }
    }
}

/* If the stop at rest holds a part that is pulled the other way: a hand that has missed it by that much, or one that
 * pushes on. */
static void a_stop_explains_a_pull_the_other_way(void** state) {
    (void)state;
    for (int blocked = 0; blocked < 2; blocked++) {
        for (int k = -6; k <= 6; k++) {
            dmi_grasp grasp = grasp_of(1, (dmi_limit_give){0, 4});
            grasp.pull.projection = DMI_PARALLEL;
            const float value = 0.004f * (float)(k * abs(k));
            float point[3];
            point_on(&kinds[DRAWER], value, point);
            const dm_ray ray = {{point[0], point[1] + 5, point[2]}, {0, -1, 0}};
            dmi_joint_hypothesis hypothesis = made(&grasp, &kinds[DRAWER], dmi_unbounded_range());
            hypothesis.log_prior = -0.7f, hypothesis.shift_cost = 0.3f, hypothesis.other_side_blocked = blocked;
            dmi_grasp_add(&grasp, &ray);
            const double at_stop = (double)dmi_joint_hypothesis_update_active(&grasp, &hypothesis, 9, &ray);
            const double missed = -0.8 - 3.5 * log(1 + fabs((double)value) / (double)dmi_expected_residual(&grasp));
            assert_near(hypothesis.pointer_value, value, 1e-5); /* followed on both sides, not at the 9 */
            const double followed =
                (double)dmi_joint_hypothesis_log_likelihood(&grasp, &hypothesis, hypothesis.max_residual);
            if (k < 0 && !blocked)
                assert_near(at_stop, -0.7 - 0.3 + fmax(missed, -1.5 + followed), 1e-3);
            else
                assert_near(at_stop, hypothesis.log_posterior, 0);
        }
    }
    dmi_grasp grasp = grasp_of(1, (dmi_limit_give){0, 4});
    const dm_ray ray = {{handle[0], handle[1], 5}, {0, 0, -1}};
    dmi_joint_hypothesis both = made(&grasp, &kinds[BOTH], dmi_unbounded_range());
    dmi_grasp_add(&grasp, &ray);
    dmi_joint_hypothesis_update_active(&grasp, &both, 0.25f, &ray);
    assert_near(both.pointer_value, 0.25f, 0);
}

/* 0.43 of the log odds among all and 1.17 for a straight pull, 0.55 of them and 2.1 for one that bends; at most 3
 * and 4.6. The type has the share of all joints of it, and is no less sure than the joint. */
static void a_confidence_comes_from_the_share_among_all(void** state) {
    (void)state;
    static const double law[2][3] = {{0.43, 1.17, 3}, {0.55, 2.1, 4.6}};
    static const float logs[][3] = {{-1, 0.5f, -3}, {0, 0, 0}, {4, -2, -1}, {-3, 3, 2.9f}};
    dmi_hypothesis_tracker tracker;
    dmi_hypothesis_tracker_init(&tracker, joints, NULL, 3, handle, 1, (dmi_limit_give){.length = 4});
    assert_true(tracker.list[0].grabbed && !tracker.list[1].grabbed && !tracker.list[2].grabbed);
    for (size_t i = 0; i < 2 * sizeof logs / sizeof *logs; i++) {
        const float* set = logs[i / 2];
        const int bends = (int)(i % 2);
        double all = 0;
        tracker.grasp.pull.length = 1, tracker.grasp.pull.bend = bends ? 0.2f : 0;
        for (int k = 0; k < 3; k++) all += exp((double)(tracker.list[k].log_posterior = set[k]));
        for (uint32_t best = 0; best < 3; best++) {
            tracker.best = best;
            const double p = fmin(fmax(exp((double)set[best]) / all, 1e-4), 1 - 1e-4);
            const double odds = fmin(law[bends][0] * log(p / (1 - p)) + law[bends][1], law[bends][2]);
            tracker.confidence = dmi_hypothesis_tracker_confidence(&tracker);
            assert_near(tracker.confidence, 1 / (1 + exp(-odds)), 2e-3);
            assert_true(dmi_hypothesis_tracker_type_confidence(&tracker) >= tracker.confidence);
        }
    }
}

/* An alternative has no range and lower odds; a last resort goes as far as the part is large, in what is free. */
static void further_joints_have_their_odds_and_ranges(void** state) {
    (void)state;
    dmi_hypothesis_tracker tracker;
    dmi_hypothesis_tracker_init(&tracker, joints, NULL, 1, handle, 2, (dmi_limit_give){.length = 4});
    dm_joint other = kinds[BOTH];
    other.joint_confidence = 0.3f;
    const uint32_t first = tracker.count;
    dmi_hypothesis_tracker_add_alternative(&tracker, &other, (dmi_free_range){-0.5f, 0.6f});
    assert_int_equal(tracker.count, first + 1);
    const dmi_joint_hypothesis* added = &tracker.list[first];
    assert_near(added->log_prior,
                0.85 * log(0.3 / 0.7) - 0.35 + (double)dmi_lever_arm_log_prior(&tracker.grasp, &other), 1e-5);
    assert_true(added->range_unknown && added->joint.lower == 0 && added->joint.upper == 0 && added->side == 0);
    dmi_hypothesis_tracker_add_alternative(&tracker, &other, dmi_unbounded_range()); /* one alike is known */
    assert_int_equal(tracker.count, first + 1);
    const dm_vec3 axes[2] = {{1, 0, 0}, {0, 1, 0}};
    dmi_hypothesis_tracker_add_slide(&tracker, axes[0], (dmi_free_range){-0.5f, 9});
    assert_int_equal(tracker.count, first + 2);
    const dmi_joint_hypothesis* slide = &tracker.list[first + 1];
    assert_true(slide->joint.lower == -0.5f && slide->joint.upper == 2 && !slide->range_unknown);
    assert_near(slide->log_prior, -6.5, 0);
    assert_near3(dmi_xyz(slide->joint.origin).v, handle, 0);
    dmi_hypothesis_tracker_add_slide(&tracker, axes[1], (dmi_free_range){0, 0}); /* no room at all */
    assert_int_equal(tracker.count, first + 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_pull_tells_the_joint),
        cmocka_unit_test(a_hand_may_cut_the_corner),
        cmocka_unit_test(a_hand_that_trembles_decides_the_same),
        cmocka_unit_test(the_pull_tells_the_side),
        cmocka_unit_test(a_door_does_not_swing_into_its_body),
        cmocka_unit_test(what_was_opened_shuts_at_rest),
        cmocka_unit_test(a_jostle_is_undone_by_as_much),
        cmocka_unit_test(nothing_is_stuck),
        cmocka_unit_test(half_the_step_is_the_same_drag),
        cmocka_unit_test(host_axes_do_not_matter),
        cmocka_unit_test(an_alternative_takes_over),
        cmocka_unit_test(no_turn_about_the_grabbed_point),
        cmocka_unit_test(what_is_no_number_is_not_waited_for),
        cmocka_unit_test(odds_are_those_of_the_confidence),
        cmocka_unit_test(a_short_lever_lowers_the_prior),
        cmocka_unit_test(joints_alike_are_within_their_tolerances),
        cmocka_unit_test(a_range_has_a_side_and_maybe_a_blocked_one),
        cmocka_unit_test(a_pull_reaches_beyond_estimates_alone),
        cmocka_unit_test(a_side_costs_by_how_far_the_pull_went),
        cmocka_unit_test(a_joint_adopts_the_side_of_the_pull),
        cmocka_unit_test(a_posterior_is_the_sum_of_its_parts),
        cmocka_unit_test(the_likeliest_are_updated),
        cmocka_unit_test(a_stop_explains_a_pull_the_other_way),
        cmocka_unit_test(a_confidence_comes_from_the_share_among_all),
        cmocka_unit_test(further_joints_have_their_odds_and_ranges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
