/* Constants that all rooms share, the largest numbers that the library computes with, and elementary functions.
 *
 * Exponential, logarithm, circle functions, minima and maxima have the same bits on every machine: C libraries round
 * theirs in ways of their own. Each is a sequence of additions, multiplications, divisions and square roots of doubles,
 * whose results IEEE 754 fixes. Results of floats are off by 0.50001 units in the last place at the most. */
#ifndef DMI_MATH_ELEMENTARY_H
#define DMI_MATH_ELEMENTARY_H

#include <stdint.h>

/* ---- constants; DMI_PI is a double, and names that end in _F are floats ---- */

#define DMI_PI 3.14159265358979323846
#define DMI_PI_F 3.14159265358979323846f
#define DMI_HALF_PI_F 1.57079632679489661923f
#define DMI_TWO_PI_F 6.28318530717958647692f
#define DMI_LN_2_F 0.69314718055994530942f

/* ---- largest numbers; by hand ---- */

/* Largest length (host units), angle (rad) and time of a track or a release (s) that is taken, and largest joint value:
 * cubes stay in a float's range, with room for what a drag makes of them, so that finite input gives finite output. */
#define DMI_LARGEST 1e9f
/* Largest number in the dual part of a pose: half of what a turn by 180 degrees about the farthest origin, 1.7e9 away,
 * moves by, and half of a screw's way, are 2.2e9; the rest is room for a pose on its way between two joints. */
#define DMI_LARGEST_DUAL 4e9f
/* Longest time, s: 30,000 years; longer is as long. */
#define DMI_LARGEST_TIME 1e12f
/* Largest velocity and acceleration, joint value a second or a second squared: no limit is felt any more. */
#define DMI_LARGEST_RATE 1e12f
/* Largest number that a saved drag holds: no less than any of the above, and its cube is in a float's range. */
#define DMI_LARGEST_SAVED 1e12f

/* ---- elementary functions ---- */

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
