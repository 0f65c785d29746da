/* Makes procedural articulated objects with labelled joints from a seed, in the glTF frame (right-handed, +Y up,
 * metres).
 */
#ifndef DMG_GENERATOR_H
#define DMG_GENERATOR_H

#include <stdint.h>

#include "dragmesh/dragmesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Flag of dmg_make: augments the object with clutter, tilts, missing interiors, flipped normals, gaps, open parts … */
enum { DMG_MESSY = 1 };

/* One moving part. Types are DM_JOINT_*; revolute limits in rad, prismatic in metres, both relative to rest (value 0).
 */
typedef struct dmg_joint {
    char name[48];
    int32_t type;
    uint32_t parent; /* 0 = body, else part id */
    float axis[3], origin[3];
    float pitch; /* screws: metres a radian */
    float lower, upper;
    int32_t opens; /* +1 or -1: the direction in which it opens from rest (a drag's direction) */
    float closed;  /* the value at which the object is closed: 0 where it rests closed */
} dmg_joint;

typedef struct dmg_object {
    const char* category;
    float* positions;    /* vertex_count x 3 */
    uint32_t* indices;   /* face_count x 3 */
    uint32_t* face_part; /* 0 = body, i = joints[i - 1] moves it */
    uint32_t vertex_count, face_count;
    dmg_joint* joints; /* joints[i] belongs to part i + 1 */
    uint32_t joint_count;
} dmg_object;

/* What a category may be used for (set in categories.h). */
enum {
    DMG_SET_TRAINED = 0,  /* trained on */
    DMG_SET_TEST_ONLY = 1 /* never trained on nor validated on */
};

/* The use of one object of a category: 18 of 20 seeds are for training, one each for validation and for test. */
enum { DMG_SPLIT_TRAIN = 0, DMG_SPLIT_VALIDATION = 1, DMG_SPLIT_TEST = 2 };

/* Categories are listed in rows 0 .. count - 1. A row may change when categories are added or moved; the id stays.
 * Store ids or names, not rows, and draw random numbers from ids alone. */
uint32_t dmg_category_count(void);
const char* dmg_category_name(uint32_t row); /* NULL: no such row */
uint32_t dmg_category_id(uint32_t row);      /* UINT32_MAX: no such row */
int32_t dmg_category_set(uint32_t row);      /* DMG_SET_*; -1: no such row */
int32_t dmg_category_find(const char* name); /* its row; -1: none */
int32_t dmg_category_with_id(uint32_t id);   /* its row; -1: none */
uint32_t dmg_category_id_limit(void);        /* 1 + the largest id */

/* DMG_SPLIT_* of the object that dmg_make makes of this seed, by a hash of seed and category id. */
int32_t dmg_split(uint32_t category, uint64_t seed);

/* Makes an object. category: a row. Same category id, seed and flags: the same bits. Returns 0 on success. Release with
 * dmg_object_release. */
int dmg_make(uint32_t category, uint64_t seed, uint32_t flags, dmg_object* out_object);
void dmg_object_release(dmg_object* object);
/* Returns the largest side of the object's box. */
float dmg_object_size(const dmg_object* object);

/* Draws a drag on part `part` (1 ..): a point on its surface (for turning joints at least 0.3 of the farthest distance
 * from the axis), and the direction in which the point starts to move, `noise_degrees` x |N(0, 1)| off, with a length
 * between 0.02 and 0.5 of the object's size. */
void dmg_drag(const dmg_object* object, uint32_t part, float noise_degrees, uint64_t seed, float out_point[3],
              float out_vector[3]);

#ifdef __cplusplus
}
#endif

#endif
