/* Clusters a subset of the points by single linkage. */
#include "kinematics/candidates/contact_clusters.h"

#include "math/linear3.h"

#define MAX_POINTS 256       /* most points of a region, evenly chosen, because the clustering is quadratic; by hand */
#define LINK_DISTANCE 0.05f  /* part diagonals between points of one cluster when all are used; by hand */
#define MIN_CLUSTER_POINTS 3 /* least points of a cluster; by hand */

typedef struct clustering {
    uint32_t points[MAX_POINTS], labels[MAX_POINTS]; /* indices of part points, cluster of each */
    uint32_t count;
} clustering;

/* Merges the clusters of all points that are closer than max_distance. */
static void link_points(const dmi_part_analysis* analysis, float max_distance, clustering* c) {
    for (uint32_t i = 0; i < c->count; i++)
        for (uint32_t j = 0; j < i; j++) {
            const float *a = analysis->points[c->points[i]], *b = analysis->points[c->points[j]];
            if (c->labels[i] == c->labels[j] || dmi_distance3(a, b) > max_distance) continue;
            uint32_t from = c->labels[i], to = c->labels[j];
            for (uint32_t k = 0; k < c->count; k++) c->labels[k] = c->labels[k] == from ? to : c->labels[k];
        }
}

/* Computes the centre of the cluster's bounding box. Returns its number of points. */
static uint32_t measure_cluster(const dmi_part_analysis* analysis, const clustering* c, uint32_t label,
                                float centre[3]) {
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    uint32_t size = 0;
    for (uint32_t i = 0; i < c->count; i++) {
        if (c->labels[i] != label) continue;
        size++;
        for (int k = 0; k < 3; k++) {
            low[k] = dmi_min(low[k], analysis->points[c->points[i]][k]);
            high[k] = dmi_max(high[k], analysis->points[c->points[i]][k]);
        }
    }
    for (int k = 0; k < 3; k++) centre[k] = (low[k] + high[k]) / 2;
    return size;
}

uint32_t dmi_contact_clusters_find(const dmi_part_analysis* analysis, const dmi_contact* contact,
                                   float out_centres[DMI_MAX_CONTACT_CLUSTERS][3]) {
    clustering c = {.count = 0};
    const uint32_t step = contact->count / MAX_POINTS + 1;
    for (uint32_t i = 0; i < contact->count && c.count < MAX_POINTS; i += step) {
        c.points[c.count] = contact->points[i], c.labels[c.count] = c.count;
        c.count++;
    }
    link_points(analysis, LINK_DISTANCE * analysis->diagonal * sqrtf((float)step), &c);
    uint32_t found = 0;
    for (uint32_t label = 0; label < c.count && found < DMI_MAX_CONTACT_CLUSTERS; label++) {
        const uint32_t size = measure_cluster(analysis, &c, label, out_centres[found]);
        if (size >= MIN_CLUSTER_POINTS && size < c.count) found++;
    }
    return found;
}
