/* Finds the folder of the shipped weights, for the tool and the viewer. */
#ifndef SAMPLES_WEIGHTS_FOLDER_H
#define SAMPLES_WEIGHTS_FOLDER_H

#include <stdbool.h>
#include <stddef.h>

#define WEIGHTS_KINEMATICS "kpp_net.safetensors"
#define WEIGHTS_MOTION "dq_vae.safetensors"
#define WEIGHTS_RANKER "ranker.safetensors"

/* Writes the folder that the environment variable DRAGMESH_MODELS names. Without it, writes the first folder that holds
 * one of the files: that of the program, models in it, models beside it, or sdk/models of the repository that the
 * program was built in. Returns false where there is none, or where its path does not fit. */
bool weights_folder_find(char* out_path, size_t size);

#endif
