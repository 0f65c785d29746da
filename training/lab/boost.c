/* Gradient boosting of regression trees (Friedman 2001), with second derivatives (Chen and Guestrin 2016), histograms
 * and the best leaf first (Ke et al. 2017), on the cross entropy of each case's softmax
 * or of each row. */
#include "boost.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"

#define FLAT 1e-4f /* added to second derivatives: rows that are surely out still count a little */
#define LEAST_GAIN 1e-6
#define REPORT 50

/* First and second derivative of the loss by a row's score. */
typedef struct gradient {
    float first, second;
} gradient;

/* Sums of gradients over many rows. In double precision: a leaf's histogram is what is left of its parent's, millions
 * of rows before. */
typedef struct gradient_sum {
    double first, second;
} gradient_sum;

typedef struct leaf {
    uint32_t begin, end; /* of the order of rows */
    uint32_t node, depth;
    gradient_sum* histogram; /* columns x DM_LAB_BINS */
    double first, second;
    double gain; /* of its best split; 0: none */
    uint32_t column, bin;
    double left_first, left_second; /* of the split's left side */
} leaf;

typedef struct grower {
    const dm_lab_rows* rows;
    const dm_lab_boost_rule* rule;
    dmi_random random;
    uint32_t row_count;
    gradient* gradients;
    float* scores;
    uint32_t *order, *spare, *columns;
    uint32_t order_count, column_count, leaf_count, node_count;
    leaf* leaves;             /* one more than a tree has: its histogram is spare */
    gradient_sum* histograms; /* of all leaves */
} grower;

static size_t histogram_size(const grower* g) {
    return (size_t)g->rows->columns * DM_LAB_BINS;
}

static int open_grower(const dm_lab_rows* rows, const dm_lab_boost_rule* rule, grower* g) {
    *g = (grower){.rows = rows, .rule = rule, .random = dmi_random_make(rule->seed, 17)};
    g->row_count = rows->first[rows->cases];
    g->gradients = malloc(sizeof *g->gradients * g->row_count);
    g->scores = calloc(g->row_count, sizeof *g->scores);
    g->order = malloc(sizeof *g->order * g->row_count);
    g->spare = malloc(sizeof *g->spare * g->row_count);
    g->columns = malloc(sizeof *g->columns * rows->columns);
    g->leaves = calloc(rule->leaves + 1, sizeof *g->leaves);
    g->histograms = malloc(sizeof(gradient_sum) * histogram_size(g) * (rule->leaves + 1));
    if (g->scores && rows->scores) memcpy(g->scores, rows->scores, sizeof *g->scores * g->row_count);
    return g->gradients && g->scores && g->order && g->spare && g->columns && g->leaves && g->histograms;
}

static void close_grower(grower* g) {
    free(g->gradients), free(g->scores), free(g->order), free(g->spare);
    free(g->columns), free(g->leaves), free(g->histograms);
}

/* Computes the gradients of a case's rows; returns its cross entropy. */
static double differentiate_case(grower* g, uint32_t begin, uint32_t end) {
    const dm_lab_rows* rows = g->rows;
    float most = -INFINITY, sum = 0;
    double loss = 0;
    for (uint32_t i = begin; i < end; i++) most = fmaxf(most, g->scores[i] + rows->weights[i]);
    for (uint32_t i = begin; i < end; i++) sum += expf(g->scores[i] + rows->weights[i] - most);
    for (uint32_t i = begin; i < end; i++) {
        const float log_share = g->scores[i] + rows->weights[i] - most - logf(sum), share = expf(log_share);
        g->gradients[i] = (gradient){share - rows->target[i], share * (1 - share) + FLAT};
        loss -= (double)rows->target[i] * log_share;
    }
    return loss;
}

/* The same for rows that each have a probability of their own. */
static double differentiate_rows(grower* g, uint32_t begin, uint32_t end) {
    double loss = 0;
    for (uint32_t i = begin; i < end; i++) {
        const float share = 1 / (1 + expf(-g->scores[i])), target = g->rows->target[i];
        const float weight = expf(g->rows->weights[i]);
        g->gradients[i] = (gradient){weight * (share - target), weight * (share * (1 - share) + FLAT)};
        loss -= (double)(weight * (target * logf(share + FLAT) + (1 - target) * logf(1 - share + FLAT)));
    }
    return loss;
}

static double differentiate(grower* g) {
    double loss = 0;
    for (uint32_t c = 0; c < g->rows->cases; c++) {
        const uint32_t begin = g->rows->first[c], end = g->rows->first[c + 1];
        loss += g->rule->each_row ? differentiate_rows(g, begin, end) : differentiate_case(g, begin, end);
    }
    return loss / g->rows->cases;
}

/* Draws the cases and columns that the next tree uses. */
static void sample(grower* g) {
    g->order_count = g->column_count = 0;
    for (uint32_t c = 0; c < g->rows->columns; c++)
        if (dmi_random_unit(&g->random) < g->rule->column_share) g->columns[g->column_count++] = c;
    for (uint32_t c = 0; c < g->rows->cases; c++) {
        if (dmi_random_unit(&g->random) >= g->rule->case_share) continue;
        for (uint32_t i = g->rows->first[c]; i < g->rows->first[c + 1]; i++) g->order[g->order_count++] = i;
    }
}

static void fill_histogram(const grower* g, leaf* l) {
    memset(l->histogram, 0, sizeof(gradient_sum) * histogram_size(g));
    for (uint32_t i = l->begin; i < l->end; i++) {
        const uint8_t* bins = g->rows->bins + (size_t)g->order[i] * g->rows->columns;
        const gradient s = g->gradients[g->order[i]];
        for (uint32_t k = 0; k < g->column_count; k++) {
            gradient_sum* to = &l->histogram[g->columns[k] * DM_LAB_BINS + bins[g->columns[k]]];
            to->first += s.first, to->second += s.second;
        }
    }
}

/* Returns twice the loss that a leaf of these gradients removes. */
static double leaf_gain(const grower* g, double first, double second) {
    return first * first / (second + g->rule->damping);
}

static void try_column(const grower* g, uint32_t column, leaf* l) {
    const gradient_sum* h = l->histogram + (size_t)column * DM_LAB_BINS;
    const double whole = leaf_gain(g, l->first, l->second);
    double first = 0, second = 0;
    for (uint32_t b = 0; b + 1 < DM_LAB_BINS; b++) {
        first += h[b].first, second += h[b].second;
        if (second < g->rule->least) continue;
        if (l->second - second < g->rule->least) return;
        const double gain = leaf_gain(g, first, second) + leaf_gain(g, l->first - first, l->second - second) - whole;
        if (gain <= l->gain) continue;
        l->gain = gain, l->column = column, l->bin = b, l->left_first = first, l->left_second = second;
    }
}

static void find_split(const grower* g, leaf* l) {
    l->gain = LEAST_GAIN;
    if (l->depth < g->rule->depth)
        for (uint32_t k = 0; k < g->column_count; k++) try_column(g, g->columns[k], l);
    if (l->gain <= LEAST_GAIN) l->gain = 0;
}

/* Moves the rows of the left side first, each side in its order; returns where the right one begins. */
static uint32_t partition_rows(grower* g, const leaf* l) {
    uint32_t middle = l->begin, right = 0;
    for (uint32_t i = l->begin; i < l->end; i++) {
        const uint32_t row = g->order[i];
        if (g->rows->bins[(size_t)row * g->rows->columns + l->column] <= l->bin)
            g->order[middle++] = row;
        else
            g->spare[right++] = row;
    }
    memcpy(g->order + middle, g->spare, sizeof *g->spare * right);
    return middle;
}

/* Computes the histograms of both sides: sums the smaller one's rows, subtracts it from the parent's for the other. */
static void share_histogram(const grower* g, leaf* left, leaf* right) {
    leaf* spare = &g->leaves[g->rule->leaves];
    gradient_sum* parent = left->histogram;
    leaf* small = right->end - right->begin < left->end - left->begin ? right : left;
    if (small == left) {
        left->histogram = spare->histogram, spare->histogram = right->histogram, right->histogram = parent;
    }
    fill_histogram(g, small);
    for (size_t i = 0; i < histogram_size(g); i++) {
        parent[i].first -= small->histogram[i].first;
        parent[i].second -= small->histogram[i].second;
    }
}

/* Splits the leaf; its left side takes its place in the list. */
static void split_leaf(grower* g, leaf* l, const dm_lab_trees* out) {
    leaf* right = &g->leaves[g->leaf_count++];
    const uint32_t middle = partition_rows(g, l), node = l->node;
    out->column[node] = (int32_t)l->column, out->bin[node] = (int32_t)l->bin;
    out->left[node] = (int32_t)g->node_count;
    right->begin = middle, right->end = l->end, right->depth = l->depth + 1, right->node = g->node_count + 1;
    right->first = l->first - l->left_first, right->second = l->second - l->left_second;
    l->end = middle, l->depth++, l->node = g->node_count;
    l->first = l->left_first, l->second = l->left_second;
    g->node_count += 2;
    share_histogram(g, l, right);
    find_split(g, l);
    find_split(g, right);
}

static leaf* best_leaf(const grower* g) {
    leaf* best = NULL;
    for (uint32_t i = 0; i < g->leaf_count; i++)
        if (g->leaves[i].gain > (best != NULL ? best->gain : 0)) best = &g->leaves[i];
    return best;
}

static void begin_tree(grower* g, const dm_lab_trees* out) {
    for (uint32_t n = 0; n < 2 * g->rule->leaves - 1; n++)
        out->column[n] = -1, out->bin[n] = out->left[n] = 0, out->score[n] = 0;
    for (uint32_t i = 0; i <= g->rule->leaves; i++) g->leaves[i].histogram = g->histograms + i * histogram_size(g);
    leaf* root = &g->leaves[0];
    *root = (leaf){.end = g->order_count, .histogram = root->histogram};
    for (uint32_t i = 0; i < g->order_count; i++)
        root->first += g->gradients[g->order[i]].first, root->second += g->gradients[g->order[i]].second;
    g->leaf_count = g->node_count = 1;
    fill_histogram(g, root);
    find_split(g, root);
}

/* Adds the tree to every row's score. */
static void add_scores(grower* g, const dm_lab_trees* tree) {
    for (uint32_t i = 0; i < g->row_count; i++) {
        const uint8_t* bins = g->rows->bins + (size_t)i * g->rows->columns;
        int32_t n = 0;
        while (tree->column[n] >= 0) n = tree->left[n] + (bins[tree->column[n]] > tree->bin[n]);
        g->scores[i] += tree->score[n];
    }
}

static void grow_tree(grower* g, const dm_lab_trees* out) {
    sample(g);
    begin_tree(g, out);
    while (g->leaf_count < g->rule->leaves) {
        leaf* l = best_leaf(g);
        if (l == NULL) break;
        split_leaf(g, l, out);
    }
    for (uint32_t i = 0; i < g->leaf_count; i++) {
        const leaf* l = &g->leaves[i];
        out->score[l->node] = (float)(-g->rule->rate * l->first / (l->second + g->rule->damping));
    }
    add_scores(g, out);
}

dm_result dm_lab_boost(const dm_lab_rows* rows, const dm_lab_boost_rule* rule, void (*report)(uint32_t, double),
                       const dm_lab_trees* out) {
    if (rows->cases == 0 || rule->leaves < 2) return DM_ERROR_INVALID_ARGUMENT;
    grower g;
    const int open = open_grower(rows, rule, &g);
    for (uint32_t t = 0; open && t < rule->trees; t++) {
        const size_t first = (size_t)t * (2 * rule->leaves - 1);
        const dm_lab_trees tree = {out->column + first, out->bin + first, out->left + first, out->score + first};
        const double loss = differentiate(&g);
        if (report != NULL && t % REPORT == 0) report(t, loss);
        grow_tree(&g, &tree);
    }
    close_grower(&g);
    return open ? DM_OK : DM_ERROR_OUT_OF_MEMORY;
}
