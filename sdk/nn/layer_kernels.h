/* The kernels other than the matrix product, written once on vectors of LANES floats. The file of each instruction set
 * defines LANES and TARGET (the attribute that enables the set) and includes this. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "base/compiler.h"
#include "nn/kernels.h"

#define NORM_EPSILON 1e-5f /* added to the variance; PyTorch's default, as trained */

typedef DMI_VECTOR(float, LANES) lanes;
typedef DMI_VECTOR(int32_t, LANES) int_lanes;

/* Copies the end of a row: `count` < LANES numbers, then `filler`. Not inlined: rows of whole vectors never need it. */
TARGET DMI_NO_INLINE static void copy_part(float* to, const float* from, uint32_t count, float filler) {
    for (uint32_t i = 0; i < LANES; i++) to[i] = i < count ? from[i] : filler;
}

/* Loads `count` numbers, at most LANES of them. */
TARGET static inline lanes load(const float* p, uint32_t count, float filler) {
    float part[LANES];
    lanes value;
    if (count < LANES) {
        copy_part(part, p, count, filler);
        p = part;
    }
    memcpy(&value, p, sizeof value);
    return value;
}

TARGET static inline void store(float* p, uint32_t count, lanes value) {
    if (count >= LANES) {
        memcpy(p, &value, sizeof value);
        return;
    }
    for (uint32_t i = 0; i < count; i++) p[i] = value[i];
}

TARGET static inline lanes select(int_lanes mask, lanes yes, lanes no) {
    return (lanes)((mask & (int_lanes)yes) | (~mask & (int_lanes)no));
}

TARGET static inline lanes larger(lanes a, lanes b) {
    return select(a > b, a, b);
}

TARGET static inline float sum_of(lanes value) {
    for (int half = LANES / 2; half > 0; half /= 2)
        for (int i = 0; i < half; i++) value[i] += value[i + half];
    return value[0];
}

TARGET static inline float max_of(lanes value) {
    float best = value[0];
    for (int i = 1; i < LANES; i++) best = value[i] > best ? value[i] : best;
    return best;
}

/* Returns e^x to 2 units in the last place, x clamped to where the result is a normal number. Algorithm and
 * coefficients of Cephes' expf: x = n ln 2 + r, |r| <= ln 2 / 2; a polynomial gives e^r, the exponent bits 2^n. */
TARGET static inline lanes exponential(lanes x) {
    const float rounder = 12582912.0f; /* 1.5 * 2^23: adding it rounds to a whole number, held in the low bits */
    x = select(x < -87.0f, -87.0f - (lanes){0}, x);
    x = select(x > 88.0f, 88.0f - (lanes){0}, x);
    const lanes shifted = x * 1.44269504f + rounder; /* 1 / ln 2 */
    const lanes n = shifted - rounder;
    const lanes r = (x - n * 0.693359375f) + n * 2.12194440e-4f; /* ln 2 in two parts, the first exact in 10 bits */
    lanes p = r * 1.9875691500e-4f + 1.3981999507e-3f;
    p = p * r + 8.3334519073e-3f;
    p = p * r + 4.1665795894e-2f;
    p = p * r + 1.6666665459e-1f;
    p = p * r + 5.0000001201e-1f;
    p = p * (r * r) + r + 1.0f;
    return (lanes)((int_lanes)p + ((int_lanes)shifted << 23));
}

TARGET static void layer_norm(const float* x, uint32_t rows, uint32_t columns, const float* weight, const float* bias,
                              float* y) {
    for (uint32_t r = 0; r < rows; r++, x += columns, y += columns) {
        lanes sum = {0}, squares = {0};
        for (uint32_t c = 0; c < columns; c += LANES) sum += load(x + c, columns - c, 0.0f);
        const float mean = sum_of(sum) / (float)columns;
        for (uint32_t c = 0; c < columns; c += LANES) {
            const lanes offset = load(x + c, columns - c, mean) - mean;
            squares += offset * offset;
        }
        const float scale = 1.0f / sqrtf(sum_of(squares) / (float)columns + NORM_EPSILON);
        for (uint32_t c = 0; c < columns; c += LANES) {
            const lanes normal = (load(x + c, columns - c, mean) - mean) * scale;
            store(y + c, columns - c, normal * load(weight + c, columns - c, 0.0f) + load(bias + c, columns - c, 0.0f));
        }
    }
}

TARGET static void softmax(float* x, uint32_t rows, uint32_t columns) {
    for (uint32_t r = 0; r < rows; r++, x += columns) {
        lanes best = load(x, columns, -FLT_MAX), sum = {0};
        for (uint32_t c = LANES; c < columns; c += LANES) best = larger(load(x + c, columns - c, -FLT_MAX), best);
        const float top = max_of(best);
        for (uint32_t c = 0; c < columns; c += LANES) {
            const lanes value = exponential(load(x + c, columns - c, -FLT_MAX) - top);
            store(x + c, columns - c, value);
            sum += value; /* lanes past the end add e^-87 each, below rounding */
        }
        const float scale = 1.0f / sum_of(sum);
        for (uint32_t c = 0; c < columns; c += LANES) store(x + c, columns - c, load(x + c, columns - c, 0.0f) * scale);
    }
}

TARGET static void gate(const float* x, uint32_t count, float* y) {
    for (uint32_t i = 0; i < count; i += LANES)
        store(y + i, count - i, load(y + i, count - i, 0.0f) / (1.0f + exponential(-load(x + i, count - i, 0.0f))));
}

TARGET static void modulate(float* x, uint32_t rows, uint32_t columns, const float* scale, const float* shift) {
    for (uint32_t r = 0; r < rows; r++, x += columns)
        for (uint32_t c = 0; c < columns; c += LANES)
            store(x + c, columns - c,
                  load(x + c, columns - c, 0.0f) * load(scale + c, columns - c, 0.0f) +
                      load(shift + c, columns - c, 0.0f));
}

TARGET static void max_rows(const float* x, uint32_t rows, uint32_t columns, float* out) {
    for (uint32_t c = 0; c < columns; c += LANES) {
        lanes best = load(x + c, columns - c, 0.0f);
        for (uint32_t r = 1; r < rows; r++) best = larger(load(x + (size_t)r * columns + c, columns - c, 0.0f), best);
        store(out + c, columns - c, best);
    }
}

TARGET static void mean_rows(const float* x, uint32_t rows, uint32_t columns, float* out) {
    for (uint32_t c = 0; c < columns; c += LANES) {
        lanes sum = {0};
        for (uint32_t r = 0; r < rows; r++) sum += load(x + (size_t)r * columns + c, columns - c, 0.0f);
        store(out + c, columns - c, sum / (float)rows);
    }
}
