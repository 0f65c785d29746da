/* Each node says which of a fixed list of rules its pivot follows. Those that the asset's largest node follows are
 * counted. */
#include "mesh/pivot_rule.h"

#include <math.h>
#include <string.h>

#include "math/linear3.h"

#define SAME_SPOT 0.01    /* diagonals of a node's box between its pivot and the place of a rule; by hand */
#define SAME_SIDE 1e-3    /* share of the largest side, between copies of one mesh; by hand: rounding alone */
#define LEAST_VOLUME 1e-3 /* diagonals cubed, from which faces enclose something; by hand */

enum { OWN_AXES, SCENE_AXES, FRAMES };
enum { RULE_SURFACE = FRAMES * DMI_BOX_PLACES, RULE_VOLUME, RULE_POINT, RULES };

static const double scene_axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double least(double a, double b) {
    return b < a ? b : a;
}

static double most_of(double a, double b) {
    return b > a ? b : a;
}

static double length(const double a[3]) {
    return sqrt(dot(a, a));
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int k = 0; k < 3; k++) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* ---- one node ---- */

void dmi_pivot_gauge_begin(const double origin[3], const float axes[9], dmi_pivot_gauge* out) {
    *out = (dmi_pivot_gauge){.face_count = 0};
    memcpy(out->origin, origin, sizeof out->origin);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) out->axes[i][k] = (double)axes[3 * i + k];
        const double size = length(out->axes[i]);
        for (int k = 0; k < 3; k++) out->axes[i][k] = size > 0 ? out->axes[i][k] / size : scene_axes[i][k];
        out->scale[i] = size > 0 ? size : 1;
        for (int frame = 0; frame < FRAMES; frame++) {
            out->low[frame][i] = HUGE_VAL;
            out->high[frame][i] = -HUGE_VAL;
        }
    }
}

static const double (*axes_of(const dmi_pivot_gauge* gauge, int frame))[3] {
    return frame == OWN_AXES ? gauge->axes : scene_axes;
}

void dmi_pivot_gauge_add_face(dmi_pivot_gauge* gauge, const double corners[3][3]) {
    double arm[3][3], first[3], second[3], normal[3];
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) arm[i][k] = corners[i][k] - gauge->origin[k];
        for (int k = 0; k < FRAMES * 3; k++) {
            const int frame = k / 3, row = k % 3;
            const double at = dot(arm[i], axes_of(gauge, frame)[row]);
            gauge->low[frame][row] = least(gauge->low[frame][row], at);
            gauge->high[frame][row] = most_of(gauge->high[frame][row], at);
        }
    }
    for (int k = 0; k < 3; k++) first[k] = arm[1][k] - arm[0][k], second[k] = arm[2][k] - arm[0][k];
    cross(first, second, normal);
    const double area = length(normal) / 2, volume = dot(arm[0], normal) / 6;
    for (int k = 0; k < 3; k++) {
        const double sum = arm[0][k] + arm[1][k] + arm[2][k];
        gauge->moment[k] += area * sum / 3;
        gauge->volume_moment[k] += volume * sum / 4;
    }
    gauge->area += area;
    gauge->volume += volume;
    gauge->face_count++;
}

/* Returns how far the pivot lies from a place of the box along a frame's axes. */
static double distance_from_place(const dmi_pivot_gauge* gauge, int frame, int place) {
    double offset[3];
    for (int k = 0, rest = place; k < 3; k++, rest /= 3) {
        const double share = (double)(rest % 3) / 2;
        offset[k] = gauge->low[frame][k] + share * (gauge->high[frame][k] - gauge->low[frame][k]);
    }
    return length(offset);
}

/* Returns how far the pivot lies from a centre of mass. */
static double distance_from_centre(const double moment[3], double mass) {
    const double offset[3] = {moment[0] / mass, moment[1] / mass, moment[2] / mass};
    return length(offset);
}

dmi_pivot_witness dmi_pivot_gauge_finish(const dmi_pivot_gauge* gauge) {
    dmi_pivot_witness out = {.rules = 0};
    memcpy(out.origin, gauge->origin, sizeof out.origin);
    if (gauge->face_count == 0 || !(gauge->area > 0)) return out;
    out.area = gauge->area;
    out.face_count = gauge->face_count;
    for (int k = 0; k < 3; k++) {
        out.sides[k] = gauge->high[SCENE_AXES][k] - gauge->low[SCENE_AXES][k];
        out.mesh_sides[k] = (gauge->high[OWN_AXES][k] - gauge->low[OWN_AXES][k]) / gauge->scale[k];
    }
    const double diagonal = length(out.sides), near = SAME_SPOT * diagonal;
    for (int rule = 0; rule < RULE_SURFACE; rule++)
        if (distance_from_place(gauge, rule / DMI_BOX_PLACES, rule % DMI_BOX_PLACES) <= near)
            out.rules |= UINT64_C(1) << rule;
    if (distance_from_centre(gauge->moment, gauge->area) <= near) out.rules |= UINT64_C(1) << RULE_SURFACE;
    if (fabs(gauge->volume) > LEAST_VOLUME * diagonal * diagonal * diagonal &&
        distance_from_centre(gauge->volume_moment, gauge->volume) <= near)
        out.rules |= UINT64_C(1) << RULE_VOLUME;
    return out;
}

/* ---- all nodes ---- */

static bool counts(const dmi_pivot_witness* node) {
    return node->area > 0;
}

/* Returns whether a node follows a rule, RULE_POINT: that of standing where `first` stands. */
static bool follows(const dmi_pivot_witness* node, int rule, const dmi_pivot_witness* first) {
    if (rule == RULE_POINT) return memcmp(node->origin, first->origin, sizeof node->origin) == 0;
    return node->rules >> rule & 1;
}

/* Returns whether two nodes may be copies of one mesh, of whatever scale. */
static bool are_copies(const dmi_pivot_witness* a, const dmi_pivot_witness* b) {
    const double *x = a->mesh_sides, *y = b->mesh_sides;
    const double most = most_of(x[0], most_of(x[1], x[2])), other = most_of(y[0], most_of(y[1], y[2]));
    if (a->face_count != b->face_count) return false;
    for (int k = 0; k < 3; k++)
        if (fabs(x[k] * other - y[k] * most) > SAME_SIDE * most * other) return false;
    return true;
}

/* Returns 0 where all that follow are copies of one mesh. */
static uint32_t count_followers(const dmi_pivot_witness* nodes, uint32_t count, int rule,
                                const dmi_pivot_witness* first) {
    uint32_t followers = 0;
    bool copies = rule != RULE_POINT;
    for (uint32_t i = 0; i < count; i++) {
        if (!counts(&nodes[i]) || !follows(&nodes[i], rule, first)) continue;
        followers++;
        copies &= are_copies(&nodes[i], first);
    }
    return copies ? 0 : followers;
}

void dmi_pivots_judge(const dmi_pivot_witness* nodes, uint32_t count, dmi_pivot_kind* out) {
    uint32_t counted = 0, most = 0;
    const dmi_pivot_witness* largest = NULL;
    int found = RULES;
    for (uint32_t i = 0; i < count; i++) {
        out[i] = DMI_PIVOT_UNJUDGED;
        if (!counts(&nodes[i])) continue;
        counted++;
        if (largest == NULL || nodes[i].area > largest->area) largest = &nodes[i];
    }
    for (int rule = 0; largest != NULL && rule < RULES; rule++) {
        const uint32_t followers = follows(largest, rule, largest) ? count_followers(nodes, count, rule, largest) : 0;
        if (followers > most) most = followers, found = rule;
    }
    if (most < 2 || 2 * most <= counted) return;
    for (uint32_t i = 0; i < count; i++) {
        if (!counts(&nodes[i]) && found != RULE_POINT) continue;
        const bool same = follows(&nodes[i], found, largest);
        if (same || counts(&nodes[i])) out[i] = same ? DMI_PIVOT_UNSET : DMI_PIVOT_SET;
    }
}

/* ---- parts alone ---- */

/* Returns which side of the box is the longest and which the shortest, as one number. */
static int stretch_of(const dmi_pivot_witness* part) {
    int longest = 0, shortest = 0;
    for (int k = 1; k < 3; k++) {
        if (part->sides[k] > part->sides[longest]) longest = k;
        if (part->sides[k] <= part->sides[shortest]) shortest = k;
    }
    return 3 * longest + shortest;
}

/* Returns whether a rule is the middle of the box or of one of its faces, or a centre of mass. */
static bool is_central(int rule) {
    int ends = 0;
    for (int k = 0, rest = rule % DMI_BOX_PLACES; k < 3; k++, rest /= 3) ends += rest % 3 != 1;
    return rule >= RULE_SURFACE || ends <= 1;
}

bool dmi_part_pivots_follow_rule(const dmi_pivot_witness* parts, uint32_t count) {
    uint64_t rules = UINT64_MAX;
    uint32_t shapes = 0;
    bool stretch_differs = false;
    for (uint32_t i = 0; i < count; i++) {
        bool is_new = counts(&parts[i]);
        if (!is_new) continue;
        rules &= parts[i].rules;
        for (uint32_t k = 0; k < i && is_new; k++) is_new = !counts(&parts[k]) || !are_copies(&parts[i], &parts[k]);
        shapes += is_new;
        stretch_differs |= stretch_of(&parts[i]) != stretch_of(&parts[0]);
    }
    if (shapes < DMI_PIVOT_LEAST_SHAPES) return false;
    for (int rule = 0; rule < RULE_POINT; rule++)
        if ((rules >> rule & 1) && (is_central(rule) || stretch_differs)) return true;
    return false;
}

/* ---- pivots of parts ---- */

static void begin(const dmi_frame* frame, const dm_pivot* pivot, dmi_pivot_gauge* out) {
    float origin[3], axes[9];
    dmi_frame_point_in(frame, dmi_xyz_f64(pivot->origin).v, origin);
    for (int i = 0; i < 9; i += 3) dmi_frame_direction_in(frame, pivot->axes + i, axes + i);
    dmi_pivot_gauge_begin((const double[]){(double)origin[0], (double)origin[1], (double)origin[2]}, axes, out);
}

static void read_corners(const dmi_mesh* mesh, uint32_t face, double out[3][3]) {
    for (size_t i = 0; i < 3; i++)
        for (size_t k = 0; k < 3; k++)
            out[i][k] = (double)mesh->positions[3 * (size_t)mesh->indices[3 * (size_t)face + i] + k];
}

void dmi_part_pivots_measure(const dmi_mesh* mesh, const dm_pivot* const* pivots, dmi_pivot_gauge* scratch,
                             dmi_pivot_witness* out) {
    for (uint32_t i = 0; i < mesh->part_count; i++)
        if (pivots[i] != NULL) begin(&mesh->frame, pivots[i], &scratch[i]);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        double corners[3][3];
        if (pivots[mesh->face_part[f]] == NULL) continue;
        read_corners(mesh, f, corners);
        dmi_pivot_gauge_add_face(&scratch[mesh->face_part[f]], (const double(*)[3])corners);
    }
    for (uint32_t i = 0; i < mesh->part_count; i++)
        out[i] = pivots[i] != NULL ? dmi_pivot_gauge_finish(&scratch[i]) : (dmi_pivot_witness){.rules = 0};
}
