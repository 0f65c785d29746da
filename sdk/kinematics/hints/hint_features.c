/* Measures how candidate joints lie to the up direction, the part's box and the pivot. */
#include "kinematics/hints/hint_features.h"

#include "math/elementary.h"
#include "math/linear3.h"

/* The values are set by hand, in round numbers. What each feature means is learnt (hint_weights.def). */
#define UPRIGHT_COSINE 0.94f /* cosine of 20 degrees */
#define LEVEL_COSINE 0.34f   /* cosine of 70 degrees */
#define ALONG_COSINE 0.95f   /* cosine of 18 degrees, to a side of the part's box */
#define CENTRE_REACH 0.2f    /* half sides */
#define INSIDE_REACH 0.75f   /* half sides */
#define EDGE_REACH 1.3f      /* half sides */
#define HIGH 0.6f            /* half heights above or below the middle */
#define SIDEWAYS 0.5f        /* cosine from which an axis lies to a side */
#define OFF_CENTRE 0.1f      /* part diagonals between the part's centre and the object's, from which there are sides */
#define ALIGNED_COSINE 0.99985f /* cosine of 1 degree, between a joint's axis and a pivot's */
#define ON_DISTANCE 0.004f      /* part diagonals between a line and a pivot that it passes through, one sigma */
#define NEAR_DISTANCE 0.03f     /* the same for a pivot that the line is meant to pass through */
#define THIN 0.06f              /* part diagonals; a half side below it is a plate's thickness */
#define IN_THE_MIDDLE 0.06f     /* half sides from the centre ... */
#define AT_THE_END 0.06f        /* part diagonals from the end of a side */

static uint32_t bit(dmi_kind_feature feature) {
    return 1u << feature;
}

/* Returns the index of the box's axis that a unit direction runs along, or -1 when it runs along none. */
static int along_side(const dmi_box* box, const float axis[3]) {
    for (int i = 0; i < 3; i++)
        if (fabsf(dmi_dot3(axis, box->axes[i])) > ALONG_COSINE) return i;
    return -1;
}

static uint32_t direction_features(const dmi_hint_frame* frame, const float axis[3], bool slides) {
    const float rise = fabsf(dmi_dot3(axis, frame->hints->up));
    const int to_up = rise > UPRIGHT_COSINE ? 0 : rise < LEVEL_COSINE ? 1 : 2;
    const int side = along_side(&frame->analysis->box, axis);
    uint32_t bits = bit((slides ? DMI_KIND_SLIDE_UPRIGHT : DMI_KIND_TURN_UPRIGHT) + (dmi_kind_feature)to_up);
    if (side >= 0) bits |= bit((slides ? DMI_KIND_SLIDE_LONG : DMI_KIND_TURN_LONG) + (dmi_kind_feature)side);
    return bits;
}

/* Returns how far a line runs from the centre of the part's box, in half sides: the larger of the two distances across
 * it. */
static float reach(const dmi_hint_frame* frame, const dmi_candidate* c) {
    const dmi_box* box = &frame->analysis->box;
    float offset[3], most = 0;
    dmi_sub3(c->origin, frame->box_centre, offset);
    dmi_reject3(offset, c->axis);
    for (int i = 0; i < 3; i++) {
        const float half = (box->high[i] - box->low[i]) / 2;
        if (fabsf(dmi_dot3(c->axis, box->axes[i])) > ALONG_COSINE) continue;
        most = dmi_max(most, fabsf(dmi_dot3(offset, box->axes[i])) / dmi_max(half, THIN * frame->analysis->diagonal));
    }
    return most;
}

/* Returns 1 when the line lies from the box's centre along a direction, -1 when it lies against it, and 0 when it lies
 * aside. least: share of the direction's length across the line, from which on it has sides. */
static int side_along(const dmi_hint_frame* frame, const dmi_candidate* c, const float direction[3], float least) {
    float offset[3], across[3];
    dmi_sub3(c->origin, frame->box_centre, offset);
    dmi_reject3(offset, c->axis);
    dmi_copy3(direction, across);
    dmi_reject3(across, c->axis);
    if (dmi_normalize3(across) < least || dmi_normalize3(offset) < CENTRE_REACH * THIN * frame->analysis->diagonal)
        return 0;
    const float cosine = dmi_dot3(offset, across);
    return cosine > SIDEWAYS ? 1 : cosine < -SIDEWAYS ? -1 : 0;
}

static uint32_t side_features(const dmi_hint_frame* frame, const dmi_candidate* c) {
    static const float front[3] = {0, 0, 1}, canonical_up[3] = {0, 1, 0};
    const int out = side_along(frame, c, frame->outward, OFF_CENTRE);
    uint32_t bits = out > 0 ? bit(DMI_KIND_TURN_OUTER) : out < 0 ? bit(DMI_KIND_TURN_INNER) : 0;
    if (dmi_dot3(frame->hints->up, canonical_up) < UPRIGHT_COSINE) return bits;
    const int to_front = side_along(frame, c, front, SIDEWAYS);
    return bits | (to_front > 0 ? bit(DMI_KIND_TURN_FRONT) : to_front < 0 ? bit(DMI_KIND_TURN_BACK) : 0);
}

uint32_t dmi_kind_features(const dmi_hint_frame* frame, const dmi_candidate* candidate) {
    const bool slides = candidate->type == DM_JOINT_PRISMATIC;
    uint32_t bits = direction_features(frame, candidate->axis, slides);
    if (slides) return bits;
    const float far = reach(frame, candidate);
    if (far > CENTRE_REACH) bits |= side_features(frame, candidate);
    bits |= bit(far <= CENTRE_REACH  ? DMI_KIND_TURN_CENTRE
                : far < INSIDE_REACH ? DMI_KIND_TURN_INSIDE
                : far <= EDGE_REACH  ? DMI_KIND_TURN_EDGE
                                     : DMI_KIND_TURN_OUTSIDE);
    if ((bits & bit(DMI_KIND_TURN_LEVEL)) == 0) return bits;
    const float height = dmi_dot3(candidate->origin, frame->hints->up) - frame->middle_height;
    if (height > HIGH * frame->half_height) bits |= bit(DMI_KIND_TURN_TOP);
    if (height < -HIGH * frame->half_height) bits |= bit(DMI_KIND_TURN_BOTTOM);
    return bits;
}

/* Returns the face's place by the direction out of it. */
static dmi_pivot_place face_place(const dmi_asset_hints* hints, const float axis[3], float side) {
    const float rise = side * dmi_dot3(axis, hints->up);
    return rise > UPRIGHT_COSINE ? DMI_PIVOT_TOP : rise < -UPRIGHT_COSINE ? DMI_PIVOT_BOTTOM : DMI_PIVOT_SIDE;
}

/* Returns where the pivot lies in the part's box along three axes. A plate's thickness does not count: all of it is
 * middle and end. */
static dmi_pivot_place place_in_box(const dmi_asset_hints* hints, const float axes[3][3], const float low[3],
                                    const float high[3], float diagonal) {
    int ends = 0, middles = 0, sides = 0, face = 0;
    float out_of_face = 0;
    for (int i = 0; i < 3; i++) {
        const float half = (high[i] - low[i]) / 2, at = dmi_dot3(hints->pivot, axes[i]) - (high[i] + low[i]) / 2;
        if (fabsf(at) - half > AT_THE_END * diagonal) return DMI_PIVOT_OUTSIDE;
        if (half < THIN * diagonal) continue;
        sides++;
        if (fabsf(at) < IN_THE_MIDDLE * half) middles++;
        if (half - fabsf(at) > AT_THE_END * diagonal) continue;
        ends++, face = i, out_of_face = at;
    }
    if (middles == sides) return DMI_PIVOT_MIDDLE;
    if (ends == 1 && middles == sides - 1) return face_place(hints, axes[face], out_of_face < 0 ? -1.0f : 1.0f);
    return ends >= 2 || (ends == 1 && sides < 3) ? DMI_PIVOT_EDGE : DMI_PIVOT_INSIDE;
}

static dmi_pivot_place find_place(const dmi_asset_hints* hints, const dmi_part_analysis* analysis) {
    static const float canonical[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const float(*axes)[3] = hints->has_axes ? hints->pivot_axes : canonical;
    float low[3], high[3];
    dmi_extents_along((const float(*)[3])analysis->extreme_points, analysis->extreme_point_count, axes, 3, low, high);
    const dmi_pivot_place place = place_in_box(hints, axes, low, high, analysis->diagonal);
    return hints->is_default && (place == DMI_PIVOT_INSIDE || place == DMI_PIVOT_OUTSIDE) ? DMI_PIVOT_DEFAULT : place;
}

void dmi_hint_frame_make(const dmi_asset_hints* hints, const dmi_part_analysis* analysis, dmi_hint_frame* out) {
    *out = (dmi_hint_frame){.hints = hints, .analysis = analysis};
    float low, high;
    dmi_box_centre(&analysis->box, out->box_centre);
    dmi_extents_along((const float(*)[3])analysis->extreme_points, analysis->extreme_point_count,
                      (const float(*)[3])hints->up, 1, &low, &high);
    out->middle_height = (low + high) / 2;
    out->half_height = (high - low) / 2;
    for (int k = 0; k < 3; k++) out->outward[k] = out->box_centre[k] / analysis->diagonal;
    if (hints->has_pivot) out->place = find_place(hints, analysis);
}

static float closeness(float distance, float sigma) {
    return dmi_expf(-distance * distance / (2 * sigma * sigma));
}

void dmi_pivot_features(const dmi_hint_frame* frame, const dmi_candidate* candidate, float out[DMI_PIVOT_FEATURES]) {
    const dmi_asset_hints* hints = frame->hints;
    const float diagonal = frame->analysis->diagonal;
    float aligned = 0;
    for (int i = 0; i < 3 && hints->has_axes; i++)
        if (fabsf(dmi_dot3(candidate->axis, hints->pivot_axes[i])) > ALIGNED_COSINE) aligned = 1;
    memset(out, 0, DMI_PIVOT_FEATURES * sizeof *out);
    if (candidate->type == DM_JOINT_PRISMATIC) {
        out[DMI_PIVOT_SLIDE] = 1;
        out[DMI_PIVOT_SLIDE_ALIGNED] = aligned;
        const float aside = dmi_line_distance3(hints->pivot, candidate->axis, frame->box_centre);
        out[DMI_PIVOT_SLIDE_THROUGH] = closeness(aside / diagonal, NEAR_DISTANCE);
        return;
    }
    const float off = dmi_line_distance3(hints->pivot, candidate->axis, candidate->origin) / diagonal;
    const float off_middle = dmi_line_distance3(frame->box_centre, candidate->axis, candidate->origin) / diagonal;
    out[DMI_PIVOT_TURN_ALIGNED] = aligned;
    out[DMI_PIVOT_NEAR] = closeness(off, NEAR_DISTANCE);
    out[DMI_PIVOT_ON] = closeness(off, ON_DISTANCE);
    out[DMI_PIVOT_ON_ALIGNED] = aligned * out[DMI_PIVOT_ON];
    out[DMI_PIVOT_ON_MIDDLE] = out[DMI_PIVOT_ON] * closeness(off_middle, NEAR_DISTANCE);
}
