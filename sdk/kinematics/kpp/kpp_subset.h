/* The subset of a cloud's points that one input of KPP-Net is made from. */
#ifndef DMI_KPP_KPP_SUBSET_H
#define DMI_KPP_KPP_SUBSET_H

#include "mesh/cloud.h"

#define DMI_KPP_SUBSETS 4 /* disjoint subsets of a cloud */
/* Points of the subset's blocks (docs/networks.md). */
#define DMI_KPP_PART_POINTS 512
#define DMI_KPP_NEAR_POINTS 256
#define DMI_KPP_BODY_POINTS 256
#define DMI_KPP_POINTS (DMI_KPP_PART_POINTS + DMI_KPP_NEAR_POINTS + DMI_KPP_BODY_POINTS)

typedef struct dmi_kpp_subset {
    const float (*part)[3], (*near)[3], (*body)[3];
    const float (*part_normals)[3], (*near_normals)[3], (*body_normals)[3];
} dmi_kpp_subset;

static inline dmi_kpp_subset dmi_kpp_subset_of(const dmi_cloud* cloud, uint32_t index) {
    const float(*xyz)[3] = (const float(*)[3])cloud->xyz, (*normal)[3] = (const float(*)[3])cloud->normal;
    const uint32_t part = index * DMI_KPP_PART_POINTS, near = DMI_CLOUD_PART + index * DMI_KPP_NEAR_POINTS;
    const uint32_t body = DMI_CLOUD_PART + DMI_CLOUD_NEAR + index * DMI_KPP_BODY_POINTS;
    return (dmi_kpp_subset){xyz + part, xyz + near, xyz + body, normal + part, normal + near, normal + body};
}

#endif
