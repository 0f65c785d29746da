/* Stands in for dmi_cpu_best_isa (linked with --wrap) where AVX-512 is emulated. */
#include "base/cpu.h"

dmi_isa __wrap_dmi_cpu_best_isa(void);

dmi_isa __wrap_dmi_cpu_best_isa(void) {
    return DMI_ISA_AVX512;
}
