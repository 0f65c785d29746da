/* Stands in for dmi_cpu_best_isa (linked with --wrap) where the scalar kernels are asked for. */
#include "base/cpu.h"

dmi_isa __wrap_dmi_cpu_best_isa(void);

dmi_isa __wrap_dmi_cpu_best_isa(void) {
    return DMI_ISA_SCALAR;
}
