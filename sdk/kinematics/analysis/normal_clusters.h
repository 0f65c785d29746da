/* Clusters of parallel surface normals. */
#ifndef DMI_ANALYSIS_NORMAL_CLUSTERS_H
#define DMI_ANALYSIS_NORMAL_CLUSTERS_H

#include <stdint.h>

typedef struct dmi_normal_cluster {
    float direction[3]; /* unit; its sign is arbitrary */
    float share;        /* share of all normals, 0 .. 1 */
} dmi_normal_cluster;

/* Finds the directions that many of the unit normals are parallel to, regardless of sign, most frequent first. Returns
 * their number, at most max_clusters. */
uint32_t dmi_normal_clusters_find(const float (*normals)[3], uint32_t count, uint32_t max_clusters,
                                  dmi_normal_cluster* out);

#endif
