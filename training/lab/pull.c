/* Draws the pulls of training cases: where a hand takes hold of the part, and which way it pulls. */
#include "pull.h"

#include <math.h>
#include <string.h>

#include "kinematics/inference/hypotheses.h"
#include "math/linear3.h"

#define EXACT_OF_CAREFUL 0.4f /* share of the careful pulls that have no error; by hand */
#define CLOSING 0.4f          /* share of pulls that close a joint which has room for that; by hand */
#define CLOSING_ROOM 0.2f     /* of the range, that closing needs; by hand */
#define SHORTEST_CHORD 0.1f   /* share of the way to where the hand wants the point, at least; by hand */
#define LONGEST_CHORD 2.0f    /* rad: of a turn that a hand makes in one straight pull; by hand */
#define STEADY 0.5f           /* share of the straight pulls that have no error of their own; by hand */
#define LEAST_REACH 0.3f      /* of the part's farthest distance from the axis, of a grabbed point; as dmg_drag */
#define HANDLE_DEPTH 0.02f    /* object sizes: what is so near to the foremost point belongs to a handle; by hand */
#define RADIAN 0.01745329f    /* in a degree */
#define HALF_TURN 3.14159265f

/* The mixture: shares of the kinds of pulls, and of the places where each takes hold; by hand. Half of the pulls are
 * what a careful hand or a host that knows the joint makes; the others are straight, as people pull
 * (docs/research/trials_joints.md). */
static const struct {
    float share;
    float far_end, handle; /* of the kind's grabs; the others are anywhere on the part */
} mixture[DM_LAB_PULL_MIXED] = {
    [DM_LAB_PULL_TANGENT] = {0.30f, 0.2f, 0.2f}, [DM_LAB_PULL_EXACT] = {0.25f, 0.2f, 0.2f},
    [DM_LAB_PULL_CHORD] = {0.22f, 0.5f, 0.3f},   [DM_LAB_PULL_ROOM] = {0.15f, 0.5f, 0.3f},
    [DM_LAB_PULL_SCREEN] = {0.08f, 0.5f, 0.3f},
};

static int32_t draw_kind(dmi_random* random, int32_t pull) {
    if (pull < DM_LAB_PULL_MIXED) return pull;
    float left = dmi_random_unit(random);
    if (pull == DM_LAB_PULL_CAREFUL) return left < EXACT_OF_CAREFUL ? DM_LAB_PULL_EXACT : DM_LAB_PULL_TANGENT;
    int32_t kind = 0;
    while (kind + 1 < DM_LAB_PULL_MIXED && left >= mixture[kind].share) left -= mixture[kind++].share;
    return kind;
}

static const float* vertex_of(const dmi_mesh* mesh, uint32_t face, int corner) {
    return mesh->positions + 3 * (size_t)mesh->indices[3 * (size_t)face + (size_t)corner];
}

static int turns(const dm_joint* joint) {
    return joint->type != DM_JOINT_PRISMATIC;
}

static float reach(const dm_joint* joint, const float point[3]) {
    const float axis[3] = {joint->axis.x, joint->axis.y, joint->axis.z};
    const float origin[3] = {joint->origin.x, joint->origin.y, joint->origin.z};
    return dmi_line_distance3(point, axis, origin);
}

/* Finds the vertex of the part, and of what it carries, that is farthest from the axis. Returns its distance. */
static float far_end(const lab_case* made, uint32_t part, float out[3]) {
    const dmi_mesh* mesh = made->mesh;
    float most = -1;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (!dmi_mesh_moves_with(mesh, mesh->face_part[f], part)) continue;
        for (int k = 0; k < 3; k++) {
            const float distance = reach(&made->joint, vertex_of(mesh, f, k));
            if (distance > most) most = distance, dmi_copy3(vertex_of(mesh, f, k), out);
        }
    }
    return most;
}

/* Draws one of the foremost vertices, as the part's centre starts to move: of a handle, where there is one. */
static void handle(lab_case* made, uint32_t part, float along, float out[3]) {
    const dmi_mesh* mesh = made->mesh;
    float way[3], most = -INFINITY;
    uint32_t seen = 0;
    dmi_joint_velocity(&made->joint, 0, mesh->parts[part].centre, way);
    if (!(dmi_normalize3(way) > 0)) return;
    for (int pass = 0; pass < 2; pass++)
        for (uint32_t f = 0; f < mesh->face_count; f++) {
            if (!dmi_mesh_moves_with(mesh, mesh->face_part[f], part)) continue;
            for (int k = 0; k < 3; k++) {
                const float* vertex = vertex_of(mesh, f, k);
                const float ahead = along * dmi_dot3(vertex, way);
                if (pass == 0) most = fmaxf(most, ahead);
                if (pass == 1 && ahead > most - HANDLE_DEPTH && dmi_random_u32(&made->random) % ++seen == 0)
                    dmi_copy3(vertex, out);
            }
        }
}

/* Moves the grabbed point to a handle or the far end. Of a turn, a point that is too near the axis stays where it was.
 */
static void draw_grab(lab_case* made, int32_t kind, float along, float point[3]) {
    const uint32_t part = (uint32_t)dmi_mesh_find_part(made->mesh, made->part);
    const float pick = dmi_random_unit(&made->random);
    float farthest[3] = {0}, found[3];
    const float most = turns(&made->joint) ? far_end(made, part, farthest) : 0;
    dmi_copy3(point, found);
    if (pick < mixture[kind].handle)
        handle(made, part, along, found);
    else if (pick < mixture[kind].handle + mixture[kind].far_end && turns(&made->joint))
        dmi_copy3(farthest, found);
    if (!turns(&made->joint) || reach(&made->joint, found) >= LEAST_REACH * most) dmi_copy3(found, point);
}

/* Rotates a unit vector about a random perpendicular axis by degrees x |N(0, 1)|. */
static void shake(dmi_random* random, float degrees, float way[3]) {
    float about[3], rotation[9];
    lab_random_direction(random, about);
    dmi_reject3(about, way);
    if (!(dmi_normalize3(about) > 0)) return;
    lab_rotation(about, degrees * RADIAN * fabsf(dmi_random_normal(random)), rotation);
    lab_rotate(rotation, way, way);
}

/* Computes the nearest to `way` of the six directions along a frame's axes, the columns of a rotation. */
static void snap(const float rotation[9], float way[3]) {
    float most = 0, nearest[3] = {0, 0, 0};
    for (int k = 0; k < 3; k++) {
        const float axis[3] = {rotation[k], rotation[3 + k], rotation[6 + k]}, along = dmi_dot3(axis, way);
        if (fabsf(along) <= fabsf(most)) continue;
        most = along;
        for (int i = 0; i < 3; i++) nearest[i] = along < 0 ? -axis[i] : axis[i];
    }
    dmi_copy3(nearest, way);
}

/* Draws how far the joint goes when its point ends where the hand pulls it to. along: +1 opens, -1 closes. */
static float draw_travel(lab_case* made, float along) {
    const dm_joint* joint = &made->joint;
    const float limit = along < 0 ? -joint->lower : joint->upper;
    const float most = joint->type == DM_JOINT_CONTINUOUS ? LONGEST_CHORD : fminf(limit, LONGEST_CHORD);
    return along * most * lab_random_uniform(&made->random, SHORTEST_CHORD, 1.0f);
}

/* Computes the unit way of a pull from `point`; zero where the point does not move. along: +1 opens, -1 closes. Returns
 * how far a chord goes, object sizes; 0 for other pulls, which go as far as the hand likes. */
static float draw_way(lab_case* made, int32_t kind, float along, const float point[3], float way[3]) {
    float screen[9], about[3];
    dmi_joint_velocity(&made->joint, 0, point, way);
    for (int i = 0; i < 3; i++) way[i] *= along;
    if (kind == DM_LAB_PULL_CHORD && turns(&made->joint)) {
        dmi_joint_move(&made->joint, draw_travel(made, along), point, way);
        dmi_sub3(way, point, way);
    } else if (kind == DM_LAB_PULL_ROOM) {
        snap(made->rotation, way);
    } else if (kind == DM_LAB_PULL_SCREEN) {
        lab_random_direction(&made->random, about);
        lab_rotation(about, lab_random_uniform(&made->random, 0.0f, HALF_TURN), screen);
        snap(screen, way);
    }
    const float length = dmi_normalize3(way);
    return kind == DM_LAB_PULL_CHORD && turns(&made->joint) ? length : 0;
}

/* Draws a point of the part and the way in which it starts to move. along: +1 opens, -1 closes. */
static dmi_drag_hint draw_tangent(lab_case* made, float noise, float* out_along) {
    float point[3], vector[3];
    dmg_drag(&made->object, made->part, noise, dmi_random_u32(&made->random), point, vector);
    const dm_joint* joint = &made->joint;
    const int closing =
        joint->type == DM_JOINT_CONTINUOUS || -joint->lower > CLOSING_ROOM * (joint->upper - joint->lower);
    *out_along = closing && lab_random_bool(&made->random, CLOSING) ? -1 : 1;
    for (int i = 0; i < 3; i++) vector[i] *= *out_along;
    dmi_drag_hint hint;
    dmi_frame_point_in(&made->mesh->frame, (const double[3]){point[0], point[1], point[2]}, hint.point);
    dmi_frame_vector_in(&made->mesh->frame, vector, hint.vector);
    return hint;
}

/* Changes a drag along the tangent to a pull of the kind. noise: degrees. */
static void pull_as(lab_case* made, int32_t kind, float noise, float along, dmi_drag_hint* hint) {
    float way[3];
    draw_grab(made, kind, along, hint->point);
    const float chord = draw_way(made, kind, along, hint->point, way);
    const float length = chord > 0 ? chord : dmi_length3(hint->vector);
    if (kind == DM_LAB_PULL_TANGENT || (kind != DM_LAB_PULL_EXACT && !lab_random_bool(&made->random, STEADY)))
        shake(&made->random, noise, way);
    if (!(dmi_length3(way) > 0)) return;
    for (int i = 0; i < 3; i++) hint->vector[i] = length * way[i];
}

dmi_drag_hint lab_case_drag(lab_case* made, int32_t pull, float noise_degrees, dm_joint* out_joint) {
    const int32_t kind = draw_kind(&made->random, pull);
    const int anywhere = pull == DM_LAB_PULL_CAREFUL || pull == DM_LAB_PULL_TANGENT || pull == DM_LAB_PULL_EXACT;
    const float noise = lab_random_uniform(&made->random, 0.0f, kind == DM_LAB_PULL_EXACT ? 0.0f : noise_degrees);
    float along;
    dmi_drag_hint hint = draw_tangent(made, kind == DM_LAB_PULL_TANGENT ? noise : 0.0f, &along);
    if (!anywhere) pull_as(made, kind, noise, along, &hint);
    *out_joint = made->joint;
    dmi_joint_orient(out_joint, &hint);
    return hint;
}
