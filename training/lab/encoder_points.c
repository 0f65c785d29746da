/* A token's points, each through an MLP, then their maximum. */
#include "encoder.h"

#if defined(__x86_64__)
#include <string.h>

#include "encoder_state.h"

enum { MASK_CHANNEL = 3, NEARNESS_CHANNEL = 16 }; /* 0, 1 or coarse: bf16 is enough */

/* Where the rest that rounding leaves of a channel stands among a row's DEPTH numbers. */
static size_t rest_of(size_t channel) {
    return CHANNELS + channel - (channel > MASK_CHANNEL);
}

static int has_rest(size_t channel) {
    return channel != MASK_CHANNEL && channel != NEARNESS_CHANNEL;
}

/* Coordinates are given as two bf16, rounded and what rounding left, which have the same weights: 16 bits of them. */
TARGET static void split_point(const float* in, bf16* out) {
    ALIGNED bf16 row[DEPTH + LANES];
    const __m512 first = _mm512_loadu_ps(in);
    const __m256i rounded = rounded16(first);
    put16(row + LANES, _mm512_set1_ps(in[NEARNESS_CHANNEL]));
    _mm256_store_si256((__m256i*)row, rounded);
    const __mmask16 rests = (__mmask16) ~(1u << MASK_CHANNEL);
    put16(row + CHANNELS, _mm512_maskz_compress_ps(rests, _mm512_sub_ps(first, widened16(rounded))));
    memcpy(out, row, DEPTH * sizeof(bf16));
}

TARGET void lab_encoder_pack_points(dm_lab_encoder* encoder, const float* weights) {
    ALIGNED bf16 rows[POINT_HIDDEN * DEPTH], one[LANES];
    memset(rows, 0, sizeof rows);
    for (size_t n = 0; n < POINT_HIDDEN; n++)
        for (size_t c = 0; c < CHANNELS; c++) {
            put16(one, _mm512_set1_ps(weights[n * CHANNELS + c]));
            rows[n * DEPTH + c] = one[0];
            if (has_rest(c)) rows[n * DEPTH + rest_of(c)] = one[0];
        }
    transpose((const uint32_t*)(const void*)rows, POINT_HIDDEN, DEPTH / 2, encoder->point1);
}

/* The maximum of each channel over a group's 16 rows, and who has it. */
TARGET static void keep_largest(const float* rows, const float* bias, const float* position,
                                uint16_t (*largest)[WIDTH / LANES], float* out) {
    for (size_t c = 0; c < WIDTH / LANES; c++, rows += LANES, bias += LANES, position += LANES, out += LANES) {
        __m512 most = _mm512_load_ps(rows);
        for (size_t i = 1; i < GROUP; i++) most = _mm512_max_ps(most, _mm512_load_ps(rows + i * WIDTH));
        for (size_t i = 0; i < GROUP; i++)
            largest[i][c] = _mm512_cmp_ps_mask(_mm512_load_ps(rows + i * WIDTH), most, _CMP_EQ_OQ);
        const __m512 token = _mm512_add_ps(most, _mm512_loadu_ps(bias));
        _mm512_store_ps(out, _mm512_add_ps(token, _mm512_loadu_ps(position)));
    }
}

TARGET void lab_encoder_points_forward(dm_lab_encoder* encoder, unit_kept* kept, size_t row, const float* points,
                                       const float* positions) {
    bf16* in = kept->points + row * GROUP * DEPTH;
    bf16* hidden = kept->hidden + row * GROUP * POINT_HIDDEN;
    float* sums = encoder->work.strip;
    for (size_t i = 0; i < 2 * GROUP; i++) split_point(points + i * CHANNELS, in + i * DEPTH);
    multiply(&(product){in, DEPTH, encoder->point1, POINT_HIDDEN, DEPTH, sums, POINT_HIDDEN}, 2 * GROUP, POINT_HIDDEN,
             0);
    for (size_t i = 0; i < 2 * GROUP * POINT_HIDDEN; i += LANES) {
        const __m512 sum =
            _mm512_add_ps(_mm512_load_ps(sums + i), _mm512_loadu_ps(encoder->point1_bias + i % POINT_HIDDEN));
        put16(hidden + i, _mm512_max_ps(sum, _mm512_setzero_ps()));
    }
    multiply(&(product){hidden, POINT_HIDDEN, encoder->point2, WIDTH, POINT_HIDDEN, sums, WIDTH}, 2 * GROUP, WIDTH, 0);
    for (size_t g = 0; g < 2; g++)
        keep_largest(sums + g * GROUP * WIDTH, encoder->point2_bias, positions + g * WIDTH,
                     kept->largest + (row + g) * GROUP, encoder->work.x + (row + g) * WIDTH);
}

/* A token's gradient goes to the points that have the maximum. */
TARGET static void spread(const float* token, const uint16_t (*largest)[WIDTH / LANES], bf16* out, float* bias) {
    for (size_t c = 0; c < WIDTH / LANES; c++, token += LANES, out += LANES, bias += LANES) {
        const __m512 gradient = _mm512_load_ps(token);
        __m512 sum = _mm512_loadu_ps(bias);
        for (size_t i = 0; i < GROUP; i++) {
            const __m512 own = _mm512_maskz_mov_ps(largest[i][c], gradient);
            put16(out + i * WIDTH, own);
            sum = _mm512_add_ps(sum, own);
        }
        _mm512_storeu_ps(bias, sum);
    }
}

TARGET void lab_encoder_points_backward(dm_lab_encoder* encoder, const unit_kept* kept, size_t row) {
    encoder_work* work = &encoder->work;
    ALIGNED bf16 outer[2 * GROUP * WIDTH], inner[2 * GROUP * POINT_HIDDEN];
    const bf16* hidden = kept->hidden + row * GROUP * POINT_HIDDEN;
    for (size_t g = 0; g < 2; g++)
        spread(work->x + (row + g) * WIDTH, kept->largest + (row + g) * GROUP, outer + g * GROUP * WIDTH,
               encoder->point2_bias_gradient);
    pair_rows(outer, WIDTH, 2 * GROUP, WIDTH, work->left_pairs);
    turn_pairs(work->left_pairs, 2 * GROUP, WIDTH, work->turned);
    pair_rows(hidden, POINT_HIDDEN, 2 * GROUP, POINT_HIDDEN, work->right_pairs);
    multiply(&(product){work->turned, 2 * GROUP, work->right_pairs, POINT_HIDDEN, 2 * GROUP, encoder->point2_gradient,
                        POINT_HIDDEN},
             WIDTH, POINT_HIDDEN, 1);
    multiply(&(product){outer, WIDTH, encoder->point2_back, POINT_HIDDEN, WIDTH, work->strip, POINT_HIDDEN}, 2 * GROUP,
             POINT_HIDDEN, 0);
    for (size_t i = 0; i < 2 * GROUP * POINT_HIDDEN; i += LANES) {
        float* bias = encoder->point1_bias_gradient + i % POINT_HIDDEN;
        const __mmask16 on = _mm512_cmp_ps_mask(get16(hidden + i), _mm512_setzero_ps(), _CMP_GT_OQ);
        const __m512 gradient = _mm512_maskz_mov_ps(on, _mm512_load_ps(work->strip + i));
        put16(inner + i, gradient);
        _mm512_storeu_ps(bias, _mm512_add_ps(_mm512_loadu_ps(bias), gradient));
    }
    pair_rows(inner, POINT_HIDDEN, 2 * GROUP, POINT_HIDDEN, work->left_pairs);
    turn_pairs(work->left_pairs, 2 * GROUP, POINT_HIDDEN, work->turned);
    pair_rows(kept->points + row * GROUP * DEPTH, DEPTH, 2 * GROUP, DEPTH, work->right_pairs);
    multiply(&(product){work->turned, 2 * GROUP, work->right_pairs, DEPTH, 2 * GROUP, work->point_gradient, DEPTH},
             POINT_HIDDEN, DEPTH, 1);
}

void lab_encoder_points_end(dm_lab_encoder* encoder) {
    float* gathered = encoder->work.point_gradient;
    for (size_t n = 0; n < POINT_HIDDEN; n++)
        for (size_t c = 0; c < CHANNELS; c++)
            encoder->point1_gradient[n * CHANNELS + c] +=
                gathered[n * DEPTH + c] + (has_rest(c) ? gathered[n * DEPTH + rest_of(c)] : 0);
    memset(gathered, 0, sizeof encoder->work.point_gradient);
}
#endif
