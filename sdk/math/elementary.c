/* Elementary functions: argument reduction and a polynomial, in doubles. */
#include "math/elementary.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#define ROUNDER 6755399441055744.0 /* 1.5 * 2^52: adding it rounds to a whole number, held in the low bits */
#define EXPONENT_BITS 52           /* place of a double's exponent */
#define EXPONENT_BIAS 1023

static const double log2_e = 1.44269504088896340736;
static const double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33; /* high: exact times 2^20 */
static const double half_pi_high = 0x1.921fb54400000p0, half_pi_low = 0x1.0b4611a626331p-34;
static const double two_over_pi = 0.63661977236758134308;
static const double largest_reduced = 0x1p20; /* quarter turns up to here times half_pi_high are exact */
static const double overflow_exp = 709.7, underflow_exp = -708.3; /* results stay normal numbers in between */

static uint64_t bits_of(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static double from_bits(uint64_t bits) {
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Returns 2^n of a normal number. */
static double power_of_two(int64_t n) {
    return from_bits((uint64_t)(n + EXPONENT_BIAS) << EXPONENT_BITS);
}

/* Returns e^r, |r| <= ln 2 / 2: Taylor's series, whose rest is below 2e-14. */
static double exp_reduced(double r) {
    const double r2 = r * r, r4 = r2 * r2;
    const double a = 1 + r, b = 1.0 / 2 + r * (1.0 / 6), c = 1.0 / 24 + r * (1.0 / 120);
    const double d = 1.0 / 720 + r * (1.0 / 5040), e = 1.0 / 40320 + r * (1.0 / 362880);
    const double f = 1.0 / 3628800 + r * (1.0 / 39916800);
    return (a + r2 * b) + r4 * ((c + r2 * d) + r4 * (e + r2 * f));
}

double dmi_exp(double x) {
    if (x > overflow_exp) return INFINITY;
    if (x < underflow_exp) return 0;
    if (x != x) return x;
    const double n = (x * log2_e + ROUNDER) - ROUNDER;
    return exp_reduced((x - n * ln2_high) - n * ln2_low) * power_of_two((int64_t)n);
}

float dmi_expf(float x) {
    return (float)dmi_exp((double)x);
}

float dmi_exp2f(float x) {
    if (!(fabsf(x) < EXPONENT_BIAS)) return x < 0 ? 0 : x > 0 ? INFINITY : x;
    const double n = ((double)x + ROUNDER) - ROUNDER;
    return (float)(exp_reduced(((double)x - n) * (ln2_high + ln2_low)) * power_of_two((int64_t)n));
}

/* Returns 2 atanh(s), the logarithm of (1 + s) / (1 - s); |s| <= 0.1716. The rest of the series is below 1e-14. */
static double log_series(double s) {
    const double s2 = s * s, s4 = s2 * s2;
    const double a = 1.0 / 3 + s2 * (1.0 / 5), b = 1.0 / 7 + s2 * (1.0 / 9), c = 1.0 / 11 + s2 * (1.0 / 13);
    const double d = 1.0 / 15 + s2 * (1.0 / 17);
    return 2 * s + 2 * s * s2 * (a + s4 * (b + s4 * (c + s4 * d)));
}

double dmi_log(double x) {
    static const uint64_t root_half = 0x3fe6a09e667f3bcd; /* bits of the root of 1/2 */
    const double subnormal_scale = 0x1p54;
    if (!(x > 0)) return x == 0 ? -INFINITY : NAN;
    if (x == INFINITY) return x;
    int64_t n = 0;
    if (bits_of(x) >> EXPONENT_BITS == 0) {
        x *= subnormal_scale;
        n = -54;
    }
    /* x = 2^n m, m in [root of 1/2, root of 2) */
    const int64_t shift = (int64_t)(bits_of(x) - root_half) >> EXPONENT_BITS;
    n += shift;
    const double m = from_bits(bits_of(x) - ((uint64_t)shift << EXPONENT_BITS));
    return (double)n * ln2_high + (log_series((m - 1) / (m + 1)) + (double)n * ln2_low);
}

float dmi_logf(float x) {
    return (float)dmi_log((double)x);
}

/* Returns x less a whole number of quarter turns, in [-pi / 4, pi / 4], and the last two bits of the number. */
static double reduce_angle(double x, uint32_t* out_quarter) {
    if (fabs(x) > largest_reduced) x = fmod(x, 2 * DMI_PI); /* exact, so every C library's is the same */
    const double shifted = x * two_over_pi + ROUNDER, n = shifted - ROUNDER;
    *out_quarter = (uint32_t)bits_of(shifted) & 3;
    return (x - n * half_pi_high) - n * half_pi_low;
}

/* Taylor's series for |r| <= pi / 4, rests below 1e-14. */
static double sin_reduced(double r) {
    const double r2 = r * r, r4 = r2 * r2;
    const double a = -1.0 / 6 + r2 * (1.0 / 120), b = -1.0 / 5040 + r2 * (1.0 / 362880);
    const double c = -1.0 / 39916800 + r2 * (1.0 / 6227020800);
    return r * (1 + r2 * (a + r4 * (b + r4 * c))); /* a product, which keeps the sign of 0 */
}

static double cos_reduced(double r) {
    const double r2 = r * r, r4 = r2 * r2;
    const double a = -1.0 / 2 + r2 * (1.0 / 24), b = -1.0 / 720 + r2 * (1.0 / 40320);
    const double c = -1.0 / 3628800 + r2 * (1.0 / 479001600), d = -1.0 / 87178291200;
    return 1 + r2 * (a + r4 * (b + r4 * (c + r4 * d)));
}

dmi_circle dmi_circle_at(double x) {
    uint32_t quarter;
    const double r = reduce_angle(x, &quarter), s = sin_reduced(r), c = cos_reduced(r);
    const double sine = quarter & 1 ? c : s, cosine = quarter & 1 ? s : c;
    return (dmi_circle){(quarter + 1) & 2 ? -cosine : cosine, quarter & 2 ? -sine : sine};
}

double dmi_tan(double x) {
    const dmi_circle at = dmi_circle_at(x);
    return at.sine / at.cosine;
}

dmi_circlef dmi_circle_atf(float x) {
    const dmi_circle at = dmi_circle_at((double)x);
    return (dmi_circlef){(float)at.cosine, (float)at.sine};
}

float dmi_sinf(float x) {
    return (float)dmi_circle_at((double)x).sine;
}

float dmi_cosf(float x) {
    return (float)dmi_circle_at((double)x).cosine;
}

/* Returns the arc tangent of t in [0, 1], by intervals and coefficients of Sun's fdlibm (s_atan.c): error 2^-53. */
static double atan_unit(double t) {
    static const double coefficients[11] = {
        3.33333333333329318027e-01,  -1.99999999998764832476e-01, 1.42857142725034663711e-01,
        -1.11111104054623557880e-01, 9.09088713343650656196e-02,  -7.69187620504482999495e-02,
        6.66107313738753120669e-02,  -5.83357013379057348645e-02, 4.97687799461593236017e-02,
        -3.65315727442169155270e-02, 1.62858201153657823623e-02};
    static const double first_end = 7.0 / 16, second_end = 11.0 / 16, atan_half = 4.63647609000806093515e-01;
    double at = 0, u = t;
    if (t >= second_end) {
        at = DMI_PI / 4;
        u = (t - 1) / (t + 1);
    } else if (t >= first_end) {
        at = atan_half;
        u = (2 * t - 1) / (2 + t);
    }
    const double u2 = u * u;
    double sum = coefficients[10];
    for (int i = 9; i >= 0; i--) sum = sum * u2 + coefficients[i];
    return at + (u - u * u2 * sum);
}

double dmi_atan2(double y, double x) {
    const double ax = fabs(x), ay = fabs(y);
    if (x != x || y != y) return NAN;
    const double least = ax < ay ? ax : ay, most = ax < ay ? ay : ax;
    const double ratio = most == 0 ? 0 : least == INFINITY ? 1 : least / most;
    double angle = atan_unit(ratio);
    if (ay > ax) angle = DMI_PI / 2 - angle;
    if (signbit(x)) angle = DMI_PI - angle;
    return signbit(y) ? -angle : angle;
}

float dmi_atan2f(float y, float x) {
    return (float)dmi_atan2((double)y, (double)x);
}

/* 1 - x and 1 + x are exact but for tiny x, where it does not matter. */
static double other_side(double x) {
    return sqrt((1 - x) * (1 + x));
}

float dmi_acosf(float x) {
    return (float)dmi_atan2(other_side((double)x), (double)x);
}

float dmi_asinf(float x) {
    return (float)dmi_atan2((double)x, other_side((double)x));
}

void dmi_softmax(float* values, uint32_t count) {
    float most = -INFINITY, sum = 0;
    for (uint32_t i = 0; i < count; i++) most = dmi_fmaxf(most, values[i]);
    for (uint32_t i = 0; i < count; i++) sum += values[i] = dmi_expf(values[i] - most);
    for (uint32_t i = 0; i < count; i++) values[i] /= sum;
}
