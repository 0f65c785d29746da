/* A pre-norm Transformer layer: x += attention(norm x); x += ff2(relu(ff1(norm x))). */
#include "encoder.h"

#if defined(__x86_64__)
#include <math.h>
#include <string.h>

#include "encoder_state.h"

enum { PIECES = WIDTH / LANES, STRIP = 2 * LANES /* rows of sums at a time: they stay in the nearest cache */ };

TARGET static void norm_forward(const float* gain, const float* bias, norm_kept* kept) {
    const float* x = kept->x;
    bf16* y = kept->y;
    for (size_t r = 0; r < ROWS; r++, x += WIDTH, y += WIDTH) {
        __m512 v[PIECES], sum = _mm512_setzero_ps(), squares = _mm512_setzero_ps();
        for (size_t i = 0; i < PIECES; i++) v[i] = _mm512_load_ps(x + i * LANES), sum = _mm512_add_ps(sum, v[i]);
        const float mean = _mm512_reduce_add_ps(sum) / WIDTH;
        for (size_t i = 0; i < PIECES; i++) {
            v[i] = _mm512_sub_ps(v[i], _mm512_set1_ps(mean));
            squares = _mm512_fmadd_ps(v[i], v[i], squares);
        }
        const float scale = 1 / sqrtf(_mm512_reduce_add_ps(squares) / WIDTH + 1e-5f);
        kept->mean[r] = mean, kept->scale[r] = scale;
        for (size_t i = 0; i < PIECES; i++) {
            const __m512 even = _mm512_mul_ps(v[i], _mm512_set1_ps(scale));
            put16(y + i * LANES,
                  _mm512_fmadd_ps(even, _mm512_loadu_ps(gain + i * LANES), _mm512_loadu_ps(bias + i * LANES)));
        }
    }
}

TARGET_INLINE void add_to(float* sums, __m512 more) {
    _mm512_storeu_ps(sums, _mm512_add_ps(_mm512_loadu_ps(sums), more));
}

/* gradient: of y; that of x is added to `x`. */
TARGET static void norm_backward(const norm_kept* kept, const float* gain, const float* gradient, float* x,
                                 float* gain_gradient, float* bias_gradient) {
    const float* in = kept->x;
    for (size_t r = 0; r < ROWS; r++, in += WIDTH, gradient += WIDTH, x += WIDTH) {
        const __m512 mean = _mm512_set1_ps(kept->mean[r]), scale = _mm512_set1_ps(kept->scale[r]);
        __m512 even[PIECES], d[PIECES], sum = _mm512_setzero_ps(), along = _mm512_setzero_ps();
        for (size_t i = 0; i < PIECES; i++) {
            const __m512 g = _mm512_load_ps(gradient + i * LANES);
            even[i] = _mm512_mul_ps(_mm512_sub_ps(_mm512_load_ps(in + i * LANES), mean), scale);
            add_to(gain_gradient + i * LANES, _mm512_mul_ps(g, even[i]));
            add_to(bias_gradient + i * LANES, g);
            d[i] = _mm512_mul_ps(g, _mm512_loadu_ps(gain + i * LANES));
            sum = _mm512_add_ps(sum, d[i]), along = _mm512_fmadd_ps(d[i], even[i], along);
        }
        const __m512 level = _mm512_set1_ps(_mm512_reduce_add_ps(sum) / WIDTH);
        const __m512 stretch = _mm512_set1_ps(_mm512_reduce_add_ps(along) / WIDTH);
        for (size_t i = 0; i < PIECES; i++) {
            const __m512 left = _mm512_fnmadd_ps(even[i], stretch, _mm512_sub_ps(d[i], level));
            add_to(x + i * LANES, _mm512_mul_ps(left, scale));
        }
    }
}

/* Gradients of a layer y = x W + bias: the bias' from y's, and the weights' as PyTorch lays them, outputs x inputs. */
TARGET static void add_gradients(encoder_work* work, const bf16* y, size_t outputs, const bf16* x, size_t inputs,
                                 float* weights, float* bias) {
    for (size_t r = 0; r < ROWS; r++)
        for (size_t c = 0; c < outputs; c += LANES) add_to(bias + c, get16(y + r * outputs + c));
    pair_rows(y, outputs, ROWS, outputs, work->left_pairs);
    turn_pairs(work->left_pairs, ROWS, outputs, work->turned);
    pair_rows(x, inputs, ROWS, inputs, work->right_pairs);
    multiply(&(product){work->turned, ROWS, work->right_pairs, inputs, ROWS, weights, inputs}, outputs, inputs, 1);
}

/* A strip of rows: q (scaled), k and v of each head, apart. */
TARGET static void put_heads(const float* sums, const float* bias, layer_kept* kept, size_t row) {
    bf16(*const parts[3])[ROWS * HEAD_ROOM] = {kept->q, kept->k, kept->v};
    const __mmask16 rest = (1u << (HEAD - LANES)) - 1u;
    for (size_t r = 0; r < STRIP; r++, sums += PACKED)
        for (size_t i = 0; i < 3 * HEADS; i++) {
            const __m512 scale = _mm512_set1_ps(i < HEADS ? SCORE_SCALE : 1);
            const float *sum = sums + i * HEAD, *b = bias + i * HEAD;
            const __m512 first = _mm512_add_ps(_mm512_loadu_ps(sum), _mm512_loadu_ps(b));
            const __m512 last =
                _mm512_add_ps(_mm512_maskz_loadu_ps(rest, sum + LANES), _mm512_maskz_loadu_ps(rest, b + LANES));
            bf16* out = parts[i / HEADS][i % HEADS] + (row + r) * HEAD_ROOM;
            put16(out, _mm512_mul_ps(first, scale));
            put16(out + LANES, _mm512_mul_ps(last, scale));
        }
}

/* out = before + sums + bias, a strip of rows */
TARGET static void add_strip(const float* before, const float* sums, const float* bias, float* out) {
    for (size_t i = 0; i < STRIP * WIDTH; i += LANES) {
        const __m512 more = _mm512_add_ps(_mm512_load_ps(sums + i), _mm512_loadu_ps(bias + i % WIDTH));
        _mm512_store_ps(out + i, _mm512_add_ps(_mm512_load_ps(before + i), more));
    }
}

TARGET static void feed_forward(encoder_work* work, const layer_weights* w, layer_kept* kept, size_t row) {
    float* sums = work->strip;
    bf16* hidden = kept->hidden + row * BETWEEN;
    multiply(&(product){kept->norm2.y + row * WIDTH, WIDTH, w->ff1, BETWEEN, WIDTH, sums, BETWEEN}, STRIP, BETWEEN, 0);
    for (size_t i = 0; i < STRIP * BETWEEN; i += LANES) {
        const __m512 sum = _mm512_add_ps(_mm512_load_ps(sums + i), _mm512_loadu_ps(w->ff1_bias + i % BETWEEN));
        put16(hidden + i, _mm512_max_ps(sum, _mm512_setzero_ps()));
    }
    multiply(&(product){hidden, BETWEEN, w->ff2, WIDTH, BETWEEN, sums, WIDTH}, STRIP, WIDTH, 0);
    add_strip(kept->norm2.x + row * WIDTH, sums, w->ff2_bias, work->x + row * WIDTH);
}

TARGET void lab_encoder_layer_forward(dm_lab_encoder* encoder, const layer_weights* w, layer_kept* kept) {
    encoder_work* work = &encoder->work;
    float* sums = work->strip;
    memcpy(kept->norm1.x, work->x, sizeof work->x);
    norm_forward(w->norm1, w->norm1_bias, &kept->norm1);
    for (size_t row = 0; row < ROWS; row += STRIP) {
        multiply(&(product){kept->norm1.y + row * WIDTH, WIDTH, w->qkv, PACKED, WIDTH, sums, PACKED}, STRIP, PACKED, 0);
        put_heads(sums, w->qkv_bias, kept, row);
    }
    lab_encoder_attend(encoder, kept);
    for (size_t row = 0; row < ROWS; row += STRIP) {
        multiply(&(product){kept->mixed + row * WIDTH, WIDTH, w->out, WIDTH, WIDTH, sums, WIDTH}, STRIP, WIDTH, 0);
        add_strip(kept->norm1.x + row * WIDTH, sums, w->out_bias, kept->norm2.x + row * WIDTH);
    }
    norm_forward(w->norm2, w->norm2_bias, &kept->norm2);
    for (size_t row = 0; row < ROWS; row += STRIP) feed_forward(work, w, kept, row);
}

TARGET static void round_all(const float* from, bf16* out) {
    for (size_t i = 0; i < ROWS * WIDTH; i += LANES) put16(out + i, _mm512_load_ps(from + i));
}

TARGET static void feed_forward_backward(encoder_work* work, const layer_weights* w, const layer_gradients* g,
                                         const layer_kept* kept) {
    round_all(work->x, work->rounded);
    add_gradients(work, work->rounded, WIDTH, kept->hidden, BETWEEN, g->ff2, g->ff2_bias);
    for (size_t row = 0; row < ROWS; row += STRIP) {
        multiply(&(product){work->rounded + row * WIDTH, WIDTH, w->ff2_back, BETWEEN, WIDTH, work->strip, BETWEEN},
                 STRIP, BETWEEN, 0);
        for (size_t i = 0; i < STRIP * BETWEEN; i += LANES) {
            const __m512 hidden = get16(kept->hidden + row * BETWEEN + i);
            const __mmask16 on = _mm512_cmp_ps_mask(hidden, _mm512_setzero_ps(), _CMP_GT_OQ);
            put16(work->hidden + row * BETWEEN + i, _mm512_maskz_mov_ps(on, _mm512_load_ps(work->strip + i)));
        }
    }
    add_gradients(work, work->hidden, BETWEEN, kept->norm2.y, WIDTH, g->ff1, g->ff1_bias);
    multiply(&(product){work->hidden, BETWEEN, w->ff1_back, WIDTH, BETWEEN, work->back, WIDTH}, ROWS, WIDTH, 0);
    norm_backward(&kept->norm2, w->norm2, work->back, work->x, g->norm2, g->norm2_bias);
}

/* A strip's rows to work.mixed, head by head. */
TARGET static void part_heads(encoder_work* work, size_t row) {
    const __mmask16 rest = (1u << (HEAD - LANES)) - 1u;
    for (size_t r = 0; r < STRIP; r++)
        for (size_t head = 0; head < HEADS; head++) {
            const float* from = work->strip + r * WIDTH + head * HEAD;
            bf16* out = work->mixed[head] + (row + r) * HEAD_ROOM;
            put16(out, _mm512_loadu_ps(from));
            put16(out + LANES, _mm512_maskz_loadu_ps(rest, from + LANES));
        }
}

TARGET void lab_encoder_layer_backward(dm_lab_encoder* encoder, const layer_weights* w, const layer_gradients* g,
                                       const layer_kept* kept) {
    encoder_work* work = &encoder->work;
    feed_forward_backward(work, w, g, kept);
    round_all(work->x, work->rounded);
    add_gradients(work, work->rounded, WIDTH, kept->mixed, WIDTH, g->out, g->out_bias);
    for (size_t row = 0; row < ROWS; row += STRIP) {
        multiply(&(product){work->rounded + row * WIDTH, WIDTH, w->out_back, WIDTH, WIDTH, work->strip, WIDTH}, STRIP,
                 WIDTH, 0);
        part_heads(work, row);
    }
    lab_encoder_attend_backward(encoder, kept);
    add_gradients(work, work->qkv, PACKED, kept->norm1.y, WIDTH, g->qkv, g->qkv_bias);
    multiply(&(product){work->qkv, PACKED, w->qkv_back, WIDTH, PACKED, work->back, WIDTH}, ROWS, WIDTH, 0);
    norm_backward(&kept->norm1, w->norm1, work->back, work->x, g->norm1, g->norm1_bias);
}
#endif
