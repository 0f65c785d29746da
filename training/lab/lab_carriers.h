/* Declares the cases that the carriers of an asset's bodies are fitted on: a body of a generated asset, and all that
 * may carry it. */
#ifndef DM_LAB_CARRIERS_H
#define DM_LAB_CARRIERS_H

#include "dragmesh_lab.h"

/* What a case's body hangs on. */
enum {
    DM_LAB_CARRIED_BY_BODY = 0,  /* what stays */
    DM_LAB_CARRIED_BY_PART = 1,  /* a part that is among the bodies */
    DM_LAB_CARRIED_BY_OTHERS = 2 /* a part that is not; target is what has most of that part */
};

typedef struct dm_lab_carrier_rows {
    uint32_t capacity, case_capacity; /* a call that would need more answers TOO_LARGE */
    float* features;                  /* x capacity x dm_lab_carrier_columns(): of a body and what may carry it */
    float* target;                    /* x capacity: 1: it carries it */
    uint32_t* first;                  /* x case_capacity + 1: case i has the rows first[i] .. first[i + 1] - 1 */
    uint32_t* carried;                /* x case_capacity: DM_LAB_CARRIED_* */
    uint32_t* asset;                  /* x case_capacity: index of the asset that the body is of */
    uint32_t case_count;              /* out */
    uint32_t missed;                  /* out: bodies whose carrier is no candidate; they make no case */
} dm_lab_carrier_rows;

DM_API uint32_t dm_lab_carrier_columns(void);
/* options: as of dm_lab_asset_sets. weights: bytes of a file of architecture dragmesh-asset-parts, whose trees find the
 * bodies; NULL: the bodies are the true ones. */
DM_API dm_result dm_lab_carriers(const dm_lab_options* options, const void* weights, size_t weights_size,
                                 dm_lab_carrier_rows* inout_rows);

#endif
