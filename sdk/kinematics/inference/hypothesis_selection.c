/* Non-maximum suppression over the leading candidates, by how differently they move the part. */
#include "kinematics/inference/hypothesis_selection.h"

#include "kinematics/candidates/twist.h"
#include "math/elementary.h"
#include "math/linear3.h"

#define TOP_OF_TYPE DMI_CONSENSUS_MAX /* leading turns, and leading slides, that may become hypotheses; by hand */
#define TOP (2 * TOP_OF_TYPE)
/* Differences of two twists (dmi_twist_difference). Up to NEAR, an answer counts as right. Up to ALIKE, candidates add
 * to the probability of one hypothesis. Beyond APART, candidates become separate hypotheses. Fitted on generated
 * objects. */
#define NEAR 0.03f
#define ALIKE 0.1f
#define APART 0.3f
/* Object sizes between two opened parts (dmi_opened_part_difference) that count as nearly the same; a right answer is
 * within 0.02. Measured: 0.01 to 0.03 are alike on generated objects. */
#define NEAR_OPENED 0.015f
#define NEARLY_AS_HEAVY 0.9f /* share of the heaviest candidate's weight; by hand */
#define HEAVIER 1.0001f      /* ratio: rounding does not decide between equal weights; by hand */

#define ANY_TYPE (-1)

typedef struct leading {
    uint32_t index; /* index of the candidate */
    float weight;   /* probability that it is near enough, whichever candidate is right */
} leading;

typedef struct selection {
    const dmi_ranked_candidates* ranked;
    leading top[TOP];
    float difference[TOP][TOP];
    bool taken[TOP];
    uint32_t count;
    float type_mass[2]; /* probabilities of all turns, and of all slides */
} selection;

static int slides(const selection* s, uint32_t index) {
    return s->ranked->candidates[index].type == DM_JOINT_PRISMATIC;
}

static float probability(const selection* s, uint32_t leading_index) {
    return s->ranked->probability[s->top[leading_index].index];
}

/* Writes the most probable candidates of one type, most probable first. Returns how many. */
static uint32_t top_of_type(const selection* s, int type, leading out[TOP_OF_TYPE]) {
    const float* p = s->ranked->probability;
    uint32_t n = 0;
    for (uint32_t i = 0; i < s->ranked->count; i++) {
        if (slides(s, i) != type || (n == TOP_OF_TYPE && p[i] <= p[out[n - 1].index])) continue;
        uint32_t at = n < TOP_OF_TYPE ? n++ : TOP_OF_TYPE - 1;
        for (; at > 0 && p[out[at - 1].index] < p[i]; at--) out[at] = out[at - 1];
        out[at].index = i;
    }
    return n;
}

static void weigh_by_motion(selection* s) {
    dmi_twist twist[TOP];
    for (uint32_t i = 0; i < s->count; i++)
        dmi_twist_of_candidate(s->ranked->analysis, &s->ranked->candidates[s->top[i].index], &twist[i]);
    for (uint32_t i = 0; i < s->count; i++) {
        s->top[i].weight = 0;
        for (uint32_t j = 0; j < s->count; j++) {
            const float off = s->difference[i][j] = i == j ? 0 : dmi_twist_difference(&twist[i], &twist[j]);
            s->top[i].weight += probability(s, j) * dmi_expf(-off * off / (NEAR * NEAR));
        }
    }
}

/* Weighs the candidates by where the opened parts end, turns and slides alike. */
static void weigh_by_pose(selection* s) {
    dmi_opened_part opened[TOP];
    for (uint32_t i = 0; i < s->count; i++)
        dmi_opened_part_make(s->ranked->analysis, &s->ranked->candidates[s->top[i].index], &opened[i]);
    for (uint32_t i = 0; i < s->count; i++) s->top[i].weight = probability(s, i);
    for (uint32_t i = 0; i < s->count; i++) {
        for (uint32_t j = 0; j < i; j++) {
            const float off = dmi_opened_part_difference(&opened[i], &opened[j]) / NEAR_OPENED;
            const float share = dmi_expf(-off * off);
            s->top[i].weight += share * probability(s, j);
            s->top[j].weight += share * probability(s, i);
        }
    }
}

static void begin_selection(const dmi_ranked_candidates* ranked, dmi_selection_rule rule, selection* s) {
    *s = (selection){.ranked = ranked};
    for (uint32_t i = 0; i < ranked->count; i++) s->type_mass[slides(s, i)] += ranked->probability[i];
    s->count = top_of_type(s, 0, s->top);
    s->count += top_of_type(s, 1, s->top + s->count);
    weigh_by_motion(s);
    if (rule == DMI_SELECT_BY_POSE) weigh_by_pose(s);
}

/* Returns the heaviest candidate left, or s->count when none is. only: ANY_TYPE, or 0 for turns and 1 for slides. */
static uint32_t heaviest(const selection* s, int only) {
    uint32_t best = s->count;
    for (uint32_t i = 0; i < s->count; i++) {
        if (s->taken[i] || (only != ANY_TYPE && slides(s, s->top[i].index) != only)) continue;
        if (best == s->count || s->top[i].weight > s->top[best].weight * HEAVIER) best = i;
    }
    return best;
}

/* Returns the most probable candidate among those near the best whose weight is nearly the same. The weight is smooth
 * over near candidates; the probability singles out the one that lies exactly on a line of the geometry. */
static uint32_t most_probable_near(const selection* s, uint32_t best) {
    uint32_t chosen = best;
    for (uint32_t i = 0; i < s->count; i++) {
        if (s->taken[i] || s->difference[best][i] > NEAR || s->top[i].weight < NEARLY_AS_HEAVY * s->top[best].weight)
            continue;
        if (probability(s, i) > probability(s, chosen)) chosen = i;
    }
    return chosen;
}

/* Removes a candidate and all within APART of it from the selection. Returns the probability of those within ALIKE. */
static float suppress_alike(selection* s, uint32_t chosen) {
    float mass = 0;
    for (uint32_t i = 0; i < s->count; i++) {
        if (s->taken[i] || s->difference[chosen][i] > APART) continue;
        if (s->difference[chosen][i] <= ALIKE) mass += probability(s, i);
        s->taken[i] = true;
    }
    return mass;
}

static void write_support(const selection* s, uint32_t chosen, dmi_selected* out) {
    out->support_count = 0;
    for (uint32_t i = 0; i < s->count; i++) {
        const dmi_candidate* candidate = &s->ranked->candidates[s->top[i].index];
        const float off = s->difference[chosen][i] / ALIKE;
        if (!dmi_consensus_counts(out->candidate, candidate)) continue;
        out->support[out->support_count++] =
            (dmi_weighted_candidate){candidate, probability(s, i) * dmi_expf(-off * off)};
    }
}

uint32_t dmi_select_hypotheses(const dmi_ranked_candidates* ranked, dmi_selection_rule rule,
                               dmi_selected out[DM_MAX_HYPOTHESES]) {
    selection s;
    begin_selection(ranked, rule, &s);
    uint32_t count = 0;
    float least = 1; /* no hypothesis is stated likelier than the one before it */
    while (count < DM_MAX_HYPOTHESES) {
        const int only =
            count == 0 && rule == DMI_SELECT_LIKELIER_TYPE_FIRST ? s.type_mass[1] > s.type_mass[0] : ANY_TYPE;
        uint32_t best = heaviest(&s, only);
        if (best == s.count) break;
        best = most_probable_near(&s, best);
        dmi_selected* one = &out[count++];
        one->index = s.top[best].index;
        one->candidate = &ranked->candidates[one->index];
        one->mass = least = dmi_min(least, suppress_alike(&s, best));
        one->type_mass = s.type_mass[slides(&s, one->index)];
        write_support(&s, best, one);
    }
    return count;
}
