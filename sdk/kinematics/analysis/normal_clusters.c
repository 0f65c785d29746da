/* Clusters greedily: the normal with the most parallel ones takes all that are nearly parallel to it. */
#include "kinematics/analysis/analysis_steps.h"

#include <stdbool.h>

#include "math/linear3.h"

#define MAX_NORMALS 1024        /* the first ones, which are a random subset of the samples; by hand */
#define MAX_SEEDS 128           /* normals tried as the centre of a cluster, evenly spaced; by hand */
#define PARALLEL_COSINE 0.9995f /* |cosine| of parallel normals (1.8 degrees); by hand */
#define NEARBY_COSINE 0.985f    /* |cosine| of normals that a cluster takes (9.9 degrees); by hand */
#define MIN_SHARE 0.01f         /* least share of the normals in a cluster; by hand */

/* Normals, coordinates separated. Zeros: taken. */
typedef struct normal_set {
    float xyz[3][MAX_NORMALS];
    uint32_t count;
} normal_set;

static float cosine_between(const normal_set* set, uint32_t i, uint32_t j) {
    return set->xyz[0][i] * set->xyz[0][j] + set->xyz[1][i] * set->xyz[1][j] + set->xyz[2][i] * set->xyz[2][j];
}

static bool is_taken(const normal_set* set, uint32_t i) {
    return set->xyz[0][i] == 0 && set->xyz[1][i] == 0 && set->xyz[2][i] == 0;
}

static void take(normal_set* set, uint32_t i) {
    for (int k = 0; k < 3; k++) set->xyz[k][i] = 0;
}

/* Returns the normal with the most parallel ones, among up to about MAX_SEEDS evenly spaced ones. */
static uint32_t find_seed(const normal_set* set, uint32_t* out_votes) {
    uint32_t best = 0, step = set->count / MAX_SEEDS + 1;
    *out_votes = 0;
    for (uint32_t i = 0; i < set->count; i += step) {
        if (is_taken(set, i)) continue;
        uint32_t votes = 0;
        for (uint32_t j = 0; j < set->count; j++) votes += fabsf(cosine_between(set, i, j)) > PARALLEL_COSINE;
        if (votes > *out_votes) *out_votes = votes, best = i;
    }
    return best;
}

/* Takes the normals near the seed's direction; the cluster's direction is the mean of the parallel ones. */
static void take_cluster(normal_set* set, const float (*normals)[3], uint32_t seed, dmi_normal_cluster* out) {
    float mean[3] = {0, 0, 0}, taken = 0;
    for (uint32_t i = 0; i < set->count; i++) {
        float c = cosine_between(set, i, seed);
        if (is_taken(set, i) || fabsf(c) < NEARBY_COSINE) continue;
        if (fabsf(c) > PARALLEL_COSINE) dmi_madd3(mean, c < 0 ? -1.0f : 1.0f, normals[i], mean);
        if (i != seed) take(set, i);
        taken += 1;
    }
    take(set, seed);
    dmi_normalize3(mean);
    dmi_copy3(mean, out->direction);
    out->share = taken / (float)set->count;
}

uint32_t dmi_normal_clusters_find(const float (*normals)[3], uint32_t count, uint32_t max_clusters,
                                  dmi_normal_cluster* out) {
    normal_set set = {.count = count < MAX_NORMALS ? count : MAX_NORMALS};
    for (uint32_t i = 0; i < set.count; i++)
        for (int k = 0; k < 3; k++) set.xyz[k][i] = dmi_dot3(normals[i], normals[i]) > 0.5f ? normals[i][k] : 0;
    uint32_t found = 0;
    while (found < max_clusters) {
        uint32_t votes, seed = find_seed(&set, &votes);
        if (votes == 0 || (float)votes < MIN_SHARE * (float)set.count) break;
        take_cluster(&set, normals, seed, &out[found++]);
    }
    return found;
}
