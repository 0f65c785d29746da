/* Fuzz target: mask files. Whatever the bytes, the parser answers with values or an error and leaks nothing. */
#include <stdlib.h>

#include "mesh/mask.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    int64_t* values = NULL;
    size_t count = 0;
    if (dmi_mask_parse(&env, data, size, &values, &count) == DM_OK) {
        uint8_t* ids = dmi_alloc(&env, count, 1);
        int32_t scope;
        int ambiguous;
        if (ids != NULL) {
            dm_result result = dmi_mask_to_part_ids(&env, values, count, NULL, count, 0, ids, &scope, &ambiguous);
            if (result != DM_OK) abort();
        }
        dmi_free(&env, ids, count);
        dmi_free(&env, values, count * sizeof *values);
    }
    if (env.bytes != 0) abort();
    return 0;
}
