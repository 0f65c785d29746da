/* Numbers as they are printed. */
#ifndef SAMPLES_SHOWN_H
#define SAMPLES_SHOWN_H

#include <math.h>

/* Returns the number, and 0 for one that rounds to 0 with so many decimals: printf would write -0.0000. */
static inline double shown(double number, int decimals) {
    return fabs(number) * pow(10, decimals) <= 0.5 ? 0 : number;
}

#endif
