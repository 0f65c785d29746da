/* Metrics of `dragmesh eval`: errors of an answered joint against the true one (docs/accuracy.md).
 * Lengths are over the object's largest side. */
#ifndef CLI_METRICS_H
#define CLI_METRICS_H

#include "dataset.h"

enum metric {
    METRIC_TYPE,       /* 1: right (a continuous joint is a revolute one) */
    METRIC_AXIS,       /* unsigned angle between the axes, mrad */
    METRIC_ORIGIN,     /* true axis to the point of the found axis nearest the part's centre, x 1000; turning joints */
    METRIC_ORIGIN_L1,  /* the paper's: mean |difference| of a coordinate of the two origins, x 1000; turning joints */
    METRIC_LINE,       /* shortest distance of the two axes, x 1000; turning joints */
    METRIC_POSE,       /* mean distance of the moved part's vertices from where they should be, the dragged point having
                          gone its true way (full travel, at most 1.2 rad) */
    METRIC_POSE_TOP3,  /* the least of the first three hypotheses */
    METRIC_SIGN,       /* 1: a positive step goes along the drag */
    METRIC_RANGE,      /* intersection over union of the ranges; only where the type is right and limits are known */
    METRIC_MASK,       /* of a part that was found: intersection over union with the true one, by area */
    METRIC_MASK_FOUND, /* 1: that is 0.8 or more */
    METRIC_CONFIDENCE, /* the stated probability that the answer is right */
    METRIC_CHAMFER,    /* of the generated motion: two-way squared Chamfer distance, mean over the frames */
    METRIC_CONSTRAINT, /* 2 (1 - |cos|) + sin^2 / 2 to the true axis (turning); |t x a|^2 (sliding) */
    METRIC_SLIDE_TURN, /* QR1: mean squared rotation angle of sliding joints */
    METRIC_TURN_SLIDE, /* Rev. Trans.: mean squared translation of turning joints about the joint's origin */
    METRIC_COUNT
};

typedef struct metric_row {
    double value[METRIC_COUNT]; /* NAN: does not apply */
    double weight;
    bool slides, answered;
    const char* source;
    char category[64], id[256], found_type[16];
} metric_row;

/* What a row is measured on. */
typedef struct metric_case {
    const known_joint* truth;
    const known_drag* drag; /* the true one, without drag noise */
    const vec* moving;      /* vertices of the part at rest */
    size_t moving_count;
    double size;  /* largest side of the whole object's box */
    bool dragged; /* the drag was shown to the library */
} metric_case;

void metrics_of_failure(const metric_case* known, metric_row* out_row);
void metrics_of_joint(const metric_case* known, const joint_answer* answer, metric_row* out_row);

/* An answer is right when the part ends within this share of the size from where it should. */
#define METRICS_RIGHT 0.02

/* The value that brings the dragged point of the answered joint nearest to where it should be at full travel. */
double metrics_answered_travel(const metric_case* known, const dm_joint* joint);
/* The joint value of the metrics' full travel, signed along the true axis so that it follows the drag. */
double metrics_travel(const metric_case* known);
/* Where the true joint at `value` takes a point. */
vec metrics_true_move(const metric_case* known, vec point, double value);
/* Frames of a motion that was asked to follow the true way; truth goes at minimum-jerk pace. */
void metrics_of_motion(const metric_case* known, const dm_joint* joint, const dm_pose poses[DM_MOTION_FRAMES],
                       metric_row* out_row);

/* Weighted statistics of one metric over the rows that `pick` (a row of ones and zeros; NULL: all) selects. */
typedef struct metric_stat {
    size_t count;
    double mean, median, p90;
} metric_stat;
metric_stat metrics_stat(const metric_row* rows, size_t count, const unsigned char* pick, enum metric metric);
/* Weighted share of the rows whose metric is below `limit`; NAN when none has it. */
double metrics_share_below(const metric_row* rows, size_t count, const unsigned char* pick, enum metric metric,
                           double limit);

/* Answers by their stated confidence, in even bins, and how many of each bin are right. */
#define METRICS_BINS 10
typedef struct metric_calibration {
    double weight[METRICS_BINS], stated[METRICS_BINS], right[METRICS_BINS]; /* share of all; means, NAN when empty */
    double error; /* expected |stated - right|; NAN when nothing was stated */
} metric_calibration;
metric_calibration metrics_calibrate(const metric_row* rows, size_t count, const unsigned char* pick);

#endif
