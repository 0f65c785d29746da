/* Scores candidates by their cheap features and chooses the best. */
#include "kinematics/ranking/candidate_prefilter.h"

#include "base/compiler.h"

#define HIDDEN 16
#define BATCH 32 /* rows at a time, which stay in the first cache */

void dmi_prefilter_read(dmi_loader* loader, dmi_prefilter* out_prefilter) {
    static const uint32_t sizes[] = {DMI_CHEAP_COLUMNS, HIDDEN, 1};
    dmi_load_standardised_perceptron(loader, "prefilter", sizes, 2, &out_prefilter->network);
}

/* Scores the candidates. Neither this function nor keep_best() is inlined, so that the stack holds the arrays of one at
 * a time. */
DMI_NO_INLINE static void score_candidates(const dmi_prefilter* prefilter, dmi_isa isa,
                                           const float (*rows)[DMI_FEATURE_COUNT], uint32_t count, float* out_scores) {
    _Alignas(DMI_ALIGNMENT) float x[BATCH][DMI_CHEAP_COLUMNS], hidden[BATCH][HIDDEN];
    float* const buffers[2] = {hidden[0], NULL};
    for (uint32_t first = 0; first < count; first += BATCH) {
        const uint32_t batch = count - first < BATCH ? count - first : BATCH;
        for (uint32_t r = 0; r < batch; r++)
            for (int k = 0; k < DMI_CHEAP_COLUMNS; k++) x[r][k] = rows[first + r][dmi_cheap_columns[k]];
        dmi_perceptron_apply(&prefilter->network, dmi_kernels_for(isa), x[0], batch, buffers, out_scores + first);
    }
}

/* Returns the n-th largest value, the largest being the 0th, by Hoare's quickselect. Reorders `values`. */
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

/* Moves the best candidates to the front. Of equal ones at the limit, it keeps the first. */
DMI_NO_INLINE static uint32_t keep_best(const float* scores, dmi_candidate* candidates, uint32_t count) {
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

uint32_t dmi_prefilter_keep(const dmi_prefilter* prefilter, const dmi_part_analysis* analysis,
                            const dmi_drag_hint* hint, const dmi_kpp_net* net, dmi_isa isa,
                            const dmi_kpp_ensemble* ensemble, dmi_candidate* candidates, uint32_t count,
                            float (*rows)[DMI_FEATURE_COUNT]) {
    if (count <= DMI_PREFILTER_KEPT) return count;
    float scores[DMI_CANDIDATES_MAX];
    dmi_cheap_features cheap;
    dmi_cheap_features_begin(analysis, hint, ensemble != NULL ? &ensemble->prediction : NULL, &cheap);
    for (uint32_t i = 0; i < count; i++) dmi_cheap_features_row(&cheap, &candidates[i], rows[i]);
    if (ensemble != NULL) dmi_kpp_ensemble_score_first(net, isa, ensemble, candidates, count, scores);
    dmi_cheap_features_kpp_scores(ensemble != NULL ? scores : NULL, count, rows);
    score_candidates(prefilter, isa, (const float(*)[DMI_FEATURE_COUNT])rows, count, scores);
    return keep_best(scores, candidates, count);
}
