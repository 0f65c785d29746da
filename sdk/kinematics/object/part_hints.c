/* Reads labels, pivots and the up direction into the inner frame. */
#include "kinematics/object/prepare_steps.h"

#include <float.h>

#include "math/linear3.h"
#include "mesh/pivot_rule.h"

#define SAME_PLACE 1e-4f /* object sizes between two pivots that count as one place; by hand */
#define FARTHEST 1e3f    /* object sizes from the object's centre to a pivot that still says something; by hand */
#define MANY_PARTS 3     /* parts that share a pivot from which on it counts as left where it was, not set; by hand */

static dm_result check_label(dmi_env* env, const char* what, const char* label) {
    if (label == NULL || strnlen(label, DM_MAX_LABEL + 1) <= DM_MAX_LABEL) return DM_OK;
    return dmi_fail(env, DM_ERROR_TOO_LARGE, "dm_object_prepare: %s is longer than %d bytes", what, DM_MAX_LABEL);
}

static dm_result check_finite(dmi_env* env, const char* what, uint32_t id, const float* numbers, uint32_t count) {
    for (uint32_t i = 0; i < count; i++)
        if (!isfinite(numbers[i]))
            return dmi_fail(env, DM_ERROR_NOT_FINITE, "dm_object_prepare: %s of part %u: number %u is %g", what, id, i,
                            (double)numbers[i]);
    return DM_OK;
}

static dm_result read_up(dmi_env* env, const dmi_object* object, dm_vec3 up, float out[3]) {
    static const float canonical[3] = {0, 1, 0};
    const dmi_float3 given = dmi_xyz(up);
    for (int k = 0; k < 3; k++)
        if (!isfinite(given.v[k]))
            return dmi_fail(env, DM_ERROR_NOT_FINITE, "dm_object_prepare: desc.up: number %d is %g", k,
                            (double)given.v[k]);
    dmi_frame_direction_in(&object->frame, given.v, out);
    if (!(dmi_normalize3(out) > FLT_MIN)) dmi_copy3(canonical, out);
    return DM_OK;
}

/* Converts the pivot's axes. Returns whether all three have a direction. */
static bool read_axes(const dmi_object* object, const float* axes, float out[3][3]) {
    bool all = true;
    for (int i = 0; i < 3; i++) {
        const float* given = axes + 3 * (size_t)i;
        float axis[3] = {given[0], given[1], given[2]};
        dmi_normalize3(axis);
        dmi_frame_direction_in(&object->frame, axis, out[i]);
        all &= dmi_normalize3(out[i]) > 0.5f;
    }
    return all;
}

static bool is_at_origin(const dmi_object* object, dm_vec3 host) {
    const dmi_float3 p = dmi_xyz(host);
    return dmi_length3(p.v) <= SAME_PLACE * dmi_frame_length_out(&object->frame);
}

static dm_result read_pivot(dmi_env* env, dmi_object* object, const dm_part_desc* part, dmi_asset_hints* out) {
    const dm_pivot* pivot = part->pivot;
    const uint32_t id = part->id;
    const dmi_float3 origin = dmi_xyz(pivot->origin);
    dm_result result = check_finite(env, "the pivot's origin", id, origin.v, 3);
    if (result == DM_OK)
        result = check_finite(env, "the pivot's axes", id, pivot->axes, sizeof pivot->axes / sizeof *pivot->axes);
    if (result != DM_OK) return result;
    dmi_frame_point_in(&object->frame, dmi_xyz_f64(pivot->origin).v, out->pivot);
    out->has_pivot = dmi_length3(out->pivot) < FARTHEST;
    if (!out->has_pivot) object->degraded |= DM_DEGRADED_HINT;
    out->has_pivot &= part->pivot_kind != DM_PIVOT_DEFAULT;
    out->has_axes = out->has_pivot && read_axes(object, pivot->axes, out->pivot_axes);
    out->is_default = part->pivot_kind != DM_PIVOT_SET && is_at_origin(object, pivot->origin);
    out->is_set = part->pivot_kind == DM_PIVOT_SET;
    return DM_OK;
}

/* Marks pivots that many parts share. */
static void mark_shared(dmi_object* object) {
    for (uint32_t i = 1; i < object->part_count; i++) {
        dmi_asset_hints* one = &object->parts[i].asset_hints;
        uint32_t same = 0;
        for (uint32_t k = 1; one->has_pivot && !one->is_default && same < MANY_PARTS && k < object->part_count; k++) {
            const dmi_asset_hints* other = &object->parts[k].asset_hints;
            same += other->has_pivot && dmi_distance3(one->pivot, other->pivot) <= SAME_PLACE;
        }
        if (same >= MANY_PARTS) one->is_default = true;
    }
}

/* Lists the pivots of an object's parts, one a part. An entry is NULL where there is no pivot, or where it is already
 * known whether somebody has set it. */
static void list_pivots(const dmi_object* object, const dm_part_desc* parts, uint32_t count, const dm_pivot** out) {
    for (uint32_t i = 0; i < object->part_count; i++) out[i] = NULL;
    for (uint32_t i = 0; i < count; i++) {
        const int32_t index = dmi_object_find_part(object, parts[i].id);
        if (index > 0 && parts[i].pivot_kind == DM_PIVOT_UNKNOWN && object->parts[index].asset_hints.has_pivot)
            out[index] = parts[i].pivot;
    }
}

/* Drops the pivots of parts that follow one rule. */
static dm_result judge_pivots(dmi_env* env, const dmi_mesh* mesh, dmi_object* object, const dm_part_desc* parts,
                              uint32_t count) {
    const uint32_t all = object->part_count;
    if (all <= DMI_PIVOT_LEAST_SHAPES) return DM_OK; /* the body is one of them */
    const size_t each = sizeof(dm_pivot*) + sizeof(dmi_pivot_gauge) + sizeof(dmi_pivot_witness);
    dmi_pivot_gauge* gauges = dmi_alloc(env, all * each, _Alignof(dmi_pivot_gauge));
    if (gauges == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_object_prepare: no memory for %u pivots", all);
    dmi_pivot_witness* witnesses = (dmi_pivot_witness*)(gauges + all);
    const dm_pivot** pivots = (const dm_pivot**)(witnesses + all);
    list_pivots(object, parts, count, pivots);
    dmi_part_pivots_measure(mesh, pivots, gauges, witnesses);
    const bool drops = dmi_part_pivots_follow_rule(witnesses, all);
    for (uint32_t i = 1; drops && i < all; i++)
        if (pivots[i] != NULL) object->parts[i].asset_hints.has_pivot = false;
    dmi_free(env, gauges, all * each);
    return DM_OK;
}

/* Puts what a part's label says in front of what is said of the whole object. */
static void join_labels(dmi_label_kind own, dmi_label_kind* inout) {
    own.modifiers.above |= inout->modifiers.above;
    if (own.kind == DMI_KIND_NOTHING) own.kind = inout->kind, own.depth = inout->depth;
    *inout = own;
}

static dm_result read_part(dmi_env* env, dmi_object* object, const dm_part_desc* part, dmi_asset_hints* out) {
    dm_result result = check_label(env, "the label of a part", part->label);
    if (result == DM_OK && (part->pivot_kind < DM_PIVOT_UNKNOWN || part->pivot_kind > DM_PIVOT_SET))
        result = dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                          "dm_object_prepare: pivot_kind of part %u: %d is not DM_PIVOT_*", part->id, part->pivot_kind);
    if (result == DM_OK && part->pivot != NULL) result = read_pivot(env, object, part, out);
    const dmi_label_kind own = result == DM_OK ? dmi_kind_of_label(part->label) : out->label;
    if (result == DM_OK && part->label != NULL) join_labels(own, &out->label);
    return result;
}

dm_result dmi_object_read_hints(dmi_env* env, const dmi_mesh* mesh, dmi_object* object, const dmi_object_labels* labels,
                                const dm_part_desc* parts, uint32_t count) {
    dmi_asset_hints common = {.label = {.kind = DMI_KIND_NOTHING}};
    dm_result result = check_label(env, "desc.label", labels->label);
    if (result == DM_OK) result = read_up(env, object, labels->up, common.up);
    if (result != DM_OK) return result;
    common.label = dmi_kind_of_label(labels->label);
    common.label.depth++;
    common.label.modifiers = (dmi_label_modifiers){0, common.label.modifiers.own | common.label.modifiers.above};
    for (uint32_t i = 1; i < object->part_count; i++) object->parts[i].asset_hints = common;
    for (uint32_t i = 0; i < count && result == DM_OK; i++) {
        const int32_t index = dmi_object_find_part(object, parts[i].id);
        if (index > 0) result = read_part(env, object, &parts[i], &object->parts[index].asset_hints);
    }
    if (result == DM_OK) result = judge_pivots(env, mesh, object, parts, count);
    mark_shared(object);
    return result;
}
