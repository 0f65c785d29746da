/* Traces wide trees by eight lanes of AVX2 for boxes, four for triangles. */
#include "base/compiler.h"
#include "base/cpu.h"

#if defined(__x86_64__)
#include <immintrin.h>

#define TARGET DMI_TARGET("avx2,fma")
#include "pick/wide_trace.h"

TARGET_INLINE uint32_t enter_node(const dmi_wide_node* node, const traced_ray* ray, float out_near[DMI_WIDE]) {
    __m256 near = _mm256_setzero_ps(), far = _mm256_set1_ps(ray->far);
    for (int k = 0; k < 3; k++) {
        const __m256 origin = _mm256_set1_ps(ray->origin[k]), inverse = _mm256_set1_ps(ray->inverse[k]);
        const __m256 low = _mm256_load_ps(node->planes[ray->near_plane[k]]);
        const __m256 high = _mm256_load_ps(node->planes[ray->far_plane[k]]);
        /* 0 times infinity is NaN, which leaves the second operand: the ray runs in the plane. */
        near = _mm256_max_ps(_mm256_mul_ps(_mm256_sub_ps(low, origin), inverse), near);
        const __m256 end = _mm256_mul_ps(_mm256_sub_ps(high, origin), inverse);
        far = _mm256_min_ps(_mm256_mul_ps(end, _mm256_set1_ps(FAR_SLACK)), far);
    }
    _mm256_storeu_ps(out_near, near);
    return (uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(near, far, _CMP_LE_OQ));
}

/* Coordinate of a corner of four triangles, seen from the ray's origin. */
TARGET_INLINE __m128 from_origin(const dmi_triangle_block* block, const traced_ray* ray, int corner, int axis) {
    return _mm_sub_ps(_mm_load_ps(block->corner[corner][ray->axis[axis]]), _mm_set1_ps(ray->origin[ray->axis[axis]]));
}

TARGET_INLINE uint32_t test_block(const dmi_triangle_block* block, const traced_ray* ray, block_test* out) {
    const __m128 shear_x = _mm_set1_ps(ray->shear[0]), shear_y = _mm_set1_ps(ray->shear[1]);
    __m128 x[3], y[3];
    for (int c = 0; c < 3; c++) {
        const __m128 z = from_origin(block, ray, c, 2);
        x[c] = _mm_sub_ps(from_origin(block, ray, c, 0), _mm_mul_ps(shear_x, z));
        y[c] = _mm_sub_ps(from_origin(block, ray, c, 1), _mm_mul_ps(shear_y, z));
    }
    __m128 least = _mm_set1_ps(INFINITY), most = _mm_set1_ps(-INFINITY);
    for (int c = 0; c < 3; c++) {
        const int n = (c + 1) % 3, p = (c + 2) % 3;
        const __m128 edge = _mm_sub_ps(_mm_mul_ps(x[p], y[n]), _mm_mul_ps(y[p], x[n]));
        _mm_store_ps(out->edge[c], edge);
        least = _mm_min_ps(edge, least);
        most = _mm_max_ps(edge, most);
    }
    const __m128 zero = _mm_setzero_ps();
    return (uint32_t)(_mm_movemask_ps(_mm_cmple_ps(zero, least)) | _mm_movemask_ps(_mm_cmple_ps(most, zero)));
}

bool dmi_wide_trace_avx2(const dmi_wide_tree* tree, const dmi_part_ray* ray, dmi_part_hit* out_hit) {
    return trace_tree(tree, ray, out_hit);
}

void dmi_scene_trace_avx2(const dmi_top_tree* tree, const dm_ray* host_ray, dm_hit* out_hit) {
    trace_scene(tree, host_ray, out_hit);
}

#endif
