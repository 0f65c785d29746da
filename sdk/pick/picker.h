/* The Embree device of a context: no thread of its own, errors to the log, memory counted. */
#ifndef DMI_PICK_PICKER_H
#define DMI_PICK_PICKER_H

#include "pick/embree.h"
#include "pick/pick.h"

struct dmi_picker {
    dmi_env* env;
    RTCDevice device;
    _Atomic uint32_t builders; /* threads inside dmi_picker_commit */
    uint32_t max_builders;
};

/* Builds what changed in the scene, on the calling thread. */
void dmi_picker_commit(dmi_picker* picker, RTCScene scene);
/* Returns the result of the calling thread's Embree calls since the last time; failures are already in the log. */
dm_result dmi_picker_status(const dmi_picker* picker);

#endif
