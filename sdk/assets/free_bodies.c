/* A lid that nothing holds is round, rests in a rim all round, and has nothing above it. That alone is also true of a
 * button, a knob and a stool's seat: names, a hollow below and a grip in the middle tell it from them. */
#include "assets/free_bodies.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"

enum { SECTORS = 24, RINGS = 12, DEEPEST = 14 }; /* parts of the profile; times that a face is quartered; by hand */

/* All by hand, in radii of the part where they are lengths. */
#define STEP 0.06f        /* longest edge of a piece of a face that counts as one point */
#define EVEN_EXTENTS 0.9f /* least share of the longer horizontal extent that the shorter one is */
#define ROUND 0.85f /* least share of the largest radius that each sector reaches: an octagon has .92, a square .71 */
#define RIM 0.8f    /* radius from which on the part is its rim */
#define SEAT_INNER 0.55f  /* radii between which a body holds the rim, */
#define SEAT_OUTER 1.25f  /* … */
#define SEAT_HEIGHT 0.25f /* and how far above or below it */
#define SEAT_SECTORS 22   /* number of sectors in which it does: a spout or a notch breaks it */
#define INSIDE 0.9f       /* radius within which nothing may be above the part, */
#define ABOVE 0.1f        /* this height and more */
#define CORE 0.5f         /* radius of the hollow, */
#define DEPTH 0.6f        /* and its depth */
#define GRIP_HEIGHT 0.25f /* share of the part's height, at its top, that is the grip */
#define GRIP_RADIUS 0.6f  /* most radius there */
#define HINGE_UP 0.3f     /* cosine between a lid's hinge and up, at most */
#define SURE_HINGE 0.6f   /* confidence from which on a hinge is believed */
#define SURE_SCREW 0.5f   /* and a screw */
#define FREE_SHARE 0.5f   /* joint_confidence of the lift; the other hypotheses share the rest */
#define SAME_WAY 0.996f   /* cosine between two slides that are one: 5 degrees */

/* What stands where around an upright axis. */
typedef struct profile {
    float up[3], across[2][3], centre[2];
    float radius, low, high;   /* the part's radius, lowest and highest place */
    float reach[SECTORS];      /* largest radius of the part */
    float top[RINGS];          /* greatest height of the part at a radius */
    float rim_low, grip;       /* least height of its rim; its radius at the top */
    bool seat[SECTORS];        /* a body is at the rim */
    bool is_covered, is_solid; /* a body is above the part, or below its middle */
} profile;

typedef void (*visit)(profile* p, float radius, float height, uint32_t sector);

static float dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---- points of faces ---- */

/* Coordinates of a point: along both horizontal axes from the centre, and up. */
static void place(const profile* p, const float point[3], float out[3]) {
    for (int k = 0; k < 2; k++) out[k] = dot(point, p->across[k]) - p->centre[k];
    out[2] = dot(point, p->up);
}

static void visit_point(profile* p, const float at[3], visit act) {
    const float turn = dmi_atan2f(at[1], at[0]) / (2 * (float)M_PI) + 0.5f;
    const float sector = turn * SECTORS;
    act(p, sqrtf(at[0] * at[0] + at[1] * at[1]), at[2], (uint32_t)sector % SECTORS);
}

static const float* corner_of(const dmi_packed_mesh* mesh, uint32_t face, int i) {
    return mesh->positions + 3 * (size_t)dmi_packed_corner(mesh, face, i);
}

/* Returns whether a face may come near enough to count. */
static bool is_near(const profile* p, float corners[3][3]) {
    for (int k = 0; k < 3; k++) {
        const float low = dmi_fminf(dmi_fminf(corners[0][k], corners[1][k]), corners[2][k]);
        const float high = dmi_fmaxf(dmi_fmaxf(corners[0][k], corners[1][k]), corners[2][k]);
        const float least = k < 2 ? -SEAT_OUTER * p->radius : p->low - p->radius;
        const float most = k < 2 ? SEAT_OUTER * p->radius : FLT_MAX;
        if (high < least || low > most) return false;
    }
    return true;
}

static float longest_edge(float corners[3][3]) {
    float most = 0;
    for (int i = 0; i < 3; i++) {
        float edge[3];
        for (int k = 0; k < 3; k++) edge[k] = corners[(i + 1) % 3][k] - corners[i][k];
        most = dmi_fmaxf(most, dot(edge, edge));
    }
    return sqrtf(most);
}

/* Visits the corners of the pieces of a face that is quartered until they are small. */
static void visit_face(profile* p, float corners[3][3], int depth, visit act) { /* NOLINT(misc-no-recursion) */
    if (!is_near(p, corners)) return;
    if (depth == DEEPEST || longest_edge(corners) <= STEP * p->radius) {
        for (int i = 0; i < 3; i++) visit_point(p, corners[i], act);
        return;
    }
    float middle[3][3], piece[3][3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) middle[i][k] = 0.5f * (corners[i][k] + corners[(i + 1) % 3][k]);
    visit_face(p, middle, depth + 1, act);
    for (int i = 0; i < 3; i++) {
        memcpy(piece[0], corners[i], sizeof piece[0]);
        memcpy(piece[1], middle[i], sizeof piece[1]);
        memcpy(piece[2], middle[(i + 2) % 3], sizeof piece[2]);
        visit_face(p, piece, depth + 1, act);
    }
}

/* Visits the faces of the part, or those of all that does not move with it. */
static void visit_faces(profile* p, const dmi_object* object, uint32_t index, bool of_part, visit act) {
    for (uint32_t owner = 0; owner < object->part_count; owner++) {
        if (of_part ? owner != index : dmi_object_moves_with(object, owner, index)) continue;
        const dmi_packed_part* part = &object->mesh->parts[owner];
        for (uint32_t f = part->first_face; f < part->first_face + part->face_count; f++) {
            float corners[3][3];
            for (int i = 0; i < 3; i++) place(p, corner_of(object->mesh, f, i), corners[i]);
            visit_face(p, corners, 0, act);
        }
    }
}

/* ---- the profile ---- */

static uint32_t ring_of(const profile* p, float radius) {
    const float ring = RINGS * radius / p->radius;
    return ring < RINGS ? (uint32_t)ring : RINGS - 1;
}

static void see_part(profile* p, float radius, float height, uint32_t sector) {
    float* top = &p->top[ring_of(p, radius)];
    p->reach[sector] = dmi_fmaxf(p->reach[sector], radius);
    *top = dmi_fmaxf(*top, height);
    if (radius >= RIM * p->radius) p->rim_low = dmi_fminf(p->rim_low, height);
    if (height >= p->high - GRIP_HEIGHT * (p->high - p->low)) p->grip = dmi_fmaxf(p->grip, radius);
}

static void see_body(profile* p, float radius, float height, uint32_t sector) {
    const float r = p->radius, above = height - p->rim_low;
    if (radius > SEAT_INNER * r && radius < SEAT_OUTER * r && fabsf(above) < SEAT_HEIGHT * r) p->seat[sector] = true;
    if (radius < INSIDE * r && height > p->top[ring_of(p, radius)] + ABOVE * r) p->is_covered = true;
    if (radius < CORE * r && above > -DEPTH * r) p->is_solid = true;
}

/* Finds the axis, the radius and the heights of a part. Returns whether it is about as long as it is wide. */
static bool measure_extents(const dmi_object* object, uint32_t index, profile* p) {
    const dmi_packed_part* part = &object->mesh->parts[index];
    const float* up = object->parts[index].asset_hints.up;
    float low[3] = {FLT_MAX, FLT_MAX, FLT_MAX}, high[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX}, at[3];
    const int flattest =
        fabsf(up[0]) < fabsf(up[1]) ? (fabsf(up[0]) < fabsf(up[2]) ? 0 : 2) : (fabsf(up[1]) < fabsf(up[2]) ? 1 : 2);
    *p = (profile){.rim_low = FLT_MAX};
    memcpy(p->up, up, sizeof p->up);
    for (int k = 0; k < 3; k++) p->across[0][k] = (float)(k == flattest) - up[flattest] * up[k];
    const float length = sqrtf(dot(p->across[0], p->across[0]));
    for (int k = 0; k < 3; k++) p->across[0][k] /= length;
    for (int k = 0; k < 3; k++) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        p->across[1][k] = up[a] * p->across[0][b] - up[b] * p->across[0][a];
    }
    for (uint32_t i = 0; i < 3 * part->face_count; i++) {
        place(p, corner_of(object->mesh, part->first_face + i / 3, (int)(i % 3)), at);
        for (int k = 0; k < 3; k++) low[k] = dmi_fminf(low[k], at[k]), high[k] = dmi_fmaxf(high[k], at[k]);
    }
    for (int k = 0; k < 2; k++) p->centre[k] = 0.5f * (low[k] + high[k]);
    const float width = dmi_fmaxf(high[0] - low[0], high[1] - low[1]);
    p->radius = 0.5f * width;
    p->low = low[2], p->high = high[2];
    for (int i = 0; i < RINGS; i++) p->top[i] = -FLT_MAX;
    return width > 0 && dmi_fminf(high[0] - low[0], high[1] - low[1]) >= EVEN_EXTENTS * width;
}

/* Measures a part and what is around it. Returns whether it is round, rests in a rim and can be lifted. */
static bool rests_in_a_rim(const dmi_object* object, uint32_t index, profile* p) {
    if (!measure_extents(object, index, p)) return false;
    visit_faces(p, object, index, true, see_part);
    uint32_t seats = 0;
    for (int i = 0; i < SECTORS; i++)
        if (p->reach[i] < ROUND * p->radius) return false;
    visit_faces(p, object, index, false, see_body);
    for (int i = 0; i < SECTORS; i++) seats += p->seat[i];
    return seats >= SEAT_SECTORS && !p->is_covered;
}

/* ---- names and joints ---- */

/* Returns whether a part is held by a hinge at its edge or by a thread. */
static bool is_held(const dmi_object_part* part) {
    const dm_joint* best = &part->hypotheses.joints[0];
    const float axis[3] = {best->axis.x, best->axis.y, best->axis.z};
    if (best->type == DM_JOINT_SCREW) return best->joint_confidence >= SURE_SCREW;
    return best->type == DM_JOINT_REVOLUTE && best->joint_confidence >= SURE_HINGE &&
           fabsf(dot(axis, part->asset_hints.up)) < HINGE_UP;
}

bool dmi_body_is_free(const dmi_object* object, uint32_t index, dmi_asset_named named) {
    const dmi_object_part* part = &object->parts[index];
    const dmi_part_kind kind = part->asset_hints.label.kind;
    const bool is_lid = kind == DMI_KIND_LID || kind == DMI_KIND_CAP;
    const bool says_nothing = kind == DMI_KIND_NOTHING || kind == DMI_KIND_POT;
    if ((!is_lid && !says_nothing) || named.other || dot(part->asset_hints.up, part->asset_hints.up) == 0 ||
        is_held(part))
        return false;
    profile p;
    if (!rests_in_a_rim(object, index, &p)) return false;
    const bool has_grip = p.grip <= GRIP_RADIUS * p.radius;
    if (is_lid) return named.vessel || has_grip || !p.is_solid;
    return has_grip && !p.is_solid && part->hypotheses.joints[0].type != DM_JOINT_SCREW;
}

/* ---- the way off ---- */

/* Returns whether a hypothesis is the lift itself. */
static bool is_lift(const dm_joint* joint, const float up[3]) {
    const float axis[3] = {joint->axis.x, joint->axis.y, joint->axis.z};
    return joint->type == DM_JOINT_PRISMATIC && fabsf(dot(axis, up)) > SAME_WAY;
}

void dmi_body_set_free(dmi_object* object, uint32_t index) {
    dmi_object_part* part = &object->parts[index];
    const float *up = part->asset_hints.up, *centre = part->shape.centre;
    profile p;
    measure_extents(object, index, &p);
    const dmi_hypotheses old = part->hypotheses;
    dmi_hypotheses* now = &part->hypotheses;
    *now = (dmi_hypotheses){.count = 1};
    now->free_range[0] = (dmi_free_range){0, FLT_MAX};
    now->joints[0] = (dm_joint){.struct_size = old.joints[0].struct_size,
                                .type = DM_JOINT_PRISMATIC,
                                .type_confidence = FREE_SHARE,
                                .joint_confidence = FREE_SHARE,
                                .axis = {up[0], up[1], up[2]},
                                .origin = {centre[0], centre[1], centre[2]},
                                .upper = p.high - p.low,
                                .source = DM_JOINT_FROM_GEOMETRY};
    for (uint32_t i = 0; i < old.count && now->count < DM_MAX_HYPOTHESES; i++) {
        if (is_lift(&old.joints[i], up)) continue;
        now->free_range[now->count] = old.free_range[i];
        now->joints[now->count] = old.joints[i];
        now->joints[now->count].type_confidence *= 1 - FREE_SHARE;
        now->joints[now->count++].joint_confidence *= 1 - FREE_SHARE;
    }
    part->joint = dmi_frame_joint_out(&object->frame, &now->joints[0]);
}
