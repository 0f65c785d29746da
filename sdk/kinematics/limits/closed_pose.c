/* Finds where a part that rests open is closed, by what it meets on its way to the body and what its front comes flush
 * with. It measures two ways of a slide. One is how far the faces that look the way it goes are from body faces that
 * look at them. The other ends where its front lies in one plane with body faces that look the same way: the fronts of
 * closed twins beside it, or the edges of its frame. Both must agree. */
#include "kinematics/limits/limits.h"

#include <float.h>

#include "math/linear3.h"

#define POINTS 256         /* points of the part that are looked at; by hand: a few of a front's edge are among them */
#define SAMPLES 4096       /* samples of the body near it; by hand */
#define LEAST_PART 0.12f   /* object sizes: a smaller part is a button or a knob, which rests out; by hand */
#define FARTHEST 1.0f      /* object sizes */
#define FACING 0.8f        /* cosine between a face and the way that it looks; by hand */
#define LOOKS_BACK (-.25f) /* cosine from the way to a body face that a point may face: cos(2 acos FACING) is 0.28 */
#define ROUNDING 1e-4f     /* object sizes, of a place across the axis; by hand */
#define BESIDE 0.025f      /* object sizes between two samples that count as one before the other; by hand */
#define MEETS 0.04f        /* share of the looking points that must have met the body; by hand */
#define WITHIN 0.006f      /* object sizes in which they meet it, and of one plane; by hand: a grain of the samples */
#define FLUSH_SHARE 0.12f  /* share of the body's outward faces that lie in one plane with the front; by hand */
#define CLOSED_WAY 0.012f  /* object sizes: nearer than this it rests closed; by hand ... */
#define CLOSED_SHARE 0.05f /* ... and of the part along the slide: drawers have room behind them; by hand */
#define BEHIND 0.1f        /* share of the part along the slide: most room behind it once its front is flush; by hand */

/* One way of a slide. */
typedef struct closing {
    const dmi_part_analysis* analysis;
    float axis[3];
    float side;       /* direction of the joint value: +1 or -1 */
    float closed_way; /* distance from the closed place, up to which the part rests closed */
} closing;

/* ---- distances to the body along the way ---- */

/* Returns how far a point is from a body sample that lies before it on its way. Returns FLT_MAX when the sample does
 * not lie there, or the two do not face each other. */
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

/* Points of the part that look the way it goes, by rising place across it, and how far each is from the body. */
typedef struct looking_points {
    float across_axis[3]; /* a direction perpendicular to the axis */
    uint32_t index[POINTS], count;
    float place[POINTS], way[POINTS]; /* FLT_MAX: it meets nothing */
} looking_points;

static void add_looking(const closing* c, uint32_t index, looking_points* to) {
    const float place = dmi_dot3(c->analysis->points[index], to->across_axis);
    uint32_t at = to->count++;
    for (; at > 0 && to->place[at - 1] > place; at--) {
        to->place[at] = to->place[at - 1];
        to->index[at] = to->index[at - 1];
    }
    to->place[at] = place;
    to->index[at] = index;
}

static void find_looking(const closing* c, looking_points* out) {
    out->count = 0;
    float other[3];
    dmi_perpendicular3(c->axis, out->across_axis, other);
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS && out->count < POINTS; i++)
        if (looks_ahead(c, i)) add_looking(c, i, out);
    for (uint32_t i = 0; i < out->count; i++) out->way[i] = FLT_MAX;
}

/* Returns the first point that is not farther back across the axis than `place`. */
static uint32_t first_from(const looking_points* points, float place) {
    uint32_t low = 0, high = points->count;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (points->place[middle] < place)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Shortens the ways of the points that a sample of the body lies before. */
static void meet_sample(const closing* c, uint32_t sample, looking_points* points) {
    const dmi_part_analysis* a = c->analysis;
    const float *at = a->near_points[sample], *normal = a->near_normals[sample];
    const float place = dmi_dot3(at, points->across_axis), reach = BESIDE + ROUNDING;
    for (uint32_t p = first_from(points, place - reach); p < points->count && points->place[p] <= place + reach; p++) {
        const uint32_t i = points->index[p];
        const float way = way_between(c, a->points[i], a->normals[i], at, normal);
        if (way > -WITHIN && way < points->way[p]) points->way[p] = way;
    }
}

/* Returns the way after which enough points meet the body at once, or FLT_MAX when they never do. */
static float find_contact(const closing* c) {
    const dmi_part_analysis* a = c->analysis;
    looking_points points;
    float ways[POINTS];
    uint32_t count = 0;
    find_looking(c, &points);
    for (uint32_t k = 0; k < a->near_count && k < SAMPLES; k++)
        if (dmi_dot3(a->near_normals[k], c->axis) * c->side < LOOKS_BACK) meet_sample(c, k, &points);
    for (uint32_t p = 0; p < points.count; p++) {
        if (points.way[p] > FARTHEST) continue;
        uint32_t at = count++;
        for (; at > 0 && ways[at - 1] > points.way[p]; at--) ways[at] = ways[at - 1];
        ways[at] = points.way[p];
    }
    const uint32_t needed = (uint32_t)(MEETS * (float)points.count) + 2;
    for (uint32_t i = 0; i + needed <= count; i++)
        if (ways[i + needed - 1] - ways[i] <= WITHIN) return ways[i + needed / 2];
    return FLT_MAX;
}

/* ---- planes that the front comes flush with ---- */

enum { BINS = 512 }; /* number of bins of heights along a slide, over two object sizes about the part */

/* Returns the bin of a height, or BINS when it is outside. */
static uint32_t bin_of(float height, float zero) {
    const float place = (height - zero) / WITHIN + BINS / 2;
    return place >= 0 && place < BINS ? (uint32_t)place : BINS;
}

/* Returns the height of the part's front along the way, where most of its points that look back are. */
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
 * or the edges of its frame. Where the front lies in such a plane already, it finds that one. Returns whether there is
 * one. */
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
