/* What the encoder's files share: its sizes, its weights as operands of products, what a forward pass keeps. */
#ifndef DM_LAB_ENCODER_STATE_H
#define DM_LAB_ENCODER_STATE_H

#include "encoder.h"
#include "encoder_tiles.h"

#define SCORE_SCALE 0.20412414523f /* HEAD^-1/2: of attention's scores, and so of q's gradient; q is kept scaled */

enum {
    WIDTH = 96,
    HEADS = 4,
    HEAD = WIDTH / HEADS,
    HEAD_ROOM = DEPTH, /* a head's numbers with zeros after them */
    BETWEEN = 192,
    PACKED = 3 * WIDTH, /* q, k, v */
    POINT_HIDDEN = 64,
    CHANNELS = 17,
    GROUP = 16,     /* points of a token */
    ROWS = 96,      /* tokens that are worked on at a time: those of two cases or three */
    MOST_KEYS = 64, /* tokens of a case, in steps of DEPTH */
    MOST_LAYERS = 3
};

/* The right operands of x W and of the gradient's way back. */
typedef struct layer_weights {
    const float *norm1, *norm1_bias, *qkv_bias, *out_bias, *norm2, *norm2_bias, *ff1_bias, *ff2_bias;
    ALIGNED uint32_t qkv[WIDTH / 2 * PACKED], out[WIDTH / 2 * WIDTH], ff1[WIDTH / 2 * BETWEEN],
        ff2[BETWEEN / 2 * WIDTH];
    ALIGNED uint32_t qkv_back[PACKED / 2 * WIDTH], out_back[WIDTH / 2 * WIDTH], ff1_back[BETWEEN / 2 * WIDTH],
        ff2_back[WIDTH / 2 * BETWEEN];
} layer_weights;

/* In PyTorch's order. */
typedef struct layer_gradients {
    float *norm1, *norm1_bias, *qkv, *qkv_bias, *out, *out_bias, *norm2, *norm2_bias, *ff1, *ff1_bias, *ff2, *ff2_bias;
} layer_gradients;

typedef struct norm_kept {
    ALIGNED float x[ROWS * WIDTH], mean[ROWS], scale[ROWS]; /* what came in, and what made it even */
    ALIGNED bf16 y[ROWS * WIDTH];
} norm_kept;

typedef struct layer_kept {
    norm_kept norm1, norm2;
    ALIGNED bf16 q[HEADS][ROWS * HEAD_ROOM], k[HEADS][ROWS * HEAD_ROOM], v[HEADS][ROWS * HEAD_ROOM];
    ALIGNED bf16 shares[HEADS][ROWS * MOST_KEYS]; /* of attention: a row a query */
    ALIGNED bf16 mixed[ROWS * WIDTH], hidden[ROWS * BETWEEN];
} layer_kept;

typedef struct unit_kept {
    layer_kept layers[MOST_LAYERS];
    ALIGNED bf16 points[ROWS * GROUP * DEPTH], hidden[ROWS * GROUP * POINT_HIDDEN];
    uint16_t largest[ROWS * GROUP][WIDTH / LANES]; /* bits: where a point has its group's maximum */
} unit_kept;

/* Scratch of one pass. */
typedef struct encoder_work {
    ALIGNED float x[ROWS * WIDTH], back[ROWS * WIDTH], strip[2 * LANES * PACKED];
    ALIGNED bf16 rounded[ROWS * WIDTH], hidden[ROWS * BETWEEN], mixed[HEADS][ROWS * HEAD_ROOM], qkv[ROWS * PACKED];
    ALIGNED uint32_t left_pairs[ROWS / 2 * PACKED], right_pairs[ROWS / 2 * PACKED];
    ALIGNED bf16 turned[PACKED * ROWS];
    ALIGNED float point_gradient[POINT_HIDDEN * DEPTH];
} encoder_work;

struct dm_lab_encoder {
    size_t tokens, padded; /* of a case; padded to tiles */
    size_t keys;           /* padded to DEPTH */
    size_t cases;          /* of a unit */
    size_t layer_count, unit_count;
    layer_weights layers[MOST_LAYERS];
    layer_gradients gradients[MOST_LAYERS];
    const float *point1_bias, *point2_bias;
    float *point1_gradient, *point1_bias_gradient, *point2_gradient, *point2_bias_gradient;
    ALIGNED uint32_t point1[DEPTH / 2 * POINT_HIDDEN], point2[POINT_HIDDEN / 2 * WIDTH],
        point2_back[WIDTH / 2 * POINT_HIDDEN];
    encoder_work work;
    unit_kept* units;
};

/* encoder_points.c: two tokens, from row `row` of the unit on. */
void lab_encoder_pack_points(dm_lab_encoder* encoder, const float* weights);
void lab_encoder_points_forward(dm_lab_encoder* encoder, unit_kept* kept, size_t row, const float* points,
                                const float* positions);
void lab_encoder_points_backward(dm_lab_encoder* encoder, const unit_kept* kept, size_t row);
/* Adds what the points' first weights have gathered since the last time. */
void lab_encoder_points_end(dm_lab_encoder* encoder);

/* encoder_layer.c: on work.x, of which `kept` keeps what the way back needs; its gradient takes its place. */
void lab_encoder_layer_forward(dm_lab_encoder* encoder, const layer_weights* weights, layer_kept* kept);
void lab_encoder_layer_backward(dm_lab_encoder* encoder, const layer_weights* weights, const layer_gradients* gradients,
                                const layer_kept* kept);

/* encoder_attention.c: from q, k, v to shares and mixed; and from work.mixed, mixed's gradient, to work.qkv. */
void lab_encoder_attend(dm_lab_encoder* encoder, layer_kept* kept);
void lab_encoder_attend_backward(dm_lab_encoder* encoder, const layer_kept* kept);

#endif
