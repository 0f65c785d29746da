/* Declares the cases that the part finder is fitted on: neighbours of a growing region, and whether they belong to the
 * part; proposals of the part, and their overlap with it. */
#ifndef DM_LAB_GROWTH_H
#define DM_LAB_GROWTH_H

#include "dragmesh_lab.h"

typedef struct dm_lab_growth {
    uint32_t capacity;
    float* features;   /* x capacity x dm_lab_growth_columns() */
    float* belongs;    /* x capacity: 0 or 1 */
    float* weight;     /* x capacity: 1 over the number of neighbours at that step */
    int32_t* category; /* id */
    uint32_t* count;   /* rows written; the batch ends early when the next case might not fit */
} dm_lab_growth;

DM_API uint32_t dm_lab_growth_columns(void);
/* Grows the part of each case twice, from a random piece of its own, by random pieces that belong to it. */
DM_API dm_result dm_lab_growth_batch(const dm_lab_options* options, const dm_lab_growth* out);

typedef struct dm_lab_choice {
    float* features;   /* x count x dm_lab_choice_most() x dm_lab_choice_columns() */
    float* overlap;    /* x count x dm_lab_choice_most(): with the true part, intersection over union of areas */
    int32_t* used;     /* x count: proposals there were */
    int32_t* category; /* x count: id */
} dm_lab_choice;

DM_API uint32_t dm_lab_choice_columns(void);
/* Returns the column of dm_lab_choice.features that says whether the grabbed sheet was cut at its creases. */
DM_API uint32_t dm_lab_choice_cut_column(void);
DM_API uint32_t dm_lab_choice_most(void);
/* Writes the proposals that growing makes of options->count cases. weights: bytes of a file of architecture
 * dragmesh-part-finder, of which the growth network is read. */
DM_API dm_result dm_lab_choice_batch(const dm_lab_options* options, const void* weights, size_t weights_size,
                                     const dm_lab_choice* out);

#endif
