/* Selects kernels by instruction set. */
#include "nn/kernels.h"

#include <stdbool.h>

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
