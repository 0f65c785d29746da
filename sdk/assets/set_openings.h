/* What a set of nodes would open: what it hangs on, what it covers, how much room is behind it, and what stands out of
 * its largest node as a grip does. All lengths are in object sizes unless a comment says otherwise. */
#ifndef DMI_ASSETS_SET_OPENINGS_H
#define DMI_ASSETS_SET_OPENINGS_H

#include "assets/asset_facts.h"
#include "assets/set_motions.h"

#define DMI_OPENING_FEATURES 36

/* Where each group of numbers begins. */
enum {
    DMI_OPENING_HANG = 0, /* how line-like its contacts are (0: a line), their length by its longest side; collisions of
                             turns about that line by 0.25 and 0.9 rad, the freer way and the other; distance of its
                             middle from the line by its longest side */
    DMI_OPENING_WAYS = 7, /* its freest way and the next, 8 each: share of points that leave the object and distance
                             of what the others meet, ahead and behind; cover of the outline, distance to the outside;
                             contacts across and along the way, in half extents */
    DMI_OPENING_GRIP = 23,       /* share of its largest node, what stands out of that, how far off the others are */
    DMI_OPENING_DEPENDANTS = 28, /* nodes that touch it alone, and their cells by its own */
    DMI_OPENING_CLEARANCE = 30,  /* mean and least gap, share of the contact that has one */
    DMI_OPENING_PLACE = 33       /* thickness along the way; middle along both ways, in the object's extents */
};

/* Puts DMI_OPENING_FEATURES numbers. ways: of dmi_measure_ways; nodes: those of the set. */
void dmi_put_openings(dmi_row* row, const dmi_node_set* set, const dmi_asset_facts* facts,
                      const dmi_set_way ways[DMI_GRID_SIDES], const uint32_t* nodes);

#endif
