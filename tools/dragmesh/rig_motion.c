/* How the parts of an asset open, all at once. */
#include <stdlib.h>

#include "constants.h"
#include "play.h"
#include "rig.h"
#include "vec.h"

#define FAR_SHARE 0.5 /* of the part's size, that one without limits slides; by hand */

/* Returns the value at which a part counts as open: at its limit; without one, a quarter turn or half its size on. */
static float open_value(const rig_part* part) {
    const bool limited = part->joint.type != DM_JOINT_CONTINUOUS && part->joint.lower < part->joint.upper;
    if (limited) return play_target(&part->joint);
    if (part->joint.type != DM_JOINT_PRISMATIC) return (float)(TWO_PI / 4);
    return (float)(FAR_SHARE * length(sub(vec_of(part->part.box_max), vec_of(part->part.box_min))));
}

dm_result rig_pose(const rig* rig, float share, dm_pose* out_poses) {
    const dm_pose rest = {.real = {0, 0, 0, 1}};
    const uint32_t count = rig->info.part_count;
    dm_pose* own = cli_alloc(count * sizeof *own);
    dm_result result = DM_OK;
    out_poses[0] = rest;
    for (uint32_t i = 0; i < count && result == DM_OK; i++) {
        const rig_part* part = &rig->parts[i];
        own[i] = rest;
        if (part->part.part_id != 0)
            result = dm_joint_pose(&part->joint, open_value(part) * minimum_jerk(share), &own[i]);
    }
    for (uint32_t i = 0; i < count && result == DM_OK; i++) {
        out_poses[i + 1] = own[i];
        for (uint32_t above = rig->parts[i].part.parent; above != DM_ASSET_NO_PART;
             above = rig->parts[above].part.parent)
            dm_pose_multiply(&own[above], &out_poses[i + 1], &out_poses[i + 1]);
    }
    free(own);
    return result;
}
