/* The kernels of NEON: its matrix product; all else is four lanes, which the compiler makes NEON of. */
#if defined(__aarch64__)
#define LANES 4
#define TARGET
#include "nn/layer_kernels.h"

const dmi_kernels dmi_kernels_neon = {
    dmi_gemm_neon, layer_norm, softmax, gate, modulate, max_rows, mean_rows,
};
#else
typedef int dmi_no_neon; /* ISO C asks for a declaration in every file */
#endif
