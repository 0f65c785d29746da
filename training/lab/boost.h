/* Grows the boosted trees that sdk/kinematics/ranking/boosted_trees.c scores candidates by. */
#ifndef DM_LAB_BOOST_H
#define DM_LAB_BOOST_H

#include "dragmesh_lab.h"

/* Rows of many cases. Those of a case share one probability, the softmax of score + weight, or each has its own: the
 * logistic function of its score (dm_lab_boost_rule.each_row). */
typedef struct dm_lab_rows {
    uint32_t columns, cases;
    const uint32_t* first; /* cases + 1: a case's rows are first[i]..first[i + 1] - 1 */
    const uint8_t* bins;   /* x columns: into which of its column's DM_LAB_BINS a number falls */
    const float* weights;  /* logarithms: for how many rows a row stands */
    const float* target;   /* probabilities; those of a case sum to 1, unless each row has its own */
    const float* scores;   /* that the trees correct; NULL: 0 */
} dm_lab_rows;

#define DM_LAB_BINS 64

typedef struct dm_lab_boost_rule {
    uint32_t trees, leaves, depth;  /* leaves of a tree and splits down to them: at most */
    float rate;                     /* learning rate (shrinkage): a leaf's score is multiplied by it */
    float damping;                  /* L2 regularisation, added to a leaf's sum of second derivatives */
    float least;                    /* sum of second derivatives in a leaf: at least */
    float case_share, column_share; /* subsampled anew for every tree */
    uint64_t seed;
    uint32_t each_row; /* 1: a row's probability is its own */
} dm_lab_boost_rule;

/* One a node, 2 leaves - 1 a tree; nodes that a tree does not need are leaves of score 0. */
typedef struct dm_lab_trees {
    int32_t* column; /* -1: a leaf */
    int32_t* bin;    /* goes left where the column's is at most this */
    int32_t* left;   /* right: the one after */
    float* score;    /* of leaves */
} dm_lab_trees;

/* report: called before every 50th tree with the mean cross entropy so far; may be NULL. */
DM_API dm_result dm_lab_boost(const dm_lab_rows* rows, const dm_lab_boost_rule* rule, void (*report)(uint32_t, double),
                              const dm_lab_trees* out);

#endif
