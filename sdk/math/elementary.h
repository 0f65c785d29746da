/* Exponential, logarithm, circle functions, minima and maxima with the same bits on every machine: C libraries round
 * theirs in ways of their own. Each is a sequence of additions, multiplications, divisions and square roots of doubles,
 * whose results IEEE 754 fixes. Results of floats are off by 0.50001 units in the last place at the most. */
#ifndef DMI_MATH_ELEMENTARY_H
#define DMI_MATH_ELEMENTARY_H

#include <stdint.h>

/* The point of the unit circle at an angle. */
typedef struct dmi_circle {
    double cosine, sine;
} dmi_circle;

typedef struct dmi_circlef {
    float cosine, sine;
} dmi_circlef;

/* Functions of doubles: their relative error is below 1e-13, that of sine and cosine absolute. */
double dmi_exp(double x);
double dmi_log(double x);
/* Takes angles beyond 2^20 modulo the double that is next to 2 pi first. */
dmi_circle dmi_circle_at(double x);
double dmi_tan(double x);
double dmi_atan2(double y, double x);

float dmi_expf(float x);
float dmi_exp2f(float x);
float dmi_logf(float x);
float dmi_sinf(float x);
float dmi_cosf(float x);
dmi_circlef dmi_circle_atf(float x);
float dmi_atan2f(float y, float x);
/* NaN outside of [-1, 1]. */
float dmi_acosf(float x);
float dmi_asinf(float x);

/* Turns scores into shares of 1, in place, by their exponentials. */
void dmi_softmax(float* values, uint32_t count);

/* Returns what fmaxf and the like return: the other one where one is NaN; b of two zeros. */
static inline float dmi_fmaxf(float a, float b) {
    return a > b || b != b ? a : b;
}

static inline float dmi_fminf(float a, float b) {
    return a < b || b != b ? a : b;
}

static inline double dmi_fmax(double a, double b) {
    return a > b || b != b ? a : b;
}

static inline double dmi_fmin(double a, double b) {
    return a < b || b != b ? a : b;
}

#endif
