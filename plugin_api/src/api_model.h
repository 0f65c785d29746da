/* Model handles for other parts of the boundary. */
#ifndef DMI_API_MODEL_H
#define DMI_API_MODEL_H

#include "api_handles.h"

/* Returns what inference uses of a model. model: NULL for geometry and rules alone. */
dmi_inference_models dmi_inference_models_of(const dm_context* context, const dmi_model_slot* model);

/* Frees a model that has been removed from its pool. */
void dmi_model_release(dm_context* context, dmi_model_slot* slot);

#endif
