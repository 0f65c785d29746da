/* Which instruction sets this processor (and its operating system) offers. */
#ifndef DMI_BASE_CPU_H
#define DMI_BASE_CPU_H

#include <stdbool.h>

typedef enum dmi_isa { DMI_ISA_SCALAR = 0, DMI_ISA_AVX2 = 1, DMI_ISA_AVX512 = 2, DMI_ISA_NEON = 3 } dmi_isa;

/* Returns the best set of the machine; AVX2 includes FMA, AVX512 means F+BW+DQ+VL. */
dmi_isa dmi_cpu_best_isa(void);
/* Whether code for AVX2 and FMA runs where `isa` is chosen. */
static inline bool dmi_isa_has_avx2(dmi_isa isa) {
    return isa == DMI_ISA_AVX2 || isa == DMI_ISA_AVX512;
}
const char* dmi_isa_name(dmi_isa isa);

#endif
