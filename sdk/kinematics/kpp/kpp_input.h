/* Input of KPP-Net: a cloud in a frame made from the drag and the part, grouped into tokens, and features of the whole
 * shape (docs/networks.md is the specification). Training builds its batches with this code. */
#ifndef DMI_KPP_KPP_INPUT_H
#define DMI_KPP_KPP_INPUT_H

#include "kinematics/kpp/kpp_frame.h"

#define DMI_KPP_GROUP 16         /* points of a group (docs/networks.md) */
#define DMI_KPP_GLOBAL_GROUPS 48 /* groups of part and body together (docs/networks.md) */
#define DMI_KPP_LOCAL_GROUPS 24  /* groups of the part alone (docs/networks.md) */
#define DMI_KPP_DIRECTIONS 9     /* the part's frame, the body's frame, the part's principal directions */

/* Channels of a point, in the frame: the paper's ten (§3.5), then seven more. */
enum {
    DMI_KPP_POINT = 0,       /* position */
    DMI_KPP_MASK = 3,        /* 1: on the part */
    DMI_KPP_DRAG_POINT = 4,  /* zeros without a drag */
    DMI_KPP_DRAG_VECTOR = 7, /* unit; zeros without a drag */
    DMI_KPP_OFFSET = 10,     /* twice the offset from the group's centre */
    DMI_KPP_NORMAL = 13,     /* unit */
    DMI_KPP_NEARNESS = 16,   /* nearness of the other side, 0 .. 1 */
    DMI_KPP_CHANNELS = 17
};

/* Features of the shape, in the frame. */
enum {
    DMI_KPP_SHAPE_DIRECTIONS = 0,                                /* unit, largest component positive */
    DMI_KPP_SHAPE_PART_BOX = 3 * DMI_KPP_DIRECTIONS,             /* centre, half sides */
    DMI_KPP_SHAPE_OBJECT_BOX = DMI_KPP_SHAPE_PART_BOX + 3 + 3,   /* the same with ends t replaced by +-ln(1 + |t|) */
    DMI_KPP_SHAPE_DRAG_POINT = DMI_KPP_SHAPE_OBJECT_BOX + 3 + 3, /* zeros without a drag */
    DMI_KPP_SHAPE_DRAG_VECTOR = DMI_KPP_SHAPE_DRAG_POINT + 3,    /* unit; zeros without a drag */
    DMI_KPP_SHAPE_RADIUS = DMI_KPP_SHAPE_DRAG_VECTOR + 3,        /* 0.5 ln(radius) + 1, object-normalised */
    DMI_KPP_SHAPE_FITS = DMI_KPP_SHAPE_RADIUS + 1,               /* shares, of the part's frame, the body's, both */
    DMI_KPP_SHAPE_CONTACT_MEAN = DMI_KPP_SHAPE_FITS + 3, /* mean of the part's points in contact with the body */
    DMI_KPP_SHAPE_CONTACT_SPREAD = DMI_KPP_SHAPE_CONTACT_MEAN + 3,  /* their standard deviation */
    DMI_KPP_SHAPE_CONTACT_SHARE = DMI_KPP_SHAPE_CONTACT_SPREAD + 3, /* share of the part's points that are in contact */
    DMI_KPP_SHAPE
};

typedef struct dmi_kpp_input {
    dmi_kpp_frame frame;
    float global_points[DMI_KPP_GLOBAL_GROUPS][DMI_KPP_GROUP][DMI_KPP_CHANNELS];
    float global_centres[DMI_KPP_GLOBAL_GROUPS][3];
    float local_points[DMI_KPP_LOCAL_GROUPS][DMI_KPP_GROUP][DMI_KPP_CHANNELS];
    float local_centres[DMI_KPP_LOCAL_GROUPS][3];
    float shape[DMI_KPP_SHAPE];
} dmi_kpp_input;

/* Makes the input from one subset of the cloud's points. The network is trained on subset 0; others lie below
 * DMI_KPP_SUBSETS. hint: NULL when there is no drag. The function is deterministic and allocates nothing. */
void dmi_kpp_input_make(const dmi_cloud* cloud, uint32_t subset, const dmi_drag_hint* hint, dmi_kpp_input* out_input);
/* Computes the same input in a frame rotated by 180 degrees about its first axis. out_input may be input. */
void dmi_kpp_input_flip(const dmi_kpp_input* input, dmi_kpp_input* out_input);

/* ---- farthest_point_sampling.c: centres spread evenly over points, and the points nearest to each centre ---- */

#define DMI_FPS_POINT_STEP 32 /* divides the number of points: lanes of the distance loops */

/* Points, coordinates separated, and the squared distance of each from the nearest centre so far. */
typedef struct dmi_fps {
    const float *x, *y, *z; /* finite */
    uint32_t count;
    float min_square[DMI_KPP_POINTS];
} dmi_fps;

void dmi_fps_begin(const float* x, const float* y, const float* z, uint32_t count, dmi_fps* out);
/* Finds the group of a centre: itself, then its nearest points by distance, ties by index. Returns the next centre: the
 * point farthest from all centres so far, of equals the first. */
uint32_t dmi_fps_next(dmi_fps* sampling, uint32_t centre, uint32_t out_members[DMI_KPP_GROUP]);

#endif
