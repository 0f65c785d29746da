/* The class DragMeshBody3D as Godot sees it: properties, signals, and what scripts call. */
#include <stdlib.h>
#include <string.h>

#include "library.h"
#include "settings.h"

static const char class_name[] = "DragMeshBody3D", parent_class_name[] = "Node3D";

/* ---- properties ---- */

#define PROPERTY_FUNCTIONS(name, index)                                                                                \
    static gd_value set_##name(void* b, const gd_value* const* a) {                                                    \
        gd_free(&((body*)b)->properties[index]);                                                                       \
        ((body*)b)->properties[index] = gd_copy(a[0]);                                                                 \
        return gd_nil();                                                                                               \
    }                                                                                                                  \
    static gd_value get_##name(void* b, const gd_value* const* a) {                                                    \
        (void)a;                                                                                                       \
        return gd_copy(&((body*)b)->properties[index]);                                                                \
    }
PROPERTY_FUNCTIONS(parts, PROPERTY_PARTS)
PROPERTY_FUNCTIONS(body, PROPERTY_BODY)
PROPERTY_FUNCTIONS(dmo, PROPERTY_DMO)
PROPERTY_FUNCTIONS(dmo_parts, PROPERTY_DMO_PARTS)
PROPERTY_FUNCTIONS(prepare_when_ready, PROPERTY_PREPARE)
PROPERTY_FUNCTIONS(use_names, PROPERTY_NAMES)
PROPERTY_FUNCTIONS(use_pivots, PROPERTY_PIVOTS)
PROPERTY_FUNCTIONS(mouse, PROPERTY_MOUSE)
PROPERTY_FUNCTIONS(release_by_rule, PROPERTY_BY_RULE)
#undef PROPERTY_FUNCTIONS

/* ---- answers ---- */

/* Prints what went wrong: the library has told the log more, where the arguments were at fault. */
static bool fine(dm_result result, const char* function) {
    if (result == DM_OK) return true;
    gd.print_error_with_message(dm_result_string(result), dm_result_string(result), function, "DragMeshBody3D", 0, 0);
    return false;
}

/* The part that the first argument names, of an object that is prepared. */
static part* part_in(body* b, const gd_value* node, const char* function) {
    part* p = b->prepared ? body_part_of(b, node) : NULL;
    if (!p) fine(b->prepared ? DM_ERROR_NOT_FOUND : DM_ERROR_STALE_HANDLE, function);
    return p;
}

static part* dragged_part(body* b, const gd_value* node, const char* function) {
    part* p = part_in(b, node, function);
    if (p && p->drag) return p;
    if (p) fine(DM_ERROR_STALE_HANDLE, function);
    return NULL;
}

static gd_value text_of_result(dm_result result) {
    return gd_of_text(result == DM_OK ? "" : dm_result_string(result));
}

static gd_value empty(void) {
    return gd_new(GDEXTENSION_VARIANT_TYPE_DICTIONARY);
}

/* ---- objects ---- */

static gd_value prepare(void* self, const gd_value* const* a) {
    (void)a;
    body_prepare(self);
    return gd_nil();
}

static gd_value prepare_now(void* self, const gd_value* const* a) {
    (void)a;
    return text_of_result(body_prepare_now(self));
}

static gd_value load(void* self, const gd_value* const* a) {
    (void)a;
    return text_of_result(body_load(self));
}

static gd_value cancel(void* self, const gd_value* const* a) {
    (void)a;
    body* b = self;
    if (b->preparation) atomic_store(&b->preparation->cancelled, true);
    return gd_nil();
}

static gd_value is_prepared(void* self, const gd_value* const* a) {
    (void)a;
    return gd_of_bool(((body*)self)->prepared != 0);
}

static gd_value part_nodes(void* self, const gd_value* const* a) {
    (void)a;
    const body* b = self;
    gd_value out = gd_new(GDEXTENSION_VARIANT_TYPE_ARRAY);
    for (uint32_t i = 0; i < b->part_count; i++) gd_append(&out, part_node(&b->parts[i]));
    return out;
}

static gd_value nodes_of(void* self, const gd_value* const* a) {
    const body* b = self;
    gd_value out = gd_new(GDEXTENSION_VARIANT_TYPE_ARRAY);
    const part* p = part_in(self, a[0], "nodes_of");
    for (uint32_t i = 0; p && i < b->member_count; i++) {
        const member* m = &b->members[i];
        if (m->part == p->id && (m->solid || !b->whole)) gd_append(&out, gd_node(m->node));
    }
    return out;
}

static gd_value carrier(void* self, const gd_value* const* a) {
    body* b = self;
    const part* p = part_in(b, a[0], "carrier");
    const part* above = p ? body_part(b, p->parent) : NULL;
    return above ? part_node(above) : gd_nil();
}

static gd_value library_memory(void* self, const gd_value* const* a) {
    (void)self, (void)a;
    dm_memory_info info = dm_memory_info_default();
    dm_context_get_memory(library_context(), &info);
    return gd_of_int((int64_t)info.bytes);
}

/* ---- joints ---- */

/* The joint in force: the instance's own where a pull has changed it. */
static dm_joint joint_of(body* b, const part* p) {
    dm_joint joint = dm_joint_default();
    if (p->moved && p->state.joint.struct_size)
        joint = p->state.joint;
    else
        dm_object_get_joint(library_context(), b->prepared, p->id, &joint);
    return joint;
}

static gd_value joint(void* self, const gd_value* const* a) {
    const part* p = part_in(self, a[0], "joint");
    if (!p) return empty();
    const dm_joint found = joint_of(self, p);
    return value_of_joint(&found);
}

static gd_value hypotheses(void* self, const gd_value* const* a) {
    gd_value out = gd_new(GDEXTENSION_VARIANT_TYPE_ARRAY);
    const part* p = part_in(self, a[0], "hypotheses");
    if (!p) return out;
    dm_joint all[DM_MAX_HYPOTHESES];
    uint32_t count = 0;
    for (int i = 0; i < DM_MAX_HYPOTHESES; i++) all[i] = dm_joint_default();
    fine(dm_object_get_hypotheses(library_context(), ((body*)self)->prepared, p->id, NULL, all, DM_MAX_HYPOTHESES,
                                  &count),
         "hypotheses");
    for (uint32_t i = 0; i < count; i++) gd_append(&out, value_of_joint(&all[i]));
    return out;
}

static gd_value set_joint(void* self, const gd_value* const* a) {
    part* p = part_in(self, a[0], "set_joint");
    if (!p) return gd_of_bool(false);
    dm_joint joint = dm_joint_default();
    joint_of_value(a[1], &joint);
    return gd_of_bool(
        fine(dm_object_set_joint(library_context(), ((body*)self)->prepared, p->id, &joint), "set_joint"));
}

/* For a joint of the physics engine: the transform's x axis is the hinge or the slide. */
static gd_value joint_frame(void* self, const gd_value* const* a) {
    gd_value out = empty();
    const part* p = part_in(self, a[0], "joint_frame");
    if (!p) return out;
    const dm_joint joint = joint_of(self, p);
    dm_joint_frame frame = dm_joint_frame_default();
    if (!fine(dm_joint_get_frame(&joint, &frame), "joint_frame")) return out;
    const dm_vec3 axes[4] = {frame.x, frame.y, frame.z, frame.origin};
    double t[12];
    for (int i = 0; i < 4; i++) {
        const int start = i < 3 ? i : 9, step = i < 3 ? 3 : 1;
        t[start] = (double)axes[i].x, t[start + step] = (double)axes[i].y, t[start + 2 * step] = (double)axes[i].z;
    }
    gd_put(&out, "type", gd_of_int(frame.type));
    gd_put(&out, "transform", gd_of_transform(t));
    gd_put(&out, "lower", gd_of_float((double)frame.lower));
    gd_put(&out, "upper", gd_of_float((double)frame.upper));
    gd_put(&out, "has_lower", gd_of_bool(frame.limits & DM_LIMIT_LOWER));
    gd_put(&out, "has_upper", gd_of_bool(frame.limits & DM_LIMIT_UPPER));
    return out;
}

/* ---- picks and drags ---- */

static gd_value pick(void* self, const gd_value* const* a) {
    double origin[3], direction[3], distance;
    dm_hit hit;
    gd_vector3(a[0], origin);
    gd_vector3(a[1], direction);
    gd_value out = empty();
    if (!body_pick(self, origin, direction, &hit, &distance)) return out;
    const part* p = body_part(self, hit.part_id);
    gd_put(&out, "part", p ? part_node(p) : gd_nil());
    gd_put(&out, "part_id", gd_of_int(hit.part_id));
    gd_put(&out, "triangle", gd_of_int(hit.triangle));
    gd_put(&out, "point", value_of_vec3(hit.object_point));
    gd_put(&out, "distance", gd_of_float(distance));
    return out;
}

static gd_value grab(void* self, const gd_value* const* a) {
    part* p = part_in(self, a[0], "grab");
    const dm_vec3 point = vec3_of_value(a[1]);
    return gd_of_bool(p && fine(part_grab(self, p, &point, false), "grab"));
}

static gd_value step_with(body* b, part* p, dm_drag_input* input, double seconds) {
    dm_drag_state state;
    if (!fine(part_step(b, p, input, seconds, &state), "step")) return empty();
    const gd_value out = value_of_drag_state(&state);
    body_tell(b);
    return out;
}

static gd_value pull(void* self, const gd_value* const* a) {
    part* p = dragged_part(self, a[0], "pull");
    if (!p) return empty();
    double origin[3], direction[3];
    gd_vector3(a[1], origin);
    gd_vector3(a[2], direction);
    dm_drag_input input = dm_drag_input_default();
    input.hand.kind = DM_HAND_RAY;
    input.hand.ray = body_ray(self, p, origin, direction);
    return step_with(self, p, &input, gd_float(a[3]));
}

/* An optional number of a Dictionary; false: it has none. */
static bool take_number(const gd_value* from, const char* name, float* out) {
    gd_value value = gd_get(from, name);
    const bool there = !gd_is(&value, GDEXTENSION_VARIANT_TYPE_NIL);
    if (there) *out = (float)gd_float(&value);
    gd_free(&value);
    return there;
}

static bool take_flag(const gd_value* from, const char* name) {
    float number = 0;
    return take_number(from, name, &number) && number > 0;
}

static void take_hand(body* b, const part* p, const gd_value* from, dm_hand* out) {
    static const struct {
        const char* name;
        int32_t kind;
    } amounts[] = {{"rate", DM_HAND_RATE}, {"step", DM_HAND_STEP}, {"value", DM_HAND_VALUE}};
    gd_value origin = gd_get(from, "origin"), direction = gd_get(from, "direction");
    if (gd_is(&origin, GDEXTENSION_VARIANT_TYPE_VECTOR3) && gd_is(&direction, GDEXTENSION_VARIANT_TYPE_VECTOR3)) {
        double o[3], d[3];
        gd_vector3(&origin, o);
        gd_vector3(&direction, d);
        out->kind = DM_HAND_RAY;
        out->ray = body_ray(b, p, o, d);
    }
    for (size_t i = 0; i < sizeof amounts / sizeof *amounts; i++)
        if (take_number(from, amounts[i].name, &out->amount)) out->kind = amounts[i].kind;
    gd_free(&direction);
    gd_free(&origin);
}

static gd_value update_input(void* self, const gd_value* const* a) {
    part* p = dragged_part(self, a[0], "update_input");
    if (!p) return empty();
    dm_drag_input input = dm_drag_input_default();
    take_hand(self, p, a[1], &input.hand);
    take_number(a[1], "handle", &input.handles[0]);
    take_number(a[1], "lower", &input.lower);
    take_number(a[1], "upper", &input.upper);
    if (take_flag(a[1], "locked")) input.flags |= DM_INPUT_LOCKED;
    if (take_flag(a[1], "ask")) input.flags |= DM_INPUT_ASK;
    return step_with(self, p, &input, gd_float(a[2]));
}

static gd_value override_value(void* self, const gd_value* const* a) {
    part* p = dragged_part(self, a[0], "override_value");
    dm_drag_state state = dm_drag_state_default();
    if (!p || !fine(dm_drag_override(library_context(), p->drag, (float)gd_float(a[1]), &state), "override_value"))
        return empty();
    part_take(self, p, &state);
    return value_of_drag_state(&state);
}

static gd_value value_of_plan(const dm_release_plan* plan) {
    gd_value out = empty();
    gd_put(&out, "intent", gd_of_int(plan->intent));
    gd_put(&out, "start_value", gd_of_float((double)plan->start_value));
    gd_put(&out, "end_value", gd_of_float((double)plan->end_value));
    gd_put(&out, "duration", gd_of_float((double)plan->duration));
    return out;
}

static gd_value release_part(body* self, part* p, const gd_value* intent, const char* function) {
    dm_release_plan plan = dm_release_plan_default();
    if (!fine(part_release(self, p, gd_enum((double)gd_int(intent)), &plan), function)) return empty();
    return value_of_plan(&plan);
}

static gd_value release(void* self, const gd_value* const* a) {
    part* p = dragged_part(self, a[0], "release");
    return p ? release_part(self, p, a[1], "release") : empty();
}

/* Opens or closes a part by itself. */
static gd_value move(void* self, const gd_value* const* a) {
    part* p = part_in(self, a[0], "move");
    if (!p || !fine(part_grab(self, p, NULL, false), "move")) return empty();
    return release_part(self, p, a[1], "move");
}

static gd_value end(void* self, const gd_value* const* a) {
    part* p = part_in(self, a[0], "end");
    if (p) part_end(p);
    return gd_nil();
}

static gd_value set_locked(void* self, const gd_value* const* a) {
    part* p = part_in(self, a[0], "set_locked");
    if (p) p->locked = gd_bool(a[1]);
    return gd_nil();
}

/* ---- states ---- */

static gd_value value_of(void* self, const gd_value* const* a) {
    const part* p = part_in(self, a[0], "value");
    return gd_of_float(p && p->moved ? (double)p->state.value : 0);
}

static gd_value part_state(void* self, const gd_value* const* a) {
    part* p = part_in(self, a[0], "part_state");
    if (!p) return empty();
    dm_part_state state = dm_part_state_default();
    if (p->drag)
        dm_drag_get_part_state(library_context(), p->drag, &state);
    else if (p->moved)
        state = p->state;
    else
        state.joint = joint_of(self, p), state.pose = (dm_pose){.real = {0, 0, 0, 1}};
    return value_of_part_state(&state);
}

static gd_value restore_part(void* self, const gd_value* const* a) {
    part* p = part_in(self, a[0], "restore_part");
    if (!p) return gd_of_bool(false);
    dm_part_state state = dm_part_state_default();
    state.joint = joint_of(self, p);
    part_state_of_value(a[1], &state);
    /* What can't be taken up by a drag is no state. */
    dm_drag_desc desc = dm_drag_desc_default();
    dm_drag drag;
    desc.object = ((body*)self)->prepared, desc.part_id = p->id, desc.state = &state,
    desc.flags = DM_DRAG_WITHOUT_POINT;
    if (!fine(dm_drag_begin(library_context(), &desc, &drag), "restore_part")) return gd_of_bool(false);
    part_end(p);
    fine(dm_drag_end(library_context(), drag, &state), "restore_part");
    p->state = state, p->moved = true;
    body_show(self, p);
    return gd_of_bool(true);
}

static gd_value reset_part(void* self, const gd_value* const* a) {
    part* p = part_in(self, a[0], "reset_part");
    if (!p) return gd_nil();
    part_end(p);
    p->moved = false;
    p->state = dm_part_state_default();
    body_show(self, p);
    return gd_nil();
}

/* The rigid motion from rest that a node's transform in the object frame shows. */
static dm_result pose_of_node(const body* b, const part* p, dm_pose* out) {
    gd_value node = part_node(p);
    const affine place = body_place_of(b, &node), back = affine_inverse(&p->rest), moved = affine_after(&place, &back);
    gd_value transform = gd_of_transform(moved.m), basis = gd_get(&transform, "basis"),
             rotation = gd_call(&basis, "get_rotation_quaternion", 0, NULL);
    static const char* const names[4] = {"x", "y", "z", "w"};
    float numbers[4] = {0};
    for (int i = 0; i < 4; i++) take_number(&rotation, names[i], &numbers[i]);
    gd_free(&rotation);
    gd_free(&basis);
    gd_free(&transform);
    gd_free(&node);
    return dm_pose_from_rotation(numbers, (dm_vec3){(float)moved.m[9], (float)moved.m[10], (float)moved.m[11]}, out);
}

/* Takes over where something else, as physics, has put the node of a part. */
static gd_value adopt(void* self, const gd_value* const* a) {
    body* b = self;
    part* p = part_in(b, a[0], "adopt");
    gd_value out = empty();
    dm_part_state state = dm_part_state_default();
    float angle = 0, distance = 0;
    if (!p) return out;
    part_end(p);
    state.joint = joint_of(b, p);
    dm_result result = pose_of_node(b, p, &state.pose);
    if (result == DM_OK) result = dm_joint_value(&state.joint, &state.pose, &state.value, &angle, &distance);
    if (!fine(result, "adopt")) return out;
    p->state = state, p->moved = true;
    if (b->scene) body_show(b, p);
    gd_put(&out, "value", gd_of_float((double)state.value));
    gd_put(&out, "angle_error", gd_of_float((double)angle));
    gd_put(&out, "distance_error", gd_of_float((double)distance));
    return out;
}

static gd_value save_drag(void* self, const gd_value* const* a) {
    static uint8_t bytes[DM_DRAG_SNAPSHOT_MAX];
    const part* p = dragged_part(self, a[0], "save_drag");
    const size_t size = dm_drag_snapshot_size();
    if (!p || !fine(dm_drag_save(library_context(), p->drag, bytes, sizeof bytes), "save_drag"))
        return gd_new(GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY);
    return gd_of_bytes(bytes, size);
}

static gd_value restore_drag(void* self, const gd_value* const* a) {
    part* p = dragged_part(self, a[0], "restore_drag");
    if (!p) return gd_of_bool(false);
    return gd_of_bool(
        fine(dm_drag_restore(library_context(), p->drag, gd_bytes(a[1]), (size_t)gd_count(a[1])), "restore_drag"));
}

/* ---- links ---- */

static uint32_t id_in(body* b, const gd_value* from, const char* name) {
    gd_value node = gd_get(from, name);
    const part* p = body_part_of(b, &node);
    gd_free(&node);
    return p ? p->id : 0;
}

static gd_value set_links(void* self, const gd_value* const* a) {
    dm_link links[DM_MAX_LINKS] = {0};
    const int64_t count = gd_count(a[0]);
    if (count > DM_MAX_LINKS) return gd_of_bool(fine(DM_ERROR_TOO_LARGE, "set_links"));
    for (int64_t i = 0; i < count; i++) {
        gd_value row = gd_at(a[0], i);
        float kind = 0;
        take_number(&row, "kind", &kind);
        links[i].driver = id_in(self, &row, "driver"), links[i].driven = id_in(self, &row, "driven");
        links[i].kind = gd_enum((double)kind);
        links[i].flags = take_flag(&row, "both_ways") ? DM_LINK_BOTH_WAYS : 0;
        take_number(&row, "ratio", &links[i].ratio);
        take_number(&row, "offset", &links[i].offset);
        take_number(&row, "from", &links[i].from);
        gd_free(&row);
    }
    return gd_of_bool(
        fine(dm_object_set_links(library_context(), ((body*)self)->prepared, links, (uint32_t)count), "set_links"));
}

static gd_value follow_links(void* self, const gd_value* const* a) {
    body* b = self;
    gd_value out = empty();
    const part* p = part_in(b, a[0], "follow_links");
    const float* given = gd_floats(a[1]); /* a call without types may hand over any array */
    const uint32_t count = given ? (uint32_t)gd_count(a[1]) : 0;
    if (!p || count != b->part_count || !count) return out;
    float* values = malloc(count * sizeof *values);
    uint8_t* held = malloc(count);
    if (values && held) {
        memcpy(values, given, count * sizeof *values);
        if (fine(dm_object_follow_links(library_context(), b->prepared, p->id, values, held, count), "follow_links")) {
            gd_put(&out, "values", gd_of_floats(values, count));
            gd_put(&out, "held", gd_of_bytes(held, count));
        }
    }
    free(held);
    free(values);
    return out;
}

static gd_value advance(void* self, const gd_value* const* a) {
    body_advance(self, gd_float(a[0]));
    return gd_nil();
}

/* ---- the table ---- */

#define BOOL GDEXTENSION_VARIANT_TYPE_BOOL
#define INT GDEXTENSION_VARIANT_TYPE_INT
#define FLOAT GDEXTENSION_VARIANT_TYPE_FLOAT
#define STRING GDEXTENSION_VARIANT_TYPE_STRING
#define VECTOR3 GDEXTENSION_VARIANT_TYPE_VECTOR3
#define ARRAY GDEXTENSION_VARIANT_TYPE_ARRAY
#define DICTIONARY GDEXTENSION_VARIANT_TYPE_DICTIONARY
#define NODE_PATH GDEXTENSION_VARIANT_TYPE_NODE_PATH
#define BYTES GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY
#define STRINGS GDEXTENSION_VARIANT_TYPE_PACKED_STRING_ARRAY
#define FLOATS GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT32_ARRAY
#define NONE GDEXTENSION_VARIANT_TYPE_NIL
#define NODE                                                                                                           \
    { "part", GDEXTENSION_VARIANT_TYPE_OBJECT, "Node3D" }
#define PROPERTY(name, type)                                                                                           \
    {"set_" #name, set_##name, NONE, false, {{"value", type, NULL}}}, {                                                \
        "get_" #name, get_##name, type, false, {                                                                       \
            { 0 }                                                                                                      \
        }                                                                                                              \
    }

static const gd_method_row methods[] = {
    PROPERTY(parts, ARRAY),
    PROPERTY(body, NODE_PATH),
    PROPERTY(dmo, BYTES),
    PROPERTY(dmo_parts, STRINGS),
    PROPERTY(prepare_when_ready, BOOL),
    PROPERTY(use_names, BOOL),
    PROPERTY(use_pivots, BOOL),
    PROPERTY(mouse, BOOL),
    PROPERTY(release_by_rule, BOOL),
    {"prepare", prepare, NONE, false, {{0}}},
    {"prepare_now", prepare_now, STRING, false, {{0}}},
    {"load_prepared", load, STRING, false, {{0}}},
    {"cancel", cancel, NONE, false, {{0}}},
    {"is_prepared", is_prepared, BOOL, false, {{0}}},
    {"part_nodes", part_nodes, ARRAY, false, {{0}}},
    {"nodes_of", nodes_of, ARRAY, false, {NODE}},
    {"carrier", carrier, GDEXTENSION_VARIANT_TYPE_OBJECT, false, {NODE}},
    {"library_memory", library_memory, INT, false, {{0}}},
    {"joint", joint, DICTIONARY, false, {NODE}},
    {"hypotheses", hypotheses, ARRAY, false, {NODE}},
    {"set_joint", set_joint, BOOL, false, {NODE, {"joint", DICTIONARY, NULL}}},
    {"joint_frame", joint_frame, DICTIONARY, false, {NODE}},
    {"pick", pick, DICTIONARY, false, {{"origin", VECTOR3, NULL}, {"direction", VECTOR3, NULL}}},
    {"grab", grab, BOOL, false, {NODE, {"point", VECTOR3, NULL}}},
    {"pull",
     pull,
     DICTIONARY,
     false,
     {NODE, {"origin", VECTOR3, NULL}, {"direction", VECTOR3, NULL}, {"delta", FLOAT, NULL}}},
    {"update_input", update_input, DICTIONARY, false, {NODE, {"input", DICTIONARY, NULL}, {"delta", FLOAT, NULL}}},
    {"override_value", override_value, DICTIONARY, false, {NODE, {"value", FLOAT, NULL}}},
    /* Their names in 0.2. */
    {"step", update_input, DICTIONARY, false, {NODE, {"input", DICTIONARY, NULL}, {"delta", FLOAT, NULL}}},
    {"take", override_value, DICTIONARY, false, {NODE, {"value", FLOAT, NULL}}},
    {"release", release, DICTIONARY, false, {NODE, {"intent", INT, NULL}}},
    {"move", move, DICTIONARY, false, {NODE, {"intent", INT, NULL}}},
    {"end", end, NONE, false, {NODE}},
    {"set_locked", set_locked, NONE, false, {NODE, {"locked", BOOL, NULL}}},
    {"value", value_of, FLOAT, false, {NODE}},
    {"part_state", part_state, DICTIONARY, false, {NODE}},
    {"restore_part", restore_part, BOOL, false, {NODE, {"state", DICTIONARY, NULL}}},
    {"adopt", adopt, DICTIONARY, false, {NODE}},
    {"reset_part", reset_part, NONE, false, {NODE}},
    {"save_drag", save_drag, BYTES, false, {NODE}},
    {"restore_drag", restore_drag, BOOL, false, {NODE, {"bytes", BYTES, NULL}}},
    {"set_links", set_links, BOOL, false, {{"links", ARRAY, NULL}}},
    {"follow_links", follow_links, DICTIONARY, false, {NODE, {"values", FLOATS, NULL}}},
    {"advance", advance, NONE, false, {{"delta", FLOAT, NULL}}},
};

/* ---- the class ---- */

enum { NOTIFICATION_EXTENSION_RELOADED = 2, NOTIFICATION_READY = 13, NOTIFICATION_PROCESS = 17 }; /* of Object, Node */

static void notified(GDExtensionClassInstancePtr instance, int32_t what, GDExtensionBool reversed) {
    (void)reversed;
    if (what == NOTIFICATION_READY || what == NOTIFICATION_EXTENSION_RELOADED) body_ready(instance);
    if (what == NOTIFICATION_PROCESS) body_process(instance);
}

static gd_name class_id, unhandled_input;

static GDExtensionClassInstancePtr recreate(void* data, GDExtensionObjectPtr object) {
    (void)data;
    return body_new(object);
}

enum { NOTIFICATION_POSTINITIALIZE = 0 };

static GDExtensionObjectPtr create(void* data, GDExtensionBool notify) {
    gd_name parent = gd_name_of(parent_class_name);
    const GDExtensionObjectPtr object = gd.classdb_construct_object2(&parent);
    gd_name_free(&parent);
    gd.object_set_instance(object, &class_id, recreate(data, object));
    if (notify) {
        gd_value self = gd_of_object(object), what = gd_of_int(NOTIFICATION_POSTINITIALIZE);
        gd_do(&self, "notification", 1, &what);
        gd_free(&what);
        gd_free(&self);
    }
    return object;
}

static void destroy(void* data, GDExtensionClassInstancePtr instance) {
    (void)data;
    body_free(instance);
}

static void on_input(GDExtensionClassInstancePtr instance, const GDExtensionConstTypePtr* arguments,
                     GDExtensionTypePtr out) {
    (void)out;
    gd_value event = gd_of_object(gd.ref_get_object(arguments[0]));
    body_input(instance, &event);
    gd_free(&event);
}

static GDExtensionClassCallVirtual find_virtual(void* data, GDExtensionConstStringNamePtr name, uint32_t hash) {
    (void)data, (void)hash;
    return ((const gd_name*)name)->data == unhandled_input.data ? on_input : NULL;
}

void body_register(GDExtensionClassLibraryPtr library) {
    class_id = gd_name_of(class_name);
    unhandled_input = gd_name_of("_unhandled_input");
    gd_name parent = gd_name_of(parent_class_name);
    const GDExtensionClassCreationInfo4 info = {
        .is_exposed = true,
        .notification_func = notified,
        .create_instance_func = create,
        .free_instance_func = destroy,
        .recreate_instance_func = recreate,
        .get_virtual_func = find_virtual,
    };
    gd.classdb_register_extension_class4(library, &class_id, &parent, &info);
    gd_name_free(&parent);
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) gd_register_method(library, class_name, &methods[i]);
    for (int i = 0; i < PROPERTIES; i++) gd_register_property(library, class_name, &body_properties[i]);
    const gd_argument progress[GD_MOST_ARGUMENTS] = {{"share", FLOAT, NULL}},
                      error[GD_MOST_ARGUMENTS] = {{"error", STRING, NULL}};
    gd_register_signal(library, class_name, "progress", progress);
    gd_register_signal(library, class_name, "prepared", error);
    body_register_signals(library, class_name);
}

void body_unregister(GDExtensionClassLibraryPtr library) {
    gd.classdb_unregister_extension_class(library, &class_id);
    gd_name_free(&unhandled_input);
    gd_name_free(&class_id);
}
