/* Traces wide trees by four lanes: SSE2, NEON or plain C. */
#include "pick/lanes.h"

#define TARGET
#include "pick/wide_trace.h"

TARGET_INLINE uint32_t enter_node(const dmi_wide_node* node, const traced_ray* ray, float out_near[DMI_WIDE]) {
    uint32_t mask = 0;
    for (uint32_t first = 0; first < DMI_WIDE; first += 4) {
        dmi_lanes near = dmi_lanes_all(0), far = dmi_lanes_all(ray->far);
        for (int k = 0; k < 3; k++) {
            const dmi_lanes origin = dmi_lanes_all(ray->origin[k]), inverse = dmi_lanes_all(ray->inverse[k]);
            const dmi_lanes low = dmi_lanes_load(node->planes[ray->near_plane[k]] + first);
            const dmi_lanes high = dmi_lanes_load(node->planes[ray->far_plane[k]] + first);
            /* 0 times infinity is NaN, which leaves the second operand: the ray runs in the plane. */
            near = dmi_lanes_max(dmi_lanes_mul(dmi_lanes_sub(low, origin), inverse), near);
            const dmi_lanes end = dmi_lanes_mul(dmi_lanes_sub(high, origin), inverse);
            far = dmi_lanes_min(dmi_lanes_mul(end, dmi_lanes_all(FAR_SLACK)), far);
        }
        dmi_lanes_store(out_near + first, near);
        mask |= dmi_lanes_less_equal(near, far) << first;
    }
    return mask;
}

TARGET_INLINE uint32_t test_block(const dmi_triangle_block* block, const traced_ray* ray, block_test* out) {
    dmi_lanes x[3], y[3];
    for (int c = 0; c < 3; c++) {
        const dmi_lanes z =
            dmi_lanes_sub(dmi_lanes_load(block->corner[c][ray->axis[2]]), dmi_lanes_all(ray->origin[ray->axis[2]]));
        x[c] = dmi_lanes_sub(
            dmi_lanes_sub(dmi_lanes_load(block->corner[c][ray->axis[0]]), dmi_lanes_all(ray->origin[ray->axis[0]])),
            dmi_lanes_mul(dmi_lanes_all(ray->shear[0]), z));
        y[c] = dmi_lanes_sub(
            dmi_lanes_sub(dmi_lanes_load(block->corner[c][ray->axis[1]]), dmi_lanes_all(ray->origin[ray->axis[1]])),
            dmi_lanes_mul(dmi_lanes_all(ray->shear[1]), z));
    }
    dmi_lanes least = dmi_lanes_all(INFINITY), most = dmi_lanes_all(-INFINITY);
    for (int c = 0; c < 3; c++) {
        const int n = (c + 1) % 3, p = (c + 2) % 3;
        const dmi_lanes edge = dmi_lanes_sub(dmi_lanes_mul(x[p], y[n]), dmi_lanes_mul(y[p], x[n]));
        dmi_lanes_store(out->edge[c], edge);
        least = dmi_lanes_min(edge, least);
        most = dmi_lanes_max(edge, most);
    }
    const dmi_lanes zero = dmi_lanes_all(0);
    return dmi_lanes_less_equal(zero, least) | dmi_lanes_less_equal(most, zero);
}

bool dmi_wide_trace_plain(const dmi_wide_tree* tree, const dmi_part_ray* ray, dmi_part_hit* out_hit) {
    return trace_tree(tree, ray, out_hit);
}

void dmi_scene_trace_plain(const dmi_top_tree* tree, const dm_ray* host_ray, dm_hit* out_hit) {
    trace_scene(tree, host_ray, out_hit);
}
