/* Where the time of dm_object_prepare goes, stage by stage: bench_prepare [triangles [models [stage]]];
 * with a stage, for profilers, the others run once. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "kinematics/features/candidate_features.h"
#include "kinematics/features/kpp_ensemble.h"
#include "kinematics/inference/joint_inference.h"
#include "kinematics/inference/joint_models.h"
#include "kinematics/object/prepare.h"
#include "mesh/connectivity.h"
#include "pick/bvh.h"
#include "support.h"
#include "test_bvh.h"

#define ROUND_MS 600
#define ARENA_BLOCK ((size_t)1 << 20)

typedef struct stages {
    dmi_env env;
    dmi_axes axes;
    dmi_picker* picker;
    bench_mesh shape;
    dmi_mesh* mesh;
    dmi_bvh* bvh;
    dmi_inference_models models;
    dmi_drag_hint hint;
    uint32_t* welded;
    dmi_cloud* cloud;
    dmi_part_analysis analysis;
    dmi_arena analysis_arena;
    dmi_kpp_ensemble ensemble;
    void* scratch;
    dmi_candidate *all, *candidates; /* before the prefilter and after it */
    uint32_t all_count, candidate_count;
    float (*features)[DMI_FEATURE_COUNT];
    float *score, *probability;
    const char* only; /* NULL: every stage is measured */
} stages;

static void check(dm_result result, const char* what) {
    if (result == DM_OK) return;
    fprintf(stderr, "bench_prepare: %s: error %d\n", what, result);
    exit(1);
}

static void stage_mesh(void* user) {
    stages* s = user;
    const dm_mesh_desc desc = bench_mesh_desc(&s->shape);
    dmi_mesh_destroy(&s->env, s->mesh);
    check(dmi_mesh_create(&s->env, &s->axes, &desc, NULL, 0, NULL, &s->mesh), "mesh");
}

static void stage_bvh(void* user) {
    stages* s = user;
    test_bvh_destroy(s->bvh);
    check(test_bvh_create(s->picker, s->mesh, NULL, &s->bvh), "bvh");
}

static void stage_cloud(void* user) {
    stages* s = user;
    check(dmi_cloud_sample(&s->env, s->mesh, 1, 0, s->cloud), "cloud");
}

static void stage_weld(void* user) {
    stages* s = user;
    dmi_arena arena;
    dmi_arena_init(&arena, &s->env, ARENA_BLOCK);
    check(dmi_weld_vertices(&arena, s->mesh, DMI_WELD_TOLERANCE, NULL, s->welded), "weld");
    dmi_arena_release(&arena);
}

static void stage_analysis(void* user) {
    stages* s = user;
    dmi_arena_release(&s->analysis_arena);
    dmi_arena_init(&s->analysis_arena, &s->env, ARENA_BLOCK);
    check(dmi_part_analysis_make(&s->analysis_arena, s->mesh, s->cloud, 1, s->welded, NULL, &s->analysis), "analysis");
}

static void stage_ensemble(void* user) {
    stages* s = user;
    dmi_kpp_ensemble_run(s->models.kpp, s->models.isa, s->cloud, &s->hint, s->scratch, &s->ensemble);
}

static void stage_candidates(void* user) {
    stages* s = user;
    s->all_count = dmi_candidates_make(&s->analysis, &s->hint, &s->ensemble.prediction, s->all);
}

static void stage_prefilter(void* user) {
    stages* s = user;
    const dmi_prefilter* prefilter = s->models.joints != NULL ? &s->models.joints->prefilter : NULL;
    memcpy(s->candidates, s->all, s->all_count * sizeof *s->all);
    s->candidate_count = s->all_count;
    if (prefilter != NULL)
        s->candidate_count = dmi_prefilter_keep(prefilter, &s->analysis, &s->hint, s->models.kpp, s->models.isa,
                                                &s->ensemble, s->candidates, s->all_count, s->features);
}

static void stage_choice(void* user) {
    stages* s = user;
    dmi_kpp_ensemble_score(s->models.kpp, s->models.isa, &s->ensemble, s->candidates, s->candidate_count, s->score);
}

static void stage_features(void* user) {
    stages* s = user;
    dmi_candidate_features_make(&s->analysis, &s->hint, &s->ensemble.prediction, s->score, s->candidates,
                                s->candidate_count, s->features);
}

static void stage_ranker(void* user) {
    stages* s = user;
    dmi_ranker_probabilities(s->models.joints != NULL ? &s->models.joints->ranker : NULL, s->models.isa,
                             (const float(*)[DMI_FEATURE_COUNT])s->features, s->candidate_count, s->probability);
}

static void stage_infer(void* user) {
    stages* s = user;
    dmi_hypotheses found;
    const dmi_inference_query query = {
        .mesh = s->mesh, .cloud = s->cloud, .models = s->models, .hint = &s->hint, .welded = s->welded, .part = 1};
    check(dmi_joint_inference_run(&s->env, &query, &found, NULL), "infer");
}

static void show(const char* name, stages* s, void (*stage)(void*)) {
    if (s->only != NULL && strcmp(s->only, name) != 0) {
        stage(s);
        return;
    }
    double least;
    const double median = bench_median_ns(stage, s, ROUND_MS, &least);
    printf("%-12s %10.3f %10.3f\n", name, median * 1e-6, least * 1e-6);
}

static void load_models(const char* folder, stages* s) {
    char path[4096];
    size_t size;
    dmi_kpp_net* net = NULL;
    dmi_joint_models* joints = NULL; /* rules, where there is no file of it */
    snprintf(path, sizeof path, "%s/kpp_net.safetensors", folder);
    void* data = bench_read(path, &size);
    check(dmi_kpp_net_load(&s->env, data, size, &net), path);
    free(data);
    snprintf(path, sizeof path, "%s/ranker.safetensors", folder);
    data = access(path, R_OK) == 0 ? bench_read(path, &size) : NULL;
    if (data != NULL) check(dmi_joint_models_load(&s->env, data, size, &joints), path);
    free(data);
    s->models = (dmi_inference_models){net, joints, dmi_cpu_best_isa()};
    s->scratch = bench_alloc(dmi_kpp_net_scratch_size(net));
}

int main(int argc, char** argv) {
    static stages s;
    const dm_drag_hint drag = bench_mesh_drag(1);
    const double point[3] = {(double)drag.point.x, (double)drag.point.y, (double)drag.point.z};
    const float vector[3] = {drag.vector.x, drag.vector.y, drag.vector.z};
    dmi_env_init(&s.env, NULL, NULL, NULL);
    dmi_arena_init(&s.analysis_arena, &s.env, ARENA_BLOCK);
    dmi_axes_init(&s.axes, DM_AXES_GLTF, NULL, 1);
    check(dmi_picker_create(&s.env, DM_PICK_AUTO, &s.picker), "picker");
    load_models(argc > 2 ? argv[2] : "sdk/models", &s);
    s.shape = bench_mesh_new(argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 100000, 1);
    s.only = argc > 3 ? argv[3] : NULL;
    s.cloud = bench_alloc(sizeof *s.cloud);
    s.all = bench_alloc(DMI_CANDIDATES_MAX * sizeof *s.all);
    s.candidates = bench_alloc(DMI_CANDIDATES_MAX * sizeof *s.candidates);
    s.features = bench_alloc(DMI_CANDIDATES_MAX * sizeof *s.features);
    s.score = bench_alloc(DMI_CANDIDATES_MAX * sizeof *s.score);
    s.probability = bench_alloc(DMI_CANDIDATES_MAX * sizeof *s.probability);
    printf("%u triangles    median ms   least ms\n", s.shape.face_count);
    show("mesh", &s, stage_mesh);
    show("bvh", &s, stage_bvh);
    dmi_frame_point_in(&s.mesh->frame, point, s.hint.point);
    dmi_frame_vector_in(&s.mesh->frame, vector, s.hint.vector);
    s.welded = bench_alloc(s.mesh->vertex_count * sizeof *s.welded);
    show("weld", &s, stage_weld);
    show("cloud", &s, stage_cloud);
    show("analysis", &s, stage_analysis);
    show("network", &s, stage_ensemble);
    show("candidates", &s, stage_candidates);
    show("prefilter", &s, stage_prefilter);
    show("choice", &s, stage_choice);
    show("features", &s, stage_features);
    show("ranker", &s, stage_ranker);
    show("infer", &s, stage_infer);
    printf("%u candidates, %u kept\n", s.all_count, s.candidate_count);
    return 0;
}
