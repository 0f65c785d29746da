/* The networks, instruction set by instruction set: whole passes, their matrix products against the machine's peak,
 * and the bulk transform: bench_networks [models]. One JSON object a line. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kinematics/kpp/kpp_net.h"
#include "math/dual_quat.h"
#include "motion/dq_vae.h"
#include "nn/kernels.h"
#include "support.h"

#define ROUND_MS 300
#define POINTS 100000
#define FRAMES 16

typedef struct state {
    dmi_env env;
    dmi_isa isa;
    dmi_kpp_net* net;
    dmi_dq_vae* vae;
    void *net_scratch, *vae_scratch;
    dmi_kpp_input input;
    dmi_kpp_output net_output;
    dmi_cloud* cloud;
    dmi_part_points points;
    dmi_vae_object object;
    dmi_vae_query query;
    dmi_vae_output vae_output;
    dm_pose pose;
    float *src, *dst;
    dmi_gemm gemm;
} state;

static void show(const char* name, state* s, void (*call)(void*), double flops) {
    double least;
    const double median = bench_median_ns(call, s, ROUND_MS, &least);
    printf("{\"isa\": \"%s\", \"name\": \"%s\", \"median_us\": %.3f, \"least_us\": %.3f", dmi_isa_name(s->isa), name,
           median * 1e-3, least * 1e-3);
    if (flops > 0) printf(", \"gflops\": %.1f", flops / median);
    printf("}\n");
}

static void call_motion(void* user) {
    state* s = user;
    dmi_dq_vae_forward(s->vae, s->isa, &s->object, &s->query, s->vae_scratch, &s->vae_output);
}

static void call_motion_object(void* user) {
    state* s = user;
    dmi_dq_vae_prepare(s->vae, s->isa, &s->points, &s->object);
}

static void call_kinematics(void* user) {
    state* s = user;
    dmi_kpp_net_forward(s->net, s->isa, &s->input, s->net_scratch, &s->net_output);
}

static void call_points(void* user) {
    state* s = user;
    dmi_pose_apply_points_isa(s->isa, &s->pose, s->src, 0, s->dst, 0, POINTS);
}

static void call_copy(void* user) {
    state* s = user;
    memcpy(s->dst, s->src, POINTS * 3 * sizeof(float));
    __asm__ volatile("" : : "r"(s->dst) : "memory");
}

static void call_gemm(void* user) {
    state* s = user;
    dmi_kernels_for(s->isa)->gemm(&s->gemm);
}

/* The product of a layer on 16 tokens. */
static void show_gemm(const char* name, state* s, uint32_t depth, uint32_t columns) {
    float* x = bench_alloc(FRAMES * depth * sizeof(float));
    float* y = bench_alloc(FRAMES * columns * sizeof(float));
    float* panels = bench_alloc(dmi_panels_size(columns, depth) * sizeof(float));
    for (size_t i = 0; i < FRAMES * depth; i++) x[i] = (float)(i % 7);
    for (size_t i = 0; i < dmi_panels_size(columns, depth); i++) panels[i] = (float)(i % 5);
    s->gemm = (dmi_gemm){.x = x,
                         .panels = panels,
                         .y = y,
                         .x_stride = depth,
                         .y_stride = columns,
                         .rows = FRAMES,
                         .depth = depth,
                         .columns = columns};
    show(name, s, call_gemm, 2.0 * FRAMES * depth * columns);
    free(x);
    free(y);
    free(panels);
}

/* Fused multiply-adds on registers alone: what a product can reach at most. Vectors of the set's width, enough of them
 * to hide the latency. */
#define PEAK_ROUNDS 4096
#define PEAK(NAME, WIDTH, ATTRIBUTE, FMA, COUNT)                                                                       \
    typedef float NAME##_lanes __attribute__((vector_size(WIDTH * sizeof(float))));                                    \
    ATTRIBUTE static void NAME(void* user) {                                                                           \
        NAME##_lanes sum[COUNT] = {{0}}, factor = {0};                                                                 \
        (void)user;                                                                                                    \
        for (int n = 0; n < PEAK_ROUNDS; n++)                                                                          \
            for (int i = 0; i < COUNT; i++) __asm__ volatile(FMA : "+x"(sum[i]) : "x"(factor));                        \
    }
#if defined(__x86_64__)
PEAK(peak_avx2, 8, __attribute__((target("avx2,fma"))), "vfmadd231ps %1, %1, %0", 12)
PEAK(peak_avx512, 16, __attribute__((target("avx512f"))), "vfmadd231ps %1, %1, %0", 12)
#endif

static void show_peak(state* s) {
#if defined(__x86_64__)
    if (s->isa == DMI_ISA_AVX2) show("peak", s, peak_avx2, 2.0 * 8 * 12 * PEAK_ROUNDS);
    if (s->isa == DMI_ISA_AVX512) show("peak", s, peak_avx512, 2.0 * 16 * 12 * PEAK_ROUNDS);
#else
    (void)s;
#endif
}

static void show_isa(state* s) {
    show("motion", s, call_motion, 0);
    show("motion_object", s, call_motion_object, 0);
    show("kinematics", s, call_kinematics, 0);
    show("points_100k", s, call_points, 0);
    show_peak(s);
    show_gemm("gemm_96_288", s, 96, 288);
    show_gemm("gemm_96_96", s, 96, 96);
    show_gemm("gemm_96_384", s, 96, 384);
    show_gemm("gemm_384_96", s, 384, 96);
}

static void* load(const char* folder, const char* name, size_t* out_size) {
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.safetensors", folder, name);
    return bench_read(path, out_size);
}

static void load_networks(const char* folder, state* s) {
    size_t size;
    void* data = load(folder, "kpp_net", &size);
    if (dmi_kpp_net_load(&s->env, data, size, &s->net) != DM_OK) exit(1);
    free(data);
    data = load(folder, "dq_vae", &size);
    if (dmi_dq_vae_load(&s->env, data, size, &s->vae) != DM_OK) exit(1);
    free(data);
    s->net_scratch = bench_alloc(dmi_kpp_net_scratch_size(s->net));
    s->vae_scratch = bench_alloc(dmi_dq_vae_scratch_size(s->vae));
}

/* A ball of points and a hinge at its side: any input of order one takes the networks the same time. */
static void make_inputs(state* s) {
    s->cloud = bench_alloc(sizeof *s->cloud);
    memset(s->cloud, 0, sizeof *s->cloud);
    for (uint32_t i = 0; i < DMI_CLOUD_POINTS; i++)
        for (uint32_t k = 0; k < 3; k++) s->cloud->xyz[i][k] = 0.01f * (float)((i * 7919 + k * 104729) % 97) - 0.5f;
    dmi_part_points_of_cloud(s->cloud, &s->points);
    dmi_drag_hint hint = {{0.4f, 0, 0}, {0, 0, 1}};
    dmi_kpp_input_make(s->cloud, 0, &hint, &s->input);
    s->query =
        (dmi_vae_query){.joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}, .origin = {-0.4f, 0, 0}, .upper = 1.5f},
                        .drag_point = {0.4f, 0, 0},
                        .drag_vector = {0, 0, 1}};
    for (int i = 0; i < DMI_VAE_PATH; i++) s->query.path[i][0] = 0.4f, s->query.path[i][2] = 0.02f * (float)i;
    s->pose = (dm_pose){{0, 0.08715574f, 0, 0.9961947f}, {0, 0, 0, 0}};
    s->src = bench_alloc(POINTS * 3 * sizeof(float));
    s->dst = bench_alloc(POINTS * 3 * sizeof(float));
    memset(s->src, 0, POINTS * 3 * sizeof(float));
    memset(s->dst, 0, POINTS * 3 * sizeof(float));
}

int main(int argc, char** argv) {
    static state s;
    dmi_env_init(&s.env, NULL, NULL, NULL);
    load_networks(argc > 1 ? argv[1] : "sdk/models", &s);
    make_inputs(&s);
    dmi_dq_vae_prepare(s.vae, DMI_ISA_SCALAR, &s.points, &s.object);
    show("memcpy_100k", &s, call_copy, 0);
    for (s.isa = DMI_ISA_SCALAR; s.isa <= DMI_ISA_NEON; s.isa++)
        if (dmi_kernels_usable(s.isa)) show_isa(&s);
    dmi_kpp_net_destroy(s.net);
    dmi_dq_vae_destroy(s.vae);
    return 0;
}
