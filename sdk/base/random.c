/* PCG32 (O'Neill 2014, XSH RR 64/32) and normal numbers by inverse transform, bit for bit the same on every machine. */
#include "base/random.h"

#include <math.h>

#define LN_2 0.69314718055994530942

dmi_random dmi_random_make(uint64_t seed, uint64_t stream) {
    dmi_random random = {.state = 0, .increment = (stream << 1) | 1};
    dmi_random_u32(&random);
    random.state += seed;
    dmi_random_u32(&random);
    return random;
}

uint32_t dmi_random_u32(dmi_random* random) {
    uint64_t old = random->state;
    random->state = old * 6364136223846793005u + random->increment;
    uint32_t shifted = (uint32_t)(((old >> 18) ^ old) >> 27);
    uint32_t turn = (uint32_t)(old >> 59);
    return (shifted >> turn) | (shifted << ((32 - turn) & 31));
}

float dmi_random_unit(dmi_random* random) {
    return (float)(dmi_random_u32(random) >> 8) * 0x1p-24f;
}

/* Returns ln x, x > 0, by correctly rounded operations alone: the last bits of libm's log differ between machines. */
static double portable_log(double x) {
    int exponent;
    double mantissa = frexp(x, &exponent);                           /* [0.5, 1) */
    double s = (mantissa - 1) / (mantissa + 1), s2 = s * s, sum = 0; /* ln m = 2 artanh s, |s| <= 1/3 */
    for (int k = 31; k >= 1; k -= 2) sum = sum * s2 + 1.0 / k;
    return 2 * s * sum + exponent * LN_2;
}

/* Inverse of the normal distribution to 7 digits: Wichura, algorithm AS 241 (1988), PPND7, with its coefficients. */
static double normal_quantile(double p) {
    double q = p - 0.5;
    if (fabs(q) <= 0.425) {
        double r = 0.180625 - q * q;
        return q * (((59.109374720 * r + 159.29113202) * r + 50.434271938) * r + 3.3871327179) /
               (((67.187563600 * r + 78.757757664) * r + 17.895169469) * r + 1);
    }
    double r = sqrt(-portable_log(q < 0 ? p : 1 - p)), tail;
    if (r <= 5) {
        r -= 1.6;
        tail = (((0.17023821103 * r + 1.3067284816) * r + 2.7568153900) * r + 1.4234372777) /
               ((0.12021132975 * r + 0.73700164250) * r + 1);
    } else {
        r -= 5;
        tail = (((0.017337203997 * r + 0.42868294337) * r + 3.0812263860) * r + 6.6579051150) /
               ((0.012258202635 * r + 0.24197894225) * r + 1);
    }
    return q < 0 ? -tail : tail;
}

float dmi_random_normal(dmi_random* random) {
    return (float)normal_quantile(((double)dmi_random_u32(random) + 0.5) * 0x1p-32);
}
