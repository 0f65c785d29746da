/* One drag of the scripted player through the public API, and its measurements. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dragbot.h"
#include "dragbot_body.h"
#include "dragbot_naive.h"
#include "timing.h"

/* By hand; docs/feel.md. */
/* A jump: in one frame the part moves more than jump_share of the screen's height and jump_gain times the pointer. */
static const double jump_share = 0.03, jump_gain = 4;
static const double near_share = 0.02;   /* of the screen's height: the grabbed point is at the pointer */
static const double reach_share = 0.9;   /* of the asked value: the part has arrived */
static const double stuck_share = 0.1;   /* of the way of the grabbed point */
static const double still_share = 0.001; /* of the object's size: a part that has not moved */
static const double regrab_share = 0.01; /* of the object's size: a jump at a new grab */
static const double own_share = 0.05;    /* of the object's size: the part is where its true joint can take it */
/* In a pull a moving camera turns round the part by move_turn, rad. A moving instance turns as far, and rises by
 * move_rise of the radius of the ball round the part's way. */
static const double move_turn = 10 * PI / 180, move_rise = 0.2;
/* Of a gamepad: the part goes through its range so fast at full deflection, a second; the axis is deflected so far for
 * each share of the asked value that the part is behind, and by axis_care of that each time the part has gone past. */
static const float axis_speed = 8;
static const double axis_gain = 1.5, axis_care = 0.5;

static void record_time(bot_times* times, double ns) {
    times->ns = cli_grow_list(times->ns, times->count, &times->room, sizeof *times->ns);
    times->ns[times->count++] = (float)ns;
}

/* Returns the true joint's value of a pose: the twist about its axis, or the displacement of the part's centre. */
static double true_value(const known_joint* truth, const dm_pose* pose, vec centre, double near) {
    if (truth->slides) return dot(sub(bot_moved(pose, centre), centre), truth->axis);
    const vec v = {(double)pose->real[0], (double)pose->real[1], (double)pose->real[2]};
    const double angle = 2 * atan2(dot(v, truth->axis), (double)pose->real[3]);
    return angle + TWO_PI * round((near - angle) / TWO_PI);
}

/* One drag under way. */
typedef struct player {
    session* session;
    const bot_case* now;
    bot_view view;      /* of the camera where it is */
    bot_carry instance; /* from the object's frame to the world where it is */
    double seen[2][2];  /* grabbed point and centre of the part on the screen in the update before */
    double pointer[2];  /* in the update before */
    dm_drag drag;
    dm_drag_state state;
    dm_joint first_joint;
    uint32_t changes;    /* in the grabs before this one */
    double axis_sign;    /* 1, or -1 once the gamepad's axis was seen to move the part the wrong way */
    double axis_value;   /* the true joint's value that the player saw last: turns add up */
    double axis_gain;    /* deflection a share of the asked value that is missing */
    double axis_missing; /* that share, in the update before */
    bot_frame* frames;
    int frame_count;
    bot_times* times;
    bot_result* result;
} player;

/* ---- measuring ---- */

/* The pixel of a point of the object's frame; false when it is behind the eye. */
static bool see(const player* p, vec point, double* out_x, double* out_y) {
    return bot_view_project(&p->view, bot_carry_point(&p->instance, point), out_x, out_y);
}

static void track_screen(player* p, const bot_step* step, const double pointer[2]) {
    const vec points[2] = {vec_of(p->state.grab_point), bot_moved(&p->state.pose, p->now->part->centre)};
    const double went = hypot(pointer[0] - p->pointer[0], pointer[1] - p->pointer[1]);
    const double* beside = p->now->plan->offset;
    bool jumped = false;
    for (int i = 0; i < 2; i++) {
        double x = 0, y = 0;
        if (!see(p, points[i], &x, &y)) continue;
        const double moved = hypot(x - p->seen[i][0], y - p->seen[i][1]);
        if (moved > jump_gain * went + jump_share * BOT_HEIGHT) {
            jumped = true;
            p->result->worst_jump = fmax(p->result->worst_jump, moved);
        }
        p->seen[i][0] = x, p->seen[i][1] = y;
        if (i == 1 || !step->on_way) continue;
        const double off = hypot(x - pointer[0] + beside[0], y - pointer[1] + beside[1]);
        p->result->off = fmax(p->result->off, off / BOT_HEIGHT);
    }
    p->result->jumps += jumped;
    memcpy(p->pointer, pointer, sizeof p->pointer);
}

static bool same_joint(const dm_joint* a, const dm_joint* b) {
    /* NOLINTBEGIN(bugprone-suspicious-memory-comparison): the bits are what is asked */
    return a->type == b->type && memcmp(&a->axis, &b->axis, sizeof a->axis) == 0 &&
           memcmp(&a->origin, &b->origin, sizeof a->origin) == 0;
    /* NOLINTEND(bugprone-suspicious-memory-comparison) */
}

static void track_rest(player* p) {
    static const dm_pose rest = {.real = {0, 0, 0, 1}};
    dm_part_state now = dm_part_state_default();
    if (dm_drag_get_part_state(p->session->context, p->drag, &now) != DM_OK) return;
    if (bot_apart(p->now->part, &rest, &p->state.pose) > still_share || !same_joint(&now.joint, &p->first_joint))
        p->result->still_moved = true;
}

static void track_regrab(player* p, const dm_pose* before) {
    const double jump = bot_apart(p->now->part, before, &p->state.pose);
    p->result->regrabs++;
    p->result->regrab_jumps += jump > regrab_share;
    p->result->worst_regrab = fmax(p->result->worst_regrab, jump);
}

/* ---- the drag ---- */

dm_result bot_regrab(session* session, uint32_t part, dm_drag* drag, dm_drag_state* state) {
    dm_part_state kept = dm_part_state_default();
    const dm_result result = dm_drag_end(session->context, *drag, &kept);
    if (result != DM_OK) return result;
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = part,
                               .object = session->object,
                               .grab_point = state->grab_point,
                               .state = &kept};
    return dm_drag_begin(session->context, &desc, drag);
}

/* Puts the camera and the instance where they are in a step. */
static void move_world(player* p, const bot_step* step) {
    const bot_case* now = p->now;
    bot_carry carry = {now->part->centre, now->up, move_turn * step->moved, 0};
    if (now->hand->moving_camera) p->view = bot_carry_view(&carry, now->view);
    carry.rise = move_rise * now->part->swept_radius * step->moved;
    if (now->hand->moving_instance) p->instance = carry;
}

/* Computes the pointer of a step, in whole pixels but for the naive hand, whose direction they would change. Where the
 * camera or the instance moves, it goes with the true point on the screen. */
static void aim(const player* p, const bot_step* step, double pointer[2]) {
    const bot_case* now = p->now;
    bot_plan_pointer(now->plan, now->pull, step, pointer);
    if (step->moved > 0) {
        const double value = now->pull->asked * bot_minimum_jerk((step->at + 1) / now->pull->frames);
        const vec point = bot_true_move(now->truth, now->pull->point, value);
        double was[2], is[2];
        if (bot_view_project(now->view, point, &was[0], &was[1]) && see(p, point, &is[0], &is[1]))
            for (int k = 0; k < 2; k++) pointer[k] += is[k] - was[k];
    }
    if (now->hand->naive) return;
    for (int k = 0; k < 2; k++) pointer[k] = round(pointer[k]); /* a mouse reports whole pixels */
}

static void keep_frame(player* p, const dm_ray* ray) {
    bot_frame* frame = &p->frames[p->frame_count++];
    *frame = (bot_frame){.pose = p->state.pose, .value = p->state.value, .ray = *ray};
    if (p->now->poses == NULL) return;
    dm_part_state now = dm_part_state_default();
    if (dm_drag_get_part_state(p->session->context, p->drag, &now) == DM_OK) frame->joint = now.joint;
}

/* ---- hands ---- */

/* Returns the share of the asked value that the hand wants in a step. */
static double wanted(const player* p, const bot_step* step) {
    return bot_minimum_jerk(fmin(fmax((step->at + 1) / p->now->pull->frames, 0), 1));
}

static dm_hand hand_in_space(const player* p, const bot_step* step) {
    const bot_pull* pull = p->now->pull;
    const vec point = p->now->hand->naive ? add(pull->point, scale(pull->way, bot_naive_progress(step->at)))
                                          : bot_true_move(p->now->truth, pull->point, pull->asked * wanted(p, step));
    return (dm_hand){.kind = DM_HAND_POINT, .point = {(float)point.x, (float)point.y, (float)point.z}};
}

/* The player sees how far the part is on its way, and turns the axis round once it goes the wrong one. */
static dm_hand gamepad(player* p, const bot_step* step) {
    const double asked = p->now->pull->asked;
    p->axis_value = true_value(p->now->truth, &p->state.pose, p->now->part->centre, p->axis_value);
    const double is = p->axis_value / asked;
    if (is < -still_share) p->axis_sign = -1;
    const double missing = wanted(p, step) - is;
    if (missing * p->axis_missing < 0) p->axis_gain *= axis_care;
    p->axis_missing = missing;
    const double deflection = p->axis_gain * p->axis_sign * missing;
    return (dm_hand){.kind = DM_HAND_RATE, .amount = (float)fmin(fmax(deflection, -1), 1)};
}

static dm_result update(player* p, const bot_step* step, const dm_ray* ray) {
    const bot_hand* hand = p->now->hand;
    dm_drag_input input = dm_drag_input_default();
    if (hand->point) input.hand = hand_in_space(p, step);
    if (hand->scalar) input.hand = gamepad(p, step);
    const double start = timing_now_ns(CLOCK_MONOTONIC);
    const dm_result result =
        input.hand.kind == DM_HAND_NONE
            ? dm_drag_update(p->session->context, p->drag, ray, (float)step->dt, &p->state)
            : dm_drag_update_input(p->session->context, p->drag, &input, (float)step->dt, &p->state);
    record_time(p->times, timing_now_ns(CLOCK_MONOTONIC) - start);
    return result;
}

static dm_result take_step(player* p, const bot_step* step) {
    dm_context* context = p->session->context;
    const dm_pose before = p->state.pose;
    double pointer[2];
    dm_ray ray;
    move_world(p, step);
    aim(p, step, pointer);
    dm_result result = dm_camera_ray(context, &p->view.camera, (float)pointer[0], (float)pointer[1], &ray);
    ray = bot_carry_ray_back(&p->instance, &ray);
    if (result == DM_OK && step->regrabs) {
        result = bot_regrab(p->session, p->now->part->id, &p->drag, &p->state);
        p->changes += p->state.changes;
    }
    if (result != DM_OK) return result;
    result = update(p, step, &ray);
    if (result != DM_OK) return result;
    keep_frame(p, &ray);
    track_screen(p, step, pointer);
    if (step->resting) track_rest(p);
    if (step->regrabs) track_regrab(p, &before);
    return DM_OK;
}

static dm_result follow_plan(player* p) {
    const bot_case* now = p->now;
    for (int k = 0; k < 2; k++) p->pointer[k] = (k ? now->pull->y : now->pull->x) + now->plan->offset[k];
    see(p, now->pull->point, &p->seen[0][0], &p->seen[0][1]);
    see(p, now->part->centre, &p->seen[1][0], &p->seen[1][1]);
    dm_part_state first = dm_part_state_default();
    dm_result result = dm_drag_get_part_state(p->session->context, p->drag, &first);
    p->first_joint = first.joint;
    for (int i = 0; i < now->plan->count && result == DM_OK; i++) result = take_step(p, &now->plan->steps[i]);
    return result;
}

/* ---- the verdict ---- */

/* Whether the part is near a place to which its true joint can take it. */
static bool is_on_own_way(const bot_case* now, const dm_pose* pose, double value) {
    const known_joint* truth = now->truth;
    if (isfinite(truth->lower) && isfinite(truth->upper)) {
        const double lower = fmin(truth->lower, 0), upper = fmax(truth->upper, 0);
        if (!truth->slides) value += TWO_PI * round((0.5 * (lower + upper) - value) / TWO_PI);
        value = fmin(fmax(value, lower), upper);
    }
    double apart = 0;
    for (int i = 0; i < BOT_EXTREMES; i++) {
        const vec point = now->part->extremes[i];
        apart = fmax(apart, length(sub(bot_moved(pose, point), bot_true_move(truth, point, value))));
    }
    return apart <= own_share * now->part->object_size;
}

static void judge(const bot_case* now, const dm_drag_state* last, bot_result* result) {
    const bool strays = now->hand->straight || now->hand->axis || now->hand->scalar; /* not at the pointer on purpose */
    const vec end = bot_true_move(now->truth, now->pull->point, now->pull->asked);
    const double way = length(sub(end, now->pull->point));
    result->reached = true_value(now->truth, &last->pose, now->part->centre, now->pull->asked) / now->pull->asked;
    const int far_enough = result->reached >= reach_share, not_beyond = result->reached <= 2 - reach_share;
    result->arrived = far_enough && not_beyond;
    result->near = result->off <= near_share;
    result->stuck = length(sub(vec_of(last->grab_point), now->pull->point)) < stuck_share * way;
    result->success_or_beyond = far_enough && (strays || result->near) && result->jumps == 0;
    result->own_way = is_on_own_way(now, &last->pose, result->reached * now->pull->asked);
    result->success = result->success_or_beyond && not_beyond;
}

dm_result bot_play(session* session, dm_scene scene, const bot_case* played, bot_times* times, bot_result* out_result) {
    *out_result = (bot_result){0};
    player p = {.session = session,
                .now = played,
                .view = *played->view,
                .axis_sign = 1,
                .axis_gain = axis_gain,
                .times = times,
                .result = out_result};
    dm_ray ray;
    dm_hit hit = dm_hit_default();
    p.state = dm_drag_state_default();
    dm_result result =
        dm_camera_ray(session->context, &p.view.camera, (float)played->pull->x, (float)played->pull->y, &ray);
    if (result == DM_OK) result = dm_scene_pick(session->context, scene, &ray, &hit);
    if (result != DM_OK) return result;
    out_result->picked = hit.object == session->object && hit.part_id == played->part->id;
    if (!out_result->picked) return DM_OK;
    const dm_drag_rules fast = {.struct_size = sizeof fast, .drive_speed = axis_speed};
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = played->part->id,
                               .object = session->object,
                               .grab_point = hit.object_point,
                               .flags = played->flags,
                               .state = played->state,
                               .rules = played->hand->scalar ? &fast : NULL};
    result = dm_drag_begin(session->context, &desc, &p.drag);
    if (result != DM_OK) return result;
    p.frames = cli_alloc((size_t)played->plan->count * sizeof *p.frames);
    result = follow_plan(&p);
    out_result->end = dm_part_state_default();
    dm_drag_end(session->context, p.drag, &out_result->end);
    out_result->pose = p.state.pose;
    out_result->changes = (int)(p.changes + p.state.changes);
    judge(played, &p.state, out_result);
    if (played->body != NULL) out_result->through = bot_body_depth(played->body, played->part, p.frames, p.frame_count);
    if (played->poses != NULL) bot_poses_write(played, p.frames, p.frame_count);
    free(p.frames);
    return result;
}
