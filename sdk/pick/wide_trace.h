/* The ways of a ray through a wide tree and through a scene, shared by the instruction sets (wide_trace_plain.c,
 * wide_trace_avx2.c). They define TARGET, the attributes of a function of their instruction set, and the functions
 * enter_node and test_block, which are declared below. All give the same bits: no multiplication is contracted with an
 * addition.
 *
 * Boxes are tested after Ize 2013 ("Robust BVH ray traversal"), triangles after Woop, Benthin and Wald 2013
 * ("Watertight ray/triangle intersection"): a ray never slips between two triangles that share an edge. */
#ifndef DMI_PICK_WIDE_TRACE_H
#define DMI_PICK_WIDE_TRACE_H

#include <math.h>

#include "base/compiler.h"
#include "pick/placed_hit.h"
#include "pick/wide_tree.h"

/* Bound of the rounding of a slab's far end, relative: 1 + 2 gamma(3) and a bit. */
#define FAR_SLACK 1.0000005f
#define MOST_STACKED ((DMI_WIDE - 1) * DMI_MOST_LEVELS + 1)

typedef struct traced_ray {
    float origin[3], inverse[3];          /* inverse: that of the direction; infinities are fine */
    float far;                            /* the nearest hit so far */
    uint32_t near_plane[3], far_plane[3]; /* planes of a node, by axis */
    /* The axis of the direction's largest component last, the other two in an order that keeps the winding; how far a
     * step along it shifts the other two, and its own scale. */
    int axis[3];
    float shear[3];
} traced_ray;

/* Edge functions of four triangles: twice the areas seen along the ray, opposite corner a, b, c. */
typedef struct block_test {
    _Alignas(16) float edge[3][DMI_BLOCK];
} block_test;

typedef struct stacked {
    float near;
    uint32_t reference;
} stacked;

/* Returns the mask of the children that the ray enters before ray->far, and where it enters each. */
TARGET_INLINE uint32_t enter_node(const dmi_wide_node* node, const traced_ray* ray, float out_near[DMI_WIDE]);
/* Returns the mask of the triangles whose edges do not tell that the ray misses: few are left. */
TARGET_INLINE uint32_t test_block(const dmi_triangle_block* block, const traced_ray* ray, block_test* out);

/* Sets what boxes are tested with. */
TARGET_INLINE void set_slabs(traced_ray* ray, const float origin[3], const float direction[3]) {
    for (int k = 0; k < 3; k++) {
        ray->origin[k] = origin[k];
        ray->inverse[k] = 1 / direction[k];
        const uint32_t back = signbit(ray->inverse[k]) ? 3 : 0;
        ray->near_plane[k] = (uint32_t)k + back;
        ray->far_plane[k] = (uint32_t)k + (3 - back);
    }
}

TARGET static traced_ray start_ray(const dmi_part_ray* ray) {
    traced_ray r = {.far = ray->far};
    int z = 0;
    set_slabs(&r, ray->origin, ray->direction);
    for (int k = 1; k < 3; k++) {
        if (fabsf(ray->direction[k]) > fabsf(ray->direction[z])) z = k;
    }
    const int x = (z + 1) % 3, y = (z + 2) % 3;
    const bool swap = ray->direction[z] < 0;
    r.axis[0] = swap ? y : x;
    r.axis[1] = swap ? x : y;
    r.axis[2] = z;
    r.shear[0] = ray->direction[r.axis[0]] / ray->direction[z];
    r.shear[1] = ray->direction[r.axis[1]] / ray->direction[z];
    r.shear[2] = r.inverse[z];
    return r;
}

/* Computes the edge functions of one triangle anew in doubles, where they are exact enough to tell the side of an edge
 * that the ray seems to touch. */
TARGET static void resolve_edges(const dmi_triangle_block* block, const traced_ray* ray, uint32_t i, double out[3]) {
    float x[3], y[3];
    for (int c = 0; c < 3; c++) {
        const float z = block->corner[c][ray->axis[2]][i] - ray->origin[ray->axis[2]];
        x[c] = (block->corner[c][ray->axis[0]][i] - ray->origin[ray->axis[0]]) - ray->shear[0] * z;
        y[c] = (block->corner[c][ray->axis[1]][i] - ray->origin[ray->axis[1]]) - ray->shear[1] * z;
    }
    for (int c = 0; c < 3; c++) {
        const int n = (c + 1) % 3, p = (c + 2) % 3;
        out[c] = (double)x[p] * (double)y[n] - (double)y[p] * (double)x[n];
    }
}

/* Takes a triangle of a block as the nearest hit if it is. */
TARGET static bool take_hit(const dmi_triangle_block* block, const block_test* test, uint32_t i, traced_ray* ray,
                            dmi_part_hit* out) {
    double edge[3] = {(double)test->edge[0][i], (double)test->edge[1][i], (double)test->edge[2][i]};
    if (edge[0] == 0 || edge[1] == 0 || edge[2] == 0) resolve_edges(block, ray, i, edge);
    if ((edge[0] < 0 || edge[1] < 0 || edge[2] < 0) && (edge[0] > 0 || edge[1] > 0 || edge[2] > 0)) return false;
    const double sum = edge[0] + edge[1] + edge[2];
    if (sum == 0) return false;
    double depth = 0;
    for (int c = 0; c < 3; c++) {
        const float z = block->corner[c][ray->axis[2]][i] - ray->origin[ray->axis[2]];
        depth += edge[c] * (double)(ray->shear[2] * z);
    }
    const double distance = depth / sum;
    if (!(distance >= 0 && distance < (double)ray->far)) return false;
    ray->far = (float)distance;
    *out = (dmi_part_hit){block->face[i], (float)(edge[1] / sum), (float)(edge[2] / sum)};
    return true;
}

TARGET static bool trace_block(const dmi_triangle_block* block, traced_ray* ray, dmi_part_hit* out) {
    block_test test;
    bool hit = false;
    for (uint32_t left = test_block(block, ray, &test); left != 0; left &= left - 1) {
        if (take_hit(block, &test, dmi_trailing_zeros(left), ray, out)) hit = true;
    }
    return hit;
}

/* Finds the nearest child that the ray enters; puts the others on the stack, the nearest of them on top. False where it
 * enters none. Most nodes have one such child: it never is on the stack. */
TARGET_INLINE bool enter_children(const dmi_wide_node* node, const traced_ray* ray, stacked* stack, uint32_t* depth,
                                  stacked* out_nearest) {
    float near[DMI_WIDE];
    const uint32_t bottom = *depth;
    DMI_PREFETCH(node->child); /* its cache line would come after the boxes are tested */
    uint32_t entered = enter_node(node, ray, near);
    if (entered == 0) return false;
    uint32_t child = dmi_trailing_zeros(entered);
    stacked nearest = {near[child], node->child[child]};
    while ((entered &= entered - 1) != 0) {
        child = dmi_trailing_zeros(entered);
        stacked other = {near[child], node->child[child]};
        if (other.near < nearest.near) {
            const stacked passed = nearest;
            nearest = other;
            other = passed;
        }
        uint32_t at = (*depth)++;
        for (; at > bottom && stack[at - 1].near < other.near; at--) stack[at] = stack[at - 1];
        stack[at] = other;
    }
    *out_nearest = nearest;
    return true;
}

/* Takes the top of the stack that begins before `far`; false where there is none. */
TARGET_INLINE bool take_next(const stacked* stack, uint32_t* depth, float far, stacked* out) {
    while (*depth > 0) {
        *out = stack[--*depth];
        if (out->near <= far) return true;
    }
    return false;
}

TARGET static bool trace_tree(const dmi_wide_tree* tree, const dmi_part_ray* part_ray, dmi_part_hit* out) {
    traced_ray ray = start_ray(part_ray);
    stacked stack[MOST_STACKED], item = {0, 0};
    uint32_t depth = 0;
    bool hit = false;
    for (bool more = true; more; more = take_next(stack, &depth, ray.far, &item)) {
        while (!(item.reference & DMI_LEAF) &&
               enter_children(&tree->nodes[item.reference], &ray, stack, &depth, &item)) {
        }
        if (item.reference & DMI_LEAF && trace_block(&tree->blocks[item.reference & ~DMI_LEAF], &ray, out)) hit = true;
    }
    return hit;
}

/* A little more than the distance of a hit: not before the entry of any box with a hit as near. */
TARGET_INLINE float bound_of(const dmi_world_hit* hit) {
    return (float)hit->distance * FAR_SLACK;
}

TARGET static void trace_scene(const dmi_top_tree* tree, const dm_ray* host_ray, dm_hit* out_hit) {
    stacked stack[(DMI_WIDE - 1) * DMI_TOP_MOST_LEVELS + 1], item;
    uint32_t depth = 0;
    dmi_world_ray world;
    dmi_world_hit hit; /* most of it is set by a hit alone: zeros would take as long as a node */
    hit.part = NULL;
    hit.distance = INFINITY;
    if (!dmi_world_ray_start(host_ray, &world)) {
        *out_hit = (dm_hit){0};
        return;
    }
    traced_ray ray = {.far = INFINITY};
    set_slabs(&ray, world.origin_f32, world.direction_f32);
    item = (stacked){0, tree->root};
    bool more = tree->root != DMI_TOP_NONE;
    while (more) {
        if (item.reference & DMI_LEAF) {
            hit_part(dmi_top_tree_item(tree, item.reference & ~DMI_LEAF), &world, item.near, &hit);
            ray.far = bound_of(&hit);
        } else if (enter_children(&tree->nodes[item.reference].wide, &ray, stack, &depth, &item)) {
            continue;
        }
        more = take_next(stack, &depth, ray.far, &item);
    }
    if (hit.part != NULL)
        describe_hit(&world, &hit, out_hit);
    else
        *out_hit = (dm_hit){0};
}

#endif
