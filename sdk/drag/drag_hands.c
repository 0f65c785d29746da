/* What hands other than one pointer ask for: a hand in space, a scalar, two hands. */
#include <math.h>

#include "drag/drag_pointer.h"
#include "math/elementary.h"
#include "math/linear3.h"

#define EYE_DISTANCE 8.0f /* sizes of the part, from the grabbed point to an eye; by hand */
#define PRESS_TIME 0.25f  /* s at an estimated limit before it gives to a rate; by hand */

static const float eye_directions[DMI_HAND_EYES][3] = {{0.66f, 0.53f, 0.53f}, {-0.53f, 0.66f, 0.53f}};

/* ---- the first hand ---- */

/* What a hand asks for in one update. */
typedef struct wish {
    float value;  /* joint value */
    float motion; /* way of the hand since the last update, host units */
    float weight; /* squared speed of what it holds, host units a unit of the joint value */
} wish;

static float squared_speed(const dmi_drag* drag, const float rest_point[3]) {
    float velocity[3];
    dmi_joint_velocity(&drag->joint, 0, rest_point, velocity);
    return dmi_dot3(velocity, velocity);
}

static void show_to_tracker(dmi_drag* drag, float nearest) {
    const float distance = EYE_DISTANCE * drag->tracker.grasp.size;
    float eye[3], way[3];
    if (drag->tracker.count == 0) return;
    dmi_madd3(drag->rest_point, distance, eye_directions[drag->hands.eye], eye);
    drag->hands.eye = (drag->hands.eye + 1) % DMI_HAND_EYES;
    dmi_sub3(drag->hands.point, eye, way);
    if (!(dmi_normalize3(way) > 0)) return;
    const dm_ray ray = {dmi_vec3(eye), dmi_vec3(way)};
    const dmi_projection of_rays = drag->projection;
    drag->projection = DMI_PERSPECTIVE;
    dmi_drag_track(drag, nearest, &ray);
    drag->projection = of_rays;
}

/* Returns what a hand in space asks for. The vector from the hand to the grabbed point stays as in its first update. */
static wish wish_of_point(dmi_drag* drag, const dm_hand* hand) {
    dmi_hands* hands = &drag->hands;
    const dmi_float3 given = dmi_xyz(hand->point);
    float before[3];
    if (!hands->has_offset) dmi_sub3(drag->point, given.v, hands->offset);
    dmi_copy3(hands->has_offset ? hands->point : drag->point, before);
    hands->has_offset = true;
    dmi_madd3(given.v, 1, hands->offset, hands->point);
    const dmi_span span = dmi_drag_span(drag, false);
    const float value =
        dmi_follow_point(&drag->joint, drag->rest_point, hands->point, drag->pointer_value, span.lower, span.upper);
    return (wish){dmi_clamp_within(value, DMI_LARGEST), dmi_distance3(hands->point, before),
                  squared_speed(drag, drag->rest_point)};
}

static wish wish_of_first(dmi_drag* drag, const dm_hand* hand, dm_ray* out_ray) {
    const wish none = {.value = drag->pointer_value};
    if (hand->kind == DM_HAND_POINT) return wish_of_point(drag, hand);
    if (hand->kind != DM_HAND_RAY || !dmi_drag_read_ray(drag, &hand->ray, out_ray)) return none;
    const float value = dmi_drag_nearest(drag, out_ray), motion = dmi_drag_ray_motion(drag, out_ray);
    drag->last_ray = *out_ray;
    return (wish){value, motion, squared_speed(drag, drag->rest_point)};
}

/* ---- the second hand ---- */

static void take_hold(dmi_drag* drag, const dm_hand* hand) {
    const dm_pose shown = dmi_drag_shown_pose(drag), back = dmi_pose_inverse(&shown);
    drag->hands.second = (dmi_second_hand){.on = true, .value = drag->pointer_value};
    dmi_pose_apply(&back, dmi_xyz(hand->grab_point).v, drag->hands.second.rest_point);
}

/* Returns the value nearest to the second hand, without its bias. */
static float nearest_to_second(const dmi_drag* drag, const dm_hand* hand) {
    const dmi_second_hand* second = &drag->hands.second;
    const dmi_span span = dmi_drag_span(drag, false);
    float value = second->value;
    dm_ray ray;
    if (hand->kind == DM_HAND_POINT)
        value =
            dmi_follow_point(&drag->joint, second->rest_point, dmi_xyz(hand->point).v, value, span.lower, span.upper);
    else if (dmi_drag_unit_ray(&hand->ray, &ray))
        value = dmi_follow_ray(&drag->joint, second->rest_point, &ray, drag->projection, value, span.lower, span.upper);
    return dmi_clamp_within(value, DMI_LARGEST);
}

static wish wish_of_second(dmi_drag* drag, const dm_hand* hand) {
    dmi_second_hand* second = &drag->hands.second;
    if (!second->on) take_hold(drag, hand);
    const float value = nearest_to_second(drag, hand), weight = squared_speed(drag, second->rest_point);
    if (!second->placed) second->bias = drag->pointer_value - value, second->value = value;
    second->placed = true;
    const float motion = fabsf(value - second->value) * sqrtf(weight);
    second->value = value;
    return (wish){value + second->bias, motion, weight};
}

/* ---- all of them ---- */

static void follow_hands(dmi_drag* drag, const dm_drag_input* input, float dt) {
    dmi_hands* hands = &drag->hands;
    dm_ray ray = {{0, 0, 0}, {0, 0, 0}};
    const wish first = wish_of_first(drag, &input->hand, &ray);
    wish all = first;
    all.value += first.weight > 0 ? hands->bias : 0;
    if (input->second.kind != DM_HAND_NONE) {
        const wish second = wish_of_second(drag, &input->second);
        const float weight = all.weight + second.weight;
        if (weight > 0) all.value = (all.weight * all.value + second.weight * second.value) / weight;
        all.motion += second.motion;
    } else if (hands->second.on) { /* the second hand has let go, and the first one holds on where the part is */
        hands->second.on = false;
        if (first.weight > 0) hands->bias = drag->pointer_value - first.value;
        all.value = drag->pointer_value;
    }
    dmi_drag_move_pointer(drag, all.value, all.motion, dt);
    dmi_drag_ask(drag);
    if (hands->second.on || hands->bias != 0) return; /* neither of two hands shows the joint */
    if (input->hand.kind == DM_HAND_POINT) show_to_tracker(drag, first.value);
    if (input->hand.kind == DM_HAND_RAY && first.weight > 0) dmi_drag_track(drag, first.value, &ray);
}

/* Returns the joint value that moves the part by its whole range towards its open end. */
static float open_range(const dmi_drag* drag) {
    const dm_joint joint = dmi_drag_found_joint(drag);
    const float range = dmi_rules_range(&drag->rules, &joint);
    return dmi_joint_has_limits(&joint) && dmi_joint_opened(&joint) == joint.lower ? -range : range;
}

static float clamp_to_span(dmi_span span, float value) {
    return dmi_fminf(dmi_fmaxf(value, span.lower), span.upper);
}

/* Returns a pointer value inside those of the limits. Estimated limits stop a scalar at first. They give when it asks
 * for more, as they do to a pull: to a rate after PRESS_TIME, to a wheel by one step more. */
static float inside_limits(dmi_drag* drag, const dm_hand* hand, float value, float dt) {
    const dmi_span limits = drag->pointer_span;
    const float before = drag->pointer_value, stop = clamp_to_span(limits, value), pressed = drag->hands.pressed;
    drag->hands.pressed = 0;
    if (!drag->limits_are_estimates || stop == value || hand->kind == DM_HAND_VALUE) return stop;
    const bool gives = before != clamp_to_span(limits, before) || (hand->kind == DM_HAND_STEP && pressed > 0);
    if (!gives) {
        /* s of this update that the value was beyond the stop. */
        const float beyond = dt * (value - stop) / (value - before);
        drag->hands.pressed = hand->kind == DM_HAND_STEP ? PRESS_TIME : pressed + beyond;
        if (hand->kind == DM_HAND_STEP || drag->hands.pressed <= PRESS_TIME) return stop;
        value = stop + (value - stop) * dmi_fminf((drag->hands.pressed - PRESS_TIME) / beyond, 1);
    }
    return dmi_fminf(dmi_fmaxf(value, drag->reachable_lower), drag->reachable_upper);
}

static void follow_scalar(dmi_drag* drag, const dm_hand* hand, float dt) {
    if (drag->joint.type == DM_JOINT_FIXED) return;
    const float range = open_range(drag), speed = drag->rules.on ? drag->rules.drive_speed : 1;
    float value = drag->pointer_value;
    if (hand->kind == DM_HAND_RATE) value += hand->amount * speed * range * dt;
    if (hand->kind == DM_HAND_STEP) value += hand->amount * range;
    if (hand->kind == DM_HAND_VALUE) value = dmi_drag_pointer_value(drag, dmi_joint_clamp(&drag->joint, hand->amount));
    value = dmi_clamp_within(value, DMI_LARGEST);
    if (dmi_joint_has_limits(&drag->joint)) value = inside_limits(drag, hand, value, dt);
    drag->pointer_value = value;
    dmi_drag_ask(drag);
}

void dmi_drag_aim(dmi_drag* drag, const dm_drag_input* input, float dt) {
    if (input->hand.kind > DM_HAND_POINT)
        follow_scalar(drag, &input->hand, dt);
    else
        follow_hands(drag, input, dt);
}

float dmi_drag_hand_miss(const dmi_drag* drag) {
    const int32_t kind = drag->hands.kind;
    const dm_vec3 d = drag->last_ray.direction;
    float shown[3], nearest[3];
    if (kind > DM_HAND_POINT) return 0;
    dmi_joint_move(&drag->joint, drag->value, drag->rest_point, shown);
    if (kind == DM_HAND_POINT) return dmi_distance3(shown, drag->hands.point);
    if (d.x == 0 && d.y == 0 && d.z == 0) return 0;
    dmi_ray_closest_point(&drag->last_ray, shown, nearest);
    return dmi_distance3(shown, nearest);
}
