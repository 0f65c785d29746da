/* Drags of parts, picks and the signals of what happens to parts. */
#include <math.h>

#include "library.h"
#include "settings.h"

static affine place_in_world(const body* b) {
    affine out = affine_identity();
    gd_value self = body_self(b), inside = gd_call(&self, "is_inside_tree", 0, NULL);
    if (gd_bool(&inside)) {
        gd_value transform = gd_call(&self, "get_global_transform", 0, NULL);
        gd_transform(&transform, out.m);
        gd_free(&transform);
    }
    gd_free(&inside);
    gd_free(&self);
    return out;
}

dm_ray body_ray(body* b, const part* p, const double origin[3], const double direction[3]) {
    const affine world = place_in_world(b);
    affine back = affine_inverse(&world);
    if (p && p->parent) {
        const dm_pose carrier = body_carrier(b, p);
        const affine carried = affine_of_pose(&carrier), from = affine_inverse(&carried);
        back = affine_after(&from, &back);
    }
    return (dm_ray){affine_point(&back, origin), affine_vector(&back, direction)};
}

bool body_pick(body* b, const double origin[3], const double direction[3], dm_hit* out, double* distance) {
    *out = dm_hit_default();
    const dm_ray ray = body_ray(b, NULL, origin, direction);
    if (!b->scene || dm_scene_commit(library_context(), b->scene) != DM_OK ||
        dm_scene_pick(library_context(), b->scene, &ray, out) != DM_OK || !out->object)
        return false;
    const affine world = place_in_world(b);
    const double at[3] = {(double)out->object_point.x, (double)out->object_point.y, (double)out->object_point.z};
    const dm_vec3 there = affine_point(&world, at);
    const double offset[3] = {(double)there.x - origin[0], (double)there.y - origin[1], (double)there.z - origin[2]};
    *distance = sqrt(offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]);
    return true;
}

dm_result part_grab(body* b, part* p, const dm_vec3* point, bool by_mouse) {
    part_end(p);
    dm_drag_rules rules = p->settings.rules;
    rules.snaps = rules.snap_count ? p->settings.snaps : NULL;
    dm_drag_desc desc = dm_drag_desc_default();
    desc.object = b->prepared, desc.part_id = p->id, desc.feel = p->settings.feel, desc.rules = &rules;
    if (p->moved) desc.state = &p->state;
    if (point) {
        dm_pose back = body_carrier(b, p);
        dm_pose_inverse(&back, &back);
        dm_pose_apply_points(&back, &point->x, 0, &desc.grab_point.x, 0, 1);
    } else {
        desc.flags = DM_DRAG_WITHOUT_POINT;
    }
    const dm_result result = dm_drag_begin(library_context(), &desc, &p->drag);
    if (result != DM_OK) return result;
    p->held = true, p->by_mouse = by_mouse;
    return DM_OK;
}

void part_take(body* b, part* p, const dm_drag_state* state) {
    p->moved = true;
    p->state.value = state->value, p->state.pose = state->pose;
    body_show(b, p);
}

dm_result part_step(body* b, part* p, dm_drag_input* input, double seconds, dm_drag_state* out) {
    if (p->locked) input->flags |= DM_INPUT_LOCKED;
    for (int i = 0; i < HANDLES; i++) {
        const part* handle = body_part(b, p->settings.handles[i]);
        if (handle && handle->moved) input->handles[i] = handle->state.value;
    }
    *out = dm_drag_state_default();
    const dm_result result = dm_drag_update_input(library_context(), p->drag, input, (float)seconds, out);
    if (result != DM_OK) return result;
    p->events |= out->events;
    part_take(b, p, out);
    return DM_OK;
}

dm_result part_release(body* b, part* p, int32_t intent, dm_release_plan* out) {
    dm_release_desc desc = dm_release_desc_default();
    desc.intent = intent;
    if (gd_bool(&b->properties[PROPERTY_BY_RULE])) desc.flags = DM_RELEASE_BY_RULE;
    p->held = p->by_mouse = false;
    return dm_drag_release(library_context(), p->drag, &desc, out);
}

static const struct {
    uint32_t event;
    const char* signal;
} signals[] = {
    {DM_EVENT_LIMIT_LOWER, "limit_lower"}, {DM_EVENT_LIMIT_UPPER, "limit_upper"},
    {DM_EVENT_LEFT_REST, "left_rest"},     {DM_EVENT_REACHED_REST, "reached_rest"},
    {DM_EVENT_OPENED, "opened"},           {DM_EVENT_CLOSED, "closed"},
    {DM_EVENT_DETENT, "detent"},           {DM_EVENT_JOINT, "joint_changed"},
    {DM_EVENT_BLOCKED, "blocked"},         {DM_EVENT_FREED, "freed"},
    {DM_EVENT_LATCHED, "latched"},         {DM_EVENT_UNLATCHED, "unlatched"},
    {DM_EVENT_LOCKED, "locked_tried"},     {DM_EVENT_LET_GO, "let_go"},
};
enum { SIGNALS = sizeof signals / sizeof *signals };

void body_register_signals(GDExtensionClassLibraryPtr library, const char* class_name) {
    const gd_argument part_argument[GD_MOST_ARGUMENTS] = {{"part", GDEXTENSION_VARIANT_TYPE_OBJECT, "Node3D"}};
    for (int i = 0; i < SIGNALS; i++) gd_register_signal(library, class_name, signals[i].signal, part_argument);
}

void body_tell(body* b) {
    const GDObjectInstanceID id = gd.object_get_instance_id(b->object);
    for (uint32_t i = 0; i < b->part_count; i++) {
        const uint32_t events = b->parts[i].events;
        if (!events) continue;
        b->parts[i].events = 0;
        gd_value self = body_self(b), node = part_node(&b->parts[i]);
        for (int s = 0; s < SIGNALS && gd.object_get_instance_from_id(id); s++) {
            if (!(events & signals[s].event)) continue;
            gd_value arguments[2] = {gd_of_text(signals[s].signal), node};
            gd_do(&self, "emit_signal", 2, arguments);
            gd_free(&arguments[0]);
        }
        gd_free(&node);
        gd_free(&self);
        if (!gd.object_get_instance_from_id(id)) return;
    }
}
