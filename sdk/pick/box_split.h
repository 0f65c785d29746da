/* Splits boxes into two groups by the surface area heuristic on bins (Wald 2007, "On fast construction of SAH-based
 * bounding volume hierarchies"). The triangles' trees and the scenes' are built with it. */
#ifndef DMI_PICK_BOX_SPLIT_H
#define DMI_PICK_BOX_SPLIT_H

#include <stdint.h>

#include "base/progress.h"

/* The fourth floats are there for vector code: it may read and compare them, and what they hold does not count. */
typedef struct dmi_box {
    float low[4], high[4];
} dmi_box;

typedef struct dmi_box_item {
    float low[3];
    uint32_t id;
    float high[3];
    uint32_t unused; /* 0 */
} dmi_box_item;

/* items[first, first + count), with the box of the items and that of their centres (times two). */
typedef struct dmi_box_range {
    dmi_box box, centres;
    uint32_t first, count;
} dmi_box_range;

/* Measures a range whose first and count are set. */
void dmi_box_range_measure(const dmi_box_item* items, dmi_box_range* range);
/* How a range is split. */
typedef enum dmi_box_splits {
    DMI_SPLIT_BY_COST,  /* where it costs least, along any axis */
    DMI_SPLIT_FAST,     /* the same, but large ranges along the longest axis of their centres alone */
    DMI_SPLIT_IN_HALVES /* puts as many items on either side */
} dmi_box_splits;

/* Splits the range ranges[0] into up to `most`, always the one with the largest box of those of more than `block`
 * items; returns how many there are. Groups of up to `block` items cost as much as one. Where bins tell nothing, the
 * halves are as large as each other. Reports large ones; returns 0 when it is cancelled. */
uint32_t dmi_box_split_up(dmi_box_item* items, uint32_t block, dmi_box_splits how, dmi_box_range* ranges, uint32_t most,
                          const dmi_progress* progress);
/* Half the surface. */
static inline float dmi_box_area(const dmi_box* box) {
    const float x = box->high[0] - box->low[0], y = box->high[1] - box->low[1], z = box->high[2] - box->low[2];
    return x * y + y * z + z * x;
}

#define DMI_WIDE 8           /* children of a node: one register of AVX2 */
#define DMI_LEAF 0x80000000u /* flag of a reference: the rest is the index of a leaf, else of a node */

typedef struct dmi_wide_node {
    _Alignas(32) float planes[6][DMI_WIDE]; /* low x, y, z, high x, y, z; unused children: inside out */
    uint32_t child[DMI_WIDE];               /* references; unused children: 0 */
} dmi_wide_node;

static inline void dmi_wide_node_set_box(dmi_wide_node* node, uint32_t slot, const dmi_box* box) {
    for (int k = 0; k < 3; k++) {
        node->planes[k][slot] = box->low[k];
        node->planes[3 + k][slot] = box->high[k];
    }
}

#endif
