/* Applies a pose to many points as a 3x4 matrix, by one kernel for each instruction set.
 *
 * Every kernel reads all it needs of a block before it writes, so that src may be dst. */
#include "math/dual_quat.h"

#include <stdbool.h>
#include <string.h>

#include "base/compiler.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#define PACKED (3 * sizeof(float)) /* bytes from one packed point to the next */

/* m: 4x4, column-major. A loop that compilers vectorise by themselves (NEON included) where src and dst lie apart: the
 * matrix is copied to variables, because dst might alias it. */
static void apply_packed(const float m[16], const float* src, float* dst, size_t count) {
    const float xx = m[0], xy = m[1], xz = m[2], yx = m[4], yy = m[5], yz = m[6], zx = m[8], zy = m[9], zz = m[10];
    const float tx = m[12], ty = m[13], tz = m[14];
    for (size_t i = 0; i < count; i++) {
        const float x = src[3 * i], y = src[3 * i + 1], z = src[3 * i + 2];
        dst[3 * i] = xx * x + yx * y + zx * z + tx;
        dst[3 * i + 1] = xy * x + yy * y + zy * z + ty;
        dst[3 * i + 2] = xz * x + yz * y + zz * z + tz;
    }
}

/* Any strides, also those that leave points off a float's alignment. */
static void apply_strided(const float m[16], const char* src, size_t src_stride, char* dst, size_t dst_stride,
                          size_t count) {
    for (size_t i = 0; i < count; i++) {
        float p[3], q[3];
        memcpy(p, src + i * src_stride, sizeof p);
        apply_packed(m, p, q, 1);
        memcpy(dst + i * dst_stride, q, sizeof q);
    }
}

#if defined(__x86_64__)

typedef struct xyz8 {
    __m256 x, y, z;
} xyz8;

#define AVX2 DMI_TARGET("avx2,fma")

/* Eight packed points as three registers of one coordinate each, the points of a half in the order 0 3 2 1, and back.
 * The low halves hold points 0-3, the high ones 4-7: first as a = x0 y0 z0 x1, b = y1 z1 x2 y2, c = z2 x3 y3 z3, where
 * no two of a coordinate share a lane, so that blends (which every port does) collect them. */
AVX2 static inline xyz8 load_8(const float* p) {
    const __m256 first = _mm256_loadu_ps(p), second = _mm256_loadu_ps(p + 8), third = _mm256_loadu_ps(p + 16);
    const __m256 a = _mm256_blend_ps(first, second, 0xf0);
    const __m256 b = _mm256_permute2f128_ps(first, third, 0x21);
    const __m256 c = _mm256_blend_ps(second, third, 0xf0);
    const __m256 x = _mm256_blend_ps(_mm256_blend_ps(a, b, 0x44), c, 0x22); /* 0 3 2 1 */
    const __m256 y = _mm256_blend_ps(_mm256_blend_ps(b, a, 0x22), c, 0x44); /* 1 0 3 2 */
    const __m256 z = _mm256_blend_ps(_mm256_blend_ps(c, b, 0x22), a, 0x44); /* 2 1 0 3 */
    return (xyz8){x, _mm256_permute_ps(y, _MM_SHUFFLE(0, 3, 2, 1)), _mm256_permute_ps(z, _MM_SHUFFLE(1, 0, 3, 2))};
}

AVX2 static inline void store_8(float* p, xyz8 v) {
    const __m256 x = v.x;
    const __m256 y = _mm256_permute_ps(v.y, _MM_SHUFFLE(2, 1, 0, 3)),
                 z = _mm256_permute_ps(v.z, _MM_SHUFFLE(1, 0, 3, 2));
    const __m256 a = _mm256_blend_ps(_mm256_blend_ps(x, y, 0x22), z, 0x44);
    const __m256 b = _mm256_blend_ps(_mm256_blend_ps(y, z, 0x22), x, 0x44);
    const __m256 c = _mm256_blend_ps(_mm256_blend_ps(z, x, 0x22), y, 0x44);
    _mm256_storeu_ps(p, _mm256_insertf128_ps(a, _mm256_castps256_ps128(b), 1));
    _mm256_storeu_ps(p + 8, _mm256_blend_ps(c, a, 0xf0));
    _mm256_storeu_ps(p + 16, _mm256_permute2f128_ps(b, c, 0x31));
}

/* The matrix in registers, because the compiler must assume that written points alias it. */
typedef struct matrix_8 {
    __m256 x[3], y[3], z[3], t[3];
} matrix_8;

AVX2 static inline matrix_8 broadcast_8(const float m[16]) {
    matrix_8 out;
    for (int row = 0; row < 3; row++) {
        out.x[row] = _mm256_set1_ps(m[row]);
        out.y[row] = _mm256_set1_ps(m[4 + row]);
        out.z[row] = _mm256_set1_ps(m[8 + row]);
        out.t[row] = _mm256_set1_ps(m[12 + row]);
    }
    return out;
}

AVX2 static inline __m256 row_8(const matrix_8* m, int row, xyz8 p) {
    const __m256 sum = _mm256_fmadd_ps(m->y[row], p.y, _mm256_fmadd_ps(m->z[row], p.z, m->t[row]));
    return _mm256_fmadd_ps(m->x[row], p.x, sum);
}

AVX2 static void apply_packed_avx2(const float m[16], const float* src, float* dst, size_t count) {
    const matrix_8 matrix = broadcast_8(m);
    size_t i = 0;
    for (; i + 8 <= count; i += 8) {
        const xyz8 p = load_8(src + 3 * i);
        store_8(dst + 3 * i, (xyz8){row_8(&matrix, 0, p), row_8(&matrix, 1, p), row_8(&matrix, 2, p)});
    }
    apply_packed(m, src + 3 * i, dst + 3 * i, count - i);
}

/* One point at a time, the matrix's columns in registers; the bytes between the points are not touched. */
AVX2 static void apply_strided_avx2(const float m[16], const char* src, size_t src_stride, char* dst, size_t dst_stride,
                                    size_t count) {
    const __m128 column[4] = {_mm_loadu_ps(m), _mm_loadu_ps(m + 4), _mm_loadu_ps(m + 8), _mm_loadu_ps(m + 12)};
    for (size_t i = 0; i < count; i++, src += src_stride, dst += dst_stride) {
        float p[3], z;
        memcpy(p, src, sizeof p);
        __m128 q = _mm_fmadd_ps(column[2], _mm_set1_ps(p[2]), column[3]);
        q = _mm_fmadd_ps(column[1], _mm_set1_ps(p[1]), q);
        q = _mm_fmadd_ps(column[0], _mm_set1_ps(p[0]), q);
        _mm_storel_pi((__m64*)(void*)dst, q);
        _mm_store_ss(&z, _mm_movehl_ps(q, q));
        memcpy(dst + 2 * sizeof(float), &z, sizeof z);
    }
}

#define AVX512 DMI_TARGET("avx512f,avx512bw,avx512dq,avx512vl,fma")

/* Which of the 32 floats of two registers goes to each place of a third. */
typedef struct pick {
    __m512i first, second;
} pick;

AVX512 static inline __m512 row_16(const float m[16], int row, __m512 x, __m512 y, __m512 z) {
    __m512 sum = _mm512_fmadd_ps(_mm512_set1_ps(m[8 + row]), z, _mm512_set1_ps(m[12 + row]));
    sum = _mm512_fmadd_ps(_mm512_set1_ps(m[4 + row]), y, sum);
    return _mm512_fmadd_ps(_mm512_set1_ps(m[row]), x, sum);
}

/* first picks of (a, b), second of (that, c). */
AVX512 static inline __m512 permute_3(pick p, __m512 a, __m512 b, __m512 c) {
    return _mm512_permutex2var_ps(_mm512_permutex2var_ps(a, p.first, b), p.second, c);
}

/* Places in 48 packed floats of coordinate `axis` of 16 points, split over the three registers. */
AVX512 static pick gather_pick(int axis) {
    int first[16], second[16];
    for (int i = 0; i < 16; i++) {
        const int place = 3 * i + axis;
        first[i] = place < 32 ? place : 0;
        second[i] = place < 32 ? i : place - 16; /* 16.. names the third register */
    }
    return (pick){_mm512_loadu_si512(first), _mm512_loadu_si512(second)};
}

/* The other way: register `part` of the 48 packed floats from x, y (first) and z (second). */
AVX512 static pick scatter_pick(int part) {
    int first[16], second[16];
    for (int i = 0; i < 16; i++) {
        const int place = 16 * part + i, point = place / 3, axis = place % 3;
        first[i] = axis == 1 ? 16 + point : point;
        second[i] = axis == 2 ? 16 + point : i;
    }
    return (pick){_mm512_loadu_si512(first), _mm512_loadu_si512(second)};
}

AVX512 static void apply_packed_avx512(const float m[16], const float* src, float* dst, size_t count) {
    const pick get_x = gather_pick(0), get_y = gather_pick(1), get_z = gather_pick(2);
    const pick put[3] = {scatter_pick(0), scatter_pick(1), scatter_pick(2)};
    size_t i = 0;
    for (; i + 16 <= count; i += 16) {
        const float* p = src + 3 * i;
        const __m512 a = _mm512_loadu_ps(p), b = _mm512_loadu_ps(p + 16), c = _mm512_loadu_ps(p + 32);
        const __m512 x = permute_3(get_x, a, b, c), y = permute_3(get_y, a, b, c), z = permute_3(get_z, a, b, c);
        const __m512 u = row_16(m, 0, x, y, z), v = row_16(m, 1, x, y, z), w = row_16(m, 2, x, y, z);
        for (size_t k = 0; k < 3; k++) _mm512_storeu_ps(dst + 3 * i + 16 * k, permute_3(put[k], u, v, w));
    }
    apply_packed_avx2(m, src + 3 * i, dst + 3 * i, count - i);
}

#endif

void dmi_pose_apply_points_isa(dmi_isa isa, const dm_pose* pose, const float* src, size_t src_stride, float* dst,
                               size_t dst_stride, size_t count) {
    float m[16];
    dmi_pose_to_matrix(pose, m);
    if (src_stride == 0) src_stride = PACKED;
    if (dst_stride == 0) dst_stride = PACKED;
    const bool packed = src_stride == PACKED && dst_stride == PACKED;
#if defined(__x86_64__)
    if (isa == DMI_ISA_AVX512 && packed) {
        apply_packed_avx512(m, src, dst, count);
        return;
    }
    if (dmi_isa_has_avx2(isa)) {
        if (packed) {
            apply_packed_avx2(m, src, dst, count);
        } else {
            apply_strided_avx2(m, (const char*)src, src_stride, (char*)dst, dst_stride, count);
        }
        return;
    }
#else
    (void)isa;
#endif
    if (packed) {
        apply_packed(m, src, dst, count);
    } else {
        apply_strided(m, (const char*)src, src_stride, (char*)dst, dst_stride, count);
    }
}

void dmi_pose_apply_points(const dm_pose* pose, const float* src, size_t src_stride, float* dst, size_t dst_stride,
                           size_t count) {
    dmi_pose_apply_points_isa(dmi_cpu_best_isa(), pose, src, src_stride, dst, dst_stride, count);
}
