/* Overlay of the picture: axis, limits, hypotheses, key poses. Text: panel.c. */
#include "overlay.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "panel.h"

static const colour axis_colour = {0.10f, 0.55f, 1.0f, 1}, limit_colour = {1.0f, 0.55f, 0.10f, 1};
static const colour hypothesis_colour = {0.75f, 0.35f, 0.85f, 0.85f}, hand_colour = {1, 1, 1, 0.95f};

enum { ARC_STEPS = 64 }; /* segments of an arc; by hand */

/* How much a part stands out. */
static float emphasis(const app* app, uint32_t id) {
    if (app->painting) return id == app->selected ? 0.65f : 0.15f;
    if (id == app->world->held) return 0.32f;
    return id == app->hovered ? 0.24f : id == app->selected ? 0.08f : 0;
}

/* Laid over the file's own colour: clay, if asked for, and over that what stands out. */
static void lay_over(float tint[4], const float under[4], const colour over) {
    const float rest = under[3] * (1 - over.a), whole = over.a + rest;
    const float share = whole > 0 ? over.a / whole : 0;
    tint[0] = over.r * share + under[0] * (1 - share);
    tint[1] = over.g * share + under[1] * (1 - share);
    tint[2] = over.b * share + under[2] * (1 - share);
    tint[3] = whole;
}

void overlay_looks(const app* app, look* looks) {
    static const float body_clay[4] = {0.66f, 0.64f, 0.60f, 1}, part_clay[4] = {0.50f, 0.33f, 0.19f, 1};
    static const float none[4] = {0, 0, 0, 0};
    const bool clay = (app->show & SHOW_CLAY) != 0;
    looks[0] = (look){.pose = pose_identity};
    memcpy(looks[0].tint, clay ? body_clay : none, sizeof none);
    for (uint32_t id = 1; id <= app->world->part_count; id++) {
        looks[id].pose = app->painting ? pose_identity : app->world->parts[id].carried;
        looks[id].glow = emphasis(app, id);
        lay_over(looks[id].tint, clay ? part_clay : none, (colour){1.0f, 0.62f, 0.15f, emphasis(app, id)});
    }
}

static uint32_t part_of_interest(const app* app) {
    if (app->world->held) return app->world->held;
    return app->hovered && !app->button ? app->hovered : app->selected;
}

static dm_pose carrier_pose(const world* world, uint32_t id) {
    const uint32_t carrier = world->parts[id].parent;
    return carrier ? world->parts[carrier].carried : pose_identity;
}

/* ---- axis and limits ---- */

/* The part's corner farthest from the axis, level with its middle: where the limits are best read. */
static dm_vec3 far_point(const world_part* part, const dm_joint* joint) {
    dm_vec3 best = part->centre;
    float most = 0;
    for (int i = 0; i < 8; i++) {
        const dm_vec3 corner = vec(i & 1 ? part->box_max.x : part->box_min.x, i & 2 ? part->box_max.y : part->box_min.y,
                                   i & 4 ? part->box_max.z : part->box_min.z);
        const dm_vec3 off = sub(corner, joint->origin);
        const float away = length(along(off, joint->axis, -dot(off, joint->axis)));
        if (away <= most) continue;
        most = away;
        best = along(corner, joint->axis, -dot(sub(corner, part->centre), joint->axis));
    }
    return best;
}

static dm_vec3 moved(const dm_joint* joint, float value, const dm_pose* carrier, dm_vec3 p) {
    dm_pose pose;
    if (dm_joint_pose(joint, value, &pose) != DM_OK) return p;
    return pose_point(carrier, pose_point(&pose, p));
}

static void draw_travel(draw* draw, const world_part* part, const dm_joint* joint, const dm_pose* carrier, float width,
                        colour colour) {
    const bool endless = joint->type == DM_JOINT_CONTINUOUS || joint->upper <= joint->lower;
    const float lower = endless ? -GLM_PIf : joint->lower, upper = endless ? GLM_PIf : joint->upper;
    const dm_vec3 start = far_point(part, joint);
    const bool turns = joint->type != DM_JOINT_PRISMATIC;
    dm_vec3 last = moved(joint, lower, carrier, start);
    for (int i = 1; i <= ARC_STEPS; i++) {
        const dm_vec3 next = moved(joint, lower + (upper - lower) * (float)i / ARC_STEPS, carrier, start);
        draw_line(draw, last, next, width, colour);
        last = next;
    }
    const dm_vec3 level = along(joint->origin, joint->axis, dot(sub(start, joint->origin), joint->axis));
    const dm_vec3 hub = pose_point(carrier, level);
    const struct colour faint = {colour.r, colour.g, colour.b, colour.a * 0.55f};
    if (endless || !turns) return;
    draw_line(draw, hub, moved(joint, lower, carrier, start), width * 0.75f, faint);
    draw_line(draw, hub, moved(joint, upper, carrier, start), width * 0.75f, faint);
}

static void draw_axis(draw* draw, const world_part* part, const dm_joint* joint, const dm_pose* carrier, float width,
                      colour colour) {
    const dm_vec3 axis = pose_direction(carrier, joint->axis);
    const float reach = 0.6f * length(sub(part->box_max, part->box_min));
    const bool slides = joint->type == DM_JOINT_PRISMATIC;
    /* A slide has no line of its own: its arrow starts in the middle of the part. */
    const dm_vec3 off = sub(part->centre, joint->origin);
    const dm_vec3 middle = slides ? part->centre : along(joint->origin, joint->axis, dot(off, joint->axis));
    const dm_vec3 at = pose_point(carrier, middle);
    draw_arrow(draw, along(at, axis, -reach), along(at, axis, reach), width, colour);
}

static bool moves(const dm_joint* joint) {
    return joint->type != DM_JOINT_FIXED && joint->type != DM_JOINT_UNKNOWN;
}

static void draw_joint(const app* app, draw* draw, uint32_t id) {
    const world_part* part = &app->world->parts[id];
    const dm_pose carrier = carrier_pose(app->world, id);
    const float pixel = fmaxf(1, (float)app->camera.height / 420);
    if (!moves(&part->state.joint)) return;
    draw_axis(draw, part, &part->state.joint, &carrier, 2.6f * pixel, axis_colour);
    draw_travel(draw, part, &part->state.joint, &carrier, 2.2f * pixel, limit_colour);
}

/* The hypothesis that is in force already. */
static bool same_line(const dm_joint* a, const dm_joint* b) {
    return a->type == b->type && length(sub(a->axis, b->axis)) < 1e-6f && length(sub(a->origin, b->origin)) < 1e-6f;
}

static void draw_hypotheses(const app* app, draw* draw, uint32_t id) {
    const world_part* part = &app->world->parts[id];
    const dm_pose carrier = carrier_pose(app->world, id);
    for (uint32_t i = 0; i < part->hypothesis_count && i < 4; i++) {
        const dm_joint* other = &part->hypotheses[i];
        if (!moves(other) || same_line(other, &part->state.joint)) continue;
        draw_axis(draw, part, other, &carrier, 1.5f, hypothesis_colour);
        draw_travel(draw, part, other, &carrier, 1.2f, hypothesis_colour);
    }
}

/* ---- key poses ---- */

static void key_pose(const world_part* part, int key, dm_pose* out_pose) {
    const dm_joint* joint = &part->state.joint;
    const float span = joint->type == DM_JOINT_CONTINUOUS ? 2 * GLM_PIf : joint->upper - joint->lower;
    const float start = joint->type == DM_JOINT_CONTINUOUS ? 0 : joint->lower;
    *out_pose = pose_identity;
    if (part->has_keys)
        *out_pose = part->keys[key];
    else
        dm_joint_pose(joint, start + span * (float)key / (DM_MOTION_FRAMES - 1), out_pose);
}

void overlay_ghosts(const app* app, render* render, const surface* surface) {
    const uint32_t id = part_of_interest(app);
    if (!(app->show & SHOW_GHOSTS) || !id || app->painting) return;
    const dm_pose carrier = carrier_pose(app->world, id);
    for (int key = 0; key < DM_MOTION_FRAMES; key++) {
        look ghost = {.tint = {0.25f, 0.55f, 0.95f, 0.11f}};
        key_pose(&app->world->parts[id], key, &ghost.pose);
        dm_pose_multiply(&carrier, &ghost.pose, &ghost.pose);
        render_ghost(render, surface, &app->camera, id, &ghost);
    }
}

/* ---- the hand ---- */

/* From the grabbed point to the pointer: what the joint doesn't allow. */
static void draw_hand(const app* app, draw* draw) {
    const world* world = app->world;
    const dm_pose carrier = carrier_pose(world, world->held);
    const dm_vec3 grabbed = pose_point(&carrier, world->parts[world->held].last.grab_point);
    const float size = fmaxf(3, (float)app->camera.height / 140);
    float p[3];
    if (!camera_project(&app->camera, grabbed, p)) return;
    draw_line_2d(draw, p[0], p[1], app->x, app->y, 1.5f, (colour){1, 1, 1, 0.5f});
    draw_disc(draw, p[0], p[1], size, (colour){0.1f, 0.1f, 0.12f, 0.9f});
    draw_disc(draw, p[0], p[1], size - 1.5f, hand_colour);
}

/* The hands of a scene that plays itself. */
static void draw_acting_hands(const app* app, draw* draw) {
    const script* script = &app->world->script;
    const float size = fmaxf(4, (float)app->camera.height / 70);
    float p[3];
    for (int hand = 0; hand < GAME_HANDS; hand++) {
        if (script->acting[hand] == GAME_NO_HAND || !camera_project(&app->camera, script->hands[hand].point, p))
            continue;
        draw_disc(draw, p[0], p[1], size, (colour){0.1f, 0.1f, 0.12f, 0.9f});
        draw_disc(draw, p[0], p[1], size - 2, hand_colour);
    }
}

static void draw_pointer(const app* app, draw* draw) {
    const float s = fmaxf(8, (float)app->camera.height / 45);
    const colour dark = {0.05f, 0.05f, 0.06f, 0.9f}, light = {1, 1, 1, 1};
    for (int pass = 0; pass < 2; pass++) {
        const colour c = pass ? light : dark;
        const float w = pass ? 1.6f : 4;
        draw_line_2d(draw, app->x, app->y, app->x, app->y + s, w, c);
        draw_line_2d(draw, app->x, app->y, app->x + 0.7f * s, app->y + 0.7f * s, w, c);
        draw_line_2d(draw, app->x, app->y + s, app->x + 0.28f * s, app->y + 0.7f * s, w, c);
        draw_line_2d(draw, app->x + 0.7f * s, app->y + 0.7f * s, app->x + 0.28f * s, app->y + 0.7f * s, w, c);
    }
}

static void draw_brush(const app* app, draw* draw) {
    const float radius = app->brush * app->world->size;
    const dm_vec3 n = app->under.normal, side = perpendicular(n), ahead = cross(n, side);
    dm_vec3 last = along(app->under.point, side, radius);
    for (int i = 1; i <= 32; i++) {
        const float angle = 2 * GLM_PIf * (float)i / 32;
        const dm_vec3 next = along(along(app->under.point, side, radius * cosf(angle)), ahead, radius * sinf(angle));
        draw_line(draw, last, next, 2, hand_colour);
        last = next;
    }
}

void overlay_draw(const app* app, draw* draw) {
    const uint32_t id = part_of_interest(app);
    draw_begin(draw, &app->camera);
    if (id && !app->painting && app->world->object) {
        if (app->show & SHOW_HYPOTHESES) draw_hypotheses(app, draw, id);
        if (app->show & SHOW_AXIS) draw_joint(app, draw, id);
    }
    if (app->painting && app->under.distance > 0) draw_brush(app, draw);
    panel_draw(app, draw, app->painting ? 0 : id);
    if (app->world->held) draw_hand(app, draw);
    if (app->world->acting) draw_acting_hands(app, draw);
    draw_pointer(app, draw);
    draw_end(draw);
}
