#include "settings.h"

#include <string.h>

typedef struct number_field {
    const char* name;
    size_t offset;
} number_field;

#define RULE(name)                                                                                                     \
    { #name, offsetof(dm_drag_rules, name) }
static const number_field rule_fields[] = {
    RULE(snap_reach),       RULE(open_share),       RULE(closed_share),   RULE(event_time),
    RULE(max_speed),        RULE(max_acceleration), RULE(lock_give),      RULE(latch_turn),
    RULE(auto_close_share), RULE(auto_close_time),  RULE(close_delay),    RULE(tip_share),
    RULE(fall_time),        RULE(restitution),      RULE(break_distance), RULE(drive_speed),
};
#undef RULE

#define FEEL(name)                                                                                                     \
    { #name, offsetof(dm_drag_feel, name) }
static const number_field feel_fields[] = {
    FEEL(smoothing_time), FEEL(soft_limit), FEEL(coast_time), FEEL(detent), FEEL(detent_pull), FEEL(return_time),
};
#undef FEEL

#define JOINT(name)                                                                                                    \
    { #name, offsetof(dm_joint, name) }
static const number_field joint_fields[] = {
    JOINT(type_confidence), JOINT(joint_confidence), JOINT(pitch), JOINT(lower), JOINT(upper), JOINT(closed),
};
#undef JOINT

#define COUNT(array) (sizeof(array) / sizeof *(array))

static bool read_number(const gd_value* from, const char* name, float* out) {
    gd_value value = gd_get(from, name);
    const bool number = gd_is(&value, GDEXTENSION_VARIANT_TYPE_FLOAT) || gd_is(&value, GDEXTENSION_VARIANT_TYPE_INT);
    if (number) *out = (float)gd_float(&value);
    gd_free(&value);
    return number;
}

static void read_numbers(const gd_value* from, const number_field* fields, size_t count, void* out) {
    for (size_t i = 0; i < count; i++) read_number(from, fields[i].name, (float*)((char*)out + fields[i].offset));
}

static void put_numbers(gd_value* to, const number_field* fields, size_t count, const void* from) {
    for (size_t i = 0; i < count; i++) {
        float number;
        memcpy(&number, (const char*)from + fields[i].offset, sizeof number);
        gd_put(to, fields[i].name, gd_of_float((double)number));
    }
}

static void read_integer(const gd_value* from, const char* name, int32_t* out) {
    float number;
    if (read_number(from, name, &number)) *out = gd_enum((double)number);
}

static bool read_flag(const gd_value* from, const char* name) {
    gd_value value = gd_get(from, name);
    const bool set = gd_bool(&value);
    gd_free(&value);
    return set;
}

static void read_vec3(const gd_value* from, const char* name, dm_vec3* out) {
    gd_value value = gd_get(from, name);
    if (gd_is(&value, GDEXTENSION_VARIANT_TYPE_VECTOR3)) *out = vec3_of_value(&value);
    gd_free(&value);
}

/* Packed floats, or an Array of numbers. Returns how many. */
static uint32_t read_floats(const gd_value* from, const char* name, float* out, uint32_t most) {
    gd_value values = gd_get(from, name);
    uint32_t count = (uint32_t)gd_count(&values);
    if (count > most) count = most;
    for (uint32_t i = 0; i < count; i++) {
        gd_value number = gd_at(&values, i);
        out[i] = (float)gd_float(&number);
        gd_free(&number);
    }
    gd_free(&values);
    return count;
}

void settings_read(settings* out, const gd_value* entry, bool* out_locked) {
    *out = (settings){.rules = dm_drag_rules_default(), .joint = dm_joint_default()};
    *out_locked = false;
    if (gd_is(entry, GDEXTENSION_VARIANT_TYPE_NIL)) return;
    read_integer(entry, "joint_type", &out->joint_type);
    read_numbers(entry, rule_fields, COUNT(rule_fields), &out->rules);
    read_numbers(entry, feel_fields, COUNT(feel_fields), &out->feel);
    out->rules.snap_count = read_floats(entry, "snaps", out->snaps, DM_MAX_SNAPS);
    if (read_flag(entry, "latch")) out->rules.flags |= DM_RULE_LATCH;
    *out_locked = read_flag(entry, "locked");
    out->has_joint = read_flag(entry, "override_joint");
    if (!out->has_joint) return;
    out->joint.type = out->joint_type;
    read_numbers(entry, joint_fields, COUNT(joint_fields), &out->joint);
    read_vec3(entry, "axis", &out->joint.axis);
    read_vec3(entry, "origin", &out->joint.origin);
}

gd_value value_of_vec3(dm_vec3 v) {
    return gd_of_vector3((const double[3]){(double)v.x, (double)v.y, (double)v.z});
}

dm_vec3 vec3_of_value(const gd_value* value) {
    double v[3];
    gd_vector3(value, v);
    return (dm_vec3){(float)v[0], (float)v[1], (float)v[2]};
}

enum { EVIDENCE_WORDS = sizeof((dm_joint*)0)->evidence / sizeof(uint32_t) };

/* What pulls have said, as an Array of four integers. */
static gd_value value_of_evidence(const dm_joint* joint) {
    gd_value out = gd_new(GDEXTENSION_VARIANT_TYPE_ARRAY);
    for (int i = 0; i < EVIDENCE_WORDS; i++) gd_append(&out, gd_of_int(joint->evidence[i]));
    return out;
}

/* Where it is absent, as in games saved by earlier versions, no pull has said anything. */
static void read_evidence(const gd_value* from, dm_joint* joint) {
    gd_value words = gd_get(from, "evidence");
    const int64_t count = gd_count(&words);
    for (int64_t i = 0; i < EVIDENCE_WORDS && i < count; i++) {
        gd_value word = gd_at(&words, i);
        const double number = gd_float(&word); /* JSON has no integers; a double keeps all 32 bits */
        joint->evidence[i] = number >= 0 && number <= UINT32_MAX ? (uint32_t)number : 0;
        gd_free(&word);
    }
    gd_free(&words);
}

gd_value value_of_joint(const dm_joint* joint) {
    gd_value out = gd_new(GDEXTENSION_VARIANT_TYPE_DICTIONARY);
    gd_put(&out, "type", gd_of_int(joint->type));
    gd_put(&out, "source", gd_of_int(joint->source));
    gd_put(&out, "axis", value_of_vec3(joint->axis));
    gd_put(&out, "origin", value_of_vec3(joint->origin));
    put_numbers(&out, joint_fields, COUNT(joint_fields), joint);
    gd_put(&out, "evidence", value_of_evidence(joint));
    return out;
}

void joint_of_value(const gd_value* value, dm_joint* joint) {
    read_integer(value, "type", &joint->type);
    read_integer(value, "source", &joint->source);
    read_vec3(value, "axis", &joint->axis);
    read_vec3(value, "origin", &joint->origin);
    read_numbers(value, joint_fields, COUNT(joint_fields), joint);
    read_evidence(value, joint);
}

enum { POSE_FLOATS = 8 };

gd_value value_of_pose(const dm_pose* pose) {
    float numbers[POSE_FLOATS];
    memcpy(numbers, pose->real, sizeof pose->real);
    memcpy(numbers + POSE_FLOATS / 2, pose->dual, sizeof pose->dual);
    return gd_of_floats(numbers, POSE_FLOATS);
}

gd_value value_of_part_state(const dm_part_state* state) {
    gd_value out = gd_new(GDEXTENSION_VARIANT_TYPE_DICTIONARY);
    gd_put(&out, "value", gd_of_float((double)state->value));
    gd_put(&out, "velocity", gd_of_float((double)state->velocity));
    gd_put(&out, "status", gd_of_int(state->status));
    gd_put(&out, "pose", value_of_pose(&state->pose));
    gd_put(&out, "joint", value_of_joint(&state->joint));
    return out;
}

void part_state_of_value(const gd_value* value, dm_part_state* state) {
    float numbers[POSE_FLOATS] = {0};
    gd_value joint = gd_get(value, "joint");
    read_number(value, "value", &state->value);
    read_floats(value, "pose", numbers, POSE_FLOATS);
    memcpy(state->pose.real, numbers, sizeof state->pose.real);
    memcpy(state->pose.dual, numbers + POSE_FLOATS / 2, sizeof state->pose.dual);
    if (gd_is(&joint, GDEXTENSION_VARIANT_TYPE_DICTIONARY)) joint_of_value(&joint, &state->joint);
    gd_free(&joint);
}

gd_value value_of_drag_state(const dm_drag_state* state) {
    gd_value out = gd_new(GDEXTENSION_VARIANT_TYPE_DICTIONARY);
    gd_put(&out, "pose", value_of_pose(&state->pose));
    gd_put(&out, "grab_point", value_of_vec3(state->grab_point));
    gd_put(&out, "value", gd_of_float((double)state->value));
    gd_put(&out, "target", gd_of_float((double)state->target));
    gd_put(&out, "velocity", gd_of_float((double)state->velocity));
    gd_put(&out, "at_limit", gd_of_int(state->at_limit));
    gd_put(&out, "phase", gd_of_int(state->phase));
    gd_put(&out, "changes", gd_of_int(state->changes));
    gd_put(&out, "events", gd_of_int(state->events));
    gd_put(&out, "detents", gd_of_int(state->detents));
    gd_put(&out, "impact", gd_of_float((double)state->impact));
    gd_put(&out, "status", gd_of_int(state->status));
    gd_put(&out, "joint_confidence", gd_of_float((double)state->joint_confidence));
    gd_put(&out, "joint_basis", gd_of_int(state->joint_basis));
    gd_put(&out, "open_share", gd_of_float((double)state->open_share));
    return out;
}
