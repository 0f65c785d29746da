/* The pull identifies the joint early, without a jump, in any axes; tremor of the hand does not change it. */
#include "test_math.h"

#include <string.h>

#include "math/frames.h"
#include "math/linear3.h"
#include "motion/drag.h"

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
        if (k == 37) other = *right, other.joint_confidence = 0.005f;
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

/* A pull that fits none of the joints takes the part along. */
static void nothing_is_stuck(void** state) {
    (void)state;
    const dm_joint up = {.type = DM_JOINT_PRISMATIC, .axis = {0, 1, 0}, .lower = -1, .upper = 1};
    const pulled p = pull(&up, 0.6f, 120, 0);
    float there[3];
    point_on(&up, 0.6f, there);
    assert_near3(dmi_xyz(p.now.grab_point).v, there, 0.02);
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_pull_tells_the_joint),
        cmocka_unit_test(a_hand_may_cut_the_corner),
        cmocka_unit_test(a_hand_that_trembles_decides_the_same),
        cmocka_unit_test(the_pull_tells_the_side),
        cmocka_unit_test(what_was_opened_shuts_at_rest),
        cmocka_unit_test(a_jostle_is_undone_by_as_much),
        cmocka_unit_test(nothing_is_stuck),
        cmocka_unit_test(half_the_step_is_the_same_drag),
        cmocka_unit_test(host_axes_do_not_matter),
        cmocka_unit_test(an_alternative_takes_over),
        cmocka_unit_test(no_turn_about_the_grabbed_point),
        cmocka_unit_test(what_is_no_number_is_not_waited_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
