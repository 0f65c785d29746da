/* Selects kernels by instruction set. Here are those of vectors of four lanes: for machines without a wider set, where
 * compilers split them, and for NEON, which has a matrix product of its own. */
#include <stdbool.h>

#define LANES 4
#define TARGET
#include "nn/layer_kernels.h"

const dmi_kernels dmi_kernels_scalar = {
    dmi_gemm_scalar, layer_norm, softmax, gate, modulate, max_rows, mean_rows,
};
#if defined(__aarch64__)
const dmi_kernels dmi_kernels_neon = {
    dmi_gemm_neon, layer_norm, softmax, gate, modulate, max_rows, mean_rows,
};
#endif

const dmi_kernels* dmi_kernels_for(dmi_isa isa) {
#if defined(__x86_64__)
    if (isa == DMI_ISA_AVX512) return &dmi_kernels_avx512;
    if (isa == DMI_ISA_AVX2) return &dmi_kernels_avx2;
#elif defined(__aarch64__)
    if (isa == DMI_ISA_NEON) return &dmi_kernels_neon;
#endif
    (void)isa;
    return &dmi_kernels_scalar;
}

bool dmi_kernels_usable(dmi_isa isa) {
    if (isa == DMI_ISA_SCALAR) return true;
    const dmi_isa best = dmi_cpu_best_isa();
    const bool offered = isa == best || (isa == DMI_ISA_AVX2 && best == DMI_ISA_AVX512);
    return offered && dmi_kernels_for(isa) != &dmi_kernels_scalar;
}
