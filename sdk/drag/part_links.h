/* Links between the parts of an object. By them, a part's value, or whether it may move, follows from another
 * part's. */
#ifndef DMI_DRAG_PART_LINKS_H
#define DMI_DRAG_PART_LINKS_H

#include <stddef.h>

#include "math/joint.h"

/* A dm_link whose parts are indices. A list of them has each driver before what it drives. */
typedef struct dmi_link {
    uint32_t driver, driven;
    int32_t kind; /* DM_LINK_* */
    bool both_ways;
    float ratio, offset, from;
} dmi_link;

/* Puts links into their order, in place. Returns false when a part is driven twice, or by itself over others. scratch:
 * room for as many links. */
bool dmi_links_order(dmi_link* links, uint32_t count, dmi_link* scratch);
/* Joints of all parts, for their limits. */
typedef struct dmi_linked_joints {
    const dm_joint* first;
    size_t stride; /* bytes from one to the next */
} dmi_linked_joints;

/* Moves what is linked with the part `moved`. changed: one number a part, zeros at first, which becomes 1 where a value
 * was set. */
void dmi_links_follow(const dmi_link* links, uint32_t count, dmi_linked_joints joints, uint32_t moved, float* values,
                      uint8_t* changed);
/* Writes 1 for the parts that links hold where they are, 0 for the others. */
void dmi_links_hold(const dmi_link* links, uint32_t count, const float* values, uint8_t* out_held, uint32_t part_count);

#endif
