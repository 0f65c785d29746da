/* The decoder's layers in oneDNN: weights packed as it likes them, one thread. One JSON object a line; built by run. */
#include <oneapi/dnnl/dnnl.h>
#include <stdio.h>
#include <stdlib.h>

#include "../support.h"

#define ROWS 16
#define ROUND_MS 500

typedef struct layer {
    dnnl_primitive_t matmul;
    dnnl_stream_t stream;
    dnnl_exec_arg_t args[3];
} layer;

static void check(dnnl_status_t status) {
    if (status == dnnl_success) return;
    fprintf(stderr, "onednn: error %d\n", status);
    exit(1);
}

static void run(void* user) {
    layer* l = user;
    check(dnnl_primitive_execute(l->matmul, l->stream, 3, l->args));
    check(dnnl_stream_wait(l->stream));
}

static dnnl_memory_desc_t matrix(dnnl_dim_t rows, dnnl_dim_t columns, dnnl_format_tag_t tag) {
    const dnnl_dims_t sides = {rows, columns};
    dnnl_memory_desc_t desc;
    check(dnnl_memory_desc_init_by_tag(&desc, 2, sides, dnnl_f32, tag));
    return desc;
}

static dnnl_exec_arg_t argument(int which, const dnnl_memory_desc_t* desc, dnnl_engine_t engine) {
    dnnl_exec_arg_t arg = {which, NULL};
    void* data = NULL;
    check(dnnl_memory_create(&arg.memory, desc, engine, DNNL_MEMORY_ALLOCATE));
    check(dnnl_memory_get_data_handle(arg.memory, &data));
    for (size_t i = 0; i < dnnl_memory_desc_get_size(desc) / sizeof(float); i++) ((float*)data)[i] = (float)(i % 5);
    return arg;
}

static void show(dnnl_engine_t engine, dnnl_stream_t stream, dnnl_dim_t depth, dnnl_dim_t columns) {
    const dnnl_memory_desc_t x = matrix(ROWS, depth, dnnl_ab), any = matrix(depth, columns, dnnl_format_tag_any);
    const dnnl_memory_desc_t y = matrix(ROWS, columns, dnnl_ab);
    dnnl_matmul_desc_t desc;
    dnnl_primitive_desc_t primitive;
    layer l = {.stream = stream};
    check(dnnl_matmul_desc_init(&desc, &x, &any, NULL, &y));
    check(dnnl_primitive_desc_create(&primitive, &desc, NULL, engine, NULL));
    const dnnl_memory_desc_t* packed = dnnl_primitive_desc_query_md(primitive, dnnl_query_weights_md, 0);
    check(dnnl_primitive_create(&l.matmul, primitive));
    l.args[0] = argument(DNNL_ARG_SRC, &x, engine);
    l.args[1] = argument(DNNL_ARG_WEIGHTS, packed, engine);
    l.args[2] = argument(DNNL_ARG_DST, &y, engine);
    double least;
    const double median = bench_median_ns(run, &l, ROUND_MS, &least);
    printf("{\"who\": \"onednn\", \"what\": \"gemm_%d_%d\", \"median_ns\": %.1f, \"least_ns\": %.1f}\n", (int)depth,
           (int)columns, median, least);
    for (int i = 0; i < 3; i++) dnnl_memory_destroy(l.args[i].memory);
    dnnl_primitive_destroy(l.matmul);
    dnnl_primitive_desc_destroy(primitive);
}

int main(void) {
    dnnl_engine_t engine;
    dnnl_stream_t stream;
    check(dnnl_engine_create(&engine, dnnl_cpu, 0));
    check(dnnl_stream_create(&stream, engine, dnnl_stream_default_flags));
    show(engine, stream, 96, 288);
    show(engine, stream, 96, 96);
    show(engine, stream, 96, 384);
    show(engine, stream, 384, 96);
    dnnl_stream_destroy(stream);
    dnnl_engine_destroy(engine);
    return 0;
}
