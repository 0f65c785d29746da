/* Reads the shipped weights into a model. */
#ifndef SAMPLES_WEIGHTS_H
#define SAMPLES_WEIGHTS_H

#include <stdio.h>
#include <stdlib.h>

#include "dragmesh/dragmesh.h"

/* The file's bytes, to be freed; NULL and size 0 when there is no such file. */
static inline void* read_whole(const char* path, size_t* out_size) {
    FILE* file = fopen(path, "rb");
    *out_size = 0;
    if (file == NULL) return NULL;
    fseek(file, 0, SEEK_END);
    const long size = ftell(file);
    rewind(file);
    void* data = size > 0 ? malloc((size_t)size) : NULL;
    if (data != NULL) *out_size = fread(data, 1, (size_t)size, file);
    fclose(file);
    return data;
}

static inline void* read_from(const char* folder, const char* name, size_t* out_size) {
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return read_whole(path, out_size);
}

/* folder: sdk/models of the repository. */
static inline dm_result load_weights(dm_context* context, const char* folder, dm_model* out_model) {
    dm_model_desc desc = {.struct_size = sizeof desc};
    void* kinematics = read_from(folder, "kpp_net.safetensors", &desc.kinematics_size);
    void* motion = read_from(folder, "dq_vae.safetensors", &desc.motion_size);
    void* ranker = read_from(folder, "ranker.safetensors", &desc.ranker_size);
    desc.kinematics = kinematics, desc.motion = motion, desc.ranker = ranker;
    const dm_result result = dm_model_load(context, &desc, out_model);
    free(kinematics);
    free(motion);
    free(ranker);
    return result;
}

#endif
