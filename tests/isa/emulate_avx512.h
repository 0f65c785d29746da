/* AVX-512's intrinsics on AVX2 by SIMDe, put in front of a kernel's source by avx512.sh. */
#include <immintrin.h>
#define SIMDE_ENABLE_NATIVE_ALIASES
#include <simde/x86/avx512.h>

/* The two that SIMDe 0.7.4 lacks. */
static inline __m512 emulated_maskz_loadu_ps(__mmask16 mask, const float* from) {
    float lanes[16];
    for (int i = 0; i < 16; i++) lanes[i] = mask >> i & 1 ? from[i] : 0;
    return _mm512_loadu_ps(lanes);
}

static inline void emulated_mask_storeu_ps(float* to, __mmask16 mask, __m512 value) {
    float lanes[16];
    _mm512_storeu_ps(lanes, value);
    for (int i = 0; i < 16; i++)
        if (mask >> i & 1) to[i] = lanes[i];
}
#define _mm512_maskz_loadu_ps emulated_maskz_loadu_ps
#define _mm512_mask_storeu_ps emulated_mask_storeu_ps

/* The kernels ask for AVX-512 in function attributes: the compiler must not use what the machine lacks. */
#define target(isa) unused
