/* One pass over the numbers instead of PyTorch's fifteen. */
#include "adam.h"

#include <math.h>

static const float KEPT_MEAN = 0.9f, KEPT_SQUARE = 0.999f, EPSILON = 1e-8f;

static float shortening(const dm_lab_adam_state* state, float most) {
    double squares = 0;
    for (size_t i = 0; i < state->count; i++) squares += (double)state->gradient[i] * (double)state->gradient[i];
    const float length = (float)sqrt(squares);
    return length > most ? most / length : 1;
}

void dm_lab_adam(const dm_lab_adam_state* state, const dm_lab_adam_step* step) {
    const float scale = shortening(state, step->most);
    const float rate = step->rate / (float)(1 - pow((double)KEPT_MEAN, step->number));
    const float root = (float)sqrt(1 / (1 - pow((double)KEPT_SQUARE, step->number)));
    const float keep = 1 - step->rate * step->decay, share = step->share;
    float* restrict w = state->weights, * restrict m = state->mean, * restrict v = state->square, * restrict a = state->average;
    for (size_t i = 0; i < state->count; i++) {
        const float g = scale * state->gradient[i];
        m[i] = KEPT_MEAN * m[i] + (1 - KEPT_MEAN) * g;
        v[i] = KEPT_SQUARE * v[i] + (1 - KEPT_SQUARE) * g * g;
        w[i] = keep * w[i] - rate * m[i] / (root * sqrtf(v[i]) + EPSILON);
        a[i] += share * (w[i] - a[i]);
    }
}
