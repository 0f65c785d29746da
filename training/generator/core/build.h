/* Declares the builder, with which categories put an object together. Internal to the generator.
 *
 * A category draws its object closed, front towards +Z, right +X, up +Y, in metres, standing on y = 0. Parts are added
 * with their joint; everything drawn afterwards belongs to the part in use. The value at which a part rests is set
 * apart (dmg_rest), so that geometry is always written for the closed state. Random draws: never two in one expression
 * or argument list, where C leaves their order open. */
#ifndef DMG_BUILD_H
#define DMG_BUILD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/vec.h"
#include "generator.h"

enum { DMG_FRAME_DEPTH = 24, DMG_PART_LIMIT = 96, DMG_FACE_LIMIT = 200000 };

/* A run of faces drawn by one call, which augmentation subdivides, shifts or flips as a whole. It ends where the next
 * begins. */
typedef struct dmg_piece {
    uint32_t first_vertex, first_face, part;
    uint32_t drawn_as; /* the piece that augmentation took its faces from; its own index where a category drew it */
} dmg_piece;

typedef struct dmg_part {
    dmg_joint joint; /* limits relative to the closed state until dmg_finish */
    float rest;
    bool keep_rest; /* augmentation may not change it: the part would collide */
} dmg_part;

typedef struct dmg_builder {
    uint64_t random_state;
    bool messy;
    bool lone;   /* augmentation adds no copy of the whole object */
    bool failed; /* out of memory, or more than the limits above */
    int sides;   /* corners of a full circle, an object's own level of detail */
    dmg_vec* vertices;
    uint32_t* indices;
    uint32_t* face_part;
    dmg_piece* pieces;
    uint32_t vertex_count, vertex_capacity, face_count, face_capacity, piece_count, piece_capacity;
    dmg_part parts[DMG_PART_LIMIT]; /* parts[i] has id i + 1 */
    uint32_t part_count;
    uint32_t part; /* in use */
    dmg_frame frames[DMG_FRAME_DEPTH];
    bool mirrored[DMG_FRAME_DEPTH]; /* frames[i] turns right hands into left ones */
    int frame_depth;
} dmg_builder;

/* ---- random ---- */

uint32_t dmg_random(dmg_builder* b);
float dmg_unit(dmg_builder* b);                               /* uniform in [0, 1) */
float dmg_range(dmg_builder* b, float low, float high);       /* uniform */
float dmg_scale_range(dmg_builder* b, float low, float high); /* uniform in the logarithm */
int dmg_int(dmg_builder* b, int low, int high);               /* both included */
bool dmg_chance(dmg_builder* b, float probability);
float dmg_sign(dmg_builder* b);   /* -1 or 1 */
float dmg_normal(dmg_builder* b); /* standard normal */
/* Returns the index of one of `count` alternatives, drawn by weight. */
int dmg_weighted(dmg_builder* b, const float* weights, int count);

/* ---- creation and release ---- */

void dmg_builder_init(dmg_builder* b, uint64_t seed, bool messy);
void dmg_builder_free(dmg_builder* b);

/* ---- frame: where the next shape goes ---- */

void dmg_save(dmg_builder* b);
void dmg_restore(dmg_builder* b);
void dmg_move(dmg_builder* b, float x, float y, float z);
void dmg_turn(dmg_builder* b, dmg_vec axis, float angle); /* axis unit */
void dmg_mirror(dmg_builder* b, dmg_vec normal);          /* normal unit, one of the axes */
void dmg_grow(dmg_builder* b, float factor);
/* Rotates to the i-th of `count` positions spread evenly round the axis. */
void dmg_turn_to(dmg_builder* b, dmg_vec axis, int i, int count);

/* ---- parts: their id; the new part is in use. Positions and directions are in the current frame ---- */

uint32_t dmg_hinge(dmg_builder* b, uint32_t parent, const char* name, dmg_vec origin, dmg_vec axis, float lower,
                   float upper);
/* Adds a hinge with limits between `least` and `most` radians in either direction, each drawn separately. */
uint32_t dmg_hinge_either_way(dmg_builder* b, uint32_t parent, const char* name, dmg_vec origin, dmg_vec axis,
                              float least, float most);
uint32_t dmg_slide(dmg_builder* b, uint32_t parent, const char* name, dmg_vec direction, float lower, float upper);
uint32_t dmg_spin(dmg_builder* b, uint32_t parent, const char* name, dmg_vec origin, dmg_vec axis);
/* Limits are angles; a turn by one radian advances `pitch` along the axis. */
uint32_t dmg_screw(dmg_builder* b, uint32_t parent, const char* name, dmg_vec origin, dmg_vec axis, float pitch,
                   float lower, float upper);
void dmg_use(dmg_builder* b, uint32_t part); /* 0 = body */
/* Sets the value, within the limits, at which the part rests. */
void dmg_rest(dmg_builder* b, uint32_t part, float value);
void dmg_keep_rest(dmg_builder* b, uint32_t part);
/* Returns the motion of a part alone (its parents at rest) from value 0 to `value`. */
dmg_frame dmg_joint_frame(const dmg_joint* joint, float value);
/* Returns the value at one of `stops` places spread over the range, ends included; over a full turn for a continuous
 * joint. */
float dmg_joint_stop(const dmg_joint* joint, int stop, int stops);

/* ---- bounds ---- */

typedef struct dmg_bounds {
    dmg_vec low, high;
} dmg_bounds;

dmg_bounds dmg_bounds_none(void);
void dmg_bounds_grow(dmg_bounds* bounds, dmg_vec p);
/* Return the end of the piece's vertices and of its faces. */
uint32_t dmg_piece_end(const dmg_builder* b, uint32_t piece);
uint32_t dmg_piece_face_end(const dmg_builder* b, uint32_t piece);
/* Returns the box of a part's own pieces, without what it carries. */
dmg_bounds dmg_part_bounds(const dmg_builder* b, uint32_t part);

/* ---- geometry, lowest level ---- */

void dmg_piece_begin(dmg_builder* b);
uint32_t dmg_vertex(dmg_builder* b, dmg_vec position);
void dmg_triangle(dmg_builder* b, uint32_t i, uint32_t j, uint32_t k); /* counter-clockwise seen from outside */
void dmg_quad(dmg_builder* b, uint32_t i, uint32_t j, uint32_t k, uint32_t l);

/* ---- shapes ---- */

enum {
    DMG_FACE_LEFT = 1,
    DMG_FACE_RIGHT = 2,
    DMG_FACE_BOTTOM = 4,
    DMG_FACE_TOP = 8,
    DMG_FACE_BACK = 16,
    DMG_FACE_FRONT = 32,
    DMG_FACE_ALL = 63
};

void dmg_box(dmg_builder* b, dmg_vec centre, dmg_vec size);
void dmg_box_faces(dmg_builder* b, dmg_vec centre, dmg_vec size, int faces);
/* Corner to corner. */
void dmg_box_span(dmg_builder* b, dmg_vec low, dmg_vec high);
void dmg_rounded_box(dmg_builder* b, dmg_vec centre, dmg_vec size, float radius);
/* A box along the segment: width along the horizontal normal of the segment, height across both. */
void dmg_beam(dmg_builder* b, dmg_vec from, dmg_vec to, float width, float height);
/* A cylinder or cone along the segment, capped where its radius is not zero. */
void dmg_cone(dmg_builder* b, dmg_vec from, dmg_vec to, float radius_from, float radius_to);
void dmg_rod(dmg_builder* b, dmg_vec from, dmg_vec to, float radius);
/* A cylinder with half a ball beyond both its ends, one shell. */
void dmg_capsule(dmg_builder* b, dmg_vec from, dmg_vec to, float radius);
/* Profile of (radius, height) pairs turned about the axis through `origin`; a solid has its profile going up outside.
 */
void dmg_lathe(dmg_builder* b, dmg_vec origin, dmg_vec axis, const dmg_xy* profile, int count);
void dmg_lathe_arc(dmg_builder* b, dmg_vec origin, dmg_vec axis, const dmg_xy* profile, int count, float start,
                   float arc);
void dmg_ellipsoid(dmg_builder* b, dmg_vec centre, dmg_vec radii);
/* Upper half of an ellipsoid about +Y, open below. */
void dmg_dome(dmg_builder* b, dmg_vec base, dmg_vec radii);
void dmg_torus(dmg_builder* b, dmg_vec centre, dmg_vec axis, float radius, float tube);
/* A tube of elliptical section along a path; `across` and `along` are the half sizes in and out of the path's plane. */
void dmg_sweep(dmg_builder* b, const dmg_vec* path, int count, float across, float along, bool closed);
/* A simple polygon in x, y (counter-clockwise), from z = low to z = high. */
void dmg_extrude(dmg_builder* b, const dmg_xy* polygon, int count, float low, float high);
/* A plate between two outlines of equally many points. */
void dmg_ring_plate(dmg_builder* b, const dmg_xy* outer, const dmg_xy* inner, int count, float low, float high);
/* An outline carried along Z, each row scaled, shifted along y and set at its height; closed at both ends. */
typedef struct dmg_row {
    float scale_x, scale_y, shift_y, height;
} dmg_row;
void dmg_loft(dmg_builder* b, const dmg_xy* outline, int count, const dmg_row* rows, int row_count);
/* A rectangle with rounded corners, front at z = 0, `thickness` deep. */
void dmg_rounded_plate(dmg_builder* b, float width, float height, float thickness, float radius);
/* A sheet of the given thickness along a polyline in x, y, `depth` wide about z = 0. */
void dmg_bent_plate(dmg_builder* b, const dmg_xy* line, int count, float thickness, float depth);

/* ---- finishing (augment/) ---- */

/* Lets some parts touch or cut what surrounds them (augment_fit.c). */
void dmg_augment_fit(dmg_builder* b);
/* Makes joints as inexact as people place them (augment_joints.c). size: of the object, metres. */
void dmg_augment_joints(dmg_builder* b, float size);
/* Gives some push buttons deep stems and another travel (augment_buttons.c). */
void dmg_augment_buttons(dmg_builder* b, float size);

enum { DMG_SWEPT_STOPS = 4, DMG_SWEPT_LIMIT = DMG_PART_LIMIT * DMG_SWEPT_STOPS };
/* Computes the boxes of every part, without what it carries, at DMG_SWEPT_STOPS values of its range, its carriers
 * moving likewise. Returns their number: those of part i begin at (i - 1) * DMG_SWEPT_STOPS. */
uint32_t dmg_swept_boxes(const dmg_builder* b, dmg_bounds out[DMG_SWEPT_LIMIT]);
bool dmg_boxes_meet(const dmg_bounds* a, const dmg_bounds* b);
/* Returns the box of all vertices. */
dmg_bounds dmg_whole_bounds(const dmg_builder* b);
float dmg_largest_side(const dmg_bounds* around);

/* Poses the parts at rest, augments a messy object, and makes limits and labels relative to rest (augment_object.c). */
void dmg_finish(dmg_builder* b);

#endif
