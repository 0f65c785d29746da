/* Whether the processor has what the encoder is written for. */
#include "encoder.h"

#if defined(__x86_64__) && defined(__linux__)
#include <cpuid.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "base/cpu.h"
#include "encoder_tiles.h"

enum { ARCH_REQ_XCOMP_PERM = 0x1023, TILE_DATA = 18 }; /* of Linux: a process asks before it uses tiles */

int lab_encoder_has_tiles;

int dm_lab_encoder_available(void) {
    unsigned a, b, c, d, more;
    if (dmi_cpu_best_isa() != DMI_ISA_AVX512 || !__get_cpuid_count(7, 0, &a, &b, &c, &d)) return 0;
    if (!__get_cpuid_count(7, 1, &more, &b, &c, &a)) return 0;
    const int tiles = d >> 24 & 1, tiles_of_bf16 = d >> 22 & 1, registers_of_bf16 = more >> 5 & 1;
    lab_encoder_has_tiles = tiles && tiles_of_bf16 && syscall(SYS_arch_prctl, ARCH_REQ_XCOMP_PERM, TILE_DATA) == 0;
    return registers_of_bf16;
}

#else
int dm_lab_encoder_available(void) {
    return 0;
}
#endif
