/* Implements random draws and rotations that the lab's files share. */
#include <math.h>

#include "case.h"

float lab_random_uniform(dmi_random* random, float low, float high) {
    return low + (high - low) * dmi_random_unit(random);
}

int lab_random_bool(dmi_random* random, float probability) {
    return dmi_random_unit(random) < probability;
}

void lab_random_direction(dmi_random* random, float out[3]) {
    float length;
    do {
        for (int i = 0; i < 3; i++) out[i] = dmi_random_normal(random);
        length = sqrtf(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
    } while (length < 1e-3f);
    for (int i = 0; i < 3; i++) out[i] /= length;
}

void lab_rotation(const float axis[3], float angle, float out[9]) {
    const float c = cosf(angle), s = sinf(angle), d = 1.0f - c;
    const float x = axis[0], y = axis[1], z = axis[2];
    const float rows[9] = {c + d * x * x,     d * x * y - s * z, d * x * z + s * y, d * x * y + s * z, c + d * y * y,
                           d * y * z - s * x, d * x * z - s * y, d * y * z + s * x, c + d * z * z};
    for (int i = 0; i < 9; i++) out[i] = rows[i];
}

void lab_rotate(const float rotation[9], const float v[3], float out[3]) {
    float turned[3];
    for (size_t i = 0; i < 3; i++)
        turned[i] = rotation[3 * i] * v[0] + rotation[3 * i + 1] * v[1] + rotation[3 * i + 2] * v[2];
    for (int i = 0; i < 3; i++) out[i] = turned[i];
}
