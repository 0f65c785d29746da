/* How far the faces that look the way a slide goes are from body faces that look at them, and from which its front lies
 * in one plane with body faces that look the same way: the fronts of closed twins beside it, or the edges of its frame.
 * Both must agree. */
#include "kinematics/limits/closed_pose.h"

#include <float.h>

#include "math/linear3.h"
#include "math/vec3.h"

#define POINTS 256         /* of the part that are looked at; by hand: a few of a front's edge are among them */
#define SAMPLES 4096       /* of the body near it; by hand */
#define LEAST_PART 0.12f   /* object sizes: a smaller part is a button or a knob, which rests out; by hand */
#define FARTHEST 1.0f      /* object sizes */
#define FACING 0.8f        /* cosine between a face and the way that it looks; by hand */
#define BESIDE 0.025f      /* object sizes between two samples that count as one before the other; by hand */
#define MEETS 0.04f        /* share of the looking points that must have met the body; by hand */
#define WITHIN 0.006f      /* object sizes in which they meet it, and of one plane; by hand: a grain of the samples */
#define FLUSH_SHARE 0.12f  /* of the body's faces that look outwards and lie in one plane with the front; by hand */
#define CLOSED_WAY 0.012f  /* object sizes: nearer than this it rests closed; by hand ... */
#define CLOSED_SHARE 0.05f /* ... and of the part along the slide: drawers have room behind them; by hand */
#define BEHIND 0.1f        /* of the part along the slide: most room behind it once its front is flush; by hand */

/* One way of a slide. */
typedef struct closing {
    const dmi_part_analysis* analysis;
    float axis[3];
    float side;       /* +1 or -1: the way of the joint value */
    float closed_way; /* from closed, up to which it rests closed */
} closing;

/* ---- distances to the body along the way ---- */

/* Returns how far a point is from a body sample that lies before it on its way; FLT_MAX: it does not, or the two do not
 * face each other. */
static float way_between(const closing* c, const float point[3], const float normal[3], const float sample[3],
                         const float sample_normal[3]) {
    float between[3];
    dmi_sub3(sample, point, between);
    const float rise = dmi_dot3(between, c->axis);
    dmi_reject3(between, c->axis);
    return dmi_length3(between) < BESIDE && dmi_dot3(normal, sample_normal) < -FACING ? rise * c->side : FLT_MAX;
}

/* Returns whether a point of the part looks the way it goes. */
static bool looks_ahead(const closing* c, uint32_t i) {
    return dmi_dot3(c->analysis->normals[i], c->axis) * c->side > FACING;
}

/* Returns the least way of a point of the part to the body; FLT_MAX: it meets nothing. */
static float way_of_point(const closing* c, uint32_t i, float least) {
    const dmi_part_analysis* a = c->analysis;
    float nearest = FLT_MAX;
    for (uint32_t k = 0; k < a->near_count && k < SAMPLES; k++) {
        const float way = way_between(c, a->points[i], a->normals[i], a->near_points[k], a->near_normals[k]);
        if (way > least && way < nearest) nearest = way;
    }
    return nearest;
}

/* Returns the way after which enough points meet the body at once; FLT_MAX: they never do. */
static float find_contact(const closing* c) {
    float ways[POINTS];
    uint32_t count = 0, looking = 0;
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS && looking < POINTS; i++) {
        if (!looks_ahead(c, i)) continue;
        looking++;
        const float way = way_of_point(c, i, -WITHIN);
        if (way > FARTHEST) continue;
        uint32_t at = count++;
        for (; at > 0 && ways[at - 1] > way; at--) ways[at] = ways[at - 1];
        ways[at] = way;
    }
    const uint32_t needed = (uint32_t)(MEETS * (float)looking) + 2;
    for (uint32_t i = 0; i + needed <= count; i++)
        if (ways[i + needed - 1] - ways[i] <= WITHIN) return ways[i + needed / 2];
    return FLT_MAX;
}

/* ---- planes that the front comes flush with ---- */

enum { BINS = 512 }; /* of heights along a slide, over two object sizes about the part */

/* Returns the bin of a height; BINS: outside. */
static uint32_t bin_of(float height, float zero) {
    const float place = (height - zero) / WITHIN + BINS / 2;
    return place >= 0 && place < BINS ? (uint32_t)place : BINS;
}

/* Returns the height of the part's front along the way: where most of its points that look back are. */
static float front_of(const closing* c, float zero) {
    uint16_t counts[BINS] = {0};
    float sums[BINS] = {0};
    uint32_t most = 0;
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++) {
        const float height = dmi_dot3(c->analysis->points[i], c->axis) * c->side;
        const uint32_t bin = bin_of(height, zero);
        if (bin == BINS || dmi_dot3(c->analysis->normals[i], c->axis) * c->side > -FACING) continue;
        counts[bin]++;
        sums[bin] += height;
        if (counts[bin] > counts[most]) most = bin;
    }
    return counts[most] > 0 ? sums[most] / (float)counts[most] : FLT_MAX;
}

/* Finds the largest plane of the body, up to `contact`, in which the front may come to lie: the fronts of closed twins,
 * or the edges of its frame. Returns whether there is one; where the front lies in one already, that. */
static bool find_flush(const closing* c, float contact, float* out_way) {
    const dmi_part_analysis* a = c->analysis;
    const float zero = dmi_dot3(a->centre, c->axis) * c->side, front = front_of(c, zero);
    uint16_t counts[BINS + 1] = {0};
    float sums[BINS] = {0};
    uint32_t looking = 0;
    if (front == FLT_MAX) return false;
    for (uint32_t k = 0; k < a->near_count; k++) {
        if (dmi_dot3(a->near_normals[k], c->axis) * c->side > -FACING) continue;
        const float height = dmi_dot3(a->near_points[k], c->axis) * c->side;
        const uint32_t bin = bin_of(height, front);
        looking++;
        if (bin == BINS) continue;
        counts[bin]++;
        sums[bin] += height;
    }
    uint32_t most = 0;
    for (uint32_t bin = 0; bin < BINS; bin++) {
        if ((float)(counts[bin] + counts[bin + 1]) < FLUSH_SHARE * (float)looking || counts[bin] == 0) continue;
        const float pair = bin + 1 < BINS ? sums[bin] + sums[bin + 1] : sums[bin];
        const float way = pair / (float)(counts[bin] + counts[bin + 1]) - front;
        if (way < -c->closed_way || way > contact + WITHIN) continue;
        const bool rests_closed = way < c->closed_way;
        if (!rests_closed && (uint32_t)counts[bin] + counts[bin + 1] <= most) continue;
        most = (uint32_t)counts[bin] + counts[bin + 1];
        *out_way = way;
        if (rests_closed) break;
    }
    return most > 0;
}

/* ---- both ways ---- */

static bool find_way(closing* c, float side, float* out_way) {
    c->side = side;
    *out_way = find_contact(c);
    return *out_way != FLT_MAX;
}

bool dmi_closed_pose_find(const dmi_part_analysis* analysis, const dm_joint* joint, float* out_value) {
    const dmi_float3 axis = dmi_xyz(joint->axis);
    closing c = {.analysis = analysis};
    float low, high, ways[2], way;
    dmi_copy3(axis.v, c.axis);
    if (joint->type != DM_JOINT_PRISMATIC || analysis->diagonal < LEAST_PART) return false;
    dmi_extents_along((const float(*)[3])analysis->extreme_points, analysis->extreme_point_count, &axis.v, 1, &low,
                      &high);
    const float depth = high - low;
    c.closed_way = dmi_max(CLOSED_WAY, CLOSED_SHARE * depth);
    const bool up = find_way(&c, 1, &ways[0]), down = find_way(&c, -1, &ways[1]);
    if (up == down) return false;
    const float contact = up ? ways[0] : ways[1];
    c.side = up ? 1.0f : -1.0f;
    if (!find_flush(&c, contact, &way) || way < c.closed_way || contact - way > BEHIND * depth) return false;
    *out_value = c.side * way;
    return true;
}
