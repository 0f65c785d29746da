/* Products of bf16 matrices on AMX tiles, or in registers where the processor has no tiles, and the two layouts of
 * their operands. For the encoder's files alone.
 *
 * A product's left operand lies row by row; the right one in pairs of rows: the dword in row k, column n holds the
 * numbers of rows 2k (low half) and 2k + 1 of that column. */
#ifndef DM_LAB_ENCODER_TILES_H
#define DM_LAB_ENCODER_TILES_H

#include <immintrin.h>
#include <stddef.h>
#include <stdint.h>

#define TARGET __attribute__((target("amx-tile,amx-bf16,avx512f,avx512bw,avx512dq,avx512vl,avx512bf16")))
#define TARGET_INLINE TARGET __attribute__((always_inline)) static inline
#define ALIGNED _Alignas(64)
#define LANES 16       /* floats in a register; rows and columns of a tile of sums */
#define DEPTH 32       /* bf16 in a tile's row */
#define ROWS_AT_ONCE 8 /* of sums in registers, two registers each; divides LANES */

typedef uint16_t bf16;

TARGET_INLINE __m256i rounded16(__m512 v) {
    const __m256bh halves = _mm512_cvtneps_pbh(v);
    __m256i bits;
    __builtin_memcpy(&bits, &halves, sizeof bits);
    return bits;
}

TARGET_INLINE void put16(bf16* out, __m512 v) {
    _mm256_storeu_si256((__m256i*)out, rounded16(v));
}

TARGET_INLINE void put8(bf16* out, __m512 v) {
    _mm_storeu_si128((__m128i*)out, _mm256_castsi256_si128(rounded16(v)));
}

TARGET_INLINE __m512 widened16(__m256i halves) {
    return _mm512_castsi512_ps(_mm512_slli_epi32(_mm512_cvtepu16_epi32(halves), 16));
}

TARGET_INLINE __m512 get16(const bf16* in) {
    return widened16(_mm256_loadu_si256((const __m256i*)in));
}

/* Whether this process may use tiles; set by dm_lab_encoder_available. */
extern int lab_encoder_has_tiles;

/* Every tile full: 16 rows of 64 bytes. Of this thread, until tiles_off. */
TARGET_INLINE void tiles_on(void) {
    if (!lab_encoder_has_tiles) return;
    ALIGNED const struct {
        uint8_t palette, start, zeros[14];
        uint16_t bytes[16];
        uint8_t rows[16];
    } shape = {1, 0, {0}, {64, 64, 64, 64, 64, 64, 64, 64}, {16, 16, 16, 16, 16, 16, 16, 16}};
    _tile_loadconfig(&shape);
}

TARGET_INLINE void tiles_off(void) {
    if (!lab_encoder_has_tiles) return;
    _tile_release();
}

/* A product's operands: left with `left_stride` bf16 a row, right with `right_stride` dwords a row of pairs, sums with
 * `out_stride` floats a row. depth: a multiple of DEPTH. */
typedef struct product {
    const bf16* left;
    size_t left_stride;
    const uint32_t* right;
    size_t right_stride, depth;
    float* out;
    size_t out_stride;
} product;

/* One or two tiles of sums down and across, constants where it is inlined. add: to what is in `out`. */
TARGET_INLINE void tiles_of_sums(const product* p, size_t row, size_t column, int add, const int two_down,
                                 const int two_across) {
    const bf16* left = p->left + row * p->left_stride;
    const uint32_t* right = p->right + column;
    float* out = p->out + row * p->out_stride + column;
    float* below = out + LANES * p->out_stride;
    const size_t out_bytes = p->out_stride * sizeof(float), left_bytes = p->left_stride * sizeof(bf16);
    const size_t right_bytes = p->right_stride * sizeof(uint32_t);
    _tile_zero(0);
    _tile_zero(1);
    _tile_zero(2);
    _tile_zero(3);
    if (add) {
        _tile_loadd(0, out, out_bytes);
        if (two_across) _tile_loadd(1, out + LANES, out_bytes);
        if (two_down) _tile_loadd(2, below, out_bytes);
        if (two_down && two_across) _tile_loadd(3, below + LANES, out_bytes);
    }
    for (size_t k = 0; k < p->depth; k += DEPTH, right += DEPTH / 2 * p->right_stride) {
        _tile_loadd(4, left + k, left_bytes);
        _tile_loadd(6, right, right_bytes);
        _tile_dpbf16ps(0, 4, 6);
        if (two_across) _tile_loadd(7, right + LANES, right_bytes);
        if (two_across) _tile_dpbf16ps(1, 4, 7);
        if (two_down) _tile_loadd(5, left + LANES * p->left_stride + k, left_bytes);
        if (two_down) _tile_dpbf16ps(2, 5, 6);
        if (two_down && two_across) _tile_dpbf16ps(3, 5, 7);
    }
    _tile_stored(0, out, out_bytes);
    if (two_across) _tile_stored(1, out + LANES, out_bytes);
    if (two_down) _tile_stored(2, below, out_bytes);
    if (two_down && two_across) _tile_stored(3, below + LANES, out_bytes);
}

TARGET_INLINE __m512bh pairs_at(const uint32_t* at) {
    const __m512i bits = _mm512_loadu_si512(at);
    __m512bh pairs;
    __builtin_memcpy(&pairs, &bits, sizeof pairs);
    return pairs;
}

/* The pair of numbers at `at` in every lane. */
TARGET_INLINE __m512bh spread_pair(const bf16* at) {
    int32_t pair;
    __builtin_memcpy(&pair, at, sizeof pair);
    const __m512i bits = _mm512_set1_epi32(pair);
    __m512bh pairs;
    __builtin_memcpy(&pairs, &bits, sizeof pairs);
    return pairs;
}

/* ROWS_AT_ONCE rows of LANES or twice as many sums. */
TARGET_INLINE void registers_of_sums(const product* p, size_t row, size_t column, int add, const int two_across) {
    const bf16* left = p->left + row * p->left_stride;
    const uint32_t* right = p->right + column;
    float* out = p->out + row * p->out_stride + column;
    __m512 sum[ROWS_AT_ONCE][2];
    for (size_t i = 0; i < ROWS_AT_ONCE; i++) {
        sum[i][0] = add ? _mm512_loadu_ps(out + i * p->out_stride) : _mm512_setzero_ps();
        sum[i][1] = add && two_across ? _mm512_loadu_ps(out + i * p->out_stride + LANES) : _mm512_setzero_ps();
    }
    for (size_t k = 0; k < p->depth; k += 2, right += p->right_stride) {
        const __m512bh first = pairs_at(right), second = two_across ? pairs_at(right + LANES) : first;
        for (size_t i = 0; i < ROWS_AT_ONCE; i++) {
            const __m512bh pair = spread_pair(left + i * p->left_stride + k);
            sum[i][0] = _mm512_dpbf16_ps(sum[i][0], pair, first);
            if (two_across) sum[i][1] = _mm512_dpbf16_ps(sum[i][1], pair, second);
        }
    }
    for (size_t i = 0; i < ROWS_AT_ONCE; i++) {
        _mm512_storeu_ps(out + i * p->out_stride, sum[i][0]);
        if (two_across) _mm512_storeu_ps(out + i * p->out_stride + LANES, sum[i][1]);
    }
}

TARGET static inline void multiply_in_registers(const product* p, size_t rows, size_t columns, int add) {
    for (size_t row = 0; row < rows; row += ROWS_AT_ONCE)
        for (size_t column = 0; column < columns; column += 2 * LANES) {
            if (column + LANES < columns)
                registers_of_sums(p, row, column, add, 1);
            else
                registers_of_sums(p, row, column, add, 0);
        }
}

/* rows, columns: multiples of LANES. */
TARGET static inline void multiply(const product* p, size_t rows, size_t columns, int add) {
    if (!lab_encoder_has_tiles) {
        multiply_in_registers(p, rows, columns, add);
        return;
    }
    for (size_t row = 0; row < rows; row += 2 * LANES)
        for (size_t column = 0; column < columns; column += 2 * LANES) {
            const int two_down = row + LANES < rows, two_across = column + LANES < columns;
            if (two_down && two_across) tiles_of_sums(p, row, column, add, 1, 1);
            if (two_down && !two_across) tiles_of_sums(p, row, column, add, 1, 0);
            if (!two_down && two_across) tiles_of_sums(p, row, column, add, 0, 1);
            if (!two_down && !two_across) tiles_of_sums(p, row, column, add, 0, 0);
        }
}

/* Rows side by side in pairs. rows: even; columns: a multiple of LANES. */
TARGET static inline void pair_rows(const bf16* from, size_t stride, size_t rows, size_t columns, uint32_t* out) {
    for (size_t r = 0; r < rows; r += 2, from += 2 * stride, out += columns)
        for (size_t c = 0; c < columns; c += LANES) {
            const __m512i even = _mm512_cvtepu16_epi32(_mm256_loadu_si256((const __m256i*)(from + c)));
            const __m512i odd = _mm512_cvtepu16_epi32(_mm256_loadu_si256((const __m256i*)(from + stride + c)));
            _mm512_storeu_si512(out + c, _mm512_or_si512(even, _mm512_slli_epi32(odd, 16)));
        }
}

TARGET_INLINE void transpose_tile(const uint32_t* from, size_t stride, uint32_t* out, size_t out_stride) {
    __m512i r[LANES], t[LANES];
    for (size_t i = 0; i < LANES; i++) r[i] = _mm512_loadu_si512(from + i * stride);
    for (size_t i = 0; i < LANES; i += 2) {
        t[i] = _mm512_unpacklo_epi32(r[i], r[i + 1]);
        t[i + 1] = _mm512_unpackhi_epi32(r[i], r[i + 1]);
    }
    for (size_t i = 0; i < LANES; i += 4) {
        r[i] = _mm512_unpacklo_epi64(t[i], t[i + 2]);
        r[i + 1] = _mm512_unpackhi_epi64(t[i], t[i + 2]);
        r[i + 2] = _mm512_unpacklo_epi64(t[i + 1], t[i + 3]);
        r[i + 3] = _mm512_unpackhi_epi64(t[i + 1], t[i + 3]);
    }
    for (size_t i = 0; i < 4; i++) {
        t[i] = _mm512_shuffle_i32x4(r[i], r[i + 4], 0x88);
        t[i + 4] = _mm512_shuffle_i32x4(r[i], r[i + 4], 0xdd);
        t[i + 8] = _mm512_shuffle_i32x4(r[i + 8], r[i + 12], 0x88);
        t[i + 12] = _mm512_shuffle_i32x4(r[i + 8], r[i + 12], 0xdd);
    }
    for (size_t i = 0; i < 8; i++) {
        _mm512_storeu_si512(out + i * out_stride, _mm512_shuffle_i32x4(t[i], t[i + 8], 0x88));
        _mm512_storeu_si512(out + (i + 8) * out_stride, _mm512_shuffle_i32x4(t[i], t[i + 8], 0xdd));
    }
}

/* Of dwords. rows, columns: multiples of LANES; the result's rows lie side by side. */
TARGET static inline void transpose(const uint32_t* from, size_t rows, size_t columns, uint32_t* out) {
    for (size_t r = 0; r < rows; r += LANES)
        for (size_t c = 0; c < columns; c += LANES)
            transpose_tile(from + r * columns + c, columns, out + c * rows + r, rows);
}

/* Of bf16: pairs of rows (as pair_rows lays them) to the transposed matrix. */
TARGET static inline void turn_pairs(const uint32_t* pairs, size_t rows, size_t columns, bf16* out) {
    transpose(pairs, rows / 2, columns, (uint32_t*)(void*)out);
}

#endif
