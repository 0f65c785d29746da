/* What an asset says of a part beside its shape: names, the pivot of its node, which way is up. It is evidence, never
 * truth. The features are those of a candidate joint against it; the weights of hint_weights.def count them. */
#ifndef DMI_HINTS_HINT_FEATURES_H
#define DMI_HINTS_HINT_FEATURES_H

#include <stdbool.h>

#include "kinematics/candidates/candidates.h"
#include "kinematics/hints/part_kind.h"

/* The hints of one part, in the object-normalised frame. Zeros: the asset says nothing. */
typedef struct dmi_asset_hints {
    dmi_label_kind label;
    float up[3];     /* unit */
    bool has_pivot;  /* pivot is set */
    bool has_axes;   /* pivot_axes is set */
    bool is_set;     /* the asset's other pivots follow a rule, and this one does not */
    bool is_default; /* the pivot lies where an export without pivots leaves it: at the file's origin */
    float pivot[3];
    float pivot_axes[3][3]; /* unit rows */
} dmi_asset_hints;

/* Features of a candidate that a kind of part makes likelier or not. Each is 0 or 1. Side: half the box's extent. */
typedef enum dmi_kind_feature {
    DMI_KIND_SLIDE_UPRIGHT, /* it slides along the up direction, within 20 degrees */
    DMI_KIND_SLIDE_LEVEL,   /* it slides across the up direction, within 20 degrees */
    DMI_KIND_SLIDE_OBLIQUE,
    DMI_KIND_SLIDE_LONG, /* it slides along the longest side of the part's box, within 18 degrees */
    DMI_KIND_SLIDE_MIDDLE,
    DMI_KIND_SLIDE_SHORT,
    DMI_KIND_TURN_UPRIGHT,
    DMI_KIND_TURN_LEVEL,
    DMI_KIND_TURN_OBLIQUE,
    DMI_KIND_TURN_LONG,
    DMI_KIND_TURN_MIDDLE,
    DMI_KIND_TURN_SHORT,
    DMI_KIND_TURN_CENTRE,  /* the axis runs through the middle of the box: at most a fifth of a side from its centre */
    DMI_KIND_TURN_INSIDE,  /* the axis is less than three quarters of a side from there */
    DMI_KIND_TURN_EDGE,    /* the axis is at most 1.3 sides from there */
    DMI_KIND_TURN_OUTSIDE, /* the axis is farther away */
    DMI_KIND_TURN_TOP,     /* the axis is level, and lies above three fifths of the part's upper half */
    DMI_KIND_TURN_BOTTOM,
    DMI_KIND_TURN_OUTER, /* the axis lies off the box's centre to the side away from the object's centre */
    DMI_KIND_TURN_INNER, /* the axis lies off to the side towards it */
    DMI_KIND_TURN_FRONT, /* the axis lies off to the side of glTF's front, where the up direction is glTF's too */
    DMI_KIND_TURN_BACK,
    DMI_KIND_FEATURES
} dmi_kind_feature;

/* Where a pivot lies in the part's box along the pivot's own axes. */
typedef enum dmi_pivot_place {
    DMI_PIVOT_MIDDLE,  /* the box's centre */
    DMI_PIVOT_BOTTOM,  /* the centre of its lower face */
    DMI_PIVOT_TOP,     /* the centre of its upper face */
    DMI_PIVOT_SIDE,    /* the centre of another face */
    DMI_PIVOT_EDGE,    /* a place on an edge or corner, not in the centre of a face */
    DMI_PIVOT_INSIDE,  /* another place in the box */
    DMI_PIVOT_OUTSIDE, /* a place outside the box */
    DMI_PIVOT_DEFAULT, /* the file's origin, where it is none of the places above that are no accident */
    DMI_PIVOT_PLACES
} dmi_pivot_place;

/* How a candidate lies to a pivot. Each is between 0 and 1. */
typedef enum dmi_pivot_feature {
    DMI_PIVOT_SLIDE,         /* it slides */
    DMI_PIVOT_SLIDE_ALIGNED, /* it slides along an axis of the pivot, within 1 degree */
    DMI_PIVOT_TURN_ALIGNED,  /* it turns about a direction that is such an axis */
    DMI_PIVOT_NEAR,          /* its line passes the pivot at a few hundredths of the part's diagonal */
    DMI_PIVOT_ON,            /* its line passes the pivot at a few thousandths of it */
    DMI_PIVOT_ON_ALIGNED,    /* both of these are so: ON and TURN_ALIGNED */
    DMI_PIVOT_SLIDE_THROUGH, /* it slides, and the pivot lies that way from the middle of the part's box */
    DMI_PIVOT_ON_MIDDLE,     /* it turns about a line through the pivot and the middle of the part's box */
    DMI_PIVOT_FEATURES
} dmi_pivot_feature;

/* What is the same for all candidates of a part. */
typedef struct dmi_hint_frame {
    const dmi_asset_hints* hints;
    const dmi_part_analysis* analysis;
    float box_centre[3];
    float outward[3];                 /* vector from the object's centre to the box's, part diagonals */
    float middle_height, half_height; /* heights of the part along the up direction */
    dmi_pivot_place place;
} dmi_hint_frame;

void dmi_hint_frame_make(const dmi_asset_hints* hints, const dmi_part_analysis* analysis, dmi_hint_frame* out);
/* Returns the candidate's kind features as bits. */
uint32_t dmi_kind_features(const dmi_hint_frame* frame, const dmi_candidate* candidate);
/* Computes the candidate's pivot features. The hints must have a pivot. */
void dmi_pivot_features(const dmi_hint_frame* frame, const dmi_candidate* candidate, float out[DMI_PIVOT_FEATURES]);

#endif
