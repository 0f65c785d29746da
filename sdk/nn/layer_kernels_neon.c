/* The kernels of NEON: its own matrix product; the rest is vectors of four lanes, which compile to NEON. */
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
