/* Fuzz target: weights. Whatever the bytes, reading and loading answer with a network or an error and leak nothing. */
#include <stdlib.h>

#include "kinematics/kpp/kpp_net.h"
#include "motion/dq_vae.h"
#include "nn/weights.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    dmi_env env;
    dmi_env_init(&env, NULL, NULL, NULL);
    dmi_weights* weights = NULL;
    dmi_kpp_net* net = NULL;
    dmi_dq_vae* vae = NULL;
    if (dmi_weights_open(&env, data, size, "net", 1, &weights) == DM_OK) {
        float numbers[6];
        (void)dmi_weights_read(weights, "m", 2, 3, numbers, NULL);
        dmi_weights_close(weights);
    }
    if (dmi_kpp_net_load(&env, data, size, &net) == DM_OK) dmi_kpp_net_destroy(net);
    if (dmi_dq_vae_load(&env, data, size, &vae) == DM_OK) dmi_dq_vae_destroy(vae);
    if (env.bytes != 0) abort();
    return 0;
}
