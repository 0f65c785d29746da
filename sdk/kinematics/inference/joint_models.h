/* The models fitted on candidate joints, in one file (sdk/models/ranker.safetensors): prefilter, ranker and limits. */
#ifndef DMI_INFERENCE_JOINT_MODELS_H
#define DMI_INFERENCE_JOINT_MODELS_H

#include "kinematics/limits/limit_network.h"
#include "kinematics/ranking/candidate_prefilter.h"
#include "kinematics/ranking/ranker.h"

typedef struct dmi_joint_models {
    dmi_env* env;
    dmi_arena arena; /* holds the packed layers */
    dmi_prefilter prefilter;
    dmi_ranker ranker;
    dmi_limit_network limits;
} dmi_joint_models;

/* Loads the file. Answers DM_ERROR_WRONG_MODEL for a file of another architecture, as earlier versions have. */
dm_result dmi_joint_models_load(dmi_env* env, const void* data, size_t size, dmi_joint_models** out_models);
void dmi_joint_models_destroy(dmi_joint_models* models);

#endif
