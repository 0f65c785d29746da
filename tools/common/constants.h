/* Mathematical constants of the tool, which sees the public headers alone. */
#ifndef CLI_CONSTANTS_H
#define CLI_CONSTANTS_H

#define PI 3.14159265358979323846
#define TWO_PI 6.28318530717958647692

#endif
