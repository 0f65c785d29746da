/* Bodies that nothing but their weight holds: the lids of pots and jars, corks. */
#ifndef DMI_ASSETS_FREE_BODIES_H
#define DMI_ASSETS_FREE_BODIES_H

#include "kinematics/object/object.h"

/* What the names of an asset call it. */
typedef struct dmi_asset_named {
    bool vessel; /* a pot, a jar, a bottle */
    bool other;  /* another object, such as a bin, whose lid hinges */
} dmi_asset_named;

/* Returns whether part `index` of an object, its joint inferred, rests in the rim of what is below it. */
bool dmi_body_is_free(const dmi_object* object, uint32_t index, dmi_asset_named named);

/* Puts the way by which a free part comes off, up, before its other hypotheses. */
void dmi_body_set_free(dmi_object* object, uint32_t index);

#endif
