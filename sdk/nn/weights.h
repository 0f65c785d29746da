/* Reader of safetensors files; every size and offset is checked before use. */
#ifndef DMI_NN_WEIGHTS_H
#define DMI_NN_WEIGHTS_H

#include <stdbool.h>

#include "base/env.h"

typedef struct dmi_weights dmi_weights;

/* Opens a file. Copies only the header: `data` must outlive the result. __metadata__ must say "architecture":
 * `architecture` (else DM_ERROR_WRONG_MODEL) and "version" <= max_version (else DM_ERROR_VERSION). float32 and float16
 * tensors only.
 */
dm_result dmi_weights_open(dmi_env* env, const void* data, size_t size, const char* architecture, int max_version,
                           dmi_weights** out_weights);
void dmi_weights_close(dmi_weights* weights);
/* Copies the tensor of exactly this shape (cols 0: one dimension of `rows`), float16 widened to float; out_finite,
 * if not NULL: whether all its numbers are. Returns false, and logs a line, when it is not there. */
bool dmi_weights_read(const dmi_weights* weights, const char* name, uint32_t rows, uint32_t cols, float* out,
                      bool* out_finite);
/* Returns a metadata value; NULL when the key is absent. */
const char* dmi_weights_metadata(const dmi_weights* weights, const char* key);

#endif
