/* Which bodies move, once their joints are known. */
#ifndef DMI_ASSETS_ASSET_VERDICT_H
#define DMI_ASSETS_ASSET_VERDICT_H

#include "assets/asset_grouping.h"
#include "kinematics/object/object.h"

/* Sets the probabilities anew. object: of these bodies; body i is its part with the id i + 1. */
dm_result dmi_asset_judge(dmi_env* env, const dmi_asset_query* query, const dmi_object* object,
                          dmi_asset_bodies* inout_bodies);

#endif
