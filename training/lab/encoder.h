/* KPP-Net's point encoder (paper §3.5; docs/networks.md) forwards and backwards, for training on processors that
 * multiply pairs of bf16 (AMX tiles, or AVX-512 BF16): several times as fast as PyTorch on one core. Products are of
 * bf16, sums and everything else float. The size is the `game` one: 96 wide, 4 heads, 192 between, points' MLP 17 to 64
 * to 96. */
#ifndef DM_LAB_ENCODER_H
#define DM_LAB_ENCODER_H

#include "dragmesh_lab.h"

#define DM_LAB_ENCODER_POINT_TENSORS 4  /* weight and bias of the points' two layers */
#define DM_LAB_ENCODER_LAYER_TENSORS 12 /* norm1, qkv, out, norm2, ff1, ff2: weight and bias of each */

typedef struct dm_lab_encoder dm_lab_encoder;

/* Returns whether the processor and the operating system support it (AMX tiles, or AVX-512 BF16). */
DM_API int dm_lab_encoder_available(void);

/* tokens: groups of 16 points a case, even and at most 48; layers: at most 3; batch: most cases at a time. NULL: not
 * available, out of range or out of memory. */
DM_API dm_lab_encoder* dm_lab_encoder_make(uint32_t tokens, uint32_t layers, uint32_t batch);
DM_API void dm_lab_encoder_free(dm_lab_encoder* encoder);

/* Reads the weights, as PyTorch lays them out and in its order, and says where backward adds the gradients. To be
 * called before each step; both must live until the step has ended. */
DM_API void dm_lab_encoder_bind(dm_lab_encoder* encoder, const float* const* weights, float* const* gradients);

/* points: count x tokens x 16 x 17; positions and out: count x tokens x 96. out: of the last layer, before the norm. */
DM_API void dm_lab_encoder_forward(dm_lab_encoder* encoder, uint32_t count, const float* points, const float* positions,
                                   float* out);
/* Of the batch that was last given forwards. Adds to the bound gradients; out_positions: gradient of the positions. */
DM_API void dm_lab_encoder_backward(dm_lab_encoder* encoder, uint32_t count, const float* gradient,
                                    float* out_positions);

#endif
