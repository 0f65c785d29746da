/* What gcc and clang (clang-cl and mingw too) offer beyond ISO C: the one place of the library that names it. Other
 * compilers get the last branch; docs/platforms.md says what Microsoft's cl lacks beyond it. */
#ifndef DMI_BASE_COMPILER_H
#define DMI_BASE_COMPILER_H

#include <stdint.h>

#if defined(__GNUC__) || defined(__clang__)

/* Stands before `static inline`: the function is inlined although it is called often. */
#define DMI_ALWAYS_INLINE __attribute__((always_inline))
/* Asks for the line of the cache at an address, which need not be readable. */
#define DMI_PREFETCH(address) __builtin_prefetch(address)
#define DMI_NO_INLINE __attribute__((noinline))
/* All calls in the function's body are inlined, so that they get its instruction set. */
#define DMI_FLATTEN __attribute__((flatten))
/* Compiles a function for instruction sets beyond the machine's least, such as "avx2,fma". */
#define DMI_TARGET(sets) __attribute__((target(sets)))
/* Lets the compiler check arguments against a printf format. */
#if defined(__MINGW32__) && !defined(__clang__)
#define DMI_PRINTF(text, first) __attribute__((format(gnu_printf, text, first))) /* not Microsoft's, without %zu */
#else
#define DMI_PRINTF(text, first) __attribute__((format(printf, text, first)))
#endif
/* A vector of `lanes` numbers, with C's operators: typedef DMI_VECTOR(float, 4) lanes; */
#define DMI_VECTOR(type, lanes) type __attribute__((vector_size((lanes) * sizeof(type))))
/* Stands before functions that return vectors: as long as they are always inlined, no calling convention matters. */
#define DMI_RETURNS_VECTORS _Pragma("GCC diagnostic ignored \"-Wpsabi\"")
/* Whether the processor has a set and the operating system saves its registers. */
#define DMI_CPU_HAS(set) __builtin_cpu_supports(set)
/* Stand around headers of other libraries, which have warnings of their own. */
#define DMI_FOREIGN_HEADERS_BEGIN                                                                                      \
    _Pragma("GCC diagnostic push") _Pragma("GCC diagnostic ignored \"-Wconversion\"")                                  \
        _Pragma("GCC diagnostic ignored \"-Wpedantic\"") _Pragma("GCC diagnostic ignored \"-Wunused-parameter\"")
#define DMI_FOREIGN_HEADERS_END _Pragma("GCC diagnostic pop")

/* Stands before a variable: calls function(&variable) where its block is left, by return too. */
#define DMI_AT_EXIT(function) __attribute__((cleanup(function), unused))

/* The processor's floating-point control; 0 where it has none that matters. */
static inline uint64_t dmi_fp_control(void) {
#if defined(__SSE__)
    return __builtin_ia32_stmxcsr();
#elif defined(__aarch64__)
    uint64_t control;
    __asm__ volatile("mrs %0, fpcr" : "=r"(control));
    return control;
#else
    return 0;
#endif
}

static inline void dmi_set_fp_control(uint64_t control) {
#if defined(__SSE__)
    __builtin_ia32_ldmxcsr((uint32_t)control);
#elif defined(__aarch64__)
    __asm__ volatile("msr fpcr, %0" : : "r"(control));
#else
    (void)control;
#endif
}

/* Number of zero bits below the lowest 1. bits: not 0. */
static inline uint32_t dmi_trailing_zeros(uint32_t bits) {
    return (uint32_t)__builtin_ctz(bits);
}

/* Floor of the binary logarithm. value: not 0. */
static inline uint32_t dmi_floor_log2(uint64_t value) {
    return 63 - (uint32_t)__builtin_clzll(value);
}

#else

#define DMI_ALWAYS_INLINE
#define DMI_PREFETCH(address) ((void)(address))
#define DMI_NO_INLINE
#define DMI_FLATTEN
#define DMI_TARGET(sets)
#define DMI_PRINTF(text, first)
#define DMI_RETURNS_VECTORS
#define DMI_CPU_HAS(set) 0
#define DMI_FOREIGN_HEADERS_BEGIN
#define DMI_FOREIGN_HEADERS_END
#define DMI_AT_EXIT(function)

/* Changes nothing, because nothing would be restored without DMI_AT_EXIT. */
static inline uint64_t dmi_fp_control(void) {
    return 0;
}

static inline void dmi_set_fp_control(uint64_t control) {
    (void)control;
}

static inline uint32_t dmi_trailing_zeros(uint32_t bits) {
    uint32_t zeros = 0;
    for (; !(bits & 1); bits >>= 1) zeros++;
    return zeros;
}

static inline uint32_t dmi_floor_log2(uint64_t value) {
    uint32_t bits = 0;
    for (; value > 1; value >>= 1) bits++;
    return bits;
}

#endif
#endif
