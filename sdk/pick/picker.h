/* The backend of a context and what it keeps. */
#ifndef DMI_PICK_PICKER_H
#define DMI_PICK_PICKER_H

#include "pick/backend.h"
#include "pick/pick.h"

struct dmi_picker {
    dmi_env* env;
    const dmi_pick_backend* backend; /* NULL: this context picks nothing */
    void* device;
    int32_t choice;              /* DM_PICK_*, of the host */
    char why[DMI_PICK_WHY_SIZE]; /* it picks nothing */
};

#endif
