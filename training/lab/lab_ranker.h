/* Declares the cases that the candidate ranker is trained on: features of candidates, and their errors. */
#ifndef DM_LAB_RANKER_H
#define DM_LAB_RANKER_H

#include "dragmesh_lab.h"

/* `count` cases of `rows` candidates each; a case with more candidates keeps its best eight and a random choice of the
 * rest. */
typedef struct dm_lab_ranker {
    uint32_t rows;
    float* features; /* x rows x dm_lab_ranker_columns() */
    float* pose;    /* x rows: mean distance of the moved part from where it should be, over the object's size, when the
                      dragged point has gone its true way */
    int32_t* used;  /* rows filled, from the first on */
    int32_t* total; /* candidates there were; rows from the ninth on stand for total - 8 of them */
    int32_t* type;  /* of the true joint: 0 revolute, 1 prismatic, 2 screw, 3 continuous */
    int32_t* has_drag;
    int32_t* category; /* id */
    float* best;       /* least pose of all candidates */
    float* axis_error; /* x rows: rad */
    float* line_error; /* x rows: distance of the axis from the true one at the part's centre; 0 for slides */
} dm_lab_ranker;

DM_API uint32_t dm_lab_ranker_columns(void);
/* Writes the columns of the cheap features, which the prefilter reads, in order, and returns how many there are. out
 * NULL: only the number. */
DM_API uint32_t dm_lab_prefilter_columns(uint8_t* out);
/* options: as for KPP-Net. kinematics: bytes of a KPP-Net weights file whose predictions go into the features; NULL:
 * none. prefilter: bytes of a file of the prefilter's weights, architecture dragmesh-prefilter; NULL: all candidates
 * are kept. */
DM_API dm_result dm_lab_ranker_batch(const dm_lab_options* options, const void* kinematics, size_t kinematics_size,
                                     const void* prefilter, size_t prefilter_size, const dm_lab_ranker* out);

/* Writes the logarithm of the probability that a ranker gives each row among those of its case. ranker: bytes of a file
 * of joint models. first: cases + 1, as in dm_lab_rows. features: x dm_lab_ranker_columns(); all rows of a case have a
 * drag, or none has. */
DM_API dm_result dm_lab_ranker_log_shares(const void* ranker, size_t ranker_size, uint32_t cases, const uint32_t* first,
                                          const float* features, float* out);

/* A case that a loader provides, in the glTF frame and the object's own unit. */
typedef struct dm_lab_given {
    const float* positions;    /* vertex_count x 3 */
    const uint32_t* indices;   /* face_count x 3 */
    const uint32_t* face_part; /* 0 the body, 1 the part */
    uint32_t vertex_count, face_count;
    int32_t type; /* DM_JOINT_* */
    float axis[3], origin[3], lower, upper;
    float drag_point[3], drag_vector[3];
} dm_lab_given;

/* Writes one case, not prefiltered, into the first place of `out`. with_drag 0: candidates are made without the drag,
 * labels with it. */
DM_API dm_result dm_lab_ranker_given(const dm_lab_given* given, int32_t with_drag, const void* kinematics,
                                     size_t kinematics_size, const dm_lab_ranker* out);

#endif
