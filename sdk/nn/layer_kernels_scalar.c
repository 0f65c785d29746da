/* The kernels of machines without a wider set: vectors of four lanes, which compilers split where necessary. */
#define LANES 4
#define TARGET
#include "nn/layer_kernels.h"

const dmi_kernels dmi_kernels_scalar = {
    dmi_gemm_scalar, layer_norm, softmax, gate, modulate, max_rows, mean_rows,
};
