/* The portable backend: trees of our own, built and traced on the calling thread, in the host's memory. */
#include "pick/backend.h"
#include "pick/wide_tree.h"

/* The device is the environment: there is nothing else to keep. */
static dm_result open(dmi_env* env, void** out_device, char* why, size_t why_size) {
    (void)why;
    (void)why_size;
    *out_device = env;
    return DM_OK;
}

static void close(void* device) {
    (void)device;
}

static dmi_wide_trace* best_trace(void) {
#if defined(__x86_64__)
    if (dmi_isa_has_avx2(dmi_cpu_best_isa())) return dmi_wide_trace_avx2;
#endif
    return dmi_wide_trace_plain;
}

/* shape: NULL where the tree is to be built. */
static dm_result make(dmi_env* env, const dmi_triangles* triangles, const dmi_tree_shape* shape, void** out_tree) {
    dmi_wide_tree* tree = dmi_alloc(env, sizeof *tree, _Alignof(dmi_wide_tree));
    if (tree == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory to pick a part");
    const dm_result result =
        shape != NULL ? dmi_wide_tree_restore(env, triangles, shape, tree) : dmi_wide_tree_build(env, triangles, tree);
    if (result != DM_OK) {
        dmi_free(env, tree, sizeof *tree);
        return result;
    }
    tree->trace = best_trace();
    *out_tree = tree;
    return DM_OK;
}

static dm_result build(void* device, const dmi_triangles* triangles, void** out_tree) {
    return make(device, triangles, NULL, out_tree);
}

static dm_result restore(void* device, const dmi_triangles* triangles, const dmi_tree_shape* shape, void** out_tree) {
    return make(device, triangles, shape, out_tree);
}

static dmi_tree_shape shape_of(const void* tree) {
    return dmi_wide_tree_shape(tree);
}

static void destroy(void* device, void* built) {
    dmi_env* env = device;
    dmi_wide_tree_release(env, built);
    dmi_free(env, built, sizeof(dmi_wide_tree));
}

static bool first_hit(const void* built, const dmi_part_ray* ray, dmi_part_hit* out_hit) {
    const dmi_wide_tree* tree = built;
    return tree->trace(tree, ray, out_hit);
}

const dmi_pick_backend dmi_pick_portable = {"portable", DM_PICK_PORTABLE, false,   open,     close,
                                            build,      destroy,          restore, shape_of, first_hit};
