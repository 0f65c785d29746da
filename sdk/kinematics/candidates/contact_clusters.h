/* Clusters of a contact region's points, such as the hinges of one door. */
#ifndef DMI_CANDIDATES_CONTACT_CLUSTERS_H
#define DMI_CANDIDATES_CONTACT_CLUSTERS_H

#include "kinematics/analysis/part_analysis.h"

#define DMI_MAX_CONTACT_CLUSTERS 4 /* most clusters of a region; by hand */
#define DMI_CLUSTERED_REGIONS 2    /* contact regions that are clustered: those with a fixed limit of the gap */

/* Computes the centres of the bounding boxes of the region's clusters (single linkage). Returns how many there are, or
 * 0 when the region is one cluster. */
uint32_t dmi_contact_clusters_find(const dmi_part_analysis* analysis, const dmi_contact* contact,
                                   float out_centres[DMI_MAX_CONTACT_CLUSTERS][3]);

#endif
