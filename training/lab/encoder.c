/* The encoder as a whole: its weights, and a batch forwards and backwards, a unit of cases at a time. */
#include "encoder.h"

#if defined(__x86_64__) && defined(__linux__)
#include <stdlib.h>
#include <string.h>

#include "encoder_state.h"

static void* make_zeros(size_t bytes) {
    void* memory = aligned_alloc(64, (bytes + 63) / 64 * 64);
    return memory != NULL ? memset(memory, 0, bytes) : NULL;
}

dm_lab_encoder* dm_lab_encoder_make(uint32_t tokens, uint32_t layers, uint32_t batch) {
    if (tokens == 0 || tokens % 2 != 0 || tokens > ROWS / 2 || layers > MOST_LAYERS || batch == 0) return NULL;
    dm_lab_encoder* encoder = dm_lab_encoder_available() ? make_zeros(sizeof *encoder) : NULL;
    if (encoder == NULL) return NULL;
    encoder->tokens = tokens, encoder->layer_count = layers;
    encoder->padded = tokens <= ROWS / 3 ? ROWS / 3 : ROWS / 2;
    encoder->keys = (encoder->padded + DEPTH - 1) / DEPTH * DEPTH;
    encoder->cases = ROWS / encoder->padded;
    encoder->unit_count = (batch + encoder->cases - 1) / encoder->cases;
    encoder->units = make_zeros(encoder->unit_count * sizeof *encoder->units);
    if (encoder->units != NULL) return encoder;
    free(encoder);
    return NULL;
}

void dm_lab_encoder_free(dm_lab_encoder* encoder) {
    if (encoder == NULL) return;
    free(encoder->units);
    free(encoder);
}

/* weights: outputs x inputs. forwards, backwards: as right operands. */
TARGET static void pack(const float* weights, size_t outputs, size_t inputs, uint32_t* forwards, uint32_t* backwards) {
    ALIGNED bf16 rounded[PACKED * WIDTH];
    for (size_t i = 0; i < outputs * inputs; i += LANES) put16(rounded + i, _mm512_loadu_ps(weights + i));
    pair_rows(rounded, inputs, outputs, inputs, backwards);
    transpose((const uint32_t*)(const void*)rounded, outputs, inputs / 2, forwards);
}

static void bind_layer(layer_weights* w, layer_gradients* g, const float* const* from, float* const* gradients) {
    w->norm1 = from[0], w->norm1_bias = from[1], w->qkv_bias = from[3], w->out_bias = from[5];
    w->norm2 = from[6], w->norm2_bias = from[7], w->ff1_bias = from[9], w->ff2_bias = from[11];
    pack(from[2], PACKED, WIDTH, w->qkv, w->qkv_back);
    pack(from[4], WIDTH, WIDTH, w->out, w->out_back);
    pack(from[8], BETWEEN, WIDTH, w->ff1, w->ff1_back);
    pack(from[10], WIDTH, BETWEEN, w->ff2, w->ff2_back);
    *g = (layer_gradients){gradients[0], gradients[1], gradients[2], gradients[3], gradients[4],  gradients[5],
                           gradients[6], gradients[7], gradients[8], gradients[9], gradients[10], gradients[11]};
}

void dm_lab_encoder_bind(dm_lab_encoder* encoder, const float* const* weights, float* const* gradients) {
    encoder->point1_bias = weights[1], encoder->point2_bias = weights[3];
    encoder->point1_gradient = gradients[0], encoder->point1_bias_gradient = gradients[1];
    encoder->point2_gradient = gradients[2], encoder->point2_bias_gradient = gradients[3];
    lab_encoder_pack_points(encoder, weights[0]);
    pack(weights[2], WIDTH, POINT_HIDDEN, encoder->point2, encoder->point2_back);
    for (size_t i = 0; i < encoder->layer_count; i++) {
        const size_t first = DM_LAB_ENCODER_POINT_TENSORS + i * DM_LAB_ENCODER_LAYER_TENSORS;
        bind_layer(&encoder->layers[i], &encoder->gradients[i], weights + first, gradients + first);
    }
}

/* How many of the unit's cases the batch has. */
static size_t cases_of(const dm_lab_encoder* encoder, size_t unit, uint32_t count) {
    const size_t first = unit * encoder->cases, left = first < count ? count - first : 0;
    return left < encoder->cases ? left : encoder->cases;
}

TARGET void dm_lab_encoder_forward(dm_lab_encoder* encoder, uint32_t count, const float* points, const float* positions,
                                   float* out) {
    const size_t tokens = encoder->tokens, row = GROUP * CHANNELS;
    tiles_on();
    for (size_t u = 0; cases_of(encoder, u, count) > 0; u++) {
        memset(encoder->work.x, 0, sizeof encoder->work.x);
        for (size_t i = 0; i < cases_of(encoder, u, count); i++)
            for (size_t t = 0, at = (u * encoder->cases + i) * tokens; t < tokens; t += 2)
                lab_encoder_points_forward(encoder, &encoder->units[u], i * encoder->padded + t,
                                           points + (at + t) * row, positions + (at + t) * WIDTH);
        for (size_t l = 0; l < encoder->layer_count; l++)
            lab_encoder_layer_forward(encoder, &encoder->layers[l], &encoder->units[u].layers[l]);
        for (size_t i = 0; i < cases_of(encoder, u, count); i++)
            memcpy(out + (u * encoder->cases + i) * tokens * WIDTH, encoder->work.x + i * encoder->padded * WIDTH,
                   tokens * WIDTH * sizeof(float));
    }
    tiles_off();
}

TARGET void dm_lab_encoder_backward(dm_lab_encoder* encoder, uint32_t count, const float* gradient,
                                    float* out_positions) {
    const size_t bytes = encoder->tokens * WIDTH * sizeof(float);
    tiles_on();
    for (size_t u = 0; cases_of(encoder, u, count) > 0; u++) {
        const size_t cases = cases_of(encoder, u, count), at = u * encoder->cases * encoder->tokens * WIDTH;
        float* x = encoder->work.x;
        memset(x, 0, sizeof encoder->work.x); /* of tokens that only fill up */
        for (size_t i = 0; i < cases; i++)
            memcpy(x + i * encoder->padded * WIDTH, gradient + at + i * encoder->tokens * WIDTH, bytes);
        for (size_t l = encoder->layer_count; l-- > 0;)
            lab_encoder_layer_backward(encoder, &encoder->layers[l], &encoder->gradients[l],
                                       &encoder->units[u].layers[l]);
        for (size_t i = 0; i < cases; i++) {
            for (size_t t = 0; t < encoder->tokens; t += 2)
                lab_encoder_points_backward(encoder, &encoder->units[u], i * encoder->padded + t);
            memcpy(out_positions + at + i * encoder->tokens * WIDTH, x + i * encoder->padded * WIDTH, bytes);
        }
    }
    lab_encoder_points_end(encoder);
    tiles_off();
}

#else
dm_lab_encoder* dm_lab_encoder_make(uint32_t tokens, uint32_t layers, uint32_t batch) {
    (void)tokens, (void)layers, (void)batch;
    return NULL;
}

/* There is none that these could be given. */
void dm_lab_encoder_free(dm_lab_encoder* encoder) {
    (void)encoder;
}
#endif
