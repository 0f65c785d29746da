/* Saves a drag's whole state and restores it, as a header and the drag as it lies in memory. Any bytes may come back,
 * so what could lead outside an array, or is no value of its type, is checked before it is used. */
#include <math.h>
#include <string.h>

#include "api_check.h"
#include "api_drag.h"
#include "api_joint_check.h"
#include "base/fp_environment.h"
#include "math/linear3.h"

#define MAGIC 0x53444D44u    /* "DMDS" */
#define UNIT_TOLERANCE 1e-5f /* error of an axis' length; by hand: rounding leaves 1e-7, and poses are as far off */
#define FNV_START 0xcbf29ce484222325u
#define FNV_PRIME 0x100000001b3u

typedef struct snapshot {
    uint32_t magic, version, size, reserved;
    uint64_t part;     /* number that identifies the part and its object */
    uint64_t checksum; /* checksum of everything after it */
    dm_vec3 scale;
    float value_unit;
    int32_t open_side;
    dmi_drag drag;
} snapshot;

_Static_assert(sizeof(snapshot) <= DM_DRAG_SNAPSHOT_MAX, "hosts reserve DM_DRAG_SNAPSHOT_MAX bytes");

size_t DM_CALL dm_drag_snapshot_size(void) {
    return sizeof(snapshot);
}

/* Returns the FNV-1a hash by words of 8 bytes. Bytes at the end that fill no word count one by one. */
static uint64_t hash(uint64_t seed, const void* data, size_t size) {
    const uint8_t* bytes = data;
    uint64_t sum = seed, word;
    for (; size >= sizeof word; size -= sizeof word, bytes += sizeof word) {
        memcpy(&word, bytes, sizeof word);
        sum = (sum ^ word) * FNV_PRIME;
        sum ^= sum >> 32; /* a multiplication carries only upwards */
    }
    for (; size > 0; size--, bytes++) sum = (sum ^ *bytes) * FNV_PRIME;
    return sum;
}

static uint64_t checksum_of(const snapshot* s) {
    const size_t start = offsetof(snapshot, checksum) + sizeof s->checksum;
    return hash(FNV_START, (const uint8_t*)s + start, sizeof *s - start);
}

uint64_t dmi_part_key(const dmi_object* object, uint32_t part) {
    const dmi_object_part* one = &object->parts[part];
    const dmi_part* shape = &one->shape;
    const uint64_t counts[5] = {shape->id, shape->face_count, object->vertex_count, object->triangle_count,
                                one->hypotheses.count};
    uint64_t sum = hash(FNV_START, counts, sizeof counts);
    for (uint32_t i = 0; i < one->hypotheses.count; i++) {
        const int32_t type = one->hypotheses.joints[i].type;
        sum = hash(sum, &type, sizeof type);
    }
    return hash(hash(sum, shape->box_min, sizeof shape->box_min), shape->box_max, sizeof shape->box_max);
}

dm_result DM_CALL dm_drag_save(dm_context* context, dm_drag drag, void* buffer, size_t capacity) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_drag_slot* slot = dmi_pool_get(context->drags, drag);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    if (buffer == NULL) return DM_ERROR_INVALID_ARGUMENT;
    if (capacity < sizeof(snapshot)) return DM_ERROR_BUFFER_TOO_SMALL;
    snapshot s;
    memset(&s, 0, sizeof s); /* clears the gaps between fields too */
    s.magic = MAGIC, s.version = DM_VERSION, s.size = sizeof s;
    s.part = dmi_part_key(slot->owner->object, slot->part);
    s.scale = slot->scale, s.value_unit = slot->value_unit, s.open_side = (int32_t)slot->open_side;
    memcpy(&s.drag, &slot->drag, sizeof s.drag);
    s.checksum = checksum_of(&s);
    memcpy(buffer, &s, sizeof s);
    return DM_OK;
}

/* ---- checks ---- */

/* Returns whether a bool holds 0 or 1. Any other byte must not be read as one. */
static bool is_bool(const bool* value) {
    uint8_t byte;
    memcpy(&byte, value, 1);
    return byte <= 1;
}

static bool are_finite(const float* values, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(values[i])) return false;
    }
    return true;
}

/* Returns whether poses can be made of the values, which come from numbers within DMI_LARGEST. */
static bool are_within(const float* values, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (!(fabsf(values[i]) <= DMI_LARGEST_SAVED)) return false;
    }
    return true;
}

/* Returns whether values that may be infinite, such as log probabilities, are numbers. */
static bool are_numbers(const float* values, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (isnan(values[i])) return false;
    }
    return true;
}

static bool are_rising(const float* values, size_t count) {
    for (size_t i = 1; i < count; i++) {
        if (!(values[i - 1] <= values[i])) return false;
    }
    return true;
}

/* Returns whether a joint is sound: its axis is unit, or the joint does not move. */
static bool is_sound_joint(const dm_joint* j) {
    const bool moves = j->type != DM_JOINT_UNKNOWN && j->type != DM_JOINT_FIXED;
    const float others[4] = {j->lower, j->upper, j->type_confidence, j->joint_confidence};
    return dmi_joint_check(NULL, "", j, DM_JOINT_UNKNOWN) == DM_OK && are_finite(others, 4) &&
           (!moves || fabsf(dmi_length3(dmi_xyz(j->axis).v) - 1) <= UNIT_TOLERANCE);
}

/* Returns whether a vector is unit, or zeros, which stand for none. */
static bool is_direction(const float v[3]) {
    const float square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    return square == 0 || fabsf(square - 1) <= 2 * UNIT_TOLERANCE;
}

static bool is_projection(const dmi_projection* projection) {
    uint32_t value = 0;
    memcpy(&value, projection, sizeof value < sizeof *projection ? sizeof value : sizeof *projection);
    return value == DMI_PARALLEL || value == DMI_PERSPECTIVE;
}

static bool is_sound_ray(const dm_ray* ray) {
    const dmi_float3 origin = dmi_xyz(ray->origin), direction = dmi_xyz(ray->direction);
    return are_finite(origin.v, 3) && are_finite(direction.v, 3);
}

static bool is_sound_pull(const dmi_pull* p) {
    const float numbers[3] = {p->spacing, p->length, p->bend};
    const dmi_seen_pointer* seen = &p->pointer;
    if (p->count > DMI_PULL_RAYS || !is_projection(&p->projection)) return false;
    for (uint32_t i = 0; i < p->count; i++) {
        if (!is_sound_ray(&p->rays[i]) || !are_finite(p->places[i], 3)) return false;
    }
    return are_finite(numbers, 3) && are_within(p->grab, 3) && are_finite(seen->sight, 3) && are_finite(seen->way, 3) &&
           are_numbers(&seen->eye_distance, 1);
}

static bool is_sound_hypothesis(const dmi_joint_hypothesis* h) {
    const float numbers[4] = {h->log_prior, h->log_posterior, h->max_residual, h->shift_cost};
    return is_sound_joint(&h->joint) && is_bool(&h->range_unknown) && is_bool(&h->grabbed) &&
           is_bool(&h->other_side_blocked) && h->free_range.lower <= 0 && h->free_range.upper >= 0 &&
           are_within(h->initial_origin, 3) && are_finite(h->shift, 2) && (h->side == 0 || fabsf(h->side) == 1) &&
           is_direction(h->first_motion) && are_finite(&h->curvature, 1) && is_bool(&h->upright) &&
           h->rank >= DMI_UNRANKED && h->rank < DM_MAX_HYPOTHESES && are_finite(h->excursion, 2) &&
           are_finite(&h->pointer_value, 1) && are_numbers(numbers, 4);
}

static bool is_sound_refiner(const dmi_axis_refiner* r, uint32_t count) {
    const dmi_pull_fit* f = &r->fit;
    const float numbers[6] = {f->lower, f->upper, f->max_residual, f->size, r->shift_cost, r->unshifted_log_posterior};
    if (r->hypothesis != DMI_NO_HYPOTHESIS && r->hypothesis >= count) return false;
    return f->count <= DMI_PULL_RAYS && is_bool(&r->shifted) && is_sound_joint(&f->joint) && are_numbers(numbers, 6) &&
           are_finite(f->outward, 3) && are_finite(f->forward, 3) && are_finite(&f->pointer_value, 1) &&
           are_numbers(f->gradient, 2) && are_numbers(f->hessian, 3) && are_numbers(r->shift, 2) &&
           are_numbers(r->priority, count);
}

static bool is_sound_tracker(const dmi_hypothesis_tracker* t) {
    const float numbers[3] = {t->grasp.size, t->grasp.limit_give.share, t->grasp.limit_give.length};
    if (t->count > DMI_TRACKED_HYPOTHESES || (t->count > 0 ? t->best >= t->count : t->best != 0)) return false;
    for (uint32_t i = 0; i < t->count; i++) {
        if (!is_sound_hypothesis(&t->list[i])) return false;
    }
    if (t->count == 0) return true;
    return are_within(numbers, 3) && t->grasp.size > 0 && is_sound_pull(&t->grasp.pull) &&
           are_numbers(&t->grasp.straightness, 1) && is_direction(t->grasp.way) && is_bool(&t->grasp.was_open) &&
           are_numbers(t->priority, t->count) && is_sound_refiner(&t->refiner, t->count);
}

static bool is_sound_release(const dmi_release* r) {
    const float numbers[8] = {r->start,   r->end,         r->velocity, r->duration,
                              r->elapsed, r->return_time, r->first,    r->last};
    return r->phase >= DM_DRAG_HELD && r->phase <= DM_DRAG_AT_REST && r->intent >= DM_INTENT_AUTO &&
           r->intent <= DM_INTENT_FREEZE && is_bool(&r->glides) && is_bool(&r->paced) && are_within(numbers, 8) &&
           are_within(r->keys, DM_MOTION_FRAMES);
}

/* Returns whether a blend is sound. Its age is infinite where there is none. */
static bool is_sound_blend(const dmi_pose_blend* b) {
    float length;
    return are_within(b->offset.real, 4) && are_within(b->offset.dual, 4) &&
           dmi_pose_is_near_unit(&b->offset, &length) && are_within(b->lag, 3) && b->age >= 0 && b->turn_time >= 0 &&
           b->lag_time >= 0 && are_finite(&b->turn_time, 1) && are_finite(&b->lag_time, 1);
}

static bool is_sound_event_state(const dmi_event_state* w) {
    const float numbers[2] = {w->catch_index, w->impact};
    return w->limit >= -1 && w->limit <= 1 && is_bool(&w->away) && is_bool(&w->open) && is_bool(&w->blocked) &&
           w->since_opening >= 0 && w->peak_speed >= 0 && are_finite(numbers, 2) && are_finite(&w->peak_speed, 1);
}

static bool is_sound_latch(const dmi_latch* l) {
    return is_bool(&l->closed) && is_bool(&l->locked) && is_bool(&l->turned) && is_bool(&l->tried) &&
           are_within(&l->at, 1);
}

static bool are_sound_hands(const dmi_hands* h) {
    const float numbers[3] = {h->bias, h->second.value, h->second.bias};
    return h->kind >= DM_HAND_NONE && h->kind <= DM_HAND_VALUE && is_bool(&h->has_offset) && h->eye < DMI_HAND_EYES &&
           is_bool(&h->second.on) && is_bool(&h->second.placed) && are_within(h->offset, 3) &&
           are_within(h->point, 3) && are_within(h->second.rest_point, 3) && are_within(numbers, 3);
}

/* Returns whether a pending value is sound. Its bounds may be infinite. */
static bool is_sound_pending(const dmi_pending_value* q) {
    return is_bool(&q->open) && q->phase >= DM_DRAG_HELD && q->phase <= DM_DRAG_AT_REST && q->dt >= 0 &&
           are_finite(&q->dt, 1) && are_within(&q->start, 1) && q->lower <= q->upper &&
           is_sound_event_state(&q->event_state);
}

/* Returns whether there are no constraints, as between two updates. */
static bool is_unconstrained(const dmi_constraints* t) {
    return t->bounds.lower == -INFINITY && t->bounds.upper == INFINITY && is_bool(&t->locked) && !t->locked &&
           t->handles[0] == 0 && t->handles[1] == 0;
}

static bool is_sound_keeping(const dmi_drag* d) {
    const float numbers[7] = {
        d->asked, d->lag, d->start.value, d->start.velocity, d->waited, d->landing.impact, d->release.acceleration};
    return is_bool(&d->rules.on) && is_bool(&d->rules.one_sided) && dmi_is_sound_rules(&d->rules) &&
           is_unconstrained(&d->constraints) && are_within(numbers, 7) && is_bool(&d->stays) && is_bool(&d->stalled) &&
           is_bool(&d->release.flies) && is_bool(&d->landing.settled) && d->landing.struck >= -1 &&
           d->landing.struck <= 1 && d->open_side >= -1 && d->open_side <= 1 && is_sound_event_state(&d->event_state) &&
           is_sound_latch(&d->latch) && are_sound_hands(&d->hands) && is_sound_pending(&d->pending);
}

static bool is_sound_origin_of_joint(const dmi_drag* d) {
    const float confidences[3] = {d->first_confidence, d->tracker.confidence, d->earlier.others};
    return are_numbers(confidences, 3) && are_numbers(d->earlier.ranked, DM_MAX_HYPOTHESES) &&
           are_numbers(&d->earlier.own, 1) && d->basis >= DM_BASIS_PREPARED && d->basis <= DM_BASIS_CHOSEN;
}

/* The share that is open is a quotient by the way. */
static bool is_sound_opening(const dmi_drag* d) {
    return are_within(&d->closed, 1) && are_numbers(&d->open_way, 1) && d->open_way != 0;
}

static bool is_sound_drag(const dmi_drag* d) {
    const float numbers[5] = {d->value, d->target, d->velocity, d->speed, d->pointer_value};
    const float limits[4] = {d->reachable_lower, d->estimated_lower, d->estimated_upper, d->reachable_upper};
    const dmi_float3 grab_offset = dmi_xyz(d->grab_offset);
    return is_sound_joint(&d->joint) && dmi_is_usable_feel(&d->feel) && are_within(numbers, 5) && d->speed >= 0 &&
           are_within(d->rest_point, 3) && are_within(d->point, 3) && are_within(grab_offset.v, 3) &&
           is_sound_ray(&d->last_ray) && is_projection(&d->projection) && is_bool(&d->limits_are_estimates) &&
           are_rising(limits, 4) && d->pointer_span.lower <= d->pointer_span.upper && is_sound_opening(d) &&
           is_sound_blend(&d->blend) && is_sound_tracker(&d->tracker) && is_sound_origin_of_joint(d) &&
           is_sound_release(&d->release) && is_sound_keeping(d);
}

static bool is_sound(const snapshot* s) {
    const float numbers[4] = {s->scale.x, s->scale.y, s->scale.z, s->value_unit};
    return s->open_side >= -1 && s->open_side <= 1 && are_within(numbers, 4) &&
           s->scale.x * s->scale.y * s->scale.z != 0 && s->value_unit > 0 && is_sound_drag(&s->drag);
}

static dm_result check_snapshot(const dmi_drag_slot* slot, const snapshot* s) {
    if (s->magic != MAGIC) return DM_ERROR_BAD_DATA;
    if (s->version != DM_VERSION || s->size != sizeof *s) return DM_ERROR_VERSION;
    if (s->checksum != checksum_of(s) || !is_sound(s)) return DM_ERROR_BAD_DATA;
    return s->part == dmi_part_key(slot->owner->object, slot->part) ? DM_OK : DM_ERROR_INVALID_ARGUMENT;
}

dm_result DM_CALL dm_drag_restore(dm_context* context, dm_drag drag, const void* data, size_t size) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_drag_slot* slot = dmi_pool_get(context->drags, drag);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    if (data == NULL) return DM_ERROR_INVALID_ARGUMENT;
    snapshot s;
    memset(&s, 0, sizeof s);
    memcpy(&s, data, size < sizeof s ? size : sizeof s);
    if (s.magic == MAGIC && s.size == sizeof s && size < sizeof s) return DM_ERROR_BAD_DATA;
    dm_result result = check_snapshot(slot, &s);
    if (result != DM_OK) return result;
    slot->scale = s.scale, slot->value_unit = s.value_unit, slot->open_side = (int8_t)s.open_side;
    memcpy(&slot->drag, &s.drag, sizeof s.drag);
    return DM_OK;
}
