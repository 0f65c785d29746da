/* Mathematical constants, once for all rooms. DMI_PI is a double; names that end in _F are floats. */
#ifndef DMI_MATH_CONSTANTS_H
#define DMI_MATH_CONSTANTS_H

#define DMI_PI 3.14159265358979323846
#define DMI_PI_F 3.14159265358979323846f
#define DMI_HALF_PI_F 1.57079632679489661923f
#define DMI_TWO_PI_F 6.28318530717958647692f
#define DMI_LN_2_F 0.69314718055994530942f

#endif
