/* Nodes of eight boxes: of the triangles' trees and of the scenes'. */
#ifndef DMI_PICK_WIDE_NODE_H
#define DMI_PICK_WIDE_NODE_H

#include <stdint.h>

#include "pick/box_split.h"

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
