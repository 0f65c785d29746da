/* One drag of the scripted player through the public API, and its measurements. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dragbot.h"
#include "timing.h"

/* By hand; docs/feel.md. */
static const double frame = 1.0 / 60; /* s */
/* A jump: in one frame the part moves more than jump_share of the screen's height and jump_gain times the pointer. */
static const double jump_share = 0.03, jump_gain = 4;
static const double near_share = 0.02; /* of the screen's height: the grabbed point is at the pointer */
static const double reach_share = 0.9; /* of the asked value: the part has arrived */

static void record_time(bot_times* times, double ns) {
    if (times->count == times->room) {
        times->room = times->room ? 2 * times->room : 65536;
        times->ns = cli_grow(times->ns, times->room * sizeof *times->ns);
    }
    times->ns[times->count++] = (float)ns;
}

static vec moved(const dm_pose* pose, vec point) {
    float xyz[3] = {(float)point.x, (float)point.y, (float)point.z};
    dm_pose_apply_points(pose, xyz, 0, xyz, 0, 1);
    return vec_at(xyz);
}

/* Returns the true joint's value of a pose: the twist about its axis, or the displacement of the part's centre. */
static double true_value(const known_joint* truth, const dm_pose* pose, vec centre, double near) {
    if (truth->slides) return dot(sub(moved(pose, centre), centre), truth->axis);
    const vec v = {(double)pose->real[0], (double)pose->real[1], (double)pose->real[2]};
    const double angle = 2 * atan2(dot(v, truth->axis), (double)pose->real[3]);
    return angle + TWO_PI * round((near - angle) / TWO_PI);
}

/* Measures jumps and distances on the screen, frame by frame. */
typedef struct screen_tracker {
    const bot_view* view;
    vec centre;        /* of the part at rest */
    double seen[2][2]; /* grabbed point and centre on the screen in the frame before */
    double pointer[2]; /* in the frame before */
    bot_result* result;
} screen_tracker;

static void track_frame(screen_tracker* w, const dm_drag_state* state, const double pointer[2]) {
    const vec points[2] = {vec_of(state->grab_point), moved(&state->pose, w->centre)};
    const double went = hypot(pointer[0] - w->pointer[0], pointer[1] - w->pointer[1]);
    bool jumped = false;
    for (int i = 0; i < 2; i++) {
        double x = 0, y = 0;
        if (!bot_view_project(w->view, points[i], &x, &y)) continue;
        const double step = hypot(x - w->seen[i][0], y - w->seen[i][1]);
        if (step > jump_gain * went + jump_share * BOT_HEIGHT) {
            jumped = true;
            w->result->worst_jump = fmax(w->result->worst_jump, step);
        }
        w->seen[i][0] = x, w->seen[i][1] = y;
        if (i == 0) w->result->off = fmax(w->result->off, hypot(x - pointer[0], y - pointer[1]) / BOT_HEIGHT);
    }
    w->result->jumps += jumped;
    memcpy(w->pointer, pointer, sizeof w->pointer);
}

static dm_result follow_path(session* session, dm_drag drag, const bot_view* view, const bot_pull* pull, vec centre,
                             bot_times* times, dm_drag_state* out_state, bot_result* out_result) {
    screen_tracker w = {.view = view, .centre = centre, .pointer = {pull->x, pull->y}, .result = out_result};
    bot_view_project(view, pull->point, &w.seen[0][0], &w.seen[0][1]);
    bot_view_project(view, centre, &w.seen[1][0], &w.seen[1][1]);
    for (int i = 0; i < pull->frames + BOT_HOLD; i++) {
        const double* at = pull->path[i < pull->frames ? i : pull->frames - 1];
        const double pointer[2] = {round(at[0]), round(at[1])}; /* a mouse reports whole pixels */
        dm_ray ray;
        dm_result result = dm_camera_ray(session->context, &view->camera, (float)pointer[0], (float)pointer[1], &ray);
        if (result != DM_OK) return result;
        const double start = timing_now_ns(CLOCK_MONOTONIC);
        result = dm_drag_update(session->context, drag, &ray, (float)frame, out_state);
        record_time(times, timing_now_ns(CLOCK_MONOTONIC) - start);
        if (result != DM_OK) return result;
        track_frame(&w, out_state, pointer);
    }
    return DM_OK;
}

dm_result bot_play(session* session, dm_scene scene, const bot_view* view, const bot_pull* pull, const bot_hand* hand,
                   uint32_t part, const known_joint* truth, vec centre, bot_times* times, bot_result* out_result) {
    *out_result = (bot_result){0};
    dm_ray ray;
    dm_hit hit = {.struct_size = sizeof hit};
    dm_result result = dm_camera_ray(session->context, &view->camera, (float)pull->x, (float)pull->y, &ray);
    if (result == DM_OK) result = dm_scene_pick(session->context, scene, &ray, &hit);
    if (result != DM_OK) return result;
    out_result->picked = hit.object == session->object && hit.part_id == part;
    if (!out_result->picked) return DM_OK;
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .part_id = part, .object = session->object, .grab_point = hit.object_point};
    dm_drag drag;
    dm_drag_state state = {.struct_size = sizeof state};
    result = dm_drag_begin(session->context, &desc, &drag);
    if (result != DM_OK) return result;
    result = follow_path(session, drag, view, pull, centre, times, &state, out_result);
    dm_part_state end = dm_part_state_default();
    dm_drag_end(session->context, drag, &end);
    out_result->joint = end.joint;
    out_result->changes = (int)state.changes;
    out_result->reached = true_value(truth, &state.pose, centre, pull->asked) / pull->asked;
    const int far_enough = out_result->reached >= reach_share, not_beyond = out_result->reached <= 2 - reach_share;
    out_result->arrived = far_enough && not_beyond;
    out_result->near = out_result->off <= near_share;
    out_result->success_or_beyond = far_enough && (hand->straight || out_result->near) && out_result->jumps == 0;
    out_result->success = out_result->success_or_beyond && not_beyond;
    return result;
}
