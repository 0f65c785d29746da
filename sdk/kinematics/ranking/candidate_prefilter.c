/* The sieve's forward pass and the choice of the best. */
#include "kinematics/ranking/candidate_prefilter.h"

#include "base/cpu.h"

#define SIDE 4 /* rows at a time */

int dmi_prefilter_read(const dmi_weights* weights, dmi_prefilter* out_sieve) {
    enum { IN = DMI_CHEAP_COLUMNS, HIDDEN = DMI_PREFILTER_HIDDEN };
    float mean[IN], scale[IN], first[HIDDEN][IN];
    if (!dmi_weights_read(weights, "sieve.mean", IN, 0, mean) ||
        !dmi_weights_read(weights, "sieve.scale", IN, 0, scale) ||
        !dmi_weights_read(weights, "sieve.0.weight", HIDDEN, IN, &first[0][0]) ||
        !dmi_weights_read(weights, "sieve.0.bias", HIDDEN, 0, out_sieve->first_bias) ||
        !dmi_weights_read(weights, "sieve.2.weight", 1, HIDDEN, out_sieve->last))
        return 0;
    for (int o = 0; o < HIDDEN; o++)
        for (int i = 0; i < IN; i++) {
            out_sieve->first[i][o] = first[o][i] * scale[i];
            out_sieve->first_bias[o] -= out_sieve->first[i][o] * mean[i];
        }
    return 1;
}

/* Some rows side by side: their sums wait less for each other. */
static inline void forward(const dmi_prefilter* sieve, const float (*rows)[DMI_FEATURE_COUNT], float out_scores[SIDE]) {
    float hidden[SIDE][DMI_PREFILTER_HIDDEN];
    for (int r = 0; r < SIDE; r++) memcpy(hidden[r], sieve->first_bias, sizeof hidden[r]);
    for (int i = 0; i < DMI_CHEAP_COLUMNS; i++)
        for (int r = 0; r < SIDE; r++) {
            const float x = rows[r][dmi_cheap_columns[i]];
            for (int o = 0; o < DMI_PREFILTER_HIDDEN; o++) hidden[r][o] += x * sieve->first[i][o];
        }
    for (int r = 0; r < SIDE; r++) {
        out_scores[r] = 0;
        for (int o = 0; o < DMI_PREFILTER_HIDDEN; o++) out_scores[r] += dmi_max(hidden[r][o], 0) * sieve->last[o];
    }
}

/* The last rows that are fewer go once more with some before them. */
static inline void score_rows(const dmi_prefilter* sieve, const float (*rows)[DMI_FEATURE_COUNT], uint32_t count,
                              float* out_scores) {
    for (uint32_t i = 0; i + SIDE <= count; i += SIDE) forward(sieve, rows + i, out_scores + i);
    forward(sieve, rows + count - SIDE, out_scores + count - SIDE);
}

#if defined(__x86_64__)
/* The same operations, eight at a time; without FMA, so the same bits. */
__attribute__((target("avx2"), flatten)) static void
score_avx2(const dmi_prefilter* sieve, const float (*rows)[DMI_FEATURE_COUNT], uint32_t count, float* out_scores) {
    score_rows(sieve, rows, count, out_scores);
}
#endif

static void score(const dmi_prefilter* sieve, const float (*rows)[DMI_FEATURE_COUNT], uint32_t count,
                  float* out_scores) {
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR) {
        score_avx2(sieve, rows, count, out_scores);
        return;
    }
#endif
    score_rows(sieve, rows, count, out_scores);
}

/* The value that comes n-th when the largest is the 0th; `values` lose their order (Hoare's quickselect). */
static float nth_largest(float* values, uint32_t count, uint32_t n) {
    int64_t low = 0, high = (int64_t)count - 1;
    while (low < high) {
        const float pivot = values[(low + high) / 2];
        int64_t i = low, j = high;
        while (i <= j) {
            while (values[i] > pivot) i++;
            while (values[j] < pivot) j--;
            if (i > j) break;
            const float swap = values[i];
            values[i++] = values[j], values[j--] = swap;
        }
        if ((int64_t)n <= j)
            high = j;
        else if ((int64_t)n >= i)
            low = i;
        else
            break;
    }
    return values[n];
}

/* Of equals on the border the first are kept. */
static uint32_t keep_best(const float* scores, dmi_candidate* candidates, uint32_t count) {
    float sorted[DMI_CANDIDATES_MAX];
    memcpy(sorted, scores, count * sizeof *scores);
    const float least = nth_largest(sorted, count, DMI_PREFILTER_KEPT - 1);
    uint32_t above = 0, kept = 0;
    for (uint32_t i = 0; i < count; i++) above += scores[i] > least;
    uint32_t equals = DMI_PREFILTER_KEPT - above;
    for (uint32_t i = 0; i < count; i++) {
        if (scores[i] < least) continue;
        if (!(scores[i] > least)) {
            if (equals == 0) continue;
            equals--;
        }
        candidates[kept++] = candidates[i];
    }
    return kept;
}

uint32_t dmi_prefilter_keep(const dmi_prefilter* sieve, const dmi_part_analysis* study, const dmi_drag_hint* hint,
                            const dmi_kpp_net* net, dmi_isa isa, const dmi_kpp_ensemble* opinion,
                            dmi_candidate* candidates, uint32_t count, float (*rows)[DMI_FEATURE_COUNT]) {
    if (count <= DMI_PREFILTER_KEPT) return count;
    float scores[DMI_CANDIDATES_MAX];
    dmi_cheap_features glance;
    dmi_cheap_features_begin(study, hint, opinion != NULL ? &opinion->prediction : NULL, &glance);
    for (uint32_t i = 0; i < count; i++) dmi_cheap_features_row(&glance, &candidates[i], rows[i]);
    if (opinion != NULL) dmi_kpp_ensemble_score_first(net, isa, opinion, candidates, count, scores);
    dmi_cheap_features_kpp_scores(opinion != NULL ? scores : NULL, count, rows);
    score(sieve, (const float(*)[DMI_FEATURE_COUNT])rows, count, scores);
    return keep_best(scores, candidates, count);
}
