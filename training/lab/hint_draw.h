/* Declares labels and pivots of generated parts, drawn as assets have them. */
#ifndef DM_LAB_HINT_DRAW_H
#define DM_LAB_HINT_DRAW_H

#include "case.h"
#include "kinematics/hints/hint_features.h"
#include "lab_hints.h"

/* Draws what the case's asset says of the part. The object must be in the generator's orientation
 * (dm_lab_options.rotated 0), whose up direction is +Y. part: index in the mesh. */
dmi_asset_hints lab_draw_hints(dmi_random* random, const lab_case* made, uint32_t part,
                               const dm_lab_hint_options* options);

#endif
