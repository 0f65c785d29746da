/* The kernels of AVX2. AVX-512 differs only in the matrix product, which takes most of the time. */
#if defined(__x86_64__)
#include "base/compiler.h"

#define LANES 8
#define TARGET DMI_TARGET("avx2,fma")
#include "nn/layer_kernels.h"

const dmi_kernels dmi_kernels_avx2 = {
    dmi_gemm_avx2, layer_norm, softmax, gate, modulate, max_rows, mean_rows,
};
const dmi_kernels dmi_kernels_avx512 = {
    dmi_gemm_avx512, layer_norm, softmax, gate, modulate, max_rows, mean_rows,
};
#else
typedef int dmi_no_avx2; /* ISO C asks for a declaration in every file */
#endif
