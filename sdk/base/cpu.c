/* Detects the instruction sets of the processor. */
#include "base/cpu.h"

#include <stdbool.h>

#include "base/compiler.h"

dmi_isa dmi_cpu_best_isa(void) {
#if defined(__x86_64__)
    /* The compiler's run time checks the processor and the operating system (saved registers). */
    const bool avx2 = DMI_CPU_HAS("avx2") && DMI_CPU_HAS("fma");
    const bool avx512 =
        DMI_CPU_HAS("avx512f") && DMI_CPU_HAS("avx512bw") && DMI_CPU_HAS("avx512dq") && DMI_CPU_HAS("avx512vl");
    if (avx2 && avx512) return DMI_ISA_AVX512;
    if (avx2) return DMI_ISA_AVX2;
    return DMI_ISA_SCALAR;
#elif defined(__aarch64__)
    return DMI_ISA_NEON; /* part of the architecture */
#else
    return DMI_ISA_SCALAR;
#endif
}

const char* dmi_isa_name(dmi_isa isa) {
    switch (isa) {
    case DMI_ISA_SCALAR:
        return "scalar";
    case DMI_ISA_AVX2:
        return "avx2";
    case DMI_ISA_AVX512:
        return "avx512";
    case DMI_ISA_NEON:
        return "neon";
    }
    return "unknown";
}
