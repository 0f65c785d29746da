/* Attention of a case's tokens to each other, head by head. */
#include "encoder.h"

#if defined(__x86_64__)
#include <math.h>
#include <string.h>

#include "encoder_state.h"

/* e^x of x <= 0, to some 1e-6 of it. */
TARGET_INLINE __m512 exp16(__m512 x) {
    const __m512 t = _mm512_mul_ps(_mm512_max_ps(x, _mm512_set1_ps(-80)), _mm512_set1_ps(1.44269504f));
    const __m512 whole = _mm512_roundscale_ps(t, 0);
    const __m512 rest = _mm512_mul_ps(_mm512_sub_ps(t, whole), _mm512_set1_ps(0.69314718f));
    static const float series[6] = {1.f / 120, 1.f / 24, 1.f / 6, 0.5f, 1, 1};
    __m512 p = _mm512_set1_ps(1.f / 720);
    for (size_t i = 0; i < 6; i++) p = _mm512_fmadd_ps(p, rest, _mm512_set1_ps(series[i]));
    return _mm512_scalef_ps(p, whole);
}

/* A row of scores to shares of one, of the tokens that exist. */
TARGET_INLINE void share_row(const float* scores, size_t tokens, size_t padded, bf16* out) {
    __m512 v[MOST_KEYS / LANES], most = _mm512_set1_ps(-INFINITY), sum = _mm512_setzero_ps();
    for (size_t i = 0; i < padded / LANES; i++) {
        const size_t left = tokens > i * LANES ? tokens - i * LANES : 0;
        const __mmask16 real = (__mmask16)(left >= LANES ? 0xffffu : (1u << left) - 1u);
        v[i] = _mm512_mask_mov_ps(_mm512_set1_ps(-INFINITY), real, _mm512_load_ps(scores + i * LANES));
        most = _mm512_max_ps(most, v[i]);
    }
    const __m512 top = _mm512_set1_ps(_mm512_reduce_max_ps(most));
    for (size_t i = 0; i < padded / LANES; i++) {
        const __mmask16 real = _mm512_cmp_ps_mask(v[i], _mm512_set1_ps(-INFINITY), _CMP_GT_OQ);
        v[i] = _mm512_maskz_mov_ps(real, exp16(_mm512_sub_ps(v[i], top)));
        sum = _mm512_add_ps(sum, v[i]);
    }
    const __m512 scale = _mm512_set1_ps(1 / _mm512_reduce_add_ps(sum));
    for (size_t i = 0; i < padded / LANES; i++) put16(out + i * LANES, _mm512_mul_ps(v[i], scale));
}

/* A head's rows of HEAD_ROOM floats to its columns of rows of `stride`. */
TARGET static void put_head(const float* from, size_t rows, float scale, bf16* out, size_t stride) {
    for (size_t r = 0; r < rows; r++, from += HEAD_ROOM, out += stride) {
        put16(out, _mm512_mul_ps(_mm512_load_ps(from), _mm512_set1_ps(scale)));
        put8(out + LANES, _mm512_mul_ps(_mm512_load_ps(from + LANES), _mm512_set1_ps(scale)));
    }
}

TARGET static void attend_head(const dm_lab_encoder* encoder, layer_kept* kept, size_t head, size_t first_row) {
    const size_t padded = encoder->padded, keys = encoder->keys, at = first_row * HEAD_ROOM;
    ALIGNED uint32_t turned[HEAD_ROOM / 2 * MOST_KEYS], pairs[MOST_KEYS / 2 * HEAD_ROOM];
    ALIGNED float scores[MOST_KEYS * MOST_KEYS];
    bf16* shares = kept->shares[head] + first_row / padded * padded * keys;
    transpose((const uint32_t*)(const void*)(kept->k[head] + at), padded, HEAD_ROOM / 2, turned);
    multiply(&(product){kept->q[head] + at, HEAD_ROOM, turned, padded, HEAD_ROOM, scores, padded}, padded, padded, 0);
    for (size_t r = 0; r < padded; r++) share_row(scores + r * padded, encoder->tokens, padded, shares + r * keys);
    memset(pairs, 0, sizeof pairs);
    pair_rows(kept->v[head] + at, HEAD_ROOM, padded, HEAD_ROOM, pairs);
    multiply(&(product){shares, keys, pairs, HEAD_ROOM, keys, scores, HEAD_ROOM}, padded, HEAD_ROOM, 0);
    put_head(scores, padded, 1, kept->mixed + first_row * WIDTH + head * HEAD, WIDTH);
}

void lab_encoder_attend(dm_lab_encoder* encoder, layer_kept* kept) {
    for (size_t i = 0; i < encoder->cases; i++)
        for (size_t head = 0; head < HEADS; head++) attend_head(encoder, kept, head, i * encoder->padded);
}

/* The scores' gradient: share (d - sum of share d), d the shares' own. */
TARGET_INLINE void unshare_row(const bf16* shares, const float* gradient, size_t padded, bf16* out) {
    __m512 p[MOST_KEYS / LANES], d[MOST_KEYS / LANES], sum = _mm512_setzero_ps();
    for (size_t i = 0; i < padded / LANES; i++) {
        p[i] = get16(shares + i * LANES), d[i] = _mm512_load_ps(gradient + i * LANES);
        sum = _mm512_fmadd_ps(p[i], d[i], sum);
    }
    const __m512 mean = _mm512_set1_ps(_mm512_reduce_add_ps(sum));
    for (size_t i = 0; i < padded / LANES; i++) put16(out + i * LANES, _mm512_mul_ps(p[i], _mm512_sub_ps(d[i], mean)));
}

typedef struct head_work {
    ALIGNED uint32_t pairs[MOST_KEYS / 2 * HEAD_ROOM], square_pairs[MOST_KEYS / 2 * MOST_KEYS];
    ALIGNED float shares[MOST_KEYS * MOST_KEYS], out[MOST_KEYS * HEAD_ROOM];
    ALIGNED bf16 scores[MOST_KEYS * MOST_KEYS], turned[MOST_KEYS * MOST_KEYS];
} head_work;

/* left (padded x keys) times a head's rows, to part 0, 1 or 2 of the gradient of q, k, v. */
TARGET static void back_to(dm_lab_encoder* encoder, head_work* work, const bf16* left, const bf16* rows,
                           size_t first_row, size_t head, size_t part) {
    pair_rows(rows, HEAD_ROOM, encoder->padded, HEAD_ROOM, work->pairs);
    multiply(&(product){left, encoder->keys, work->pairs, HEAD_ROOM, encoder->keys, work->out, HEAD_ROOM},
             encoder->padded, HEAD_ROOM, 0);
    put_head(work->out, encoder->padded, part == 0 ? SCORE_SCALE : 1,
             encoder->work.qkv + first_row * PACKED + part * WIDTH + head * HEAD, PACKED);
}

/* padded x keys to keys x padded, rows of `keys` again. */
TARGET static void turn_square(const dm_lab_encoder* encoder, head_work* work, const bf16* square) {
    const size_t padded = encoder->padded, keys = encoder->keys;
    pair_rows(square, keys, padded, keys, work->square_pairs);
    memset(work->square_pairs + padded / 2 * keys, 0, (keys - padded) / 2 * keys * sizeof(uint32_t));
    turn_pairs(work->square_pairs, keys, keys, work->turned);
}

TARGET static void attend_head_backward(dm_lab_encoder* encoder, head_work* work, const layer_kept* kept, size_t head,
                                        size_t first_row) {
    const size_t padded = encoder->padded, keys = encoder->keys, at = first_row * HEAD_ROOM;
    const bf16* shares = kept->shares[head] + first_row / padded * padded * keys;
    const bf16* gradient = encoder->work.mixed[head] + at;
    transpose((const uint32_t*)(const void*)(kept->v[head] + at), padded, HEAD_ROOM / 2, work->square_pairs);
    multiply(&(product){gradient, HEAD_ROOM, work->square_pairs, padded, HEAD_ROOM, work->shares, padded}, padded,
             padded, 0);
    for (size_t r = 0; r < padded; r++)
        unshare_row(shares + r * keys, work->shares + r * padded, padded, work->scores + r * keys);
    back_to(encoder, work, work->scores, kept->k[head] + at, first_row, head, 0);
    turn_square(encoder, work, work->scores);
    back_to(encoder, work, work->turned, kept->q[head] + at, first_row, head, 1);
    turn_square(encoder, work, shares);
    back_to(encoder, work, work->turned, gradient, first_row, head, 2);
}

void lab_encoder_attend_backward(dm_lab_encoder* encoder, const layer_kept* kept) {
    head_work work;
    memset(&work, 0, sizeof work); /* rows and columns past the tokens stay 0 */
    for (size_t i = 0; i < encoder->cases; i++)
        for (size_t head = 0; head < HEADS; head++)
            attend_head_backward(encoder, &work, kept, head, i * encoder->padded);
}
#endif
