/* Declares the cases that the weights of asset hints are fitted on: generated objects with names and pivots as assets
 * have them. */
#ifndef DM_LAB_HINTS_H
#define DM_LAB_HINTS_H

#include "dragmesh_lab.h"

/* How often an object's parts come with what. */
typedef struct dm_lab_hint_options {
    float labels;   /* share of cases with a label */
    float pivots;   /* share of cases with a pivot */
    float lies;     /* share of labels that name another part, and of pivots anywhere in the object's box */
    float wrong_up; /* share of cases whose up direction is another */
} dm_lab_hint_options;

/* One entry a case, or `rows` of them. */
typedef struct dm_lab_hint_cases {
    uint32_t rows;
    float* probability; /* x rows: the ranker's, without hints */
    float* pose;        /* x rows: as dm_lab_ranker.pose */
    uint32_t* bits;     /* x rows: dmi_kind_features */
    float* pivot;       /* x rows x 8: dmi_pivot_features */
    int32_t* used;      /* rows filled */
    int32_t* kind;      /* dmi_part_kind; 0: none */
    int32_t* depth;
    int32_t* place; /* dmi_pivot_place; -1: no pivot */
    int32_t* has_drag;
    int32_t* category; /* id */
} dm_lab_hint_cases;

/* Returns the name of a kind (which 0), a kind feature (1), a pivot's place (2) or a pivot feature (3); NULL beyond the
 * last. */
DM_API const char* dm_lab_hint_name(int32_t which, uint32_t index);
DM_API dm_result dm_lab_hint_batch(const dm_lab_options* options, const dm_lab_hint_options* hints,
                                   const void* kinematics, size_t kinematics_size, const void* ranker,
                                   size_t ranker_size, const dm_lab_hint_cases* out);

#endif
