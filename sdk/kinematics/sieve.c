/* The sieve's forward pass and the choice of the best. */
#include "kinematics/sieve.h"

#include "base/cpu.h"

#define SIDE 4 /* rows at a time */

int dmi_sieve_read(const dmi_weights* weights, dmi_sieve* out_sieve) {
    enum { IN = DMI_GLANCE_COLUMNS, HIDDEN = DMI_SIEVE_HIDDEN };
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
static inline void forward(const dmi_sieve* sieve, const float (*rows)[DMI_EVIDENCE_COUNT], float out_scores[SIDE]) {
    float hidden[SIDE][DMI_SIEVE_HIDDEN];
    for (int r = 0; r < SIDE; r++) memcpy(hidden[r], sieve->first_bias, sizeof hidden[r]);
    for (int i = 0; i < DMI_GLANCE_COLUMNS; i++)
        for (int r = 0; r < SIDE; r++) {
            const float x = rows[r][dmi_glance_columns[i]];
            for (int o = 0; o < DMI_SIEVE_HIDDEN; o++) hidden[r][o] += x * sieve->first[i][o];
        }
    for (int r = 0; r < SIDE; r++) {
        out_scores[r] = 0;
        for (int o = 0; o < DMI_SIEVE_HIDDEN; o++) out_scores[r] += dmi_max(hidden[r][o], 0) * sieve->last[o];
    }
}

/* The last rows that are fewer go once more with some before them. */
static inline void score_rows(const dmi_sieve* sieve, const float (*rows)[DMI_EVIDENCE_COUNT], uint32_t count,
                              float* out_scores) {
    for (uint32_t i = 0; i + SIDE <= count; i += SIDE) forward(sieve, rows + i, out_scores + i);
    forward(sieve, rows + count - SIDE, out_scores + count - SIDE);
}

#if defined(__x86_64__)
/* The same operations, eight at a time; without FMA, so the same bits. */
__attribute__((target("avx2"), flatten)) static void
score_avx2(const dmi_sieve* sieve, const float (*rows)[DMI_EVIDENCE_COUNT], uint32_t count, float* out_scores) {
    score_rows(sieve, rows, count, out_scores);
}
#endif

static void score(const dmi_sieve* sieve, const float (*rows)[DMI_EVIDENCE_COUNT], uint32_t count, float* out_scores) {
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
    const float least = nth_largest(sorted, count, DMI_SIEVE_KEPT - 1);
    uint32_t above = 0, kept = 0;
    for (uint32_t i = 0; i < count; i++) above += scores[i] > least;
    uint32_t equals = DMI_SIEVE_KEPT - above;
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

uint32_t dmi_sieve_keep(const dmi_sieve* sieve, const dmi_study* study, const dmi_drag_hint* hint,
                        const dmi_kpp_net* net, dmi_isa isa, const dmi_opinion* opinion, dmi_candidate* candidates,
                        uint32_t count, float (*rows)[DMI_EVIDENCE_COUNT]) {
    if (count <= DMI_SIEVE_KEPT) return count;
    float scores[DMI_CANDIDATES_MAX];
    dmi_glance glance;
    dmi_glance_begin(study, hint, opinion != NULL ? &opinion->prediction : NULL, &glance);
    for (uint32_t i = 0; i < count; i++) dmi_glance_row(&glance, &candidates[i], rows[i]);
    if (opinion != NULL) dmi_opinion_glance(net, isa, opinion, candidates, count, scores);
    dmi_glance_choice(opinion != NULL ? scores : NULL, count, rows);
    score(sieve, (const float(*)[DMI_EVIDENCE_COUNT])rows, count, scores);
    return keep_best(scores, candidates, count);
}
